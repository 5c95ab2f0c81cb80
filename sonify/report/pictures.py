"""PICTURES: what was solved and what is heard, each readable without colour."""

from itertools import zip_longest
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import TYPE_CHECKING

import numpy as np
from PIL import Image

from sonify.files import whole
from sonify.plan.supports import over_the_run
from sonify.report.mode_shapes import draw_modes
from sonify.report.motion import draw_motion
from sonify.report.sound import draw_spectrogram, draw_stems

if TYPE_CHECKING:
    from sonify.result import Result


def draw_all(result: "Result"):
    """Draw every picture of a run into its folder; in a draft not that of the stems."""
    for name, draw in PICTURES.items():
        path = result.out / f"{name}.png"
        if name == "stems" and result.plan.accuracy == "draft":
            path.unlink(missing_ok=True)  # that of another run
        else:
            draw(result, path)


def picture(result: "Result", name: str) -> Image.Image:
    """Return one of the PICTURES of a result, which a notebook shows. Raises ValueError for another name."""
    if name not in PICTURES:
        raise ValueError(f"there is no picture {name!r}: it is one of {', '.join(PICTURES)}")
    with TemporaryDirectory() as folder:
        PICTURES[name](result, Path(folder) / "picture.png")
        with Image.open(Path(folder) / "picture.png") as image:
            return image.convert("RGB")


def _modes(result, path):
    """The modes of a draft are seen from above only."""
    with whole(path) as temporary:
        steps = over_the_run(result.scene, result.motion, result.plan.highest_mode)
        draw_modes(result.modes, temporary, result.plan.accuracy != "draft", result.scene.support, moving(steps))


def moving(steps) -> str:
    """Return a line for each mode of a disk on its contact: where its frequency goes as the disk falls."""
    rows = zip_longest(*[[f"{f:.0f}" for f in step.modes.frequency] for step in steps], fillvalue="none")
    at = ",\n".join(f"{step.name} {np.degrees(step.inclination):.2g}°" for step in steps)
    return "\n".join([f"[Hz] at {at}", *(f"{i}: {' → '.join(row)}" for i, row in enumerate(rows, 1))]) if steps else ""


PICTURES = {
    "spectrogram": lambda result, path: draw_spectrogram(result.motion, result.modes, result.sound, path),
    "stems": lambda result, path: draw_stems(result.sound, path),
    "motion": lambda result, path: draw_motion(result.motion, path),
    "modes": _modes,
}
"""By name, what draws the picture of a result into a PNG file."""
