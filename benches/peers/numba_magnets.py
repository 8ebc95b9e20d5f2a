"""Program 7.5 of P compiled by numba: the scalar loop as printed, start after start, one thread.

python numba_magnets.py N STEPS [FILE]
"""

import math
import time

import numba
import numpy as np

from protocol import DEPTH, DT, FRICTION, MAGNETS, SPRING, Array, parser, report, starts

(X0, Y0), (X1, Y1), (X2, Y2) = MAGNETS


@numba.njit(fastmath=False)
def integrate(xs: Array, ys: Array, steps: int) -> None:
    """Replace every start by its position after `steps` steps."""
    d, c, r, dt = DEPTH, SPRING, FRICTION, DT
    for i in range(xs.size):
        x, y, vx, vy = xs[i], ys[i], 0.0, 0.0
        for _ in range(steps):
            d0 = math.sqrt((x - X0) * (x - X0) + (y - Y0) * (y - Y0) + d * d)
            d1 = math.sqrt((x - X1) * (x - X1) + (y - Y1) * (y - Y1) + d * d)
            d2 = math.sqrt((x - X2) * (x - X2) + (y - Y2) * (y - Y2) + d * d)
            d03, d13, d23 = d0 * d0 * d0, d1 * d1 * d1, d2 * d2 * d2
            ax = -c * x - r * vx + (X0 - x) / d03 + (X1 - x) / d13 + (X2 - x) / d23
            ay = -c * y - r * vy + (Y0 - y) / d03 + (Y1 - y) / d13 + (Y2 - y) / d23
            x += vx * dt + 0.5 * ax * dt * dt
            y += vy * dt + 0.5 * ay * dt * dt
            vx += ax * dt
            vy += ay * dt
        xs[i], ys[i] = x, y


def main() -> None:
    """Integrate and report."""
    given = parser("Program 7.5 compiled by numba.").parse_args()
    integrate(np.zeros(1), np.zeros(1), 1)  # compile
    x, y = starts(given.n)
    begin = time.perf_counter()
    integrate(x, y, given.steps)
    seconds = time.perf_counter() - begin
    report(given, "numba", seconds, x, y, version=numba.__version__)


if __name__ == "__main__":
    main()
