"""What there is: systems, methods, scenarios, each with all that its card says."""

from __future__ import annotations

import functools
import html
import json
from collections.abc import Callable, Iterable, Iterator, Mapping
from typing import TYPE_CHECKING, Any, Generic, NamedTuple, TypeVar

from . import _core
from ._names import nearest

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from ._core import Floats
    from ._scenario import Scenario

T = TypeVar("T")


class UnknownNameError(_core.InputError, KeyError, AttributeError):
    """There is nothing of this name; the sentence says what comes nearest."""

    def __str__(self) -> str:
        return str(self.args[0])


class Quantity(NamedTuple):
    """A number with a name: a coordinate, a parameter, an observable."""

    name: str
    """As it is typed: `theta_dot`."""
    unit: str
    """SI, empty for a pure number."""
    symbol: str
    """LaTeX."""
    meaning: str
    """In a few words."""
    note: str
    """Default, start, or where it is constant."""


def _quantity(card: dict[str, Any], note: str) -> Quantity:
    return Quantity(card["name"], card["unit"], card["symbol"], card["text"]["en"], note)


class _Card:
    """A card: an id, a title, a few sentences, a source."""

    def __init__(self, card: dict[str, Any]) -> None:
        self._card = card
        self.id: str = card["id"]
        self.title: str = card["title"]["en"]
        self.about: str = card["about"]["en"]
        self.source: str = card["source"]

    def __repr__(self) -> str:
        return f"<precess.{type(self).__name__} {self.id}: {self.title}>"

    def __reduce__(self) -> tuple[object, tuple[str]]:
        return _find, (f"{type(self).__name__.lower()}:{self.id}",)


def _find(what: str) -> _Card:
    kind, _, name = what.partition(":")
    return systems[name] if kind == "system" else methods[name]


class System(_Card):
    """A mechanical system: its names, units, defaults, equations and source.

    Its text (`print(precess.systems.pendulum.__doc__)`, `precess.systems.pendulum?` in a notebook) is its card.
    """

    def __init__(self, card: dict[str, Any]) -> None:
        super().__init__(card)
        self.state: tuple[str, ...] = tuple(card["state"])
        """Names of the state in order: coordinates, then velocities."""
        latex = card["equations"]
        self.latex: tuple[str, ...] = tuple(
            f"{left} = {right}" for left, right in latex["definitions"] + latex["equations"]
        )
        """Definitions and equations in LaTeX, from the very code that is integrated."""
        self.defaults: dict[str, Any] = dict(card["defaults"])
        """Method, end and step where nobody says otherwise."""
        self.__doc__ = self._text()

    @property
    def equations(self) -> tuple[str, ...]:
        """Definitions and equations as text, from the very code that is integrated."""
        return tuple(f"{left} = {right}" for left, right in _core.system_equations(self.id))

    def rhs(self, t: float, y: ArrayLike) -> Floats:
        """Give the rate of a state with the card's parameters; see `Scenario.rhs`."""
        return self._default.rhs(t, y)

    def jacobian(self, t: float, y: ArrayLike) -> Floats:
        """Give the derivatives of the rates by the state with the card's parameters; see `Scenario.jacobian`."""
        return self._default.jacobian(t, y)

    @functools.cached_property
    def _default(self) -> Scenario:
        from ._scenario import Scenario

        return Scenario(self.id)

    @property
    def coordinates(self) -> tuple[Quantity, ...]:
        """The coordinates with their starts; those of second order have a velocity `<name>_dot`."""
        return tuple(_quantity(c, _start(c)) for c in self._card["coordinates"])

    @property
    def parameters(self) -> tuple[Quantity, ...]:
        """The parameters with their defaults."""
        return tuple(_quantity(p, f"default {p['default']}{_choices(p)}") for p in self._card["parameters"])

    @property
    def observables(self) -> tuple[Quantity, ...]:
        """The observables, and where they are invariants."""
        return tuple(_quantity(o, _kind(o)) for o in self._card["observables"])

    @property
    def starts(self) -> tuple[Quantity, ...]:
        """Further names by which a start may be given."""
        return tuple(_quantity(s, "") for s in self._card["starts"])

    @property
    def views(self) -> list[dict[str, Any]]:
        """The pictures that show it best: pairs (horizontal, vertical)."""
        views: list[dict[str, Any]] = self._card["views"]
        return views

    def _text(self) -> str:
        parts = [f"{self.title} (`{self.id}`)", self.about]
        for heading, quantities in [
            ("Coordinates", self.coordinates),
            ("Parameters", self.parameters),
            ("Observables", self.observables),
            ("Starts by other names", self.starts),
        ]:
            lines = [
                f"    {q.name} : {', '.join(filter(None, [q.unit or 'pure number', q.note]))}\n        {q.meaning}"
                for q in quantities
            ]
            if lines:
                parts.append("\n".join([heading, *lines]))
        parts.append("\n".join(["Equations", *(f"    {line}" for line in self.equations)]))
        parts.append(f"Source\n    {self.source}")
        return "\n\n".join(parts)

    def _repr_html_(self) -> str:
        rows = "".join(
            f"<tr><td><code>{q.name}</code></td><td>${q.symbol}$</td><td>{html.escape(q.unit)}</td>"
            f"<td style='text-align:left'>{html.escape(q.meaning)}</td><td>{html.escape(q.note)}</td></tr>"
            for q in self.coordinates + self.parameters + self.observables
        )
        equations = "".join(f"<div>$\\displaystyle {html.escape(line)}$</div>" for line in self.latex)
        return (
            f"<b>{html.escape(self.title)}</b> <code>{self.id}</code><p>{html.escape(self.about)}</p>"
            f"{equations}<table>{rows}</table><p><small>{html.escape(self.source)}</small></p>"
        )


