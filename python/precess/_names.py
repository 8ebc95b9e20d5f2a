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
    """Make an unknown keyword argument a sentence with the nearest known one.

    What a function takes beside its own (`**settings`) are the settings of a scenario.
    """
    parameters = inspect.signature(function).parameters.values()
    own = [
        p.name for p in parameters if p.kind in (p.POSITIONAL_OR_KEYWORD, p.KEYWORD_ONLY) and p.name != "self"
    ]
    settings = any(p.kind is p.VAR_KEYWORD for p in parameters)

    @functools.wraps(function)
    def checked(*args: P.args, **kwargs: P.kwargs) -> R:
        if not kwargs.keys() <= set(own):
            from ._scenario import Settings

            known = [*own, *(Settings.__annotations__ if settings else ())]
            for name in kwargs:
                if name not in known:
                    where = function.__qualname__.removesuffix(".__init__")
                    raise TypeError(nearest(f"keyword argument of {where}", name, known))
        return function(*args, **kwargs)

    return checked


def extra(module: str, extra: str) -> ImportError:
    """Say which extra brings a package that is missing."""
    return ImportError(f"{module} is needed here: pip install 'precess[{extra}]'", name=module)
