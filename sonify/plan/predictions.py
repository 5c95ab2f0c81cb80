"""PLAN -> ERRORS: predicted errors relative to accuracy "reference", and errors between sounds."""

from dataclasses import dataclass
from math import isfinite, pi
from typing import Literal

import numpy as np

from dynamics.film.activation import decide_film
from dynamics.quasi_steady import time_left
from dynamics.solver_settings import MIN_SOLVED_INCLINATION
from modal import Modes
from sonify.hearing.audio_source import source_of, stretch
from sonify.hearing.loudness import THRESHOLD_DB, WINDOW, a_weighting_db, band_levels
from sonify.hearing.spectrogram import spectrogram
from sonify.scene import Scene

Quantity = Literal["end", "frequencies", "sound"]


@dataclass(frozen=True, kw_only=True)
class Prediction:
    """Predicted error of a run relative to the same run at accuracy "reference".

    `key` identifies the quantity and `name` describes it. `error` is in `unit`; `source` states the
    basis of the prediction.
    """

    key: Quantity
    name: str
    error: float
    unit: str
    source: str


def predicted_end(scene: Scene, final_inclination: float) -> Prediction:
    """Return the time [s] by which a motion that settles stops too early."""
    name = "end of the motion, if the disk settles"
    if decide_film(scene).film:
        return Prediction(
            key="end",
            name=name,
            error=0.0,
            unit="s",
            source="the air carries the disk before its end, at a solved event",
        )
    left = [
        time_left(b, scene.disk, scene.friction, scene.dissipation)
        for b in (final_inclination, MIN_SOLVED_INCLINATION)
    ]
    early = left[0] - left[1] if isfinite(left[0]) else 0.0
    source = "quasi-steady decline of a steady disk"
    return Prediction(key="end", name=name, error=early, unit="s", source=source)


def predicted_frequencies(scene: Scene, modes: Modes) -> Prediction:
    """Return the median of the expected relative errors of the frequencies."""
    error = mode_frequency_error(scene, modes)
    return Prediction(
        key="frequencies",
        name="frequencies of the modes, median",
        error=float(np.median(error)) if len(error) else 0.0,
        unit="relative",
        source="the difference between two levels of the solver, times the share that is true "
        "for similar disks",
    )


def predicted_sound(scene: Scene, modes: Modes, loudness) -> Prediction:
    """Return the predicted relative error of the samples.

    It combines slightly detuned modes, weighted by their `loudness` (m,) [Pa^2 s], with the modes
    left out. Two decaying sines that start in phase differ by 2 D^2/(D^2 + 4 d^2) of their energy,
    where D is the difference of their frequencies [rad/s] and d their decay rate [1/s].
    """
    apart = 2 * pi * modes.frequency * mode_frequency_error(scene, modes)
    square = apart**2
    lost = 2 * np.divide(
        square, square + 4 * modes.decay_rate**2, out=np.zeros_like(square), where=square > 0
    )
    unheard = 10 ** (-scene.numerics.level.range_db / 10)
    return Prediction(
        key="sound",
        name="samples of the sound, A-weighted",
        error=float(np.sqrt((loudness @ lost) / (loudness.sum() or 1.0) + unheard)),
        unit="relative",
        source="modes with slightly different frequencies drift out of phase",
    )


def mode_frequency_error(scene: Scene, modes: Modes) -> np.ndarray:
    """Return the expected relative errors (m,) of the frequencies, a fraction of the estimates."""
    level = scene.numerics.level
    return modes.error * (
        level.held_error_share if scene.support.kind == "patch" else level.free_error_share
    )


def audible_error(sound, reference, weighted: bool = True) -> float:
    """Return the rms difference of two sources or files relative to the rms of the reference.

    Both are A-weighted if `weighted` is True. Zeros pad the shorter one. Raises ValueError if the
    sample rates differ.
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
    """Return the rms error of the third-octave levels over all windows, relative: 0.12 is 1 dB.

    Levels below the threshold of hearing (ISO 226) are raised to the threshold. Bands inaudible in
    both sounds are ignored.
    """
    a, b = (band_levels(spectrogram(source, WINDOW)) for source in (sound, reference))
    count = min(a.shape[1], b.shape[1])
    a, b = (np.maximum(levels[:, :count], THRESHOLD_DB[:, None]) for levels in (a, b))
    heard = np.maximum(a, b) > THRESHOLD_DB[:, None]
    return (
        float(np.sqrt(np.mean(np.square(a - b)[heard])) * np.log(10) / 20) if heard.any() else 0.0
    )
