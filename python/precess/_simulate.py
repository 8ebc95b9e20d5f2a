"""One start to a trajectory."""

from __future__ import annotations

from typing import TYPE_CHECKING

from . import _core
from ._names import knows_its_keywords
from ._progress import bar
from ._scenario import Scenario
from ._trajectory import Trajectory

if TYPE_CHECKING:
    from pathlib import Path

    from ._catalogue import System
    from ._progress import Progress
    from ._scenario import Events, Values


@knows_its_keywords
def simulate(
    system: str | Path | System | Scenario,
    *,
    parameters: Values | None = None,
    start: Values | None = None,
    method: str | None = None,
    until: float | str | None = None,
    every: float | str | None = None,
    dt: float | str | None = None,
    rtol: float | str | None = None,
    atol: float | str | None = None,
    options: Values | None = None,
    events: Events = (),
    progress: Progress = None,
) -> Trajectory:
    """Run a system, a scenario, or a scenario file.

    The settings are those of `precess.Scenario`; what is given here changes a scenario. Other threads of Python go on
    meanwhile, and Ctrl-C ends the run.

    Parameters
    ----------
    progress
        True for a progress bar (tqdm), or a function that is told the time now and then.

    Returns
    -------
    Trajectory
        The samples as NumPy arrays, with units, events, the drift of the invariants and their provenance. They have
        the bits, and `hash()` gives the hash, of the same run on the command line.

    Raises
    ------
    InputError
        Where something makes no sense (a `ValueError`): the sentence says what, where, and the nearest right thing.
    RunError
        Where the run ends before its time (a `RuntimeError`): it says when, why, and what to try; its attribute
        `trajectory` has the samples up to then.

    Examples
    --------
    >>> import precess
    >>> swing = precess.simulate("pendulum", start={"theta": 0.1}, until=1, every=0.5)
    >>> swing.t
    array([0. , 0.5, 1. ])

    """
    given = {
        "parameters": parameters,
        "start": start,
        "method": method,
        "until": until,
        "every": every,
        "dt": dt,
        "rtol": rtol,
        "atol": atol,
        "options": options,
    }
    if isinstance(system, Scenario) or str(system).endswith(".toml"):
        scenario = Scenario.of(system).replace(**given)  # type: ignore[arg-type]
        if events:
            raise _core.InputError(
                "a scenario has its own events: write [[event]] there, or give a system's id here"
            )
    else:
        scenario = Scenario(system, events=events, **given)  # type: ignore[arg-type]
    return run(scenario, progress)


def run(scenario: Scenario, progress: Progress = None) -> Trajectory:
    """Run a scenario."""
    with bar(progress, scenario.until, "s") as told:
        outcome = scenario._plan.run(told)  # noqa: SLF001
    trajectory = Trajectory(scenario, outcome)
    if outcome.failure is not None:
        error = _core.RunError(f"{outcome.failure}; the samples up to then are in 'trajectory'")
        error.trajectory = trajectory
        raise error
    return trajectory
