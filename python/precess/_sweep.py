"""A sweep over starts and parameters, and any part of it: what a worker anywhere is given."""

from __future__ import annotations

import functools
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from . import _core

if TYPE_CHECKING:
    from ._core import Floats
    from ._progress import Told
    from ._scenario import Scenario


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
        """Run the members from one number to another. Those with the same parameters go side by side in lanes."""
        plan = self.scenario._plan  # noqa: SLF001
        known = plan.parameters
        is_parameter = np.array([name in known for name in self.axes])
        starts = [name for name in self.axes if name not in known]
        swept = [name for name in self.axes if name in known]
        rows = self.rows(first, last)
        sets, group = np.unique(rows[:, is_parameter], axis=0, return_inverse=True)
        numbers: Floats | None = None
        failures: dict[int, str] = {}
        done = 0
        for number, values in enumerate(sets):
            mine = np.flatnonzero(group.reshape(-1) == number)
            own = (
                plan.changed(dict(zip(swept, values.tolist(), strict=True)), {}, None, {}) if swept else plan
            )
            more = told and functools.partial(_told_more, told, done)
            part = own.ensemble(starts, rows[np.ix_(mine, ~is_parameter)], self.samples, threads, more)
            if numbers is None:
                numbers = np.empty((len(rows), *part.numbers.shape[1:]))
            numbers[mine] = part.numbers
            failures |= {int(mine[member]): why for member, why in part.failures}
            done += len(mine)
        assert numbers is not None, "an axis has at least one value"  # noqa: S101
        return Members(part.times, numbers, dict(sorted(failures.items())))


def _told_more(told: Told, before: int, done: float) -> None:
    told(before + done)


def axes(over: dict[str, Any]) -> dict[str, Floats]:
    """Give the axes as arrays."""
    if not over:
        raise _core.InputError(
            "an ensemble needs something to go over: over={'theta': [0.1, 0.2]}, for instance"
        )
    found = {}
    for name, values in over.items():
        try:
            axis = np.asarray(values, dtype=np.float64)
        except (TypeError, ValueError):
            raise TypeError(f"over {name}: an array of numbers is needed") from None
        if axis.ndim != 1:
            raise _core.InputError(f"over {name}: an array of one dimension is needed, not of {axis.ndim}")
        if axis.size == 0:
            raise _core.InputError(f"over {name}: the array is empty")
        if not np.isfinite(axis).all():
            raise _core.InputError(f"over {name}: {axis[~np.isfinite(axis)][0]} is not a finite number")
        found[name] = axis
    return found


def same_lengths(axes: dict[str, Floats]) -> None:
    """Refuse rows that do not fit together."""
    lengths = {name: len(values) for name, values in axes.items()}
    if len(set(lengths.values())) > 1:
        told = ", ".join(f"{name} has {length}" for name, length in lengths.items())
        raise _core.InputError(f"the arrays differ in length: {told} (product=True runs every combination)")
