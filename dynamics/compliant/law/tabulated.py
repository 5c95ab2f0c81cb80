"""Contact law tabulated over the inclination, for time stepping."""

from dataclasses import dataclass
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike
from scipy.interpolate import CubicSpline, PchipInterpolator, PPoly

from dynamics.compliant.law.hertz_mindlin import (
    MIN_CONTACT_INCLINATION,
    ContactLaw,
    ContactSprings,
)
from dynamics.compliant.law.linearised import (
    RIGID_FLEXIBILITY,
    LinearContact,
    Resonances,
    linear_contact,
    mobility,
    normal_damping,
    resonances,
)
from dynamics.compliant.law.spin_friction import slip_arm, spin_creep_moment_coefficient

LOG_SINE_GRID_STEP = 0.02
"""Grid step in ln sin(beta); the splines are accurate to 1e-8, the lengths to 2e-5."""


class LawColumns(NamedTuple):
    """Indices of the columns of a tabulated law, which applies under the weight."""

    hertz_stiffness: int
    """K [N/m^1.5]"""
    half_length: int
    """Half-length a of the ellipse [m]."""
    stiffness_1: int
    """Tangential stiffness k1 along the rolling direction [N/m]."""
    stiffness_2: int
    """Tangential stiffness k2 across the rolling direction [N/m]."""
    relaxation_length_1: int
    """Relaxation length l1 along the rolling direction [m]."""
    relaxation_length_2: int
    """Relaxation length l2 across the rolling direction [m]."""
    loss_coefficient: int
    """c in N = K d^1.5 (1 + c d') [s/m]."""
    slip_arm: int
    """Arm of the moment of full slip in pivoting at mu = 1 [m]."""
    creep_moment: int
    """Moment of spin creep divided by normal force and creepage [m^2]."""


LAW_COLUMNS = LawColumns(*range(len(LawColumns._fields)))


