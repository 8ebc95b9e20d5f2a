"""Pictures of a trajectory."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from . import _core
from ._figure import draw
from ._names import extra, nearest

if TYPE_CHECKING:
    from collections.abc import Sequence

    from matplotlib.figure import Figure

    from ._trajectory import Trajectory

KINDS = ["invariants", "axis", "contact"]
AXIS = ("axis_x", "axis_y", "axis_z")
CONTACT = ("contact_x", "contact_y")


def plot(trajectory: Trajectory, names: Sequence[str], x: str, kind: str | None) -> Figure:
    """Draw what is asked for."""
    scenario = trajectory.scenario
    whole = _core.picture(scenario._plan, np.ascontiguousarray(trajectory.numbers))  # noqa: SLF001
    if kind is not None and kind not in KINDS:
        raise _core.InputError(nearest("kind of picture", str(kind), KINDS))
    if kind == "axis":
        return _sphere(trajectory)
    if kind == "contact":
        _needs(trajectory, CONTACT, "contact point")
        whole["panels"] = [_panel(trajectory, CONTACT[0], CONTACT[1:], equal_scales=True)]
    elif kind == "invariants":
        if not trajectory.drifts:
            raise _core.InputError(f"{scenario.system.id} has no invariants with these parameters")
        # The last panel of the whole picture.
        whole["panels"] = whole["panels"][-1:]
    elif names:
        whole["panels"] = [_panel(trajectory, x, names, equal_scales=False)]
    return draw(whole)


def _panel(trajectory: Trajectory, x: str, names: Sequence[str], *, equal_scales: bool) -> dict[str, Any]:
    curves = [
        (name if len(names) > 1 else "", trajectory[x], trajectory[name], None, "line") for name in names
    ]
    return {
        "title": "",
        "x_label": _label(trajectory, x),
        "y_label": _label(trajectory, names[0]) if len(names) == 1 else "",
        "equal_scales": equal_scales,
        "logarithmic": False,
        "curves": curves,
        "marks": [],
        "map": None,
        "x_range": None,
        "y_range": None,
    }


def _label(trajectory: Trajectory, name: str) -> str:
    unit = next((column.unit for column in trajectory.columns if column.name == name), "")
    return f"{name} [{unit}]" if unit else name


def _needs(trajectory: Trajectory, names: Sequence[str], what: str) -> None:
    known = {column.name for column in trajectory.columns}
    if not known.issuperset(names):
        raise _core.InputError(
            f"{trajectory.scenario.system.id} has no {what}: that takes {', '.join(names)}"
        )


def _sphere(trajectory: Trajectory) -> Figure:
    _needs(trajectory, AXIS, "axis to follow")
    try:
        import matplotlib.pyplot as plt
    except ImportError:
        raise extra("matplotlib", "plot") from None
    figure = plt.figure(figsize=(6, 6), layout="constrained")
    axes = figure.add_subplot(projection="3d")
    turn, height = np.meshgrid(np.linspace(0, 2 * np.pi, 25), np.linspace(0, np.pi, 13))
    sphere = (np.cos(turn) * np.sin(height), np.sin(turn) * np.sin(height), np.cos(height))
    axes.plot_wireframe(*sphere, color="0.85", lw=0.4)
    path = [trajectory[name] for name in AXIS]
    axes.plot(*path, lw=1)
    axes.scatter(*[[along[0]] for along in path], s=20, label="start")
    axes.set_box_aspect((1, 1, 1))
    axes.set(xlabel="x", ylabel="y", zlabel="z", title=trajectory.scenario.title)
    axes.legend()
    return figure
