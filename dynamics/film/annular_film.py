"""Reynolds' equation in the ring between the rim of a disk and a hole under its centre.

The pressure is the ambient one at both edges. Lengths are divided by the radius of the
disk, and gaps by the gap that a table without a hole would leave below the centre. The
gap is h = 1 + eps x + sig (1 - r^2), as in `conformal_reynolds`; it closes at x = -1 for
eps = 1. The map -exp(-a - i b) takes a rectangle to the ring, and the mesh is uniform in
the logarithms of the distance from the rim and from the low point.
"""

from functools import lru_cache

import numpy as np
from numpy.polynomial.chebyshev import chebval2d, chebvander
from skfem import Basis, ElementQuad2, MeshQuad

from dynamics.film.conformal_reynolds import FilmResistance
from dynamics.film.forces import HOLE_COEFFICIENTS
from dynamics.film.reynolds import FilmMesh

RING_NODES = 9
"""Chebyshev nodes of the table in sqrt(1 - eps) and in log(1 + sig)."""
MAX_TABULATED_DEPTH = 100.0
"""Largest tabulated sig; a smaller gap counts as this depth."""
MAX_FITTED_BOWL = 15.0
"""Largest gap that a concave table adds in the middle of the closed film, divided by the gap of
the disk there, for which the polynomials of `closed_film_constants` are fitted."""


class AnnularFilmMesh(FilmMesh):
    """Quadratic finite elements for the film over a hole, refined at the low point of the rim.

    Parameters
    ----------
    hole : float
        Radius of the hole over that of the disk, between 0 and 1.
    tilt, depth : float
        eps and sig of the gap.
    cells : int
        Number of elements across and along one half of the ring.
    parity : int
        1 for fields that are even in y, -1 for odd fields.
    """

    def __init__(
        self, hole: float, tilt: float, depth: float, *, cells: int = 24, parity: int
    ):
        self.parity = parity
        unit = np.linspace(0, 1, cells + 1)
        self.basis = Basis(MeshQuad.init_tensor(unit, unit), ElementQuad2())
        width = -np.log(hole)
        decades = (
            7.0  # natural logarithms; the film is resolved down to exp(-7) of the width
        )
        s, u = np.asarray(self.basis.global_coordinates())
        a, a_slope = _graded(s, width, decades)
        b, b_slope = _graded(u, np.pi, decades)
        points = -np.exp(-a - 1j * b)
        self._place_points(points, np.abs(points) ** 2, (a_slope, b_slope))
        self.height = _gap(points, tilt, depth)
        s, u = self.basis.doflocs
        self.nodes = -np.exp(
            -_graded(s, width, decades)[0] - 1j * _graded(u, np.pi, decades)[0]
        )
        between = (s > 1e-9) & (s < 1 - 1e-9)
        symmetric = (u > 1e-9) & (u < 1 - 1e-9) | (parity == 1)
        self._inner = np.flatnonzero(between & symmetric)
        self._find_sparsity_pattern()


def _graded(
    unit: np.ndarray, length: float, decades: float
) -> tuple[np.ndarray, np.ndarray]:
    """Return a coordinate from 0 to `length` that is fine at 0, and its derivative."""
    scale = length / np.expm1(decades)
    return scale * np.expm1(decades * unit), scale * decades * np.exp(decades * unit)


def _gap(points: np.ndarray, tilt: float, depth: float) -> np.ndarray:
    return 1 + tilt * points.real + depth * (1 - np.abs(points) ** 2)


