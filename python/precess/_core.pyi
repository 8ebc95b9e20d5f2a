"""The extension module: what it says is in crates/python."""

from collections.abc import Callable
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray
from typing_extensions import Self

Floats: TypeAlias = NDArray[np.float64]

class InputError(ValueError):
    """What was asked for makes no sense: what, where, the nearest right thing."""

class RunError(RuntimeError):
    """A run ended before its time: what happened, when, what to try."""

    trajectory: Any

def version() -> str: ...
def system_ids() -> list[str]: ...
def system_card(id: str) -> str: ...  # noqa: A002
def system_equations(id: str) -> list[tuple[str, str]]: ...  # noqa: A002
def method_cards() -> str: ...
def scenario_texts() -> list[tuple[str, str]]: ...
def unknown(what: str, name: str, names: list[str]) -> str: ...
def hash(numbers: Floats) -> str: ...  # noqa: A001
def rate(plan: Plan, t: float, y: Floats) -> Floats: ...
def jacobian(plan: Plan, t: float, y: Floats) -> Floats: ...
def expressions(plan: Plan) -> tuple[list[str], list[tuple[str, list[int], float]], list[int]]: ...
def picture(plan: Plan, numbers: Floats) -> dict[str, Any]: ...
def lyapunov(plan: Plan, progress: Callable[[float], object] | None = None) -> Answer: ...
def trust(plan: Plan, within: float, progress: Callable[[float], object] | None = None) -> Answer: ...
def poincare(
    plan: Plan,
    section: str,
    direction: str | None = None,
    x: str | None = None,
    y: str | None = None,
    progress: Callable[[float], object] | None = None,
) -> Answer: ...
def portrait(
    plan: Plan,
    windows: list[str],
    levels: int | None = None,
    progress: Callable[[float], object] | None = None,
) -> Answer: ...
def response(
    plan: Plan,
    sweep: str,
    coordinate: str | None = None,
    down: bool = False,
    progress: Callable[[float], object] | None = None,
) -> Answer: ...
def bifurcation(
    plan: Plan,
    sweep: str,
    coordinate: str | None = None,
    down: bool = False,
    progress: Callable[[float], object] | None = None,
) -> Answer: ...
def floquet(plan: Plan, sweeps: list[str], progress: Callable[[float], object] | None = None) -> Answer: ...
def floquet_points(sweeps: list[str]) -> int: ...
def floquet_part(
    plan: Plan,
    sweeps: list[str],
    first: int,
    last: int,
    progress: Callable[[float], object] | None = None,
) -> Floats: ...
def floquet_whole(plan: Plan, sweeps: list[str], moduli: Floats) -> Answer: ...
def frenet(
    plan: Plan, x: str | None = None, y: str | None = None, progress: Callable[[float], object] | None = None
) -> Answer: ...
def basins(
    plan: Plan,
    spec: tuple[list[tuple[str, float, float, int]], bool, bool],
    threads: int | None = None,
    progress: Callable[[float], object] | None = None,
) -> Basins: ...
def basins_part(
    plan: Plan,
    spec: tuple[list[tuple[str, float, float, int]], bool, bool],
    first: int,
    last: int,
    threads: int | None = None,
    progress: Callable[[float], object] | None = None,
) -> Floats: ...
def basins_whole(
    plan: Plan,
    spec: tuple[list[tuple[str, float, float, int]], bool, bool],
    rows: Floats,
    threads: int | None = None,
    progress: Callable[[float], object] | None = None,
) -> Basins: ...
def sensitivities(
    plan: Plan, names: list[str], times: Floats, progress: Callable[[float], object] | None = None
) -> tuple[Floats, Floats]: ...
def fit(
    plan: Plan,
    times: Floats,
    columns: list[tuple[str, Floats]],
    uncertainties: list[float],
    free: list[str],
    progress: Callable[[float], object] | None = None,
) -> Fit: ...

class Answer:
    """What comes out of an analysis."""

    numbers: Floats
    columns: list[tuple[str, str]]
    figure: dict[str, Any]
    summary: list[str]
    failure: str | None

class Basins:
    """Where the starts of a grid end."""

    labels: NDArray[np.int32]
    times: Floats
    attractors: list[tuple[list[float], str, float | None]]
    scenario: str
    figure: dict[str, Any]
    summary: list[str]

class Fit:
    """A fit."""

    fitted: list[tuple[str, str, float, float, tuple[float, float]]]
    correlation: list[list[float]]
    scatter: list[float]
    chi2: float
    freedom: int
    model: list[Floats]
    scenario: str
    answer: Answer

class Plan:
    """A run that is fully determined."""

    system: str
    title: str
    method: str
    until: float
    every: float
    step: list[tuple[str, float]]
    parameters: dict[str, object]
    state: list[str]
    start: list[tuple[str, float]]
    columns: list[tuple[str, str, str, str]]

    def __new__(
        cls,
        system: str,
        parameters: dict[str, object],
        start: dict[str, object],
        method: str | None,
        run: dict[str, object],
        events: list[tuple[str | None, str, str | None, bool]],
        title: str,
    ) -> Self: ...
    @staticmethod
    def parse(text: str) -> Plan: ...
    def changed(
        self,
        parameters: dict[str, object],
        start: dict[str, object],
        method: str | None,
        run: dict[str, object],
    ) -> Plan: ...
    def toml(self) -> str: ...
    def run(self, progress: Callable[[float], object] | None = None) -> Outcome: ...
    def ensemble(
        self,
        names: list[str],
        values: Floats,
        samples: bool,
        threads: int | None = None,
        progress: Callable[[float], object] | None = None,
    ) -> Members: ...

class Outcome:
    """What came out of a run."""

    numbers: Floats
    columns: list[tuple[str, str, str]]
    events: list[tuple[str, float, list[float]]]
    drifts: list[tuple[str, str, float, float, float | None]]
    scenario: tuple[str, str]
    counts: tuple[int, int, int]
    stopped_by: str | None
    failure: str | None

class Members:
    """What came out of an ensemble."""

    times: Floats
    numbers: Floats
    failures: list[tuple[int, str]]
