"""RESULT: what a run found, in memory, on a line, in a notebook."""

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from dynamics import Motion
from modal import Modes, SurfaceModes
from sonify.claims.checks import Check
from sonify.claims.finding import Findings
from sonify.hearing.recording import Heard
from sonify.plan.plan import Plan
from sonify.scene import Scene
from sonify.sound.pressure import Sound

if TYPE_CHECKING:
    from PIL.Image import Image


@dataclass(frozen=True, kw_only=True, eq=False)
class SolvedMotion:
    """What a run knows once the motion is solved, and later its sound."""

    scene: Scene
    plan: Plan
    motion: Motion
    modes: Modes
    table: SurfaceModes | None = None
    sound: Sound | None = None


@dataclass(frozen=True, kw_only=True, eq=False)
class Result:
    """What a run found, `seconds` by stage. Its files are in `out`, where they have been written.

    `table` are the modes of the table that sound, None of a rigid one.
    """

    scene: Scene
    plan: Plan
    motion: Motion
    modes: Modes
    sound: Sound
    heard: Heard | None
    findings: Findings
    checks: list[Check]
    seconds: dict[str, float]
    out: Path | None = None
    table: SurfaceModes | None = None

    @property
    def passed(self) -> bool:
        """Whether every self-check passed."""
        return all(check.passed for check in self.checks)

    def plot(self, name: str = "spectrogram") -> "Image":
        """Return the picture of that name (spectrogram, stems, motion, modes), which a notebook
        shows; a PIL image."""
        from sonify.report.pictures import picture  # drawing loads slowly

        return picture(self, name)

    def __repr__(self):
        from sonify.report.page import in_words

        return in_words(self)

    def _repr_html_(self):
        from sonify.report.page import in_a_notebook

        return in_a_notebook(self)
