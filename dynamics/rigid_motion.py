"""The record of a solved motion of a rigid disk, which answers for any time and any force."""

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property, wraps

import numpy as np
from numpy.typing import ArrayLike

from .disk import Disk
from .equations import Law
from .kinematics import energy, precession_rate
from .monotone import largest_fall
from .motion import COLUMNS, Answers, Jumps, Outcome, Transition, halves, read_only
from .pieces import Pieces
from .regime import ARRAY, DISSIPATED, PRECESSION, SPIN, STOP_SPEED, V1, V2, W1, W3, Branch, R, Regime, X

HARMONICS = 8
"""Multiples of the precession rate that the contact force is taken to contain."""
GENTLE = 1e-8
"""Share of the first step of a slide in which it gains less speed by its first push than by the growth of that push:
then it has none, but the rounding of its coefficients."""
BLOCK = 8192
"""Times at which the force is computed together: few enough for the cache."""


def remembered(method):
    """Let a method of a motion know its answers for the last two rows of times that nobody can change: many ask for
    what is at `t` and at its `halves`."""

    @wraps(method)
    def answer(self, t):
        if not isinstance(t, np.ndarray) or t.flags.writeable or t.base is not None:
            return method(self, t)
        known = self.__dict__.setdefault(f"_{method.__name__}", [])
        found = next((found for row, found in known if row is t), None)
        if found is None:
            found = method(self, t)
            known[:] = [*known[-1:], (t, found)]
        return tuple(part.copy() for part in found) if isinstance(found, tuple) else found.copy()

    return answer


