"""The basins of three magnets by `precess`, and the same motions by heyoka: right labels first, then processor time.

python heyoka_basins.py path/to/precess [SIDE [ROUNDS]]

SIDE x SIDE starts at rest over [-2, 2]^2 with C = 4, R = 0.2, d = 0.1, within 1e-12, to t = 100:

full     every motion is followed to t = 100 (`precess ensemble`; heyoka in batches)
stopped  a motion ends as soon as its energy is below the lowest pass (`precess basins --once`; heyoka with a terminal event, whose lane
         takes the next start at once, and heyoka in pieces of time between which the energies are looked at and what is left
         goes on in full batches)
checked  `precess basins` as it is: companions within other tolerances tell the labels that errors may have decided

All on one thread, in turns; processor time, since the machine may be busy, the least of the rounds, compilation left out.
"""

import math
import os
import resource
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import heyoka as hy
import numpy as np

SPRING, FRICTION, DEPTH, UNTIL, TOLERANCE = 4.0, 0.2, 0.1, 100.0, 1e-12
MAGNETS = np.array([[0.5, 0.0], [-0.25, 0.433], [-0.25, -0.433]])
# Lengths of the pieces of time.
PIECES = (1.0, 2.0, 4.0)
SCENARIO = f"""precess = 1
[system]
id = "magnetic_pendulum"
parameters = {{ c = {SPRING}, r = {FRICTION}, d = {DEPTH} }}
[start]
y_dot = 0
[run]
method = "dop853"
rtol = {TOLERANCE}
atol = {TOLERANCE}
until = {UNTIL}
every = {UNTIL}
"""


def potential(x, y):
    """Give the potential energy, of numbers or of expressions."""
    wells = sum(((x - a) ** 2 + (y - b) ** 2 + DEPTH**2) ** -0.5 for a, b in MAGNETS)
    return 0.5 * SPRING * (x**2 + y**2) - wells


def energies(state):
    """Give the energies of states x, y, x_dot, y_dot, a column each."""
    return 0.5 * (state[2] ** 2 + state[3] ** 2) + potential(state[0], state[1])


def lowest_pass():
    """Give the energy of the lowest saddle between the wells, by Newton's method from many places."""
    x, y = hy.make_vars("x", "y")
    slope = [hy.diff(potential(x, y), v) for v in (x, y)]
    bend = [hy.diff(s, v) for s in slope for v in (x, y)]
    given = hy.cfunc([*slope, *bend], [x, y])
    passes = []
    for start in np.random.default_rng(1).uniform(-0.6, 0.6, (300, 2)):
        place = start.copy()
        for _ in range(50):
            values = given(place)
            place -= np.linalg.solve(values[2:].reshape(2, 2), values[:2])
        values = given(place)
        if abs(values[:2]).max() < 1e-12 and np.linalg.det(values[2:].reshape(2, 2)) < 0:
            passes.append(potential(*place))
    return min(passes)


def starts(side):
    """Give all starts, x running fastest: x, y, x_dot, y_dot, a column each."""
    axis = -2 + 4 * (np.arange(side) / (side - 1))
    y, x = np.meshgrid(axis, axis, indexing="ij")
    return np.stack([x.ravel(), y.ravel(), np.zeros(side * side), np.zeros(side * side)])


def nearest(places):
    """Give the magnet that each end is nearest to."""
    return np.hypot(*(places[:2].T[:, None, :] - MAGNETS).transpose(2, 0, 1)).argmin(axis=1)


class Heyoka:
    """Its integrator in batches, with and without the event."""

    def __init__(self):
        hy.set_nthreads(1)
        x, y, u, v = hy.make_vars("x", "y", "u", "v")
        pull = [-hy.diff(potential(x, y), q) for q in (x, y)]
        rates = [(x, u), (y, v), (u, pull[0] - FRICTION * u), (v, pull[1] - FRICTION * v)]
        self.width = hy.recommended_simd_size()
        self.ends_below = lowest_pass()
        below = hy.t_event_batch(
            0.5 * (u**2 + v**2) + potential(x, y) - self.ends_below, direction=hy.event_direction.negative
        )
        zeros = np.zeros((4, self.width))
        self.free = hy.taylor_adaptive_batch(rates, zeros, tol=TOLERANCE)
        self.watching = hy.taylor_adaptive_batch(rates, zeros, tol=TOLERANCE, t_events=[below])

    def _batches(self, state, begin, end):
        """Follow states in full batches; what is left over fills its batch with copies of the last."""
        count = state.shape[1]
        for k in range(0, count, self.width):
            columns = np.minimum(np.arange(k, k + self.width), count - 1)
            self.free.set_time([begin] * self.width)
            self.free.state[:] = state[:, columns]
            self.free.propagate_until([end] * self.width)
            state[:, columns] = self.free.state

    def full(self, state):
        """Follow all to the end."""
        self._batches(state, 0.0, UNTIL)
        return nearest(state)

    def pieces(self, state, length):
        """Follow all from time to time, and go on with those above the pass."""
        left = np.arange(state.shape[1])
        for k in range(math.ceil(UNTIL / length)):
            left = left[energies(state[:, left]) > self.ends_below]
            if not len(left):
                break
            part = state[:, left]
            self._batches(part, k * length, min((k + 1) * length, UNTIL))
            state[:, left] = part
        return nearest(state)

    def event(self, state):
        """End each at its event, and begin another in the lane."""
        run, count = self.watching, state.shape[1]
        waiting = iter(np.flatnonzero(energies(state) > self.ends_below))
        lanes, times = [None] * self.width, np.zeros(self.width)
        while True:
            for lane, member in enumerate(lanes):
                if member is None:
                    lanes[lane] = member = next(waiting, None)
                    run.reset_cooldowns(lane)
                    times[lane] = 0.0
                    # An idle lane rests far from everything that happens.
                    run.state[:, lane] = [0.5, 0.0, 0.0, 0.0] if member is None else state[:, member]
                    if member is None:
                        times[lane] = UNTIL
            if not any(member is not None for member in lanes):
                return nearest(state)
            run.set_time(times)
            run.propagate_until([UNTIL] * self.width)
            times[:] = run.time
            for lane, member in enumerate(lanes):
                over = run.propagate_res[lane][0] != hy.taylor_outcome.success or times[lane] >= UNTIL
                stopped = energies(run.state[:, lane]) <= self.ends_below + 1e-9
                if member is not None and (stopped or (over and times[lane] >= UNTIL)):
                    state[:, member] = run.state[:, lane]
                    lanes[lane] = None


