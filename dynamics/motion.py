"""The motion of a scene: `simulate`, and the record that answers for any time and any force."""

import math
from dataclasses import dataclass
from enum import Enum
from functools import cached_property
from importlib import import_module
from importlib.util import find_spec
from typing import NamedTuple

import numpy as np
from scipy.interpolate import PPoly

from .disk import Disk
from .equations import Law
from .hybrid import CASCADE, drive
from .regime import ARRAY, DISSIPATED, PRECESSION, STOP_SPEED, V1, V2, W1, W3, Branch, R, Regime, X
from .rolling import RollingDisk
from .switching import ImpossibleContactError

COLUMNS = (
    "precession",
    "inclination",
    "spin",
    "x",
    "y",
    "omega_1",
    "omega_2",
    "omega_3",
    "slip_1",
    "slip_2",
    "dissipated_energy",
)
"""Names of the columns of `Motion.state`."""
TOLERANCE = {"draft": 1e-12, "standard": 1e-16, "reference": 1e-16}
FINAL_INCLINATION = 1e-10
BLOCK = 8192
"""Times at which the force is computed together: few enough for the cache."""


class Outcome(Enum):
    """How a motion ended, with the sentence that says so."""

    SETTLED = "the inclination reached its final value: the disk lies on the table"
    TIME_LIMIT = "the time limit was reached before the disk came to rest"
    LIFTED_OFF = "the normal force fell to zero: the contact was lost"
    UPRIGHT = "the disk stood upright on a generator of its lateral surface: contact passes to the other rim"
    CASCADE = "the regimes changed again and again at one instant"

    @property
    def sentence(self) -> str:
        """The outcome in words."""
        return self.value


OUTCOMES = {
    "flat": Outcome.SETTLED,
    "upright": Outcome.UPRIGHT,
    "lift-off": Outcome.LIFTED_OFF,
    CASCADE: Outcome.CASCADE,
    None: Outcome.TIME_LIMIT,
}


class Transition(NamedTuple):
    """A change of regime at time t [s]: its name before and after ('roll', 'slide', with what sticks), and the guard."""

    t: float
    before: str
    after: str
    guard: str


class Jumps(NamedTuple):
    """The discontinuities of the contact force: times (j,) [s], force before and after (j, 3) [N], as `Motion.force`."""

    t: np.ndarray
    before: np.ndarray
    after: np.ndarray


