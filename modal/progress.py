"""Report the progress of a computation of modes."""

from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from typing import TypeVar

T = TypeVar("T")

_watch: ContextVar[Callable[[float], None]] = ContextVar(
    "watch", default=lambda share: None
)


@contextmanager
def progress_reported_to(watch: Callable[[float], None]) -> Iterator[None]:
    """Call `watch(fraction)` with the completed fraction of the modal computations of
    this thread in the block."""
    before = _watch.set(watch)
    try:
        yield
    finally:
        _watch.reset(before)


@contextmanager
def progress_range(begin: float, end: float) -> Iterator[None]:
    """Report the progress of the block as fractions from `begin` to `end` of the whole
    work."""
    outer = _watch.get()
    with progress_reported_to(lambda share: outer(begin + (end - begin) * share)):
        yield
    outer(end)


def report_progress(share: float) -> None:
    """Report the completed fraction of the work."""
    _watch.get()(share)


def report_each(items: Iterable[T], count: int) -> Iterator[T]:
    """Yield `count` items, and report each one as finished when the next one is
    requested."""
    for done, item in enumerate(items, 1):
        yield item
        report_progress(min(done / count, 1.0))
