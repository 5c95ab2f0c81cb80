"""AIR OUTSIDE: a solid disk that stands a gap above a baffle; its face, and the flow out of the gap, are what sounds.

Lengths are over the radius R, pressures over density times R times acceleration; waves are exp(i w t), of the order n
round the axis, k = w R/c. Finite elements in the half plane of r and z reach from the disk to a hemisphere, on which
the field is a sum of outgoing multipoles: their amplitudes are the answer, exact at every listener beyond.
tests/test_sound_open_film.py.
"""

import numpy as np
from scipy.sparse import coo_matrix
from scipy.sparse.linalg import splu
from scipy.special import gammaln, lpmv, spherical_jn, spherical_yn
from skfem import Basis, BilinearForm, ElementQuad2, FacetBasis, LinearForm, MeshQuad

CELLS, OUTWARDS, MULTIPOLES = 14, 6, 8
"""Elements along the face, and from the disk to the hemisphere; multipoles of each order."""
GRADED = 2.0
"""The elements grow towards the hemisphere as this power."""


class Outside:
    """A disk of `thickness` over a `gap` within a hemisphere of the radius `far`.

    `loads` (3, nodes) are what its heave and its tilt push outside, and a flow of unit volume per length of the rim.
    """

    def __init__(self, thickness: float, gap: float, far: float, cells: int = CELLS, outwards: int = OUTWARDS):
        self.gap, self.far, height = gap, far, thickness + gap
        mesh = _mesh(height, gap, far, cells, outwards)
        self._basis, facets = Basis(mesh, ElementQuad2()), mesh.boundary_facets()
        ends = mesh.p[:, mesh.facets[:, facets]]
        r, z = ends.mean(axis=1)
        rim = np.abs(r - 1) < 1e-9
        parts = (
            (np.abs(z - height) < 1e-9) & (r < 1),
            rim & (z > gap),
            rim & (z < gap),
            np.hypot(*ends).min(axis=0) > 0.999 * far,
        )
        face, side, below, self._beyond = (FacetBasis(mesh, ElementQuad2(), facets=facets[part]) for part in parts)
        self._axis = self._basis.get_dofs(facets[r < 1e-9]).all()
        self._forms = [form.assemble(self._basis) for form in (_slope, _around, _mass)]
        heave, tilt = _load.assemble(face, weight=1.0), _load.assemble(face, weight=_places(face)[0])
        lift = _load.assemble(side, weight=_places(side)[1] - gap - thickness / 2)
        self.loads = np.array([heave, tilt - lift, _load.assemble(below, weight=1 / gap)])

    def answers(self, n: int, numbers) -> tuple[np.ndarray, np.ndarray]:
        """Return the mean pressure in the gap at the rim (a, 3), and the multipoles on the hemisphere
        (a, MULTIPOLES, 3), of the order n and `numbers` k (a,), under each of `loads` times cos n theta."""
        order, (slope, around, mass) = n + 2 * np.arange(MULTIPOLES), self._forms
        r, z = _places(self._beyond)
        shapes = _legendre(n, z / np.hypot(r, z))
        waves = np.array([_load.assemble(self._beyond, weight=w) for w in shapes]) / self.far**2
        on = np.flatnonzero(waves.any(axis=0))
        some = np.setdiff1d(np.arange(waves.shape[1]), self._axis if n else [])
        at_rim, multipoles = [], []
        for k in numbers:
            outwards = k * self.far**2 * _hankel(order, k * self.far, True) / _hankel(order, k * self.far)
            beyond = ((waves[:, on].T * outwards) @ waves[:, on]).ravel()
            beyond = coo_matrix((beyond, (np.repeat(on, len(on)), np.tile(on, len(on)))), mass.shape)
            matrix = (slope + n * n * around - k * k * mass - beyond).tocsc()[some][:, some]
            p = splu(matrix).solve(self.loads.T[some].astype(complex))
            at_rim.append(self.loads[2, some] @ p)
            multipoles.append(waves[:, some] @ p)
        return np.array(at_rim), np.array(multipoles)


def heard(n: int, numbers, far: float, distance: float, elevation: float) -> np.ndarray:
    """Return the pressures (a, MULTIPOLES) of multipoles 1 on the hemisphere `far`, of the order n and `numbers` k
    (a,), at azimuth 0 of a listener at a `distance` over the radius and an elevation [rad], retarded to the centre."""
    order, k = n + 2 * np.arange(MULTIPOLES), np.asarray(numbers)[:, None]
    wave = _hankel(order, k * distance) / _hankel(order, k * far)
    return wave * np.exp(1j * k * distance) * _legendre(n, np.sin(elevation))


def _mesh(height, gap, far, cells, outwards):
    """Quadrilaterals between the disk and the hemisphere, finer to the edges."""
    half = height - (height - gap) / 2
    inwards = np.linspace(0, 1, cells + 1) ** 2
    low = int(np.ceil(np.log2(max((half - gap) / gap, 4.0)))) + 1
    sides = [
        height - (height - half) * np.linspace(0, 1, cells // 2 + 1)[1:] ** 2,
        gap + (half - gap) * (2.0 ** np.arange(low, -1, -1) - 1)[1:] / (2.0**low - 1),
        [gap / 2, 0.0],
    ]
    z = np.concatenate([np.full(cells + 1, height), *sides])
    r = np.minimum(np.append(1 - inwards[::-1], np.ones(len(z) - cells - 1)), 1.0)
    length = np.append(0.0, np.cumsum(np.hypot(np.diff(r), np.diff(z))))
    angle = np.pi / 4 * (2 - length / length[-1] - np.linspace(0, 1, len(z)))
    disk, arc = np.array([r, z])[..., None], far * np.array([np.cos(angle), np.sin(angle)])[..., None]
    part = np.linspace(0, 1, outwards + 1) ** GRADED
    grid = MeshQuad.init_tensor(np.arange(len(z), dtype=float), np.arange(outwards + 1, dtype=float))
    along, across = np.rint(grid.p).astype(int)
    return MeshQuad(np.ascontiguousarray((disk * (1 - part) + arc * part)[:, along, across]), grid.t)


def _places(basis):
    return np.asarray(basis.global_coordinates())


def _hankel(order, x, derivative=False):
    """The spherical Hankel function of the second kind, outgoing with exp(i w t)."""
    return spherical_jn(order, x, derivative) - 1j * spherical_yn(order, x, derivative)


def _legendre(n, cosine):
    """The associated Legendre functions of n, n + 2, .. (MULTIPOLES, ...), of mean square 1 on half a sphere."""
    degree = n + 2 * np.arange(MULTIPOLES)
    size = np.sqrt((2 * degree + 1) * np.exp(gammaln(degree - n + 1) - gammaln(degree + n + 1)))
    return np.array([c * lpmv(n, m, cosine) for c, m in zip(size, degree, strict=True)])


@BilinearForm
def _slope(p, q, w):
    return (p.grad[0] * q.grad[0] + p.grad[1] * q.grad[1]) * w.x[0]


@BilinearForm
def _around(p, q, w):
    return p * q / w.x[0]


@BilinearForm
def _mass(p, q, w):
    return p * q * w.x[0]


@LinearForm
def _load(q, w):
    return w.weight * q * w.x[0]
