"""Count misses and false alarms of the detector of settling disks: python
benchmarks/ear.py FOLDER | --coverage

Every sound file below FOLDER counts by the class at the end of its name
("1-17150-A-010-Fire_crackling.flac"), or by its folder; simulated takes and imitations
of `settling_sounds` are added. The interval of each share is the 95 % one of Wilson.

With --coverage instead of a folder, it counts how often the intervals of exponent, end
and rate contain the truth of simulated takes, on the half that calibrated them and on
the other half.

The rate of false alarms is that of surrogates of the files without a disk (those with a
class): blocks of 0.1 s in random order, and random phases of the spectrum. The
thresholds were fixed on surrogates, not on the files themselves."""

import sys
from collections import defaultdict
from pathlib import Path

import numpy as np
import soundfile
from scipy.fft import irfft, rfft
from scipy.stats import chi2

sys.path.insert(0, str(Path(__file__).parents[1] / "tests" / "helpers"))
import settling_sounds

from sonify.claims.shares import share_of_count
from sonify.hearing.audio_source import source_of
from sonify.hearing.settling.detector import settling_runs

SOUND_FILE_SUFFIXES = {".flac", ".wav", ".ogg", ".aiff"}
TAKE_SEEDS = range(200, 213)


def is_classed(path):
    """Return True if the name of a sound file ends with the class of its sound."""
    return path.suffix.lower() in SOUND_FILE_SUFFIXES and path.stem.count("-") > 2


def share(count, of):
    """Return a text with a count and the 95 % interval of its percentage."""
    wilson = share_of_count(count, of)
    interval = f"{100 * wilson.low:5.1f} to {100 * wilson.high:5.1f} %"
    return f"{count:4d} of {of:3d}  {interval}"


def simulated(sample, folder):
    """Return the number of runs detected in samples that are written to a file in a
    folder."""
    path = Path(folder) / "sound.wav"
    soundfile.write(path, np.asarray(sample), settling_sounds.RATE, "FLOAT")
    return len(settling_runs(source_of(path)))


def block_shuffled(samples, rate, rng):
    """Return samples (n,) in blocks of 0.1 s in random order."""
    size = int(0.1 * rate)
    blocks = samples[: len(samples) // size * size].reshape(-1, size)
    return rng.permutation(blocks).ravel()


def phase_randomised(samples, rate, rng):
    """Return samples (n,) of the same spectrum with random phases, under the same
    envelope."""
    spectrum = rfft(samples)
    noise = irfft(
        np.abs(spectrum) * np.exp(2j * np.pi * rng.random(len(spectrum))), len(samples)
    )
    window = np.hanning(int(0.05 * rate))
    power = [np.convolve(np.square(x), window, "same") for x in (samples, noise)]
    return noise * np.sqrt(power[0] / np.maximum(power[1], 1e-12))


def false_alarms(paths, scratch, count=4):
    """Print the false alarms per hour in surrogates of files, with the 95 % Poisson
    interval."""
    path = Path(scratch) / "surrogate.wav"
    surrogates = (
        {"shuffled": block_shuffled, "random phases": phase_randomised} if paths else {}
    )
    for name, surrogate in surrogates.items():
        scores = []
        hours = 0.0
        for number, file in enumerate(paths):
            samples, rate = soundfile.read(file, always_2d=True)
            for seed in range(count):
                rng = np.random.default_rng((seed, number))
                made = surrogate(samples[:, 0], rate, rng)
                soundfile.write(path, made, rate, "FLOAT")
                scores += [run.score for run in settling_runs(source_of(path))]
                hours += len(made) / rate / 3600
        low = chi2.ppf(0.025, 2 * len(scores)) / 2 / hours if scores else 0.0
        high = chi2.ppf(0.975, 2 * len(scores) + 2) / 2 / hours
        heard = ", ".join(f"{score:.1f}" for score in sorted(scores))
        print(
            f"{name}: {len(scores)} in {hours:.2f} h, {len(scores) / hours:.1f} per hour "
            f"({low:.1f} to {high:.1f}) {heard}"
        )


def coverage(scratch):
    """Print how often the intervals of 400 simulated takes contain the truth."""
    path = Path(scratch) / "take.wav"
    for name, seeds in {"calibrating": range(200), "other": range(200, 400)}.items():
        inside = []
        for seed in seeds:
            take = settling_sounds.simulated_take(seed)
            soundfile.write(path, take.samples, settling_sounds.RATE, "FLOAT")
            runs = settling_runs(source_of(path))
            best = max(runs, key=lambda run: run.score, default=None)
            inside += [settling_sounds.intervals_hold(take, best)] if best else []
        print(f"{name} half: {len(inside)} of {len(seeds)} heard")
        for quantity, count in zip(
            ("n", "end", "rate"), np.sum(inside, axis=0), strict=True
        ):
            print(f"  {quantity:5s} {share(int(count), len(inside))}")


def main(folder, scratch):
    """Print the table of a folder of recordings."""
    counts = defaultdict(list)
    for path in sorted(Path(folder).rglob("*")):
        if path.suffix.lower() in SOUND_FILE_SUFFIXES:
            kind = path.stem.split("-")[-1] if is_classed(path) else path.parent.name
            counts[kind].append(len(settling_runs(source_of(path))))
    for name, imitation in settling_sounds.IMITATIONS.items():
        counts[f"imitation: {name}"] = [
            simulated(imitation(seed), scratch) for seed in TAKE_SEEDS
        ]
    for seed in range(400, 440):
        take = settling_sounds.simulated_take(seed)
        counts[f"simulated: {take.kind}"].append(simulated(take.samples, scratch))
    false_alarms(
        [path for path in sorted(Path(folder).rglob("*")) if is_classed(path)], scratch
    )
    print(f"{'kind':30s} runs  sounds with a run, 95 %")
    for kind, runs in sorted(counts.items()):
        heard = int(np.count_nonzero(runs))
        print(f"{kind:30s} {sum(runs):4d}  {share(heard, len(runs))}")


if __name__ == "__main__":
    import tempfile

    with tempfile.TemporaryDirectory() as scratch:
        if sys.argv[1] == "--coverage":
            coverage(scratch)
        else:
            main(sys.argv[1], scratch)
