"""Pictures of a trajectory, drawn by matplotlib."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from . import _core
from ._names import extra, nearest
from ._trajectory import departures

if TYPE_CHECKING:
    from collections.abc import Sequence

    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from ._trajectory import Trajectory

KINDS = ["invariants", "axis", "contact"]
AXIS = ("axis_x", "axis_y", "axis_z")
CONTACT = ("contact_x", "contact_y")
# Below this a drift is drawn as this: a logarithm has no zero.
LEAST = 1e-17


def plot(trajectory: Trajectory, names: Sequence[str], x: str, kind: str | None) -> Figure:
    """Draw what is asked for."""
    try:
        import matplotlib.pyplot as plt
    except ImportError:
        raise extra("matplotlib", "plot") from None
    if kind is not None:
        if kind not in KINDS:
            raise _core.InputError(nearest("kind of picture", kind, KINDS))
        return {"invariants": _invariants, "axis": _sphere, "contact": _contact}[kind](trajectory, plt)
    if names:
        figure, axes = plt.subplots(figsize=(7, 4), layout="constrained")
        _curves(axes, trajectory, [(x, name) for name in names], equal=False)
    else:
        views = trajectory.scenario.system.views
        known = {column.name for column in trajectory.columns}
        views = [view for view in views if all(a in known and b in known for a, b in view["pairs"])]
        panels = len(views) + bool(trajectory.drifts)
        figure, grid = plt.subplots(
            1, max(panels, 1), figsize=(4.5 * max(panels, 1), 4), squeeze=False, layout="constrained"
        )
        for axes, view in zip(grid[0], views, strict=False):
            _curves(axes, trajectory, view["pairs"], equal=view["equal_scales"])
        if trajectory.drifts:
            _drift(grid[0][-1], trajectory)
    figure.suptitle(_title(trajectory))
    return figure


def _title(trajectory: Trajectory) -> str:
    scenario = trajectory.scenario
    return (
        f"{scenario.title} ({scenario.method}, {', '.join(f'{k} = {v:g}' for k, v in scenario.step.items())})"
    )


def _label(trajectory: Trajectory, name: str) -> str:
    for known, symbol, unit, _ in trajectory.scenario._plan.columns:  # noqa: SLF001
        if known == name:
            # matplotlib's own LaTeX knows no \mathrm with a thin space, nor all of LaTeX: names of several letters stay.
            letters = f"${symbol}$" if "mathrm" not in symbol else name
            return f"{letters} [{unit}]" if unit else letters
    return name


def _curves(axes: Axes, trajectory: Trajectory, pairs: Sequence[Sequence[str]], *, equal: bool) -> None:
    for a, b in pairs:
        axes.plot(trajectory[a], trajectory[b], lw=1, label=_label(trajectory, b))
    horizontal = {a for a, _ in pairs}
    axes.set_xlabel(_label(trajectory, horizontal.pop()) if len(horizontal) == 1 else "")
    if len(pairs) == 1:
        axes.set_ylabel(_label(trajectory, pairs[0][1]))
    else:
        axes.legend(loc="upper right", fontsize="small")
    if equal:
        axes.set_aspect("equal", adjustable="datalim")
    axes.grid(visible=True, alpha=0.3)


def _drift(axes: Axes, trajectory: Trajectory) -> None:
    for drift in trajectory.drifts:
        distance = np.maximum(departures(trajectory[drift.name]), LEAST)
        axes.semilogy(trajectory.t, distance, lw=1, label=drift.name)
    axes.set_xlabel(_label(trajectory, "t"))
    axes.set_ylabel("drift of the invariants (relative)")
    axes.legend(loc="lower right", fontsize="small")
    axes.grid(visible=True, alpha=0.3)


def _invariants(trajectory: Trajectory, plt: Any) -> Figure:
    if not trajectory.drifts:
        raise _core.InputError(f"{trajectory.scenario.system.id} has no invariants with these parameters")
    figure, axes = plt.subplots(figsize=(7, 4), layout="constrained")
    _drift(axes, trajectory)
    figure.suptitle(_title(trajectory))
    drawn: Figure = figure
    return drawn


def _needs(trajectory: Trajectory, names: Sequence[str], what: str) -> None:
    known = {column.name for column in trajectory.columns}
    if not known.issuperset(names):
        raise _core.InputError(
            f"{trajectory.scenario.system.id} has no {what}: that takes {', '.join(names)}"
        )


def _sphere(trajectory: Trajectory, plt: Any) -> Figure:
    _needs(trajectory, AXIS, "axis to follow")
    figure = plt.figure(figsize=(6, 6), layout="constrained")
    axes = figure.add_subplot(projection="3d")
    turn, height = np.meshgrid(np.linspace(0, 2 * np.pi, 25), np.linspace(0, np.pi, 13))
    axes.plot_wireframe(
        np.cos(turn) * np.sin(height), np.sin(turn) * np.sin(height), np.cos(height), color="0.85", lw=0.4
    )
    path = [trajectory[name] for name in AXIS]
    axes.plot(*path, lw=1)
    axes.scatter(*[[along[0]] for along in path], s=20, label="start")
    axes.set_box_aspect((1, 1, 1))
    axes.set(xlabel="x", ylabel="y", zlabel="z", title=_title(trajectory))
    axes.legend()
    drawn: Figure = figure
    return drawn


def _contact(trajectory: Trajectory, plt: Any) -> Figure:
    _needs(trajectory, CONTACT, "contact point")
    figure, axes = plt.subplots(figsize=(5, 5), layout="constrained")
    _curves(axes, trajectory, [CONTACT], equal=True)
    axes.plot(*[trajectory[name][:1] for name in CONTACT], "o", ms=4)
    figure.suptitle(_title(trajectory))
    drawn: Figure = figure
    return drawn
