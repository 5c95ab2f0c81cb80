"""Finite-element solution of Reynolds' equation for the air film under the disk.

Lengths are divided by the radius R, and gaps by the mean gap g = R sin(beta). The wedge
h = 1 + x closes at the contact x = -1. The inversion z = 2/(X + i Y) - 1 maps the half
plane X > 1 to the disk, its boundary to the rim and infinity to the contact; the gap
becomes h = 2 X/(X^2 + Y^2). The mesh is uniform in b and sqrt(a), where X = exp(a) and
Y = sinh(b). It is therefore fine at the contact, where the gap nearly closes, and at
the rim, where the flow of a stiff film is concentrated.
tests/film/test_film_constants.py compares the results with known solutions.
"""

from collections.abc import Callable, Sequence
from typing import Any, NamedTuple

import numpy as np
from scipy.sparse import csc_array, csr_array
from scipy.sparse.linalg import splu
from skfem import Basis, ElementQuad2, MeshQuad

from dynamics.air import HEAT_CAPACITY_RATIO


def wedge_gap(x: np.ndarray, y: np.ndarray) -> np.ndarray:
    """Return the gap between disk and plane table, divided by the mean gap."""
    return 1 + x


class FilmResponse(NamedTuple):
    """Response of a film to the opening of its gap at a velocity V.

    Attributes
    ----------
    works : array
        Work int p W dA/R^2 on each of the given shapes W; p is in units of 12 mu R^2
        V/g^3.
    rim : (2 k + 1,) array
        Outflow at the rim, int q exp(-i n theta) ds/(R^2 V), for n = 0, 1, .., k, -k,
        .., -1.
    """

    works: np.ndarray
    rim: np.ndarray