@dataclass(frozen=True, kw_only=True)
class TabulatedLaw:
    """Columns of a contact law tabulated over x = ln sin(beta).

    The half-length and all springs are proportional to the cube root of the load.

    Attributes
    ----------
    law : ContactLaw
        Law of the contact.
    damping : float, optional
        Damping under the weight [N s/m], which replaces the loss factor of the law.
    edge : modal.Edge, optional
        Flexibility of the edge, in series with the springs; None for a rigid disk.
    max_moving_frequency : float
        Modes below this frequency [Hz] are excluded from the vertical flexibility,
        because they are solved in time (rim_modes.py).
    """

    law: ContactLaw
    damping: float | None = None
    edge: Any = None
    max_moving_frequency: float = 0.0

    @cached_property
    def grid(self) -> np.ndarray:
        """Nodes (n,) of x, from below MIN_CONTACT_INCLINATION to an upright disk."""
        return LOG_SINE_GRID_STEP * np.arange(
            np.floor(np.log(MIN_CONTACT_INCLINATION / 2) / LOG_SINE_GRID_STEP), 1
        )

    @property
    def inclinations(self) -> np.ndarray:
        """Inclinations (n,) [rad] of the nodes."""
        return np.arcsin(np.minimum(np.exp(self.grid), 1.0))

    @cached_property
    def spline(self) -> PPoly:
        """Cubic spline of the columns over the grid."""
        return positive_interpolants(self.grid, self._tabulated())

    @cached_property
    def stiffness(self) -> PPoly:
        """K [N/m^1.5] as a piecewise polynomial in x."""
        return PPoly(self.spline.c[:, :, LAW_COLUMNS.hertz_stiffness], self.grid)

    def _tabulated(self) -> np.ndarray:
        """Return the columns (n, 9) of the law at the nodes."""
        beta = self.inclinations
        load = self.law.disk.weight
        springs = self.law.springs(beta, load)
        c = (
            normal_damping(
                self.law,
                beta,
                load,
            )
            if self.damping is None
            else np.full(len(beta), self.damping)
        )
        columns = (
            self.law.stiffness(beta),
            self.law.semi_axes(beta, load)[0],
            *springs[:2],
            *springs[3:],
            c / load,
            slip_arm(self.law, beta, load),
            spin_creep_moment_coefficient(self.law, beta, load),
        )
        return np.column_stack(columns)

    def columns(self, inclination: ArrayLike) -> np.ndarray:
        """Return the tabulated columns (k, 9) at inclinations (k,) [rad].

        They apply to a normal force equal to the weight.
        """
        return self.spline(np.log(np.sin(inclination)))

    def springs(
        self, inclination: ArrayLike, load: Any
    ) -> tuple[ContactSprings, np.ndarray, np.ndarray]:
        """Return springs, half-length [m] and damping [N s/m] under loads (k,) [N]."""
        value = self.columns(inclination).T
        root = np.cbrt(load / self.law.disk.weight)
        kn = 1.5 * value[LAW_COLUMNS.hertz_stiffness] ** (2 / 3) * np.cbrt(load)
        springs = ContactSprings(
            value[LAW_COLUMNS.stiffness_1] * root,
            value[LAW_COLUMNS.stiffness_2] * root,
            kn,
            value[LAW_COLUMNS.relaxation_length_1] * root,
            value[LAW_COLUMNS.relaxation_length_2] * root,
        )
        return (
            springs,
            value[LAW_COLUMNS.half_length] * root,
            value[LAW_COLUMNS.loss_coefficient] * load,
        )

    def linear_contact(
        self,
        inclination: ArrayLike,
        load: ArrayLike,
        speed: ArrayLike = 0.0,
        rolls: ArrayLike = True,
    ) -> LinearContact:
        """Return the linearised contact at inclinations [rad], loads [N], speeds [m/s].

        The arguments are (k,). A contact that does not roll has no spring along a_2.
        """
        springs, _, c = self.springs(inclination, load)
        springs = springs._replace(k2=np.where(rolls, springs.k2, 0.0))
        return linear_contact(
            self.law.disk,
            inclination,
            springs,
            speed,
            c,
            flexibility=self.flexibility(inclination),
            fillet=self.law.rolling_fillet,
        )

    def contact_resonance(
        self, inclination: ArrayLike, load: ArrayLike, speed: ArrayLike
    ) -> Resonances:
        """Return frequency (k,) [Hz] and loss factor (k,) of the contact resonance.

        The arguments (k,) are inclination [rad], normal force [N] and speed of the
        rolling contact along its path [m/s].
        """
        found = resonances(self.linear_contact(inclination, load, speed))
        return Resonances(found.frequency[:, 2], found.loss_factor[:, 2])

    def flexibility(self, inclination: ArrayLike) -> np.ndarray:
        """Return the edge flexibility (k, 3, 3) [m/N] at inclinations (k,) [rad]."""
        return (
            RIGID_FLEXIBILITY
            if self.edge is None
            else self.flexibility_spline(np.log(np.sin(inclination)))
        )

    @cached_property
    def flexibility_spline(self) -> CubicSpline:
        """Spline of the edge flexibility at the frequency w of the contact resonance.

        The resonance is that under the weight. F(w) = F + sum of s s^T w^2/(w_i^2
        (w_i^2 - w^2)) over the modes s makes it exact. For the lateral components, w^2
        is at most `max_lateral_frequency_ratio` times that of the lowest mode, because
        that mode may move the contact only laterally.
        """
        # for the frequency of the contact resonance
        bisection_steps = 40
        # largest squared frequency of the lateral flexibility over that of the lowest mode
        max_lateral_frequency_ratio = 0.5
        beta = self.inclinations
        edge = self.edge
        turn = rotations_to_contact(beta)
        shapes = edge.shapes @ turn.swapaxes(1, 2)
        raised = shapes[:, :, 2] ** 2
        still = turn @ edge.flexibility @ turn.swapaxes(1, 2)
        springs = self.law.springs(beta, self.law.disk.weight)
        W = mobility(self.law.disk, beta, self.law.rolling_fillet)[:, 2, 2]
        lowest = edge.squared.min(initial=np.inf)
        low = np.zeros(len(beta))
        high = np.minimum(lowest, springs.kn * W)
        for _ in range(bisection_steps):
            square = (low + high) / 2
            normal = still[:, 2, 2] + (
                raised * dynamic_flexibility(edge.squared, square)
            ).sum(axis=1)
            below = square * (1 / springs.kn + normal) < W
            low = np.where(below, square, low)
            high = np.where(below, high, square)
        sideways = dynamic_flexibility(
            edge.squared,
            np.minimum(square, max_lateral_frequency_ratio * lowest),
        )
        yields = still + (shapes.swapaxes(1, 2) * sideways[:, None]) @ shapes
        part = np.where(
            edge.squared < (2 * np.pi * self.max_moving_frequency) ** 2,
            -1 / edge.squared,
            dynamic_flexibility(edge.squared, square),
        )
        yields[:, 2, 2] = still[:, 2, 2] + (raised * part).sum(axis=1)
        return CubicSpline(
            self.grid, bounded_flexibility(yields, np.column_stack(springs[:3]))
        )


