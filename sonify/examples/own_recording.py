"""
Your own recording
==================

Detect a rising tone, its end, and its power law of the time left.

Without a file, the example makes a tone with a known answer: it rises as 60 Hz s / (4 s - t).
"""

import sys
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np
import soundfile

from sonify import Heard, listen

RATE = 22050  # Hz
END = 4.0  # s
PITCH = 60.0  # Hz


def made(path: Path) -> Path:
    """Write a tone that rises until END [s] and is silent afterwards, in a little noise."""
    t = np.arange(5 * RATE) / RATE
    phase = -2 * np.pi * PITCH * np.log(np.maximum(1 - t / END, 1e-3))
    noise = np.random.default_rng(1).normal(size=len(t))
    soundfile.write(path, np.where(t < END, 0.3 * np.sin(phase), 0.0) + 0.003 * noise, RATE)
    return path


def main(path: Path | None = None) -> Heard:
    """Analyse the recording at `path`, print the results and return them."""
    with TemporaryDirectory() as folder:
        heard = listen(path or made(Path(folder) / "made.wav"))
    if heard.tone is None:
        print("no tone rises")
    else:
        print(
            f"a tone rises until {heard.tone.end:.3f} s as (t_end - t)^-{heard.tone.exponent:.3f}"
        )
    for carrier in heard.carriers:
        print(f"a steady tone at {carrier.frequency:.2f} Hz")
    return heard


if __name__ == "__main__":
    main(*map(Path, sys.argv[1:]))
