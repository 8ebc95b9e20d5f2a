"""A run as a moving picture in a notebook."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ._names import extra, knows_its_keywords
from ._scenario import Scenario
from ._simulate import run
from ._trajectory import Trajectory

if TYPE_CHECKING:
    from collections.abc import Mapping
    from pathlib import Path

    from typing_extensions import Unpack

    from ._catalogue import System
    from ._scenario import Settings
    from ._widget import Scene


@knows_its_keywords
def scene(
    system: str | Path | System | Scenario | Trajectory,
    *,
    sliders: Mapping[str, tuple[float, float]] | None = None,
    **settings: Unpack[Settings],
) -> Scene:
    """Show a run as a moving picture in a notebook: the bodies, their trails, and graphs with a cursor.

    The picture updates in place: `shown.update(start={"theta": 2})` runs it again where it stands, and so does moving
    a slider. `shown.trajectory` is the run that is shown. It is a picture of its own, drawn from the columns of the run
    (places of bodies, the axis of a top on the sphere), not the scenes of the lab.

    Parameters
    ----------
    system
        What is run, or a trajectory that is there already. Samples a thirtieth of a second apart look smooth.
    sliders
        Numbers of the start and parameters that a person may move: `{"theta": (-3, 3), "l": (0.2, 2)}`.

    Returns
    -------
    Scene
        A widget (`pip install 'precess[notebook]'`) for Jupyter and whatever else shows an `anywidget`.

    Raises
    ------
    InputError
        Where a setting or a slider makes no sense.
    RunError
        Where the run ends before its time.

    """
    try:
        from ._widget import Scene
    except ImportError as error:
        raise extra(error.name or "anywidget", "notebook") from None
    trajectory = system if isinstance(system, Trajectory) else run(Scenario.of(system).replace(**settings))
    if isinstance(system, Trajectory) and settings:
        trajectory = run(trajectory.scenario.replace(**settings))
    return Scene(trajectory, sliders)
