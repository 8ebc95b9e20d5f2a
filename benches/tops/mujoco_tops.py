"""A map of tippe tops by `precess ensemble` beside MuJoCo simulating one of them, on one core.

python mujoco_tops.py path/to/precess [TOPS]

Which of TOPS tippe tops turn over, spin against friction: what one costs, against one simulation of the same top in MuJoCo.
MuJoCo's contact is soft and its friction a cone, ours is rigid and smooth (epsilon 1 cm/s), so there is no common solution to
hold both against. Without friction both ought to keep their energy, and under any friction Jellett's quantity: these are the
errors, largest along the run. MuJoCo gets one call for all steps, and settings from cheap to careful. Times are the
processor's own, since the machine may be busy.
"""

import os
import resource
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import mujoco
import numpy as np

MASS, RADIUS, ALPHA = 0.02, 0.02, 0.3
I3 = 0.4 * MASS * RADIUS**2
I1 = 131 / 350 * MASS * RADIUS**2
TILT, SPIN, UNTIL, STEP = 0.1, 120.0, 10.0, 1.5e-3
SCENARIO = """precess = 1
[system]
id = "tippe_top"
parameters = {{ epsilon = "1 cm/s", mu = {mu} }}
[start]
omega3 = {spin}
[run]
method = "rk4"
dt = {step}
until = {until}
every = {every}
"""
CLASSES = 'classes = {{ of = "theta", at = ["30 deg", "150 deg"] }}\n'


def spent() -> float:
    """Give the seconds of processor time of all programs that were started and have ended."""
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime


def ours(binary: str, tops: int) -> float:
    """Give the seconds of a top in a map of so many."""
    side = max(2, round(tops**0.5))
    text = SCENARIO.format(mu=0.3, spin=SPIN, step=STEP, until=UNTIL, every=UNTIL)
    text += f'[ensemble]\ngrid = {{ omega3 = "10:130:{side}", mu = "0.02:0.4:{side}" }}\n' + CLASSES.format()
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "map.toml"
        file.write_text(text)
        begin = spent()
        subprocess.run([binary, "ensemble", file, "--hash", "-q"], check=True, capture_output=True)
        return (spent() - begin) / side**2


def our_error(binary: str, mu: float, quantity: str) -> float:
    """Give the largest departure of a quantity of one top from its start, relative."""
    with tempfile.TemporaryDirectory() as folder:
        file, table = Path(folder) / "top.toml", Path(folder) / "top.csv"
        file.write_text(SCENARIO.format(mu=mu, spin=SPIN, step=STEP, until=UNTIL, every=0.01))
        subprocess.run([binary, "run", file, "-o", table, "-q"], check=True)
        values = np.genfromtxt(table, delimiter=",", names=True)[quantity]
    return float(np.abs(values / values[0] - 1).max())


def model(step: float, integrator: str, mu: float) -> mujoco.MjModel:
    """Give the top on a table whose contact is as stiff as the step allows."""
    contact = f'friction="{mu} 0 0" condim="3" solref="{max(2 * step, 1e-3)} 1" solimp="0.99 0.9999 1e-4"'
    return mujoco.MjModel.from_xml_string(f"""
<mujoco><option timestep="{step}" integrator="{integrator}" cone="elliptic"/><worldbody>
<geom type="plane" size="5 5 .1" {contact}/><body><freejoint/>
<inertial pos="0 0 0" mass="{MASS}" diaginertia="{I1} {I1} {I3}"/>
<geom type="sphere" size="{RADIUS}" pos="0 0 {ALPHA * RADIUS}" {contact}/></body></worldbody></mujoco>""")


def constants(data: mujoco.MjData) -> tuple[float, float]:
    """Give energy and Jellett's quantity."""
    turned = np.zeros(9)
    mujoco.mju_quat2Mat(turned, data.qpos[3:7])
    vertical = turned.reshape(3, 3)[2]
    momentum = np.array([I1, I1, I3]) * data.qvel[3:6]
    energy = 0.5 * (MASS * data.qvel[:3] @ data.qvel[:3] + data.qvel[3:6] @ momentum) + 9.81 * MASS * data.qpos[2]
    return energy, -momentum @ (np.array([0, 0, ALPHA * RADIUS]) - RADIUS * vertical)


def theirs(step: float, integrator: str, mu: float) -> tuple[float, float, float]:
    """Give seconds, and the largest relative departures of energy and Jellett's quantity at a thousand samples."""
    made = model(step, integrator, mu)
    start = [0, 0, RADIUS * (1 - ALPHA * np.cos(TILT)), np.cos(TILT / 2), np.sin(TILT / 2), 0, 0]
    steps = round(UNTIL / step)
    data = mujoco.MjData(made)
    data.qpos[:], data.qvel[5] = start, SPIN
    first = np.array(constants(data))
    begin = time.process_time()
    mujoco.mj_step(made, data, steps)
    seconds = time.process_time() - begin
    data = mujoco.MjData(made)
    data.qpos[:], data.qvel[5] = start, SPIN
    worst = np.zeros(2)
    for _ in range(1000):
        mujoco.mj_step(made, data, max(1, steps // 1000))
        worst = np.maximum(worst, np.abs(np.array(constants(data)) / first - 1))
    return seconds, *worst


def main() -> None:
    """Measure and print."""
    binary, tops = sys.argv[1], int(sys.argv[2]) if len(sys.argv) > 2 else 10_000
    os.sched_setaffinity(0, {min(os.sched_getaffinity(0))})
    here = min(ours(binary, tops) for _ in range(2))
    energy, jellett = our_error(binary, 0.0, "energy"), our_error(binary, 0.3, "jellett")
    print(f"a top of a map: {1e3 * here:.3f} ms; energy {energy:.0e} (no friction), Jellett {jellett:.0e} (mu = 0.3)")
    for integrator in ("Euler", "implicitfast", "RK4"):
        for step in (2e-3, 1e-3, 5e-4):
            seconds, _, drift = theirs(step, integrator, 0.3)
            loss = theirs(step, integrator, 0.0)[1]
            print(
                f"MuJoCo {mujoco.__version__}, {integrator}, dt = {step:g}: {seconds / here:.0f} times as long "
                f"({1e3 * seconds:.0f} ms); energy {loss:.0e}, Jellett {drift:.0e}"
            )


if __name__ == "__main__":
    main()
