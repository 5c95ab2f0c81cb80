"""Model of the full compliant motion, with creep, slip, roughness and loss of contact.

It is valid for inclinations above MIN_CONTACT_INCLINATION, and while the roughness
leaves a single contact (roughness.shift_of_contact below 1). The normal force follows
from the gap in every step. The tangential springs and the length of the ellipse are
those under the weight.
"""

from collections.abc import Iterator
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np

from dynamics.compliant.law.height_profile import SMOOTH_PROFILE, Profile
from dynamics.compliant.law.hertz_mindlin import MIN_CONTACT_INCLINATION
from dynamics.compliant.law.linearised import required_step_rate
from dynamics.compliant.law.sections import Imperfection
from dynamics.compliant.law.tabulated import LOG_SINE_GRID_STEP, TabulatedLaw
from dynamics.compliant.stepping.state_layout import (
    STATE,
    STATE_SIZE,
    CompiledModel,
    LawCubics,
    ModelConstants,
)
from dynamics.compliant.stepping.table_modes import (
    ContactModes,
    modes_at_rest,
    set_steady_mode_response,
    wavy_table,
)
from dynamics.compliant.stepping.tangential import film_forces_on_table
from dynamics.compliant.stepping.time_loop import (
    MotionRecords,
    MotionSteps,
    step_motion,
)
from dynamics.contact_losses import ContactLosses
from dynamics.disk import MAX_FINITE_FRICTION, Friction
from dynamics.film.wedge import Film, film_in_si_units
from dynamics.solver_settings import ACCURACY_LEVELS
from dynamics.stepping_core.body import body_constants
from dynamics.stepping_core.end_reasons import EndReason
from dynamics.stepping_core.rim_modes import NO_RIM_MODES, RimModes

STEPS_PER_CALL = 2**15
"""Number of steps in one call of the time loop, unless a row has more."""
END_REASONS = {
    EndReason.LIES_FLAT: "the inclination reached its final value, below which the contact is "
    "not a single ellipse",
    EndReason.STANDS_UPRIGHT: "the disk stood upright on its lateral surface; the contact moves to the "
    "other rim",
    EndReason.UNSOLVED: "the roughness rotated the disk too far in one step: there are several contacts, "
    "or the step rate is too low",
    EndReason.IS_AIRBORNE: "the disk was higher above the table than it was tilted; "
    "its landing on the film of air does not need the contact",
}
"""Reasons for the end of a motion."""


class MotionPiece(NamedTuple):
    """Piece of a motion, with the events that end in it.

    Attributes
    ----------
    t : (n,) array
        Times [s].
    state : (n, STATE_SIZE) array
        States.
    force : (n p, 3) array
        Mean forces [N] along a_1, a_2 and the normal, p for each row.
    losses : ContactLosses
        Losses of contact that ended.
    slips : (s, 2) array
        Start and end [s] of each slip that ended.
    end_reason : EndReason
        Reason for the end, or EndReason.CONTINUES.
    """

    t: np.ndarray
    state: np.ndarray
    force: np.ndarray
    losses: ContactLosses
    slips: np.ndarray
    end_reason: EndReason