@dataclass(frozen=True, kw_only=True)
class Motion:
    """A solved motion: piecewise polynomials of the state, the regime of each piece, the transitions and the outcome.

    Inside, everything is dimensionless as in the paper; what the methods take and return is in SI units.
    """

    disk: Disk
    law: Law
    loads: object
    path: PPoly
    regimes: tuple[Regime, ...]
    regime_of_piece: np.ndarray
    transitions: tuple[Transition, ...]
    contact_losses: tuple
    outcome: Outcome
    integrator: str

    @cached_property
    def t(self) -> np.ndarray:
        """Ends of the pieces of the solution, (n,) [s], from 0 to the end of the motion."""
        return _read_only(self.path.x * self.disk.time_unit)

    @cached_property
    def state(self) -> np.ndarray:
        """The state at `t`, (n, 11), with the columns COLUMNS."""
        return _read_only(self.at(self.t))

    def at(self, t) -> np.ndarray:
        """Return the state at the times t (k,) [s] as (k, 11): COLUMNS, in SI units; the frame of omega precesses.

        Raises ValueError for times outside the motion.
        """
        return self._columns(self.path(self._tau(t)))

    def force(self, t) -> np.ndarray:
        """Return the contact force at the times t (k,) [s] as (k, 3) [N]: friction along a_1, a_2, and the normal force.

        It comes from the balance laws that the integrator solved (4.6), (5.2), never from differences. At a jump it is
        the force after it. Raises ValueError for times outside the motion.
        """
        tau = self._tau(t)
        out = np.empty((len(tau), 3))
        for i in range(0, len(tau), BLOCK):
            some = tau[i : i + BLOCK]
            out[i : i + BLOCK] = self._force(self.path(some), self._piece(some))
        return out

    def normal_load(self, t) -> np.ndarray:
        """Return Phi of (4.6) at the times t (k,) [s]; at rest it is (K + 4)/4."""
        return self.force(t)[:, 2] * self.disk.time_unit**2 / (self.disk.mass * self.disk.radius)

    def energy(self, t) -> np.ndarray:
        """Return kinetic and potential energy [J] at the times t (k,) [s], zero at rest on the table; (6.1) corrected."""
        tau = self._tau(t)
        return energy(self.path(tau).T, self.law) * self._unit_of_energy

    def regime(self, t) -> np.ndarray:
        """Return the name of the regime at the times t (k,) [s], an array of strings."""
        names = np.array([str(regime) for regime in self.regimes])
        return names[self.regime_of_piece[self._piece(self._tau(t))]]

    @cached_property
    def jumps(self) -> Jumps:
        """Every discontinuity of the contact force, with the one-sided limits of the force."""
        ends = np.flatnonzero(np.diff(self.regime_of_piece)) + 1
        tau = self.path.x[ends]
        at_end = _polynomials(self.path.c[:, ends - 1], tau - self.path.x[ends - 1])
        before, after = self._force(at_end, ends - 1), self._force(self.path.c[-1, ends].copy(), ends)
        return Jumps(*(_read_only(a) for a in (tau * self.disk.time_unit, before, after)))

    @cached_property
    def t_end(self) -> float:
        """The time [s] at which sqrt(inclination), falling linearly on the mean, is zero; for a settled motion."""
        r = self.path.c[-1, :, R]
        i = np.searchsorted(-r, -10 * r[-1])
        slope = (r[-1] - r[i]) / (self.path.x[-2] - self.path.x[i])
        return float((self.path.x[-2] - r[-1] / slope) * self.disk.time_unit)

    def _tau(self, t):
        tau = np.atleast_1d(np.asarray(t, dtype=float)) / self.disk.time_unit
        end = self.path.x[-1]
        if tau.size and not (tau.min() >= 0 and tau.max() <= end * (1 + 1e-14)):
            raise ValueError(f"t must lie within the motion, 0 to {end * self.disk.time_unit:.9g} s")
        return np.minimum(tau, end)

    def _piece(self, tau):
        return np.clip(np.searchsorted(self.path.x, tau, side="right") - 1, 0, len(self.regime_of_piece) - 1)

    @property
    def _unit_of_energy(self) -> float:
        return self.disk.mass * (self.disk.radius / self.disk.time_unit) ** 2

    def _columns(self, y):
        radius, chi = self.disk.radius, self.disk.time_unit
        r = y[:, [R]]
        return np.hstack(
            [
                y[:, [PRECESSION]],
                r * r,
                y[:, [PRECESSION + 1]],
                y[:, X : X + 2] * radius,
                r * y[:, W1 : W3 + 1] / chi,
                r * y[:, V1 : V2 + 1] * radius / chi,
                y[:, [DISSIPATED]] * self._unit_of_energy,
            ]
        )

    def _force(self, y, piece):
        """Solve the contact at states y (k, 11) within the pieces (k,), and return its force (k, 3) [N]."""
        out = np.empty((len(y), 3))
        kinds = self.regime_of_piece[piece]
        for kind in np.unique(kinds):
            here = np.flatnonzero(kinds == kind)
            contact = self._contact(y[here].T, piece[here], self.regimes[kind])
            out[here] = np.stack(np.broadcast_arrays(contact.F1, contact.F2, contact.Phi), axis=1)
        return out * (self.disk.mass * self.disk.radius / self.disk.time_unit**2)

    def _contact(self, y, piece, regime):
        if regime.sliding:  # at either end of a slide the direction is that of the slip which begins or ends there
            resting = np.hypot(y[V1], y[V2]) < 1e-3 * STOP_SPEED
            first, slope = self.path.c[-1:-3:-1, piece[resting], V1 : V2 + 1].swapaxes(1, 2)
            y[V1 : V2 + 1, resting] = 1e-3 * STOP_SPEED * np.where(first.any(axis=0), -slope, slope)
        branch = Branch.of(regime, self.law, self.loads)
        return ARRAY.contact(y, branch, regime.senses, self.law)


def _polynomials(c, x):
    """Evaluate polynomials c (order + 1, k, m), highest power first, at x (k,)."""
    out = c[0].copy()
    for row in c[1:]:
        out *= x[:, None]
        out += row
    return out


