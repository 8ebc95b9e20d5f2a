"""Program 7.5 of P as a compiled function of heyoka, over many points at once, on one thread.

python heyoka_magnets.py N STEPS [FILE] [--form warm|shared|plain]

`COMPOSED` steps are written into one function, which is evaluated on blocks of points that stay in
the cache; a batch of 16 or 32 points travels through the code together (two or four AVX-512
registers, so that the latency of one hides behind the others). The forms differ in how 1/D of the
three magnets comes about; all are the same step but for rounding:

plain   three roots and three divisions
shared  three roots and one division (1 / (D0 D1 D2) times the other two)
warm    no root and no division after the second step of a function: 1/D is extrapolated from the
        two steps before, and one correction of fourth order brings it to full precision
        (|1 - D^2 guess^2| stays below 8e-5 over 40 x 40 starts, and 35/128 of its fourth power,
        the term left out, below 2e-17)
"""

import time
from collections.abc import Callable

import heyoka as hy
import numpy as np

from protocol import DEPTH, DT, FRICTION, MAGNETS, SPRING, Array, parser, report, starts

COMPOSED = 100
BLOCK = 2048

X0 = MAGNETS[0][0]
X1, Y1 = MAGNETS[1]

Expressions = list[hy.expression]


def plain(squares: Expressions, _before: list[Expressions]) -> Expressions:
    """Return 1/D for every D^2: a root and a division each."""
    return [1.0 / hy.sqrt(square) for square in squares]


def shared(squares: Expressions, _before: list[Expressions]) -> Expressions:
    """Return 1/D for every D^2: a root each, and one division for all."""
    d0, d1, d2 = (hy.sqrt(square) for square in squares)
    d01 = d0 * d1
    inverse = 1.0 / (d01 * d2)
    rest = inverse * d2
    return [rest * d1, rest * d0, inverse * d01]


def warm(squares: Expressions, before: list[Expressions]) -> Expressions:
    """Return 1/D for every D^2 from its values in the steps before."""
    if len(before) < 2:
        return shared(squares, before)
    result = []
    for square, last, last_but_one in zip(squares, before[-1], before[-2], strict=True):
        guess = 2.0 * last - last_but_one
        e = 1.0 - square * (guess * guess)
        result.append(guess + (guess * e) * (0.5 + e * (0.375 + 0.3125 * e)))
    return result


# With the batch that was found fastest.
FORMS: dict[str, tuple[Callable[[Expressions, list[Expressions]], Expressions], int]] = {
    "warm": (warm, 16),
    "shared": (shared, 32),
    "plain": (plain, 32),
}


def compiled(form: str, steps: int) -> hy.cfunc_dbl:
    """Compile `steps` steps into one function of x, y, vx, vy."""
    inverses, batch = FORMS[form]
    variables = hy.make_vars("x", "y", "vx", "vy")
    x, y, vx, vy = variables
    before: list[Expressions] = []
    for _ in range(steps):
        squares = [(x - a) ** 2 + (y - b) ** 2 + DEPTH * DEPTH for a, b in MAGNETS]
        before.append(inverses(squares, before))
        c0, c1, c2 = (inverse * inverse * inverse for inverse in before[-1])
        # The pulls gathered: sum of (a - x) / D^3 = sum of a / D^3 - x * sum of 1 / D^3, where the
        # first magnet has y = 0 and the other two mirror each other.
        c12 = c1 + c2
        pull = -SPRING - (c0 + c12)
        ax = pull * x - FRICTION * vx + X0 * c0 + X1 * c12
        ay = pull * y - FRICTION * vy + Y1 * (c1 - c2)
        x, y = x + vx * DT + 0.5 * DT * DT * ax, y + vy * DT + 0.5 * DT * DT * ay
        vx, vy = vx + ax * DT, vy + ay * DT
    return hy.cfunc([x, y, vx, vy], variables, fast_math=True, force_avx512=True, batch_size=batch)


def integrate(form: str, x: Array, y: Array, steps: int) -> float:
    """Replace every start by its position after `steps` steps; return the seconds taken."""
    # Blocks of equal width, in whole batches: a rest would run scalar.
    batch = FORMS[form][1]
    points = x.size
    count = -(-points // BLOCK)
    width = -(-points // (count * batch)) * batch
    state = np.zeros((4, count * width))
    state[0, :points], state[1, :points] = x, y
    blocks = [(block.copy(), np.empty_like(block)) for block in np.split(state, count, axis=1)]

    many, rest = divmod(steps, COMPOSED)
    functions = [(compiled(form, COMPOSED), many)] if many else []
    if rest:
        functions.append((compiled(form, rest), 1))

    for function, _ in functions:  # the first call of anything is slower
        function(blocks[0][0].copy(), outputs=blocks[0][1])

    finals = []
    begin = time.perf_counter()
    for now, then in blocks:
        for function, times in functions:
            for _ in range(times):
                function(now, outputs=then)
                now, then = then, now
        finals.append(now)
    seconds = time.perf_counter() - begin

    final = np.concatenate(finals, axis=1)
    x[:], y[:] = final[0, :points], final[1, :points]
    return seconds


def main() -> None:
    """Integrate and report."""
    arguments = parser("Program 7.5 as a compiled function of heyoka.")
    arguments.add_argument("--form", choices=FORMS, default="warm", help="how 1/D is computed")
    given = arguments.parse_intermixed_args()
    hy.set_nthreads(1)
    x, y = starts(given.n)
    seconds = integrate(given.form, x, y, given.steps)
    report(given, "heyoka", seconds, x, y, version=hy.__version__, form=given.form)


if __name__ == "__main__":
    main()
