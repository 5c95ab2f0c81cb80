"""Reynolds' equation for the film under the disk, by finite elements graded to the contact.

Lengths are over the radius R, gaps over the mean gap g = R sin(beta): the wedge is h = 1 + x and
closes at the contact x = -1. The inversion z = 2/(X + i Y) - 1 maps the half plane X > 1 to the
disk, its edge to the rim, infinity to the contact, and h is 2 X/(X^2 + Y^2). A mesh in a, b with X
= exp(a), Y = sinh(b), even in b and sqrt(a), is graded to the contact, where the gap nearly closes,
and to the rim, where a stiff film has its flow. tests/film/test_film_constants.py compares the solutions.
"""

from collections.abc import Callable, Sequence
from typing import NamedTuple

import numpy as np
from scipy.sparse import csc_array
from scipy.sparse.linalg import splu
from skfem import Basis, ElementQuad2, MeshQuad

from dynamics.air import HEAT_RATIO

NEWTON_TOLERANCE = 1e-9
"""Relative tolerance of Newton's method for the compressible film."""
MAX_NEWTON_STEPS = 30
"""Newton steps for the compressible film."""
MAX_HALVINGS = 6
"""Step sizes tried in one Newton step, each half of the one before."""
MIN_DRIVING_PRESSURE = 0.01
"""Smallest pressure that drives air, over the ambient pressure, in spite of oscillations near the
contact.
"""
UPWIND_GAPS = (0.005, 0.05)
"""Gaps, over the mean gap, below which the elements are too long and artificial diffusion acts.

The second gap serves meshes on which the first is not sufficient.
"""


def wedge_gap(x, y):
    """Return the gap of a flat disk on its edge, over the mean gap."""
    return 1 + x


class FilmResponse(NamedTuple):
    """Response of a film to a gap that opens at the velocity V, of unit order.

    Attributes
    ----------
    pressure : (n,) array
        Pressure over 12 mu R^2 V/g^3 at the nodes of the mesh.
    works : array
        Work on given shapes, int p W dA/R^2.
    rim : (2 k + 1,) array
        Orders 0, 1, .., k, -k, .., -1 of the flow out of the rim, int q exp(-i n theta) ds/(R^2 V).
    """

    pressure: np.ndarray
    works: np.ndarray
    rim: np.ndarray


