"""Motions that lose their rolling contact: what follows, to rest or to rolling again."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike

from dynamics.contact_losses import ContactLosses
from dynamics.film.wedge import Film
from dynamics.landing import MAX_BOUNCE_ENERGY_ERROR
from dynamics.landing.landing_motion import LandingMotion
from dynamics.motion import FindingGroup, Motion, MotionEvent, Outcome
from dynamics.sequential_motion import SequentialMotion

if TYPE_CHECKING:
    from dynamics.stepping_core.rim_modes import RimModes


@dataclass(frozen=True, eq=False)
class ContinuedMotion(SequentialMotion):
    """A `Motion` that another model continues without loss of energy.

    The hand-over keeps position, velocity and dissipated energy. The energy stored in
    the contact and in the place on a concave table remains part of the energy.
    """

    @property
    def outcome(self) -> Outcome:
        """Outcome of the continuation."""
        return self.then.outcome

    @property
    def rolling_outcome(self) -> Outcome:
        """How the last rolling motion ended."""
        return self.first.rolling_outcome

    @property
    def rolling_fillet(self) -> float:
        """Radius [m] of the edge on which the disk rolls; 0 for a sharp edge."""
        return self.first.rolling_fillet

    @property
    def finding_groups(self) -> tuple[FindingGroup, ...]:
        """Groups of findings that apply to the rolling motion."""
        return self.first.finding_groups

    @property
    def rim_modes(self) -> "RimModes | None":
        """Modes of the disk that are part of the rolling motion, or None."""
        return self.first.rim_modes

    @property
    def vibration_crossover(self) -> float | None:
        """Frequency [Hz] above which the force of the rolling contact is vibration."""
        return self.first.vibration_crossover

    @property
    def max_energy_error(self) -> float | None:
        """Largest relative error of the energy balance of the rolling motion."""
        return self.first.max_energy_error

    def rim_vibration(self, t: ArrayLike) -> np.ndarray:
        """Return the vibration (k, 3, m) of the `rim_modes` at times t (k,) [s].

        They are at rest in a landing, whose disk is rigid.
        """
        t = np.atleast_1d(np.asarray(t, dtype=float))
        modes = self.rim_modes
        out = np.zeros((len(t), 3, 0 if modes is None else len(modes.order)))
        late = self._is_late(t)
        if self.first.rim_modes is not None:
            out[~late] = self.first.rim_vibration(t[~late])
        if self.then.rim_modes is not None:
            out[late] = self.then.rim_vibration(self._time_since_switch(t[late]))
        return out

    @property
    def solves_contact(self) -> bool:
        """True if the rolling motion includes the vibration of its contact."""
        return self.first.solves_contact

    @property
    def moves_table(self) -> bool:
        """True if the table and the disk are coupled as the disk rolls."""
        return self.first.moves_table

    @property
    def events(self) -> tuple[MotionEvent, ...]:
        """What happened on the way, in order of time."""
        return (*self.first.events, *self._later_events)

    @property
    def _later_events(self) -> tuple[MotionEvent, ...]:
        """Events of the continuation at their times in the whole motion."""
        begin = self.switch_time
        return tuple(event._replace(t=begin + event.t) for event in self.then.events)

    def energy(self, t: ArrayLike) -> np.ndarray:
        """Return the total energy (k,) [J] at t (k,) [s]; it is continuous."""
        return super().energy(t) + self._is_late(t) * self.energy_step


@dataclass(frozen=True, eq=False)
class LandedMotion(ContinuedMotion):
    """A `Motion` of a disk that loses its rolling contact, and then lands or tumbles."""

    then: LandingMotion

    def __repr__(self) -> str:
        """Return a one-line summary."""
        cause = self.first.rolling_outcome.name
        return f"Motion({self.t[-1]:.6g} s, {self.outcome.name}, {cause} at {self.switch_time:.6g} s)"

    @property
    def rolling(self) -> Motion:
        """The motion until the loss of the rolling contact."""
        return self.first

    @property
    def landing(self) -> LandingMotion:
        """The motion from there to rest."""
        return self.then

    @property
    def contact_losses(self) -> Sequence[Any]:
        """Losses of contact of the rolling motion."""
        return self.first.contact_losses

    @property
    def events(self) -> tuple[MotionEvent, ...]:
        """What happened on the way; a fall onto the face is the cause of the landing."""
        earlier, later = self.first.events, self._later_events
        if earlier and earlier[-1].t == self.switch_time:
            later = later[1:]
        return (*earlier, *later)


@dataclass(frozen=True, eq=False)
class ResumedMotion(ContinuedMotion):
    """A `Motion` of a disk that loses its contact, or is released without it, and then rolls.

    Where it rolls again, the creep of the contact and its vibration end. Their energy
    remains part of the energy, so that it is continuous.
    """

    first: LandedMotion | LandingMotion

    @property
    def film(self) -> Film | None:
        """The air film that acts on the disk as it rolls, or None."""
        return self.then.film

    @property
    def rim_modes(self) -> "RimModes | None":
        """Modes of the disk that are part of the last rolling motion, or None."""
        return self.then.rim_modes

    @property
    def vibration_crossover(self) -> float | None:
        """Frequency [Hz] above which the force of the rolling contact is vibration."""
        return self.then.vibration_crossover

    @property
    def rolling_outcome(self) -> Outcome:
        """How the last rolling motion ended."""
        return self.then.rolling_outcome

    @property
    def max_energy_error(self) -> float:
        """Largest relative error of the energy balance, that of a disk which bounces."""
        return MAX_BOUNCE_ENERGY_ERROR

    def __repr__(self) -> str:
        """Return a one-line summary."""
        return f"Motion({self.t[-1]:.6g} s, {self.outcome.name}, rolls again at {self.switch_time:.6g} s)"

    @cached_property
    def _column_offset(self) -> np.ndarray:
        """Offset of the dissipated energy, and of the angles if the second part begins at 0."""
        landing = (
            self.first if isinstance(self.first, LandingMotion) else self.first.landing
        )
        begin = self.then.at(0.0)[0]
        offset = np.zeros(len(begin))
        offset[[0, 2]] = (landing.rolling_columns() - begin)[[0, 2]]
        offset[-1] = super()._column_offset[-1]
        return offset

    @cached_property
    def contact_losses(self) -> ContactLosses:
        """Losses of contact, with those of the landings between the rolling motions."""
        parts: list[tuple[float, Motion]] = [(self.switch_time, self.then)]
        first = self.first
        if isinstance(first, LandedMotion):
            parts = [(0.0, first.rolling), (first.switch_time, first.landing), *parts]
        else:
            parts = [(0.0, first), *parts]
        losses = [
            np.reshape(list(part.contact_losses), (-1, 3)) + np.array([begin, 0.0, 0.0])
            for begin, part in parts
        ]
        return ContactLosses(np.concatenate(losses))
