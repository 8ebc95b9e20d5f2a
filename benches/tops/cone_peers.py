"""A thousand seconds of T's cone (60 rad/s), one trajectory on one core, by `precess` and by others, in one run.

python cone_peers.py path/to/precess

Time is the processor's own, the shortest of a few runs, and compilation is left out; ratios come first. The errors are those
at the end: of the energy, relative, and of psi, less whole turns, against the closed form. In Euler angles, except MuJoCo, which
has a body in quaternions on a ball joint. SciPy has the equations as plain Python, is run once, and takes minutes.
"""

import csv
import math
import os
import resource
import shutil
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path

M, G, I1, I3, D = 0.03926990816987242, 9.81, 4.7860200582032015e-5, 2.9452431127404324e-5, 0.1125
START = [0.0, math.pi / 6, 0.0, 0.0, 0.0, 60.0]
AT_A = I1 + M * D * D
UNTIL = 1000.0
# Seconds, the end's energy, and psi there.
Result = tuple[float, float, float]


def energy(state: list[float]) -> float:
    """Kinetic and potential, from Euler angles and their rates."""
    _, theta, _, psi_dot, theta_dot, phi_dot = state
    across = AT_A * (theta_dot**2 + (psi_dot * math.sin(theta)) ** 2)
    along = I3 * (psi_dot * math.cos(theta) + phi_dot) ** 2
    return (across + along) / 2 + M * G * D * math.cos(theta)


def ours(binary: str, *method: str) -> Result:
    """Run the terminal; its own start is measured apart."""

    def spend(until: float, table: Path) -> float:
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        words = ["-i", f"phi_dot={START[5]}", "--until", str(until), "--every", str(UNTIL), "-q", "-o", str(table)]
        subprocess.run([binary, "run", "gyroscope", *words, *method], check=True)
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        return after.ru_utime - before.ru_utime + after.ru_stime - before.ru_stime

    with tempfile.TemporaryDirectory() as folder:
        table = Path(folder) / "cone.csv"
        nothing = min(spend(0.0, table) for _ in range(5))
        seconds = min(spend(UNTIL, table) for _ in range(5))
        with table.open() as file:
            last = list(csv.DictReader(file))[-1]
    return max(seconds - nothing, 0.0), float(last["energy"]), float(last["psi"])


def rates(state: list[float]) -> list[float]:
    """Give the rates of the Euler angles and of their rates."""
    _, theta, _, p, t, f = state
    sine, cosine = math.sin(theta), math.cos(theta)
    moment = AT_A * p * cosine - I3 * (p * cosine + f)
    psi_rate = (-t * moment / AT_A - p * t * cosine) / sine
    return [p, t, f, psi_rate, (M * G * D * sine + p * sine * moment) / AT_A, p * t * sine - psi_rate * cosine]


def heyoka(tolerance: float) -> Result:
    """Run Taylor's method, compiled."""
    import heyoka as hy

    psi, theta, phi, p, t, f = hy.make_vars("psi", "theta", "phi", "p", "t", "f")
    sine, cosine = hy.sin(theta), hy.cos(theta)
    moment = AT_A * p * cosine - I3 * (p * cosine + f)
    psi_rate = (-t * moment / AT_A - p * t * cosine) / sine
    theta_rate = (M * G * D * sine + p * sine * moment) / AT_A
    pairs = [(psi, p), (theta, t), (phi, f), (p, psi_rate), (t, theta_rate), (f, p * t * sine - psi_rate * cosine)]
    run = hy.taylor_adaptive(pairs, START, tol=tolerance)
    best = math.inf
    for _ in range(5):
        run.time = 0.0
        run.state[:] = START
        begin = time.process_time()
        run.propagate_until(UNTIL)
        best = min(best, time.process_time() - begin)
    return best, energy(list(run.state)), float(run.state[0])


