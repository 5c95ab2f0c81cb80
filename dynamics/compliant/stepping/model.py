"""Full compliant motion: a rigid disk on an elastic, rough contact with creep, slip and loss of
contact.

Valid from the upright disk down to MIN_CONTACT_INCLINATION, where the contact is no longer one ellipse,
and while the roughness under the ellipse makes one contact (roughness.shift_of_contact below 1).
The normal force follows the gap in every step. The tangential springs and the length of the ellipse
are those under the weight, at the inclination of the step.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np

from dynamics.compliant.law.height_profile import SMOOTH_PROFILE, Profile
from dynamics.compliant.law.hertz_mindlin import MIN_CONTACT_INCLINATION
from dynamics.compliant.law.linearised import inertias, required_step_rate
from dynamics.compliant.law.sections import Imperfection
from dynamics.compliant.law.tabulated import GRID_STEP, LawTable
from dynamics.compliant.stepping.contact_energy import LawCubics
from dynamics.compliant.stepping.rim_modes import NO_RIM_MODES, RimModes
from dynamics.compliant.stepping.state_layout import STATE, STATE_SIZE, ModelConstants
from dynamics.compliant.stepping.table_modes import modes_at_rest, settle_modes, wavy_table
from dynamics.compliant.stepping.time_loop import EndReason, step_motion
from dynamics.disk import MAX_FINITE_FRICTION, Friction
from dynamics.film.wedge import Film

DEFAULT_STEP_RATE = 400e3
"""Steps per second; sufficient down to 1e-6 rad."""
STEPS_PER_CALL = 2**15
"""Steps in one call of the time loop, or one row if a row has more steps."""
NODES_PER_RATE_CHECK = 10
"""Spacing of the nodes of the tabulated law at which the required step rate is computed.

