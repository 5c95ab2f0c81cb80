"""Motion that starts on a passive table and switches to two-way coupling once the table's reaction
matters.
"""

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np

from dynamics.compliant.compliant_motion import CompliantMotion, solve_compliant_motion
from dynamics.compliant.stepping.model import ContactLosses
from dynamics.disk import Disk
from dynamics.film.wedge import Film
from dynamics.motion import (
    CAUSES,
    Jumps,
    Motion,
    MotionBase,
    MotionPart,
    Outcome,
    Transition,
    read_only,
)

if TYPE_CHECKING:
    from dynamics.sections import MotionScene


def solve_switched(
    scene: "MotionScene", inclination: float, alone: Callable, watch, modes
) -> Motion:
    """Solve a scene with `alone(scene)` down to an inclination [rad], then with two-way coupling to
    its table.

    A motion that does not reach this inclination is returned unchanged. A rigid contact becomes
    elastic at the switch.
    """
    short = replace(scene.numerics, final_inclination=inclination)
    first = alone(scene.part(numerics=short))
    if first.outcome is not Outcome.SETTLED:
        return first
    t = float(first.t[-1])
    left = replace(scene.numerics, time_limit=scene.numerics.time_limit - t)
    yields = replace(scene.contact, law="elastic")
    parts = scene.part(
        numerics=left,
        contact=yields,
        roughness=None,  # no effect on a rigid contact; a rough elastic contact does not switch
        surface=replace(scene.surface, action="motion"),
    )
    state, force = first.at_and_force(t)
    held = float(first.energy(t)[0])
    then = solve_compliant_motion(
        parts,
        lambda now, *rest: watch(t + now, *rest),
        modes,
        (state[0], force[0]),
        held,
    )
    return SwitchedMotion(first, then, then.outcome)


