"""Reynolds' equation on the film under the disk, by finite elements that are graded to the contact.

Lengths over the radius R, gaps over the mean gap g = R sin(beta): the wedge is h = 1 + x, and x = -1 the contact, where
it closes. The inversion z = 2/(X + i Y) - 1 takes the half plane X > 1 to the disk, its edge to the rim, infinity to
the contact, and h is 2 X/(X^2 + Y^2). A mesh in a, b with X = exp(a), Y = sinh(b), even in b and sqrt(a), is graded to
the contact and to the rim: there a stiff film has its flow, and next to the contact its gap is nearly closed.
tests/test_film_solved.py.
"""

from collections.abc import Callable, Sequence
from typing import NamedTuple

import numpy as np
from scipy.sparse import csc_array
from scipy.sparse.linalg import splu
from skfem import Basis, ElementQuad2, MeshQuad

TOLERANCE, MOST_STEPS, MOST_HALVED = 1e-9, 30, 6
"""Of Newton's method for the compressible film, and of the halvings of a step of it."""
LEAST_PRESSURE, NEAR = 0.01, (0.005, 0.05)
"""Pressure of which air is driven on however the nodes next to the contact swing; and the gap, over the mean one, below
which the elements are too long for what happens along them, so that air is spread over them: the second on meshes on
which the first is not enough."""


def wedge(x, y):
    """Return the gap of a flat disk on its edge, over the mean gap."""
    return 1 + x


class Response(NamedTuple):
    """What a film answers to a gap that opens at the velocity V, of unit order.

    `pressure` (n,) over 12 mu R^2 V/g^3 on the nodes of the mesh; `works` of it on given shapes, int p W dA/R^2; and
    `rim` (2 k + 1,), of the orders 0, 1, .., k, -k, .., -1, the flow out of the rim int q exp(-i n theta) ds/(R^2 V).
    """

    pressure: np.ndarray
    works: np.ndarray
    rim: np.ndarray


