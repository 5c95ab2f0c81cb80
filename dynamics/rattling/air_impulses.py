"""Impulses of the air film under a rattling disk, at its present gap and tilt.

A drag opposes the precession. The resistance to heave and tilt is that of a force and of
a moment which each oppose one velocity: that of the face at the centre of pressure of a
heaving disk, and the tilting about it. The compressed air exerts no pressure when it
stores no energy.
"""

from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from dynamics.film.film_kernels import (
    compressed_air_impulse,
    film_capacity,
    film_loads,
    open_film,
)
from dynamics.numba_kernels import kernel
from dynamics.rattling.body import PressedDisk, RimGeometry, Velocities, add_force
from dynamics.rattling.layout import FILM, RECORD, RattlingDisk
from dynamics.stepping_core.vectors import cross, dot, plus, times

if TYPE_CHECKING:
    from dynamics.stepping_core.vectors import AnyVector, Triple


class FilmLoad(NamedTuple):
    """Mean loads of the film in a step.

    Attributes
    ----------
    pressure : float
        Force along the axis [N].
    place : float
        Distance [m] of this force from the axis, up the slope of the face.
    righting : float
        Torque [N m] about the horizontal diameter that raises the high side.
    drag : float
        Torque [N m] about the direction up the slope.
    work : float
        Work [J] of the compressed air.
    """

    pressure: float
    place: float
    righting: float
    drag: float
    work: float


@kernel
def film_load(
    disk: RattlingDisk,
    axis: "AnyVector",
    up_slope: "AnyVector",
    velocity: Velocities,
    clearance: float,
    stored_energy: float,
    step: float,
) -> FilmLoad:
    """Return the `FilmLoad` in a step with an energy [J] stored in the compressed air.

    `disk` is a `RattlingDisk`, `axis` (3,) the unit vector along its axis, `up_slope` that
    up its slope, whose height is the sine of the inclination, and `clearance` [m] the
    height of the low point of the rim. The laws of the closed wedge, for wall slip,
    inertia, compression and a concave table, are those at the same mean gap.
    """
    min_rate = 1e-9  # rad/s; the drag of slower precession is independent of the rate
    sine = up_slope[2]
    gap = sine + clearance / disk.radius  # mean gap over the radius
    spin = velocity.angular
    turning = dot(spin, up_slope)
    rate = abs(turning) / sine + min_rate
    drag, fall, _, tip, lift = film_loads(disk.film, gap, rate)
    _, _, closed_fall, closed_across = open_film(1.0)
    eps = sine / gap
    heave, about, falling, across = open_film(eps)
    # exponential damping is stable at every gap
    inertia = disk.diametral_inertia
    turned = drag / (rate * gap) * across / closed_across
    torque = turning * inertia / step * np.expm1(-step * turned / inertia)
    scale = fall / closed_fall  # N m s
    radius = disk.radius
    place = radius * (about / heave - 1)
    speed = normal_speed(disk, axis, up_slope, velocity, place)
    mobility = normal_mobility(disk, place)
    resisted = scale * heave / radius**2
    pressure = speed / (mobility * step) * np.expm1(-step * resisted * mobility)
    moment = pressure * place
    tilting = dot(spin, cross(up_slope, axis)) + step * moment / inertia
    resisted = scale * (falling - about**2 / heave)
    righting = tilting * inertia / step * np.expm1(-step * resisted / inertia)
    work = 0.0
    if lift > 0:
        # the pressure of the compressed air vanishes with the square of the tilt
        lift *= eps * eps
        place = radius * tip / lift * eps * eps - radius
        speed = normal_speed(disk, axis, up_slope, velocity, place)
        mobility = normal_mobility(disk, place)
        impulse, work = compressed_air_impulse(
            step * lift / radius, speed, mobility, stored_energy
        )
        pressure += impulse / step
        moment += impulse / step * place
    place = moment / pressure if pressure != 0 else 0.0
    return FilmLoad(pressure, place, righting, torque, work)


@kernel
def point_on_face(
    disk: RattlingDisk, axis: "AnyVector", up_slope: "AnyVector", place: float
) -> "Triple":
    """Return the vector [m] from the centre to a point on the lower face.

    The point is at the distance `place` [m] from the axis, up the slope.
    """
    return plus(times(place, up_slope), times(-disk.half_thickness, axis))


@kernel
def normal_speed(
    disk: RattlingDisk,
    axis: "AnyVector",
    up_slope: "AnyVector",
    velocity: Velocities,
    place: float,
) -> float:
    """Return the velocity along the axis [m/s] of `point_on_face`."""
    x, y, z = point_on_face(disk, axis, up_slope, place)
    linear = velocity.linear
    spin = velocity.angular
    speed = axis[0] * (linear[0] + spin[1] * z - spin[2] * y)
    speed += axis[1] * (linear[1] + spin[2] * x - spin[0] * z)
    return speed + axis[2] * (linear[2] + spin[0] * y - spin[1] * x)


@kernel
def normal_mobility(disk: RattlingDisk, place: float) -> float:
    """Return the change of `normal_speed` per impulse at the same point [1/kg]."""
    return 1 / disk.mass + place**2 / disk.diametral_inertia


@kernel
def add_film(
    pressed: PressedDisk, rim: RimGeometry, velocity: Velocities, step: float
) -> None:
    """Add the forces of the air film in a step, and record what its compressed air stores."""
    disk, _, motion, contacts = pressed
    record = motion.record
    axis = rim.axis
    up_slope = (-axis[0] * axis[2] / rim.sine, -axis[1] * axis[2] / rim.sine, rim.sine)
    stored = record[RECORD.compressed_air_energy]
    clearance = max(rim.height - rim.tilt, 0.0)
    film = film_load(disk, axis, up_slope, velocity, clearance, stored, step)
    arm = point_on_face(disk, axis, up_slope, film.place)
    add_force(contacts, FILM, times(film.pressure, axis), arm)
    level = cross(up_slope, axis)  # about which the high side rises
    for i in range(3):
        contacts.torque[FILM, i] += film.drag * up_slope[i] + film.righting * level[i]
    rate = np.hypot(velocity.angular[0], velocity.angular[1]) / rim.sine
    gap = max(rim.height, rim.tilt) / disk.radius
    kept = min(max(stored - film.work, 0.0), film_capacity(disk.film, gap, rate))
    record[RECORD.film_loss] += stored - kept
    record[RECORD.compressed_air_energy] = kept