def spent():
    """Give the seconds of processor time of all programs that were started and have ended."""
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime


def run(command, cores=1):
    """Run a program on so many cores; give seconds of the processor and of the clock."""
    chosen = sorted(os.sched_getaffinity(0))[:cores]
    begin, clock = spent(), time.perf_counter()
    subprocess.run(
        command, check=True, capture_output=True, preexec_fn=lambda: os.sched_setaffinity(0, chosen)
    )
    return spent() - begin, time.perf_counter() - clock


def ours(binary, folder, side):
    """Give the commands: all motions to the end, basins, and basins that are checked."""
    grid = f'[ensemble]\ngrid = {{ x = "-2:2:{side}", y = "-2:2:{side}" }}\n'
    (folder / "full.toml").write_text(SCENARIO + grid)
    (folder / "basins.toml").write_text(SCENARIO)
    axes = [f"--grid={name}=-2:2:{side}" for name in "xy"]
    return (
        [binary, "ensemble", folder / "full.toml", "-q", "-o", folder / "full.npz"],
        *([binary, "basins", folder / "basins.toml", "-q", *axes, "-o", folder / "basins.npz", *once] for once in (["--once"], [])),
    )


def at_boundary(labels, side):
    """Tell which starts have a neighbour of another label."""
    padded = np.pad(labels.reshape(side, side), 1, mode="edge")
    shifts = [padded[i : i + side, j : j + side] for i in range(3) for j in range(3)]
    return np.any([shift != shifts[4] for shift in shifts], axis=0).ravel()


def main():
    """Print who is right, then ratios, then times."""
    binary = sys.argv[1]
    side = int(sys.argv[2]) if len(sys.argv) > 2 else 40
    rounds = int(sys.argv[3]) if len(sys.argv) > 3 else 3
    peer, count = Heyoka(), side * side
    peers = {"heyoka, full": peer.full, "heyoka, stopped by its event": peer.event}
    for length in PIECES:
        peers[f"heyoka, stopped in pieces of {length:g}"] = lambda s, length=length: peer.pieces(s, length)
    seconds, labels, clocks = {}, {}, {1: math.inf, 2: math.inf}

    def note(name, time_spent):
        seconds[name] = min(seconds.get(name, math.inf), time_spent)

    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        full, once, checked = ours(binary, folder, side)
        for _ in range(rounds):
            note("precess, full", run(full)[0])
            note("precess, stopped by proof", run(once)[0])
            for cores in clocks:
                processor, clock = run(checked, cores)
                clocks[cores] = min(clocks[cores], clock)
                if cores == 1:
                    note("precess, stopped and checked", processor)
            for name, follow in peers.items():
                state = starts(side)
                begin = time.process_time()
                labels[name] = follow(state)
                note(name, time.process_time() - begin)
        archive = np.load(folder / "full.npz")
        labels["precess, full"] = nearest(np.stack([archive["x"], archive["y"]]))
        archive = np.load(folder / "basins.npz")
        raw = archive["label"].ravel()
        mine = np.where(raw < 0, raw, nearest(archive["attractors"].T)[raw])
    alike = labels["heyoka, full"] == labels["precess, full"]
    wrong = alike & (mine >= 0) & (mine != labels["precess, full"])
    doubtful = ~alike | (mine < 0)
    inside = doubtful & ~at_boundary(labels["precess, full"], side)
    print(f"{side} x {side} starts, heyoka {hy.__version__} in batches of {peer.width}, the pass at {peer.ends_below:.6f}")
    print(f"{alike.sum()} ends are the same in both full runs; of these labels of `precess basins` are wrong: {wrong.sum()}")
    print(f"undecided: {(mine < 0).sum()}; undecided or in doubt beyond a pixel of a boundary: {inside.sum()}")
    early = [(labels[n] != labels["heyoka, full"])[alike].sum() for n in peers]
    print(f"labels of heyoka's motions that were stopped and are wrong: {max(early)}")
    stopped = min((n for n in peers if "stopped" in n), key=seconds.get)
    proof = seconds["precess, stopped by proof"]
    print("\nhow many times as long as precess takes heyoka:")
    print(f"  full, both                     {seconds['heyoka, full'] / seconds['precess, full']:8.2f}")
    print(f"  full, precess stopped by proof {seconds['heyoka, full'] / proof:8.2f}")
    print(f"  both stopped ({stopped[8:]}) {seconds[stopped] / proof:8.2f}")
    print(f"  the same, precess checked      {seconds[stopped] / seconds['precess, stopped and checked']:8.2f}")
    print(f"two threads to one, by the clock: {clocks[1] / clocks[2]:.2f}\n")
    for name, best in seconds.items():
        print(f"{name:36}{1e6 * best / count:10.1f} us for a start")


if __name__ == "__main__":
    main()
