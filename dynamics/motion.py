"""Interface of solved motions, and the types of their outcomes and transitions."""

from collections.abc import Sequence
from enum import Enum
from functools import cached_property, lru_cache
from typing import (
    TYPE_CHECKING,
    Any,
    Literal,
    NamedTuple,
    Protocol,
    runtime_checkable,
)

import numpy as np
from numpy.typing import ArrayLike

from dynamics.disk import Disk, Release
from dynamics.film.wedge import Film, film_loads_of

if TYPE_CHECKING:
    from matplotlib.figure import Figure
    from pandas import DataFrame

    from dynamics.landing.landing_motion import LandingMotion
    from dynamics.motion_plan import MotionPlan
    from dynamics.stepping_core.rim_modes import RimModes

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
"""Names of the columns of `Motion.state`.

They contain the angles of precession, inclination and spin [rad], the position of the
centre [m], the angular velocity [rad/s] and the slip velocity [m/s] in the precessing
frame, and the dissipated energy [J].
"""
FORCE_COLUMNS = ("friction_1", "friction_2", "normal_force")
"""Names of the columns of `Motion.force` [N]: friction along a_1 and a_2, and the normal force."""
FILM_COLUMNS = ("mean_gap", "lift", "moment_1", "moment_3", "half_arc")
"""Names of the columns of `Motion.film_loads`.

They contain the mean gap below the face [m], the lift of the film [N], its moments about
e_1 and e_3 [N m], and half the arc of the rim that touches the table [rad], which is zero
for a contact point.
"""


class Outcome(Enum):
    """How a motion ended; each value describes it in a sentence.

    Examples
    --------
    >>> from dynamics import Outcome
    >>> Outcome.ROLLING_ON.sentence
    'the time limit was reached before the disk came to rest'
    """

    AT_REST = "the disk came to rest"
    SETTLED = "the disk settled: its inclination reached the final value"
    ROLLING_ON = "the time limit was reached before the disk came to rest"
    TIME_LIMIT = ROLLING_ON
    """Former name of ROLLING_ON."""
    LIFTED_OFF = "the disk lifted off: the normal force fell to zero"
    AIRBORNE = (
        "the disk became airborne: the lift of the air film reached the contact force"
    )
    LEFT_TABLE = "the contact reached the edge of the table: the disk falls off"
    UPRIGHT = "the disk stood upright on its lateral surface: the contact moves to the other rim"
    FELL = "the disk fell onto its face"
    SANK = "the disk sank onto its face"
    PRECESSION_STOPPED = (
        "the precession stopped, where the dissipation law is undefined"
    )
    CASCADE = "the contact regime changed without end at one instant"
    STALLED = "the motion became too stiff to integrate, even with the shortest steps"

    @property
    def sentence(self) -> str:
        """The sentence that describes the outcome."""
        return self.value

    @property
    def is_rest(self) -> bool:
        """True if the end of the motion was solved: the disk settled, sank or is at rest."""
        return self in (Outcome.SETTLED, Outcome.SANK, Outcome.AT_REST)

    @property
    def lies_flat(self) -> bool:
        """True if the disk finally lies flat on the table."""
        return self in (Outcome.SETTLED, Outcome.SANK, Outcome.FELL)


class Transition(NamedTuple):
    """A change of regime.

    Parameters
    ----------
    t : float
        Time [s].
    before, after : str
        Names of the two regimes, such as 'roll', 'slide' or 'roll, nutation sticks'.
    guard : str
        Name of the guard that crossed zero, such as 'slip'.

    Examples
    --------
    >>> from dynamics import Transition
    >>> Transition(t=1.5, before="roll", after="slide", guard="slip").after
    'slide'
    """

    t: float
    before: str
    after: str
    guard: str


class MotionEvent(NamedTuple):
    """An event on the way of the disk.

    Parameters
    ----------
    t : float
        Time [s].
    kind : str
        What happened, such as 'fell onto its face'.
    speed : float
        Speed of the surfaces towards each other [m/s].
    energy : float
        Kinetic energy of this approach [J].

    Examples
    --------
    >>> from dynamics import simulate
    >>> from sonify import load_scene
    >>> still = "release={inclination_deg=5, omega=[0, 0, 0]}"
    >>> event, *touches = simulate(load_scene("published").replace(still)).events
    >>> f"{event.kind} at {event.speed:.2f} m/s with {event.energy:.3f} J"
    'fell onto its face at 0.45 m/s with 0.014 J'
    """

    t: float
    kind: str
    speed: float
    energy: float


