"""Write the last seconds of finished runs as FLAC files for the pictures of the documentation.

`python docs/last_seconds.py outputs/glass outputs/granite` reads `audible.wav` in each folder and
writes `outputs/shown/<scene>/last_seconds.flac`: 16 bits, one channel."""

import json
import sys
from io import BytesIO
from math import gcd
from pathlib import Path

import numpy as np
import soundfile
from scipy.signal import resample_poly

SHOWN = Path(__file__).parents[1] / "outputs" / "shown"


def last_seconds(
    samples: np.ndarray, rate: int, seconds: float = 6.0, sample_rate: int = 24000
) -> bytes:
    """Return the mean of both ears (n, 2) over the last seconds as a FLAC file."""
    last = samples[-round(seconds * rate) :].mean(axis=1)
    common = gcd(sample_rate, rate)
    resampled = resample_poly(last, sample_rate // common, rate // common)
    peak = np.abs(resampled).max()
    file = BytesIO()
    soundfile.write(
        file, 0.9 * resampled / peak, sample_rate, subtype="PCM_16", format="FLAC"
    )
    return file.getvalue()


def store_last_seconds(scene: str, sound: bytes) -> Path:
    """Write the last seconds of a scene to the folder that the documentation shows."""
    path = SHOWN / scene / "last_seconds.flac"
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(sound)
    return path


if __name__ == "__main__":
    for folder in map(Path, sys.argv[1:]):
        name = json.loads((folder / "run.json").read_text("utf-8"))["scene"]["name"]
        sound = last_seconds(*soundfile.read(folder / "audible.wav", always_2d=True))
        print(store_last_seconds(name, sound))
