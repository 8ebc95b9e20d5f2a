"""A scenario: what to run, held against the cards."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypedDict

from . import _core
from ._catalogue import System, scenarios, systems
from ._given import array, number, text
from ._names import knows_its_keywords, nearest

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from ._core import Floats
    from ._progress import Progress
    from ._trajectory import Trajectory

    Values = Mapping[str, Any]
    Events = Iterable[str | Mapping[str, Any]]


class Settings(TypedDict, total=False):
    """What may be set of a run; see `Scenario`."""

    parameters: Values | None
    start: Values | None
    method: str | None
    until: float | str | None
    every: float | str | None
    dt: float | str | None
    rtol: float | str | None
    atol: float | str | None
    options: Values | None


class Scenario:
    """What to run: a system with its parameters and start, a method, an end.

    Parameters
    ----------
    system
        The id of a system.
    parameters, start
        What differs from the system's card, by name: numbers in SI units, texts as on the command line
        (`"30 deg"`, `"49*pi/50"`), lists, or arrays.
    method
        The id of a method; the system's own where absent.
    until, every
        The end (s; a negative one runs backwards), and the time between samples.
    dt
        The step of a method with fixed steps, in s.
    rtol, atol
        The tolerances of an adaptive method, 1e-10 where absent.
    options
        The method's own options, by name.
    events
        Crossings to watch: `"theta = 0"`, or a dictionary with `when` and, if wanted, `name`, `direction`
        (`"rising"`, `"falling"`, `"either"`) and `stop` (the run ends there).
    title
        A heading.

    Raises
    ------
    InputError
        Where something makes no sense; the sentence says what, where, and the nearest right thing.

    """

    __slots__ = ("_plan",)
    _plan: _core.Plan

    @knows_its_keywords
    def __init__(
        self,
        system: str | System,
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
        title: str = "",
    ) -> None:
        name = system.id if isinstance(system, System) else system
        if not isinstance(name, str):
            raise TypeError(f"a system is given by its id, not by {type(name).__name__}")
        run = settings(until=until, every=every, dt=dt, rtol=rtol, atol=atol, options=options)
        if method is not None:
            text("method", method)
        text("title", title)
        self._plan = _core.Plan(
            name, table("parameters", parameters), table("start", start), method, run, watched(events), title
        )

    @classmethod
    def of(cls, system: str | Path | System | Scenario) -> Scenario:
        """Make a scenario of a system, of a file (`*.toml`), or of one that comes with the program."""
        if isinstance(system, Scenario):
            return system
        if isinstance(system, Path) or (isinstance(system, str) and system.endswith(".toml")):
            return cls.load(system)
        return cls(system)

    @classmethod
    def parse(cls, toml: str) -> Scenario:
        """Read the text of a scenario file."""
        return cls._of(_core.Plan.parse(text("toml", toml)))

    @classmethod
    def load(cls, path: str | Path) -> Scenario:
        """Read a scenario file, or one of `precess.scenarios` where there is no such file."""
        file = Path(path)
        if not file.exists() and file.name in scenarios:
            return cls.parse(scenarios[file.name])
        try:
            return cls.parse(file.read_text(encoding="utf-8"))
        except _core.InputError as error:
            raise _core.InputError(f"{file}: {error}") from None

    @classmethod
    def _of(cls, plan: _core.Plan) -> Scenario:
        scenario = cls.__new__(cls)
        scenario._plan = plan  # noqa: SLF001
        return scenario

    @knows_its_keywords
    def replace(
        self,
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
    ) -> Scenario:
        """Make the same scenario with something changed. Another method keeps the settings that it understands."""
        run = settings(until=until, every=every, dt=dt, rtol=rtol, atol=atol, options=options)
        if method is not None:
            text("method", method)
        plan = self._plan.changed(table("parameters", parameters), table("start", start), method, run)
        return self._of(plan)

    @property
    def system(self) -> System:
        """The system."""
        return systems[self._plan.system]

    @property
    def title(self) -> str:
        """The heading."""
        return self._plan.title

    @property
    def method(self) -> str:
        """The id of the method."""
        return self._plan.method

    @property
    def until(self) -> float:
        """The end, in s."""
        return self._plan.until

    @property
    def every(self) -> float:
        """The time between samples, in s."""
        return self._plan.every

    @property
    def step(self) -> dict[str, float]:
        """`dt`, or `rtol` and `atol`."""
        return dict(self._plan.step)

    @property
    def parameters(self) -> dict[str, Any]:
        """All parameters."""
        return self._plan.parameters

    @property
    def state(self) -> tuple[str, ...]:
        """Names of the state: coordinates, then velocities."""
        return tuple(self._plan.state)

    @property
    def start(self) -> dict[str, float]:
        """The numbers at the start, by name: the state, and what a system holds behind it."""
        return dict(self._plan.start)

    @property
    def toml(self) -> str:
        """The scenario file with everything spelt out, so that it runs the same for ever."""
        return self._plan.toml()

    def save(self, path: str | Path) -> None:
        """Write the scenario file."""
        Path(path).write_text(self.toml, encoding="utf-8")

    def rhs(self, t: float, y: ArrayLike) -> Floats:
        """Give the rate of a state, as SciPy's `solve_ivp` asks for it: shapes `(numbers,)` and `(numbers,)`.

        `solve_ivp(scenario.rhs, (0, 10), list(scenario.start.values()), jac=scenario.jacobian)` is the same motion.
        A system with events is refused: its rates alone do not tell its motion.
        """
        return _core.rate(self._plan, number("t", t), array("y", y))

    def jacobian(self, t: float, y: ArrayLike) -> Floats:
        """Give the derivatives of the rates (rows) by the state (columns), exact to rounding (dual numbers)."""
        return _core.jacobian(self._plan, number("t", t), array("y", y))

    def simulate(self, *, progress: Progress = None) -> Trajectory:
        """Run it; see `precess.simulate`."""
        from ._simulate import run

        return run(self, progress)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Scenario) and self.toml == other.toml

    def __hash__(self) -> int:
        return hash(self.toml)

    def __reduce__(self) -> tuple[object, tuple[str]]:
        return Scenario.parse, (self.toml,)

    def __repr__(self) -> str:
        return f"<precess.Scenario {self._plan.system} by {self.method} until {self.until} s>"


def table(what: str, given: Values | None) -> dict[str, object]:
    """Give a dictionary from what the user gave as one."""
    if given is None:
        return {}
    if not isinstance(given, Mapping):
        raise TypeError(f"{what} is a dictionary from names to values, not {type(given).__name__}")
    return dict(given)


def settings(*, options: Values | None, **given: object) -> dict[str, object]:
    """Give the settings of a run that are not absent."""
    return {name: value for name, value in given.items() if value is not None} | table("options", options)


def watched(events: Events) -> list[tuple[str | None, str, str | None, bool]]:
    """Give the crossings as the core takes them."""
    keys = ["when", "name", "direction", "stop"]
    found: list[tuple[str | None, str, str | None, bool]] = []
    if isinstance(events, (str, Mapping)):
        events = [events]
    if not isinstance(events, Iterable):
        raise TypeError(f"events: crossings such as 'theta = 0' are needed, not {type(events).__name__}")
    for event in events:
        if not isinstance(event, (str, Mapping)):
            raise TypeError(f"events: a text or a dictionary is needed, not {type(event).__name__}")
        given = {"when": event} if isinstance(event, str) else dict(event)
        for key in given:
            if key not in keys:
                raise _core.InputError(nearest("key of an event", str(key), keys))
        if "when" not in given:
            raise _core.InputError("an event needs a crossing to watch, such as when='theta = 0'")
        for key in ("when", "name", "direction"):
            if given.get(key) is not None:
                text(f"{key} of an event", given[key])
        found.append((given.get("name"), given["when"], given.get("direction"), bool(given.get("stop"))))
    return found