class FilmMesh:
    """Quadratic elements on the film of a gap `height`(x, y), graded to contact and rim.

    At the rim the pressure is the ambient pressure.

    Parameters
    ----------
    cells : int
        Elements from the rim inwards; twice as many along the rim.
    height : callable
        Gap over the mean gap at (x, y).
    nearest : float
        The mesh ends at exp(-nearest) of the radius from the contact.
    parity : int
        1 for fields that are even in y, -1 for odd ones, 0 for all; half the mesh suffices for an
        even gap with parity.

    Attributes
    ----------
    points : (e, q) array
        Points x + i y at which velocities and shapes are given.
    area : (e, q) array
        Weights of these points in an integral over the face.
    """

    def __init__(
        self,
        cells: int = 16,
        height: Callable = wedge_gap,
        nearest: float = 7.0,
        parity: int = 0,
    ):
        across = nearest * np.linspace(0, 1, cells + 1) ** 2
        along = np.linspace(-nearest, nearest, 2 * cells + 1)
        along = along[cells:] if parity else along
        self.parity = parity
        self.basis = Basis(MeshQuad.init_tensor(across, along), ElementQuad2())
        a, b = np.asarray(self.basis.global_coordinates())
        t = np.exp(a) + 1j * np.sinh(b)
        dX = np.exp(a)
        dY = np.cosh(b)
        self._dx = (2 if parity else 1) * self.basis.dx
        self.points, self.area = 2 / t - 1, 4 / np.abs(t) ** 4 * dX * dY * self._dx
        around = 1j * self.points * np.conj(-2 / t**2)
        self._metric = {"first": dY / dX, "second": dX / dY}
        self._around = {"first": around.real * dY, "second": around.imag * dX}
        self._measure = 4 / np.abs(t) ** 4 * dX * dY
        corners = self.basis.mesh.p[:, self.basis.mesh.t]
        sizes = np.ptp(corners, axis=1)[:, :, None] * self._measure
        rate = sum(
            np.abs(turn) / size
            for turn, size in zip(
                self._around.values(),
                sizes,
                strict=True,
            )
        )
        self._crossed = 1 / (4 * rate)  # a quarter of the angle of one element
        self.height = height(self.points.real, self.points.imag)
        each = [shape[0] for shape in self.basis.basis]
        self._shapes = (
            np.array([np.hstack([*s.grad, np.asarray(s)]) for s in each], complex)
            .swapaxes(
                0,
                1,
            )
            .copy()
        )
        a, b = self.basis.doflocs
        self.nodes = 2 / (np.exp(a) + 1j * np.sinh(b)) - 1
        self._known_waves: dict = {}
        self._node_height = height(self.nodes.real, self.nodes.imag)
        self._inner = np.flatnonzero((a > 1e-9) & ((b > 1e-9) | (parity != -1)))
        self._prepare()

    def _prepare(self):
        """Find the places of the element pairs (e, i, j) in a sparse matrix of the inner nodes."""
        count = len(self._inner)
        place = np.full(self.basis.N, -1)
        place[self._inner] = np.arange(count)
        row, column = (
            place[self.basis.element_dofs.T][at] for at in (np.s_[:, :, None], np.s_[:, None, :])
        )
        key, self._slot = np.unique(
            np.where((row < 0) | (column < 0), count**2, column * count + row), return_inverse=True
        )
        key = key[key < count**2]
        self._sparse = key % count, np.searchsorted(key, count * np.arange(count + 1))

    def linear(
        self,
        velocities,
        shapes,
        sigma: float = 0.0,
        inertia: complex = 0.0,
        orders: int = 3,
        slip: float = 0.0,
        heat: complex = 0.0,
    ) -> list[FilmResponse]:
        """Return the FilmResponse to each of `velocities` (v, e, q) at the rate e^{i w t}, with the
        work on `shapes`.

        It solves div(m(h) grad p) - i sigma s(h) p = V for small pressure changes.

        Parameters
        ----------
        velocities, shapes : (v, e, q) arrays
            Opening velocities and shapes at the points.
        sigma : float
            12 mu w R^2/(p_a g^2).
        inertia : complex
            g sqrt(i w rho/mu); the mobility m is that of unsteady flow, h^3 without inertia.
        orders : int
            Highest order of the flow at the rim.
        slip : float
            Mean free path over g; adds 6 slip h^2 to the mobility (Maxwell).
        heat : complex
            k = g sqrt(i w rho c_p/kappa) of the heat conduction to the faces; s = h - (1 - 1/c) (h
            - 2/k tanh(k h/2)) with
            the ratio c of the specific heats (Tijdeman 1975), s = h for isothermal air.
        """
        mobility = film_mobility(self.height, inertia) + 6 * slip * self.height**2
        warmed = film_mobility(self.height, heat) * heat * heat / 12
        pairs, matrix = self._stiffness(
            mobility,
            1j * sigma * (self.height - (1 - 1 / HEAT_RATIO) * warmed),
        )
        loads = self._loads(velocities)
        works = loads if shapes is velocities else self._loads(shapes)
        inner = self._inner
        p = np.zeros(loads.shape, complex)
        factors = splu(matrix)
        rest = loads.astype(complex)
        p[:, inner] = [factors.solve(-row[inner]) for row in rest]
        rim = -(rest + self._times(pairs, p.T).T) @ self._waves(orders)
        return [FilmResponse(*answer) for answer in zip(p, p @ works.T, rim, strict=True)]

    def at_rim(self, mobility, storage, velocities, orders: int) -> tuple[np.ndarray, np.ndarray]:
        """Return the flow out of the rim, int q W ds, for the waves W = cos n theta, n <= `orders`,
        then sin n theta.

        The film obeys div(m grad p) = V + storage p. The first result (w, v) is for each of
        `velocities` V (v, e, q) with zero pressure at the rim, the second (w, w) the reduction by a
        pressure at the rim that is one of the waves.
        """
        (pairs, matrix) = self._stiffness(mobility, storage)
        inner = self._inner
        waves = self._waves(orders)
        p = np.hstack([waves.real[:, : orders + 1], -waves.imag[:, 1 : orders + 1]]).astype(complex)
        p[inner] -= splu(matrix).solve(self._times(pairs, p)[inner])
        return -p.T @ self._loads(velocities).T, p.T @ self._times(pairs, p)

    def turning(self, Lam: float, guess=None, falling: float = 0.0) -> np.ndarray:
        """Return the pressure (n,), over the ambient pressure, of a gap that turns steadily, Lam =
        12 mu Omega/(p_a beta^2).

        It solves div(P h^3 grad P) = -Lam d(P h)/dtheta - falling P h in the rotating frame for
        isothermal air, by Newton's method from `guess`; `falling` is 12 mu omega_1/(p_a beta^3).
        Raises ArithmeticError if the method does not converge.
        """
        for near in UPWIND_GAPS:
            P = self._newton(np.ones(self.basis.N) if guess is None else guess, Lam, falling, near)
            if P is not None:
                return P
        raise ArithmeticError(
            f"the compressible film does not converge at Lam = {Lam:g}, falling = {falling:g}"
        )

    def _newton(self, P, Lam, falling, near):
        """Return the pressure (n,) by damped Newton steps, or None if they do not converge."""
        inner = self._inner
        rest = self._left(P, Lam, falling, near)[self._inner]
        for _ in range(MAX_NEWTON_STEPS):
            factors = splu(self._slope(P, Lam, falling, near))
            step = factors.solve(-rest)
            for part in 0.5 ** np.arange(MAX_HALVINGS):
                ahead = P.copy()
                ahead[inner] += part * step
                rest = self._left(ahead, Lam, falling, near)[inner]
                if np.abs(factors.solve(rest)).max() <= (1 - part / 4) * np.abs(step).max():
                    break
            P = ahead
            if np.abs(step).max() < NEWTON_TOLERANCE * P.max():
                return P
        return None

    def flow_out(self, P, Lam: float, orders: int = 3, falling: float = 0.0) -> np.ndarray:
        """Return the mass flow out of the rim under `turning`, as FilmResponse.rim, over p_a
        g^3/(12 mu).

        It is the residual at the rim of the equation that P solves, for the gap of UPWIND_GAPS that
        fits.
        """
        left = (self._left(P, Lam, falling, near) for near in UPWIND_GAPS)
        return -min(left, key=lambda rest: np.abs(rest[self._inner]).max()) @ self._waves(orders)

    def integral(self, p, shape=1.0) -> float:
        """Return int p W dA over the face, for a nodal field p (n,) and a shape W at the points."""
        return float((self.area * np.asarray(self.basis.interpolate(p)) * shape).sum())

    def _waves(self, orders):
        """Return exp(-i n theta) on the rim, continued inwards as z^n, at the nodes (n, 2 k +
        1)."""
        if orders in self._known_waves:
            return self._known_waves[orders]
        n = np.concatenate([np.arange(orders + 1), np.arange(-orders, 0)])
        z = self.nodes[:, None] ** np.abs(n)
        other = np.conj(self.nodes)[:, None] ** np.abs(n)
        waves = np.where(n > 0, other, z)
        mirrored = np.where(n > 0, z, other)
        self._known_waves[orders] = (waves + self.parity * mirrored) / 2 if self.parity else waves
        return self._known_waves[orders]

    def _stiffness(self, mobility, storage):
        """Return int m grad p . grad q + i sigma h p q dA for all element pairs (e, i, j), and the
        matrix of the inner nodes.

        A form of scikit-fem, evaluated pair after pair, would take longer than the solution.
        """
        first, second = self._metric.values()
        fields = np.hstack(
            [mobility * first, mobility * second, storage * self._measure]
        ) * np.tile(self._dx, 3)
        pairs = (self._shapes * fields[:, None]) @ self._shapes.swapaxes(1, 2)
        return pairs, self._among_inner(pairs)

    def _among_inner(self, pairs):
        """Return the sparse matrix of the inner nodes from element pairs (e, i, j)."""
        row, start = self._sparse
        summed = np.zeros(self._slot.max() + 1, pairs.dtype)
        np.add.at(summed, self._slot.ravel(), pairs.ravel())
        return csc_array((summed[: len(row)], row, start))

    def _times(self, pairs, p):
        """Return the product of the matrix of all nodes, given as element pairs (e, i, j), with p
        (n, k).
        """
        return self._gathered(pairs @ p[self.basis.element_dofs.T])

    def _gathered(self, parts):
        """Return the sums (n, k) at the nodes of element contributions (e, i, k)."""
        out = np.zeros((self.basis.N, parts.shape[2]), parts.dtype)
        np.add.at(out, self.basis.element_dofs.T, parts)
        return out

    def _loads(self, shapes):
        """Return int q W dA (s, n) for shapes W (s, e, q)."""
        values = self._shapes[:, :, -self.area.shape[1] :].real
        parts = values @ (self.area * np.reshape(shapes, (-1, *self.area.shape))).transpose(1, 2, 0)
        return self._gathered(parts).T

    def _flow(self, P, Lam, falling, near):
        """Return the fluxes and sources (3, e, q) of the equation of `turning` and their
        derivatives (3, 3, e, q).

        The rows belong to the slopes and the value of a test function, the columns to those of P.
        Both include the artificial diffusion near the contact.
        """
        p, h = (self.basis.interpolate(field) for field in (P, self._node_height))
        along, around = (np.array([*parts.values()]) for parts in (self._metric, self._around))
        along = self.height**3 * along
        turn = around / self._measure
        around = Lam * self.height * around
        source = falling * self.height * self._measure
        spread = Lam * self._crossed / (1 + (self.height / near) ** 2) * self._measure * turn
        root = np.sqrt(p * p + 4 * MIN_DRIVING_PRESSURE**2)  # keeps the driving pressure positive
        driven = (p + root) / 2
        slope = (1 + p / root) / 2
        turned_p, turned_h = ((turn * field.grad).sum(axis=0) for field in (p, h))
        flow = driven * along * p.grad + p * around + spread * (h * turned_p + p * turned_h)
        by = np.zeros((3, 3, *self.height.shape))
        by[[0, 1], [0, 1]] = driven * along
        by[:2, :2] += spread[:, None] * h * turn
        by[:2, 2] = slope * along * p.grad + around + spread * turned_h
        by[2, 2] = -source
        return np.array([*flow, -source * p]), by

    def _left(self, P, Lam, falling, near):
        """Return the residual (n,) of the equation of `turning` at the nodes for a pressure
        (n,)."""
        flow = self._flow(P, Lam, falling, near)[0] * self._dx
        return self._gathered(self._shapes.real @ np.hstack(flow)[:, :, None])[:, 0]

    def _slope(self, P, Lam, falling, near):
        """Return the derivative (k, k) of the residual at the inner nodes by the pressure there."""
        shapes = self._shapes.real
        by = self._flow(P, Lam, falling, near)[1] * self._dx
        moved = np.einsum("abeq,eibq->eiaq", by, shapes.reshape(*shapes.shape[:2], 3, -1))
        return self._among_inner(shapes @ moved.reshape(shapes.shape).swapaxes(1, 2))


