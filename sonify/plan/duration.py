"""Predicted duration of a run."""

from math import inf, isfinite, radians
from typing import NamedTuple

from dynamics import MotionPlan
from dynamics.motion_plan import rattling_end_error
from sonify.scene import Scene


class RunCosts(NamedTuple):
    """Measured times [s] on two idle cores, by which the duration of a run is predicted."""

    start_and_page: float = 3.0
    """Imports, modes, findings and page."""
    sound: float = 0.07
    """Per second of sound."""
    contact_sound: float = 0.2
    """Per second of the sound of an elastic contact, in addition."""
    table_sound: float = 0.3
    """Per second of the sound of a table, in addition."""
    mesh: float = 25.0
    """Modes of a meshed table."""
    step: float = 3e-6
    """Per time step of a contact."""
    coupled_step: float = 25e-6
    """Per time step of a disk coupled to a table, with the repetitions of its end."""
    coupled_end: float = 30.0
    """End of a motion that may couple to a table, with its repetitions."""


def predicted_run_seconds(scene: Scene, motion: MotionPlan) -> float:
    """Return the predicted duration of a run [s] on two idle cores.

    Motions of the shipped scenes take 0.3 to 1 times their quasi-steady prediction, and
    compilations come in addition.
    """
    costs = RunCosts()
    seconds = predicted_motion_seconds(motion)
    per_second = costs.sound
    if motion.tabulated_law is not None:
        per_second += costs.contact_sound
    if scene.surface.kind != "rigid":
        per_second += costs.table_sound
    predicted = costs.start_and_page + per_second * seconds
    if scene.surface.kind == "mesh":
        predicted += costs.mesh
    if motion.may_be_two_way and scene.surface.action == "motion":
        return predicted + costs.coupled_step * motion.step_rate * seconds
    if motion.may_be_two_way:
        predicted += costs.coupled_end
    return predicted + costs.step * motion.step_rate * seconds


def predicted_motion_seconds(motion: MotionPlan) -> float:
    """Return a rough prediction of the duration of a motion [s]."""
    scene = motion.scene
    if motion.contact.kind == "many" and scene.roughness:
        relative_scatter = 0.02  # of `rattling_end_error`
        predicted = rattling_end_error(scene) / relative_scatter
    else:
        typical_share = 0.7  # of the quasi-steady duration; slips and air shorten it
        predicted = typical_share * _quasi_steady_seconds(motion)
    return min(predicted, scene.numerics.time_limit)


def _quasi_steady_seconds(motion: MotionPlan) -> float:
    """Return the duration of quasi-steady motion [s] from the release, or from a smaller
    inclination if the disk is released too steeply for it; infinite without losses."""
    released = radians(motion.scene.release.inclination_deg)
    max_steady_inclination = 0.3  # rad
    for inclination in (released, min(released, max_steady_inclination)):
        try:
            seconds = motion.time_to_flat(inclination)
        except ValueError:  # too steep or too thick
            continue
        if isfinite(seconds):
            return seconds
    return inf
