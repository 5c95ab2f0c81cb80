"""How the face of a disk meets the table: at the end of a fall, or slowly on a film."""

from math import cos, sin, sqrt
from typing import NamedTuple

import numpy as np

from dynamics.disk import inertias
from dynamics.kinematics import contact_place
from dynamics.motion import Motion, MotionEvent, Outcome

MIN_FALL_SPEED = 2.5e-3
"""Smallest speed [m/s] of the face at the end of a fall.

A disk reaches it in a free fall of its centre by 0.1 um, the roughness of an ordinary
surface. A slower face sinks."""
FACE_EVENTS = {
    Outcome.FELL: "fell onto its face",
    Outcome.SANK: "sank onto its face",
}
"""Kind of the last event, by outcome."""


class Fall(NamedTuple):
    """Rotation of a disk about its contact towards its face.

    Attributes
    ----------
    speed
        Downward speed of the point of the face opposite to the contact [m/s].
    kinetic
        Kinetic energy of this rotation [J].
    potential
        Potential energy above that of a disk that lies flat [J].
    """

    speed: float
    kinetic: float
    potential: float


def final_fall(motion: Motion) -> Fall:
    """Return the fall of a disk in the last state of its motion."""
    disk = motion.disk
    inclination, nutation, slip = motion.state[-1, [1, 5, 9]]
    fillet = motion.rolling_fillet / disk.radius
    place = contact_place(cos(inclination), sin(inclination), disk.aspect, fillet)
    across = slip - place.e * disk.radius * nutation
    upwards = place.f * disk.radius * nutation
    inertia, _ = inertias(disk)
    squared_speed = across**2 + upwards**2
    return Fall(
        speed=float(disk.radius * (place.radius + 1 - fillet) * nutation),
        kinetic=float((disk.mass * squared_speed + inertia * nutation**2) / 2),
        potential=float(disk.weight * disk.radius * (place.e - disk.aspect)),
    )


def turn_in_last_decade(motion: Motion) -> float:
    """Return the precession [rad] in the last decade of the inclination.

    It is infinite if the inclination does not fall by a decade."""
    precession, inclination = motion.state[:, :2].T
    above = np.flatnonzero(inclination > 10 * inclination[-1])
    return float(abs(precession[-1] - precession[above[-1]])) if len(above) else np.inf


def outcome_when_flat(motion: Motion, turned: float) -> Outcome:
    """Return the outcome of a disk that lies flat at the end of its motion.

    `turned` is the precession [rad] during the last decade of the inclination. A disk
    that still precesses settles; any other disk falls or sinks.
    """
    min_settling_turn = 1.0  # rad
    if turned >= min_settling_turn:
        return Outcome.SETTLED
    return face_outcome(motion)


def face_outcome(motion: Motion) -> Outcome:
    """Return FELL or SANK, by the speed at which the face meets the table."""
    is_fast = final_fall(motion).speed >= MIN_FALL_SPEED
    return Outcome.FELL if is_fast else Outcome.SANK


def face_events(motion: Motion) -> tuple[MotionEvent, ...]:
    """Return the contact of the face with the table; empty if the face does not meet it.

    A fall converts the remaining potential energy. A disk that sinks keeps its speed.
    """
    if motion.rolling_outcome not in FACE_EVENTS:
        return ()
    fall = final_fall(motion)
    speed = max(fall.speed, 0.0)
    energy = fall.kinetic
    if motion.rolling_outcome is Outcome.FELL:
        energy += fall.potential
        speed *= sqrt(energy / fall.kinetic)
    kind = FACE_EVENTS[motion.rolling_outcome]
    return (MotionEvent(float(motion.t[-1]), kind, speed, energy),)
