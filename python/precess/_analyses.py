"""Questions beyond a run."""

from __future__ import annotations

import os
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from . import _core
from ._catalogue import UnknownNameError
from ._given import SPAN, array, count, number, several, text, texts
from ._names import extra, knows_its_keywords, nearest
from ._progress import bar
from ._scenario import Scenario, table
from ._sweep import Members, side_by_side
from ._table import Answer
from ._tiles import done

if TYPE_CHECKING:
    from collections.abc import Sequence
    from pathlib import Path

    import xarray as xr
    from numpy.typing import ArrayLike
    from typing_extensions import Unpack

    from ._catalogue import System
    from ._core import Floats
    from ._progress import Progress, Told
    from ._scenario import Settings
    from ._tiles import Submits

    Window = Mapping[str, tuple[float | str, float | str]]
    SweepOf = str | Mapping[str, tuple[float | str, float | str, int]]

# Points that a thread takes at a time.
PIECE = 8


@knows_its_keywords
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


@knows_its_keywords
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
        answer = _core.poincare(scenario._plan, text("section", section), direction, x, y, told)  # noqa: SLF001
    return Answer(scenario, "Poincaré section", answer)


@knows_its_keywords
def portrait(
    system: str | Path | System | Scenario,
    window: Window | None = None,
    *,
    levels: int | None = None,
    progress: Progress = None,
    **settings: Unpack[Settings],
) -> Answer:
    """Find the fixed points with their eigenvalues, and draw the phase portrait.

    Parameters
    ----------
    window
        The part of the space of states that is looked at: `{"x": (-2, 2), "x_dot": (-3, 3)}`; chosen where absent.
    levels
        About how many levels of the energy are drawn.

    """
    scenario = Scenario.of(system).replace(**settings)
    windows = []
    for name, ends in table("window", window).items():
        low, high = several(f"window {name}", "a lowest and a highest value", ends, 2)
        windows.append(f"{name}={_text(low)}:{_text(high)}")
    with bar(progress, 1.0, "") as told:
        return Answer(scenario, "phase portrait", _core.portrait(scenario._plan, windows, levels, told))  # noqa: SLF001


@knows_its_keywords
def response(
    system: str | Path | System | Scenario,
    sweep: SweepOf,
    *,
    coordinate: str | None = None,
    down: bool = False,
    progress: Progress = None,
    **settings: Unpack[Settings],
) -> Answer:
    """Measure the response to a drive along a parameter: amplitude, lag, and for linear equations the exact ones.

    Parameters
    ----------
    sweep
        `{"frequency": (0.2, 3, 200)}`: first value, last value, how many; or `"frequency=0.2:3:200"`.
    coordinate
        The number of the state; the first coordinate where absent.
    down
        From the last value to the first: a branch is followed, so the way matters where there are two.

    """
    scenario = Scenario.of(system).replace(**settings)
    with bar(progress, 1.0, "") as told:
        answer = _core.response(scenario._plan, _sweeps(sweep, 1)[0], coordinate, down, told)  # noqa: SLF001
    return Answer(scenario, "response", answer)


@knows_its_keywords
def bifurcation(
    system: str | Path | System | Scenario,
    sweep: SweepOf,
    *,
    coordinate: str | None = None,
    down: bool = False,
    progress: Progress = None,
    **settings: Unpack[Settings],
) -> Answer:
    """Follow the motion along a parameter: a coordinate once a period of the drive (at its maxima, without a drive).

    The arguments are those of `precess.response`.
    """
    scenario = Scenario.of(system).replace(**settings)
    with bar(progress, 1.0, "") as told:
        answer = _core.bifurcation(scenario._plan, _sweeps(sweep, 1)[0], coordinate, down, told)  # noqa: SLF001
    return Answer(scenario, "bifurcation diagram", answer)


