"""The incompressible air film under a disk at any small tilt and height.

`conformal_reynolds` solves Reynolds' equation. Its results are stored as Chebyshev
polynomials of sqrt(1 - eps) and sig/(1 + sig) in tilted_film.csv, which `python -m
dynamics.film.tilted_film` makes. The extrapolation to eps = 1 is the film that closes
at the rim.
"""

from math import acos, pi, sqrt
from pathlib import Path
from typing import NamedTuple

import numpy as np
from numpy.polynomial.chebyshev import chebvander

from dynamics.air import Air
from dynamics.film.conformal_reynolds import FilmResistance, film_resistance

TABLE_FILE = Path(__file__).with_name("tilted_film.csv")
MIN_TABULATED_OPENING = 0.03
"""Smallest tabulated sqrt(1 - eps)."""
MAX_TABULATED_DEPTH_SHARE = 0.99
"""Largest tabulated sig/(1 + sig)."""
OPENING_NODES = 14
DEPTH_NODES = 20

_COEFFICIENTS = np.loadtxt(TABLE_FILE, delimiter=",").reshape(DEPTH_NODES, -1)


def tabulated_resistance(tilt: float, depth: float = 0.0) -> FilmResistance:
    """Return `film_resistance` from the table, with a relative error below 3e-4.

    Parameters
    ----------
    tilt : float
        Slope of the disk times radius over gap, eps; a value above 1 counts as 1.
    depth : float
        Depth of a concave table below its rim over the gap, sig >= 0.

    Returns
    -------
    FilmResistance
        The resistances.
    """
    share = min(depth / (1.0 + depth), MAX_TABULATED_DEPTH_SHARE)
    in_depth = _chebyshev_polynomials(2 * share - 1, DEPTH_NODES)
    opening = sqrt(max(1.0 - tilt, 0.0))
    in_opening = _chebyshev_polynomials(2 * opening - 1, OPENING_NODES)
    return _unscaled(in_opening @ (in_depth @ _COEFFICIENTS).reshape(-1, 4), depth)


def plane_series() -> np.ndarray:
    """Return the coefficients (OPENING_NODES, 4) of the film on a plane, without wall slip.

    They are those of Chebyshev polynomials of 2 sqrt(1 - eps) - 1. The functions are the
    resistances a00 to heave, a00 + a01 and a00 + 2 a01 + a11 about the low point of the
    rim, and a22 to precession.
    """
    in_depth = _chebyshev_polynomials(-1.0, DEPTH_NODES)
    return (in_depth @ _COEFFICIENTS).reshape(OPENING_NODES, 4)


def _chebyshev_polynomials(x: float, count: int) -> np.ndarray:
    """Return the first polynomials (count,) at x in [-1, 1]."""
    return np.cos(np.arange(count) * acos(x))


def _scaled(resistance: FilmResistance, depth: float) -> np.ndarray:
    """Return four functions (4,) without cancellation that vary slowly with the depth.

    The second and third belong to a rotation about the low point of the rim.
    """
    heave, coupling, along, across = resistance
    deep = 1 + depth
    about_rim = heave + coupling
    return (
        np.array([heave, about_rim, about_rim + coupling + along, across * deep]) * deep
    )


def _unscaled(scaled: np.ndarray, depth: float) -> FilmResistance:
    """Invert `_scaled`."""
    deep = 1 + depth
    heave, about_rim, fall, across = (scaled / deep).tolist()
    return FilmResistance(
        heave, about_rim - heave, fall - 2 * about_rim + heave, across / deep
    )


