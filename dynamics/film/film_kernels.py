"""Compiled loads and stored energy of an air film whose constants are in SI units."""

from dynamics.film.forces import film_moment_parts, squeezed_air_energy
from dynamics.numba_kernels import kernel

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