def film_mobility(height, inertia: complex):
    """Return the mobility of air in a gap: 12/k^2 (h - 2/k tanh(k h/2)), k = `inertia`; h^3 without
    inertia.
    """
    x = inertia * height / 2
    small = np.abs(x) < 0.05
    safe = np.where(small, 1.0, x)
    return height**3 * np.where(
        small,
        1 - 0.4 * x**2 + 17 / 105 * x**4,
        3 * (1 - np.tanh(safe) / safe) / safe**2,
    )


def compressible_wedge_response(numbers: Sequence[float], mesh: FilmMesh, orders: int = 3):
    """Return lift, power and rim flow of a turning wedge for ascending numbers Lam (l,).

    The dipole int V (x + i y) dA is i pi/4, so row[-1] of the flow, that of exp(i theta), is g1;
    its phase is the lead.

    Returns
    -------
    lift : (l,) array
        Lift over p_a pi R^2.
    power : (l,) array
        Power over that of incompressible air.
    flow : (l, 2 k + 1) array
        Orders of the flow out of the rim over the dipole of the face.
    """
    y = mesh.points.imag
    P = None
    rows = []
    incompressible_power = mesh.linear([y], [y])[0].works[0].real
    for Lam in numbers:
        P = mesh.turning(Lam, P)
        power = mesh.integral(P - 1, y) / (Lam * incompressible_power)
        rows.append(
            (
                mesh.integral(P - 1) / np.pi,
                power,
                mesh.flow_out(P, Lam, orders) / (-0.25j * np.pi * Lam),
            )
        )
    return tuple(np.array(column) for column in zip(*rows, strict=True))
