"""Level error of one-way coupling, measured after a run and compared with the plan."""

from dataclasses import replace
from typing import Any

import numpy as np
from scipy.signal import welch

from dynamics import Motion
from dynamics.compliant.law.two_way_criterion import (
    coupling_error,
    level_weight,
    table_acceleration,
)
from sonify.claims.contact import contact_conditions
from sonify.claims.finding import Measured, finding
from sonify.claims.table_power import LEAD_TIME, intervals, one_way_end
from sonify.scene import Scene
from sonify.sound.sources.contact import ContactFilter

SAMPLE_RATE = 96_000
"""Rate [Hz] at which the force is solved with and without the table."""


@finding(needs=("scene", "motion", "contact law"), at_least=-3.0, at_most=3.0)
def coupling_error_is_predicted(scene: Scene, motion: Motion) -> Measured:
    """The measured minus the predicted level error [dB] of one-way coupling.

    In several intervals of the motion, the filter is solved with the table and on a
    rigid one. The level is that of the modal accelerations of the table, as in the
    plan; the value is the median difference."""
    spans = intervals(min(one_way_end(motion), motion.t[-1]))[1::2]
    measured = np.array([measured_error(scene, motion, *span) for span in spans])
    predicted = np.array([predicted_error(scene, motion, *span) for span in spans])
    difference = measured - predicted
    details = {
        "measured": float(np.median(measured)),
        "predicted": float(np.median(predicted)),
    }
    scatter = 2 * difference.std(ddof=1) / np.sqrt(len(spans))
    return Measured(float(np.median(difference)), float(scatter), details)


def measured_error(scene: Scene, motion: Motion, begin: float, end: float) -> float:
    """Return the level on a rigid table minus that on the yielding one [dB], in an
    interval [s]."""
    variant: Any = motion  # a dataclass
    one_way = replace(variant, plan=replace(motion.plan, rough_table=None))
    levels = []
    for solved in (one_way, motion):
        force = vibration(scene, solved, begin, end)
        levels.append(table_level(motion, force))
    return levels[0] - levels[1]


def vibration(scene: Scene, motion: Motion, begin: float, end: float) -> np.ndarray:
    """Return the vibration (k,) [N] of the normal force in an interval [s]."""
    first = max(begin - LEAD_TIME, 0.0)
    added = ContactFilter.along(motion, scene, SAMPLE_RATE, first)
    skipped = round((begin - first) * SAMPLE_RATE)
    count = round((end - begin) * SAMPLE_RATE)
    force = np.zeros(0)
    for block in added.blocks():
        force = np.append(force, block[:, 1])
        if len(force) >= skipped + count:
            break
    return force[skipped : skipped + count]


def table_level(motion: Motion, force: np.ndarray) -> float:
    """Return the A-weighted level [dB] of the modal accelerations under a force (k,)."""
    frequency, power = welch(force, SAMPLE_RATE, nperseg=len(force) // 4)
    moved = table_acceleration(motion.plan.contact_receptance, 2 * np.pi * frequency)
    heard = moved * level_weight(frequency)
    return float(10 * np.log10(heard @ power))


def predicted_error(scene: Scene, motion: Motion, begin: float, end: float) -> float:
    """Return the predicted level error [dB] in the middle of an interval [s]."""
    law = motion.plan.tabulated_law
    assert law is not None  # the contact is elastic
    assert scene.roughness is not None
    middle = np.array([(begin + end) / 2])
    inclination, load, speed, _ = contact_conditions(motion, middle)
    found = coupling_error(
        law,
        scene.roughness,
        float(inclination[0]),
        float(load[0]),
        float(speed[0]),
        motion.plan.contact_receptance,
    )
    return found.level
