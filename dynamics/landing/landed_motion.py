"""Motion that rolls until the contact is lost, and then lands and comes to rest."""

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike

from dynamics.landing.landing_motion import LandingMotion
from dynamics.motion import FindingGroup, Motion, MotionEvent, Outcome
from dynamics.sequential_motion import SequentialMotion

if TYPE_CHECKING:
    from dynamics.compliant.stepping.rim_modes import RimModes


@dataclass(frozen=True, eq=False)
class LandedMotion(SequentialMotion):
    """A `Motion` of a disk that rolls, loses its contact nearly flat, and lands.

    The hand-over keeps position, velocity and dissipated energy. The energy stored in
    the contact and in the place on a concave table remains part of the energy.
    """

    first: Motion
    then: LandingMotion

    def __repr__(self) -> str:
        """Return a one-line summary."""
        cause = self.first.outcome.name
        return f"Motion({self.t[-1]:.6g} s, {self.outcome.name}, {cause} at {self.switch_time:.6g} s)"

    @property
    def outcome(self) -> Outcome:
        """Outcome of the landing."""
        return self.then.outcome

    @property
    def rolling(self) -> Motion:
        """The motion until the loss of the rolling contact."""
        return self.first

    @property
    def landing(self) -> LandingMotion:
        """The motion from there to rest."""
        return self.then

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
    def contact_losses(self) -> Any:
        """Losses of contact of the rolling motion."""
        return self.first.contact_losses

    @property
    def events(self) -> tuple[MotionEvent, ...]:
        """The loss of contact, what the disk touches as it lands, and the rest."""
        begin = self.switch_time
        return tuple(event._replace(t=begin + event.t) for event in self.then.events)

    def energy(self, t: ArrayLike) -> np.ndarray:
        """Return the total energy (k,) [J] at t (k,) [s]; it is continuous."""
        return super().energy(t) + self._is_late(t) * self.energy_step
