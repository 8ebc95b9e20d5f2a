"""Questions beyond a run."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from . import _core
from ._catalogue import UnknownNameError
from ._names import extra, nearest
from ._progress import bar
from ._scenario import Scenario
from ._table import Answer

if TYPE_CHECKING:
    from collections.abc import Sequence
    from pathlib import Path

    import xarray as xr
    from numpy.typing import ArrayLike
    from typing_extensions import Unpack

    from ._catalogue import System
    from ._core import Floats
    from ._progress import Progress
    from ._scenario import Settings


def lyapunov(
    system: str | Path | System | Scenario, *, progress: Progress = None, **settings: Unpack[Settings]
) -> Answer:
    """Compute all Lyapunov exponents with their errors (columns `index`, `exponent`, `error`, in 1/s).

    The settings are those of `precess.Scenario`; `until` says how long the motion is followed.

    Raises
    ------
    InputError
        Where a setting makes no sense, or the system has jumps.
    RunError
        Where the motion cannot be integrated.

    """
    scenario = Scenario.of(system).replace(**settings)
    with bar(progress, 1.0, "") as told:
        return Answer(scenario, "Lyapunov spectrum", _core.lyapunov(scenario._plan, told))  # noqa: SLF001


def poincare(
    system: str | Path | System | Scenario,
    section: str,
    *,
    direction: str | None = None,
    x: str | None = None,
    y: str | None = None,
    progress: Progress = None,
    **settings: Unpack[Settings],
) -> Answer:
    """Compute a Poincaré section: time and state at every passage.

    Parameters
    ----------
    section
        `"theta = 0"`, `"theta = 0 mod 2*pi"`, or in the time of a drive `"t = 0 mod period"`.
    direction
        `"rising"`, `"falling"` or `"either"` (where absent).
    x, y
        What the picture shows.

    """
    scenario = Scenario.of(system).replace(**settings)
    with bar(progress, 1.0, "") as told:
        answer = _core.poincare(scenario._plan, section, direction, x, y, told)  # noqa: SLF001
    return Answer(scenario, "Poincaré section", answer)


class Sensitivity:
    """A motion and its derivatives with respect to its start and its parameters.

    `found["theta"]` is the motion, shape `(times,)`, and `found["theta", "l"]` its derivative with respect to `l`.
    Columns are the numbers of the state and the observables.
    """

    def __init__(
        self, scenario: Scenario, along: list[str], times: Floats, found: tuple[Floats, Floats]
    ) -> None:
        self.scenario = scenario
        """The scenario."""
        self.along = tuple(along)
        """What moves."""
        self.t = times
        """The times, in s."""
        self.columns: tuple[str, ...] = tuple(name for name, *_ in scenario._plan.columns[1:])  # noqa: SLF001
        """Names of the columns."""
        self.values, self.slopes = found
        """The motion `(times, columns)` and its derivatives `(times, along, columns)`."""

    def _column(self, name: str) -> int:
        if name not in self.columns:
            what = f"column of {self.scenario.system.id}"
            raise UnknownNameError(nearest(what, str(name), self.columns))
        return self.columns.index(name)

    def __getitem__(self, names: str | tuple[str, str]) -> Floats:
        if isinstance(names, str):
            return self.values[:, self._column(names)]
        name, along = names
        if along not in self.along:
            raise UnknownNameError(nearest("direction", str(along), self.along))
        return self.slopes[:, self.along.index(along), self._column(name)]

    @property
    def transition(self) -> Floats:
        """The state-transition matrix: the derivative of number i by the start of number j, `(times, i, j)`."""
        state = list(self.scenario.start)
        missing = [name for name in state if name not in self.along]
        if missing:
            raise _core.InputError(
                f"the state-transition matrix needs all numbers of the start: {missing[0]} is missing"
            )
        places = [self.along.index(name) for name in state]
        return np.swapaxes(self.slopes[:, places, : len(state)], 1, 2)

    def to_xarray(self) -> xr.Dataset:
        """Give a dataset: a variable for each column, and one `d<column>` with the dimensions `t` and `along`."""
        try:
            import xarray as xr
        except ImportError:
            raise extra("xarray", "xarray") from None
        data: dict[str, Any] = {}
        for k, name in enumerate(self.columns):
            data[name] = ("t", self.values[:, k])
            data[f"d{name}"] = (("t", "along"), self.slopes[:, :, k])
        coords = {"t": ("t", self.t, {"units": "s"}), "along": list(self.along)}
        return xr.Dataset(data, coords=coords, attrs={"scenario": self.scenario.toml})

    def __repr__(self) -> str:
        what = f"{len(self.columns)} columns at {len(self.t)} times"
        return f"<precess.Sensitivity of {self.scenario.system.id} along {', '.join(self.along)}: {what}>"


def sensitivity(
    system: str | Path | System | Scenario,
    along: Sequence[str] | str | None = None,
    *,
    times: ArrayLike | None = None,
    progress: Progress = None,
    **settings: Unpack[Settings],
) -> Sensitivity:
    """Compute how a motion answers to its start and its parameters, by the variational equations (dual numbers).

    Parameters
    ----------
    along
        Names of numbers of the start and of numeric parameters (`"masses[0]"` for an item of a list); all numbers of
        the start where absent, which gives the state-transition matrix.
    times
        When, rising from zero on; the scenario's samples where absent.

    Raises
    ------
    InputError
        Where a name or a setting makes no sense, or the system has jumps.
    RunError
        Where the motion cannot be integrated.

    """
    scenario = Scenario.of(system).replace(**settings)
    names = list(scenario.start) if along is None else [along] if isinstance(along, str) else list(along)
    moments = _moments(scenario) if times is None else np.atleast_1d(np.asarray(times, dtype=np.float64))
    if moments.ndim != 1:
        raise _core.InputError(f"times: an array of one dimension is needed, not of {moments.ndim}")
    with bar(progress, 1.0, "") as told:
        found = _core.sensitivities(scenario._plan, names, moments, told)  # noqa: SLF001
    return Sensitivity(scenario, names, moments, found)


def _moments(scenario: Scenario) -> Floats:
    """Give the times of a scenario's samples."""
    if scenario.until < 0:
        raise _core.InputError(f"the end must not lie before zero here, as {scenario.until} does")
    moments = np.arange(0, scenario.until / scenario.every + 1e-9) * scenario.every
    moments[moments > scenario.until] = scenario.until
    return moments if moments[-1] == scenario.until else np.append(moments, scenario.until)