class ForceJumps(NamedTuple):
    """Discontinuities of the contact force.

    Parameters
    ----------
    t : ndarray, (j,)
        Times [s].
    before, after : ndarray, (j, 3)
        Limits of the force from the left and from the right [N].
    """

    t: np.ndarray
    before: np.ndarray
    after: np.ndarray


CAUSES = ("contact", "creep", "slip", "moments", "table", "film", "body")
"""Names of the energy sinks.

"contact" is the compression of the contact, "creep" its creep, "slip" sliding friction, "moments"
the resisting moments, "table" the modes of the table, "film" the air film, and "body" the modes of
the disk.
"""


FindingGroup = Literal["air", "contact", "rattling", "two-way"]
"""Group of findings that apply to a motion: on the air, on a single elastic contact, on
contacts anywhere on the rim, and on the onset of two-way coupling with the table."""
SINGLE_CONTACT_GROUPS: tuple[FindingGroup, ...] = ("air", "contact", "two-way")
"""Groups of findings that apply to a motion with a single contact."""


class MotionPart(NamedTuple):
    """Part of a motion that was solved with one model.

    Parameters
    ----------
    begin : float
        Start of the part [s].
    motion : Motion
        The motion, with its time measured from `begin`.
    """

    begin: float
    motion: "Motion"


