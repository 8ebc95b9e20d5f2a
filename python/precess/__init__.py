"""Precess: a laboratory of classical mechanics.

>>> import precess
>>> swing = precess.simulate("pendulum", start={"theta": "30 deg"}, until=10, every=0.1)
>>> swing["theta"][-1]  # doctest: +SKIP

`precess.systems`, `precess.methods` and `precess.scenarios` list what there is; `precess.simulate` runs one start,
`precess.ensemble` many. A run gives the same bits here as on the command line and in the browser.
"""

from ._catalogue import Method, Quantity, System, UnknownNameError, methods, scenarios, systems
from ._core import InputError, RunError
from ._core import version as _version
from ._ensemble import Ensemble, ensemble
from ._scenario import Scenario
from ._simulate import simulate
from ._trajectory import Column, Drift, Event, Trajectory

__version__ = _version()

__all__ = [
    "Column",
    "Drift",
    "Ensemble",
    "Event",
    "InputError",
    "Method",
    "Quantity",
    "RunError",
    "Scenario",
    "System",
    "Trajectory",
    "UnknownNameError",
    "ensemble",
    "methods",
    "scenarios",
    "simulate",
    "systems",
]
