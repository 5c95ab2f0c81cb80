"""Test oscillator steps that are long for the frequency, and frequencies around the
Nyquist frequency.

An oscillator fails if it grows or if its pitch is wrong by a quarter tone. It is
degraded if the mistuning is audible."""

import math

import numpy as np

from benchmarks.methods.oscillator_steps import STEPS, growth_and_tuning, static_gain
from benchmarks.timed_runs import Record
from sonify.sound.oscillators import OscillatorBank

OUR_STEP = "exact, first-order hold"

DAMPING_RATIO = 1e-4
"""Damping ratio of the oscillators, as of steel."""

AUDIBLE_MISTUNING = 5.0
"""Smallest audible difference of pitch [cents]."""

MAX_MISTUNING = 50.0
"""Largest mistuning [cents], half a semitone; a method with a larger one fails."""

MAX_STEP_GROWTH = 1e-9
"""Largest relative growth in one step attributed to round-off."""

MAX_STATIC_ERROR = 0.3
"""Largest relative error of the static response, about 3 dB; a method with a larger one
fails."""

LONG_STEPS = (0.03, 0.1, 0.2, 0.4, 0.8, 1.2, 1.6, 1.98, 2.02, 2.4, 2.8, 2.86, 3.1)
"""Products of step and angular frequency; pi corresponds to half the sample rate."""

RELATIVE_FREQUENCIES = (0.2, 0.3, 0.4, 0.45, 0.49, 0.51, 0.55, 0.6, 0.7, 0.8)
"""Frequencies divided by the sample rate."""

SAMPLED_METHODS = (OUR_STEP, "impulse-invariant", "bilinear", "exact, zero-order hold")


def records() -> list[Record]:
    """Return one record per method and parameter value, computed from the step matrices
    without timing."""
    long_steps = [
        _long_step(name, x)
        for name in STEPS
        if "zero-order" not in name
        for x in LONG_STEPS
    ]
    near_nyquist = [
        _near_nyquist(name, frequency)
        for name in SAMPLED_METHODS
        for frequency in RELATIVE_FREQUENCIES
    ]
    return long_steps + near_nyquist


def _labels(name, hazard, x):
    family = "ours" if name == OUR_STEP else "oscillator"
    return {"family": family, "method": name, "setting": f"{x:g}", "case": hazard}


def _long_step(name, x) -> Record:
    """Return the record of a step of length 1 at the angular frequency x; its error is
    the mistuning [cents]."""
    w = np.array([x])
    relative_growth, tuning = (
        float(value[0])
        for value in growth_and_tuning(STEPS[name], w, DAMPING_RATIO * w, 1.0)
    )
    growth = relative_growth * math.exp(-DAMPING_RATIO * x)
    cents = _cents(tuning)
    failure = ""
    if growth > 1 + MAX_STEP_GROWTH:
        failure = f"grows by {20 * math.log10(growth):.2g} dB a step"
    elif abs(cents) > MAX_MISTUNING:
        failure = f"out of tune by {cents:.0f} cents"
    return Record(**_labels(name, "long steps", x), error=abs(cents), failure=failure)


def _near_nyquist(name, frequency) -> Record:
    """Return the record of an oscillator at a frequency relative to the sample rate,
    with the error of its static gain."""
    labels = _labels(name, "near half the sample rate", frequency)
    w = np.array([2 * math.pi * frequency])
    if name == OUR_STEP and _is_rejected(frequency):
        return Record(**labels, error=0.0)
    tuning = float(growth_and_tuning(STEPS[name], w, DAMPING_RATIO * w, 1.0)[1][0])
    gain = float(static_gain(STEPS[name], w, DAMPING_RATIO * w, 1.0)[0])
    failure = ""
    if abs(_cents(tuning)) > MAX_MISTUNING:
        failure = f"sounds at {tuning * frequency:.2g} of the sample rate"
    elif abs(gain - 1) > MAX_STATIC_ERROR:
        failure = f"answers a steady force {gain:.2g} times as much"
    return Record(**labels, error=abs(gain - 1), failure=failure)


def _is_rejected(frequency) -> bool:
    """Return True if the oscillator bank rejects a mode of this frequency, which must
    then be omitted."""
    try:
        OscillatorBank([frequency], [0.0], 1.0)
    except ValueError:
        return True
    return False


def _cents(ratio):
    return 1200 * math.log2(ratio) if ratio else -math.inf