class TiltedFilm(NamedTuple):
    """The film under a disk that may lie level, tilt, or touch the table.

    Attributes
    ----------
    viscosity : float
        Viscosity of the air [Pa s].
    radius : float
        Radius of the flat face [m].
    fillet : float
        Radius of the rounded edge [m], 0 for a sharp edge.
    depth : float
        Depth of a concave table below the rim of the face [m].
    mean_free_path : float
        Mean free path of the air [m]. Its first-order wall slip acts like a table that is
        deeper by six of these lengths, which is exact for a level disk.
    hole : float
        Diameter [m] of a hole in table or disk, about the centre of the disk, 0 without one.
    """

    viscosity: float
    radius: float
    fillet: float = 0.0
    depth: float = 0.0
    mean_free_path: float = 0.0
    hole: float = 0.0

    @property
    def hole_share(self) -> float:
        """Radius of the hole over that of the flat face."""
        return self.hole / (2 * self.radius)

    def ambient_pressure_radius(self, gap: float) -> float:
        """Return the radius [m] at which the pressure is ambient, for a gap [m].

        The film ends within the rounding of the edge; the error is 0.01 %.
        """
        return self.radius + 3 * pi / 16 * sqrt(2 * self.fillet * gap)

    def resistance(self, gap: float, slope: float) -> FilmResistance:
        """Return the resistances in SI units.

        Parameters
        ----------
        gap : float
            Gap [m] below the centre of the disk, above the plane of the rim of the table.
        slope : float
            Slope of the disk [rad].

        Returns
        -------
        FilmResistance
            `heave` [N s/m], `coupling` [N s], `along` and `across` [N m s].
        """
        R = self.ambient_pressure_radius(gap)
        depth = (self.depth + 6 * self.mean_free_path) / gap
        heave, coupling, along, across = self._relative_resistance(
            R * slope / gap, depth
        )
        k = 12 * self.viscosity * R**4 / gap**3
        return FilmResistance(
            k * heave, k * R * coupling, k * R**2 * along, k * R**2 * across
        )

    def _relative_resistance(self, tilt: float, depth: float) -> FilmResistance:
        """Return the dimensionless resistances; a hole keeps its share of the radius."""
        if not self.hole:
            return tabulated_resistance(tilt, depth)
        from dynamics.film.annular_film import tabulated_ring  # imports scikit-fem

        ring = tabulated_ring(self.hole_share, tilt, depth)
        heave, about, fall, across = ring.tolist()
        return FilmResistance(heave, about - heave, fall - 2 * about + heave, across)

    def sink_rate(self, gap: float, weight: float) -> float:
        """Return the speed [m/s] at which a level disk sinks under its weight [N]."""
        return weight / self.resistance(gap, 0.0).heave

    def sink_time(self, gap: float, final_gap: float, weight: float) -> float:
        """Return the time [s] in which a level disk sinks from one gap to another [m].

        It is the integral of dt = (3 pi mu R^4/(2 W)) dz/(z^2 (z + a)), where a is the depth
        of the table and of the wall slip, for the radius of the flat face.
        """
        a = self.depth + 6 * self.mean_free_path
        scale = 3 * pi * self.viscosity * self.radius**4 / (2 * weight)
        if self.hole:
            return self._integrated_sink_time(gap, final_gap, weight)
        if a == 0.0:
            return scale * (1 / final_gap**2 - 1 / gap**2) / 2
        return scale * (_sink_integral(final_gap, a) - _sink_integral(gap, a))

    def _integrated_sink_time(
        self, gap: float, final_gap: float, weight: float
    ) -> float:
        """Return `sink_time` by quadrature in log(z), with the sealing radius of each gap."""
        nodes, weights = np.polynomial.legendre.leggauss(24)
        half = np.log(gap / final_gap) / 2
        z = final_gap * np.exp(half * (nodes + 1))
        times = [v / self.sink_rate(float(v), weight) for v in z]
        return float(half * (weights @ times))


def _sink_integral(gap: float, a: float) -> float:
    """Return 1/(a z) - ln(1 + a/z)/a^2 at the gap z, whose derivative is -1/(z^2 (z + a))."""
    x = a / gap
    if x < 1e-3:  # without cancellation
        return (x * x / 2 - x**3 / 3 + x**4 / 4) / (a * a)
    return (x - np.log1p(x)) / (a * a)


def film_below(
    radius: float, fillet: float, air: Air, curvature: float = 0.0, hole: float = 0.0
) -> TiltedFilm:
    """Return the film under a disk with a rounded edge in air.

    Parameters
    ----------
    radius, fillet : float
        Radius of the disk and of its edge [m].
    air : Air
        The air.
    curvature : float
        Curvature of a concave table [1/m].
    hole : float
        Diameter [m] of a hole in table or disk, about the centre of the disk.

    Returns
    -------
    TiltedFilm
        The film.
    """
    flat = radius - fillet
    return TiltedFilm(
        viscosity=air.viscosity,
        radius=flat,
        fillet=fillet,
        depth=curvature * flat**2 / 2,
        mean_free_path=air.mean_free_path,
        hole=hole,
    )


def chebyshev_coefficients() -> np.ndarray:
    """Solve Reynolds' equation at the nodes and return the coefficients of the table.

    Returns
    -------
    ndarray, (DEPTH_NODES, OPENING_NODES, 4)
        Coefficients in sig/(1 + sig) and sqrt(1 - eps).
    """
    width = 1 - MIN_TABULATED_OPENING
    opening = MIN_TABULATED_OPENING + width * _nodes(OPENING_NODES)
    share = MAX_TABULATED_DEPTH_SHARE * _nodes(DEPTH_NODES)
    values = [
        [_scaled(film_resistance(1 - s * s, depth), depth) for s in opening]
        for depth in share / (1 - share)
    ]
    in_depth = np.linalg.inv(chebvander(2 * share - 1, DEPTH_NODES - 1))
    in_opening = np.linalg.inv(chebvander(2 * opening - 1, OPENING_NODES - 1))
    return np.einsum("ik,jl,klm->ijm", in_depth, in_opening, np.array(values))


def _nodes(count: int) -> np.ndarray:
    """Return the Chebyshev nodes (count,) in (0, 1)."""
    return (1 + np.cos(np.pi * (np.arange(count) + 0.5) / count)) / 2


if __name__ == "__main__":
    np.savetxt(TABLE_FILE, chebyshev_coefficients().reshape(-1, 4), "%.9e", ",")
