"""Impulses of the air film under a rattling disk.

The film is that of a disk in contact, because hops are low compared with the mean gap.
A drag opposes the precession. The pressure force acts at the centre of pressure, normal
to the face, and opposes the normal velocity there. The compressed air exerts no
pressure when it stores no energy.
"""

from typing import NamedTuple

import numpy as np

from dynamics.film.film_kernels import film_loads
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
    drag : float
        Torque [N m] about the direction up the slope.
    work : float
        Work [J] of the compressed air.
    """

    pressure: float
    place: float
    drag: float
    work: float


@kernel
def film_load(disk, axis, up_slope, velocity, stored_energy, step):
    """Return the `FilmLoad` in a step with an energy [J] stored in the compressed air.

    `disk` is a `RattlingDisk`, `axis` (3,) the unit vector along its axis, and `up_slope` that
    up its slope, whose height is the sine of the inclination.
    """
    min_rate = 1e-9  # rad/s; the drag of slower precession is independent of the rate
    sine = up_slope[2]
    spin = velocity.angular
    turning = spin[0] * up_slope[0] + spin[1] * up_slope[1] + spin[2] * up_slope[2]
    rate = abs(turning) / sine + min_rate
    drag, fall, lever, tip, lift = film_loads(disk.film, sine, rate)
    # exponential damping is stable at every gap
    torque = (turning * disk.diametral_inertia / step) * np.expm1(
        -step * drag / (rate * sine * disk.diametral_inertia)
    )
    distance = disk.radius / lever
    place = distance - disk.radius
    speed = normal_speed(disk, axis, up_slope, velocity, place)
    mobility = normal_mobility(disk, place)
    pressure = (
        speed / (mobility * step) * np.expm1(-step * fall / distance**2 * mobility)
    )
    moment = pressure * place
    work = 0.0
    if lift > 0:
        place = disk.radius * tip / lift - disk.radius
        speed = normal_speed(disk, axis, up_slope, velocity, place)
        mobility = normal_mobility(disk, place)
        fastest = np.sqrt(speed**2 + 2 * mobility * stored_energy)
        impulse = min(step * lift / disk.radius, (fastest - speed) / mobility)
        work = impulse * (speed + impulse * mobility / 2)
        pressure += impulse / step
        moment += impulse / step * place
    place = moment / pressure if pressure != 0 else 0.0
    return FilmLoad(pressure, place, torque, work)


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
    film = film_load(disk, axis, up_slope, velocity, stored, step)
    force = (film.pressure * axis[0], film.pressure * axis[1], film.pressure * axis[2])
    add_force(contacts, FILM, force, point_on_face(disk, axis, up_slope, film.place))
    for i in range(3):
        contacts.torque[FILM, i] += film.drag * up_slope[i]
    return film.work