@dataclass(frozen=True, eq=False)
class SwitchedMotion(MotionBase):
    """A `Motion` in two parts: `first` on a passive table, `then` with two-way coupling.

    The energy difference at the switch, where table and contact begin to yield, counts as
    dissipated.
    """

    first: Motion
    then: CompliantMotion
    outcome: Outcome

    def __repr__(self):
        """Return a one-line summary."""
        return f"Motion({self.t[-1]:.6g} s, {self.outcome.name}, handed over at {self.handed_over:.6g} s)"

    @property
    def disk(self) -> Disk:
        """The disk."""
        return self.first.disk

    @property
    def parts(self) -> tuple[MotionPart, ...]:
        """Both parts."""
        return MotionPart(0.0, self.first), MotionPart(self.handed_over, self.then)

    @property
    def film(self) -> Film | None:
        """The air film that acts on the disk in both parts, or None."""
        return self.first.film

    @property
    def solves_contact(self) -> bool:
        """False: the first part may have a rigid contact."""
        return False

    @property
    def moves_table(self) -> bool:
        """False: the table moves in the second part only."""
        return False

    @property
    def integrator(self) -> str:
        """Integrators of both parts."""
        return f"{self.first.integrator}, then {self.then.integrator}"

    @cached_property
    def handed_over(self) -> float:
        """Time of the switch [s]."""
        return float(self.first.t[-1])

    @cached_property
    def t(self) -> np.ndarray:
        """Ends of the pieces (n,) [s]."""
        return read_only(np.concatenate([self.first.t, self.handed_over + self.then.t[1:]]))

    @property
    def t_end(self) -> float:
        """Extrapolated time [s] at which the inclination reaches zero."""
        return self.handed_over + self.then.t_end

    @cached_property
    def jumps(self) -> Jumps:
        """Jumps of the first part; an elastic contact has none."""
        return self.first.jumps

    @cached_property
    def transitions(self) -> tuple[Transition, ...]:
        """Transitions of both parts."""
        later = (event._replace(t=event.t + self.handed_over) for event in self.then.transitions)
        return (*self.first.transitions, *later)

    @cached_property
    def contact_losses(self) -> ContactLosses:
        """Losses of contact in both parts."""
        later = self.then.contact_losses.array + np.array([self.handed_over, 0, 0])
        return ContactLosses(
            np.vstack(
                [
                    np.reshape(
                        list(self.first.contact_losses),
                        (-1, 3),
                    ),
                    later,
                ]
            )
        )

    @cached_property
    def _offset(self) -> np.ndarray:
        """Offset of the columns of the second part: angles turned and energy dissipated before."""
        end = self.first.at(self.handed_over)[0]
        begin = self.then.at(0.0)[0]
        offset = np.zeros(len(end))
        offset[[0, 2]] = (end - begin)[[0, 2]]
        offset[-1] = end[-1] + self.first.energy(self.handed_over)[0] - self.then.energy(0.0)[0]
        return offset

    def _since(self, t) -> np.ndarray:
        """Return the times t (k,) [s] since the switch, limited to the end of the second part."""
        return np.where(
            t <= self.t[-1],
            np.minimum(t - self.handed_over, self.then.t[-1]),
            t - self.handed_over,
        )

    def _both(self, name, t):
        """Evaluate the method `name` of the part to which each time belongs."""
        t = np.atleast_1d(np.asarray(t, dtype=float))
        late = t >= self.handed_over
        early = getattr(self.first, name)(t[~late])
        later = getattr(self.then, name)(self._since(t[late]))
        out = np.empty((len(t), *early.shape[1:]), dtype=np.result_type(early, later))
        out[~late] = early
        out[late] = later
        return out

    def at(self, t) -> np.ndarray:
        """Return the state (k, 11) at times t (k,) [s]: COLUMNS in SI units, omega in the
        precessing frame.
        """
        late = np.atleast_1d(t) >= self.handed_over
        return self._both("at", t) + late[:, None] * self._offset

    def force(self, t) -> np.ndarray:
        """Return the contact force (k, 3) [N] at times t (k,) [s]: friction along a_1 and a_2,
        normal force.
        """
        return self._both("force", t)

    def steady_load(self, t) -> np.ndarray:
        """Return the normal force (k,) [N] at t (k,) without the vibration of the contact."""
        return self._both("steady_load", t)

    def steady_nutation(self, t) -> np.ndarray:
        """Return omega_1 (k,) [rad/s] at t (k,) without the vibration of the contact."""
        return self._both("steady_nutation", t)

    def energy(self, t) -> np.ndarray:
        """Return the total energy (k,) [J] at times t (k,) [s], with that of a table with two-way
        coupling.
        """
        return self._both("energy", t)

    def energy_lost(self, t) -> dict[str, np.ndarray]:
        """Return the energy (k,) [J] lost until the times t (k,) [s], by cause.

        The energy difference at the switch has no cause.
        """
        t = np.atleast_1d(np.asarray(t, dtype=float))
        early = self.first.energy_lost(np.minimum(t, self.handed_over))
        late = self.then.energy_lost(np.maximum(self._since(t), 0.0))
        return {cause: early[cause] + late[cause] for cause in CAUSES}

    def dissipation(self, t) -> dict[str, np.ndarray]:
        """Return the dissipated power (k,) [W] at times t (k,) [s], by cause."""
        t = np.atleast_1d(np.asarray(t, dtype=float))
        early = self.first.dissipation(np.minimum(t, self.handed_over))
        late = self.then.dissipation(np.maximum(self._since(t), 0.0))
        return {
            cause: np.where(
                t < self.handed_over,
                early[cause],
                late[cause],
            )
            for cause in CAUSES
        }

    def table_energy(self, t) -> np.ndarray:
        """Return the energy (k,) [J] of the table modes at t (k,) [s]; 0 before the switch."""
        late = np.atleast_1d(t) >= self.handed_over
        return np.where(
            late,
            self.then.table_energy(np.maximum(self._since(np.atleast_1d(t)), 0.0)),
            0.0,
        )

    def regime(self, t) -> np.ndarray:
        """Return the name of the regime at times t (k,) [s]."""
        return self._both("regime", t)

    def bandwidth(self, state) -> np.ndarray:
        """Return the highest frequency (k,) [Hz] of the contact force at states (k, 11)."""
        late = state[:, -1] >= self._offset[-1]  # the dissipated energy never decreases
        return np.where(late, self.then.bandwidth(state), self.first.bandwidth(state))

    def largest_regain(self) -> float:
        """Return the largest decrease [J] of the dissipated energy between two instants."""
        where_they_meet = float(self.first.at(self.handed_over)[0, -1] - self._offset[-1])
        return max(self.first.largest_regain(), self.then.largest_regain(), where_they_meet)

    def friction_excess(self) -> float:
        """Return the largest excess of the friction over its law in either part, divided by the
        weight.
        """
        return max(self.first.friction_excess(), self.then.friction_excess())
