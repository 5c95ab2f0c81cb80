"""PICTURES: what was solved and what is heard, each readable without colour."""

from modal import draw_modes
from sonify.files import whole

from .heard import draw_recording, draw_spectrogram, draw_stems
from .solved import draw_motion

__all__ = ["draw_all", "draw_motion", "draw_recording", "draw_spectrogram", "draw_stems"]


def draw_all(result):
    """Draw every picture of a run into its folder."""
    draw_spectrogram(result.motion, result.modes, result.sound, result.out / "spectrogram.png")
    draw_stems(result.sound, result.out / "stems.png")
    draw_motion(result.motion, result.out / "motion.png")
    with whole(result.out / "modes.png") as temporary:
        draw_modes(result.modes, temporary)