class MotionBase(Protocol):
    """What motions share: quantities that follow from the others of a `Motion`, and defaults."""

    @property
    def parts(self: "Motion") -> tuple[MotionPart, ...]:
        """Parts that were solved with different models, in order of time."""
        return (MotionPart(0.0, self),)

    @property
    def rolling(self: "Motion") -> "Motion":
        """The motion up to the loss of its rolling contact, or the whole motion."""
        return self

    @property
    def landing(self) -> "LandingMotion | None":
        """The motion from the loss of the rolling contact to rest, or None."""
        return None

    @property
    def outcome(self: "Motion") -> Outcome:
        """How the motion ended: AT_REST, or what prevented that."""
        ends_flat = self.rolling_outcome in (Outcome.SETTLED, Outcome.SANK)
        return Outcome.AT_REST if ends_flat else self.rolling_outcome

    @property
    def lift_off_speed(self) -> float:
        """Velocity [m/s] at which the low point of the rim leaves the table at the end."""
        return 0.0

    @property
    def solves_contact(self) -> bool:
        """True if the whole motion includes the vibration of an elastic contact."""
        return False

    @property
    def moves_table(self) -> bool:
        """True if the table and the disk are coupled from the start of the motion."""
        return False

    @property
    def finding_groups(self) -> tuple[FindingGroup, ...]:
        """Groups of findings that apply to the motion."""
        return SINGLE_CONTACT_GROUPS

    @property
    def rim_modes(self) -> "RimModes | None":
        """Modes of the disk whose vibration is part of the motion, or None.

        Without them, the force on the modes follows from the contact force.
        """
        return None

    @property
    def vibration_crossover(self) -> float | None:
        """Frequency [Hz] above which the contact force is vibration of the contact.

        It is None if the motion does not include this vibration.
        """
        return None

    @property
    def max_energy_error(self) -> float | None:
        """Largest relative error of the energy balance that the time step explains.

        It is None if the balance is exact except for rounding.
        """
        return None

    @property
    def jumps(self) -> ForceJumps:
        """The discontinuities of the contact force, with the one-sided limits of the force."""
        return ForceJumps(np.zeros(0), np.zeros((0, 3)), np.zeros((0, 3)))

    @cached_property
    def state(self: "Motion") -> np.ndarray:
        """The state at `t`, (n, 11), with the columns COLUMNS."""
        return read_only(self.at(self.t))

    def contact_force(self: "Motion", t: ArrayLike) -> np.ndarray:
        """Return the normal force of the contact at times t, without that of the film.

        Parameters
        ----------
        t : array_like, (k,)
            Times [s].

        Returns
        -------
        ndarray, (k,)
            Normal force [N].

        Raises
        ------
        ValueError
            If a time is outside the motion.
        """
        return self.force(t)[:, 2]

    def film_loads(self: "Motion", t: ArrayLike, state: np.ndarray) -> np.ndarray:
        """Return the loads on the disk besides the contact force, and the gap below it.

        Parameters
        ----------
        t : array_like, (k,)
            Times [s].
        state : ndarray, (k, 11)
            The state at these times.

        Returns
        -------
        ndarray, (k, 5)
            The columns FILM_COLUMNS: mean gap below the face [m], lift of the film [N],
            moments about e_1 and e_3 [N m], and half the arc of the rim that touches the
            table [rad]. A force on an arc acts at the low point, and the moments correct
            for its distribution.

        Raises
        ------
        ValueError
            If a time is outside the motion.
        """
        gap = self.disk.radius * np.sin(state[:, 1])
        lift, moment_1, moment_3 = film_loads_of(self.film, self.disk, state)
        return np.column_stack([gap, lift, moment_1, moment_3, np.zeros(len(state))])

    def rim_vibration(self, t: ArrayLike) -> np.ndarray:
        """Return the vibration of the `rim_modes` at times t.

        Parameters
        ----------
        t : array_like, (k,)
            Times [s].

        Returns
        -------
        ndarray, (k, 3, m)
            Displacement, velocity and acceleration of modes of unit modal mass; empty
            without such modes.

        Raises
        ------
        ValueError
            If a time is outside the motion.
        """
        return np.zeros((np.size(t), 3, 0))

    def at_and_force(self: "Motion", t: ArrayLike) -> tuple[np.ndarray, np.ndarray]:
        """Return the state and the contact force at times t from one evaluation.

        Parameters
        ----------
        t : array_like, (k,)
            Times [s].

        Returns
        -------
        state : ndarray, (k, 11)
            As returned by `at`.
        force : ndarray, (k, 3)
            As returned by `force`.

        Raises
        ------
        ValueError
            If a time is outside the motion.
        """
        return self.at(t), self.force(t)

    def inclination(self: "Motion", t: ArrayLike) -> np.ndarray:
        """Return the inclination at times t.

        Parameters
        ----------
        t : array_like, (k,)
            Times [s].

        Returns
        -------
        ndarray, (k,)
            Inclination [rad].
        """
        return self.at(t)[:, COLUMNS.index("inclination")]

    def precession(self: "Motion", t: ArrayLike) -> np.ndarray:
        """Return the precession angle at times t.

        Parameters
        ----------
        t : array_like, (k,)
            Times [s].

        Returns
        -------
        ndarray, (k,)
            Precession angle [rad].
        """
        return self.at(t)[:, COLUMNS.index("precession")]

    def spin(self: "Motion", t: ArrayLike) -> np.ndarray:
        """Return the spin angle of the disk about its axis at times t.

        Parameters
        ----------
        t : array_like, (k,)
            Times [s].

        Returns
        -------
        ndarray, (k,)
            Spin angle [rad].
        """
        return self.at(t)[:, COLUMNS.index("spin")]

    def plot(self: "Motion") -> "Figure":
        """Plot inclination, precession rate and normal force against time.

        Returns
        -------
        matplotlib.figure.Figure
            The figure.
        """
        from dynamics.plotting import plot_motion  # matplotlib is slow to import

        return plot_motion(self)

    def to_frame(self: "Motion", t: ArrayLike | None = None) -> "DataFrame":
        """Return the motion at times t as a pandas data frame.

        Parameters
        ----------
        t : array_like, (k,), optional
            Times [s]; by default the breakpoints `t`.

        Returns
        -------
        pandas.DataFrame, (k, 14)
            The columns COLUMNS of the state and FORCE_COLUMNS of the contact force,
            with the index "t".

        Raises
        ------
        ImportError
            If pandas is not installed.
        ValueError
            If a time is outside the motion.
        """
        from pandas import DataFrame, Index

        times = np.atleast_1d(np.asarray(self.t if t is None else t, float))
        rows = np.column_stack(self.at_and_force(times))
        return DataFrame(
            rows, index=Index(times, name="t"), columns=[*COLUMNS, *FORCE_COLUMNS]
        )

    def largest_regain(self: "Motion") -> float:
        """Return `largest_energy_gain_error` under its former name.

        Returns
        -------
        float
            Energy [J].
        """
        return self.largest_energy_gain_error()

    def normal_load(self: "Motion", t: ArrayLike) -> np.ndarray:
        """Return the dimensionless normal force Phi of (4.6) at times t.

        Parameters
        ----------
        t : array_like, (k,)
            Times [s].

        Returns
        -------
        ndarray, (k,)
            Normal force in units of m R/chi^2; (K + 4)/4 at rest.
        """
        return (
            self.force(t)[:, 2]
            * self.disk.time_unit**2
            / (self.disk.mass * self.disk.radius)
        )

    def steady_load(self: "Motion", t: ArrayLike) -> np.ndarray:
        """Return the normal force without contact vibration at times t.

        Parameters
        ----------
        t : array_like, (k,)
            Times [s].

        Returns
        -------
        ndarray, (k,)
            Normal force [N].
        """
        return self.force(t)[:, 2]

    def steady_nutation(self: "Motion", t: ArrayLike) -> np.ndarray:
        """Return the nutation rate omega_1 without contact vibration at times t.

        Parameters
        ----------
        t : array_like, (k,)
            Times [s].

        Returns
        -------
        ndarray, (k,)
            Nutation rate [rad/s].
        """
        return self.at(t)[:, COLUMNS.index("omega_1")]


