"""Misses and false alarms of the detector of settling disks, by kind of sound: python
benchmarks/ear.py FOLDER

Every sound file below FOLDER counts by the class at the end of its name
("1-17150-A-010-Fire_crackling.flac"), or by its folder; simulated takes and imitations of
`settling_sounds` are added. The interval of each share is the 95 % one of Clopper and Pearson."""

import sys
from collections import defaultdict
from pathlib import Path

import numpy as np
import soundfile
from scipy.stats import beta

sys.path.insert(0, str(Path(__file__).parents[1] / "tests" / "helpers"))
import settling_sounds

from sonify.hearing.audio_source import source_of
from sonify.hearing.settling.detector import settling_runs

SUFFIXES = {".flac", ".wav", ".ogg", ".aiff"}
SEEDS = range(200, 213)


def share(count, of):
    """Return a count, and the 95 % interval of its share [%], as words."""
    low = beta.ppf(0.025, count, of - count + 1) if count else 0.0
    high = beta.ppf(0.975, count + 1, of - count) if count < of else 1.0
    return f"{count:4d} of {of:3d}  {100 * low:5.1f} to {100 * high:5.1f} %"


def simulated(sample, folder):
    """Return the number of runs heard in samples, by way of a file in a folder."""
    path = Path(folder) / "sound.wav"
    soundfile.write(path, np.asarray(sample), settling_sounds.RATE, "FLOAT")
    return len(settling_runs(source_of(path)))


def main(folder, scratch):
    """Print the table of a folder of recordings."""
    counts = defaultdict(list)
    for path in sorted(Path(folder).rglob("*")):
        if path.suffix.lower() in SUFFIXES:
            kind = path.stem.split("-")[-1] if path.stem.count("-") > 2 else path.parent.name
            counts[kind].append(len(settling_runs(source_of(path))))
    for name, imitation in settling_sounds.IMITATIONS.items():
        counts[f"imitation: {name}"] = [simulated(imitation(seed), scratch) for seed in SEEDS]
    for seed in range(400, 440):
        take = settling_sounds.simulated_take(seed)
        counts[f"simulated: {take.kind}"].append(simulated(take.samples, scratch))
    print(f"{'kind':30s} runs  sounds with a run, 95 %")
    for kind, runs in sorted(counts.items()):
        heard = int(np.count_nonzero(runs))
        print(f"{kind:30s} {sum(runs):4d}  {share(heard, len(runs))}")


if __name__ == "__main__":
    import tempfile

    with tempfile.TemporaryDirectory() as scratch:
        main(sys.argv[1], scratch)
