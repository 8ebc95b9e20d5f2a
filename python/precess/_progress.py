"""A progress bar where one is asked for."""

from __future__ import annotations

from contextlib import contextmanager
from typing import TYPE_CHECKING

from ._names import extra

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

    Told = Callable[[float], object]
    Progress = bool | Told | None


@contextmanager
def bar(progress: Progress, total: float, unit: str) -> Iterator[Told | None]:
    """Give what the core is to tell: a bar for True, the user's own function, or nothing."""
    if callable(progress) or not progress:
        yield progress if callable(progress) else None
        return
    try:
        from tqdm.auto import tqdm
    except ImportError:
        raise extra("tqdm", "progress") from None
    with tqdm(total=abs(total), unit=unit) as shown:
        yield lambda done: shown.update(abs(done) - shown.n)
