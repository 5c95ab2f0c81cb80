"""Compiled loads and stored energy of an air film whose constants are in SI units."""

import numpy as np

from dynamics.film.forces import film_moment_parts, squeezed_air_energy
from dynamics.film.tilted_film import plane_series
from dynamics.numba_kernels import kernel

PLANE_SERIES = np.ascontiguousarray(plane_series())
"""Coefficients (n, 4) of `plane_series`."""

_moment_parts = kernel(film_moment_parts)
_squeezed_air_energy = kernel(squeezed_air_energy)


@kernel
def film_loads(film, sine, rate):
    """Return the results of `film_moment_parts` at the sine of an inclination and a
    precession rate [rad/s]."""
    return _moment_parts(sine, rate, film)


@kernel
def film_capacity(film, sine, rate):
    """Return the largest energy [J] that the compressed air can store."""
    return _squeezed_air_energy(
        sine, rate, film.number, film.ambient, film.slip, film.bowl
    )


@kernel
def open_film(eps):
    """Return the resistances (a00, a00 + a01, a00 + 2 a01 + a11, a22) of a film on a plane.

    `eps` is the slope times the radius over the gap at the centre; the film is closed
    at the rim where it is 1.
    """
    x = 2 * np.sqrt(max(1.0 - eps, 0.0)) - 1
    before = 1.0
    now = x
    heave, about, fall, across = PLANE_SERIES[0]
    for n in range(1, PLANE_SERIES.shape[0]):
        heave += now * PLANE_SERIES[n, 0]
        about += now * PLANE_SERIES[n, 1]
        fall += now * PLANE_SERIES[n, 2]
        across += now * PLANE_SERIES[n, 3]
        before, now = now, 2 * x * now - before
    return heave, about, fall, across


@kernel
def compressed_air_impulse(impulse, speed, mobility, stored_energy):
    """Return the impulse [N s] of compressed air on a point of the face, and its work [J].

    The work is at most the stored energy, which limits the `impulse`. `speed` [m/s] is
    the velocity of the point away from the film, and `mobility` [1/kg] its change per
    impulse.
    """
    fastest = np.sqrt(speed * speed + 2 * mobility * stored_energy)
    impulse = min(impulse, (fastest - speed) / mobility)
    return impulse, impulse * (speed + impulse * mobility / 2)
