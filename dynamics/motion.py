"""What every solved motion of the disk answers, however it was solved; its outcome, transitions and jumps."""

from collections.abc import Sequence
from enum import Enum
from functools import cached_property, lru_cache
from typing import NamedTuple, Protocol, runtime_checkable

import numpy as np
from numpy.typing import ArrayLike

from .disk import Disk, Friction, Release
from .numerics import Numerics

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


class Outcome(Enum):
    """How a motion ended, with the sentence that says so."""

    SETTLED = "the inclination reached its final value: the disk lies on the table"
    TIME_LIMIT = "the time limit was reached before the disk came to rest"
    LIFTED_OFF = "the normal force fell to zero: the contact was lost"
    AIRBORNE = "the pressure of the film under the falling disk reached the contact force: the air carries the disk"
    LEFT_TABLE = "the contact came to the edge of the table: the disk falls off it"
    UPRIGHT = "the disk stood upright on a generator of its lateral surface: contact passes to the other rim"
    FELL = "the disk fell flat, with angular velocity left"
    PRECESSION_STOPPED = "the precession came to a stop, where the law of dissipation has no direction"
    CASCADE = "the regimes changed again and again at one instant"
    STALLED = "the motion became too stiff to be followed, however short the steps"

    @property
    def sentence(self) -> str:
        """The outcome in words."""
        return self.value


class Transition(NamedTuple):
    """A change of regime at t [s]: its name before and after ('roll', 'slide', with what sticks), and the guard."""

    t: float
    before: str
    after: str
    guard: str


class Jumps(NamedTuple):
    """The discontinuities of the contact force: times (j,) [s], `Motion.force` before and after them (j, 3) [N]."""

    t: np.ndarray
    before: np.ndarray
    after: np.ndarray


class MotionScene(Protocol):
    """What `simulate` reads of a scene, besides its dissipation where it has one."""

    @property
    def disk(self) -> Disk: ...
    @property
    def friction(self) -> Friction: ...
    @property
    def release(self) -> Release: ...
    @property
    def numerics(self) -> Numerics: ...


@runtime_checkable
class Motion(Protocol):
    """A solved motion, in SI units; times outside it raise ValueError. `RigidMotion` is the rigid disk's."""

    def __hash__(self) -> int: ...
    @property
    def disk(self) -> Disk: ...
    @property
    def transitions(self) -> tuple[Transition, ...]: ...
    @property
    def contact_losses(self) -> Sequence: ...
    @property
    def outcome(self) -> Outcome: ...
    @property
    def integrator(self) -> str: ...

    @property
    def t(self) -> np.ndarray:
        """Ends of the pieces of the solution, (n,) [s], from 0 to the end of the motion."""

    @property
    def t_end(self) -> float:
        """The time [s] at which the inclination of a settled motion would be zero; of another one that of its last
        instant."""

    @property
    def state(self) -> np.ndarray:
        """The state at `t`, (n, 11), with the columns COLUMNS."""

    @property
    def jumps(self) -> Jumps:
        """Every discontinuity of the contact force, with the one-sided limits of the force."""

    def at(self, t: ArrayLike) -> np.ndarray:
        """Return the state at the times t (k,) [s] as (k, 11): COLUMNS, in SI units; the frame of omega precesses."""

    def force(self, t: ArrayLike) -> np.ndarray:
        """Return the contact force at times t (k,) [s] as (k, 3) [N]: friction along a_1, a_2, and the normal force."""

    def at_and_force(self, t: ArrayLike) -> tuple[np.ndarray, np.ndarray]:
        """Return `at(t)` and `force(t)` from one evaluation."""

    def normal_load(self, t: ArrayLike) -> np.ndarray:
        """Return Phi of (4.6) at the times t (k,) [s]."""

    def steady_load(self, t: ArrayLike) -> np.ndarray:
        """Return the normal force at times t (k,) [s] as (k,) [N], without the vibration of an elastic contact."""

    def bandwidth(self, state: np.ndarray) -> np.ndarray:
        """Return the highest frequency (k,) [Hz] that the contact force is taken to hold at states (k, 11)."""

    def energy(self, t: ArrayLike) -> np.ndarray:
        """Return kinetic and potential energy [J] at times t (k,) [s], zero at rest on the table."""

    def largest_regain(self) -> float:
        """Return by how much [J] the dissipated energy ever falls, from any instant to any later one."""

    def friction_excess(self) -> float:
        """Return by how much |F|/N exceeds mu_s while rolling, or misses mu_d while sliding."""

    def regime(self, t: ArrayLike) -> np.ndarray:
        """Return the name of the regime at the times t (k,) [s], an array of strings."""


class Answers:
    """What follows from the `t`, `at` and `force` of any motion."""

    @cached_property
    def state(self: Motion) -> np.ndarray:
        """The state at `t`, (n, 11), with the columns COLUMNS."""
        return read_only(self.at(self.t))

    def at_and_force(self: Motion, t: ArrayLike) -> tuple[np.ndarray, np.ndarray]:
        """Return `at(t)` and `force(t)`."""
        return self.at(t), self.force(t)

    def normal_load(self: Motion, t: ArrayLike) -> np.ndarray:
        """Return Phi of (4.6) at the times t (k,) [s]; at rest it is (K + 4)/4."""
        return self.force(t)[:, 2] * self.disk.time_unit**2 / (self.disk.mass * self.disk.radius)


def read_only(array: ArrayLike) -> np.ndarray:
    """Return an array that cannot be changed."""
    array = np.asarray(array)
    array.flags.writeable = False
    return array


@lru_cache(maxsize=1)
def halves(motion: Motion) -> np.ndarray:
    """Return the ends and the middles (2n - 1,) [s] of the pieces of a motion, read-only."""
    return read_only(np.sort(np.concatenate([motion.t, (motion.t[:-1] + motion.t[1:]) / 2])))
