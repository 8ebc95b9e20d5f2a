"""A sweep in tiles: on other processes, on other machines, into a folder that survives."""

from __future__ import annotations

import hashlib
import json
from collections import deque
from typing import TYPE_CHECKING, Any, Protocol

import numpy as np

from . import _core
from ._names import extra
from ._sweep import Members, Sweep

if TYPE_CHECKING:
    from collections.abc import Callable
    from pathlib import Path

    from ._progress import Told

# Members of a tile: a second of work, more or less, and some megabytes at most.
TILE = 4096
# Tiles that are under way: enough for a thousand cores, few enough for the memory of the one that collects.
UNDER_WAY = 1024


class Submits(Protocol):
    """What runs a function elsewhere: a Dask client, an executor of `concurrent.futures`, of mpi4py, of Ray."""

    def submit(self, fn: Callable[..., Any], /, *args: Any) -> Any:
        """Give a future, which has a `result()`."""


def in_tiles(
    sweep: Sweep,
    *,
    client: Submits | None,
    tile: int,
    store: str | Path | None,
    threads: int | None,
    told: Told | None,
) -> Members:
    """Run a sweep in tiles; those that the store has already are not run again."""
    if tile < 1:
        raise _core.InputError(f"tile: at least one member is needed, not {tile}")
    kept = Store(store, sweep, tile) if store is not None else Memory(sweep)
    tiles = [(first, min(first + tile, sweep.size)) for first in range(0, sweep.size, tile)]
    waiting: deque[tuple[int, int, Any]] = deque()
    done = 0

    def take() -> None:
        nonlocal done
        first, last, future = waiting.popleft()
        members = future if isinstance(future, Members) else future.result()
        failures = {first + member: why for member, why in members.failures.items()}
        kept.keep(first, last, members._replace(failures=failures))
        done += last - first
        if told is not None:
            told(done)

    for first, last in tiles:
        if kept.has(first):
            done += last - first
        elif client is None:
            waiting.append((first, last, sweep.run(first, last, threads)))
            take()
        else:
            waiting.append((first, last, _submit(client, sweep, first, last, threads or 1)))
            if len(waiting) >= UNDER_WAY:
                take()
    while waiting:
        take()
    return kept.members()


def _submit(client: Submits, sweep: Sweep, first: int, last: int, threads: int) -> Any:
    if getattr(client, "status", "running") in ("closed", "closing"):
        raise _core.InputError("the client is closed: open another one, or leave it out")
    try:
        part, *span = sweep.part(first, last)
        return client.submit(part.run, *span, threads)
    except RuntimeError as error:
        if "shutdown" in str(error):
            raise _core.InputError(
                "the executor has been shut down: open another one, or leave it out"
            ) from None
        raise


class Memory:
    """Tiles in the memory of this process."""

    def __init__(self, sweep: Sweep) -> None:
        self._size = sweep.size
        self._numbers: Any = None
        self._times: Any = None
        self._failures: dict[int, str] = {}

    def has(self, first: int) -> bool:
        """Tell whether a tile is there."""
        del first
        return False

    def keep(self, first: int, last: int, members: Members) -> None:
        """Keep a tile."""
        if self._numbers is None:
            self._numbers = np.full((self._size, *members.numbers.shape[1:]), np.nan)
            self._times = members.times
        self._numbers[first:last] = members.numbers
        self._failures |= members.failures

    def members(self) -> Members:
        """Give all of them."""
        return Members(self._times, self._numbers, dict(sorted(self._failures.items())))


class Store:
    """Tiles in a Zarr group: `numbers` in chunks of a tile, `times`, `done`, and the failures as attributes."""

    def __init__(self, path: str | Path, sweep: Sweep, tile: int) -> None:
        self._sweep = sweep
        self._tile = tile
        self._group = _group(path)
        name = self._name()
        if self._group.attrs.setdefault("sweep", name) != name:
            raise _core.InputError(
                f"{path} holds another sweep, or tiles of another size: give another folder"
            )
        count = -(-sweep.size // tile)
        if "done" not in self._group:
            self._group.create_array("done", shape=(count,), dtype="u1", fill_value=0)
            self._group.attrs["scenario"] = sweep.scenario.toml
        self._done = self._group["done"][:]

    def _name(self) -> str:
        """Give what tells this sweep from any other."""
        sweep = self._sweep
        digest = hashlib.sha256(
            json.dumps([sweep.scenario.toml, sweep.product, sweep.samples, self._tile]).encode()
        )
        for name, values in sweep.axes.items():
            digest.update(name.encode())
            digest.update(values.astype("<f8").tobytes())
        return digest.hexdigest()

    def has(self, first: int) -> bool:
        """Tell whether a tile is there."""
        return bool(self._done[first // self._tile])

    def keep(self, first: int, last: int, members: Members) -> None:
        """Keep a tile; it counts as done once all of it is there."""
        if "numbers" not in self._group:
            shape = (self._sweep.size, *members.numbers.shape[1:])
            chunks = (min(self._tile, self._sweep.size), *members.numbers.shape[1:])
            self._group.create_array("numbers", shape=shape, chunks=chunks, dtype="f8", fill_value=np.nan)
            self._group.create_array("times", data=members.times)
        self._group["numbers"][first:last] = members.numbers
        if members.failures:
            told = {str(member): why for member, why in members.failures.items()}
            self._group.attrs["failures"] = {**self._group.attrs.get("failures", {}), **told}
        self._group["done"][first // self._tile] = 1
        self._done[first // self._tile] = 1

    def members(self) -> Members:
        """Give all of them, read into memory."""
        failures = {int(member): why for member, why in self._group.attrs.get("failures", {}).items()}
        return Members(self._group["times"][:], self._group["numbers"][:], dict(sorted(failures.items())))


def _group(path: str | Path) -> Any:
    try:
        import zarr
    except ImportError:
        raise extra("zarr", "dask") from None
    return zarr.open_group(str(path), mode="a")
