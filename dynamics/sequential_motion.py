"""Motion whose end is solved with another model than its beginning."""

from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike

from dynamics.disk import Disk
from dynamics.film.wedge import Film
from dynamics.motion import (
    CAUSES,
    ForceJumps,
    Motion,
    MotionBase,
    MotionPart,
    Transition,
    read_only,
)

if TYPE_CHECKING:
    from dynamics.motion_plan import MotionPlan


@dataclass(frozen=True, eq=False)
class SequentialMotion(MotionBase):
    """A `Motion` in two parts, each with its own model.

    Parameters
    ----------
    plan : MotionPlan
        The decisions of the motion.
    first, then : Motion
        The parts; the time of the second one begins at the hand-over.
    """

    plan: "MotionPlan"
    first: Motion
    then: Motion

    @property
    def disk(self) -> Disk:
        """The disk."""
        return self.first.disk

    @property
    def parts(self) -> tuple[MotionPart, ...]:
        """The parts of the first part, and the second part."""
        return (*self.first.parts, MotionPart(self.switch_time, self.then))

    @property
    def film(self) -> Film | None:
        """The air film that acts on the disk as it rolls, or None."""
        return self.first.film

    @property
    def rolling_fillet(self) -> float:
        """Radius [m] of the edge on which the disk rolls; 0 for a sharp edge."""
        return self.then.rolling_fillet

    @property
    def lift_off_speed(self) -> float:
        """`Motion.lift_off_speed` of the last part."""
        return self.then.lift_off_speed

    @property
    def integrator(self) -> str:
        """Names of the integrators of both parts."""
        return f"{self.first.integrator}, then {self.then.integrator}"

    @cached_property
    def switch_time(self) -> float:
        """Time of the hand-over [s]."""
        return float(self.first.t[-1])

    @cached_property
    def t(self) -> np.ndarray:
        """Breakpoints (n,) [s] of the solution."""
        later = self.switch_time + self.then.t[1:]
        return read_only(np.append(self.first.t, later))

    @property
    def t_end(self) -> float:
        """Time [s] at which a settled disk would be flat, or end of a motion that does
        not settle."""
        return self.switch_time + self.then.t_end

    @cached_property
    def jumps(self) -> ForceJumps:
        """Jumps of the force in both parts."""
        first, then = self.first.jumps, self.then.jumps
        joined = zip(first, (then.t + self.switch_time, *then[1:]), strict=True)
        return ForceJumps(*(read_only(np.concatenate(pair)) for pair in joined))

    @cached_property
    def transitions(self) -> tuple[Transition, ...]:
        """Transitions of both parts."""
        later = (
            event._replace(t=event.t + self.switch_time)
            for event in self.then.transitions
        )
        return (*self.first.transitions, *later)

    @cached_property
    def energy_step(self) -> float:
        """Energy [J] of the first part minus that of the second one at the hand-over."""
        return float(self.first.energy(self.switch_time)[0] - self.then.energy(0.0)[0])

    @cached_property
    def _column_offset(self) -> np.ndarray:
        """Offset of the columns of the second part, in angles and dissipated energy."""
        end = self.first.at(self.switch_time)[0]
        begin = self.then.at(0.0)[0]
        offset = np.zeros(len(end))
        offset[[0, 2, -1]] = (end - begin)[[0, 2, -1]]
        return offset

    def _time_since_switch(self, t: np.ndarray) -> np.ndarray:
        """Return the times (k,) [s] since the hand-over for times t (k,) [s].

        Rounding does not move a time beyond the end of the second part.
        """
        since = t - self.switch_time
        within = np.minimum(since, self.then.t[-1])
        return np.where(t <= self.t[-1], within, since)

    def _evaluate_in_parts(
        self, name: str, t: ArrayLike, *arguments: np.ndarray
    ) -> np.ndarray:
        """Evaluate the method `name` of the part that contains each time t (k,) [s].

        Further `arguments` (k, ...) belong to the times."""
        t = np.atleast_1d(np.asarray(t, dtype=float))
        late = self._is_late(t)
        before = [argument[~late] for argument in arguments]
        after = [argument[late] for argument in arguments]
        early = getattr(self.first, name)(t[~late], *before)
        later = getattr(self.then, name)(self._time_since_switch(t[late]), *after)
        out = np.empty((len(t), *early.shape[1:]), dtype=np.result_type(early, later))
        out[~late] = early
        out[late] = later
        return out

    def _evaluate_both_parts(self, name: str, t: ArrayLike) -> tuple[Any, Any]:
        """Evaluate the method `name` of both parts, each at its time closest to t (k,) [s]."""
        t = np.atleast_1d(np.asarray(t, dtype=float))
        since = np.maximum(self._time_since_switch(t), 0.0)
        early = getattr(self.first, name)(np.minimum(t, self.switch_time))
        return early, getattr(self.then, name)(since)

    def _is_late(self, t: ArrayLike) -> np.ndarray:
        """Return a mask of the times t (k,) [s] in the second part."""
        return np.atleast_1d(t) >= self.switch_time

    def at(self, t: ArrayLike) -> np.ndarray:
        """Return the COLUMNS (k, 11) at times t (k,) [s]."""
        late = self._is_late(t)[:, None]
        return self._evaluate_in_parts("at", t) + late * self._column_offset

    def force(self, t: ArrayLike) -> np.ndarray:
        """Return friction along a_1, a_2 and normal force (k, 3) [N] at t (k,) [s]."""
        return self._evaluate_in_parts("force", t)

    def film_loads(self, t: ArrayLike, state: np.ndarray) -> np.ndarray:
        """Return the FILM_COLUMNS (k, 5) at t (k,) [s], for the states (k, 11)."""
        return self._evaluate_in_parts("film_loads", t, state)

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

        The energy difference at the hand-over is not attributed to a cause.
        """
        early, late = self._evaluate_both_parts("energy_lost", t)
        return {cause: early[cause] + late[cause] for cause in CAUSES}

    def dissipation(self, t: ArrayLike) -> dict[str, np.ndarray]:
        """Return the power (k,) [W] dissipated by each of CAUSES at times t (k,) [s]."""
        early, late = self._evaluate_both_parts("dissipation", t)
        is_late = self._is_late(t)
        return {cause: np.where(is_late, late[cause], early[cause]) for cause in CAUSES}

    def regime(self, t: ArrayLike) -> np.ndarray:
        """Return the names (k,) of the regimes at times t (k,) [s]."""
        return self._evaluate_in_parts("regime", t)

    def bandwidth(self, state: np.ndarray) -> np.ndarray:
        """Return the highest frequency (k,) [Hz] of the contact force at states (k, 11)."""
        # the dissipated energy never decreases
        begin = self.then.at(0.0)[0, -1] + self._column_offset[-1]
        late = state[:, -1] >= begin
        early = self.first.bandwidth(state)
        return np.where(late, self.then.bandwidth(state), early)

    def largest_energy_gain_error(self) -> float:
        """Return the largest decrease [J] of the dissipated energy; see `Motion`."""
        before = self.first.at(self.switch_time)[0, -1]
        after = self.then.at(0.0)[0, -1] + self._column_offset[-1]
        return max(
            self.first.largest_energy_gain_error(),
            self.then.largest_energy_gain_error(),
            float(before - after),
        )

    def friction_excess(self) -> float:
        """Return the larger `friction_excess` of both parts."""
        return max(self.first.friction_excess(), self.then.friction_excess())

    def tensile_time(self) -> float:
        """Return the sum of `tensile_time` of both parts [s]."""
        return self.first.tensile_time() + self.then.tensile_time()