def _start(coordinate: dict[str, Any]) -> str:
    velocity = f", starts with velocity {coordinate['start_dot']}" if coordinate.get("start_dot") else ""
    return f"starts at {coordinate['start']}{velocity}"


def _choices(parameter: dict[str, Any]) -> str:
    return f", one of {', '.join(parameter['choices'])}" if "choices" in parameter else ""


def _kind(observable: dict[str, Any]) -> str:
    if observable["kind"] == "signal":
        return ""
    where = " = ".join([*observable["when_zero"], "0"]) if observable["when_zero"] else ""
    return f"constant where {where}" if where else "constant"


class Method(_Card):
    """An integration method: its order, what it needs and keeps, and its source."""

    def __init__(self, card: dict[str, Any]) -> None:
        super().__init__(card)
        self.order: int = card["order"]
        self.adaptive: bool = card["adaptive"]
        """It chooses its steps from `rtol` and `atol`; the others take steps of length `dt`."""
        self.separable_only: bool = card["separable_only"]
        """It needs accelerations that depend on positions alone."""
        self.symplectic: bool = card["symplectic"]
        self.reversible: bool = card["reversible"]
        self.options: tuple[str, ...] = tuple(option["name"] for option in card["options"])
        options = "".join(
            f"\n    {o['name']} : default {o['default']}, between {o['low']} and {o['high']}\n        {o['text']['en']}"
            for o in card["options"]
        )
        self.__doc__ = (
            f"{self.title} (`{self.id}`), order {self.order}\n\n{self.about}\n"
            + (f"\nOptions{options}\n" if options else "")
            + f"\nSource\n    {self.source}"
        )


class Catalogue(Mapping[str, T], Generic[T]):
    """Things by id: `catalogue["pendulum"]`, `catalogue.pendulum`, `list(catalogue)`."""

    def __init__(self, what: str, ids: Callable[[], Iterable[str]], make: Callable[[str], T]) -> None:
        self._what = what
        self._all = ids
        self._make = functools.cache(make)

    @functools.cached_property
    def _ids(self) -> dict[str, None]:
        return dict.fromkeys(self._all())

    def __getitem__(self, name: str) -> T:
        if name not in self._ids:
            raise UnknownNameError(nearest(self._what, str(name), self._ids))
        return self._make(name)

    def __getattr__(self, name: str) -> T:
        if name.startswith("_"):
            raise AttributeError(name)
        return self[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._ids)

    def __len__(self) -> int:
        return len(self._ids)

    def __dir__(self) -> list[str]:
        return [*super().__dir__(), *self._ids]

    def __repr__(self) -> str:
        return f"<{len(self)} {self._what}s: {', '.join(self)}>"


@functools.cache
def _method_cards() -> dict[str, Any]:
    return {card["id"]: card for card in json.loads(_core.method_cards())}


@functools.cache
def _scenario_texts() -> dict[str, str]:
    return dict(_core.scenario_texts())


systems: Catalogue[System] = Catalogue(
    "system", _core.system_ids, lambda name: System(json.loads(_core.system_card(name)))
)
"""Every mechanical system by its id."""
methods: Catalogue[Method] = Catalogue("method", _method_cards, lambda name: Method(_method_cards()[name]))
"""Every integration method by its id."""
scenarios: Catalogue[str] = Catalogue("scenario", _scenario_texts, lambda name: _scenario_texts()[name])
"""The text (TOML) of every scenario that comes with the program, by its file name."""
