"""A scenario fitted to measured points."""

from __future__ import annotations

import csv
import html
from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from . import _core
from ._given import array, number, texts
from ._names import knows_its_keywords, nearest
from ._progress import bar
from ._scenario import Scenario, table
from ._simulate import run

if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence

    from matplotlib.figure import Figure
    from typing_extensions import Unpack

    from ._catalogue import System
    from ._core import Floats
    from ._progress import Progress
    from ._scenario import Settings
    from ._trajectory import Trajectory


class Fit:
    """A fit: what was found, how well it is known, and the fitted scenario."""

    def __init__(self, columns: list[str], fit: _core.Fit) -> None:
        self.values: dict[str, float] = {name: value for name, _, value, _, _ in fit.fitted}
        """The fitted numbers by name."""
        self.errors: dict[str, float] = {name: error for name, _, _, error, _ in fit.fitted}
        """Their standard errors."""
        self.intervals: dict[str, tuple[float, float]] = {
            name: interval for name, _, _, _, interval in fit.fitted
        }
        """Where they lie with a probability of 95 %."""
        self.units: dict[str, str] = {name: unit for name, unit, _, _, _ in fit.fitted}
        """Their units."""
        self.correlation: Floats = np.array(fit.correlation)
        """The correlation of each with each, in the order of `values`."""
        self.scatter: dict[str, float] = dict(zip(columns, fit.scatter, strict=True))
        """How far each column lies from the motion, root mean square."""
        self.chi2: float = fit.chi2
        """The sum of the squares over the uncertainties (over the scatter where none were given)."""
        self.freedom: int = fit.freedom
        """Numbers measured less numbers fitted."""
        self.model: dict[str, Floats] = dict(zip(columns, fit.model, strict=True))
        """The fitted columns at the times of the data."""
        self.scenario: Scenario = Scenario.parse(fit.scenario)
        """The fitted scenario."""
        self.summary: tuple[str, ...] = tuple(fit.answer.summary)
        """All that, in words."""
        self._figure = fit.answer.figure

    def simulate(self) -> Trajectory:
        """Run the fitted scenario."""
        return run(self.scenario)

    def plot(self) -> Figure:
        """Draw the data over the model with matplotlib."""
        from ._figure import draw

        return draw(self._figure)

    def __repr__(self) -> str:
        found = ", ".join(
            f"{name} = {value:.6g} ± {self.errors[name]:.1g}" for name, value in self.values.items()
        )
        return f"<precess.Fit of {self.scenario.system.id}: {found}>"

    def _repr_html_(self) -> str:
        rows = "".join(
            f"<tr><td>{html.escape(name)}</td><td>{value:.8g} ± {self.errors[name]:.2g} {html.escape(self.units[name])}"
            f"</td><td>{self.intervals[name][0]:.8g} to {self.intervals[name][1]:.8g}</td></tr>"
            for name, value in self.values.items()
        )
        return f"<table><tr><th></th><th>fitted</th><th>95 %</th></tr>{rows}</table>"


@knows_its_keywords
def fit(
    system: str | Path | System | Scenario,
    data: object,
    *,
    free: Sequence[str] | str,
    columns: Sequence[str] | str | None = None,
    uncertainties: Mapping[str, float] | None = None,
    progress: Progress = None,
    **settings: Unpack[Settings],
) -> Fit:
    """Estimate starts and parameters from measured points, with their uncertainties.

    Levenberg and Marquardt's method on exact derivatives (`precess.sensitivity`). The errors take the scatter about the
    motion for independent and normal; with `uncertainties` they are taken as given.

    Parameters
    ----------
    system
        What moves; its starts and parameters are the first guesses. A start is at t = 0.
    data
        Columns of numbers with the times under `t`: a dictionary of arrays, a pandas table (times may be its index), an
        xarray dataset, or the path of a CSV file. A column is a number of the state or an observable.
    free
        What is fitted: numbers of the start and numeric parameters, `"masses[0]"` for an item of a list.
    columns
        The columns that are used; all of them where absent.
    uncertainties
        One standard deviation for each column.

    Raises
    ------
    InputError
        Where a name or a value makes no sense, times fall or repeat, a value is missing, the data are too few, or do
        not determine what is free; the sentence says which.
    RunError
        Where no motion gets to the end of the data from the first guesses.

    """
    scenario = Scenario.of(system).replace(**settings)
    names = None if columns is None else texts("columns", columns)
    times, measured = _table(data, names)
    given = {
        name: number(f"uncertainty of {name}", x) for name, x in table("uncertainties", uncertainties).items()
    }
    for name in given:
        if name not in measured:
            raise _core.InputError(nearest("measured column", str(name), measured))
    if given and len(given) < len(measured):
        missing = next(name for name in measured if name not in given)
        raise _core.InputError(f"{missing} has no uncertainty: either every column has one, or none")
    with bar(progress, 1.0, "") as told:
        found = _core.fit(
            scenario._plan,  # noqa: SLF001
            times,
            list(measured.items()),
            [given[name] for name in measured] if given else [],
            texts("free", free),
            told,
        )
    return Fit(list(measured), found)


def _table(data: object, names: list[str] | None) -> tuple[Floats, dict[str, Floats]]:
    """Give times and columns from whatever holds them."""
    if isinstance(data, (str, Path)):
        data = _read(Path(data))
    elif hasattr(data, "reset_index") and hasattr(data, "columns"):
        frame: Any = data
        data = {str(name): frame[name].to_numpy() for name in frame.columns}
        if "t" not in data and frame.index.name == "t":
            data["t"] = frame.index.to_numpy()
    if not isinstance(data, Mapping):
        kind = type(data).__name__
        raise TypeError(f"data are a dictionary, a table, a dataset, or the path of a CSV file, not {kind}")
    keys = [str(key) for key in data if str(key) != "t"]
    if "t" not in data:
        raise _core.InputError("the data have no times: a column t is needed")
    for name in names or []:
        if name not in keys:
            raise _core.InputError(nearest("measured column", name, keys))
    return array("t", data["t"]), {name: array(name, data[name]) for name in names or keys}


def _read(path: Path) -> dict[str, list[float]]:
    """Read a CSV file: a line of names, perhaps with units in brackets, then a line for each time."""
    try:
        whole = path.read_text(encoding="utf-8-sig")
    except UnicodeDecodeError:
        raise _core.InputError(f"{path}: this is no text") from None
    lines = [line for line in whole.splitlines() if line and not line.startswith("#")]
    if not lines:
        raise _core.InputError(f"{path}: the file is empty")
    semicolons = ";" in lines[0]
    rows: Iterable[list[str]] = csv.reader(lines, delimiter=";" if semicolons else ",")
    head, *body = rows
    names = [name.split("[")[0].strip() for name in head]
    table: dict[str, list[float]] = {name: [] for name in names}
    for place, row in enumerate(body, start=2):
        if len(row) != len(names):
            raise _core.InputError(f"{path}: row {place} has {len(row)} fields for {len(names)} names")
        for name, field in zip(names, row, strict=True):
            try:
                table[name].append(float(field.replace(",", ".") if semicolons else field))
            except ValueError:  # noqa: PERF203
                where = f"{path}: row {place}: {name} is no number ({field!r})"
                raise _core.InputError(f"{where}: leave out rows that have a gap") from None
    return table
