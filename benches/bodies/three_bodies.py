"""A star, a planet and its moon (P, exercise 9.2) to t = 24 by `precess`, heyoka and REBOUND's ias15: one, and a thousand at once.

python three_bodies.py path/to/precess [ROUNDS]

Each integrator gets the loosest of its tolerances with which the energy at the end is right to 1e-12: of the one system, and of
the worst of the thousand, whose moons start between 1.199 and 1.201. On one thread, in turns, the least of the rounds: the one by
the clock (of the integration alone), the thousand in processor time (of `precess` with all that it does, from reading the
scenario to writing the table; of the others without compilation). What is not there is skipped.
"""

import importlib
import math
import os
import re
import resource
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import numpy as np

MASSES = np.array([45.0, 1.0, 0.01])
UNTIL, ERROR, MANY = 24.0, 1e-12, 1000
START = np.array([[-1, 0, 0, 6], [1, 0, 0, -6 / 45], [1.2, 0, 0, -6 / 45 + 2.5]])
LOW, HIGH = 1.199, 1.201
SCENARIO = """precess = 1
[system]
id = "n_body"
parameters = {{ k = 1, masses = [45, 1, 0.01] }}
[start]
x0 = -1
y0_dot = 6
x1 = 1
y1_dot = "-6/45"
x2 = 1.2
y2_dot = "-6/45 + 2.5"
[run]
method = "{method}"
rtol = {tolerance}
atol = {tolerance}
until = 24
every = 24
"""
ENSEMBLE = f'[ensemble]\ngrid = {{ x2 = "{LOW}:{HIGH}:{MANY}" }}\n'
NAMES = [f"{q}{k}{dot}" for k in range(3) for dot in ("", "_dot") for q in "xy"]


def starts():
    """Give the thousand systems: bodies of x, y, x_dot, y_dot."""
    all_of_them = np.repeat(START[None], MANY, axis=0)
    all_of_them[:, 2, 0] = LOW + (HIGH - LOW) * (np.arange(MANY) / (MANY - 1))
    return all_of_them


def energies(systems):
    """Give the energy of each system."""
    speed = (systems[..., 2:] ** 2).sum(axis=-1)
    energy = (MASSES * speed).sum(axis=-1) / 2
    for i, j in ((0, 1), (0, 2), (1, 2)):
        energy -= MASSES[i] * MASSES[j] / np.hypot(*(systems[..., i, :2] - systems[..., j, :2]).T)
    return energy


def worst(before, after):
    """Give the largest error of the energy, relative."""
    return float(np.abs(energies(after) / energies(before) - 1).max())


class Ours:
    """Some adaptive method of `precess`."""

    tolerances = (1e-8, 1e-9, 1e-10, 1e-11, 1e-12, 1e-13, 1e-14)

    def __init__(self, binary, method):
        self.binary, self.method = binary, method

    def _run(self, word, text):
        with tempfile.TemporaryDirectory() as folder:
            file, table = Path(folder) / "bodies.toml", Path(folder) / "bodies.csv"
            file.write_text(text)
            begin = spent()
            core = {min(os.sched_getaffinity(0))}
            done = subprocess.run(
                [self.binary, word, file, "-o", table], check=True, capture_output=True, text=True,
                preexec_fn=lambda: os.sched_setaffinity(0, core),
            )  # fmt: skip
            took = spent() - begin
            rows = np.genfromtxt(table, delimiter=",", names=True)
        ends = np.stack([rows[name] for name in NAMES], axis=-1).reshape(-1, 3, 4)
        return done.stderr, took, ends

    def one(self, tolerance):
        """Give seconds by the clock, and the error."""
        text = SCENARIO.format(method=self.method, tolerance=tolerance)
        said, _, ends = self._run("run", text)
        number, unit = re.search(r"samples in ([\d.]+) (\S+)", said).groups()
        return float(number) * {"s": 1, "ms": 1e-3, "us": 1e-6}[unit], worst(START, ends[-1])

    def many(self, tolerance):
        """Give seconds of the processor, and the error."""
        text = SCENARIO.format(method=self.method, tolerance=tolerance) + ENSEMBLE
        _, took, ends = self._run("ensemble", text)
        return took, worst(starts(), ends)


