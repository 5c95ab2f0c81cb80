"""Results of a run in memory."""

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Protocol

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
    """Intermediate results of a run; `sound` is None until it is rendered."""

    scene: Scene
    plan: Plan
    motion: Motion
    modes: Modes
    table: SurfaceModes | None = None
    sound: Sound | None = None

    @property
    def completed_stage(self) -> str:
        """The stage that was completed last, "motion" or "sound"."""
        return "motion" if self.sound is None else "sound"


class Display(Protocol):
    """Shows a result in a terminal and in a notebook."""

    def text(self, result: "Result") -> str:
        """Return a few lines of text."""
        ...

    def html(self, result: "Result") -> str:
        """Return an HTML fragment."""
        ...

    def picture(self, result: "Result", name: str) -> "Image":
        """Return a picture; raise ValueError for an unknown name."""
        ...


@dataclass(frozen=True, kw_only=True, eq=False)
class Result:
    """The results of a run.

    Parameters
    ----------
    scene : Scene
        Input of the run.
    plan : Plan
        Decisions, omissions and predicted errors.
    motion : Motion
        Motion of the disk.
    modes : Modes
        Elastic modes of the disk.
    sound : Sound
        Sound pressure at the listeners.
    heard : Heard or None
        Analysis of the sound.
    findings : Findings
        Claims with their verdicts.
    checks : list of Check
        Self-checks.
    seconds : dict of str to float
        Computing time of each stage [s].
    display : Display
        Text, notebook view and pictures of the result.
    out : Path or None
        Folder of the files; None before they are written.
    table : SurfaceModes or None
        All modes of the table; None for a rigid or infinite table.

    Examples
    --------
    >>> from sonify import run
    >>> result = run("published", accuracy="draft")  # doctest: +SKIP
    >>> result.motion.outcome.name, result.passed  # doctest: +SKIP
    ('AT_REST', True)
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
    display: Display
    out: Path | None = None
    table: SurfaceModes | None = None

    @property
    def passed(self) -> bool:
        """True if every self-check passed."""
        return all(check.passed for check in self.checks)

    def plot(self, name: str = "spectrogram") -> "Image":
        """Draw a picture of the result.

        Parameters
        ----------
        name : str
            "spectrogram", "stems", "motion" or "modes".

        Returns
        -------
        PIL.Image.Image
            The picture, which notebooks display.

        Raises
        ------
        ValueError
            If there is no picture of this name.
        """
        return self.display.picture(self, name)

    def __repr__(self) -> str:
        return self.display.text(self)

    def _repr_html_(self) -> str:
        return self.display.html(self)


def output_folder(result: Result) -> Path:
    """Return the folder of the files of a result.

    Raises ValueError for a result without a folder."""
    if result.out is None:
        raise ValueError("the result has no folder; write it with sonify.run")
    return result.out
