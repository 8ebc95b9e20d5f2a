"""Basins of attraction: where each start of a grid ends, and only what is proved."""

from __future__ import annotations

import html
import math
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from . import _core
from ._given import SPAN, count, number, several, text
from ._names import extra, knows_its_keywords
from ._progress import bar
from ._scenario import Scenario
from ._sweep import Members
from ._tiles import done

if TYPE_CHECKING:
    from pathlib import Path

    import xarray as xr
    from matplotlib.figure import Figure
    from numpy.typing import NDArray
    from typing_extensions import Unpack

    from ._catalogue import System
    from ._core import Floats
    from ._progress import Progress, Told
    from ._scenario import Settings
    from ._tiles import Submits

# Starts of a tile: many more than the scouts that each tile sends out for the attractors.
TILE = 16384


class Attractor(NamedTuple):
    """What motions end at."""

    state: dict[str, float]
    """A state of it."""
    kind: str
    """A fixed point, or a cycle."""
    pass_energy: float | None
    """The energy below which nothing leaves it, where that is the proof."""


class Basins:
    """Where the starts end.

    `labels` has an axis for each name of `over`: the number of the attractor, -1 where a start is undecided, -2 where
    it has escaped, -3 where it does not go on in numbers.
    """

    def __init__(self, over: dict[str, Floats], found: _core.Basins) -> None:
        shape = tuple(len(values) for values in over.values())
        self.over = over
        """The values along each axis."""
        self.labels: NDArray[np.int32] = found.labels.reshape(shape[::-1]).T
        """The attractor of each start."""
        self.times: Floats = found.times.reshape(shape[::-1]).T
        """When it was known, in s."""
        self.scenario: Scenario = Scenario.parse(found.scenario)
        """The run of each start."""
        names = self.scenario.state
        self.attractors: tuple[Attractor, ...] = tuple(
            Attractor(dict(zip(names, state, strict=False)), kind, energy)
            for state, kind, energy in found.attractors
        )
        """The attractors by number."""
        self.summary: tuple[str, ...] = tuple(found.summary)
        """Shares of the basins, undecided starts, basin entropy, uncertainty exponent, in words."""
        self._figure = found.figure

    @property
    def undecided(self) -> float:
        """The share of the starts that nothing is proved of."""
        return float((self.labels == -1).mean())

    def plot(self) -> Figure:
        """Draw the map with matplotlib."""
        from ._figure import draw

        return draw(self._figure)

    def to_xarray(self) -> xr.Dataset:
        """Give a dataset with `label` and `time`, and a dimension for each axis."""
        try:
            import xarray as xr
        except ImportError:
            raise extra("xarray", "xarray") from None
        dims = list(self.over)
        data = {"label": (dims, self.labels.copy()), "time": (dims, self.times.copy(), {"units": "s"})}
        attrs: dict[str, Any] = {"scenario": self.scenario.toml, "summary": "\n".join(self.summary)}
        return xr.Dataset(data, coords=self.over, attrs=attrs)

    def __repr__(self) -> str:
        return (
            f"<precess.Basins of {self.scenario.system.id}: {len(self.attractors)} attractors, "
            f"{100 * self.undecided:.2g} % undecided>"
        )

    def _repr_html_(self) -> str:
        lines = "".join(f"<li>{html.escape(line)}</li>" for line in self.summary)
        return f"<b>Basins of attraction</b> <code>{self.scenario.system.id}</code><ul>{lines}</ul>"


class Grid(NamedTuple):
    """The starts of a grid, and any part of them: what a worker anywhere is given."""

    scenario: Scenario
    axes: list[tuple[str, float, float, int]]
    """Name, first value, last value, number of values; the first axis runs fastest."""
    once: bool
    """Each start is followed once."""

    @property
    def size(self) -> int:
        """How many starts there are."""
        return math.prod(points for *_, points in self.axes)

    def identity(self) -> list[object]:
        """Give what tells these starts from any others."""
        axes = [[name, low.hex(), high.hex(), points] for name, low, high, points in self.axes]
        return ["basins", self.scenario.toml, axes, self.once]

    def part(self, first: int, last: int) -> tuple[Grid, int, int]:
        """Give what a worker needs: all of it, since the attractors are those of the whole grid."""
        return self, first, last

    def run(self, first: int, last: int, threads: int | None = None, told: Told | None = None) -> Members:
        """Follow the starts from one number to another."""
        plan = self.scenario._plan  # noqa: SLF001
        rows = _core.basins_part(plan, (self.axes, False, self.once), first, last, threads, told)
        return Members(np.zeros(1), rows, {})


@knows_its_keywords
def basins(
    system: str | Path | System | Scenario,
    over: Mapping[str, tuple[float, float, int]],
    *,
    wrap: bool = False,
    once: bool = False,
    threads: int | None = None,
    client: Submits | None = None,
    tile: int = TILE,
    store: str | Path | None = None,
    progress: Progress = None,
    **settings: Unpack[Settings],
) -> Basins:
    """Find where each start of a grid ends, and prove it: what is not proved is undecided.

    Parameters
    ----------
    over
        Numbers of the start: `{"x": (-2, 2, 200), "y": (-2, 2, 200)}`, first value, last value, how many.
    wrap
        Attractors that differ by whole turns are one.
    once
        Each start is followed once: faster, but nothing tells labels that are right from those that another
        tolerance would change.
    threads
        How many; as many as there are cores where absent. Nothing here changes a bit of the result.
    client
        A Dask client, or any `concurrent.futures.Executor`: the starts are followed there, in tiles, by one thread each
        where `threads` is absent. The bits are those of one machine.
    tile
        The number of starts that go to a worker at a time. Each tile begins with looking for the attractors.
    store
        A folder (Zarr) that keeps the tiles; work that was stopped resumes there.

    Raises
    ------
    InputError
        Where something makes no sense, the system has events, or nothing can attract.

    """
    scenario = Scenario.of(system).replace(**settings)
    if not isinstance(over, Mapping):
        raise TypeError(
            f"over is a dictionary from names to (first, last, number), not {type(over).__name__}"
        )
    axes: list[tuple[str, float, float, int]] = []
    for name, span in over.items():
        low, high, points = several(text("over", name), SPAN, span, 3)
        axes.append((name, number(name, low), number(name, high), count(f"{name}, how many", points)))
    if threads is not None:
        count("threads", threads)
    grid = Grid(scenario, axes, once)
    with bar(progress, 1.0, "") as told:
        if client is None and store is None:
            found = _core.basins(scenario._plan, (axes, wrap, once), threads, told)  # noqa: SLF001
        else:
            share = None if told is None else lambda members: told(members / grid.size)
            rows = done(grid, client=client, tile=tile, store=store, threads=threads, told=share).numbers
            found = _core.basins_whole(scenario._plan, (axes, wrap, once), rows, threads)  # noqa: SLF001
    return Basins({name: np.linspace(low, high, points) for name, low, high, points in axes}, found)
