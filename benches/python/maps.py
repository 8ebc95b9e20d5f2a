"""From an import to the first plotted basin map: precess beside heyoka, diffrax and pynamicalsys.

Every one starts in a process of its own, follows 200 x 200 starts over three magnets within a tolerance of 1e-6 by an adaptive
method and writes a PNG with a colour for each magnet. Precess and pynamicalsys have a function for basins, which is used; with
the others a careful user takes the nearest magnet at t = 30. All that a user waits for counts: import, compilation,
integration, drawing; by the clock, and in processor time, which other work on the machine changes less.
`make bench-python` runs it; `maps.py PYTHON` takes the peers from that interpreter, and leaves out those which it does not
have.
"""

import json
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import numpy as np

SIDE, UNTIL, TOLERANCE = 200, 30.0, 1e-6
SPRING, FRICTION, DEPTH = 4.0, 0.2, 0.2
MAGNETS = np.array([[0.5, 0.0], [-0.25, 0.433], [-0.25, -0.433]])
ROUNDS = 3
CLOSELY = "precess 1e-12"
# A peer that takes longer than this, in s, runs once.
LONG = 20.0


def starts():
    """Give all starts at rest: x, y, x_dot, y_dot, a row each."""
    axis = np.linspace(-2, 2, SIDE)
    x, y = np.meshgrid(axis, axis, indexing="ij")
    return np.column_stack([x.ravel(), y.ravel(), np.zeros(SIDE * SIDE), np.zeros(SIDE * SIDE)])


def by_precess_closely():
    """The same as the user gets who says nothing: labels that are right, and starts that 1e-12 cannot tell, which are not counted."""
    return by_precess(1e-12, once=False)


def nearest(places):
    """Give the nearest magnet of each end."""
    return np.hypot(*(places[:, None, :] - MAGNETS).transpose(2, 0, 1)).argmin(axis=1)


def by_precess(tolerance=TOLERANCE, *, once=True):
    """Each start until it is proved where it ends, once as all others follow it; the attractors are in the order of their first coordinate."""
    import precess

    parameters = {"c": SPRING, "r": FRICTION, "d": DEPTH, "magnets": [[x, y, 1.0] for x, y in MAGNETS]}
    found = precess.basins(
        "magnetic_pendulum", {"x": (-2, 2, SIDE), "y": (-2, 2, SIDE)}, start={"y_dot": 0}, parameters=parameters,
        rtol=tolerance, atol=tolerance, once=once,
    )  # fmt: skip
    places = np.array([[a.state["x"], a.state["y"]] for a in found.attractors])
    labels = found.labels.ravel()
    return np.where(labels < 0, labels, nearest(places)[labels])


