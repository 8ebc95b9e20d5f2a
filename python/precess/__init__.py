"""Precess: a laboratory of classical mechanics.

>>> import precess
>>> swing = precess.simulate("pendulum", start={"theta": "30 deg"}, until=10, every=0.1)
>>> swing["theta"][-1]  # doctest: +SKIP

`precess.systems`, `precess.methods` and `precess.scenarios` list what there is; `precess.simulate` runs one start,
`precess.ensemble` many; `precess.basins`, `portrait`, `response`,
`lyapunov`, `sensitivity`, `fit` and others ask further. A run gives the same bits here as on the command line and in the browser.
"""

from ._analyses import (
    Sensitivity,
    bifurcation,
    floquet,
    frenet,
    lyapunov,
    poincare,
    portrait,
    response,
    sensitivity,
    trust,
)
from ._basins import Attractor, Basins, basins
from ._catalogue import Method, Quantity, System, UnknownNameError, methods, scenarios, systems
from ._core import InputError, RunError
from ._core import version as _version
from ._ensemble import Ensemble, ensemble
from ._exponents import Exponents, lyapunov_sweep
from ._fit import Fit, fit
from ._scenario import Scenario
from ._scene import scene
from ._simulate import simulate
from ._sympy import to_sympy
from ._table import Answer
from ._trajectory import Column, Drift, Event, Trajectory

__version__ = _version()

__all__ = [
    "Answer",
    "Attractor",
    "Basins",
    "Column",
    "Drift",
    "Ensemble",
    "Event",
    "Exponents",
    "Fit",
    "InputError",
    "Method",
    "Quantity",
    "RunError",
    "Scenario",
    "Sensitivity",
    "System",
    "Trajectory",
    "UnknownNameError",
    "basins",
    "bifurcation",
    "ensemble",
    "fit",
    "floquet",
    "frenet",
    "lyapunov",
    "lyapunov_sweep",
    "methods",
    "poincare",
    "portrait",
    "response",
    "scenarios",
    "scene",
    "sensitivity",
    "simulate",
    "systems",
    "to_sympy",
    "trust",
]
