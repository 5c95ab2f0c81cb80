"""Write the last seconds of finished runs as FLAC files for the pictures of the documentation.

`python docs/last_seconds.py outputs/glass outputs/granite` reads `audible.wav` in each folder and
writes `outputs/shown/<scene>/last_seconds.flac`: 16 bits, one channel."""

import json
import sys
from math import gcd
from pathlib import Path

import numpy as np
import soundfile
from scipy.signal import resample_poly

SHOWN = Path(__file__).parents[1] / "outputs" / "shown"


def write_last_seconds(run: Path, seconds: float = 6.0, sample_rate: int = 24000) -> Path:
    """Write the mean of both ears over the last seconds of a run; return the path of the file."""
    scene = json.loads((run / "run.json").read_text("utf-8"))["scene"]["name"]
    samples, rate = soundfile.read(run / "audible.wav", always_2d=True)
    last = samples[-round(seconds * rate) :].mean(axis=1)
    common = gcd(sample_rate, rate)
    resampled = resample_poly(last, sample_rate // common, rate // common)
    peak = np.abs(resampled).max()
    path = SHOWN / scene / "last_seconds.flac"
    path.parent.mkdir(parents=True, exist_ok=True)
    soundfile.write(path, 0.9 * resampled / peak, sample_rate, subtype="PCM_16")
    return path


if __name__ == "__main__":
    for folder in sys.argv[1:]:
        print(write_last_seconds(Path(folder)))
