"""Rings of asteroids about a small body that passes a large one (`cluster`), beside REBOUND's leapfrog on one core.

`rebound_cluster.py PRECESS [ASTEROIDS]`: the same bodies and steps. Both are run for a few steps and for many, in turns, and the
shortest difference of processor time counts, so that starting up, reading and printing are left out. Precess computes in the lanes that it finds
(`PRECESS_LANES` forces one set).
"""

import math
import os
import resource
import subprocess
import sys
import time
from functools import partial

import rebound

MASSES, CENTRE, TURN = (100.0, 30.0), (200.0, 220.0, -0.5, -0.8), 6.28
DT, FEW, MANY, TURNS = 0.01, 100, 2100, 3
RINGS = 100


def rings(asteroids):
    """Give circular rings from the radius 5 to 40: asteroids, radius, speed."""
    radii = [5 + 35 * k / (RINGS - 1) for k in range(RINGS)]
    return [(asteroids // RINGS, radius, math.sqrt(MASSES[1] / radius)) for radius in radii]


def by_precess(program, asteroids, steps):
    """Give the processor time of a run, everything included."""
    rows = "; ".join(f"[{count}; {count}; {radius!r}; {speed!r}]" for count, radius, speed in rings(asteroids))
    until = repr(steps * DT)
    command = [program, "run", "cluster", "-p", f"rings=[{rows}]", "--method", "verlet", "--dt", repr(DT)]
    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    subprocess.run([*command, "--until", until, "--every", until, "--quiet"], check=True, stdout=subprocess.DEVNULL)
    return resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before


def by_rebound(asteroids, steps):
    """Give the processor time of the integration."""
    sim = rebound.Simulation()
    sim.G, sim.integrator, sim.dt = 1.0, "leapfrog", DT
    x, y, u, v = CENTRE
    sim.add(m=MASSES[0], x=-100.0)
    sim.add(m=MASSES[1], x=x, y=y, vx=u, vy=v)
    before = 0
    for count, radius, speed in rings(asteroids):
        for k in range(count):
            angle = TURN * (before + k) / count
            sin, cos = math.sin(angle), math.cos(angle)
            sim.add(x=x + radius * cos, y=y + radius * sin, vx=u + speed * sin, vy=v - speed * cos)
        before += count
    # Asteroids attract nothing.
    sim.N_active = 2
    begun = time.process_time()
    sim.integrate(steps * DT, exact_finish_time=0)
    return time.process_time() - begun


def main():
    """Print the ratio first."""
    program, asteroids = sys.argv[1], int(sys.argv[2]) if len(sys.argv) > 2 else 100_000
    if hasattr(os, "sched_setaffinity"):
        os.sched_setaffinity(0, {min(os.sched_getaffinity(0))})
    times = {"precess": [], "rebound": []}
    for _ in range(TURNS):
        for name, run in (("precess", partial(by_precess, program)), ("rebound", by_rebound)):
            short, long = run(asteroids, FEW), run(asteroids, MANY)
            times[name].append((long - short) / (MANY - FEW) / asteroids * 1e9)
    ours, theirs = (min(times[name]) for name in ("precess", "rebound"))
    print(f"{theirs / ours:.1f} times as fast as REBOUND {rebound.__version__}'s leapfrog, {asteroids} asteroids, one core")
    print(f"an asteroid and step: precess {ours:.1f} ns, REBOUND {theirs:.1f} ns")


if __name__ == "__main__":
    main()
