"""Tables with named columns: what comes out of an analysis."""

from __future__ import annotations

import html
from typing import TYPE_CHECKING, Any

from ._catalogue import UnknownNameError
from ._names import extra, nearest

if TYPE_CHECKING:
    import pandas as pd
    import xarray as xr
    from matplotlib.figure import Figure

    from . import _core
    from ._core import Floats
    from ._scenario import Scenario


class Answer:
    """What comes out of an analysis: `answer["exponent"]` is a column, `answer.summary` says it in words."""

    def __init__(self, scenario: Scenario, what: str, answer: _core.Answer) -> None:
        self.scenario = scenario
        """The scenario that was asked about."""
        self.what = what
        """Which analysis."""
        self.numbers: Floats = answer.numbers
        """All numbers: a row each, a column for each of `columns`."""
        self.columns: dict[str, str] = dict(answer.columns)
        """Names and units."""
        self.summary: tuple[str, ...] = tuple(answer.summary)
        """What a person wants to know, line by line."""
        self.failure: str | None = answer.failure
        """Why the work ended before its time; what is there is right."""
        self._figure = answer.figure

    def __getitem__(self, name: str) -> Floats:
        if name not in self.columns:
            raise UnknownNameError(nearest(f"column of this {self.what}", str(name), self.columns))
        return self.numbers[:, list(self.columns).index(name)]

    def __len__(self) -> int:
        return len(self.numbers)

    def plot(self) -> Figure:
        """Draw it with matplotlib."""
        from ._figure import draw

        return draw(self._figure)

    def to_pandas(self) -> pd.DataFrame:
        """Give a table; units and the scenario are in its `attrs`."""
        try:
            import pandas as pd
        except ImportError:
            raise extra("pandas", "xarray") from None
        frame: pd.DataFrame = pd.DataFrame(self.numbers.copy(), columns=list(self.columns))
        frame.attrs = self._provenance() | {"units": dict(self.columns)}
        return frame

    def to_xarray(self) -> xr.Dataset:
        """Give a dataset with the dimension `row`, a variable for each column."""
        try:
            import xarray as xr
        except ImportError:
            raise extra("xarray", "xarray") from None
        data = {name: ("row", self[name].copy(), {"units": unit}) for name, unit in self.columns.items()}
        return xr.Dataset(data, attrs=self._provenance())

    def _provenance(self) -> dict[Any, Any]:
        from . import __version__

        return {"source": f"Precess {__version__}", "analysis": self.what, "scenario": self.scenario.toml}

    def __repr__(self) -> str:
        return f"<precess.Answer {self.what} of {self.scenario.system.id}: {'; '.join(self.summary) or len(self)}>"

    def _repr_html_(self) -> str:
        lines = "".join(f"<li>{html.escape(line)}</li>" for line in self.summary)
        return f"<b>{html.escape(self.what)}</b> <code>{self.scenario.system.id}</code><ul>{lines}</ul>"