def rotations_to_contact(inclination: np.ndarray) -> np.ndarray:
    """Return the rotations (k, 3, 3) from radius, rim and axis of the disk to a_1, a_2, a_3
    at inclinations (k,) [rad]."""
    turn = np.zeros((len(inclination), 3, 3))
    turn[:, 0, 1] = -1.0
    turn[:, 1, 0] = np.cos(inclination)
    turn[:, 2, 2] = np.cos(inclination)
    turn[:, 1, 2] = np.sin(inclination)
    turn[:, 2, 0] = -np.sin(inclination)
    return turn


def positive_interpolants(grid: np.ndarray, columns: np.ndarray) -> PPoly:
    """Return interpolants of positive columns (n, k) at the nodes (n,).

    A column that changes steeply between nodes, where a spline might become negative,
    has a monotone interpolant.
    """
    max_node_ratio = 2.0  # ratio of the values at neighbouring nodes
    above = np.maximum(columns[1:], columns[:-1])
    below = np.minimum(columns[1:], columns[:-1])
    leaps = np.any(above > max_node_ratio * below, axis=0)
    smooth = CubicSpline(grid, columns)
    if not leaps.any():
        return smooth
    monotone = PchipInterpolator(grid, columns)
    return PPoly(np.where(leaps, monotone.c, smooth.c), grid)


def dynamic_flexibility(
    mode_frequency_squared: np.ndarray, frequency_squared: np.ndarray
) -> np.ndarray:
    """Return w^2/(w_i^2 (w_i^2 - w^2)) (k, m) for modes w_i (m,) at frequencies w (k,).

    It is the flexibility of a mode at w minus its static flexibility.
    """
    w2 = frequency_squared[:, None]
    return w2 / (mode_frequency_squared * (mode_frequency_squared - w2))


def bounded_flexibility(flexibility: np.ndarray, stiffness: np.ndarray) -> np.ndarray:
    """Return flexibilities (k, 3, 3) [m/N] with a lower bound.

    The bound is -`max_negative_flexibility` times the flexibility of springs (k, 3)
    [N/m] in series. The edge flexibility excludes the deformation near the contact,
    which the springs include, and the modes solved in time, so it can be negative. If
    the ellipse is as long as the waves of these modes, the total could become negative
    as well.
    """
    # largest negative flexibility of the edge over the flexibility of the springs
    max_negative_flexibility = 0.5
    root = np.sqrt(stiffness)
    part, axes = np.linalg.eigh(flexibility * root[:, :, None] * root[:, None, :])
    raised = np.maximum(-max_negative_flexibility - part, 0.0)
    back = axes / root[:, :, None]
    return flexibility + (back * raised[:, None]) @ back.swapaxes(1, 2)


class EdgeSeriesLaw(TabulatedLaw):
    """Tabulated law with the flexibility of the edge in series with every spring.

    Creep forces and contact losses are unchanged. All springs scale with the load like
    the Hertz contact. The coupling between the directions a_1, a_2, a_3 is neglected:
    the error of the contact resonance is 0.3 to 0.9 % for the toy, and up to 6 % for an
    upright coin (tests/contact_law/test_edge_flexibility.py).
    """

    def flexibility(self, inclination: ArrayLike) -> np.ndarray:
        """Return zero flexibility, because the springs include it."""
        return RIGID_FLEXIBILITY

    def _tabulated(self) -> np.ndarray:
        columns = super()._tabulated()
        one = np.ones(len(self.grid))
        kn = (
            1.5
            * columns[:, LAW_COLUMNS.hertz_stiffness] ** (2 / 3)
            * np.cbrt(self.law.disk.weight)
        )
        stiffness = np.column_stack(
            [columns[:, [LAW_COLUMNS.stiffness_1, LAW_COLUMNS.stiffness_2]], kn]
        )
        yields = super().flexibility(self.inclinations)
        first, second, normal = (
            1 / (1 + stiffness * np.diagonal(yields, axis1=-2, axis2=-1))
        ).T
        return columns * np.column_stack(
            [
                normal**1.5,
                one,
                first,
                second,
                1 / first,
                1 / second,
                normal**2,
                one,
                one,
            ]
        )