class Heyoka:
    """Taylor's method; the thousand in batches."""

    tolerances = (1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12, 1e-13)

    def __init__(self):
        self.hy = importlib.import_module("heyoka")
        self.hy.set_nthreads(1)
        self.made = {}

    def _made(self, tolerance):
        if tolerance not in self.made:
            hy = self.hy
            names = [f"{q}{k}" for k in range(3) for q in ("x", "y", "u", "v")]
            q = np.array(hy.make_vars(*names)).reshape(3, 4)
            pull = [[0.0, 0.0] for _ in MASSES]
            for i, j in ((0, 1), (0, 2), (1, 2)):
                across = q[j, :2] - q[i, :2]
                cube = (across[0] ** 2 + across[1] ** 2) ** -1.5
                for k in range(2):
                    pull[i][k] = pull[i][k] + MASSES[j] * cube * across[k]
                    pull[j][k] = pull[j][k] - MASSES[i] * cube * across[k]
            rates = [pair for b, p in zip(q, pull, strict=True) for pair in zip(b, [b[2], b[3], *p], strict=True)]
            width = hy.recommended_simd_size()
            zeros = np.repeat(START.reshape(12, 1), width, axis=1)
            one = hy.taylor_adaptive(rates, START.ravel().copy(), tol=tolerance)
            self.made[tolerance] = one, hy.taylor_adaptive_batch(rates, zeros, tol=tolerance), width
        return self.made[tolerance]

    def one(self, tolerance):
        """Give seconds by the clock, and the error."""
        run = self._made(tolerance)[0]
        run.time, run.state[:] = 0.0, START.ravel()
        begin = time.perf_counter()
        run.propagate_until(UNTIL)
        return time.perf_counter() - begin, worst(START, run.state.reshape(3, 4))

    def many(self, tolerance):
        """Give seconds of the processor, and the error."""
        _, run, width = self._made(tolerance)
        state = starts().reshape(MANY, 12).T.copy()
        begin = time.process_time()
        for k in range(0, MANY, width):
            columns = np.minimum(np.arange(k, k + width), MANY - 1)
            run.set_time([0.0] * width)
            run.state[:] = state[:, columns]
            run.propagate_until([UNTIL] * width)
            state[:, columns] = run.state
        return time.process_time() - begin, worst(starts(), state.T.reshape(MANY, 3, 4))


class Rebound:
    """Everhart's method of order 15, one system after another: it has no other way."""

    tolerances = (1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9)

    def __init__(self):
        self.rebound = importlib.import_module("rebound")

    def _follow(self, system, tolerance):
        run = self.rebound.Simulation()
        run.integrator = "ias15"
        run.integrator.epsilon = tolerance
        for mass, (x, y, u, v) in zip(MASSES, system, strict=True):
            run.add(m=mass, x=x, y=y, vx=u, vy=v)
        begin = time.perf_counter(), time.process_time()
        run.integrate(UNTIL)
        end = time.perf_counter(), time.process_time()
        bodies = [[p.x, p.y, p.vx, p.vy] for p in run.particles]
        return bodies, end[0] - begin[0], end[1] - begin[1]

    def one(self, tolerance):
        """Give seconds by the clock, and the error."""
        bodies, took, _ = self._follow(START, tolerance)
        return took, worst(START, np.array(bodies))

    def many(self, tolerance):
        """Give seconds of the processor, and the error."""
        ends, _, took = zip(*(self._follow(system, tolerance) for system in starts()), strict=True)
        return sum(took), worst(starts(), np.array(ends))


def spent():
    """Give the seconds of processor time of all programs that were started and have ended."""
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime


def loosest(peer, kind):
    """Give the loosest tolerance that is good enough, or the one with the smallest error."""
    errors = {}
    for tolerance in peer.tolerances:
        errors[tolerance] = getattr(peer, kind)(tolerance)[1]
        if errors[tolerance] <= ERROR:
            return tolerance
    return min(errors, key=errors.get)


def main():
    """Print ratios first."""
    rounds = int(sys.argv[2]) if len(sys.argv) > 2 else 5
    peers = {f"precess, {method}": Ours(sys.argv[1], method) for method in ("dop853", "taylor")}
    for name, kind in {"heyoka": Heyoka, "REBOUND, ias15": Rebound}.items():
        try:
            peers[name] = kind()
        except ImportError as error:
            print(f"precess: {name} is skipped: {error}", file=sys.stderr)
    for kind, title, unit in (("one", "one system", 1e3), ("many", f"{MANY} systems, for each", 1e3 / MANY)):
        chosen = {name: loosest(peer, kind) for name, peer in peers.items()}
        found = {name: (math.inf, math.nan) for name in peers}
        for _ in range(rounds if kind == "many" else 5 * rounds):
            for name, peer in peers.items():
                found[name] = min(found[name], getattr(peer, kind)(chosen[name]))
        least = min(found[name][0] for name in peers if name.startswith("precess"))
        print(f"{title}: to the faster of precess, ms, tolerance, error of the energy")
        for name, (took, error) in found.items():
            short = "" if error <= ERROR else " (no tolerance gives 1e-12)"
            print(f"  {name:18}{took / least:8.2f}{took * unit:10.3f}{chosen[name]:10.0e}{error:10.1e}{short}")


if __name__ == "__main__":
    main()
