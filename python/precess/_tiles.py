"""Work in tiles: on other processes, on other machines, into a folder that survives."""

from __future__ import annotations

from collections import deque
from typing import TYPE_CHECKING, Any, Protocol

import numpy as np

from . import _core
from ._given import count as at_least_one
from ._names import extra
from ._sweep import Members

if TYPE_CHECKING:
    from collections.abc import Callable
    from pathlib import Path

    from ._progress import Told
    from ._scenario import Scenario

# Members of a tile: a second of work, more or less, and some megabytes at most.
TILE = 4096
# Tiles that are under way: enough for a thousand cores, few enough for the memory of the one that collects.
UNDER_WAY = 1024


class Submits(Protocol):
    """What runs a function elsewhere: a Dask client, an executor of `concurrent.futures`, of mpi4py, of Ray."""

    def submit(self, fn: Callable[..., Any], /, *args: Any) -> Any:
        """Give a future, which has a `result()`."""


class Work(Protocol):
    """What may be cut anywhere: members whose numbers do not depend on one another."""

    @property
    def scenario(self) -> Scenario:
        """What all members have in common."""

    @property
    def size(self) -> int:
        """How many members there are."""

    def identity(self) -> list[object]:
        """Give what tells this work from any other, for JSON."""

    def part(self, first: int, last: int) -> tuple[Work, int, int]:
        """Give what a worker needs for the members from one number to another: `part[0].run(*part[1:])`."""

    def run(self, first: int, last: int, threads: int | None = None, told: Told | None = None) -> Members:
        """Run the members from one number to another."""


def done(
    work: Work,
    *,
    client: Submits | None,
    tile: int,
    store: str | Path | None,
    threads: int | None,
    told: Told | None,
) -> Members:
    """Do all of the work, in tiles where it is to go elsewhere or to be kept; what the store has is not done again."""
    if client is None and store is None:
        return work.run(0, work.size, threads, told)
    _check(client, tile)
    kept = Store(store, work, tile) if store is not None else Memory(work)
    tiles = [(first, min(first + tile, work.size)) for first in range(0, work.size, tile)]
    waiting: deque[tuple[int, int, Any]] = deque()
    count = 0

    def take() -> None:
        nonlocal count
        first, last, future = waiting[0]
        members = future if isinstance(future, Members) else _result(future)
        waiting.popleft()
        failures = {first + member: why for member, why in members.failures.items()}
        kept.keep(first, last, members._replace(failures=failures))
        count += last - first
        if told is not None:
            told(count)

    try:
        for first, last in tiles:
            if kept.has(first):
                count += last - first
            elif client is None:
                waiting.append((first, last, work.run(first, last, threads)))
                take()
            else:
                waiting.append((first, last, _submit(client, work, first, last, threads or 1)))
                if len(waiting) >= UNDER_WAY:
                    take()
        while waiting:
            take()
    finally:
        # Nobody waits for these any more.
        for _, _, future in waiting:
            getattr(future, "cancel", lambda: None)()
    return kept.members()


def _check(client: Submits | None, tile: int) -> None:
    at_least_one("tile", tile)
    if client is not None and not callable(getattr(client, "submit", None)):
        kind = type(client).__name__
        raise TypeError(f"client: a Dask client or an executor of concurrent.futures is needed, not {kind}")


def _submit(client: Submits, work: Work, first: int, last: int, threads: int) -> Any:
    if getattr(client, "status", "running") in ("closed", "closing"):
        raise _core.InputError("the client is closed: open another one, or leave it out")
    try:
        part, *span = work.part(first, last)
        return client.submit(part.run, *span, threads)
    except RuntimeError as error:
        if "shutdown" in str(error):
            raise _core.InputError(
                "the executor has been shut down: open another one, or leave it out"
            ) from None
        raise


def _result(future: Any) -> Members:
    from concurrent.futures import CancelledError

    try:
        found: Members = future.result()
    except CancelledError:
        raise _core.RunError(
            "the client was closed before all tiles were done: with a store, the same call goes on from there"
        ) from None
    return found


class Memory:
    """Tiles in the memory of this process."""

    def __init__(self, work: Work) -> None:
        self._size = work.size
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

    def __init__(self, path: str | Path, work: Work, tile: int) -> None:
        self._work = work
        self._tile = tile
        self._group = _group(path)
        name = self._name()
        if self._group.attrs.setdefault("sweep", name) != name:
            raise _core.InputError(
                f"{path} holds another sweep, or tiles of another size: give another folder"
            )
        count = -(-work.size // tile)
        if "done" not in self._group:
            self._group.create_array("done", shape=(count,), dtype="u1", fill_value=0)
            self._group.attrs["scenario"] = work.scenario.toml
        self._done = self._group["done"][:]

    def _name(self) -> str:
        """Give what tells these tiles from any others."""
        import hashlib
        import json

        return hashlib.sha256(json.dumps([*self._work.identity(), self._tile]).encode()).hexdigest()

    def has(self, first: int) -> bool:
        """Tell whether a tile is there."""
        return bool(self._done[first // self._tile])

    def keep(self, first: int, last: int, members: Members) -> None:
        """Keep a tile; it counts as done once all of it is there."""
        if "numbers" not in self._group:
            shape = (self._work.size, *members.numbers.shape[1:])
            chunks = (min(self._tile, self._work.size), *members.numbers.shape[1:])
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