@dataclass(frozen=True, kw_only=True, eq=False)
class CompliantModel:
    """A disk on a table with compliant contact.

    Attributes
    ----------
    tabulated_law : TabulatedLaw
        Tabulated law of the contact.
    friction : Friction
        Coefficients of friction and resisting arms.
    powers : tuple of (float, float)
        Power laws (c [W s^b], b) of the precession rate.
    viscous : (float, float)
        Moment divided by angular velocity [N m s], and force divided by velocity [N
        s/m].
    profiles : (Profile, Profile)
        Heights of table and edge.
    modes : modal.SurfaceModes, optional
        Modes of the table, for two-way coupling.
    disk_modes : RimModes
        Modes of the disk that are solved in time.
    imperfection : Imperfection, optional
        Waviness of the table.
    film : Film, optional
        Air film.
    friction_is_fitted : bool
        True if the friction was fitted to a rough disk and includes its losses by
        contact and creep.
    bowl_curvature : float
        Curvature of a concave table [1/m].
    bowl_place : (float, float)
        Position [m] of the origin relative to the middle of a concave table.
    rate : float
        Steps per second.
    """

    tabulated_law: TabulatedLaw
    friction: Friction
    powers: tuple[tuple[float, float], ...] = ()
    viscous: tuple[float, float] = (0.0, 0.0)
    profiles: tuple[Profile, Profile] = (SMOOTH_PROFILE, SMOOTH_PROFILE)
    modes: Any = None
    disk_modes: RimModes = NO_RIM_MODES
    imperfection: Imperfection | None = None
    film: Film | None = None
    friction_is_fitted: bool = False
    bowl_curvature: float = 0.0
    bowl_place: tuple[float, float] = (0.0, 0.0)
    rate: float = ACCURACY_LEVELS["standard"].contact_rate

    @cached_property
    def constants(self) -> ModelConstants:
        """The constants of the model for the time loop."""
        disk = self.tabulated_law.law.disk
        f = self.friction
        has_spin_friction = f.arm_pivoting == "contact"
        fillet = self.tabulated_law.law.rolling_fillet
        viscous_moment, viscous_force = self.viscous
        return ModelConstants(
            **body_constants(disk, fillet, self.bowl_curvature, self.bowl_place),
            weight=disk.weight,
            mu_static=min(f.mu_static, MAX_FINITE_FRICTION),
            mu_dynamic=min(f.mu_dynamic, MAX_FINITE_FRICTION),
            arm_nutation=f.arm_nutation,
            arm_rolling=f.arm_rolling,
            arm_pivoting=0.0 if has_spin_friction else float(f.arm_pivoting),
            viscous_moment=viscous_moment,
            viscous_force=viscous_force,
            has_spin_friction=float(has_spin_friction),
            friction_is_fitted=float(self.friction_is_fitted),
            film=film_in_si_units(self.film, disk),
        )

    @cached_property
    def cubics(self) -> LawCubics:
        """The tabulated law for the time loop."""
        powers = LOG_SINE_GRID_STEP ** np.array([3, 2, 1, 0])
        cubics = self.tabulated_law.spline.c.transpose(1, 2, 0) * powers
        return LawCubics(
            float(self.tabulated_law.grid[0]),
            1 / LOG_SINE_GRID_STEP,
            np.ascontiguousarray(cubics),
        )

    @cached_property
    def _required_rates(self) -> tuple[np.ndarray, np.ndarray]:
        """Sines (n,) of inclinations, and the step rates (n,) [1/s] that they require."""
        tabulated = self.tabulated_law
        node_step = 10  # linear interpolation between every tenth is accurate to 2e-4
        rates = required_step_rate(tabulated.law, tabulated.inclinations[::node_step])
        return np.exp(tabulated.grid[::node_step]), rates

    def with_half_time_step(self) -> "CompliantModel":
        """Return the model with half the time step."""
        return replace(self, rate=2 * self.rate)

    def with_double_stiffness(self) -> "CompliantModel":
        """Return the model with twice the contact stiffness.

        The time step is reduced if required.
        """
        law = self.tabulated_law.law
        body, table = (
            side._replace(young=2 * side.young) for side in (law.body, law.table)
        )
        law = replace(law, body=body, table=table)
        rate = max(
            self.rate,
            float(required_step_rate(law, np.array([MIN_CONTACT_INCLINATION]))[0]),
        )
        return replace(
            self, tabulated_law=replace(self.tabulated_law, law=law), rate=rate
        )

    def run(
        self,
        y: np.ndarray,
        steps_per_row: int,
        end_time: float,
        final_inclination: float = MIN_CONTACT_INCLINATION,
        forces_per_row: int = 1,
        modes: ContactModes | None = None,
    ) -> Iterator[MotionPiece]:
        """Simulate from the state y to `end_time` [s] or `final_inclination` [rad].

        Parameters
        ----------
        y : (STATE_SIZE,) array
            Initial state, which is advanced in place.
        steps_per_row : int
            Steps per row.
        end_time : float
            End time [s].
        final_inclination : float
            Final inclination [rad].
        forces_per_row : int
            Number of mean forces per row.
        modes : ContactModes, optional
            Modes for the state y; computed if not given.

        Yields
        ------
        MotionPiece
            Pieces of the motion; END_REASONS explains the `end_reason` of the last one.

        Raises
        ------
        ValueError
            If the step rate is too low for the stiffness of the contact; the message
            states the required rate.
        """
        compiled = CompiledModel(
            self.constants,
            np.reshape(np.array(self.powers, dtype=float), (-1, 2)),
            self.cubics,
            *self.profiles,
        )
        sine = np.sin(max(final_inclination, MIN_CONTACT_INCLINATION))
        modes = modes or self.supporting_modes(y)
        steps = 0
        rows_left = int(np.ceil(end_time * self.rate / steps_per_row - 1e-9))
        end_reason = EndReason.CONTINUES
        flying = [np.nan, np.nan, 0.0]
        slipping = [np.nan, np.nan]
        while rows_left > 0 and end_reason == EndReason.CONTINUES:
            self._check_step_rate(y)
            rows = np.empty(
                (min(max(STEPS_PER_CALL // steps_per_row, 1), rows_left), STATE_SIZE)
            )
            forces = np.empty((len(rows) * forces_per_row, 3))
            flights, slips = (
                np.full((len(rows) * steps_per_row // 2 + 2, k), np.nan) for k in (3, 2)
            )
            flights[0] = flying
            slips[0] = slipping
            end_reason, n, flight_count, slip_count = step_motion(
                y,
                MotionSteps(steps, 1 / self.rate, steps_per_row, sine),
                compiled,
                modes,
                MotionRecords(rows, forces, flights, slips),
            )
            t = (steps + steps_per_row * np.arange(1, n + 1)) / self.rate
            flying = flights[flight_count]
            slipping = slips[slip_count]
            steps += steps_per_row * n
            rows_left -= n
            # unfinished events end with the motion
            if rows_left == 0 or end_reason != EndReason.CONTINUES:
                end = steps / self.rate
                flying[1] = end
                slipping[1] = end
                flight_count += flying[0] < end
                slip_count += slipping[0] < end
            begin, end, top = flights[:flight_count].T
            losses = ContactLosses(np.column_stack([begin, end - begin, top]))
            yield MotionPiece(
                t,
                rows[:n],
                forces[: n * forces_per_row] * [-1.0, 1.0, 1.0],
                losses,
                slips[:slip_count],
                end_reason,
            )

    def supporting_modes(self, y: np.ndarray) -> ContactModes | None:
        """Return the modes that support a disk in the state y, and adjust its height.

        Without table modes, there are no disk modes.
        """
        if self.imperfection is not None:
            return wavy_table(self.imperfection, y, self.constants)
        if self.modes is None or not len(self.modes.frequency):
            return None
        supporting = modes_at_rest(self.modes, 1 / self.rate, self.disk_modes)
        forces = film_forces_on_table(y, self.constants)
        set_steady_mode_response(supporting, self.modes, self, y, forces)
        return supporting

    def _check_step_rate(self, y: np.ndarray) -> None:
        """Raise ValueError if the phase of a resonance changes too much in one step."""
        sine = np.hypot(*y[STATE.axis : STATE.axis + 2])
        fastest = np.interp(sine, *self._required_rates)
        if fastest > self.rate:
            raise ValueError(
                f"rate = {self.rate:g}: too low for the stiffness of the contact, must be at least "
                f"{fastest:.4g} 1/s"
            )
