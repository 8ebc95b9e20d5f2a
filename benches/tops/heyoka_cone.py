"""A thousand seconds of T's cone (60 rad/s) in Euler angles by heyoka, and by `precess` with `gauss_legendre16`.

python heyoka_cone.py path/to/precess [ROUNDS]

In turns, the shortest time by the clock of each, of the integration alone; psi is held against the closed form (`exact`).
"""

import math
import re
import subprocess
import sys
import time

import heyoka as hy

M, G, I1, I3, D = 0.03926990816987242, 9.81, 4.7860200582032015e-5, 2.9452431127404324e-5, 0.1125
START = [0.0, math.pi / 6, 0.0, 0.0, 0.0, 60.0]
AT_A = I1 + M * D * D
TOLERANCES = (2.2e-16, 1e-15, 1e-12)
STEPS = (0.0125, 0.01)
UNITS = {"s": 1.0, "ms": 1e-3, "us": 1e-6}


def energy(state: list[float]) -> float:
    """Kinetic and potential."""
    _, theta, _, psi_dot, theta_dot, phi_dot = state
    across = AT_A * (theta_dot**2 + (psi_dot * math.sin(theta)) ** 2)
    along = I3 * (psi_dot * math.cos(theta) + phi_dot) ** 2
    return (across + along) / 2 + M * G * D * math.cos(theta)


def ours(binary: str, *method: str) -> tuple[float, list[float]]:
    """Give the seconds of a run of `precess`, and its last state."""
    command = [binary, "run", "gyroscope", "-i", "phi_dot=60", "--until", "1000", "--every", "1000", "-o", "-"]
    done = subprocess.run([*command, *method], check=True, capture_output=True, text=True)
    number, unit = re.search(r"samples in ([\d.]+) (\S+)", done.stderr).groups()
    return float(number) * UNITS[unit], [float(x) for x in done.stdout.split()[-1].split(",")[1:7]]


def heyokas(tolerance: float) -> hy.taylor_adaptive:
    """Compile the integrator of a tolerance."""
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
    return hy.taylor_adaptive(rates, START, tol=tolerance)


def theirs(run: hy.taylor_adaptive) -> tuple[float, list[float]]:
    """Give the seconds of a run of heyoka, and its last state."""
    run.time = 0.0
    run.state[:] = START
    begun = time.perf_counter()
    run.propagate_until(1000.0)
    return time.perf_counter() - begun, list(run.state)


def main() -> None:
    """Print a line for each integrator, ratios first."""
    binary = sys.argv[1]
    rounds = int(sys.argv[2]) if len(sys.argv) > 2 else 5
    right = ours(binary, "--method", "exact")[1]
    compiled = {f"heyoka, {tolerance:g}": heyokas(tolerance) for tolerance in TOLERANCES}
    steps = {f"precess, dt = {dt}": ("--method", "gauss_legendre16", "--dt", str(dt)) for dt in STEPS}
    found: dict[str, tuple[float, list[float]]] = {}
    for _ in range(rounds):
        for name, run in compiled.items():
            found[name] = min(found.get(name, (math.inf, [])), theirs(run))
        for name, method in steps.items():
            found[name] = min(found.get(name, (math.inf, [])), ours(binary, *method))
    first = found[next(iter(compiled))][0]
    print(f"1000 s of a cone: to heyoka {hy.__version__} at 2.2e-16, ms, errors of the energy and of psi")
    for name, (took, state) in found.items():
        error = abs(energy(state) / energy(START) - 1)
        print(f"  {name:22}{took / first:6.2f}{took * 1e3:10.1f}{error:10.1e}{abs(state[0] - right[0]):10.1e}")


if __name__ == "__main__":
    main()
