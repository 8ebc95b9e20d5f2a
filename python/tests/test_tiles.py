"""Sweeps elsewhere: the same bits from threads, processes, a cluster that loses a worker, and a folder."""

import multiprocessing
import os
import signal
from concurrent.futures import Executor, ProcessPoolExecutor, ThreadPoolExecutor
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import precess

OVER: dict[str, Any] = {"x": np.linspace(-1, 1, 25), "y": np.linspace(-1, 1, 12), "d": [0.1, 0.2]}
SWEEP = precess.Scenario("magnetic_pendulum", until=2, method="rk4", dt=0.01)


@pytest.fixture(scope="module")
def alone() -> precess.Ensemble:
    return precess.ensemble(SWEEP, OVER)


def test_any_executor_gives_the_same_bits(alone: precess.Ensemble) -> None:
    spawn = multiprocessing.get_context("spawn")
    told: list[float] = []
    pools: list[Executor] = [ThreadPoolExecutor(2), ProcessPoolExecutor(1, mp_context=spawn)]
    for pool in pools:
        with pool:
            there = precess.ensemble(SWEEP, OVER, client=pool, tile=77, progress=told.append)
        assert there.numbers.tobytes() == alone.numbers.tobytes()
        assert told[-1] == 600
    with pytest.raises(precess.InputError, match="has been shut down"):
        precess.ensemble(SWEEP, OVER, client=pools[0])


def test_rows_are_cut_and_failures_keep_their_numbers() -> None:
    rows = {"x": [1.0, 0.5, 1.7e308, 0.2, 1.7e308], "x_dot": [0.0, 0.0, 1.7e308, 0.0, 1.7e308]}
    settings: dict[str, Any] = {"product": False, "method": "rk4", "dt": 0.5, "until": 1.0}
    here = precess.ensemble("magnetic_pendulum", rows, **settings)
    with ThreadPoolExecutor(2) as pool:
        there = precess.ensemble("magnetic_pendulum", rows, client=pool, tile=2, **settings)
    assert list(here.failures) == [2, 4]
    assert there.failures == here.failures
    assert there.numbers.tobytes() == here.numbers.tobytes()


def test_a_sweep_that_was_stopped_resumes(alone: precess.Ensemble, tmp_path: Path) -> None:
    store = tmp_path / "sweep.zarr"
    done: list[float] = []

    def stop_half_way(members: float) -> None:
        done.append(members)
        if members >= 300:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        precess.ensemble(SWEEP, OVER, store=store, tile=100, progress=stop_half_way)
    assert done == [100, 200, 300]
    done.clear()
    again = precess.ensemble(SWEEP, OVER, store=store, tile=100, progress=done.append)
    assert done == [400, 500, 600]
    assert again.numbers.tobytes() == alone.numbers.tobytes()
    with pytest.raises(precess.InputError, match="holds another sweep"):
        precess.ensemble(SWEEP, {**OVER, "d": [0.1, 0.3]}, store=store, tile=100)
    with pytest.raises(precess.InputError, match="tile: at least one is needed, not 0"):
        precess.ensemble(SWEEP, OVER, store=store, tile=0)


def test_basins_in_tiles_have_the_same_bits(tmp_path: Path) -> None:
    over = {"x": (-1.5, 1.5, 17), "y": (-1.5, 1.0, 13)}
    settings: dict[str, Any] = {"start": {"y_dot": 0}, "until": 20}
    here = precess.basins("magnetic_pendulum", over, **settings)
    told: list[float] = []
    with ThreadPoolExecutor(2) as pool:
        there = precess.basins(
            "magnetic_pendulum",
            over,
            client=pool,
            tile=50,
            store=tmp_path / "map",
            progress=told.append,
            **settings,
        )
    assert told[-1] == 1
    for basins in (
        there,
        precess.basins("magnetic_pendulum", over, store=tmp_path / "map", tile=50, **settings),
    ):
        assert basins.labels.tobytes() == here.labels.tobytes()
        assert basins.times.tobytes() == here.times.tobytes()
        assert basins.attractors == here.attractors
        assert basins.summary == here.summary
    with pytest.raises(precess.InputError, match="holds another sweep"):
        precess.basins("magnetic_pendulum", over, store=tmp_path / "map", tile=49, **settings)


def test_multipliers_and_exponents_in_tiles_have_the_same_bits(tmp_path: Path) -> None:
    sweep = {"h": (0.0, 0.4, 5), "alpha": (0.8, 2.4, 4)}
    here = precess.floquet("parametric_oscillator", sweep)
    with ThreadPoolExecutor(2) as pool:
        there = precess.floquet("parametric_oscillator", sweep, client=pool, tile=7, store=tmp_path / "map")
        assert there.numbers.tobytes() == here.numbers.tobytes()
        assert there.summary == here.summary
        over = {"rho": [0.5, 28.0], "x": [1.0, 2.0, 3.0]}
        alone = precess.lyapunov_sweep("lorenz", over, until=5)
        tiles = precess.lyapunov_sweep("lorenz", over, until=5, client=pool, tile=4)
    assert tiles.exponents.tobytes() == alone.exponents.tobytes()
    assert alone.exponents.shape == (2, 3, 3)
    one = precess.lyapunov("lorenz", parameters={"rho": 28.0}, start={"x": 2.0}, until=5)
    assert alone.exponents[1, 1].tobytes() == one["exponent"].tobytes()
    assert alone.errors[1, 1].tobytes() == one["error"].tobytes()
    assert alone.to_xarray()["exponent"].dims == ("rho", "x", "index")
    assert (alone.largest[0] < 0).all()
    assert alone.plot().axes
    with pytest.raises(precess.InputError, match="one motion cannot be cut"):
        precess.floquet("parametric_oscillator", store=tmp_path / "one")


def test_what_is_no_client_is_refused() -> None:
    with pytest.raises(TypeError, match=r"a Dask client or an executor of .* is needed, not int"):
        precess.ensemble(SWEEP, OVER, client=3)  # type: ignore[arg-type]
    with pytest.raises(TypeError, match="tile: a whole number is needed, not float"):
        precess.ensemble(SWEEP, OVER, client=ThreadPoolExecutor(1), tile=1.5)  # type: ignore[arg-type]
    with pytest.raises(TypeError, match="no keyword argument of basins 'clinet': did you mean 'client'"):
        precess.basins("magnetic_pendulum", {"x": (0, 1, 2)}, clinet=None)  # type: ignore[call-arg]


@pytest.mark.filterwarnings("ignore")
def test_a_cluster_that_loses_a_worker_gives_the_same_bits(alone: precess.Ensemble) -> None:
    from distributed import Client, LocalCluster

    with (
        LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as cluster,  # type: ignore[no-untyped-call]
        Client(cluster) as client,  # type: ignore[no-untyped-call]
    ):
        victims = list(client.run(os.getpid).values())[:1]

        def kill(_: float) -> None:
            while victims:
                os.kill(victims.pop(), signal.SIGKILL)

        there = precess.ensemble(SWEEP, OVER, client=client, tile=20, progress=kill)
    assert not victims
    assert there.numbers.tobytes() == alone.numbers.tobytes()
    with pytest.raises(precess.InputError, match="the client is closed"):
        precess.ensemble(SWEEP, OVER, client=client)
