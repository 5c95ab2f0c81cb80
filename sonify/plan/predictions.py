"""PLAN -> ERRORS: how far a run will be from the same one at accuracy "reference", and how far
apart sounds are."""

from dataclasses import dataclass
from math import isfinite, pi

import numpy as np

from dynamics.film.activation import decide_film
from dynamics.quasi_steady import time_left
from dynamics.solver_settings import MIN_SOLVED_INCLINATION
from modal import Modes
from sonify.hearing.audio_source import source_of, stretch
from sonify.hearing.loudness import THRESHOLD_DB, WINDOW, a_weighting_db, band_levels
from sonify.hearing.spectrogram import spectrogram
from sonify.scene import Scene

END = "the end of the motion, if the disk settles"
FREQUENCIES = "frequencies of the modes, median"
SOUND = "samples of the sound, A-weighted"


@dataclass(frozen=True, kw_only=True)
class Prediction:
    """How far a run will be from the same one at accuracy "reference": `error` in `unit`; `source`
    says how we know."""

    name: str
    error: float
    unit: str
    source: str


def predicted_end(scene: Scene, final_inclination: float) -> Prediction:
    """By how much a motion that settles stops too early."""
    if decide_film(scene).film:
        return Prediction(
            name=END,
            error=0.0,
            unit="s",
            source="the air carries the disk before: that is an event",
        )
    left = [
        time_left(b, scene.disk, scene.friction, scene.dissipation)
        for b in (final_inclination, MIN_SOLVED_INCLINATION)
    ]
    early = left[0] - left[1] if isfinite(left[0]) else 0.0
    return Prediction(
        name=END, error=early, unit="s", source="quasi-steady decline of a steady disk"
    )


def predicted_frequencies(scene: Scene, modes: Modes) -> Prediction:
    """The median of the expected relative errors of the frequencies."""
    error = true_error(scene, modes)
    return Prediction(
        name=FREQUENCIES,
        error=float(np.median(error)) if len(error) else 0.0,
        unit="relative",
        source="the distance between two levels of the solver, times what of it is true on disks "
        "like these",
    )


def predicted_sound(scene: Scene, modes: Modes, loudness) -> Prediction:
    """The distance of two sounds of modes that are a little out of tune, as loud as `loudness`
    (m,), plus what is left out.

    Two decaying sines that start together differ by 2 D^2/(D^2 + 4 d^2) of their energy, D the
    difference of their frequencies [rad/s], d their decay rate."""
    apart = 2 * pi * modes.frequency * true_error(scene, modes)
    square = apart**2
    lost = 2 * np.divide(
        square, square + 4 * modes.decay_rate**2, out=np.zeros_like(square), where=square > 0
    )
    unheard = 10 ** (-scene.numerics.level.range_db / 10)
    return Prediction(
        name=SOUND,
        error=float(np.sqrt((loudness @ lost) / (loudness.sum() or 1.0) + unheard)),
        unit="relative",
        source="the modes, if they are what is heard, drift out of step where their frequencies "
        "differ",
    )


def true_error(scene: Scene, modes: Modes) -> np.ndarray:
    """Return the expected relative errors (m,) of the frequencies, from the estimated ones."""
    level = scene.numerics.level
    return modes.error * (
        level.held_error_share if scene.support.kind == "patch" else level.free_error_share
    )


def audible_error(sound, reference, weighted: bool = True) -> float:
    """Return the root mean square of the difference of two sources or files over that of the
    reference, A-weighted or not.

    The shorter one is followed by silence. Raises ValueError where their sample rates differ.
    """
    one = source_of(sound)
    true = source_of(reference)
    if one.sample_rate != true.sample_rate:
        raise ValueError(f"sample rates differ: {one.sample_rate} Hz and {true.sample_rate} Hz")
    a, b = (stretch(source, 0, source.frames)[:, 0].astype(float) for source in (one, true))
    size = max(len(a), len(b))
    weight = (
        10 ** (a_weighting_db(np.fft.rfftfreq(size, 1 / one.sample_rate)) / 20) if weighted else 1.0
    )
    spectrum = np.fft.rfft(b, size)
    apart = np.linalg.norm(weight * (np.fft.rfft(a, size) - spectrum))
    return float(apart / (np.linalg.norm(weight * spectrum) or 1.0))


def level_error(sound, reference) -> float:
    """Return the root mean square error of the levels of third octaves, window by window, relative:
    0.12 is 1 dB.

    Levels below the threshold of hearing (ISO 226) count as at the threshold; what is heard in
    neither does not count."""
    a, b = (band_levels(spectrogram(source, WINDOW)) for source in (sound, reference))
    count = min(a.shape[1], b.shape[1])
    a, b = (np.maximum(levels[:, :count], THRESHOLD_DB[:, None]) for levels in (a, b))
    heard = np.maximum(a, b) > THRESHOLD_DB[:, None]
    return (
        float(np.sqrt(np.mean(np.square(a - b)[heard])) * np.log(10) / 20) if heard.any() else 0.0
    )
