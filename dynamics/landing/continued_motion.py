"""Motions that lose their rolling contact: what follows, to rest or to rolling again."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike

from dynamics.contact_losses import ContactLosses
from dynamics.landing import MAX_BOUNCE_ENERGY_ERROR
from dynamics.landing.landing_motion import LandingMotion
from dynamics.motion import FindingGroup, Motion, MotionEvent, Outcome
from dynamics.sequential_motion import SequentialMotion

if TYPE_CHECKING:
    from dynamics.compliant.stepping.rim_modes import RimModes


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
    """A `Motion` of a disk that loses its contact and rolls again.

    Where it rolls again, the creep of the contact and its vibration end. Their energy
    remains part of the energy, so that it is continuous.
    """

    first: LandedMotion

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
        """Offset of the dissipated energy; the second part begins with the other columns."""
        offset = np.zeros_like(super()._column_offset)
        offset[-1] = super()._column_offset[-1]
        return offset

    @cached_property
    def contact_losses(self) -> ContactLosses:
        """Losses of contact, with those of the landings between the rolling motions."""
        parts = (self.first.rolling, self.first.landing, self.then)
        begins = (0.0, self.first.switch_time, self.switch_time)
        losses = [
            np.reshape(list(part.contact_losses), (-1, 3)) + np.array([begin, 0.0, 0.0])
            for part, begin in zip(parts, begins, strict=True)
        ]
        return ContactLosses(np.concatenate(losses))
