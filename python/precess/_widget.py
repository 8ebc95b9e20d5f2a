"""A run as a moving picture in a notebook, which updates in place."""

from __future__ import annotations

import fnmatch
from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

import anywidget
import numpy as np
import traitlets

from . import _core
from ._names import nearest
from ._places import places
from ._simulate import run as simulated

if TYPE_CHECKING:
    from typing_extensions import Unpack

    from ._core import Floats
    from ._scenario import Scenario, Settings
    from ._trajectory import Trajectory

    Sliders = Mapping[str, tuple[float, float]]

HERE = Path(__file__).parent
# More samples than this a screen cannot show.
MOST = 5000
# A picture has room for so many graphs.
GRAPHS = 2
# A run that is not about as long as this is played slower or faster, in s.
SHORT, LONG, PLAYED = 4.0, 40.0, 12.0


class Scene(anywidget.AnyWidget):
    """A run as a moving picture; see `precess.scene`."""

    _esm = HERE / "_scene.js"
    _css = HERE / "_scene.css"
    run: Any = traitlets.Dict().tag(sync=True)
    """What is drawn: the numbers of the run, and what they mean."""
    sliders: Any = traitlets.List().tag(sync=True)
    """Name, low, high, value and unit of each."""
    wish: Any = traitlets.Dict().tag(sync=True)
    """The values at which a person has put the sliders."""
    problem = traitlets.Unicode("").tag(sync=True)
    """Why the last run could not be made."""
    playing = traitlets.Bool(default_value=True).tag(sync=True)
    """Whether it moves."""
    speed = traitlets.Float(1.0).tag(sync=True)
    """Seconds of the run that pass in a second."""

    def __init__(self, trajectory: Trajectory, sliders: Sliders | None = None) -> None:
        self.trajectory = trajectory
        """The run that is shown."""
        length = abs(float(trajectory.t[-1] - trajectory.t[0]))
        speed = 1.0 if SHORT <= length <= LONG or length == 0 else length / PLAYED
        super().__init__(
            run=shown(trajectory), sliders=offered(trajectory.scenario, sliders or {}), speed=speed
        )
        self.observe(self._wished, names="wish")

    @property
    def scenario(self) -> Scenario:
        """The scenario of the run that is shown."""
        return self.trajectory.scenario

    def update(self, **settings: Unpack[Settings]) -> None:
        """Run it again with something changed, and show that in the same place.

        Where that makes no sense, or the run fails, the picture stays and an exception says why.
        """
        trajectory = simulated(self.scenario.replace(**settings))
        values = trajectory.scenario.parameters | trajectory.scenario.start
        with self.hold_sync():
            self._show(trajectory)
            self.wish = {}
            self.sliders = [slider | {"value": values[slider["name"]]} for slider in self.sliders]

    def _show(self, trajectory: Trajectory) -> None:
        self.trajectory = trajectory
        self.problem = ""
        self.run = shown(trajectory)

    def _wished(self, change: dict[str, Any]) -> None:
        """Follow the sliders; a person who moves one wants a sentence, not an exception."""
        known = {slider["name"] for slider in self.sliders}
        values = {name: value for name, value in change["new"].items() if name in known}
        if not values:
            return
        parameters, start = _parted(self.scenario, values)
        try:
            trajectory = simulated(self.scenario.replace(parameters=parameters, start=start))
        except (ValueError, RuntimeError) as error:
            self.problem = str(error)
        else:
            with self.hold_sync():
                self._show(trajectory)


def _parted(scenario: Scenario, values: Mapping[str, float]) -> tuple[dict[str, float], dict[str, float]]:
    """Give parameters and numbers of the start."""
    known = scenario.parameters
    return (
        {name: value for name, value in values.items() if name in known},
        {name: value for name, value in values.items() if name not in known},
    )


def offered(scenario: Scenario, sliders: Sliders) -> list[dict[str, Any]]:
    """Give the sliders as the page takes them."""
    if not isinstance(sliders, Mapping):
        raise TypeError(f"sliders is a dictionary from names to (low, high), not {type(sliders).__name__}")
    numbers = {name: x for name, x in scenario.parameters.items() if isinstance(x, float)} | scenario.start
    units = {q.name: q.unit for q in scenario.system.parameters}
    units |= {name: unit for name, _, unit, _ in scenario._plan.columns}  # noqa: SLF001
    found = []
    for name, ends in sliders.items():
        if name not in numbers:
            what = f"start or numeric parameter of {scenario.system.id}"
            raise _core.InputError(nearest(what, str(name), numbers))
        try:
            low, high = (float(end) for end in ends)
        except (TypeError, ValueError):
            raise TypeError(f"sliders {name}: a lowest and a highest number are needed") from None
        if not (np.isfinite([low, high]).all() and low < high):
            raise _core.InputError(f"sliders {name}: {low:g} is not below {high:g}")
        found.append(
            {"name": name, "low": low, "high": high, "value": numbers[name], "unit": units.get(name, "")}
        )
    return found


def shown(trajectory: Trajectory) -> dict[str, Any]:
    """Give a run as the page takes it."""
    stride = -(-len(trajectory) // MOST)
    columns: dict[str, Floats] = {c.name: trajectory[c.name] for c in trajectory.columns}
    scene = None
    there = places(trajectory)
    if there is not None:
        bodies = []
        for k, place in enumerate(there.bodies):
            names = [f"place{k}_{axis}" for axis in "xyz"[: len(place)]]
            columns |= dict(zip(names, place, strict=True))
            bodies.append(names)
        order = list(columns)
        scene = {
            "bodies": [[order.index(name) for name in names] for names in bodies],
            "rods": there.rods,
            "marks": there.marks,
            "sphere": there.sphere,
        }
    numbers = np.stack([column[::stride] for column in columns.values()])
    # A page cannot draw what is no number, and JSON has no word for it: the bytes do.
    return {
        "title": trajectory.scenario.title,
        "columns": list(columns),
        "samples": numbers.shape[1],
        "time": 0,
        "length": abs(float(trajectory.t[-1] - trajectory.t[0])) or 1.0,
        "numbers": np.ascontiguousarray(numbers, dtype="<f8").tobytes(),
        "scene": scene,
        "graphs": _graphs(trajectory, list(columns), whether=scene is not None),
    }


def _graphs(trajectory: Trajectory, names: list[str], *, whether: bool) -> list[dict[str, Any]]:
    """Give the views of the card as graphs; paths in the plane only where no scene shows them."""
    units = {column.name: column.unit for column in trajectory.columns}

    def label(pair: list[str]) -> str:
        unit = units.get(pair[0], "")
        text = ", ".join(dict.fromkeys(pair))
        return f"{text} [{unit}]" if unit else text

    found = []
    for view in trajectory.scenario.system._card["views"]:  # noqa: SLF001
        if view["equal_scales"] and whether:
            continue
        # `xg*` stands for the column of every body.
        ys = [name for _, y in view["pairs"] for name in fnmatch.filter(names, y)]
        x = next(iter(fnmatch.filter(names, view["pairs"][0][0])), None)
        if x is None or not ys:
            continue
        found.append(
            {
                "x": names.index(x),
                "y": [names.index(y) for y in ys],
                "x_label": label([x]),
                "y_label": label(ys),
            }
        )
    if not found:
        invariants = [c.name for c in trajectory.columns if c.kind == "invariant"] or [
            trajectory.columns[1].name
        ]
        y = invariants[0]
        found = [{"x": 0, "y": [names.index(y)], "x_label": "t [s]", "y_label": label([y])}]
    return found[:GRAPHS]
