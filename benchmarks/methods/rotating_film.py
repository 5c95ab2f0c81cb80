"""Steady compressible film under a rotating wedge, from Newton's method.

It is the reference for the constants of dynamics/film/wedge.py and the table
sonify/sound/sources/rim_flow.csv.
"""

from collections.abc import Callable, Sequence

import numpy as np
from scipy.sparse.linalg import splu

from dynamics.film.reynolds import FilmMesh, wedge_gap

UPWIND_GAPS = (0.005, 0.05)
"""Gaps, divided by the mean gap, below which artificial diffusion stabilises the
solution.

The second value is used if the solution does not converge with the first.
"""


class RotatingFilmMesh(FilmMesh):
    """A `FilmMesh` whose gap rotates steadily, with its parameters."""

    def __init__(
        self,
        cells: int = 16,
        height: Callable = wedge_gap,
        nearest: float = 7.0,
        parity: int = 0,
    ):
        super().__init__(cells, height, nearest=nearest, parity=parity)
        a, b = np.asarray(self.basis.global_coordinates())
        t = np.exp(a) + 1j * np.sinh(b)
        around = 1j * self.points * np.conj(-2 / t**2)
        self._around = np.array([around.real * np.cosh(b), around.imag * np.exp(a)])
        corners = self.basis.mesh.p[:, self.basis.mesh.t]
        sizes = np.ptp(corners, axis=1)[:, :, None] * self._measure
        rate = sum(
            np.abs(turn) / size
            for turn, size in zip(
                self._around,
                sizes,
                strict=True,
            )
        )
        self._upwind_angle = 1 / (
            4 * rate
        )  # a quarter of the angle covered by one element
        self._node_height = height(self.nodes.real, self.nodes.imag)

    def steady_rotating_pressure(
        self, Lam: float, guess=None, falling: float = 0.0
    ) -> np.ndarray:
        """Return the pressure (n,) over the ambient one in a steadily rotating gap.

        Newton's method solves div(P h^3 grad P) = -Lam d(P h)/dtheta - falling P h for
        isothermal air in the rotating frame.

        Parameters
        ----------
        Lam : float
            Compressibility number 12 mu Omega/(p_a beta^2).
        guess : (n,) array, optional
            Initial pressure; the ambient pressure by default.
        falling : float
            Squeeze number 12 mu omega_1/(p_a beta^3).

        Raises
        ------
        ArithmeticError
            If the method does not converge.
        """
        for upwind_gap in UPWIND_GAPS:
            P = self._newton(
                np.ones(self.basis.N) if guess is None else guess,
                Lam,
                falling,
                upwind_gap,
            )
            if P is not None:
                return P
        raise ArithmeticError(
            f"the compressible film does not converge at Lam = {Lam:g}, falling = {falling:g}"
        )

    def _newton(
        self,
        P,
        Lam,
        falling,
        upwind_gap,
        tolerance=1e-9,
        max_steps=30,
        max_step_lengths=6,
    ):
        """Return the pressure (n,) from damped Newton steps; None if they diverge.

        Each step is halved, at most `max_step_lengths` - 1 times, until the error
        decreases.
        """
        inner = self._inner
        rest = self._nodal_residual(P, Lam, falling, upwind_gap)[self._inner]
        for _ in range(max_steps):
            factors = splu(self._residual_jacobian(P, Lam, falling, upwind_gap))
            step = factors.solve(-rest)
            for part in 0.5 ** np.arange(max_step_lengths):
                ahead = P.copy()
                ahead[inner] += part * step
                rest = self._nodal_residual(ahead, Lam, falling, upwind_gap)[inner]
                if (
                    np.abs(factors.solve(rest)).max()
                    <= (1 - part / 4) * np.abs(step).max()
                ):
                    break
            P = ahead
            if np.abs(step).max() < tolerance * P.max():
                return P
        return None

    def rim_mass_flow(
        self, P, Lam: float, orders: int = 3, falling: float = 0.0
    ) -> np.ndarray:
        """Return the mass outflow at the rim for a `steady_rotating_pressure` P.

        It is ordered as FilmResponse.rim, in units of p_a g^3/(12 mu). It is computed
        as the residual at the rim, with the value of UPWIND_GAPS for which P was
        solved.
        """
        left = (
            self._nodal_residual(P, Lam, falling, upwind_gap)
            for upwind_gap in UPWIND_GAPS
        )
        return -min(
            left, key=lambda rest: np.abs(rest[self._inner]).max()
        ) @ self._waves(orders)

    def integral(self, p, shape=1.0) -> float:
        """Return int p W dA for nodal values p (n,) and a shape W at `points`."""
        return float((self.area * np.asarray(self.basis.interpolate(p)) * shape).sum())

    def _flow(self, P, Lam, falling, upwind_gap):
        """Return fluxes and source (3, e, q), and their derivatives (3, 3, e, q).

        The rows are multiplied by the slopes and the value of a test function, the
        columns by those of the change of P. They include the artificial diffusion near
        the contact.
        """
        # Driving pressure where the solution is zero, divided by the ambient pressure. The
        # driving pressure is a smooth positive function of the solution, because the solution
        # may oscillate below zero near the contact.
        min_driving_pressure = 0.01
        p, h = (self.basis.interpolate(field) for field in (P, self._node_height))
        along = self.height**3 * np.array(self._metric)
        turn = self._around / self._measure
        around = Lam * self.height * self._around
        source = falling * self.height * self._measure
        spread = (
            Lam
            * self._upwind_angle
            / (1 + (self.height / upwind_gap) ** 2)
            * self._measure
            * turn
        )
        root = np.sqrt(
            p * p + 4 * min_driving_pressure**2
        )  # keeps the driving pressure positive
        driven = (p + root) / 2
        slope = (1 + p / root) / 2
        turned_p, turned_h = ((turn * field.grad).sum(axis=0) for field in (p, h))
        flow = (
            driven * along * p.grad
            + p * around
            + spread * (h * turned_p + p * turned_h)
        )
        by = np.zeros((3, 3, *self.height.shape))
        by[[0, 1], [0, 1]] = driven * along
        by[:2, :2] += spread[:, None] * h * turn
        by[:2, 2] = slope * along * p.grad + around + spread * turned_h
        by[2, 2] = -source
        return np.array([*flow, -source * p]), by

    def _nodal_residual(self, P, Lam, falling, upwind_gap):
        """Return the nodal residual (n,) of `steady_rotating_pressure`."""
        flow = self._flow(P, Lam, falling, upwind_gap)[0] * self._dx
        return self._sum_at_nodes(self._shapes.real @ np.hstack(flow)[:, :, None])[:, 0]

    def _residual_jacobian(self, P, Lam, falling, upwind_gap):
        """Return the Jacobian (k, k) of the residual at the inner nodes."""
        shapes = self._shapes.real
        by = self._flow(P, Lam, falling, upwind_gap)[1] * self._dx
        moved = np.einsum(
            "abeq,eibq->eiaq", by, shapes.reshape(*shapes.shape[:2], 3, -1)
        )
        return self._inner_matrix(shapes @ moved.reshape(shapes.shape).swapaxes(1, 2))


def compressible_wedge_response(
    numbers: Sequence[float], mesh: RotatingFilmMesh, orders: int = 3
):
    """Return lift, power and rim flow of a rotating wedge at ascending Lam (l,).

    The dipole int V (x + i y) dA equals i pi/4. The last column of the flow, for exp(i
    theta), is therefore g1; its phase is the phase lead of the flow.

    Returns
    -------
    lift : (l,) array
        Lift divided by p_a pi R^2.
    power : (l,) array
        Power divided by the power for incompressible air.
    flow : (l, 2 k + 1) array
        Outflow at the rim by order, divided by the dipole of the face.
    """
    y = mesh.points.imag
    P = None
    rows = []
    incompressible_power = mesh.linear_responses([y], [y])[0].works[0].real
    for Lam in numbers:
        P = mesh.steady_rotating_pressure(Lam, P)
        power = mesh.integral(P - 1, y) / (Lam * incompressible_power)
        rows.append(
            (
                mesh.integral(P - 1) / np.pi,
                power,
                mesh.rim_mass_flow(P, Lam, orders) / (-0.25j * np.pi * Lam),
            )
        )
    return tuple(np.array(column) for column in zip(*rows, strict=True))
