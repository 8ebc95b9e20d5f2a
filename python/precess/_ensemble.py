"""Many starts, and many parameters, side by side."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from . import _core
from ._catalogue import UnknownNameError
from ._given import count
from ._names import extra, knows_its_keywords, nearest
from ._progress import bar
from ._scenario import Scenario
from ._sweep import sweep_over
from ._tiles import TILE, done

if TYPE_CHECKING:
    from collections.abc import Mapping
    from pathlib import Path

    import xarray as xr
    from numpy.typing import ArrayLike

    from ._catalogue import System
    from ._core import Floats
    from ._progress import Progress
    from ._scenario import Values
    from ._sweep import Members, Sweep
    from ._tiles import Submits

KEEPS = ["last", "samples"]


class Ensemble:
    """What came out of an ensemble.

    `ensemble["theta"]` is a number of the state: an array of the shape of the ensemble (an axis for each name of
    `over`, or one axis for the members where they are not all combinations), with a last axis for the times where
    every sample was kept. Where a member ended before its time its numbers are NaN, and `failures` says why.
    """

    def __init__(self, sweep: Sweep, members: Members) -> None:
        self.scenario = sweep.scenario
        """What all members have in common."""
        self.over = sweep.axes
        """The values along each axis, or of each member."""
        self.shape = sweep.shape
        """The shape of the ensemble."""
        self.t = members.times
        """The times that are kept, in s: the end alone, or every sample."""
        self.failures = members.failures
        """Why a member ended before its time, by its number in the order of the flattened ensemble."""
        self.names: tuple[str, ...] = sweep.scenario.state
        """Names of the state."""
        self._product = sweep.product
        self._samples = sweep.samples
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
    client: Submits | None = None,
    tile: int = TILE,
    store: str | Path | None = None,
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
    client
        A Dask client, or any `concurrent.futures.Executor`: the members are run there, in tiles, by one thread each
        where `threads` is absent. The bits are those of one machine.
    tile
        The number of members that go to a worker at a time.
    store
        A folder (Zarr) that keeps the tiles; a sweep that was stopped resumes there.
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
    members = sweep_over(scenario, over, product=product, samples=keep == "samples")
    if threads is not None:
        count("threads", threads)
    with bar(progress, members.size, "runs") as told:
        return Ensemble(
            members, done(members, client=client, tile=tile, store=store, threads=threads, told=told)
        )
