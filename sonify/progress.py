"""Which stage a run is in, and how long each took."""

from contextlib import contextmanager
from time import perf_counter
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from sonify.result import Result


class Stages:
    """Times the stages of a run; `seconds` by name. Silent: the command line shows them by a subclass."""

    def __init__(self, seconds: dict[str, float] | None = None):
        self.seconds = {} if seconds is None else seconds

    @contextmanager
    def stage(self, name: str):
        """Time the block as stage `name`; yields watch(share done, note)."""
        began = perf_counter()
        yield self.watch
        self.seconds[name] = perf_counter() - began

    def answer(self, result: "Result"):
        """Take note of what was found, before it is drawn and written."""

    def watch(self, share: float, note: str = ""):
        """Note the share of the stage that is done."""
