"""Which stage a run is in, how long each took, and what goes on beside it."""

from collections.abc import Callable
from concurrent.futures import Future, ThreadPoolExecutor
from contextlib import contextmanager
from time import perf_counter
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from sonify.result import Result


class Stages:
    """Times the stages of a run, of which some go on beside each other; `seconds` by name. Silent: the command line
    shows them by a subclass."""

    def __init__(self, seconds: dict[str, float] | None = None):
        self.seconds = {} if seconds is None else seconds

    @contextmanager
    def stage(self, name: str):
        """Time the block as stage `name`; yields watch(share done, note)."""
        began = perf_counter()
        yield lambda share, note="": None
        self.seconds[name] = perf_counter() - began

    def answer(self, result: "Result"):
        """Take note of what was found, before it is drawn and written."""


def beside(work: Callable, *arguments: Any) -> Future:
    """Return the future of work in a thread of its own, for which nobody waits who does not ask for its result."""
    thread = ThreadPoolExecutor(1, work.__name__)
    try:
        return thread.submit(work, *arguments)
    finally:
        thread.shutdown(wait=False)