def energy(y, law: Law):
    """Return the dimensionless energy (6.1), with its two errata corrected, of states y (11, ...)."""
    r = y[R]
    beta, w1, w2, w3 = r * r, r * y[W1], r * y[W1 + 1], r * y[W3]
    sin_a, cos_a = np.cos(beta), np.sin(beta)
    e, f = law.h * sin_a + cos_a, law.h * cos_a - sin_a
    v1, v2, v3 = r * y[V1] + w2 - law.h * w3, r * y[V2] - e * w1, f * w1
    turning = (law.K / 4 + law.h**2 / 3) * (w1 * w1 + w3 * w3) + law.K / 2 * w2 * w2
    height = cos_a - 2 * law.h * np.sin(beta / 2) ** 2  # e - h without cancellation
    return (v1 * v1 + v2 * v2 + v3 * v3 + turning) / 2 + (law.K + 4) / 4 * height


def simulate(scene, watch=lambda t, inclination: None) -> Motion:
    """Solve the rigid motion of `scene`, which offers disk, friction, release and numerics.

    `watch(t, inclination)` is called on the way. Raises ImpossibleContactError, with time and state, where no contact
    force satisfies the balance laws.
    """
    disk, numerics = scene.disk, scene.numerics
    name, integrate = chosen_integrator(numerics.integrator)
    r_end = math.sqrt(numerics.final_inclination or FINAL_INCLINATION)
    tolerance = numerics.tolerance or TOLERANCE[numerics.accuracy]
    system = RollingDisk(law_of(disk, scene.friction), None, r_end, integrate, tolerance)
    y, now = released(disk, scene.release), 0.0

    def watched(tau, y):
        nonlocal now
        now = tau * disk.time_unit
        watch(now, y[R] ** 2)

    try:
        path, guard = drive(system, y, numerics.time_limit / disk.time_unit, watched)
    except ImpossibleContactError as error:
        raise ImpossibleContactError(f"at t = {now:.9g} s: {error}") from None
    return _motion(disk, system, path, OUTCOMES[guard], name)


def chosen_integrator(name: str):
    """Return name and flow of the integrator asked for; 'auto' takes heyoka's Taylor series where it is installed.

    Raises ValueError where 'taylor' is asked for and heyoka is missing.
    """
    if name == "auto":
        name = "taylor" if find_spec("heyoka") else "dop853"
    if name == "taylor" and not find_spec("heyoka"):
        raise ValueError("numerics.integrator = 'taylor' needs heyoka, which is not installed: use 'dop853'")
    return name, import_module(f".{name}", __package__).advance


def _motion(disk, system, path, outcome, name) -> Motion:
    """Join the pieces of a path to one record; pieces of no duration are left out."""
    x = np.concatenate(path.times)
    lasting = np.diff(x) > 0
    order = max(block.shape[1] for block in path.coefficients)
    c = np.zeros((order, np.count_nonzero(lasting), len(path.coefficients[0][0, 0])))
    regimes = tuple(dict.fromkeys(regime for regime, _ in path.regimes))
    kinds = np.repeat([regimes.index(regime) for regime, _ in path.regimes], [n for _, n in path.regimes])
    start = 0
    for block, kept in zip(path.coefficients, np.split(lasting, np.cumsum([len(b) for b in path.coefficients])[:-1])):
        n = np.count_nonzero(kept)
        c[order - block.shape[1] :, start : start + n] = block[kept, ::-1].swapaxes(0, 1)
        start += n
    chi = disk.time_unit
    crossings = (Transition(a.t * chi, str(a.before), str(a.after), a.guard) for a in path.crossings)
    return Motion(
        disk=disk,
        law=system.law,
        loads=system.loads,
        path=PPoly(_read_only(c), _read_only(np.append(x[0], x[1:][lasting]))),
        regimes=regimes,
        regime_of_piece=_read_only(kinds[lasting]),
        transitions=tuple(crossings),
        contact_losses=(),
        outcome=outcome,
        integrator=name,
    )


def _read_only(array):
    array = np.asarray(array)
    array.flags.writeable = False
    return array


def law_of(disk: Disk, friction) -> Law:
    """Return the dimensionless constants of a disk and its friction, (4.4) and (7.3)."""
    arms = (friction.arm_nutation, friction.arm_rolling, friction.arm_pivoting)
    return Law(disk.aspect, disk.gyration, friction.mu_static, friction.mu_dynamic, *(a / disk.radius for a in arms))


def released(disk: Disk, release) -> list:
    """Return the state of (7.4): the contact at rest, the centre over the origin."""
    r = math.sqrt(math.radians(release.inclination_deg))
    return [r, *(w * disk.time_unit / r for w in release.omega), *[0.0] * 7]