class FilmMesh:
    """Quadratic elements on the film of a gap `height`(x, y), `cells` of them inwards from the rim, twice that along.

    The mesh ends where the contact is as near as exp(-nearest) of the radius.

    `points` (e, q) are the places x + i y at which velocities and shapes are given, `area` (e, q) their weights in an
    integral over the face. At the rim the pressure is that of the air around. Of what is even (1) or odd (-1) in y, the
    `parity`, half the mesh is enough, where the gap is even.
    """

    def __init__(self, cells: int = 16, height: Callable = wedge, nearest: float = 7.0, parity: int = 0):
        across, along = nearest * np.linspace(0, 1, cells + 1) ** 2, np.linspace(-nearest, nearest, 2 * cells + 1)
        along, self.parity = along[cells:] if parity else along, parity
        self.basis = Basis(MeshQuad.init_tensor(across, along), ElementQuad2())
        a, b = np.asarray(self.basis.global_coordinates())
        t, dX, dY = np.exp(a) + 1j * np.sinh(b), np.exp(a), np.cosh(b)
        self._dx = (2 if parity else 1) * self.basis.dx
        self.points, self.area = 2 / t - 1, 4 / np.abs(t) ** 4 * dX * dY * self._dx
        around = 1j * self.points * np.conj(-2 / t**2)
        self._metric = {"first": dY / dX, "second": dX / dY}
        self._around = {"first": around.real * dY, "second": around.imag * dX}
        self._measure = 4 / np.abs(t) ** 4 * dX * dY
        corners = self.basis.mesh.p[:, self.basis.mesh.t]
        sizes = np.ptp(corners, axis=1)[:, :, None] * self._measure
        rate = sum(np.abs(turn) / size for turn, size in zip(self._around.values(), sizes, strict=True))
        self._crossed = 1 / (4 * rate)  # a quarter of the angle in which the turning crosses an element
        self.height = height(self.points.real, self.points.imag)
        each = [shape[0] for shape in self.basis.basis]
        self._shapes = np.array([np.hstack([*s.grad, np.asarray(s)]) for s in each], complex).swapaxes(0, 1).copy()
        a, b = self.basis.doflocs
        self.nodes = 2 / (np.exp(a) + 1j * np.sinh(b)) - 1
        self._known_waves: dict = {}
        self._node_height = height(self.nodes.real, self.nodes.imag)
        self._inner = np.flatnonzero((a > 1e-9) & ((b > 1e-9) | (parity != -1)))
        self._prepare()

    def _prepare(self):
        """Where in a sparse matrix of inner nodes the pairs (e, i, j) of the elements belong; others after it."""
        count, place = len(self._inner), np.full(self.basis.N, -1)
        place[self._inner] = np.arange(count)
        row, column = (place[self.basis.element_dofs.T][at] for at in (np.s_[:, :, None], np.s_[:, None, :]))
        key, self._slot = np.unique(
            np.where((row < 0) | (column < 0), count**2, column * count + row), return_inverse=True
        )
        key = key[key < count**2]
        self._sparse = key % count, np.searchsorted(key, count * np.arange(count + 1))

    def linear(
        self, velocities, shapes, sigma: float = 0.0, inertia: complex = 0.0, orders: int = 3, slip: float = 0.0
    ) -> list[Response]:
        """Return the Response to each of `velocities` (v, e, q) at the rate e^{i w t}, whose work is done on `shapes`.

        div(m(h) grad p) - i sigma h p = V, sigma = 12 mu w R^2/(p_a g^2), the air isothermal, its pressure little
        changed; `inertia` is g sqrt(i w rho/mu), with which the mobility m, h^3 without it, is that of unsteady flow;
        `slip`, the mean free path over g, adds 6 slip h^2 to it, as Maxwell found.
        """
        mobility = mobility_of(self.height, inertia) + 6 * slip * self.height**2
        pairs, matrix = self._stiffness(mobility, 1j * sigma * self.height)
        loads = self._loads(velocities)
        works = loads if shapes is velocities else self._loads(shapes)
        inner, p = self._inner, np.zeros(loads.shape, complex)
        factors, rest = splu(matrix), loads.astype(complex)
        p[:, inner] = [factors.solve(-row[inner]) for row in rest]
        rim = -(rest + self._times(pairs, p.T).T) @ self._waves(orders)
        return [Response(*answer) for answer in zip(p, p @ works.T, rim, strict=True)]

    def at_rim(self, mobility, storage, velocities, orders: int) -> tuple[np.ndarray, np.ndarray]:
        """Return what flows out at the rim, int q W ds for the waves W = cos n theta, n <= `orders`, then sin n theta.

        The film is div(m grad p) = V + storage p. For each of `velocities` V (v, e, q) with nothing at the rim, (w, v);
        and what less for a pressure there that is one of the waves, (w, w).
        """
        (pairs, matrix), inner, waves = self._stiffness(mobility, storage), self._inner, self._waves(orders)
        p = np.hstack([waves.real[:, : orders + 1], -waves.imag[:, 1 : orders + 1]]).astype(complex)
        p[inner] -= splu(matrix).solve(self._times(pairs, p)[inner])
        return -p.T @ self._loads(velocities).T, p.T @ self._times(pairs, p)

    def turning(self, Lam: float, guess=None, falling: float = 0.0) -> np.ndarray:
        """Return the pressure (n,) over that around of a gap that turns steadily, Lam = 12 mu Omega/(p_a beta^2).

        div(P h^3 grad P) = -Lam d(P h)/dtheta - falling P h in the frame that turns, isothermal, by Newton's method
        from `guess`; `falling` is 12 mu omega_1/(p_a beta^3). Raises ArithmeticError where that does not converge.
        """
        for near in NEAR:
            P = self._newton(np.ones(self.basis.N) if guess is None else guess, Lam, falling, near)
            if P is not None:
                return P
        raise ArithmeticError(f"the compressible film does not converge at Lam = {Lam:g}, falling = {falling:g}")

    def _newton(self, P, Lam, falling, near):
        """The pressure (n,) by damped steps, None where they do not converge."""
        inner, rest = self._inner, self._left(P, Lam, falling, near)[self._inner]
        for _ in range(MOST_STEPS):
            factors = splu(self._slope(P, Lam, falling, near))
            step = factors.solve(-rest)
            for part in 0.5 ** np.arange(MOST_HALVED):
                ahead = P.copy()
                ahead[inner] += part * step
                rest = self._left(ahead, Lam, falling, near)[inner]
                if np.abs(factors.solve(rest)).max() <= (1 - part / 4) * np.abs(step).max():
                    break
            P = ahead
            if np.abs(step).max() < TOLERANCE * P.max():
                return P
        return None

    def flow_out(self, P, Lam: float, orders: int = 3, falling: float = 0.0) -> np.ndarray:
        """Return the mass that leaves at the rim under `turning`, as Response.rim, over p_a g^3/(12 mu).

        It is what the equation that P solves, whichever of NEAR that is, leaves at the rim.
        """
        left = (self._left(P, Lam, falling, near) for near in NEAR)
        return -min(left, key=lambda rest: np.abs(rest[self._inner]).max()) @ self._waves(orders)

    def integral(self, p, shape=1.0) -> float:
        """Return int p W dA over the face, of a nodal field p (n,) and a shape W at the points."""
        return float((self.area * np.asarray(self.basis.interpolate(p)) * shape).sum())

    def _waves(self, orders):
        """exp(-i n theta) on the rim, continued inwards as z^n, at the nodes, (n, 2 k + 1)."""
        if orders in self._known_waves:
            return self._known_waves[orders]
        n = np.concatenate([np.arange(orders + 1), np.arange(-orders, 0)])
        z, other = self.nodes[:, None] ** np.abs(n), np.conj(self.nodes)[:, None] ** np.abs(n)
        waves, mirrored = np.where(n > 0, other, z), np.where(n > 0, z, other)
        self._known_waves[orders] = (waves + self.parity * mirrored) / 2 if self.parity else waves
        return self._known_waves[orders]

    def _stiffness(self, mobility, storage):
        """int m grad p . grad q + i sigma h p q dA of all pairs (e, i, j) in the elements, and the matrix of the inner
        nodes: by a form of scikit-fem, pair after pair, it takes longer than the solution."""
        first, second = self._metric.values()
        fields = np.hstack([mobility * first, mobility * second, storage * self._measure]) * np.tile(self._dx, 3)
        pairs = (self._shapes * fields[:, None]) @ self._shapes.swapaxes(1, 2)
        return pairs, self._among_inner(pairs)

    def _among_inner(self, pairs):
        """The matrix of the inner nodes, of pairs (e, i, j)."""
        row, start = self._sparse
        summed = np.zeros(self._slot.max() + 1, pairs.dtype)
        np.add.at(summed, self._slot.ravel(), pairs.ravel())
        return csc_array((summed[: len(row)], row, start))

    def _times(self, pairs, p):
        """The matrix of all nodes, of pairs (e, i, j), times p (n, k)."""
        return self._gathered(pairs @ p[self.basis.element_dofs.T])

    def _gathered(self, parts):
        """The sums (n, k) at the nodes of what the nodes of the elements have, (e, i, k)."""
        out = np.zeros((self.basis.N, parts.shape[2]), parts.dtype)
        np.add.at(out, self.basis.element_dofs.T, parts)
        return out

    def _loads(self, shapes):
        """int q W dA of shapes W (s, e, q), (s, n)."""
        values = self._shapes[:, :, -self.area.shape[1] :].real
        parts = values @ (self.area * np.reshape(shapes, (-1, *self.area.shape))).transpose(1, 2, 0)
        return self._gathered(parts).T

    def _flow(self, P, Lam, falling, near):
        """What in the equation of `turning` works on slopes and value of a test function, (3, e, q), and how it changes
        with slopes and value of P, (3, 3, e, q); with what spreads air next to the contact."""
        p, h = (self.basis.interpolate(field) for field in (P, self._node_height))
        along, around = (np.array([*parts.values()]) for parts in (self._metric, self._around))
        along, turn, around = self.height**3 * along, around / self._measure, Lam * self.height * around
        source = falling * self.height * self._measure
        spread = Lam * self._crossed / (1 + (self.height / near) ** 2) * self._measure * turn
        root = np.sqrt(p * p + 4 * LEAST_PRESSURE**2)  # air is driven by a pressure that is kept above nothing
        driven, slope = (p + root) / 2, (1 + p / root) / 2
        turned_p, turned_h = ((turn * field.grad).sum(axis=0) for field in (p, h))
        flow = driven * along * p.grad + p * around + spread * (h * turned_p + p * turned_h)
        by = np.zeros((3, 3, *self.height.shape))
        by[[0, 1], [0, 1]] = driven * along
        by[:2, :2] += spread[:, None] * h * turn
        by[:2, 2] = slope * along * p.grad + around + spread * turned_h
        by[2, 2] = -source
        return np.array([*flow, -source * p]), by

    def _left(self, P, Lam, falling, near):
        """What a pressure (n,) leaves of the equation of `turning` at the nodes, (n,)."""
        flow = self._flow(P, Lam, falling, near)[0] * self._dx
        return self._gathered(self._shapes.real @ np.hstack(flow)[:, :, None])[:, 0]

    def _slope(self, P, Lam, falling, near):
        """The matrix (k, k) of what it leaves at the inner nodes by the pressure there."""
        shapes, by = self._shapes.real, self._flow(P, Lam, falling, near)[1] * self._dx
        moved = np.einsum("abeq,eibq->eiaq", by, shapes.reshape(*shapes.shape[:2], 3, -1))
        return self._among_inner(shapes @ moved.reshape(shapes.shape).swapaxes(1, 2))