@runtime_checkable
class Motion(MotionBase, Protocol):
    """A solved motion in SI units, as returned by `simulate`.

    The methods accept times within [0, t[-1]] and raise ValueError for others. Angular
    velocities are components in the frame that precesses with the contact. The
    inclination is pi/2 - alpha, where alpha is the angle of the paper.

    See Also
    --------
    RigidMotion : The motion of a rigid disk on a rigid contact.

    Examples
    --------
    >>> from dynamics import simulate
    >>> from sonify import load_scene
    >>> motion = simulate(load_scene("published").replace("numerics.accuracy=draft"))
    >>> state = motion.at([0.0, 0.5])
    >>> state.shape
    (2, 11)
    >>> motion.outcome.name
    'AT_REST'
    """

    def __hash__(self) -> int: ...
    @property
    def plan(self) -> "MotionPlan":
        """The decisions of the motion."""

    @property
    def disk(self) -> Disk:
        """Disk of the scene."""

    @property
    def transitions(self) -> tuple[Transition, ...]:
        """Changes of regime, in order of time."""

    @property
    def contact_losses(self) -> Sequence[Any]:
        """Losses of contact, each with t [s], duration [s] and height [m]."""

    @property
    def rolling_outcome(self) -> Outcome:
        """How the rolling motion ended, such as SETTLED, FELL or AIRBORNE."""

    @property
    def integrator(self) -> str:
        """Name of the integrator."""

    @property
    def film(self) -> Film | None:
        """The air film that acts on the disk, or None."""

    @property
    def rolling_fillet(self) -> float:
        """Radius [m] of the edge on which the disk rolls; 0 for a sharp edge."""

    @property
    def events(self) -> tuple[MotionEvent, ...]:
        """What happened on the way of the disk, in order of time."""

    @property
    def t(self) -> np.ndarray:
        """Breakpoints (n,) [s] of the solution, from 0 to the end of the motion."""

    @property
    def t_end(self) -> float:
        """Time [s] at which a settled disk would be flat; the end of any other motion."""

    def at(self, t: ArrayLike) -> np.ndarray:
        """Return the state at times t.

        Parameters
        ----------
        t : array_like, (k,)
            Times [s].

        Returns
        -------
        ndarray, (k, 11)
            The columns COLUMNS: precession, inclination and spin [rad], position x, y
            of the centre [m], angular velocity [rad/s] and slip velocity [m/s] in the
            precessing frame, and dissipated energy [J].

        Raises
        ------
        ValueError
            If a time is outside the motion.
        """

    def force(self, t: ArrayLike) -> np.ndarray:
        """Return the contact force at times t.

        Parameters
        ----------
        t : array_like, (k,)
            Times [s].

        Returns
        -------
        ndarray, (k, 3)
            Friction along a_1 and a_2, and normal force [N]. At a jump, it is the limit
            from the right.

        Raises
        ------
        ValueError
            If a time is outside the motion.
        """

    def bandwidth(self, state: np.ndarray) -> np.ndarray:
        """Return the highest relevant frequency of the contact force.

        Parameters
        ----------
        state : ndarray, (k, 11)
            States with the columns COLUMNS.

        Returns
        -------
        ndarray, (k,)
            Frequencies [Hz].
        """

    def energy(self, t: ArrayLike) -> np.ndarray:
        """Return the kinetic plus potential energy at times t.

        Parameters
        ----------
        t : array_like, (k,)
            Times [s].

        Returns
        -------
        ndarray, (k,)
            Energy [J]; zero at rest.
        """

    def energy_lost(self, t: ArrayLike) -> dict[str, np.ndarray]:
        """Return the energy lost from the release until times t, by cause.

        Parameters
        ----------
        t : array_like, (k,)
            Times [s].

        Returns
        -------
        dict of str to ndarray, (k,)
            Lost energy [J] for each of CAUSES.
        """

    def dissipation(self, t: ArrayLike) -> dict[str, np.ndarray]:
        """Return the dissipated power at times t, by cause.

        Parameters
        ----------
        t : array_like, (k,)
            Times [s].

        Returns
        -------
        dict of str to ndarray, (k,)
            Dissipated power [W] for each of CAUSES.
        """

    def largest_energy_gain_error(self) -> float:
        """Return the largest decrease of the dissipated energy between two times.

        It is a measure of the numerical error: the exact value is zero.

        Returns
        -------
        float
            Energy [J].
        """

    def friction_excess(self) -> float:
        """Return the largest deviation of |F|/N from Coulomb's law (3.2).

        It is the excess over mu_static during rolling, and the difference from
        mu_dynamic during sliding.

        Returns
        -------
        float
            Ratio of friction to normal force, dimensionless.
        """

    def tensile_time(self) -> float:
        """Return the time in which the contact pulls the disk towards the table.

        A contact that exerts no force outside its recorded losses counts as well.

        Returns
        -------
        float
            Time [s]; the exact value is zero.
        """

    def regime(self, t: ArrayLike) -> np.ndarray:
        """Return the names of the regimes at times t.

        Parameters
        ----------
        t : array_like, (k,)
            Times [s].

        Returns
        -------
        ndarray, (k,)
            Names, such as 'roll' or 'slide'.
        """


