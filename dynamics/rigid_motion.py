"""Motion of a rigid disk on a rigid contact, with its force, energy and regimes."""

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike

from dynamics.disk import Disk
from dynamics.equations import ContactSolution, DiskConstants
from dynamics.face_contact import face_events
from dynamics.film.wedge import Film, film_powers, find_film
from dynamics.guards import STOP_SLIP_SPEED
from dynamics.kinematics import energy, precession_rate
from dynamics.monotonicity import largest_decrease
from dynamics.motion import (
    CAUSES,
    ForceJumps,
    MotionBase,
    MotionEvent,
    Outcome,
    Transition,
    force_at_ends_and_middles,
    read_only,
    times_within,
)
from dynamics.piecewise_polynomial import PiecewisePolynomials
from dynamics.regime import (
    ARRAY_FORMULAS,
    DISSIPATED,
    PRECESSION,
    SPIN,
    V1,
    V2,
    W1,
    W3,
    Branch,
    R,
    Regime,
    X,
)

if TYPE_CHECKING:
    from dynamics.motion_plan import MotionPlan

FORCE_HARMONICS = 8
"""Number of harmonics of the precession rate within the bandwidth of the force."""


@dataclass(frozen=True, kw_only=True, eq=False)
class RigidMotion(MotionBase):
    """Motion of a rigid disk on a rigid contact.

    It implements `Motion`. The solution is a piecewise polynomial in the dimensionless
    quantities of the paper; arguments and results of the methods are in SI units.

    Parameters
    ----------
    plan : MotionPlan
        The decisions of the motion.
    path : PiecewisePolynomials
        The state as a function of the dimensionless time.
    regimes : tuple of Regime
        The distinct regimes of the motion.
    regime_of_piece : ndarray, (n - 1,)
        Index into `regimes` for each piece.
    transitions : tuple of Transition
        The changes of regime, in order of time.
    contact_losses : tuple
        Always empty, because a rigid motion ends when contact is lost.
    rolling_outcome : Outcome
        How the motion ended.
    integrator : str
        'taylor' or 'dop853'.

    Examples
    --------
    >>> from dynamics import RigidMotion, simulate
    >>> from sonify import load_scene
    >>> motion = simulate(load_scene("published").replace("numerics.accuracy=draft"))
    >>> isinstance(motion, RigidMotion)
    True
    >>> motion.regime([0.0, 0.5]).tolist()
    ['roll', 'roll']
    """

    plan: "MotionPlan"
    path: PiecewisePolynomials
    regimes: tuple[Regime, ...]
    regime_of_piece: np.ndarray
    transitions: tuple[Transition, ...]
    contact_losses: tuple[()]
    rolling_outcome: Outcome
    integrator: str

    @property
    def disk(self) -> Disk:
        """The disk."""
        return self.plan.scene.disk

    @property
    def constants(self) -> DiskConstants:
        """Dimensionless constants of disk, friction and table."""
        return self.plan.constants

    @property
    def loads(self) -> Any:
        """Loads on the disk other than those of the contact, or None."""
        return self.plan.loads

    def __repr__(self) -> str:
        """Return a one-line summary: duration, outcome, number of transitions and integrator."""
        end = self.path.x[-1] * self.disk.time_unit
        changes = f"{len(self.transitions)} transitions"
        return f"Motion({end:.6g} s, {self.outcome.name}, {changes}, {self.integrator})"

    @cached_property
    def t(self) -> np.ndarray:
        """Breakpoints (n,) [s] of the solution, from 0 to the end of the motion."""
        return read_only(self.path.x * self.disk.time_unit)

    def at(self, t: ArrayLike) -> np.ndarray:
        """Return the state at times t; see `Motion.at`."""
        return self._columns(self.path(*self._time_and_piece(t)))

    def force(self, t: ArrayLike) -> np.ndarray:
        """Return the contact force at times t; see `Motion.force`.

        It is the solution of the balance laws (4.6) and (5.2), without numerical
        differentiation.
        """
        tau, piece = self._time_and_piece(t)
        return self._force(self.path(tau, piece), piece)

    def at_and_force(self, t: ArrayLike) -> tuple[np.ndarray, np.ndarray]:
        """Return `at(t)` and `force(t)` from one evaluation."""
        tau, piece = self._time_and_piece(t)
        y = self.path(tau, piece)
        return self._columns(y), self._force(y, piece)

    def bandwidth(self, state: np.ndarray) -> np.ndarray:
        """Return the highest frequency (k,) [Hz] of the contact force at states (k, 11).

        It is FORCE_HARMONICS times the precession rate (2.3).
        """
        rate = precession_rate(state[:, 7], np.sin(state[:, 1]))
        return FORCE_HARMONICS / (2 * np.pi) * np.abs(rate)

    def energy(self, t: ArrayLike) -> np.ndarray:
        """Return the kinetic plus potential energy (k,) [J] at times t (k,) [s].

        The formula is (6.1) with its two misprints corrected.
        """
        y = self.path(*self._time_and_piece(t))
        r = y[R]
        omega = r * y[W1 : W3 + 1]
        slip = r * y[V1 : V2 + 1]
        return (
            energy(r * r, omega, slip, self.constants, y[X : X + 2])
            * self._unit_of_energy
        )

    @property
    def film(self) -> Film | None:
        """The air film that acts on the disk, or None."""
        return find_film(self.loads)

    @property
    def rolling_fillet(self) -> float:
        """Radius [m] of the edge on which the disk rolls; 0 for a sharp edge."""
        return self.constants.fillet * self.disk.radius

    @property
    def events(self) -> tuple[MotionEvent, ...]:
        """The contact of the face with the table, if it ends the motion."""
        return face_events(self)

    def energy_lost(self, t: ArrayLike) -> dict[str, np.ndarray]:
        """Return the energy (k,) [J] lost to each of CAUSES up to times t (k,) [s].

        The powers of sliding friction and of the film are integrated by the two-point
        Gauss rule on each piece of the solution. The rest of the dissipated energy is
        attributed to the resisting moments.
        """
        times = np.asarray(t, dtype=float)
        return {
            cause: np.interp(times, self.t, lost)
            for cause, lost in self._energy_lost.items()
        }

    @cached_property
    def _energy_lost(self) -> dict[str, np.ndarray]:
        middle = (self.t[1:] + self.t[:-1]) / 2
        half_length = np.diff(self.t) / 2
        offset = half_length / np.sqrt(3)
        nodes = np.stack([middle - offset, middle + offset])
        sliding = self._pieces_that_slide
        powers: dict[str, np.ndarray] = {"slip": np.zeros(nodes.shape)}
        powers["slip"][:, sliding] = _slip_power(
            *self.at_and_force(nodes[:, sliding].ravel())
        ).reshape(2, -1)
        if self.film:
            state = self.at(nodes.ravel())
            powers["film"] = _film_power(self.disk, self.film, state).reshape(2, -1)
        lost = {
            cause: np.append(0.0, np.cumsum(power.sum(axis=0) * half_length))
            for cause, power in powers.items()
        }
        moments = self.state[:, 10] - sum(lost.values())
        nothing = dict.fromkeys(CAUSES, np.zeros(len(self.t)))
        return nothing | lost | {"moments": moments}

    @property
    def _pieces_that_slide(self) -> np.ndarray:
        """The mask (n - 1,) of the pieces in which the contact point slides."""
        sliding = np.array([regime.sliding for regime in self.regimes])
        return sliding[self.regime_of_piece]

    def dissipation(self, t: ArrayLike) -> dict[str, np.ndarray]:
        """Return the power (k,) [W] dissipated by each of CAUSES at times t (k,) [s]."""
        tau, piece = self._time_and_piece(t)
        y = self.path(tau, piece)
        state = self._columns(y)
        known = {"slip": _slip_power(state, self._force(y, piece))}
        if self.film:
            known["film"] = _film_power(self.disk, self.film, state)
        moments = self._power(y, piece)
        for power in known.values():
            moments = moments - power
        nothing = dict.fromkeys(CAUSES, np.zeros(len(tau)))
        return nothing | known | {"moments": moments}

    def _power(self, y: np.ndarray, piece: np.ndarray) -> np.ndarray:
        """Return the dissipated power (k,) [W] at states y (11, k) in the pieces (k,)."""
        power = np.empty(len(piece))
        for selected, states, contact, branch in self._contacts(y, piece):
            rates = ARRAY_FORMULAS.rates(states, contact, branch, self.constants)
            power[selected] = rates[DISSIPATED]
        return power * self._unit_of_energy / self.disk.time_unit

    def largest_energy_gain_error(self) -> float:
        """Return the largest decrease [J] of the dissipated energy; see `Motion`."""
        lost = self.path.c[..., DISSIPATED]
        return largest_decrease(lost, self.path.x) * self._unit_of_energy

    def friction_excess(self) -> float:
        """Return `Motion.friction_excess`, evaluated at the midpoints of the pieces."""
        force = force_at_ends_and_middles(self)[1::2]
        ratio = np.hypot(force[:, 0], force[:, 1]) / force[:, 2]
        sliding = self._pieces_that_slide
        excess = ratio[~sliding] - self.constants.mu_static
        deviation = np.abs(ratio[sliding] - self.constants.mu_dynamic)
        return float(max(excess.max(initial=0.0), deviation.max(initial=0.0)))

    def tensile_time(self) -> float:
        """Return `Motion.tensile_time`, from the start and the middle of each piece."""
        force = force_at_ends_and_middles(self)[:-1, 2]
        lowest = force.reshape(-1, 2).min(axis=1)
        return float(np.diff(self.t) @ (lowest < 0))

    def regime(self, t: ArrayLike) -> np.ndarray:
        """Return the names (k,) of the regimes at times t (k,) [s]."""
        names = np.array([str(regime) for regime in self.regimes])
        _, piece = self._time_and_piece(t)
        return names[self.regime_of_piece[piece]]

    @cached_property
    def jumps(self) -> ForceJumps:
        """The discontinuities of the contact force, with the one-sided limits of the force."""
        piece_after = np.flatnonzero(np.diff(self.regime_of_piece)) + 1
        piece_before = piece_after - 1
        tau = self.path.x[piece_after]
        before = self._force(self.path(tau, piece_before), piece_before)
        after = self._force(self.path(tau, piece_after), piece_after)
        return ForceJumps(
            read_only(tau * self.disk.time_unit), read_only(before), read_only(after)
        )

    @cached_property
    def t_end(self) -> float:
        """Time [s] at which a settled disk would be flat; the end of any other motion.

        The square root of the inclination, which decreases linearly on average, is
        extrapolated from its last decade to zero.
        """
        if self.rolling_outcome is not Outcome.SETTLED:
            return float(self.t[-1])
        r = self.path.c[-1, :, R]
        i = np.searchsorted(-r, -10 * r[-1])
        slope = (r[-1] - r[i]) / (self.path.x[-2] - self.path.x[i])
        return float((self.path.x[-2] - r[-1] / slope) * self.disk.time_unit)

    def _time_and_piece(self, t: ArrayLike) -> tuple[np.ndarray, np.ndarray]:
        """Return times t (k,) [s] in time units, and the indices (k,) of their pieces."""
        t = times_within(t, self.t[-1])
        tau = t / self.disk.time_unit
        piece = np.searchsorted(self.t[:-1], t, side="right") - 1
        # The rounded quotient may lie outside the piece.
        return np.clip(tau, self.path.x[piece], self.path.x[piece + 1]), piece

    @property
    def _unit_of_energy(self) -> float:
        """The energy [J] m (R/chi)^2."""
        return self.disk.mass * (self.disk.radius / self.disk.time_unit) ** 2

    def _columns(self, y: np.ndarray) -> np.ndarray:
        """Convert dimensionless states y (11, k) to COLUMNS (k, 11) in SI units."""
        r = y[R]
        radius = self.disk.radius
        chi = self.disk.time_unit
        omega = r * y[W1 : W3 + 1] / chi
        slip = r * y[V1 : V2 + 1] * radius / chi
        position = y[X : X + 2] * radius
        work = y[DISSIPATED] * self._unit_of_energy
        return np.stack(
            [y[PRECESSION], r * r, y[SPIN], *position, *omega, *slip, work], axis=1
        )

    def _force(self, y: np.ndarray, piece: np.ndarray) -> np.ndarray:
        """Return the contact force (k, 3) [N] at states y (11, k) in the pieces (k,)."""
        force = np.empty((len(piece), 3))
        for selected, _, contact, _ in self._contacts(y, piece):
            components = np.broadcast_arrays(contact.F1, contact.F2, contact.Phi)
            force[selected] = np.stack(components, axis=1)
        return force * (self.disk.mass * self.disk.radius / self.disk.time_unit**2)

    def _contacts(
        self, y: np.ndarray, piece: np.ndarray
    ) -> Iterator[tuple[np.ndarray, np.ndarray, ContactSolution, Branch]]:
        """Solve the balance laws at states y (11, k) in the pieces (k,).

        Yields the indices and states of each regime, its contact and its branch.
        """
        regime_index = self.regime_of_piece[piece]
        for index in np.unique(regime_index):
            selected = np.flatnonzero(regime_index == index)
            states = y[:, selected]
            regime = self.regimes[index]
            if regime.sliding:
                self._set_direction_at_rest(states, piece[selected])
            branch = Branch.of(regime, self.constants, self.loads)
            contact = ARRAY_FORMULAS.contact(
                states, branch, regime.senses, self.constants
            )
            yield selected, states, contact, branch

    def _set_direction_at_rest(self, y: np.ndarray, piece: np.ndarray) -> None:
        """Replace zero slip velocities by tiny ones in the slip direction, in place.

        It is the direction of the slip acceleration, or of the next derivative if that
        is zero within rounding.
        """
        tiny_speed = 1e-3 * STOP_SLIP_SPEED
        resting = np.hypot(y[V1], y[V2]) < tiny_speed
        coefficients = self.path.c[-1:-4:-1, piece[resting], V1 : V2 + 1].swapaxes(1, 2)
        start, slope, curvature = coefficients
        duration = np.diff(self.path.x)[piece[resting]]
        rounding = 1e-8 * duration * np.abs(curvature).max(axis=0)
        is_gentle = np.abs(slope).max(axis=0) < rounding
        sense = np.where(start.any(axis=0), -1.0, 1.0)
        direction = np.where(is_gentle, curvature, slope) * sense
        y[V1 : V2 + 1, resting] = tiny_speed * direction / np.abs(direction).max(axis=0)


def _slip_power(state: np.ndarray, force: np.ndarray) -> np.ndarray:
    """Return the power (k,) [W] that sliding friction dissipates at states (k, 11) with
    the forces (k, 3) [N]."""
    return -np.sum(force[:, :2] * state[:, 8:10], axis=1)


def _film_power(disk: Disk, film: Film, state: np.ndarray) -> np.ndarray:
    """Return the power (k,) [W] that the film dissipates at states (k, 11)."""
    return film_powers(disk, film, state).sum(axis=0)
