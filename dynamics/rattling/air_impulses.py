"""Impulses of the air film under a rattling disk, at its present gap and tilt.

A drag opposes the precession. The resistance to heave and tilt is that of a force and of
a moment which each oppose one velocity: that of the face at the centre of pressure of a
heaving disk, and the tilting about it. The compressed air exerts no pressure when it
stores no energy.
"""

from typing import NamedTuple

import numpy as np

from dynamics.film.film_kernels import (
    compressed_air_impulse,
    film_loads,
    open_film,
)
from dynamics.numba_kernels import kernel
from dynamics.rattling.body import add_force
from dynamics.rattling.layout import FILM, RECORD


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
def film_load(disk, axis, up_slope, velocity, clearance, stored_energy, step):
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
    turning = spin[0] * up_slope[0] + spin[1] * up_slope[1] + spin[2] * up_slope[2]
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
    tilting = tilt_rate(axis, up_slope, velocity) + step * moment / inertia
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
def level_diameter(axis, up_slope):
    """Return the unit vector of the horizontal diameter about which the high side rises."""
    x = up_slope[1] * axis[2] - up_slope[2] * axis[1]
    y = up_slope[2] * axis[0] - up_slope[0] * axis[2]
    z = up_slope[0] * axis[1] - up_slope[1] * axis[0]
    return x, y, z


@kernel
def tilt_rate(axis, up_slope, velocity):
    """Return the rate [rad/s] at which the high side of a disk rises."""
    x, y, z = level_diameter(axis, up_slope)
    return velocity.angular[0] * x + velocity.angular[1] * y + velocity.angular[2] * z


@kernel
def point_on_face(disk, axis, up_slope, place):
    """Return the vector [m] from the centre to a point on the lower face.

    The point is at the distance `place` [m] from the axis, up the slope.
    """
    x = place * up_slope[0] - disk.half_thickness * axis[0]
    y = place * up_slope[1] - disk.half_thickness * axis[1]
    z = place * up_slope[2] - disk.half_thickness * axis[2]
    return x, y, z


@kernel
def normal_speed(disk, axis, up_slope, velocity, place):
    """Return the velocity along the axis [m/s] of `point_on_face`."""
    x, y, z = point_on_face(disk, axis, up_slope, place)
    linear = velocity.linear
    spin = velocity.angular
    speed = axis[0] * (linear[0] + spin[1] * z - spin[2] * y)
    speed += axis[1] * (linear[1] + spin[2] * x - spin[0] * z)
    return speed + axis[2] * (linear[2] + spin[0] * y - spin[1] * x)


@kernel
def normal_mobility(disk, place):
    """Return the change of `normal_speed` per impulse at the same point [1/kg]."""
    return 1 / disk.mass + place**2 / disk.diametral_inertia


@kernel
def add_film(disk, motion, rim, velocity, step, contacts):
    """Add the forces of the air film; return the work [J] of its compressed air."""
    axis = rim.axis
    up_slope = (-axis[0] * axis[2] / rim.sine, -axis[1] * axis[2] / rim.sine, rim.sine)
    stored = motion.record[RECORD.compressed_air_energy]
    clearance = max(rim.height - rim.tilt, 0.0)
    film = film_load(disk, axis, up_slope, velocity, clearance, stored, step)
    force = (film.pressure * axis[0], film.pressure * axis[1], film.pressure * axis[2])
    add_force(contacts, FILM, force, point_on_face(disk, axis, up_slope, film.place))
    level = level_diameter(axis, up_slope)
    for i in range(3):
        contacts.torque[FILM, i] += film.drag * up_slope[i] + film.righting * level[i]
    return film.work
