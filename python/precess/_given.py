"""What people give, held against what is needed: an exception of the right type, one sentence."""

from __future__ import annotations

import operator
from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

import numpy as np

from . import _core

if TYPE_CHECKING:
    from ._core import Floats

# What a sweep is given by.
SPAN = "first value, last value and number of values"


def array(name: str, values: Any) -> Floats:
    """Give an array of one dimension; its numbers need not be finite."""
    try:
        found = np.asarray(values)
    except ValueError:
        # Rows that differ in length.
        raise TypeError(f"{name}: an array of numbers is needed") from None
    if found.dtype.kind == "O" and all(type(x) in (int, float) for x in found.flat):
        # Whole numbers beyond 64 bits.
        found = found.astype(np.float64)
    # An empty list has no kind of its own.
    if found.dtype.kind not in "iuf" and found.size:
        raise TypeError(f"{name}: an array of numbers is needed, not of {_kind(found)}")
    if found.ndim != 1:
        raise _core.InputError(f"{name}: an array of one dimension is needed, not of {found.ndim}")
    return np.ascontiguousarray(found, dtype=np.float64)


def _kind(found: Any) -> str:
    if found.dtype.kind == "O":
        return type(found.flat[0]).__name__
    return "texts" if found.dtype.kind in "US" else str(found.dtype)


def text(name: str, value: Any) -> str:
    """Give a text."""
    if not isinstance(value, str):
        raise TypeError(f"{name}: a text is needed, not {type(value).__name__}")
    return value


def texts(name: str, value: Any) -> list[str]:
    """Give some texts, or one."""
    if isinstance(value, str):
        return [value]
    if not isinstance(value, Iterable):
        raise TypeError(f"{name}: a name or a list of names is needed, not {type(value).__name__}")
    return [text(name, one) for one in value]


def count(name: str, value: Any) -> int:
    """Give a whole number above zero."""
    try:
        found = operator.index(value)
    except TypeError:
        raise TypeError(f"{name}: a whole number is needed, not {type(value).__name__}") from None
    if found < 1:
        raise _core.InputError(f"{name}: at least one is needed, not {found}")
    return found


def several(name: str, what: str, values: Any, many: int) -> list[Any]:
    """Give so many things of a list."""
    try:
        found = [*values] if not isinstance(values, str) else []
    except TypeError:
        found = []
    if len(found) != many:
        raise TypeError(f"{name}: {what} are needed")
    return found


def number(name: str, value: Any) -> float:
    """Give a number."""
    try:
        return float(value)
    except (TypeError, ValueError):
        raise TypeError(f"{name}: a number is needed, not {value!r}") from None
