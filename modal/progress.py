"""Progress reports of a computation of modes."""

from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from typing import TypeVar

T = TypeVar("T")

_watch: ContextVar[Callable[[float], None]] = ContextVar("watch", default=lambda share: None)


@contextmanager
def watched(watch: Callable[[float], None]) -> Iterator[None]:
    """Call `watch(share)` with the finished share at every step of modes that this thread solves in
    the block."""
    before = _watch.set(watch)
    try:
        yield
    finally:
        _watch.reset(before)


@contextmanager
def portion(begin: float, end: float) -> Iterator[None]:
    """Report the progress of the block as the shares `begin` to `end` of the whole work."""
    outer = _watch.get()
    with watched(lambda share: outer(begin + (end - begin) * share)):
        yield
    outer(end)


def report(share: float) -> None:
    """Report the finished share of the work."""
    _watch.get()(share)


def reporting(items: Iterable[T], count: int) -> Iterator[T]:
    """Yield items, and report each of `count` as finished when the next one is requested."""
    for done, item in enumerate(items, 1):
        yield item
        report(min(done / count, 1.0))
