"""Forces of the air film under a rattling disk.

The film is that of a disk in contact, because hops are low compared with the mean gap.
A drag opposes the precession. The pressure force acts at the centre of pressure, normal
to the face, and opposes the normal velocity there. The compressed air exerts no
pressure when it stores no energy.
"""

from typing import NamedTuple

import numpy as np

from dynamics.film.forces import film_moment_parts, squeezed_air_energy
from dynamics.numba_kernels import kernel

film_moment_parts_kernel = kernel(film_moment_parts)
squeezed_air_kernel = kernel(squeezed_air_energy)

MIN_PRECESSION_RATE = 1e-9
"""Precession rate [rad/s] below which the drag is independent of the rate."""
FORCE, ARM, TORQUE = range(3)
"""Rows of the loads (3, 3) of the film: force [N], its position relative to the centre
[m], and torque [N m]."""


class AirFilm(NamedTuple):
    """Constants of `film_moment_parts` in SI units; `turning` is 0 without a film.

    Attributes
    ----------
    turning, falling : float
        12 mu R^3 times I and I_n [N m s].
    inertia : float
        Factor of the inertia of the rotating air [s^2].
    number : float
        Factor of the compressibility [s].
    ambient : float
        p pi R^3 [J].
    slip : float
        Factor of the wall slip.
    bowl : float
        Gap added in the middle by a concave table, divided by the radius.
    """

    turning: float
    falling: float
    inertia: float
    number: float
    ambient: float
    slip: float
    bowl: float


@kernel
def film_capacity(film, sine, rate):
    """Return the largest energy [J] that the compressed air can store."""
    return squeezed_air_kernel(
        sine, abs(rate), film.number, film.ambient, film.slip, film.bowl
    )


@kernel
def film_pressure(film, disk, axis, sine, velocity, stored_energy, step, load):
    """Write the loads (3, 3) of the film in a step; return the work [J] of the compressed air.

    `disk` is a `RattlingDisk`, `axis` (3,) the unit vector along its axis, `sine` that of the
    inclination, and `velocity` (6,) the velocity of the centre and the angular velocity.
    """
    up_slope = (-axis[0] * axis[2] / sine, -axis[1] * axis[2] / sine, sine)
    turning = (
        velocity[3] * up_slope[0]
        + velocity[4] * up_slope[1]
        + velocity[5] * up_slope[2]
    )
    rate = abs(turning) / sine + MIN_PRECESSION_RATE
    drag, fall, lever, tip, lift = film_moment_parts_kernel(
        sine,
        rate,
        film.turning,
        film.falling,
        film.inertia,
        film.number,
        film.ambient,
        film.slip,
        film.bowl,
    )
    # exponential damping is stable at every gap
    decay = np.expm1(-step * drag / (rate * sine * disk.diametral_inertia))
    torque = turning * disk.diametral_inertia / step * decay
    distance = disk.radius / lever
    speed = normal_speed(disk, axis, up_slope, velocity, distance)
    mobility = normal_mobility(disk, distance)
    closing = (
        speed / (mobility * step) * np.expm1(-step * fall / distance**2 * mobility)
    )
    pressure = closing
    moment = closing * (distance - disk.radius)
    work = 0.0
    if lift > 0:
        distance = disk.radius * tip / lift
        speed = normal_speed(disk, axis, up_slope, velocity, distance)
        mobility = normal_mobility(disk, distance)
        fastest = np.sqrt(speed**2 + 2 * mobility * stored_energy)
        impulse = min(step * lift / disk.radius, (fastest - speed) / mobility)
        work = impulse * (speed + impulse * mobility / 2)
        pressure += impulse / step
        moment += impulse / step * (distance - disk.radius)
    place = moment / pressure if pressure != 0 else 0.0
    for i in range(3):
        load[FORCE, i] = pressure * axis[i]
        load[ARM, i] = place * up_slope[i] - disk.half_thickness * axis[i]
        load[TORQUE, i] = torque * up_slope[i]
    return work


@kernel
def normal_speed(disk, axis, up_slope, velocity, distance):
    """Return the velocity along the axis [m/s] of a point on the lower face.

    The point is at `distance` [m] from the contact, up the slope.
    """
    x = (distance - disk.radius) * up_slope[0] - disk.half_thickness * axis[0]
    y = (distance - disk.radius) * up_slope[1] - disk.half_thickness * axis[1]
    z = (distance - disk.radius) * up_slope[2] - disk.half_thickness * axis[2]
    speed = axis[0] * (velocity[0] + velocity[4] * z - velocity[5] * y)
    speed += axis[1] * (velocity[1] + velocity[5] * x - velocity[3] * z)
    return speed + axis[2] * (velocity[2] + velocity[3] * y - velocity[4] * x)


@kernel
def normal_mobility(disk, distance):
    """Return the change of `normal_speed` per impulse at the same point [1/kg]."""
    return 1 / disk.mass + (distance - disk.radius) ** 2 / disk.diametral_inertia
