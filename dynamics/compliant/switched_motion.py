"""Motion that starts on a passive table and switches to two-way coupling."""

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike

from dynamics.compliant.compliant_motion import CompliantMotion, solve_compliant_motion
from dynamics.compliant.stepping.model import ContactLosses
from dynamics.disk import Disk
from dynamics.face_contact import face_events
from dynamics.film.wedge import Film
from dynamics.motion import (
    CAUSES,
    ForceJumps,
    Motion,
    MotionBase,
    MotionEvent,
    MotionPart,
    Outcome,
    Transition,
    read_only,
)

if TYPE_CHECKING:
    from dynamics.motion_plan import MotionPlan


def solve_switched(
    plan: "MotionPlan",
    solve_passive: Callable[..., Motion],
    watch: Callable[..., None],
) -> Motion:
    """Solve a motion with two-way coupling below the inclination of its plan.

    Above it, `solve_passive(plan, watch)` solves the motion, which is returned unchanged
    if it does not reach this inclination. A rigid contact becomes elastic at the switch.
    If the release is not above the inclination, the whole motion is coupled.
    """
    numerics = plan.scene.numerics
    inclination = plan.two_way.inclination
    if inclination >= np.radians(plan.scene.release.inclination_deg):
        return solve_compliant_motion(plan.coupled_part(), watch)
    short = replace(numerics, final_inclination=inclination)
    first = solve_passive(plan.part(numerics=short), watch)
    if first.outcome not in (Outcome.SETTLED, Outcome.SANK):
        return first
    t = float(first.t[-1])
    left = replace(numerics, time_limit=numerics.time_limit - t)
    state, force = first.at_and_force(t)
    held = float(first.energy(t)[0])
    then = solve_compliant_motion(
        plan.coupled_part(numerics=left),
        lambda now, *rest: watch(t + now, *rest),
        (state[0], force[0]),
        held,
    )
    return SwitchedMotion(plan, first, then, then.outcome)