def annular_resistance(
    hole: float, tilt: float, depth: float = 0.0, cells: int = 24
) -> FilmResistance:
    """Solve Reynolds' equation for a heaving and turning disk over a hole.

    As the hole vanishes, the resistance to heave tends to that without a hole as
    1/log(1/hole).

    Parameters
    ----------
    hole : float
        Radius of the hole over that of the disk, between 0 and 1.
    tilt : float
        Slope of the disk times radius over gap, eps in [0, 1].
    depth : float
        Depth of a concave table below its rim over the gap, sig >= 0.
    cells : int
        Number of elements across and along one half of the ring.

    Returns
    -------
    FilmResistance
        The resistances.
    """
    even = AnnularFilmMesh(hole, tilt, depth, cells=cells, parity=1)
    odd = AnnularFilmMesh(hole, tilt, depth, cells=cells, parity=-1)
    x, y = even.points.real, odd.points.imag
    heaving, tilting = even.linear_responses([np.ones_like(x), x], [np.ones_like(x), x])
    (rolling,) = odd.linear_responses([y], [y])
    return FilmResistance(
        heave=-float(heaving.works[0].real),
        coupling=-float(heaving.works[1].real),
        along=-float(tilting.works[1].real),
        across=-float(rolling.works[0].real),
    )


def about_low_point(resistance: FilmResistance) -> np.ndarray:
    """Return heave, heave + coupling, heave + 2 coupling + along, and across (4,).

    All are positive; the second and third belong to a rotation about the low point of
    the rim.
    """
    heave, coupling, along, across = resistance
    about = heave + coupling
    return np.array([heave, about, about + coupling + along, across])


@lru_cache(maxsize=32)
def closed_film_polynomials(hole: float) -> np.ndarray:
    """Return the coefficients (3, HOLE_COEFFICIENTS) of the film of a rolling disk.

    They are the coefficients of w, w^2, .., with w = 1/(1 + sig), of the resistance to
    precession, to a fall about the contact, and of the lift on a falling disk, fitted to
    `annular_resistance` with eps = 1.

    Parameters
    ----------
    hole : float
        Radius of the hole over that of the face, between 0 and 1.

    Returns
    -------
    ndarray, (3, HOLE_COEFFICIENTS)
        The coefficients.
    """
    count = 10
    least = 1 / (1 + MAX_FITTED_BOWL)
    w = least + (1 - least) * _chebyshev_nodes(count)
    solved = np.array([_closed(hole, 1 / v - 1) for v in w])
    powers = w[:, None] ** np.arange(1, HOLE_COEFFICIENTS + 1)
    fits = [
        np.linalg.lstsq(powers / column[:, None], np.ones(count))[0]
        for column in solved[:, [3, 2, 1]].T
    ]
    return np.array(fits)


def _closed(hole: float, depth: float) -> np.ndarray:
    return about_low_point(annular_resistance(hole, 1.0, depth))


def tabulated_ring(hole: float, tilt: float, depth: float) -> np.ndarray:
    """Return `about_low_point` (4,) of `annular_resistance` from a table.

    The relative error is below 0.5 %. The table is made at the first call for a hole.

    Parameters
    ----------
    hole : float
        Radius of the hole over that of the face, between 0 and 1.
    tilt : float
        Slope of the disk times radius over gap, eps; a value above 1 counts as 1.
    depth : float
        Depth of a concave table below its rim over the gap, sig >= 0.

    Returns
    -------
    ndarray, (4,)
        The four resistances.
    """
    deep = np.log1p(depth) / np.log1p(MAX_TABULATED_DEPTH)
    opening = max(1 - tilt, 0.0) ** 0.5
    place = 2 * min(deep, 1.0) - 1, 2 * opening - 1
    return np.exp(chebval2d(*place, _ring_table(hole)))


@lru_cache(maxsize=8)
def _ring_table(hole: float) -> np.ndarray:
    """Return Chebyshev coefficients (RING_NODES, RING_NODES, 4) of the logarithms."""
    nodes = _chebyshev_nodes(RING_NODES)
    depths = np.expm1(np.log1p(MAX_TABULATED_DEPTH) * nodes)
    logarithms = [
        [
            np.log(about_low_point(annular_resistance(hole, 1 - o * o, depth)))
            for o in nodes
        ]
        for depth in depths
    ]
    inverse = np.linalg.inv(chebvander(2 * nodes - 1, RING_NODES - 1))
    return np.einsum("ik,jl,klm->ijm", inverse, inverse, np.array(logarithms))


def _chebyshev_nodes(count: int) -> np.ndarray:
    """Return the Chebyshev nodes (count,) in (0, 1)."""
    return (1 + np.cos(np.pi * (np.arange(count) + 0.5) / count)) / 2
