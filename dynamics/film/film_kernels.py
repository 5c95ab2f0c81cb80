"""Compiled loads and stored energy of an air film whose constants are in SI units."""

from typing import TYPE_CHECKING

import numpy as np

from dynamics.film.forces import (
    film_moment_parts,
    moment_parts_over_hole,
    squeezed_air_energy,
)
from dynamics.film.tilted_film import plane_series
from dynamics.numba_kernels import kernel

if TYPE_CHECKING:
    from dynamics.film.wedge import Film

PLANE_SERIES = np.ascontiguousarray(plane_series())
"""Coefficients (n, 4) of `plane_series`."""

_moment_parts = kernel(film_moment_parts)
_parts_over_hole = kernel(moment_parts_over_hole)
_squeezed_air_energy = kernel(squeezed_air_energy)


@kernel
def film_loads(
    film: "Film", sine: float, rate: float
) -> tuple[float, float, float, float, float]:
    """Return the parts of the moments, as `film_moment_parts`, at the sine of an
    inclination and a precession rate [rad/s]."""
    parts = _moment_parts(sine, rate, film)
    if film.hole[0] != 0.0:
        parts = _parts_over_hole(parts, sine, film)
    return parts


@kernel
def film_capacity(film: "Film", sine: float, rate: float) -> float:
    """Return the largest energy [J] that the compressed air can store; 0 over a hole."""
    if film.hole[0] != 0.0:
        return 0.0
    return _squeezed_air_energy(
        sine, rate, film.number, film.ambient, film.slip, film.bowl
    )


@kernel
def open_film(eps: float) -> tuple[float, float, float, float]:
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
def film_opening(eps: float) -> tuple[float, float, float, float]:
    """Return how the gap of a film on a plane changes its resistance; see `open_film`.

    In units of the values of the closed film with the same mean gap, the results are the
    resistance to precession, the resistance to a fall about the low point of the rim, and
    the lever of this resistance. The last result is the resistance of a force at the low
    point that completes the resistance to all motions; it is multiplied by R^2, and in
    units of the resistance to the fall.
    """
    heave, about, fall, across = open_film(eps)
    _, closed_about, closed_fall, closed_across = open_film(1.0)
    return (
        across / closed_across,
        fall / closed_fall,
        about / fall * closed_fall / closed_about,
        (heave - about * about / fall) / closed_fall,
    )


@kernel
def compressed_air_impulse(
    impulse: float, speed: float, mobility: float, stored_energy: float
) -> tuple[float, float]:
    """Return the impulse [N s] of compressed air on a point of the face, and its work [J].

    The work is at most the stored energy, which limits the `impulse`. `speed` [m/s] is
    the velocity of the point away from the film, and `mobility` [1/kg] its change per
    impulse.
    """
    fastest = np.sqrt(speed * speed + 2 * mobility * stored_energy)
    impulse = min(impulse, (fastest - speed) / mobility)
    return impulse, impulse * (speed + impulse * mobility / 2)
