"""Stage times, progress estimates and background threads of a run."""

from collections import deque
from collections.abc import Iterator
from concurrent.futures import Executor, ThreadPoolExecutor
from contextlib import contextmanager
from math import floor
from pathlib import Path
from statistics import median_low
from time import perf_counter
from typing import TYPE_CHECKING, NamedTuple, Protocol

MAX_SIMULTANEOUS_STAGES = 8
"""Number of threads of a run; a task may wait for the result of one that began earlier."""

if TYPE_CHECKING:
    import numpy as np


class Watch(Protocol):
    """Progress callback of every task."""

    def __call__(self, share: float, note: str = "") -> None:
        """Receive the completed share, from 0 to 1, and a short note."""


def ignore_progress(share: float, note: str = "") -> None:
    """Receive the progress of a task that nobody watches."""


class Stages:
    """Timer for the stages of a run, which may overlap; `seconds` maps names to
    durations [s].

    This class prints nothing; the subclass for the command line prints the progress.
    """

    def __init__(self, seconds: dict[str, float] | None = None) -> None:
        self.seconds = {} if seconds is None else seconds

    @contextmanager
    def stage(self, name: str) -> Iterator[Watch]:
        """Time the block as stage `name` and yield its progress callback."""
        began = perf_counter()
        yield lambda share, note="": None
        self.seconds[name] = perf_counter() - began

    def notice(self, line: str) -> None:
        """Receive a message for the user before the work starts."""

    def expect(self, seconds: float) -> None:
        """Receive the predicted duration [s] of a run on two idle cores."""

    def pressure(self, block: "np.ndarray", sample_rate: int, samples: int) -> None:
        """Receive a block (k,) of the pressure at the first listener [Pa] while it is
        rendered.

        `samples` is the length of the whole sound.
        """

    def sound_written(self, path: Path) -> None:
        """Receive the path of sound.wav, which is written before all other files."""


class Interval(NamedTuple):
    """Time between two reports of the progress of a stage."""

    end: float
    """Clock time [s]."""
    duration: float
    """[s]"""
    gained: float
    """Completed share."""


class StageProgress:
    """Progress of one stage; the remaining time assumes the average speed of the last
    30 s of work.

    Loading and compilation are no work: the measurement begins with the first completed
    share, and interruptions are left out. The caller passes clock times [s]. The
    completed share never decreases; it is None before the first report."""

    def __init__(self, name: str, began: float) -> None:
        self.name = name
        self.began = began
        self.share: float | None = None
        self.note = ""
        self._measured: tuple[float, float] | None = None
        self._intervals: deque[Interval] = deque()

    def report(self, now: float, share: float, note: str = "") -> None:
        """Record the completed share, from 0 to 1, and a short note."""
        min_interval = 0.2  # s, between two measurements of the speed
        self.share = max(share, self.share or 0.0)
        self.note = note
        if self._measured is None:
            self._measured = (now, self.share) if self.share > 0 else None
            return
        before, share_before = self._measured
        if now - before >= min_interval:
            self._intervals.append(
                Interval(now, now - before, self.share - share_before)
            )
            self._measured = (now, self.share)
            self._forget_old_intervals(now)

    def _forget_old_intervals(self, now: float) -> None:
        """Keep the intervals of the last 30 s, and at least 20."""
        window = 30.0  # s
        while len(self._intervals) > 20 and self._intervals[0].end < now - window:
            self._intervals.popleft()

    def remaining(self) -> float | None:
        """Return the estimated remaining time [s], or None while it is unknown."""
        if not self._intervals or self.share is None:
            return None
        interruption = 10 * median_low(one.duration for one in self._intervals)
        steady = [one for one in self._intervals if one.duration <= interruption]
        gained = sum(one.gained for one in steady)
        spent = sum(one.duration for one in steady)
        return (1 - self.share) * spent / gained if gained > 0 else None

    def line(self, now: float) -> str:
        """Return the name with percentage, remaining time and note, or initially, after
        one second, the elapsed time."""
        if self.share is None:
            elapsed = now - self.began
            spent = f" for {duration_in_words(elapsed)}" if elapsed >= 1.0 else ""
            return self.name + spent
        percent = min(floor(100 * self.share), 99)  # 100 % is for a completed stage
        parts = [f"{self.name} {percent} %"]
        remaining = self.remaining()
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


@contextmanager
def background_threads(executor: Executor | None = None) -> Iterator[Executor]:
    """Yield the given executor, or else one with threads for this block.

    The block does not wait for tasks whose results it has not requested.
    """
    if executor is not None:
        yield executor
        return
    threads = ThreadPoolExecutor(MAX_SIMULTANEOUS_STAGES, "stage")
    try:
        yield threads
    finally:
        threads.shutdown(wait=False, cancel_futures=True)
