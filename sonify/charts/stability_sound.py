"""Where oscillators fail: steps too long for their frequency, frequencies about half the sample rate.

An oscillator fails that grows, or that sounds another note; out of tune by more than is heard it is degraded.
"""

import math

import numpy as np

from sonify.charts.records import Record
from sonify.charts.steps import STEPS, growth_and_tuning, static_gain
from sonify.sound.oscillators import OscillatorBank

OURS = "exact, first-order hold"
DAMPING = 1e-4
"""Damping ratio of the oscillators, that of steel."""
HEARD = 5.0
"""The least difference of pitch that is heard [cents, 1200 to the octave]."""
ANOTHER_NOTE = 50.0
"""Half a semitone [cents]."""
GROWTH = 1e-9
"""Growth in one step that rounding may cause."""
WEAK = 0.3
"""Relative error of the static response, some 3 dB, above which a mode is not the one that was asked for."""
LONG_STEPS = (0.03, 0.1, 0.2, 0.4, 0.8, 1.2, 1.6, 1.98, 2.02, 2.4, 2.8, 2.86, 3.1)
"""Step times angular frequency; half the sample rate is at pi."""
PITCHES = (0.2, 0.3, 0.4, 0.45, 0.49, 0.51, 0.55, 0.6, 0.7, 0.8)
"""Frequencies over the sample rate."""
SAMPLED = (OURS, "impulse-invariant", "bilinear", "exact, zero-order hold")


def records() -> list[Record]:
    """Return one record per method and parameter; nothing of it takes time."""
    stepped = [_stepped(name, x) for name in STEPS if "zero-order" not in name for x in LONG_STEPS]
    return stepped + [_sampled(name, share) for name in SAMPLED for share in PITCHES]


def _about(name, hazard, x):
    family, method = ("ours", name) if name == OURS else ("oscillator", name)
    return {"family": family, "method": method, "setting": f"{x:g}", "case": hazard}


def _stepped(name, x) -> Record:
    """Judge a step of length 1 at the angular frequency x: error is the mistuning [cents]."""
    w = np.array([x])
    grown, tuning = (float(value[0]) for value in growth_and_tuning(STEPS[name], w, DAMPING * w, 1.0))
    growth, cents, failure = grown * math.exp(-DAMPING * x), _cents(tuning), ""
    if growth > 1 + GROWTH:
        failure = f"grows by {20 * math.log10(growth):.2g} dB a step"
    elif abs(cents) > ANOTHER_NOTE:
        failure = f"out of tune by {cents:.0f} cents"
    return Record(**_about(name, "long steps", x), error=abs(cents), failure=failure)


def _sampled(name, share) -> Record:
    """Judge an oscillator at `share` of the sample rate: error is that of its response to a force at rest."""
    about, w = _about(name, "near half the sample rate", share), np.array([2 * math.pi * share])
    if name == OURS and _refused(share):
        return Record(**about, error=0.0)
    tuning = float(growth_and_tuning(STEPS[name], w, DAMPING * w, 1.0)[1][0])
    gain = float(static_gain(STEPS[name], w, DAMPING * w, 1.0)[0])
    failure = ""
    if abs(_cents(tuning)) > ANOTHER_NOTE:
        failure = f"sounds at {tuning * share:.2g} of the sample rate"
    elif abs(gain - 1) > WEAK:
        failure = f"answers a steady force {gain:.2g} times as much"
    return Record(**about, error=abs(gain - 1), failure=failure)


def _refused(share) -> bool:
    """Tell whether the bank refuses a mode of this frequency, so that whoever drives it must leave the mode out."""
    try:
        OscillatorBank([share], [0.0], 1.0)
    except ValueError:
        return True
    return False


def _cents(ratio):
    return 1200 * math.log2(ratio) if ratio else -math.inf
