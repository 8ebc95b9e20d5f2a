"""Lyapunov spectra over parameters and starts."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from . import _core
from ._given import count as at_least_one
from ._names import extra, knows_its_keywords
from ._progress import bar
from ._scenario import Scenario
from ._sweep import Members, Sweep, side_by_side, sweep_over
from ._tiles import done

if TYPE_CHECKING:
    from collections.abc import Mapping
    from pathlib import Path

    import xarray as xr
    from matplotlib.figure import Figure
    from numpy.typing import ArrayLike
    from typing_extensions import Unpack

    from ._catalogue import System
    from ._core import Floats
    from ._progress import Progress, Told
    from ._scenario import Settings
    from ._tiles import Submits

# What may be drawn: a curve over one name, a map over two.
LINE, MAP = 1, 2


class Spectra(NamedTuple):
    """The spectra of a sweep's members, and any part of them: what a worker anywhere is given."""

    sweep: Sweep

    @property
    def scenario(self) -> Scenario:
        """What all members have in common."""
        return self.sweep.scenario

    @property
    def size(self) -> int:
        """How many members there are."""
        return self.sweep.size

    def identity(self) -> list[object]:
        """Give what tells this sweep from any other."""
        return ["lyapunov", *self.sweep.identity()]

    def part(self, first: int, last: int) -> tuple[Spectra, int, int]:
        """Give what a worker needs for the members from one number to another."""
        part, *span = self.sweep.part(first, last)
        return Spectra(part), span[0], span[1]

    def run(self, first: int, last: int, threads: int | None = None, told: Told | None = None) -> Members:
        """Find exponents and errors of the members from one number to another; each thread takes one after another."""
        plan = self.scenario._plan  # noqa: SLF001
        known = plan.parameters
        rows = self.sweep.rows(first, last)
        names = list(self.sweep.axes)

        def member(number: int, _: int | None, told: Told | None) -> tuple[Floats, str | None]:
            values: dict[str, object] = dict(zip(names, rows[number].tolist(), strict=True))
            parameters = {name: value for name, value in values.items() if name in known}
            start = {name: value for name, value in values.items() if name not in known}
            try:
                answer = _core.lyapunov(plan.changed(parameters, start, None, {}), told)
            except _core.RunError as error:
                return np.full((len(plan.state), 2), np.nan), str(error)
            return answer.numbers[:, 1:], None

        found = list(side_by_side(member, [1] * len(rows), threads or os.cpu_count() or 1, told))
        failures = {number: why for number, (_, why) in enumerate(found) if why is not None}
        return Members(np.zeros(1), np.stack([numbers for numbers, _ in found]), failures)


class Exponents:
    """Lyapunov spectra over parameters and starts.

    `exponents` and `errors` have the shape of the sweep (an axis for each name of `over`, or one for the members where
    they are not all combinations) and a last axis for the spectrum, largest first, in 1/s.
    """

    def __init__(self, sweep: Sweep, members: Members) -> None:
        self.scenario = sweep.scenario
        """What all members have in common."""
        self.over = sweep.axes
        """The values along each axis, or of each member."""
        self.exponents: Floats = members.numbers[..., 0].reshape(*sweep.shape, -1)
        """The exponents, NaN where a motion cannot be followed."""
        self.errors: Floats = members.numbers[..., 1].reshape(*sweep.shape, -1)
        """Their errors."""
        self.failures = members.failures
        """Why a motion could not be followed, by its number in the order of the flattened sweep."""
        self._product = sweep.product

    @property
    def largest(self) -> Floats:
        """The largest exponent of each member."""
        return self.exponents[..., 0]

    def to_xarray(self) -> xr.Dataset:
        """Give a dataset: `exponent` and `error`, a dimension for each name of `over`, and `index` from 1 on."""
        try:
            import xarray as xr
        except ImportError:
            raise extra("xarray", "xarray") from None
        from . import __version__

        dims = [*(self.over if self._product else ["member"]), "index"]
        coords: dict[str, Any] = {
            name: (name if self._product else "member", values) for name, values in self.over.items()
        }
        coords["index"] = np.arange(1, self.exponents.shape[-1] + 1)
        data = {
            "exponent": (dims, self.exponents.copy(), {"units": "1/s"}),
            "error": (dims, self.errors.copy(), {"units": "1/s"}),
        }
        attrs = {"source": f"Precess {__version__}", "scenario": self.scenario.toml}
        return xr.Dataset(data, coords=coords, attrs=attrs)

    def plot(self) -> Figure:
        """Draw with matplotlib: all exponents over one name, a map of the largest over two."""
        try:
            import matplotlib.pyplot as plt
        except ImportError:
            raise extra("matplotlib", "plot") from None
        count = len(self.over) if self._product else 0
        if count not in (LINE, MAP):
            raise _core.InputError("one name or two, in all combinations, can be drawn: see to_xarray()")
        units = {quantity.name: quantity.unit for quantity in self.scenario.system.parameters}
        labels = [f"{name} [{units[name]}]" if units.get(name) else name for name in self.over]
        figure, axes = plt.subplots(figsize=(6.5, 4), layout="constrained")
        values = list(self.over.values())
        if count == LINE:
            for k in range(self.exponents.shape[-1]):
                axes.plot(values[0], self.exponents[:, k], ".-", lw=1, ms=3, label=f"$\\lambda_{{{k + 1}}}$")
            axes.axhline(0, color="0.5", lw=0.6)
            axes.set(xlabel=labels[0], ylabel="exponents [1/s]")
            axes.legend(fontsize="small")
        else:
            reach = float(np.nanmax(np.abs(self.largest)))
            drawn = axes.pcolormesh(*values, self.largest.T, cmap="RdBu_r", vmin=-reach, vmax=reach)
            figure.colorbar(drawn, label="largest exponent [1/s]")
            axes.set(xlabel=labels[0], ylabel=labels[1])
        axes.set_title(f"{self.scenario.title}: Lyapunov exponents", fontsize="medium")
        return figure

    def __repr__(self) -> str:
        failed = f", {len(self.failures)} failed" if self.failures else ""
        count = int(np.prod(self.exponents.shape[:-1]))
        return f"<precess.Exponents of {self.scenario.system.id}: {count} spectra over {', '.join(self.over)}{failed}>"


@knows_its_keywords
def lyapunov_sweep(
    system: str | Path | System | Scenario,
    over: Mapping[str, ArrayLike],
    *,
    product: bool = True,
    threads: int | None = None,
    client: Submits | None = None,
    tile: int = 64,
    store: str | Path | None = None,
    progress: Progress = None,
    **settings: Unpack[Settings],
) -> Exponents:
    """Compute all Lyapunov exponents over parameters and starts, each as `precess.lyapunov` does.

    Parameters
    ----------
    over, product
        Arrays by name, each an initial value or a numeric parameter, as in `precess.ensemble`.
    threads, client, tile, store
        Where the members are computed, as in `precess.ensemble`; nothing here changes a bit of the result.

    Raises
    ------
    InputError
        Where something makes no sense, or the system has jumps.

    """
    scenario = Scenario.of(system).replace(**settings)
    work = Spectra(sweep_over(scenario, over, product=product, samples=False))
    if threads is not None:
        at_least_one("threads", threads)
    with bar(progress, work.size, "spectra") as told:
        members = done(work, client=client, tile=tile, store=store, threads=threads, told=told)
    return Exponents(work.sweep, members)
