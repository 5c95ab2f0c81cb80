"""Where methods fail: every method, finely set, on what makes it hard for a motion and for an oscillator.

An oscillator fails that grows, or that is out of tune by more than CENTS, which is what can be heard.
"""

from functools import partial

import numpy as np

from sonify.charts import event_driven
from sonify.charts.moreau import moreau
from sonify.charts.motion_case import pivoting, published, sticking, strong
from sonify.charts.naive import naive_sign
from sonify.charts.records import Record, Work, measure
from sonify.charts.regularised import tanh_regularised
from sonify.charts.slip_tolerance import slip_tolerance
from sonify.charts.sound import OURS
from sonify.charts.sound_case import RATE
from sonify.charts.steps import STEPS, first_order_hold, growth_and_tuning

HAZARDS = {
    "easy: rolls": published(1.0),
    "slips begin, end": published(50.0),
    "nutation sticks": sticking(40.0),
    "sticks early": strong(5.0),
    "pivoting sticks": pivoting(30.7),
}
"""What makes a motion hard, by name."""
PITCHES = {"0.02 fs": 0.02, "0.1 fs": 0.1, "0.25 fs": 0.25, "0.4 fs": 0.4, "0.49 fs": 0.49}
"""Frequencies of oscillators, as parts of the sample rate fs."""
DAMPING = 1e-4
"""Damping ratio of the oscillators, that of steel."""
CENTS = 5.0
"""The least difference of pitch that is heard [cents, 1200 to the octave]."""
GROWTH = 1e-9
"""Growth in one step that rounding may cause."""
METHODS = {
    ("event-driven", "Taylor (heyoka)", "tol 1e-16"): (event_driven.ours, "taylor", 1e-16),
    ("event-driven", "our DOP853", "tol 1e-12"): (event_driven.ours, "dop853", 1e-12),
    ("event-driven", "our DOP853", "tol 1e-7"): (event_driven.ours, "dop853", 1e-7),
    ("event-driven", "solve_ivp DOP853", "tol 1e-12"): (event_driven.with_solve_ivp, "DOP853", 1e-12),
    ("event-driven", "solve_ivp DOP853", "tol 1e-6"): (event_driven.with_solve_ivp, "DOP853", 1e-6),
    **{("naive sign()", m, "tol 1e-8"): (naive_sign, m, 1e-8) for m in ("RK45", "DOP853", "LSODA", "Radau", "BDF")},
    ("slip tolerance", "DOP853", "1e-4"): (slip_tolerance, 1e-4, 1e-4, 0.01, 1e-9),
    ("slip tolerance", "DOP853", "1e-12"): (slip_tolerance, 1e-5, 1e-12, 0.1, 1e-6),
    ("tanh", "LSODA", "width 1e-3"): (tanh_regularised, "LSODA", 1e-3, 1e-6),
    ("tanh", "LSODA", "width 1e-6"): (tanh_regularised, "LSODA", 1e-6, 1e-9),
    ("Moreau", "time-stepping", "step 1e-2"): (moreau, 1e-2),
    ("Moreau", "time-stepping", "step 1e-3"): (moreau, 1e-3),
}
"""Family, method and setting, and the call that takes a case first."""


def run(quick: bool, watch=lambda share, note: None) -> list[Record]:
    """Return the records of the map; `quick` leaves the long motions out."""
    hazards = [name for name in HAZARDS if not (quick and HAZARDS[name].span > 10)]
    records = []
    for i, (about, (function, *arguments)) in enumerate(METHODS.items()):
        for j, name in enumerate(hazards):
            watch((i + j / len(hazards)) / len(METHODS), f"{', '.join(about)}: {name}")
            case = HAZARDS[name]
            records.append(measure(Work(*about, name, partial(function, case, *arguments), case.error), repeats=1))
    return records + oscillators()


def oscillators() -> list[Record]:
    """Return one record per method and pitch: error is the mistuning, failure growth or what is heard of it."""
    steps = {name: step for name, step in STEPS.items() if "zero-order" not in name} | {OURS: first_order_hold}
    return [_oscillator(name, step, pitch, share) for name, step in steps.items() for pitch, share in PITCHES.items()]


def _oscillator(name, step, pitch, share) -> Record:
    w = np.array([2 * np.pi * share * RATE])
    relative, tuning = (x[0] for x in growth_and_tuning(step, w, DAMPING * w, 1 / RATE))
    growth = relative * np.exp(-DAMPING * w[0] / RATE)
    cents = 1200 * np.log2(tuning) if tuning else -np.inf
    failure = ""
    if growth > 1 + GROWTH:
        failure = f"grows by {20 * np.log10(growth):.2g} dB a step"
    elif abs(cents) > CENTS:
        failure = f"out of tune by {cents:.0f} cents"
    return Record(
        family="oscillator", method=name, setting=f"{RATE} Hz", case=pitch, error=abs(tuning - 1), failure=failure
    )


def draw(records: list[Record], title: str, path):
    """Draw the map."""
    from sonify.charts.pictures import draw_map

    draw_map(records, title, path)


def conclusion(records: list[Record]) -> list[str]:
    """Return what fails nowhere, and how often the others fail."""
    lines = []
    for about in dict.fromkeys((r.family, r.method, r.setting) for r in records):
        runs = [r for r in records if (r.family, r.method, r.setting) == about]
        failed = [r.case for r in runs if r.failure]
        lines.append(f"{', '.join(about)}: " + (f"fails at {'; '.join(failed)}." if failed else "fails nowhere."))
    return lines
