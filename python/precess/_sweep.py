"""A sweep over starts and parameters, and any part of it: what a worker anywhere is given."""

from __future__ import annotations

import os
import threading
from typing import TYPE_CHECKING, Any, NamedTuple, TypeVar

import numpy as np

from . import _core
from ._given import array, text
from ._names import nearest
from ._scenario import table

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Iterator

    from ._core import Floats
    from ._progress import Told
    from ._scenario import Scenario


T = TypeVar("T")


class Members(NamedTuple):
    """What came out of some members, in their order."""

    times: Floats
    numbers: Floats
    """Members, times, numbers of the state."""
    failures: dict[int, str]
    """Why a member ended before its time, by its number among these."""


class Sweep(NamedTuple):
    """All members: every combination of the axes (the last runs fastest), or one for each of their rows."""

    scenario: Scenario
    axes: dict[str, Floats]
    product: bool
    samples: bool

    def identity(self) -> list[object]:
        """Give what tells this sweep from any other."""
        axes = [[name, values.astype("<f8").tobytes().hex()] for name, values in self.axes.items()]
        return ["ensemble", self.scenario.toml, self.product, self.samples, axes]

    @property
    def shape(self) -> tuple[int, ...]:
        """An axis for each name, or one for all members."""
        lengths = tuple(len(values) for values in self.axes.values())
        return lengths if self.product else lengths[:1]

    @property
    def size(self) -> int:
        """How many members there are."""
        size = 1
        for length in self.shape:
            size *= length
        return size

    def rows(self, first: int, last: int) -> Floats:
        """Give the values of the members from one number to another, a row each."""
        if not self.product:
            return np.column_stack([values[first:last] for values in self.axes.values()])
        places = np.unravel_index(np.arange(first, last), self.shape)
        return np.column_stack(
            [values[place] for values, place in zip(self.axes.values(), places, strict=True)]
        )

    def part(self, first: int, last: int) -> tuple[Sweep, int, int]:
        """Give what a worker needs for the members from one number to another: `part[0].run(*part[1:])`."""
        if self.product:
            return self, first, last
        axes = {name: values[first:last] for name, values in self.axes.items()}
        return self._replace(axes=axes), 0, last - first

    def run(self, first: int, last: int, threads: int | None = None, told: Told | None = None) -> Members:
        """Run the members from one number to another.

        Those with the same parameters go together, side by side in lanes; where there are many parameters, each thread
        takes one after another.
        """
        plan = self.scenario._plan  # noqa: SLF001
        known = plan.parameters
        is_parameter = np.array([name in known for name in self.axes])
        swept = [name for name in self.axes if name in known]
        rows = self.rows(first, last)
        sets, group = np.unique(rows[:, is_parameter], axis=0, return_inverse=True)
        order = np.argsort(group.reshape(-1), kind="stable")
        groups = np.split(order, np.cumsum(np.bincount(group.reshape(-1)))[:-1])
        starts = [name for name in self.axes if name not in known]

        def part(number: int, threads: int | None, told: Told | None) -> _core.Members:
            changes = dict(zip(swept, sets[number].tolist(), strict=True))
            own = plan.changed(changes, {}, None, {}) if swept else plan
            return own.ensemble(
                starts, rows[np.ix_(groups[number], ~is_parameter)], self.samples, threads, told
            )

        if len(groups) == 1:
            parts: Iterable[_core.Members] = [part(0, threads, told)]
        else:
            parts = side_by_side(part, [len(mine) for mine in groups], threads or os.cpu_count() or 1, told)
        numbers: Floats = np.empty(0)
        failures: dict[int, str] = {}
        for mine, done in zip(groups, parts, strict=True):
            if numbers.size == 0:
                numbers = np.empty((len(rows), *done.numbers.shape[1:]))
                times = done.times
            numbers[mine] = done.numbers
            failures |= {int(mine[member]): why for member, why in done.failures}
        return Members(times, numbers, dict(sorted(failures.items())))


def side_by_side(
    part: Callable[[int, int | None, Told | None], T],
    sizes: list[int],
    threads: int,
    told: Told | None,
) -> Iterator[T]:
    """Give the parts in order, computed by so many threads; whatever ends the loop ends them all."""
    from concurrent.futures import ThreadPoolExecutor

    ended = threading.Event()

    def go_on(_: float) -> None:
        if ended.is_set():
            raise InterruptedError

    pool = ThreadPoolExecutor(threads)
    try:
        done = 0
        for size, found in zip(sizes, pool.map(lambda k: part(k, 1, go_on), range(len(sizes))), strict=True):
            done += size
            if told is not None:
                told(done)
            yield found
    finally:
        ended.set()
        pool.shutdown(cancel_futures=True)


def sweep_over(scenario: Scenario, over: Any, *, product: bool, samples: bool) -> Sweep:
    """Give the members from what the user wants to go over."""
    axes = _axes(scenario, table("over", over))
    if not product:
        _same_lengths(axes)
    return Sweep(scenario, axes, product, samples)


def _axes(scenario: Scenario, over: dict[str, Any]) -> dict[str, Floats]:
    """Give the axes as arrays, each an initial value or a parameter of the scenario."""
    if not over:
        raise _core.InputError(
            "an ensemble needs something to go over: over={'theta': [0.1, 0.2]}, for instance"
        )
    known = [*scenario.start, *(k for k, x in scenario.parameters.items() if isinstance(x, float))]
    found = {}
    for name, values in over.items():
        if text("over", name) not in known:
            what = f"start or numeric parameter of {scenario.system.id}"
            raise _core.InputError(nearest(what, name, known))
        axis = array(f"over {name}", values)
        if axis.size == 0:
            raise _core.InputError(f"over {name}: the array is empty")
        if not np.isfinite(axis).all():
            raise _core.InputError(f"over {name}: {axis[~np.isfinite(axis)][0]} is not a finite number")
        found[name] = axis
    return found


def _same_lengths(axes: dict[str, Floats]) -> None:
    """Refuse rows that do not fit together."""
    lengths = {name: len(values) for name, values in axes.items()}
    if len(set(lengths.values())) > 1:
        told = ", ".join(f"{name} has {length}" for name, length in lengths.items())
        raise _core.InputError(f"the arrays differ in length: {told} (product=True runs every combination)")
