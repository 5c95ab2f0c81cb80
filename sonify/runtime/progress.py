"""Stage times, progress estimates and background threads of a run."""

from collections import deque
from collections.abc import Callable
from concurrent.futures import Future, ThreadPoolExecutor
from contextlib import contextmanager
from math import floor
from time import perf_counter
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from sonify.result import Result


class Stages:
    """Timer for the stages of a run, which may overlap; `seconds` maps names to
    durations [s].

    This class prints nothing; the subclass for the command line prints the progress.
    """

    def __init__(self, seconds: dict[str, float] | None = None):
        self.seconds = {} if seconds is None else seconds

    @contextmanager
    def stage(self, name: str):
        """Time the block as stage `name`; yield a callback watch(share_done, note)."""
        began = perf_counter()
        yield lambda share, note="": None
        self.seconds[name] = perf_counter() - began

    def notice(self, line: str):
        """Receive a message for the user before the work starts."""

    def pressure(self, block, sample_rate: int, samples: int):
        """Receive a block (k,) of the pressure at the first listener [Pa] while it is
        rendered.

        `samples` is the length of the whole sound.
        """

    def answer(self, result: "Result"):
        """Receive the result before it is drawn and written."""


class StageProgress:
    """Progress of one stage; the remaining time assumes the average speed of the last
    30 s.

    The caller passes clock times [s]. The completed share never decreases; it is None
    before the first report."""

    def __init__(self, name: str, began: float):
        self.name = name
        self.began = began
        self.share: float | None = None
        self.note = ""
        self._history: deque[tuple[float, float]] = deque()

    def report(self, now: float, share: float, note: str = ""):
        """Record the completed share, from 0 to 1, and a short note."""
        window = 30.0  # s
        self.share = max(share, self.share or 0.0)
        self.note = note
        while len(self._history) > 1 and self._history[1][0] < now - window:
            self._history.popleft()
        self._history.append((now, self.share))

    def remaining(self, now: float) -> float | None:
        """Return the estimated remaining time [s], or None while it is unknown."""
        if self.share is None:
            return None
        before, share_before = self._history[0]
        gained = self.share - share_before
        return (1 - self.share) * (now - before) / gained if gained > 0 else None

    def line(self, now: float) -> str:
        """Return the name with percentage, remaining time and note, or initially, after
        one second, the elapsed time."""
        if self.share is None:
            elapsed = now - self.began
            spent = f" for {duration_in_words(elapsed)}" if elapsed >= 1.0 else ""
            return self.name + spent
        percent = min(floor(100 * self.share), 99)  # 100 % is for a completed stage
        parts = [f"{self.name} {percent} %"]
        remaining = self.remaining(now)
        if remaining:
            parts.append(f"about {duration_in_words(max(round(remaining), 1))} left")
        if self.note:
            parts.append(self.note)
        return ", ".join(parts)


def duration_in_words(seconds: float) -> str:
    """Format a duration [s] in a suitable unit: "0.8 s", "12 min", "3.4 h", "2.1
    days".

    The number has two significant digits, or more if its integer part needs them."""
    sizes = {"days": 86400.0, "h": 3600.0, "min": 60.0}
    unit = next((unit for unit, size in sizes.items() if seconds >= 1.5 * size), "s")
    number = seconds / sizes.get(unit, 1.0)
    return f"{number:.0f} {unit}" if number >= 10 else f"{number:.2g} {unit}"


def in_background(work: Callable, *arguments: Any) -> Future:
    """Run `work` in a background thread and return its Future."""
    thread = ThreadPoolExecutor(1, work.__name__)
    try:
        return thread.submit(work, *arguments)
    finally:
        thread.shutdown(wait=False)
