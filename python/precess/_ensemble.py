"""Many starts, and many parameters, side by side."""

from __future__ import annotations

import functools
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from . import _core
from ._catalogue import UnknownNameError
from ._names import extra, knows_its_keywords, nearest
from ._progress import bar
from ._scenario import Scenario, table

if TYPE_CHECKING:
    from collections.abc import Mapping
    from pathlib import Path

    import xarray as xr
    from numpy.typing import ArrayLike

    from ._catalogue import System
    from ._core import Floats
    from ._progress import Progress, Told
    from ._scenario import Values

KEEPS = ["last", "samples"]


class Ensemble:
    """What came out of an ensemble.

    `ensemble["theta"]` is a number of the state: an array of the shape of the ensemble (an axis for each name of
    `over`, or one axis for the members where they are not all combinations), with a last axis for the times where
    every sample was kept. Where a member ended before its time its numbers are NaN, and `failures` says why.
    """

    def __init__(
        self,
        scenario: Scenario,
        over: dict[str, Floats],
        shape: tuple[int, ...],
        members: _Members,
        *,
        product: bool,
        samples: bool,
    ) -> None:
        self.scenario = scenario
        """What all members have in common."""
        self.over = over
        """The values along each axis, or of each member."""
        self.shape = shape
        """The shape of the ensemble."""
        self.t = members.times
        """The times that are kept, in s: the end alone, or every sample."""
        self.failures = members.failures
        """Why a member ended before its time, by its number in the order of the flattened ensemble."""
        self.names = members.names
        """Names of the state."""
        self._product = product
        self._samples = samples
        self._numbers = members.numbers

    @property
    def numbers(self) -> Floats:
        """All states: shape `(*shape, times, numbers of a state)`."""
        return self._numbers.reshape(*self.shape, len(self.t), len(self.names))

    def __getitem__(self, name: str) -> Floats:
        if name not in self.names:
            what = f"state of {self.scenario.system.id}"
            raise UnknownNameError(nearest(what, str(name), self.names))
        column = self.numbers[..., self.names.index(name)]
        return column if self._samples else column[..., 0]

    def __len__(self) -> int:
        return len(self._numbers)

    def hash(self, member: int) -> str:
        """SHA-256 of a member's times and states: the hash of the same run alone, where every sample is kept."""
        return _core.hash(np.column_stack([self.t, self._numbers[member]]))

    def to_xarray(self) -> xr.Dataset:
        """Give a dataset: a variable for each number of the state, a dimension for each name of `over`.

        A dimension is called `start_<name>` where it is an initial value, since the variable of that name is the
        value at the end.
        """
        try:
            import xarray as xr
        except ImportError:
            raise extra("xarray", "xarray") from None
        units = {name: (unit, meaning) for name, _, unit, meaning in self.scenario._plan.columns}  # noqa: SLF001

        def called(name: str) -> str:
            return f"start_{name}" if name in self.names else name

        dims = [called(name) for name in self.over] if self._product else ["member"]
        coords: dict[str, Any] = {
            called(name): (
                (called(name) if self._product else "member"),
                values,
                {"units": units.get(name, ("",))[0]},
            )
            for name, values in self.over.items()
        }
        if self._samples:
            dims = [*dims, "t"]
        coords["t"] = ("t" if self._samples else (), self.t if self._samples else self.t[0], {"units": "s"})
        data = {
            name: (dims, self[name].copy(), {"units": units[name][0], "long_name": units[name][1]})
            for name in self.names
        }
        from . import __version__

        attrs = {
            "source": f"Precess {__version__}",
            "scenario": self.scenario.toml,
            "failures": len(self.failures),
        }
        return xr.Dataset(data, coords=coords, attrs=attrs)

    def __repr__(self) -> str:
        failed = f", {len(self.failures)} failed" if self.failures else ""
        return f"<precess.Ensemble {self.scenario.system.id}: {len(self)} members over {', '.join(self.over)}{failed}>"


class _Members(NamedTuple):
    """Members in the order of the flattened ensemble."""

    times: Floats
    numbers: Floats
    failures: dict[int, str]
    names: tuple[str, ...]


