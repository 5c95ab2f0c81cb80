"""PICTURES: what was solved and what is heard, each readable without colour."""

from sonify.files import whole
from sonify.report.mode_shapes import draw_modes
from sonify.report.motion import draw_motion
from sonify.report.sound import draw_spectrogram, draw_stems


def draw_all(result):
    """Draw every picture of a run into its folder; in a draft not that of the stems, and the modes from above only."""
    whole_story = result.plan.accuracy != "draft"
    draw_spectrogram(result.motion, result.modes, result.sound, result.out / "spectrogram.png")
    if whole_story:
        draw_stems(result.sound, result.out / "stems.png")
    else:
        (result.out / "stems.png").unlink(missing_ok=True)  # that of another run
    draw_motion(result.motion, result.out / "motion.png")
    with whole(result.out / "modes.png") as temporary:
        draw_modes(result.modes, temporary, slanted=whole_story, support=result.scene.support)