def release_columns(release: Release) -> np.ndarray:
    """Return the COLUMNS (11,) of a disk that is released on its contact without slip."""
    columns = np.zeros(len(COLUMNS))
    columns[COLUMNS.index("inclination")] = np.radians(release.inclination_deg)
    columns[5:8] = release.omega
    return columns


def times_within(t: ArrayLike, end: float) -> np.ndarray:
    """Return times t (k,) [s] as an array.

    Raises ValueError for times outside a motion that lasts from 0 to `end` [s].
    """
    t = np.atleast_1d(np.asarray(t, dtype=float))
    if t.ndim > 1:
        raise ValueError(
            f"t must be a scalar or one-dimensional array of times [s], not of shape {t.shape}"
        )
    if t.size and not (t.min() >= 0 and t.max() <= end * (1 + 1e-14)):
        raise ValueError(f"t must be within the motion, 0 to {end:.9g} s")
    return t


def read_only(array: ArrayLike) -> np.ndarray:
    """Make an array read-only and return it."""
    array = np.asarray(array)
    array.flags.writeable = False
    return array


@lru_cache(maxsize=1)
def piece_ends_and_middles(motion: Motion) -> np.ndarray:
    """Return the sorted ends and midpoints (2n - 1,) [s] of the pieces of a motion."""
    middles = (motion.t[:-1] + motion.t[1:]) / 2
    return read_only(np.sort(np.concatenate([motion.t, middles])))


@lru_cache(maxsize=1)
def force_at_ends_and_middles(motion: Motion) -> np.ndarray:
    """Return the contact force (2n - 1, 3) [N] at `piece_ends_and_middles`."""
    return read_only(motion.force(piece_ends_and_middles(motion)))
