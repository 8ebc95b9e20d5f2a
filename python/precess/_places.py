"""Where things are in a run: what a moving picture shows. Geometry of columns, no mechanics."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

if TYPE_CHECKING:
    from ._core import Floats
    from ._trajectory import Trajectory

    Place = tuple[Floats, ...]


class Places(NamedTuple):
    """Bodies with their places in the plane or in space at every sample, and what is drawn about them."""

    bodies: list[Place]
    rods: list[tuple[int, int]]
    """Pairs of bodies that are joined; -1 is the origin."""
    marks: list[tuple[float, float]]
    """Places that do not move."""
    sphere: float
    """The radius of a sphere about the origin on which a body moves, zero for none."""


def places(run: Trajectory) -> Places | None:
    """Tell where the bodies of a run are, if it has any places: by the first rule that fits its columns."""
    names = {column.name for column in run.columns}
    return next((found for rule in RULES if (found := rule(run, names)) is not None), None)


def _columns(run: Trajectory, *names: str) -> Place:
    return tuple(run[name] for name in names)


def _top(run: Trajectory, names: set[str]) -> Places | None:
    """Give the axis of a body on the sphere."""
    if names >= {"axis_x", "axis_y", "axis_z"}:
        return Places([_columns(run, "axis_x", "axis_y", "axis_z")], [(-1, 0)], [], 1.0)
    if names >= {"qw", "qx", "qy", "qz"}:
        w, x, y, z = _columns(run, "qw", "qx", "qy", "qz")
        axis = (2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y))
        return Places([axis], [(-1, 0)], [], 1.0)
    return None


def _space(run: Trajectory, names: set[str]) -> Places | None:
    """Give a point in space; one on a rod hangs from the origin."""
    if not names >= {"x", "y", "z"}:
        return None
    rods = [(-1, 0)] if "l" in run.scenario.parameters else []
    return Places([_columns(run, "x", "y", "z")], rods, [], 0.0)


def _swinging(run: Trajectory, names: set[str]) -> Places | None:
    """Give a pendulum whose pivot may move."""
    if not names >= {"px", "py"}:
        return None
    bob = _columns(run, "px", "py")
    if names >= {"x_pivot", "y_pivot"}:
        return Places([bob, _columns(run, "x_pivot", "y_pivot")], [(1, 0)], [], 0.0)
    if "pivot" in names:
        return Places([bob, (np.zeros(len(run)), run["pivot"])], [(1, 0)], [], 0.0)
    return Places([bob], [(-1, 0)], [], 0.0)


def _chain(run: Trajectory, _: set[str]) -> Places | None:
    """Give rods that hang from one another."""
    parameters = run.scenario.parameters
    angles = [name for name in run.scenario.state if name.startswith("theta") and name[5:].isdigit()]
    lengths = parameters.get("lengths") or [parameters.get(f"l{k}") for k in range(1, len(angles) + 1)]
    if not angles or len(lengths) != len(angles) or None in lengths:
        return None
    x, y = np.zeros(len(run)), np.zeros(len(run))
    bodies: list[Place] = []
    for angle, length in zip(angles, lengths, strict=True):
        x, y = x + length * np.sin(run[angle]), y - length * np.cos(run[angle])
        bodies.append((x, y))
    return Places(bodies, [(k - 1, k) for k in range(len(bodies))], [], 0.0)


def _pendulum(run: Trajectory, names: set[str]) -> Places | None:
    """Give a bob on a rod."""
    if "theta" not in run.scenario.state or names & {"psi", "phi"}:
        return None
    length = run.scenario.parameters.get("l", 1.0)
    return Places([(length * np.sin(run["theta"]), -length * np.cos(run["theta"]))], [(-1, 0)], [], 0.0)


def _many(run: Trajectory, names: set[str]) -> Places | None:
    """Give numbered bodies in the plane, about their centre of mass where they are known there."""
    for x, y in (("xg", "yg"), ("x", "y")):
        numbers = sorted(int(name[len(x) :]) for name in names if re.fullmatch(rf"{x}\d+", name))
        if numbers and names >= {f"{y}{k}" for k in numbers}:
            return Places([_columns(run, f"{x}{k}", f"{y}{k}") for k in numbers], [], [], 0.0)
    return None


def _plane(run: Trajectory, names: set[str]) -> Places | None:
    """Give a point in the plane, and what stands about it."""
    for pair in (("x", "y"), ("contact_x", "contact_y")):
        if names >= set(pair):
            marks = [(x, y) for x, y, *_ in run.scenario.parameters.get("magnets", [])]
            return Places([_columns(run, *pair)], [], marks, 0.0)
    return None


RULES = (_top, _space, _swinging, _chain, _pendulum, _many, _plane)
