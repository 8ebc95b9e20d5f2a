"""Names that do not exist, and the nearest that do."""

from __future__ import annotations

import functools
import inspect
from typing import TYPE_CHECKING, ParamSpec, TypeVar

from . import _core

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable

P = ParamSpec("P")
R = TypeVar("R")


def nearest(what: str, name: str, names: Iterable[str]) -> str:
    """Tell in a sentence that there is no such name, and the nearest that is."""
    return _core.unknown(what, name, list(names))


def knows_its_keywords(function: Callable[P, R]) -> Callable[P, R]:
    """Make an unknown keyword argument a sentence with the nearest known one."""
    parameters = inspect.signature(function).parameters

    @functools.wraps(function)
    def checked(*args: P.args, **kwargs: P.kwargs) -> R:
        for name in kwargs:
            if name not in parameters:
                keywords = [
                    p.name
                    for p in parameters.values()
                    if p.kind is not p.POSITIONAL_ONLY and p.name != "self"
                ]
                where = function.__qualname__.removesuffix(".__init__")
                raise TypeError(nearest(f"keyword argument of {where}", name, keywords))
        return function(*args, **kwargs)

    return checked


def extra(module: str, extra: str) -> ImportError:
    """Say which extra brings a package that is missing."""
    return ImportError(f"{module} is needed here: pip install 'precess[{extra}]'", name=module)
