"""A thousand seconds of T's cone (60 rad/s) by heyoka, in Euler angles: shortest time of five, error of the energy, psi.

Beside it: precess run gyroscope -i phi_dot=60 --method gauss_legendre16 --dt 0.0125 --until 1000 --every 1000
"""

import math
import time

import heyoka as hy

M, G, I1, I3, D = 0.03926990816987242, 9.81, 4.7860200582032015e-5, 2.9452431127404324e-5, 0.1125
START = [0.0, math.pi / 6, 0.0, 0.0, 0.0, 60.0]
AT_A = I1 + M * D * D


def energy(state: list[float]) -> float:
    """Kinetic and potential."""
    _, theta, _, psi_dot, theta_dot, phi_dot = state
    across = AT_A * (theta_dot**2 + (psi_dot * math.sin(theta)) ** 2)
    along = I3 * (psi_dot * math.cos(theta) + phi_dot) ** 2
    return (across + along) / 2 + M * G * D * math.cos(theta)


def main() -> None:
    """Print a line for each tolerance."""
    psi, theta, phi, p, t, f = hy.make_vars("psi", "theta", "phi", "p", "t", "f")
    sin, cos = hy.sin(theta), hy.cos(theta)
    moment = AT_A * p * cos - I3 * (p * cos + f)
    psi_rate = (-t * moment / AT_A - p * t * cos) / sin
    theta_rate = (M * G * D * sin + p * sin * moment) / AT_A
    rates = [
        (psi, p),
        (theta, t),
        (phi, f),
        (p, psi_rate),
        (t, theta_rate),
        (f, p * t * sin - psi_rate * cos),
    ]
    for tolerance in (2.2e-16, 1e-15, 1e-12):
        run = hy.taylor_adaptive(rates, START, tol=tolerance)
        best = math.inf
        for _ in range(5):
            run.time = 0.0
            run.state[:] = START
            begun = time.perf_counter()
            run.propagate_until(1000.0)
            best = min(best, time.perf_counter() - begun)
        error = abs(energy(list(run.state)) / energy(START) - 1)
        print(f"{tolerance}: {best * 1e3:.1f} ms, energy {error:.1e}, psi {run.state[0]:.10f}")


if __name__ == "__main__":
    main()