def mobility_of(height, inertia: complex):
    """Return the mobility of air in a gap, h^3 where it has no inertia: 12/k^2 (h - 2/k tanh(k h/2)), k = `inertia`."""
    x = inertia * height / 2
    small = np.abs(x) < 0.05
    safe = np.where(small, 1.0, x)
    return height**3 * np.where(small, 1 - 0.4 * x**2 + 17 / 105 * x**4, 3 * (1 - np.tanh(safe) / safe) / safe**2)


def compressible(numbers: Sequence[float], mesh: FilmMesh, orders: int = 3):
    """Return lift over p_a pi R^2 (l,), power over that of incompressible air (l,), and the orders of the flow out of
    the rim (l, 2 k + 1) over the dipole of the face, of a wedge that turns, for numbers Lam (l,) in ascending order.

    The dipole int V (x + i y) dA is i pi/4: so row[-1], of exp(i theta), is g1, which leads where its phase does.
    """
    y, P, rows = mesh.points.imag, None, []
    slow = mesh.linear([y], [y])[0].works[0].real
    for Lam in numbers:
        P = mesh.turning(Lam, P)
        power = mesh.integral(P - 1, y) / (Lam * slow)
        rows.append((mesh.integral(P - 1) / np.pi, power, mesh.flow_out(P, Lam, orders) / (-0.25j * np.pi * Lam)))
    return tuple(np.array(column) for column in zip(*rows, strict=True))
