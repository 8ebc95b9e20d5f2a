"""The equations of motion as SymPy expressions."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from . import _core
from ._names import extra
from ._scenario import Scenario

if TYPE_CHECKING:
    from pathlib import Path

    from ._catalogue import System


def to_sympy(system: str | Path | System | Scenario) -> dict[str, Any]:
    """Give the rate of every number of the state as a SymPy expression, from the very code that is integrated.

    The symbols are real and named as on the card (`theta`, `theta_dot`, `l`); the time is `t`. Lists have the length
    that they have in the scenario (`masses[0]`). A choice, such as rough or smooth, is the scenario's.

    Examples
    --------
    >>> import precess
    >>> precess.to_sympy("pendulum")["theta"]
    theta_dot

    """
    try:
        import sympy as sp
    except ImportError:
        raise extra("sympy", "sympy") from None
    scenario = Scenario.of(system)
    names, operations, outputs = _core.expressions(scenario._plan)  # noqa: SLF001
    symbols = [sp.Symbol(name, real=True) for name in names]
    found: list[Any] = []
    for name, operands, number in operations:
        arguments = [symbols[operands[0]]] if name == "input" else [found[k] for k in operands]
        found.append(_operation(sp, name, arguments, number))
    card = scenario.system
    state = scenario.state
    rates: dict[str, Any] = {}
    for place, name in zip(outputs, state, strict=False):
        velocity = f"{name}_dot"
        if velocity in state[len(outputs) :]:
            rates[name] = sp.Symbol(velocity, real=True)
            rates[velocity] = found[place]
        else:
            rates[name] = found[place]
    assert set(rates) == set(state), card.id  # noqa: S101
    # One over a length that vanishes, in a branch that is not taken then: SymPy's name for it cannot be printed as code.
    return {name: rates[name].xreplace({sp.zoo: sp.nan}) for name in state}


def _operation(sp: Any, name: str, a: list[Any], number: float) -> Any:
    """Give one operation of the tape."""
    if name == "constant":
        return sp.Integer(int(number)) if number.is_integer() else sp.Float(number, 17)
    if name == "input":
        return a[0]
    if name == "power":
        return a[0] ** int(number)
    return {
        "neg": lambda x: -x,
        "add": lambda x, y: x + y,
        "sub": lambda x, y: x - y,
        "mul": lambda x, y: x * y,
        "div": lambda x, y: x / y,
        "powf": lambda x, y: x**y,
        "hypot": lambda x, y: sp.sqrt(x**2 + y**2),
        "cbrt": sp.real_root,
        "larger": sp.Max,
        "smaller": sp.Min,
        "ln": sp.log,
        "less": sp.StrictLessThan,
        "lessorequal": sp.LessThan,
        "less_or_equal": sp.LessThan,
        "and": sp.And,
        "or": sp.Or,
        "not": sp.Not,
        "select": lambda condition, x, y: sp.Piecewise((x, condition), (y, True)),
        **{
            f: getattr(sp, f)
            for f in (
                "sqrt",
                "sin",
                "cos",
                "tan",
                "asin",
                "acos",
                "exp",
                "sinh",
                "cosh",
                "tanh",
                "atan2",
                "sign",
            )
        },
        "abs": sp.Abs,
    }[name](*a)