@dataclass(frozen=True, eq=False)
class SwitchedMotion(MotionBase):
    """A `Motion` on a passive table, followed by one with two-way coupling.

    The energy difference at the switch, where table and contact become compliant, is
    counted as dissipated.
    """

    plan: "MotionPlan"
    passive_part: Motion
    coupled_part: CompliantMotion
    outcome: Outcome

    def __repr__(self) -> str:
        """Return a one-line summary."""
        return f"Motion({self.t[-1]:.6g} s, {self.outcome.name}, switched at {self.switch_time:.6g} s)"

    @property
    def disk(self) -> Disk:
        """The disk."""
        return self.passive_part.disk

    @property
    def parts(self) -> tuple[MotionPart, ...]:
        """The passive part and the coupled part."""
        coupled = MotionPart(self.switch_time, self.coupled_part)
        return MotionPart(0.0, self.passive_part), coupled

    @property
    def film(self) -> Film | None:
        """The air film that acts on the disk in both parts, or None."""
        return self.passive_part.film

    @property
    def rolling_fillet(self) -> float:
        """Radius [m] of the edge on which the disk rolls; 0 for a sharp edge."""
        return self.coupled_part.rolling_fillet

    @property
    def events(self) -> tuple[MotionEvent, ...]:
        """The contact of the face with the table, if it ends the motion."""
        return face_events(self)

    @property
    def solves_contact(self) -> bool:
        """False, because the passive part may have a rigid contact."""
        return False

    @property
    def moves_table(self) -> bool:
        """False, because the table moves only in the coupled part."""
        return False

    @cached_property
    def vibration_crossover(self) -> float | None:
        """Half the contact resonance [Hz] under the weight at the release.

        It is None for a motion that begins on a rigid contact.
        """
        tabulated = self.plan.tabulated_law
        if tabulated is None:
            return None
        first = self.state[:1, 1]
        resonance = tabulated.contact_resonance(first, self.disk.weight, 0.0)
        return float(resonance.frequency[0]) / 2

    @property
    def integrator(self) -> str:
        """Names of the integrators of both parts."""
        return f"{self.passive_part.integrator}, then {self.coupled_part.integrator}"

    @cached_property
    def switch_time(self) -> float:
        """Time of the switch [s]."""
        return float(self.passive_part.t[-1])

    @cached_property
    def t(self) -> np.ndarray:
        """Breakpoints (n,) [s] of the solution."""
        later = self.switch_time + self.coupled_part.t[1:]
        return read_only(np.append(self.passive_part.t, later))

    @property
    def t_end(self) -> float:
        """Time [s] at which a settled disk would be flat, or end of a motion that does
        not settle."""
        return self.switch_time + self.coupled_part.t_end

    @cached_property
    def jumps(self) -> ForceJumps:
        """Jumps of the force in the passive part; the coupled part has none."""
        return self.passive_part.jumps

    @cached_property
    def transitions(self) -> tuple[Transition, ...]:
        """Transitions of both parts."""
        later = (
            event._replace(t=event.t + self.switch_time)
            for event in self.coupled_part.transitions
        )
        return (*self.passive_part.transitions, *later)

    @cached_property
    def contact_losses(self) -> ContactLosses:
        """Losses of contact in both parts."""
        earlier = np.reshape(list(self.passive_part.contact_losses), (-1, 3))
        shift = np.array([self.switch_time, 0, 0])
        later = self.coupled_part.contact_losses.array + shift
        return ContactLosses(np.vstack([earlier, later]))

    @cached_property
    def _column_offset(self) -> np.ndarray:
        """Offset of the columns of the coupled part, in angles and dissipated energy."""
        end = self.passive_part.at(self.switch_time)[0]
        begin = self.coupled_part.at(0.0)[0]
        offset = np.zeros(len(end))
        offset[[0, 2]] = (end - begin)[[0, 2]]
        energy = self.passive_part.energy(self.switch_time)[0]
        offset[-1] = end[-1] + energy - self.coupled_part.energy(0.0)[0]
        return offset

    def _time_since_switch(self, t: np.ndarray) -> np.ndarray:
        """Return the times (k,) [s] since the switch for times t (k,) [s].

        Rounding does not move a time beyond the end of the coupled part.
        """
        since = t - self.switch_time
        within = np.minimum(since, self.coupled_part.t[-1])
        return np.where(t <= self.t[-1], within, since)

    def _evaluate_in_parts(self, name: str, t: ArrayLike) -> np.ndarray:
        """Evaluate the method `name` of the part that contains each time t (k,) [s]."""
        t = np.atleast_1d(np.asarray(t, dtype=float))
        late = self._is_late(t)
        early = getattr(self.passive_part, name)(t[~late])
        later = getattr(self.coupled_part, name)(self._time_since_switch(t[late]))
        out = np.empty((len(t), *early.shape[1:]), dtype=np.result_type(early, later))
        out[~late] = early
        out[late] = later
        return out

    def _evaluate_both_parts(self, name: str, t: ArrayLike) -> tuple[Any, Any]:
        """Evaluate the method `name` of both parts, each at its time closest to t (k,) [s]."""
        t = np.atleast_1d(np.asarray(t, dtype=float))
        since = np.maximum(self._time_since_switch(t), 0.0)
        early = getattr(self.passive_part, name)(np.minimum(t, self.switch_time))
        return early, getattr(self.coupled_part, name)(since)

    def _is_late(self, t: ArrayLike) -> np.ndarray:
        """Return a mask of the times t (k,) [s] in the coupled part."""
        return np.atleast_1d(t) >= self.switch_time

    def at(self, t: ArrayLike) -> np.ndarray:
        """Return the COLUMNS (k, 11) at times t (k,) [s]."""
        late = self._is_late(t)[:, None]
        return self._evaluate_in_parts("at", t) + late * self._column_offset

    def force(self, t: ArrayLike) -> np.ndarray:
        """Return friction along a_1, a_2 and normal force (k, 3) [N] at t (k,) [s]."""
        return self._evaluate_in_parts("force", t)

    def steady_load(self, t: ArrayLike) -> np.ndarray:
        """Return the normal force (k,) [N] at t (k,) [s] without contact vibration."""
        return self._evaluate_in_parts("steady_load", t)

    def steady_nutation(self, t: ArrayLike) -> np.ndarray:
        """Return omega_1 (k,) [rad/s] at t (k,) [s] without contact vibration."""
        return self._evaluate_in_parts("steady_nutation", t)

    def energy(self, t: ArrayLike) -> np.ndarray:
        """Return the total energy (k,) [J] at t (k,) [s], with that of a coupled table."""
        return self._evaluate_in_parts("energy", t)

    def energy_lost(self, t: ArrayLike) -> dict[str, np.ndarray]:
        """Return the energy (k,) [J] lost to each of CAUSES up to times t (k,) [s].

        The energy difference at the switch is not attributed to a cause.
        """
        early, late = self._evaluate_both_parts("energy_lost", t)
        return {cause: early[cause] + late[cause] for cause in CAUSES}

    def dissipation(self, t: ArrayLike) -> dict[str, np.ndarray]:
        """Return the power (k,) [W] dissipated by each of CAUSES at times t (k,) [s]."""
        early, late = self._evaluate_both_parts("dissipation", t)
        is_late = self._is_late(t)
        return {cause: np.where(is_late, late[cause], early[cause]) for cause in CAUSES}

    def table_energy(self, t: ArrayLike) -> np.ndarray:
        """Return the energy (k,) [J] of the table modes at t (k,) [s]; 0 before the switch."""
        since = np.maximum(self._time_since_switch(np.atleast_1d(t)), 0.0)
        return np.where(self._is_late(t), self.coupled_part.table_energy(since), 0.0)

    def regime(self, t: ArrayLike) -> np.ndarray:
        """Return the names (k,) of the regimes at times t (k,) [s]."""
        return self._evaluate_in_parts("regime", t)

    def bandwidth(self, state: np.ndarray) -> np.ndarray:
        """Return the highest frequency (k,) [Hz] of the contact force at states (k, 11)."""
        # the dissipated energy never decreases
        late = state[:, -1] >= self._column_offset[-1]
        early = self.passive_part.bandwidth(state)
        return np.where(late, self.coupled_part.bandwidth(state), early)

    def largest_energy_gain_error(self) -> float:
        """Return the largest decrease [J] of the dissipated energy; see `Motion`."""
        before = self.passive_part.at(self.switch_time)[0, -1]
        return max(
            self.passive_part.largest_energy_gain_error(),
            self.coupled_part.largest_energy_gain_error(),
            float(before - self._column_offset[-1]),
        )

    def friction_excess(self) -> float:
        """Return the larger `friction_excess` of both parts."""
        return max(
            self.passive_part.friction_excess(), self.coupled_part.friction_excess()
        )

    def tensile_time(self) -> float:
        """Return the sum of `tensile_time` of both parts [s]."""
        return self.passive_part.tensile_time() + self.coupled_part.tensile_time()