class FilmMesh:
    """Quadratic finite elements for an air film, refined at the contact and the rim.

    The pressure at the rim is the ambient pressure.

    Parameters
    ----------
    cells : int
        Number of elements across the film; the number along the rim is twice as large.
    height : callable
        Function of (x, y) that returns the gap divided by the mean gap.
    nearest : float
        Negative logarithm of the distance from the contact, divided by R, at which the
        mesh ends.
    parity : int
        1 for fields that are even in y, -1 for odd fields, 0 for all fields. For 1 and
        -1 the mesh covers one half of the film, and the gap must be even in y.

    Attributes
    ----------
    points : (e, q) array
        Quadrature points x + i y, at which velocities and shapes are given.
    area : (e, q) array
        Quadrature weights for integrals over the face.
    """

    def __init__(
        self,
        cells: int,
        height: Callable[..., Any] = wedge_gap,
        *,
        nearest: float,
        parity: int = 0,
    ) -> None:
        across = nearest * np.linspace(0, 1, cells + 1) ** 2
        along = np.linspace(-nearest, nearest, 2 * cells + 1)
        along = along[cells:] if parity else along
        self.parity = parity
        self.basis = Basis(MeshQuad.init_tensor(across, along), ElementQuad2())
        a, b = np.asarray(self.basis.global_coordinates())
        t = np.exp(a) + 1j * np.sinh(b)
        self._place_points(2 / t - 1, 4 / np.abs(t) ** 4, (np.exp(a), np.cosh(b)))
        self.height = height(self.points.real, self.points.imag)
        a, b = self.basis.doflocs
        self.nodes = 2 / (np.exp(a) + 1j * np.sinh(b)) - 1
        self._inner = np.flatnonzero((a > 1e-9) & ((b > 1e-9) | (parity != -1)))
        self._find_sparsity_pattern()

    def _place_points(
        self,
        points: np.ndarray,
        scale: np.ndarray,
        stretch: tuple[np.ndarray, np.ndarray],
    ) -> None:
        """Set the quadrature points x + i y of a mesh that a conformal map takes to the film.

        `scale` is the square of the scale of the map, and `stretch` the two derivatives of
        its arguments by the coordinates of the mesh.
        """
        first, second = stretch
        self._dx = (2 if self.parity else 1) * self.basis.dx
        self.points = points
        self._measure = scale * first * second
        self.area = self._measure * self._dx
        self._metric = (second / first, first / second)
        each = [shape[0] for shape in self.basis.basis]
        parts = [np.hstack([*s.grad, np.asarray(s)]) for s in each]
        self._shapes = np.array(parts, complex).swapaxes(0, 1).copy()
        self._wave_cache: dict[int, np.ndarray] = {}

    def _find_sparsity_pattern(self) -> None:
        """Compute the sparsity pattern, the positions of the pairs (e, i, j) in it, and
        the matrix that sums element contributions at the nodes."""
        count = len(self._inner)
        place = np.full(self.basis.N, -1)
        place[self._inner] = np.arange(count)
        places = place[self.basis.element_dofs.T]
        row = places[:, :, None]
        column = places[:, None, :]
        key, self._slot = np.unique(
            np.where((row < 0) | (column < 0), count**2, column * count + row),
            return_inverse=True,
        )
        key = key[key < count**2]
        self._sparse = key % count, np.searchsorted(key, count * np.arange(count + 1))
        node = self.basis.element_dofs.T.ravel()
        self._gather = csr_array(
            (np.ones(len(node)), (node, np.arange(len(node)))),
            shape=(self.basis.N, len(node)),
        )

    def linear_responses(
        self,
        velocities: list[np.ndarray],
        shapes: list[np.ndarray],
        sigma: float = 0.0,
        inertia: complex = 0.0,
        orders: int = 0,
        slip: float = 0.0,
        heat: complex = 0.0,
    ) -> list[FilmResponse]:
        """Solve the linearised equation for opening velocities that vary as exp(i w t).

        The equation for small pressure changes p is div(m(h) grad p) - i sigma s(h) p =
        V.

        Parameters
        ----------
        velocities, shapes : (v, e, q) arrays
            Values at `points` of the opening velocities V and of the shapes W for the
            work.
        sigma : float
            Squeeze number 12 mu w R^2/(p_a g^2).
        inertia : complex
            Parameter g sqrt(i w rho/mu) of unsteady flow; if 0, the mobility m is h^3.
        orders : int
            Highest order of the outflow at the rim.
        slip : float
            Mean free path divided by g. Maxwell's slip adds 6 slip h^2 to the mobility.
        heat : complex
            Parameter k = g sqrt(i w rho c_p/kappa) of heat conduction to the faces. The
            storage is s = h - (1 - 1/c) (h - 2/k tanh(k h/2)), where c is the ratio of
            the specific heats (Tijdeman 1975). If k is 0, the air is isothermal and s =
            h.

        Returns
        -------
        list of FilmResponse
            One response for each velocity.
        """
        mobility = film_mobility(self.height, inertia) + 6 * slip * self.height**2
        warmed = film_mobility(self.height, heat) * heat * heat / 12
        pairs, matrix = self._stiffness(
            mobility,
            1j * sigma * (self.height - (1 - 1 / HEAT_CAPACITY_RATIO) * warmed),
        )
        loads = self._load_vectors(velocities)
        works = loads if shapes is velocities else self._load_vectors(shapes)
        inner = self._inner
        p = np.zeros(loads.shape, complex)
        factors = splu(matrix)
        rest = loads.astype(complex)
        p[:, inner] = [factors.solve(-row[inner]) for row in rest]
        rim = -(rest + self._matrix_product(pairs, p.T).T) @ self._waves(orders)
        return [FilmResponse(*answer) for answer in zip(p @ works.T, rim, strict=True)]

    def rim_flow_matrices(
        self,
        mobility: np.ndarray,
        storage: np.ndarray,
        velocities: Sequence[np.ndarray],
        orders: int,
    ) -> tuple[np.ndarray, np.ndarray]:
        """Return two matrices of the outflow int q W ds at the rim.

        The waves W are cos n theta, n = 0, .., `orders`, followed by sin n theta, n =
        1, .., `orders`. The film obeys div(m grad p) = V + storage p. The first matrix
        (w, v) is the outflow for each of the `velocities` V (v, e, q) with zero
        pressure at the rim. The second matrix (w, w) is the reduction of the outflow if
        the pressure at the rim equals each wave.
        """
        pairs, matrix = self._stiffness(mobility, storage)
        inner = self._inner
        waves = self._waves(orders)
        p = np.hstack(
            [waves.real[:, : orders + 1], -waves.imag[:, 1 : orders + 1]]
        ).astype(complex)
        p[inner] -= splu(matrix).solve(self._matrix_product(pairs, p)[inner])
        return -p.T @ self._load_vectors(velocities).T, p.T @ self._matrix_product(
            pairs, p
        )

    def _waves(self, orders: int) -> np.ndarray:
        """Return nodal values (n, 2 k + 1) of exp(-i n theta), extended inwards as z^n."""
        if orders in self._wave_cache:
            return self._wave_cache[orders]
        n = np.concatenate([np.arange(orders + 1), np.arange(-orders, 0)])
        z = self.nodes[:, None] ** np.abs(n)
        other = np.conj(self.nodes)[:, None] ** np.abs(n)
        waves = np.where(n > 0, other, z)
        mirrored = np.where(n > 0, z, other)
        if self.parity:
            waves = (waves + self.parity * mirrored) / 2
        self._wave_cache[orders] = waves
        return waves

    def _stiffness(
        self, mobility: np.ndarray, storage: np.ndarray
    ) -> tuple[np.ndarray, csc_array]:
        """Assemble the bilinear form int m grad p . grad q + storage p q dA.

        Returns the element matrices (e, i, j) and the sparse matrix of the inner nodes.
        A form of scikit-fem would be evaluated pair by pair, which would take longer
        than the solution.
        """
        first, second = self._metric
        fields = np.hstack(
            [mobility * first, mobility * second, storage * self._measure]
        ) * np.tile(self._dx, 3)
        pairs = (self._shapes * fields[:, None]) @ self._shapes.swapaxes(1, 2)
        return pairs, self._inner_matrix(pairs)

    def _inner_matrix(self, pairs: np.ndarray) -> csc_array:
        """Assemble the sparse matrix of the inner nodes from element matrices (e, i, j)."""
        row, start = self._sparse
        summed = np.zeros(self._slot.max() + 1, pairs.dtype)
        np.add.at(summed, self._slot.ravel(), pairs.ravel())
        return csc_array((summed[: len(row)], row, start))

    def _matrix_product(self, pairs: np.ndarray, p: np.ndarray) -> np.ndarray:
        """Return the product (n, k) of element matrices (e, i, j) with nodal values p (n, k)."""
        return self._sum_at_nodes(pairs @ p[self.basis.element_dofs.T])

    def _sum_at_nodes(self, parts: np.ndarray) -> np.ndarray:
        """Return the sums (n, k) at the nodes of element contributions (e, i, k)."""
        return self._gather @ parts.reshape(self._gather.shape[1], parts.shape[2])

    def _load_vectors(self, shapes: Sequence[np.ndarray]) -> np.ndarray:
        """Return the load vectors int q W dA (s, n) of shapes W (s, e, q)."""
        values = self._shapes[:, :, -self.area.shape[1] :].real
        parts = values @ (
            self.area * np.reshape(shapes, (-1, *self.area.shape))
        ).transpose(1, 2, 0)
        return self._sum_at_nodes(parts).T


def film_mobility(height: float | np.ndarray, inertia: complex) -> complex | np.ndarray:
    """Return the mobility of the air in a gap of height h.

    It is 12/k^2 (h - 2/k tanh(k h/2)) with k = `inertia`, and h^3 for k = 0.
    """
    x = inertia * height / 2
    small = np.abs(x) < 0.05
    safe = np.where(small, 1.0, x)
    return height**3 * np.where(
        small,
        1 - 0.4 * x**2 + 17 / 105 * x**4,
        3 * (1 - np.tanh(safe) / safe) / safe**2,
    )
