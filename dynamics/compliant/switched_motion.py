"""Motion that starts on a passive table and switches to two-way coupling."""

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike

from dynamics.compliant.compliant_motion import CompliantMotion, solve_compliant_motion
from dynamics.contact_losses import ContactLosses
from dynamics.face_contact import face_events
from dynamics.motion import Motion, MotionEvent, Outcome
from dynamics.sequential_motion import SequentialMotion

if TYPE_CHECKING:
    from dynamics.motion_plan import MotionPlan


def solve_switched(
    plan: "MotionPlan",
    solve_passive: Callable[..., Motion],
    watch: Callable[..., None],
) -> Motion:
    """Solve a motion with two-way coupling below the inclination of its plan.

    Above it, `solve_passive(plan, watch)` solves the motion, which is returned unchanged
    if it does not reach this inclination. A rigid contact becomes elastic at the switch. A
    rough contact keeps its heights; there the modes of the table are at rest under the
    force of the passive motion, without the vibration that the filter adds to it. If the
    release is not above the inclination, the whole motion is coupled.
    """
    numerics = plan.scene.numerics
    inclination = plan.two_way.inclination
    if inclination >= np.radians(plan.scene.release.inclination_deg):
        return solve_compliant_motion(plan.coupled_part(), watch)
    short = replace(numerics, final_inclination=inclination)
    first = solve_passive(plan.part(numerics=short), watch)
    if first.rolling_outcome not in (Outcome.SETTLED, Outcome.SANK):
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
    return SwitchedMotion(plan, first, then, then.rolling_outcome)


@dataclass(frozen=True, eq=False)
class SwitchedMotion(SequentialMotion):
    """A `Motion` on a passive table, followed by one with two-way coupling.

    The energy difference at the switch, where table and contact become compliant, is
    counted as dissipated.
    """

    first: Motion
    then: CompliantMotion
    rolling_outcome: Outcome

    def __repr__(self) -> str:
        """Return a one-line summary."""
        return f"Motion({self.t[-1]:.6g} s, {self.outcome.name}, switched at {self.switch_time:.6g} s)"

    @property
    def events(self) -> tuple[MotionEvent, ...]:
        """The contact of the face with the table, if it ends the motion."""
        return face_events(self)

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

    @cached_property
    def contact_losses(self) -> ContactLosses:
        """Losses of contact in both parts."""
        earlier = np.reshape(list(self.first.contact_losses), (-1, 3))
        shift = np.array([self.switch_time, 0, 0])
        later = self.then.contact_losses.array + shift
        return ContactLosses(np.vstack([earlier, later]))

    @cached_property
    def _column_offset(self) -> np.ndarray:
        """Offset of the columns of the coupled part, in angles and dissipated energy."""
        offset = super()._column_offset.copy()
        offset[-1] += self.energy_step
        return offset

    def table_energy(self, t: ArrayLike) -> np.ndarray:
        """Return the energy (k,) [J] of the table modes at t (k,) [s]; 0 before the switch."""
        since = np.maximum(self._time_since_switch(np.atleast_1d(t)), 0.0)
        return np.where(self._is_late(t), self.then.table_energy(since), 0.0)
