"""What came out of a run: NumPy arrays by name, with units, events and provenance."""

from __future__ import annotations

import html
from typing import TYPE_CHECKING, Any, NamedTuple

from . import _core
from ._catalogue import UnknownNameError
from ._names import extra, nearest

if TYPE_CHECKING:
    import pandas as pd
    import xarray as xr
    from matplotlib.figure import Figure

    from ._core import Floats
    from ._scenario import Scenario


class Column(NamedTuple):
    """A column of a trajectory."""

    name: str
    unit: str
    """SI, empty for a pure number."""
    kind: str
    """`"time"`, `"state"`, `"signal"` or `"invariant"`: an observable that ought to stay constant in this run."""


class Event(NamedTuple):
    """A crossing that was met."""

    name: str
    t: float
    """When, in s."""
    state: dict[str, float]
    """The state there, before any jump."""


class Drift(NamedTuple):
    """How far an invariant has drifted."""

    name: str
    unit: str
    start: float
    """Its value at the start."""
    largest: float
    """The largest departure from it."""
    relative: float | None
    """The same relative to the start; None where the start is zero."""


class Trajectory:
    """The samples of a run.

    `trajectory["theta"]` (or `trajectory.theta`) is a column and `trajectory.t` the times: arrays of shape
    `(samples,)`, read-only views of `numbers`, which has shape `(samples, columns)`. Units are in `columns`.
    """

    def __init__(self, scenario: Scenario, outcome: _core.Outcome) -> None:
        self.scenario = scenario
        """The scenario; `scenario.toml` runs the same for ever."""
        self.numbers: Floats = outcome.numbers
        """All samples, a row each; read-only."""
        self.numbers.flags.writeable = False
        self.columns: tuple[Column, ...] = tuple(Column(*column) for column in outcome.columns)
        """Name, unit and kind of each column: time, state, observables."""
        self._places = {column.name: k for k, column in enumerate(self.columns)}
        names = [column.name for column in self.columns if column.kind == "state"]
        self.events: tuple[Event, ...] = tuple(
            Event(name, t, dict(zip(names, state, strict=True))) for name, t, state in outcome.events
        )
        """The crossings that were watched, and the system's own events, in the order of time."""
        self.drifts: tuple[Drift, ...] = tuple(Drift(*drift) for drift in outcome.drifts)
        """How far each invariant has drifted."""
        self.stopped_by: str | None = outcome.stopped_by
        """The event that ended the run, if one did."""
        self.steps, self.rejections, self.evaluations = outcome.counts
        self.scenario_hash: str = outcome.scenario[1]
        """SHA-256 of the scenario with everything spelt out."""

    @property
    def t(self) -> Floats:
        """The times of the samples, in s."""
        return self.numbers[:, 0]

    @property
    def state(self) -> Floats:
        """The states in the system's order (coordinates, then velocities), shape `(samples, numbers)`."""
        return self.numbers[:, 1 : self._proper]

    @property
    def _proper(self) -> int:
        """The number of leading columns that make the result proper: time and state."""
        return sum(column.kind in ("time", "state") for column in self.columns)

    def hash(self) -> str:
        """SHA-256 of time and state, as `precess run --hash` prints it: the same on every machine, in every face."""
        return _core.hash(self.numbers[:, : self._proper])

    def __getitem__(self, name: str) -> Floats:
        try:
            return self.numbers[:, self._places[name]]
        except (KeyError, TypeError):
            what = f"column of {self.scenario.system.id}"
            raise UnknownNameError(nearest(what, str(name), self._places)) from None

    def __getattr__(self, name: str) -> Floats:
        if name.startswith("_"):
            raise AttributeError(name)
        return self[name]

    def __dir__(self) -> list[str]:
        return [*super().__dir__(), *self._places]

    def __len__(self) -> int:
        return len(self.numbers)

    def to_pandas(self) -> pd.DataFrame:
        """Give a table with the times as its index; units and provenance are in its `attrs`."""
        try:
            import pandas as pd
        except ImportError:
            raise extra("pandas", "xarray") from None
        names = [column.name for column in self.columns[1:]]
        frame: pd.DataFrame = pd.DataFrame(
            self.numbers[:, 1:].copy(), index=pd.Index(self.t.copy(), name="t"), columns=names
        )
        frame.attrs = self._provenance() | {"units": {column.name: column.unit for column in self.columns}}
        return frame

    def to_xarray(self) -> xr.Dataset:
        """Give a dataset with the dimension `t`, a variable a column, units and provenance as attributes."""
        try:
            import xarray as xr
        except ImportError:
            raise extra("xarray", "xarray") from None
        meanings = {name: meaning for name, _, _, meaning in self.scenario._plan.columns}  # noqa: SLF001
        data = {
            column.name: (
                "t",
                self[column.name].copy(),
                {"units": column.unit, "long_name": meanings[column.name], "kind": column.kind},
            )
            for column in self.columns
        }
        time = data.pop("t")
        return xr.Dataset(data, coords={"t": time}, attrs=self._provenance())

    def _provenance(self) -> dict[Any, Any]:
        from . import __version__

        return {
            "title": self.scenario.title,
            "source": f"Precess {__version__}",
            "system": self.scenario.system.id,
            "method": self.scenario.method,
            "scenario": self.scenario.toml,
            "scenario_hash": self.scenario_hash,
            "result_hash": self.hash(),
            "steps": self.steps,
            "rejections": self.rejections,
            "evaluations": self.evaluations,
        }

    def plot(self, *names: str, x: str = "t", kind: str | None = None) -> Figure:
        """Draw it with matplotlib.

        Parameters
        ----------
        names
            Columns against time; the views of the system's card and its invariants where there are none.
        x
            The horizontal column: `plot("theta_dot", x="theta")` is a phase portrait.
        kind
            `"invariants"` for their drift, `"axis"` for the way of a top's axis on the sphere, `"contact"` for the
            trace of a contact point on its table.

        """
        from ._plot import plot

        return plot(self, names, x, kind)

    def __repr__(self) -> str:
        return (
            f"<precess.Trajectory {self.scenario.system.id}: {len(self)} samples of {len(self.columns)} columns, "
            f"t from {self.t[0]:g} to {self.t[-1]:g} s>"
        )

    def _repr_html_(self) -> str:
        step = ", ".join(f"{name} = {x:g}" for name, x in self.scenario.step.items())
        facts = [
            ("samples", f"{len(self)}, t from {self.t[0]:g} to {self.t[-1]:g} s"),
            ("method", f"{self.scenario.method}, {step}"),
            ("cost", f"{self.steps} steps, {self.rejections} rejected, {self.evaluations} evaluations"),
        ]
        facts += [(f"drift of {d.name}", _drift(d)) for d in self.drifts]
        if self.events:
            facts.append(("events", f"{len(self.events)}, the last at t = {self.events[-1].t:g} s"))
        if self.stopped_by:
            facts.append(("stopped by", self.stopped_by))
        rows = "".join(
            f"<tr><th style='text-align:left'>{html.escape(a)}</th><td>{html.escape(b)}</td></tr>"
            for a, b in facts
        )
        shown = [column for column in self.columns if column.kind != "signal"]
        head = "".join(f"<th>{html.escape(f'{c.name} [{c.unit}]' if c.unit else c.name)}</th>" for c in shown)
        some = [0, 1, 2, len(self) - 1] if len(self) > 4 else range(len(self))  # noqa: PLR2004
        body = "".join(
            "<tr>" + "".join(f"<td>{self[c.name][k]:.6g}</td>" for c in shown) + "</tr>" for k in some
        )
        return (
            f"<b>{html.escape(self.scenario.title)}</b> <code>{self.scenario.system.id}</code><table>{rows}</table>"
            f"<table><tr>{head}</tr>{body}</table>"
        )


def _drift(drift: Drift) -> str:
    """Say a drift: relative where that has a meaning."""
    if drift.relative is not None:
        return f"{drift.relative:.1e} (relative)"
    return f"{drift.largest:.1e} {drift.unit}".strip()
