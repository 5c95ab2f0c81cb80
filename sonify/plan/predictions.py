"""Predicted errors of a run relative to accuracy "reference"."""

from dataclasses import dataclass
from math import pi
from typing import Literal

import numpy as np

from dynamics import MotionPlan
from modal import Modes
from sonify.scene import Scene

Quantity = Literal["end", "frequencies", "sound"]


@dataclass(frozen=True, kw_only=True)
class Prediction:
    """Predicted error of a run relative to the same run at accuracy "reference".

    `key` identifies the quantity and `name` describes it. `error` is in `unit`;
    `source` states the basis of the prediction."""

    key: Quantity
    name: str
    error: float
    unit: str
    source: str


def predicted_end_error(motion: MotionPlan) -> Prediction:
    """Return the predicted error of the end of a motion [s]."""
    if motion.contact.kind == "many" and motion.scene.roughness:
        source = "the end of a rattling motion is chaotic: it varies by 2 % with the time step"
    elif motion.film:
        source = (
            "the motion ends at a solved event, when the air begins to carry the disk"
        )
    else:
        source = "quasi-steady decay of steady motion"
    return Prediction(
        key="end",
        name="end of the motion, if the disk settles",
        error=motion.predicted_end_error,
        unit="s",
        source=source,
    )


def predicted_frequency_error(scene: Scene, modes: Modes) -> Prediction:
    """Return the predicted median of the relative errors of the mode frequencies."""
    error = mode_frequency_error(scene, modes)
    return Prediction(
        key="frequencies",
        name="frequencies of the modes, median",
        error=float(np.median(error)) if len(error) else 0.0,
        unit="relative",
        source="a fraction of the difference between two levels of the solver, calibrated on "
        "similar disks",
    )


def predicted_sound_error(
    scene: Scene, modes: Modes, loudness: np.ndarray
) -> Prediction:
    """Return the predicted relative error of the samples.

    It combines the errors due to slightly detuned modes, weighted by their `loudness`
    (m,) [Pa^2 s], and due to omitted modes. The difference of two decaying sines that
    start in phase has the energy 2 D^2/(D^2 + 4 d^2) relative to one of them, where D
    is the difference of their frequencies [rad/s] and d their decay rate [1/s]."""
    detuning = 2 * pi * modes.frequency * mode_frequency_error(scene, modes)
    square = detuning**2
    lost = 2 * np.divide(
        square,
        square + 4 * modes.decay_rate**2,
        out=np.zeros_like(square),
        where=square > 0,
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
    """Return the expected relative errors (m,) of the frequencies, fractions of the
    estimated errors."""
    level = scene.numerics.level
    share = {
        "patch": level.held_error_share,
        "free": level.free_error_share,
        "contact": level.sprung_error_share,
    }
    return modes.error * share[scene.support.kind]
