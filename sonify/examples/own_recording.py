"""
Your own recording
==================

Detect a rising tone, and fit its end and the power law of its frequency.

Without a file, the example generates a tone with the known frequency 60 Hz s / (4 s -
t)."""

import sys
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np
import soundfile

from sonify import Heard, listen


def write_rising_tone(path: Path) -> Path:
    """Write a tone that rises until its end and then stops, with weak noise
    throughout."""
    sample_rate = 22050  # Hz
    end = 4.0  # s
    coefficient = 60.0  # frequency times remaining time [Hz s]
    t = np.arange(5 * sample_rate) / sample_rate
    phase = -2 * np.pi * coefficient * np.log(np.maximum(1 - t / end, 1e-3))
    noise = np.random.default_rng(1).normal(size=len(t))
    soundfile.write(
        path,
        np.where(t < end, 0.3 * np.sin(phase), 0.0) + 0.003 * noise,
        sample_rate,
    )
    return path


def main(path: Path | None = None) -> Heard:
    """Analyse the recording at `path`, print the results and return them."""
    with TemporaryDirectory() as folder:
        heard = listen(path or write_rising_tone(Path(folder) / "rising_tone.wav"))
    if heard.tone is None:
        print("no tone rises")
    else:
        print(
            f"a tone rises until {heard.tone.heard_until:.3f} s "
            f"as (t_end - t)^-{heard.tone.exponent.value:.3f}"
        )
    for line in heard.carriers:
        print(f"a steady tone at {line.frequency:.2f} Hz")
    return heard


if __name__ == "__main__":
    main(*map(Path, sys.argv[1:]))
