"""RESULT -> PAGE: one self-contained HTML file with the sound, the pictures, the checks and the findings."""

from base64 import b64encode
from io import BytesIO
from pathlib import Path
from typing import TYPE_CHECKING

import soundfile
from jinja2 import Environment, PackageLoader

from sonify.files import whole

if TYPE_CHECKING:
    from sonify.result import Result

PICTURES = {
    "spectrogram.png": "The pressure at the listener in two bands; the solved rates drawn over.",
    "stems.png": "What can be heard: each cause of sound against the threshold of hearing.",
    "motion.png": "Figures 3 to 6 of the paper.",
    "modes.png": "The modes: the whole body exaggerated, and the axial motion of its upper face with the nodal lines.",
}
MOST_EMBEDDED = 100_000_000
"""A longer sound [bytes] is not put into the page, which refers to the file beside it."""


def write(result: "Result", path: Path):
    """Write the page of a result, with everything it shows inside, but not a sound of hours."""
    text = (
        _templates()
        .get_template("report.html")
        .render(
            result=result,
            zip=zip,
            sound=playable(result.out / "sound.wav"),
            audible=compressed(result.sound.audible),
            pictures=[
                (embedded(result.out / name, "image/png"), caption)
                for name, caption in PICTURES.items()
                if (result.out / name).exists()
            ],
        )
    )
    with whole(path) as temporary:
        temporary.write_text(text, encoding="utf-8")


def _templates():
    return Environment(loader=PackageLoader("sonify.report"), autoescape=True)


def in_words(result: "Result") -> str:
    """Return a result in a few lines."""
    yes, passed = (sum(one) for one in ([f.holds for f in result.findings], [c.passed for c in result.checks]))
    head = f"{result.scene.name}: {result.motion.outcome.sentence}"
    count = f"{passed} of {len(result.checks)} self-checks passed; {yes} of {len(result.findings)} claims stand"
    return "\n".join([head, *map(repr, (result.plan, result.modes, result.motion, result.sound)), count])


def in_a_notebook(result: "Result") -> str:
    """Return a result as a piece of HTML: the sound to play, and the verdict on every claim."""
    template = _templates().get_template("notebook.html")
    return template.render(result=result, audible=compressed(result.sound.audible), words=in_words(result))


def playable(path: Path) -> str:
    """Return a WAV file as a data URL, or the name of a file too long for that."""
    return embedded(path, "audio/wav") if path.stat().st_size <= MOST_EMBEDDED else path.name


def compressed(source) -> str:
    """Return a source as a data URL of FLAC, or "" if it is too long for a page."""
    if 3 * source.frames > MOST_EMBEDDED:
        return ""
    held = BytesIO()
    with soundfile.SoundFile(held, "w", source.sample_rate, 1, "PCM_16", format="FLAC") as file:
        for block in source.blocks():
            file.write(block)
    return f"data:audio/flac;base64,{b64encode(held.getvalue()).decode()}"


def embedded(path: Path, kind: str) -> str:
    """Return a file as a data URL."""
    return f"data:{kind};base64,{b64encode(path.read_bytes()).decode()}"