@dataclass(frozen=True, kw_only=True, eq=False)
class RigidMotion(Answers):
    """A `Motion` as piecewise polynomials of the state, the regime of each piece, the transitions and the outcome.

    Inside, everything is dimensionless as in the paper; what the methods take and return is in SI units.
    """

    disk: Disk
    law: Law
    loads: Callable | None
    path: Pieces
    regimes: tuple[Regime, ...]
    regime_of_piece: np.ndarray
    transitions: tuple[Transition, ...]
    contact_losses: tuple
    outcome: Outcome
    integrator: str

    def __repr__(self):
        """In one line."""
        end = self.path.x[-1] * self.disk.time_unit
        return f"Motion({end:.6g} s, {self.outcome.name}, {len(self.transitions)} transitions, {self.integrator})"

    @cached_property
    def t(self) -> np.ndarray:
        """Ends of the pieces of the solution, (n,) [s], from 0 to the end of the motion."""
        return read_only(self.path.x * self.disk.time_unit)

    def at(self, t: ArrayLike) -> np.ndarray:
        """Return the state at the times t (k,) [s] as (k, 11): COLUMNS, in SI units; the frame of omega precesses.

        Raises ValueError for times outside the motion.
        """
        return self._columns(self.path(*self._placed(t)))

    def force(self, t: ArrayLike) -> np.ndarray:
        """Return the contact force at times t (k,) [s] as (k, 3) [N]: friction along a_1, a_2, and the normal force.

        It comes from the balance laws that the integrator solved (4.6), (5.2), never from differences. At a jump it is
        the force after it. Raises ValueError for times outside the motion.
        """
        return self.at_and_force(t)[1]

    @remembered
    def at_and_force(self, t: ArrayLike) -> tuple[np.ndarray, np.ndarray]:
        """Return `at(t)` and `force(t)` from one evaluation; ValueError for times outside the motion."""
        tau, piece = self._placed(t)
        state, force = np.empty((len(tau), len(COLUMNS))), np.empty((len(tau), 3))
        for i in range(0, len(tau), BLOCK):
            some = slice(i, i + BLOCK)
            y = self.path(tau[some], piece[some])
            state[some], force[some] = self._columns(y), self._force(y, piece[some])
        return state, force

    def steady_load(self, t: ArrayLike) -> np.ndarray:
        """Return the normal force at times t (k,) [s] as (k,) [N]: nothing vibrates on a rigid contact."""
        return self.force(t)[:, 2]

    def bandwidth(self, state: np.ndarray) -> np.ndarray:
        """Return the highest frequency (k,) [Hz] that the contact force is taken to hold at states (k, 11); (2.3)."""
        return HARMONICS / (2 * np.pi) * np.abs(precession_rate(state[:, 7], np.sin(state[:, 1])))

    @remembered
    def energy(self, t: ArrayLike) -> np.ndarray:
        """Return kinetic and potential energy [J] at times t (k,) [s], zero at rest on the table; (6.1) corrected."""
        y = self.path(*self._placed(t))
        r = y[R]
        return energy(r * r, r * y[W1 : W3 + 1], r * y[V1 : V2 + 1], self.law) * self._unit_of_energy

    def largest_regain(self) -> float:
        """Return by how much [J] the dissipated energy ever falls, from any instant to any later one."""
        return largest_fall(self.path.c[..., DISSIPATED], self.path.x) * self._unit_of_energy

    def friction_excess(self) -> float:
        """Return by how much |F|/N exceeds mu_s while rolling, or misses mu_d while sliding, between the instants t."""
        t, force = halves(self)[1::2], self.force(halves(self))[1::2]
        ratio = np.hypot(force[:, 0], force[:, 1]) / force[:, 2]
        sliding = np.char.startswith(self.regime(t), "slide")
        excess, miss = ratio[~sliding] - self.law.mu_static, np.abs(ratio[sliding] - self.law.mu_dynamic)
        return float(max(excess.max(initial=0.0), miss.max(initial=0.0)))

    def regime(self, t: ArrayLike) -> np.ndarray:
        """Return the name of the regime at the times t (k,) [s], an array of strings."""
        names = np.array([str(regime) for regime in self.regimes])
        return names[self.regime_of_piece[self._placed(t)[1]]]

    @cached_property
    def jumps(self) -> Jumps:
        """Every discontinuity of the contact force, with the one-sided limits of the force."""
        ends = np.flatnonzero(np.diff(self.regime_of_piece)) + 1
        tau = self.path.x[ends]
        before, after = (self._force(self.path(tau, piece), piece) for piece in (ends - 1, ends))
        return Jumps(*(read_only(a) for a in (tau * self.disk.time_unit, before, after)))

    @cached_property
    def t_end(self) -> float:
        """The time [s] at which sqrt(inclination), falling linearly on the mean, is zero; the last if not settled."""
        if self.outcome is not Outcome.SETTLED:
            return float(self.t[-1])
        r = self.path.c[-1, :, R]
        i = np.searchsorted(-r, -10 * r[-1])
        slope = (r[-1] - r[i]) / (self.path.x[-2] - self.path.x[i])
        return float((self.path.x[-2] - r[-1] / slope) * self.disk.time_unit)

    def _placed(self, t):
        """The times t (k,) [s] in units of time, and the pieces (k,) in which they lie."""
        t = np.atleast_1d(np.asarray(t, dtype=float))
        if t.ndim > 1:
            raise ValueError(f"t must be a time or a row of times [s], not an array of shape {t.shape}")
        tau, end = t / self.disk.time_unit, self.path.x[-1]
        if tau.size and not (tau.min() >= 0 and tau.max() <= end * (1 + 1e-14)):
            raise ValueError(f"t must lie within the motion, 0 to {end * self.disk.time_unit:.9g} s")
        piece = np.searchsorted(self.t[:-1], t, side="right") - 1
        return np.clip(tau, self.path.x[piece], self.path.x[piece + 1]), piece  # the quotient may round to beside it

    @property
    def _unit_of_energy(self) -> float:
        return self.disk.mass * (self.disk.radius / self.disk.time_unit) ** 2

    def _columns(self, y):
        r, radius, chi = y[R], self.disk.radius, self.disk.time_unit
        omega, slip = r * y[W1 : W3 + 1] / chi, r * y[V1 : V2 + 1] * radius / chi
        place, work = y[X : X + 2] * radius, y[DISSIPATED] * self._unit_of_energy
        return np.stack([y[PRECESSION], r * r, y[SPIN], *place, *omega, *slip, work], axis=1)

    def _force(self, y, piece):
        """Solve the contact at states y (11, k) within the pieces (k,), and return its force (k, 3) [N]."""
        out = np.empty((len(piece), 3))
        kinds = self.regime_of_piece[piece]
        for kind in np.unique(kinds):
            here = np.flatnonzero(kinds == kind)
            contact = self._contact(y[:, here], piece[here], self.regimes[kind])
            out[here] = np.stack(np.broadcast_arrays(contact.F1, contact.F2, contact.Phi), axis=1)
        return out * (self.disk.mass * self.disk.radius / self.disk.time_unit**2)

    def _contact(self, y, piece, regime):
        if regime.sliding:  # at either end of a slide the direction is that of the slip which begins or ends there
            resting = np.hypot(y[V1], y[V2]) < 1e-3 * STOP_SPEED
            rest, slope, curve = self.path.c[-1:-4:-1, piece[resting], V1 : V2 + 1].swapaxes(1, 2)
            duration = np.diff(self.path.x)[piece[resting]]
            grazes = np.abs(slope).max(axis=0) < GENTLE * duration * np.abs(curve).max(axis=0)
            onward = np.where(grazes, curve, slope) * np.where(rest.any(axis=0), -1.0, 1.0)
            y[V1 : V2 + 1, resting] = 1e-3 * STOP_SPEED * onward / np.abs(onward).max(axis=0)
        branch = Branch.of(regime, self.law, self.loads)
        return ARRAY.contact(y, branch, regime.senses, self.law)