def odeint(tolerance: float) -> Result:
    """Compile and run Boost.odeint's Fehlberg 7(8)."""
    if not shutil.which("g++"):
        raise ImportError("g++")
    source = Path(__file__).with_name("odeint_cone.cpp")
    with tempfile.TemporaryDirectory() as folder:
        program = Path(folder) / "odeint_cone"
        command = ["g++", "-O3", "-march=native", "-std=c++17", source, "-o", program]
        if subprocess.run(command, capture_output=True, check=False).returncode:
            raise ImportError("Boost (apt-get install libboost-dev)")
        runs = [
            [float(word) for word in subprocess.run([program, str(tolerance)], check=True, capture_output=True).stdout.split()]
            for _ in range(3)
        ]
    return min(run[0] for run in runs), energy(runs[0][1:]), runs[0][1]


def scipy(tolerance: float) -> Result:
    """Run SciPy's DOP853, once."""
    from scipy.integrate import solve_ivp

    begin = time.process_time()
    found = solve_ivp(lambda _, y: rates(y), (0, UNTIL), START, "DOP853", [UNTIL], rtol=tolerance, atol=tolerance)
    last = [float(number) for number in found.y[:, -1]]
    return time.process_time() - begin, energy(last), last[0]


def mujoco(step: float) -> Result:
    """Run MuJoCo's RK4: a body on a ball joint, no contact."""
    import mujoco as mj

    model = mj.MjModel.from_xml_string(f"""
<mujoco><option timestep="{step}" integrator="RK4"/><worldbody><body><joint type="ball"/>
<inertial pos="0 0 {D}" mass="{M}" diaginertia="{I1} {I1} {I3}"/></body></worldbody></mujoco>""")
    data = mj.MjData(model)
    data.qpos[:] = [math.cos(START[1] / 2), math.sin(START[1] / 2), 0, 0]
    data.qvel[:] = [0, 0, START[5]]
    begin = time.process_time()
    mj.mj_step(model, data, round(UNTIL / step))
    seconds = time.process_time() - begin
    w, x, y, z = (float(part) for part in data.qpos)
    o1, o2, o3 = (float(part) for part in data.qvel)
    kinetic = (AT_A * (o1 * o1 + o2 * o2) + I3 * o3 * o3) / 2
    return seconds, kinetic + M * G * D * (w * w - x * x - y * y + z * z), math.atan2(z, w) + math.atan2(y, x)


def main() -> None:
    """Measure and print."""
    binary = str(Path(sys.argv[1]).resolve())
    os.sched_setaffinity(0, {min(os.sched_getaffinity(0))})
    closed = ours(binary, "--method", "exact")
    rows: list[tuple[str, Result]] = [("precess, exact (a sample)", closed)]
    best = ours(binary, "--method", "gauss_legendre16", "--dt", "0.0125")
    rows.append(("precess, gauss_legendre16, dt = 0.0125", best))
    peers: list[tuple[str, Callable[[], Result]]] = [
        ("heyoka, tolerance 2.2e-16", lambda: heyoka(2.2e-16)),
        ("Boost.odeint, Fehlberg 7(8), tolerance 1e-15", lambda: odeint(1e-15)),
        ("Boost.odeint, Fehlberg 7(8), tolerance 1e-12", lambda: odeint(1e-12)),
        ("MuJoCo, RK4, dt = 1 ms", lambda: mujoco(1e-3)),
        ("MuJoCo, RK4, dt = 0.1 ms", lambda: mujoco(1e-4)),
        ("SciPy, DOP853, tolerance 1e-12", lambda: scipy(1e-12)),
    ]
    for name, run in peers:
        try:
            rows.append((name, run()))
        except ImportError as missing:
            print(f"precess: {name} is skipped, since {missing.name or missing} is not there", file=sys.stderr)
    print("| | to gauss_legendre16 | ms | error of the energy | error of psi |\n|---|---|---|---|---|")
    for name, (seconds, end, psi) in rows:
        off = math.remainder(psi - closed[2], 2 * math.pi)
        error = abs(end / energy(START) - 1)
        print(f"| {name} | {seconds / best[0]:.2g} | {1e3 * seconds:.3g} | {error:.0e} | {abs(off):.0e} |", flush=True)


if __name__ == "__main__":
    main()