@knows_its_keywords
def ensemble(
    system: str | Path | System | Scenario,
    over: Mapping[str, ArrayLike],
    *,
    product: bool = True,
    keep: str = "last",
    parameters: Values | None = None,
    start: Values | None = None,
    method: str | None = None,
    until: float | str | None = None,
    every: float | str | None = None,
    dt: float | str | None = None,
    rtol: float | str | None = None,
    atol: float | str | None = None,
    options: Values | None = None,
    threads: int | None = None,
    progress: Progress = None,
) -> Ensemble:
    """Run a system from many starts, or with many parameters, side by side in the lanes of the processor.

    Parameters
    ----------
    system
        A system, a scenario, or a scenario file.
    over
        Arrays of one dimension by name, each an initial value or a numeric parameter.
    product
        Whether every combination is run (a grid, an axis for each name), or one member for each row.
    keep
        `"last"` keeps the state at the end, `"samples"` at every sample.
    threads
        How many; as many as there are cores where absent. Nothing here changes a bit of the result.
    progress
        True for a progress bar (tqdm), or a function that is told now and then how many members are done.

    Returns
    -------
    Ensemble
        The states as NumPy arrays. A member has the bits of the same run alone.

    Raises
    ------
    InputError
        Where something makes no sense; the sentence says what, where, and the nearest right thing.

    """
    if keep not in KEEPS:
        raise _core.InputError(nearest("way to keep", str(keep), KEEPS))
    scenario = Scenario.of(system).replace(
        parameters=parameters,
        start=start,
        method=method,
        until=until,
        every=every,
        dt=dt,
        rtol=rtol,
        atol=atol,
        options=options,
    )
    axes = _axes(table("over", over))
    if product:
        shape = tuple(len(values) for values in axes.values())
        rows = np.stack(np.meshgrid(*axes.values(), indexing="ij"), axis=-1).reshape(-1, len(axes))
    else:
        shape = (_common_length(axes),)
        rows = np.column_stack(list(axes.values()))
    with bar(progress, len(rows), "runs") as told:
        members = _run(scenario, list(axes), rows, _How(keep == "samples", threads, told))
    return Ensemble(scenario, axes, shape, members, product=product, samples=keep == "samples")


def _axes(over: dict[str, Any]) -> dict[str, Floats]:
    if not over:
        raise _core.InputError(
            "an ensemble needs something to go over: over={'theta': [0.1, 0.2]}, for instance"
        )
    axes = {}
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
        axes[name] = axis
    return axes


def _common_length(axes: dict[str, Floats]) -> int:
    lengths = {name: len(values) for name, values in axes.items()}
    if len(set(lengths.values())) > 1:
        told = ", ".join(f"{name} has {length}" for name, length in lengths.items())
        raise _core.InputError(f"the arrays differ in length: {told} (product=True runs every combination)")
    return next(iter(lengths.values()))


def _run(scenario: Scenario, over: list[str], rows: Floats, run: _How) -> _Members:
    """Run the rows. Those with the same parameters go together, side by side in lanes."""
    plan = scenario._plan  # noqa: SLF001
    is_parameter = np.array([name in plan.parameters for name in over])
    starts = [name for name in over if name not in plan.parameters]
    sets, group = np.unique(rows[:, is_parameter], axis=0, return_inverse=True)
    group = group.reshape(-1)
    numbers: Floats | None = None
    failures: dict[int, str] = {}
    done = 0
    for number, values in enumerate(sets):
        mine = np.flatnonzero(group == number)
        parameters = dict(zip(np.array(over)[is_parameter].tolist(), values.tolist(), strict=True))
        own = plan.changed(parameters, {}, None, {}) if parameters else plan
        told = run.told and functools.partial(_told_more, run.told, done)
        part = own.ensemble(starts, rows[np.ix_(mine, ~is_parameter)], run.samples, run.threads, told)
        if numbers is None:
            numbers = np.empty((len(rows), *part.numbers.shape[1:]))
        numbers[mine] = part.numbers
        failures |= {int(mine[member]): why for member, why in part.failures}
        done += len(mine)
    assert numbers is not None, "an axis has at least one value"  # noqa: S101
    names = tuple(name for name, *_ in plan.columns[1 : numbers.shape[2] + 1])
    return _Members(part.times, numbers, dict(sorted(failures.items())), names)


class _How(NamedTuple):
    """How rows are run; nothing here changes a bit of them."""

    samples: bool
    threads: int | None
    told: Told | None


def _told_more(told: Told, before: int, done: float) -> None:
    told(before + done)
