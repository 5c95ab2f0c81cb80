"""Print progress on standard error and results on standard output."""

from collections.abc import Callable, Iterator
from contextlib import AbstractContextManager, contextmanager
from pathlib import Path
from threading import Event, Lock, Thread
from time import perf_counter
from typing import Any, Self

import click
from rich.console import Console as RichConsole
from rich.progress import BarColumn, Progress, TaskID, TextColumn

from sonify.runtime.progress import StageProgress, Stages, Watch, duration_in_words


class Console(Stages, AbstractContextManager[Any]):
    """Show the progress of running stages and the `times` of finished ones on standard
    error.

    A terminal shows one bar per stage; other outputs receive one line on all running
    stages every `interval` [s]."""

    def __init__(self, interval: float = 10.0, times: bool = True) -> None:
        super().__init__()
        self._shown = times
        self._console = RichConsole(stderr=True, highlight=False, emoji=False)
        in_terminal = self._console.is_terminal
        self._bars = Progress(
            BarColumn(bar_width=20),
            TextColumn("{task.description}"),
            console=self._console,
            transient=True,
            disable=not in_terminal,
        )
        self._running: dict[TaskID, StageProgress] = {}
        self._lock = Lock()
        self._ended = Event()
        show, period = (
            (self._redraw, 0.25) if in_terminal else (self._print_progress, interval)
        )
        self._ticker = Thread(target=self._repeat, args=(show, period), daemon=True)

    def __enter__(self) -> Self:
        self._ticker.start()
        return self

    def __exit__(self, *_: object) -> None:
        self._shown = False  # threads that still run print nothing more
        self._ended.set()
        if self._bars.live.is_started:
            self._bars.stop()

    def progress_line(self) -> str:
        """Return the progress of all running stages on one line, or "" if none is
        running."""
        now = perf_counter()
        with self._lock:
            return "; ".join(stage.line(now) for stage in self._running.values())

    @contextmanager
    def stage(self, name: str) -> Iterator[Watch]:
        """Time the block as stage `name`, and show its progress and then its
        duration."""
        self._bars.start()
        task = self._bars.add_task(name, total=None)
        progress = StageProgress(name, perf_counter())
        with self._lock:
            self._running[task] = progress

        def watch(share: float, note: str = "") -> None:
            with self._lock:
                progress.report(perf_counter(), share, note)

        try:
            with super().stage(name):
                yield watch
        finally:
            with self._lock:
                del self._running[task]
            self._bars.remove_task(task)
        if self._shown:
            self._console.print(f"{name:20} {self.seconds[name]:7.2f} s")

    def notice(self, line: str) -> None:
        """Print a line on standard error."""
        self._console.print(line, markup=False, soft_wrap=True)

    def expect(self, seconds: float) -> None:
        """Print the predicted duration of a run."""
        duration = duration_in_words(
            float(f"{seconds:.1g}") if seconds < 10 else seconds
        )
        self.notice(f"takes about {duration} on two idle cores")

    def sound_written(self, path: Path) -> None:
        """Print the path of a sound on standard output."""
        self._bars.stop()  # the next stage restarts them
        click.echo(path)

    def _repeat(self, show: Callable[[], None], period: float) -> None:
        """Call `show` every `period` [s] until the context ends."""
        while not self._ended.wait(period):
            show()

    def _print_progress(self) -> None:
        """Print one line about all running stages."""
        if line := self.progress_line():
            self.notice(line)

    def _redraw(self) -> None:
        """Update the bars in the terminal."""
        now = perf_counter()
        with self._lock:
            for task, stage in self._running.items():
                total = None if stage.share is None else 1.0
                done = stage.share or 0.0
                self._bars.update(
                    task, total=total, completed=done, description=stage.line(now)
                )
