"""Layouts of arrays: the first index of each named quantity."""

from collections.abc import Callable
from itertools import accumulate
from typing import Annotated, TypeVar, get_type_hints

Layout = TypeVar("Layout")
"""NamedTuple class of first indices."""

Pair = Annotated[int, 2]
"""Index of the first of two successive entries."""
Vector = Annotated[int, 3]
"""Index of the first of three successive entries."""


def first_indices(layout: Callable[..., Layout]) -> tuple[Layout, int]:
    """Return a `layout` (NamedTuple class) of first indices, and the number of entries."""
    hints = get_type_hints(layout, include_extras=True).values()
    sizes = [getattr(hint, "__metadata__", (1,))[0] for hint in hints]
    return layout(*accumulate(sizes[:-1], initial=0)), sum(sizes)