def by_heyoka():
    """Taylor's method, batches of four in AVX2 or eight in AVX-512, on all cores."""
    import heyoka as hy

    x, y, u, v = variables = hy.make_vars("x", "y", "u", "v")
    pull = [0.0, 0.0]
    for a, b in MAGNETS:
        cube = ((x - a) ** 2 + (y - b) ** 2 + DEPTH**2) ** -1.5
        pull = [pull[0] + (a - x) * cube, pull[1] + (b - y) * cube]
    rates = [u, v, pull[0] - SPRING * x - FRICTION * u, pull[1] - SPRING * y - FRICTION * v]
    width = hy.recommended_simd_size()
    rows = starts()
    batch = hy.taylor_adaptive_batch(
        list(zip(variables, rates, strict=True)), rows[:width].T.copy(), tol=TOLERANCE
    )

    def begin(integrator, k):
        integrator.set_time(0.0)
        integrator.state[:] = rows[k * width : (k + 1) * width].T
        return integrator

    found = hy.ensemble_propagate_until_batch(batch, UNTIL, len(rows) // width, begin)
    return nearest(np.concatenate([integrator.state[:2].T for integrator, *_ in found]))


def by_diffrax():
    """Dormand and Prince's method of order 8, all starts in one `vmap`, compiled by XLA."""
    import diffrax
    import jax
    import jax.numpy as jnp

    jax.config.update("jax_enable_x64", True)
    magnets = jnp.asarray(MAGNETS)

    def rate(_, state, __):
        place, velocity = state[:2], state[2:]
        to = magnets - place
        cube = (jnp.sum(to**2, axis=1) + DEPTH**2) ** -1.5
        return jnp.concatenate([velocity, cube @ to - SPRING * place - FRICTION * velocity])

    @jax.jit
    @jax.vmap
    def end(state):
        found = diffrax.diffeqsolve(
            diffrax.ODETerm(rate), diffrax.Dopri8(), 0.0, UNTIL, None, state, max_steps=100_000,
            stepsize_controller=diffrax.PIDController(rtol=TOLERANCE, atol=TOLERANCE),
        )  # fmt: skip
        return found.ys[-1]

    return nearest(np.asarray(end(starts()))[:, :2])


def by_pynamicalsys():
    """Its `rk45`, compiled by numba, on all cores, and its clusters of the states at t = 30, named after the magnets."""
    from numba import njit
    from pynamicalsys import ContinuousDynamicalSystem

    magnets = tuple((float(a), float(b)) for a, b in MAGNETS)

    @njit
    def rate(_, state, __):
        x, y, u, v = state[0], state[1], state[2], state[3]
        ax, ay = -SPRING * x - FRICTION * u, -SPRING * y - FRICTION * v
        for a, b in magnets:
            cube = ((x - a) ** 2 + (y - b) ** 2 + DEPTH**2) ** -1.5
            ax = ax + (a - x) * cube
            ay = ay + (b - y) * cube
        # It asks for the rates of all starts at once, too, to choose its first step.
        rates = np.zeros_like(state)
        rates[0], rates[1], rates[2], rates[3] = u, v, ax, ay
        return rates

    system = ContinuousDynamicalSystem(equations_of_motion=rate, system_dimension=4, number_of_parameters=0)
    system.integrator("rk45", atol=TOLERANCE, rtol=TOLERANCE)
    labels = system.basin_of_attraction(starts(), 1, transient_time=UNTIL - 1, sampling_time=1.0, eps=0.05, min_samples=20)
    # A cluster has no place: that of the start which lies nearest to a magnet is taken to belong to it.
    names = np.full(labels.max() + 2, -1)
    for number, magnet in enumerate(MAGNETS):
        names[labels[np.hypot(*(starts()[:, :2] - magnet).T).argmin()]] = number
    names[-1] = -1
    return names[labels]


PEERS = {
    "precess": by_precess,
    CLOSELY: by_precess_closely,
    "heyoka": by_heyoka,
    "diffrax": by_diffrax,
    "pynamicalsys": by_pynamicalsys,
}


def one(peer, file):
    """Make the map, and tell how long it took from before the import on: by the clock, and in processor time."""
    begin = time.perf_counter()
    winner = PEERS[peer]()
    import matplotlib as mpl

    mpl.use("Agg")
    import matplotlib.pyplot as plt

    plt.imshow(winner.reshape(SIDE, SIDE).T, origin="lower", extent=(-2, 2, -2, 2))
    plt.savefig(file.with_suffix(".png"))
    print(json.dumps({"clock": time.perf_counter() - begin, "processor": time.process_time()}))
    np.save(file, winner.astype(np.int8))


def run(peer, python, file):
    """Give clock, processor time and map of a peer in a process of its own, or nothing where it is not there."""
    command = [python, __file__, "--one", peer, str(file)]
    done = subprocess.run(command, check=False, capture_output=True, text=True)
    if done.returncode != 0:
        why = (done.stderr.strip().splitlines() or ["no reason given"])[-1]
        print(f"precess: {peer} is skipped: {why}", file=sys.stderr)
        return None
    row = json.loads(done.stdout.splitlines()[-1])
    return row["clock"], row["processor"], np.load(file)


def main():
    """Run all that there are in turns, and print ratios first."""
    others = sys.argv[1] if len(sys.argv) > 1 else sys.executable
    found = {peer: [] for peer in PEERS}
    with tempfile.TemporaryDirectory() as folder:
        for turn in range(ROUNDS):
            for peer, rows in found.items():
                # Who is not there, or takes minutes, is asked once.
                if turn == 0 or (rows and rows[0][0] < LONG):
                    python = sys.executable if peer.startswith("precess") else others
                    row = run(peer, python, Path(folder) / f"{peer}.npy")
                    rows += [row] if row else []
    if not found["precess"] or not found[CLOSELY]:
        sys.exit(1)
    clock, processor = (best(found["precess"], k) for k in range(2))
    right = best(found[CLOSELY], 2)
    print(f"from the import to the picture of {SIDE} x {SIDE} starts, within {TOLERANCE:g}; to precess, and in seconds")
    print(f"{'':14}{'clock':>8}{'processor':>11}{'clock [s]':>12}{'processor [s]':>15}{'right':>9}")
    for peer, rows in found.items():
        if rows:
            a, b, labels = (best(rows, k) for k in range(3))
            share = 100 * (labels == right)[right >= 0].mean()
            print(f"{peer:14}{a / clock:8.1f}{b / processor:11.1f}{a:12.2f}{b:15.2f}{share:7.1f} %")


def best(rows, k):
    """Give the smallest of a kind of time, or the map."""
    return rows[0][k] if isinstance(rows[0][k], np.ndarray) else min(row[k] for row in rows)


if __name__ == "__main__":
    if sys.argv[1:2] == ["--one"]:
        one(sys.argv[2], Path(sys.argv[3]))
    else:
        main()
