"""RESULT -> PAGE: one self-contained HTML file with the sound, the pictures, the checks and the findings."""

from base64 import b64encode
from pathlib import Path

from jinja2 import Environment, PackageLoader

from sonify.files import whole

PICTURES = {
    "spectrogram.png": "The pressure at the listener in two bands; the solved rates drawn over.",
    "stems.png": "What can be heard: each cause of sound against the threshold of hearing.",
    "motion.png": "Figures 3 to 6 of the paper.",
    "modes.png": "Normal displacement of the upper face; black: the nodal lines.",
}


def write(result, path: Path):
    """Write the page of a result, with everything it shows inside."""
    page = Environment(loader=PackageLoader("sonify"), autoescape=True).get_template("report.html")
    text = page.render(
        result=result,
        zip=zip,
        sound=embedded(result.out / "sound.wav", "audio/wav"),
        pictures=[
            (embedded(result.out / name, "image/png"), caption)
            for name, caption in PICTURES.items()
            if (result.out / name).exists()
        ],
    )
    with whole(path) as temporary:
        temporary.write_text(text, encoding="utf-8")


def embedded(path: Path, kind: str) -> str:
    """Return a file as a data URL."""
    return f"data:{kind};base64,{b64encode(path.read_bytes()).decode()}"
