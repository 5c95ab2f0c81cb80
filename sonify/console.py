"""Progress on standard error, results on standard output."""

from contextlib import AbstractContextManager, contextmanager
from typing import TYPE_CHECKING

import click
from rich.console import Console as RichConsole
from rich.progress import BarColumn, Progress, TextColumn

from sonify.plan.plan import unsettled
from sonify.progress import Stages

if TYPE_CHECKING:
    from sonify.result import Result


class Console(Stages, AbstractContextManager):
    """Shows every stage as a line on standard error, with a bar while it runs where there is a terminal."""

    def __init__(self):
        super().__init__()
        self._shown = True
        self._console = RichConsole(stderr=True, highlight=False)
        self._bars = Progress(
            TextColumn("{task.description}"),
            BarColumn(),
            TextColumn("{task.fields[note]}"),
            console=self._console,
            transient=True,
            disable=not self._console.is_terminal,
        )

    def __exit__(self, *_):
        self._shown = False  # what still goes on in a thread says no more
        if self._bars.live.is_started:
            self._bars.stop()

    @contextmanager
    def stage(self, name: str):
        """Time the block as stage `name` and say how long it took."""
        self._bars.start()
        task = self._bars.add_task(name, total=1.0, note="")
        try:
            with super().stage(name):
                yield lambda share, note="": self._bars.update(task, completed=share, note=note)
        finally:
            self._bars.remove_task(task)
        if self._shown:
            self._console.print(f"{name:20} {self.seconds[name]:7.2f} s")

    def answer(self, result: "Result"):
        """Print checks and findings; the files follow."""
        self._bars.stop()
        for c in result.checks:
            verdict = "ok    " if c.passed else "FAILED"
            click.echo(f"{verdict}  {c.name}: {c.value:.4g} (expected {c.expectation})")
        for f in result.findings:
            click.echo(f"{f.answer:6}  {f.claim}: {f.measured} {f.unit} ({f.expectation})")
        for line in unsettled(result.motion):
            click.echo(f"note    {line}")