Linear interpolation between them is accurate to 2e-4.
"""
END_REASONS = {
    EndReason.LIES_FLAT: "the inclination reached its final value; below it the contact is not one ellipse",
    EndReason.STANDS_UPRIGHT: "the disk stood upright on its lateral surface; the contact passes to the "
    "other rim",
    EndReason.UNSOLVED: "the roughness turned the disk too far in one step: several contacts, or too low a "
    "rate",
    EndReason.IS_AIRBORNE: "the air film carried the disk; without a contact it is not a wedge",
}
"""Reasons for the end of a motion."""


class ContactLoss(NamedTuple):
    """Loss of contact: begin and duration [s], largest height [m] of the edge above the table."""

    t: float
    duration: float
    height: float


class ContactLosses(Sequence):
    """Losses of contact as an array (n, 3): begin [s], duration [s], height [m]."""

    def __init__(self, array):
        self.array = array

    def __len__(self):
        return len(self.array)

    def __getitem__(self, i):
        return (
            ContactLosses(self.array[i])
            if isinstance(i, slice)
            else ContactLoss(*self.array[i].tolist())
        )

    def __repr__(self):
        return f"Losses({len(self)}, {self.array[:, 1].sum():.4g} s in all)"


class MotionPiece(NamedTuple):
    """Piece of a motion, with the events that end in it.

    Attributes
    ----------
    t : (n,) array
        Times [s].
    state : (n, STATE_SIZE) array
        States.
    force : (n p, 3) array
        Mean forces [N] along a_1 and a_2 and mean normal force, p for each row.
    losses : ContactLosses
        Losses of contact that ended.
    slips : (s, 2) array
        Begin and end [s] of each slip that ended.
    why : int
        Reason of the end, EndReason.CONTINUES if the motion continues.
    """

    t: np.ndarray
    state: np.ndarray
    force: np.ndarray
    losses: ContactLosses
    slips: np.ndarray
    why: int


@dataclass(frozen=True, kw_only=True, eq=False)
class CompliantModel:
    """A disk on a table with compliant contact.

    Attributes
    ----------
    table : LawTable
        Tabulated law of the contact.
    friction : Friction
        Coefficients of friction and resisting arms.
    powers : tuple of (float, float)
        Power laws (c [W s^b], b) of the precession rate.
    viscous : (float, float)
        Moment per angular velocity [N m s] and force per velocity [N s/m].
    profiles : (Profile, Profile)
        Heights of table and edge.
    impedance : float
        Impedance of the table [N s/m].
    modes : modal.SurfaceModes, optional
        Modes of the table with two-way coupling.
    bending : RimModes
        Modes of the disk that move together with those of the table.
    imperfection : Imperfection, optional
        Waviness of the table.
    film : Film, optional
        Air film.
    fitted : bool
        True if the friction was fitted to a rough disk and includes the losses of contact and
        creep.
    rate : float
        Steps per second.
    """

    table: LawTable
    friction: Friction
    powers: tuple[tuple[float, float], ...] = ()
    viscous: tuple[float, float] = (0.0, 0.0)
    profiles: tuple[Profile, Profile] = (SMOOTH_PROFILE, SMOOTH_PROFILE)
    impedance: float = np.inf
    modes: Any = None
    bending: RimModes = NO_RIM_MODES
    imperfection: Imperfection | None = None
    film: Film | None = None
    fitted: bool = False
    rate: float = DEFAULT_STEP_RATE

    @cached_property
    def constants(self) -> ModelConstants:
        """The constants of the model."""
        disk = self.table.law.disk
        f = self.friction
        body = disk.mass, *inertias(disk), disk.radius, disk.thickness / 2, disk.weight
        friction = (
            min(f.mu_static, MAX_FINITE_FRICTION),
            min(f.mu_dynamic, MAX_FINITE_FRICTION),
            f.arm_nutation,
            f.arm_rolling,
            f.arm_pivoting,
        )
        chi = disk.time_unit
        energy = disk.mass * disk.radius**2 / disk.time_unit**2
        units = energy * chi, energy * chi, chi**2, chi, energy, 1.0
        air = np.multiply(self.film or np.zeros(len(units)), units)  # type: ignore[arg-type]
        values = *body, *friction, self.impedance, *self.viscous, *air, self.fitted
        return ModelConstants(*map(float, values))

    @cached_property
    def cubics(self) -> LawCubics:
        """The tabulated law for the time loop."""
        powers = GRID_STEP ** np.array([3, 2, 1, 0])
        cubics = self.table.spline.c.transpose(1, 2, 0) * powers
        return LawCubics(float(self.table.grid[0]), 1 / GRID_STEP, np.ascontiguousarray(cubics))

    @cached_property
    def _required_rate_at_nodes(self) -> np.ndarray:
        """Required step rate (n,) [1/s] at every NODES_PER_RATE_CHECK-th node of the tabulated
        law."""
        return required_step_rate(self.table.law, self.table.inclinations[::NODES_PER_RATE_CHECK])

    def with_half_time_step(self) -> "CompliantModel":
        """Return the model with half the time step."""
        return replace(self, rate=2 * self.rate)

    def with_double_stiffness(self) -> "CompliantModel":
        """Return the model with twice the contact stiffness, and a smaller time step where
        required.
        """
        law = self.table.law
        body, table = (side._replace(young=2 * side.young) for side in (law.body, law.table))
        law = replace(law, body=body, table=table)
        rate = max(
            self.rate, float(required_step_rate(law, np.array([MIN_CONTACT_INCLINATION]))[0])
        )
        return replace(self, table=replace(self.table, law=law), rate=rate)

    def run(
        self,
        y,
        every: int,
        stop: float,
        last: float = MIN_CONTACT_INCLINATION,
        parts: int = 1,
        waves=None,
    ) -> Iterator[MotionPiece]:
        """Simulate from the state y until `stop` [s] or the inclination `last` [rad], one row every
        `every` steps.

        Parameters
        ----------
        y : (STATE_SIZE,) array
            Initial state; advanced in place.
        every : int
            Steps per row.
        stop : float
            End time [s].
        last : float
            Final inclination [rad].
        parts : int
            Number of mean forces per row.
        waves : ContactModes, optional
            Modes of the state y, if the caller has computed them.

        Yields
        ------
        MotionPiece
            The `why` of the last piece gives the reason of the end, see END_REASONS.

        Raises
        ------
        ValueError
            If the step rate is too low for the stiffness of the contact; the message names the
            required rate.
        """
        powers = np.reshape(np.array(self.powers, dtype=float), (-1, 2))
        sine = np.sin(max(last, MIN_CONTACT_INCLINATION))
        waves = waves or self.waves(y)
        count = 0
        left = int(np.ceil(stop * self.rate / every - 1e-9))
        why = EndReason.CONTINUES
        flying = [np.nan, np.nan, 0.0]
        slipping = [np.nan, np.nan]
        while left > 0 and why == EndReason.CONTINUES:
            self._check_step_rate(y)
            rows = np.empty((min(max(STEPS_PER_CALL // every, 1), left), STATE_SIZE))
            forces = np.empty((len(rows) * parts, 3))
            flights, slips = (np.full((len(rows) * every // 2 + 2, k), np.nan) for k in (3, 2))
            flights[0] = flying
            slips[0] = slipping
            report = rows, forces, (flights, slips)
            why, n, flown, slid = step_motion(
                y,
                count,
                self.constants,
                powers,
                self.cubics,
                *self.profiles,
                waves,
                1 / self.rate,
                every,
                sine,
                *report,
            )
            t = (count + every * np.arange(1, n + 1)) / self.rate
            flying = flights[flown]
            slipping = slips[slid]
            count = count + every * n
            left = left - n
            if left == 0 or why != EndReason.CONTINUES:  # events that continue end with the motion
                flying[1] = slipping[1] = end = count / self.rate
                flown = flown + (flying[0] < end)
                slid = slid + (slipping[0] < end)
            begin, end, top = flights[:flown].T
            losses = ContactLosses(np.column_stack([begin, end - begin, top]))
            yield MotionPiece(
                t,
                rows[:n],
                forces[: n * parts] * [-1.0, 1.0, 1.0],
                losses,
                slips[:slid],
                why,
            )

    def waves(self, y):
        """Return the modes that support a disk in the state y, and raise the disk onto them."""
        if self.imperfection is not None:
            return wavy_table(self.imperfection, y, self.constants)
        waves = modes_at_rest(self.modes, 1 / self.rate, self.bending)
        settle_modes(waves, self.modes, self, y)
        return waves

    def _check_step_rate(self, y):
        """Raise ValueError if the phase of a resonance changes too much in one step."""
        fastest = np.interp(
            np.hypot(*y[STATE.axis : STATE.axis + 2]),
            np.exp(self.table.grid[::NODES_PER_RATE_CHECK]),
            self._required_rate_at_nodes,
        )
        if fastest > self.rate:
            raise ValueError(
                f"rate = {self.rate:g}: too low for so stiff a contact, at least {fastest:.4g} "
                f"1/s needed"
            )