class Points(NamedTuple):
    """Points of a sweep of Floquet multipliers, and any part of them: what a worker anywhere is given."""

    scenario: Scenario
    sweeps: list[str]

    @property
    def size(self) -> int:
        """How many points there are."""
        return _core.floquet_points(self.sweeps)

    def identity(self) -> list[object]:
        """Give what tells this sweep from any other."""
        return ["floquet", self.scenario.toml, self.sweeps]

    def part(self, first: int, last: int) -> tuple[Points, int, int]:
        """Give what a worker needs."""
        return self, first, last

    def run(self, first: int, last: int, threads: int | None = None, told: Told | None = None) -> Members:
        """Find the largest moduli at the points from one number to another, in pieces of which each thread takes one."""
        plan = self.scenario._plan  # noqa: SLF001
        cuts = range(first, last, PIECE)
        sizes = [min(PIECE, last - cut) for cut in cuts]

        def piece(number: int, _: int | None, told: Told | None) -> Floats:
            return _core.floquet_part(plan, self.sweeps, cuts[number], cuts[number] + sizes[number], told)

        found = side_by_side(piece, sizes, threads or os.cpu_count() or 1, told)
        return Members(np.zeros(1), np.concatenate(list(found)), {})


@knows_its_keywords
def floquet(
    system: str | Path | System | Scenario,
    sweep: SweepOf | None = None,
    *,
    threads: int | None = None,
    client: Submits | None = None,
    tile: int = 256,
    store: str | Path | None = None,
    progress: Progress = None,
    **settings: Unpack[Settings],
) -> Answer:
    """Compute Floquet multipliers: of the periodic motion near the start, along a parameter, or over two.

    Parameters
    ----------
    sweep
        `{"f": (0, 1, 50)}`, or two: first value, last value, how many.
    threads, client, tile, store
        Where the points of a sweep are computed, as in `precess.ensemble`; nothing here changes a bit of the result.

    """
    scenario = Scenario.of(system).replace(**settings)
    if threads is not None:
        count("threads", threads)
    if sweep is None:
        if client is not None or store is not None:
            raise _core.InputError("one motion cannot be cut into tiles: a client or a store needs a sweep")
        with bar(progress, 1.0, "") as told:
            return Answer(scenario, "Floquet multipliers", _core.floquet(scenario._plan, [], told))  # noqa: SLF001
    points = Points(scenario, _sweeps(sweep, 2))
    with bar(progress, points.size, "points") as told:
        moduli = done(points, client=client, tile=tile, store=store, threads=threads, told=told).numbers
    return Answer(
        scenario,
        "Floquet multipliers",
        _core.floquet_whole(scenario._plan, points.sweeps, moduli),  # noqa: SLF001
    )


@knows_its_keywords
def frenet(
    system: str | Path | System | Scenario,
    *,
    x: str | None = None,
    y: str | None = None,
    progress: Progress = None,
    **settings: Unpack[Settings],
) -> Answer:
    """Follow a path in a plane with its speed, accelerations along and across it, and its curvature."""
    scenario = Scenario.of(system).replace(**settings)
    with bar(progress, 1.0, "") as told:
        return Answer(scenario, "path", _core.frenet(scenario._plan, x, y, told))  # noqa: SLF001


@knows_its_keywords
def trust(
    system: str | Path | System | Scenario,
    *,
    within: float = 1e-3,
    progress: Progress = None,
    **settings: Unpack[Settings],
) -> Answer:
    """Tell how far a run can be trusted: its distance from a shadow with twice the digits, at every sample.

    Columns `t`, `error` (a share of the state's size so far) and `trusted`: one up to the horizon, the last sample
    before the error exceeds `within`, and zero beyond.
    """
    scenario = Scenario.of(system).replace(**settings)
    with bar(progress, 1.0, "") as told:
        return Answer(scenario, "trust", _core.trust(scenario._plan, number("within", within), told))  # noqa: SLF001


def _text(value: float | str) -> str:
    return value if isinstance(value, str) else repr(number("a range", value))


def _sweeps(sweep: SweepOf, most: int) -> list[str]:
    """Give sweeps as the command line has them."""
    if isinstance(sweep, str):
        return [sweep]
    if not isinstance(sweep, Mapping) or not 1 <= len(sweep) <= most:
        how_many = "one parameter" if most == 1 else "one parameter or two"
        raise _core.InputError(f"a sweep goes over {how_many}: {{'frequency': (0.2, 3, 200)}}, for instance")
    found = []
    for name, span in sweep.items():
        low, high, points = several(name, SPAN, span, 3)
        found.append(f"{name}={_text(low)}:{_text(high)}:{points}")
    return found


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
        state = self.scenario.state
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


@knows_its_keywords
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
    names = list(scenario.state) if along is None else texts("along", along)
    moments = _moments(scenario) if times is None else array("times", times)
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
