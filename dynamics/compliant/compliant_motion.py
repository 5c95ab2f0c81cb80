"""Solution of a scene with an elastic contact, and its `Motion`."""

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cached_property
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from dynamics.compliant.law.hertz_mindlin import MIN_CONTACT_INCLINATION
from dynamics.compliant.law.linearised import mobility
from dynamics.compliant.law.roughness import profiles
from dynamics.compliant.model_inputs import final_contact_inclination
from dynamics.compliant.model_selection import release_force
from dynamics.compliant.state_conversion import (
    columns,
    energy,
    inclination,
    limit_energy,
    preloaded_compliant_state,
)
from dynamics.compliant.stepping.model import END_REASONS, CompliantModel
from dynamics.compliant.stepping.state_layout import ENERGY_LOSSES, STATE
from dynamics.compliant.stepping.time_loop import FLAT_INCLINATION
from dynamics.contact_losses import ContactLosses
from dynamics.disk import Disk
from dynamics.dissipation import power_laws
from dynamics.face_contact import face_events, outcome_when_flat
from dynamics.film.wedge import Film
from dynamics.motion import (
    CAUSES,
    COLUMNS,
    MotionBase,
    MotionEvent,
    Outcome,
    Transition,
    read_only,
    times_within,
)
from dynamics.observables import precession_rate
from dynamics.rigid_motion import FORCE_HARMONICS
from dynamics.stepping_core.end_reasons import OUTCOME_OF_END, EndReason
from dynamics.stepping_core.ledger import (
    DISK_ENERGY_COLUMN,
    ENERGY_COLUMN,
    LOSS_COLUMNS,
    TABLE_ENERGY_COLUMN,
    motion_rows,
)
from dynamics.stepping_core.rim_modes import (
    MAX_MOVING_MODE_FREQUENCY,
    NO_RIM_MODES,
    moving_rim_modes,
)
from dynamics.stepping_core.row_store import RowStore, interpolate_rows
from dynamics.switching import ImpossibleContactError

if TYPE_CHECKING:
    from dynamics.motion_plan import MotionPlan

MAX_REPEATED_STEP_RATE = 3e6
"""Rate [1/s] below which a motion with an unsolved step is solved again with half the step."""

FORCE_SAMPLE_RATE = 1e5
"""Number of mean forces stored per second of motion."""
FORCES_PER_ROW = 4
"""Number of mean forces stored per row."""


@dataclass(frozen=True, kw_only=True, eq=False)
class CompliantMotion(MotionBase):
    """A `Motion` with an elastic contact, stored as rows at equal time intervals.

    Between rows, the impulses and the columns are interpolated by polynomials, the
    energies linearly.

    Attributes
    ----------
    plan : MotionPlan
        The decisions of the motion.
    model : CompliantModel
        Disk and contact.
    dt : float
        Time between two impulses [s].
    impulses : (n, 3) array
        Impulse of the contact force since the start [N s].
    rows : (r, 21) array
        COLUMNS, energies and losses; one row for every FORCES_PER_ROW impulses.
    slides : (s, 2) array
        Start and end of each slip [s].
    contact_losses : ContactLosses
        Losses of contact.
    max_friction_excess : float
        Largest excess of the friction over its cone [N].
    rolling_outcome : Outcome
        Outcome of the motion.
    lift_off_speed : float
        Velocity [m/s] at which the low point of the rim leaves the table at the end,
        relative to the table.
    """

    plan: "MotionPlan"
    model: CompliantModel
    dt: float
    impulses: np.ndarray
    rows: np.ndarray
    slides: np.ndarray
    contact_losses: ContactLosses
    max_friction_excess: float
    rolling_outcome: Outcome
    lift_off_speed: float = 0.0

    def __repr__(self) -> str:
        """Return a one-line summary."""
        lost = f"{len(self.contact_losses)} losses of contact"
        return f"Motion({self._end:.6g} s, {self.outcome.name}, {len(self.transitions)} transitions, {lost})"

    @property
    def disk(self) -> Disk:
        """The disk."""
        return self.model.tabulated_law.law.disk

    @property
    def film(self) -> Film | None:
        """The air film that acts on the disk, or None."""
        return self.model.film

    @property
    def rolling_fillet(self) -> float:
        """Radius [m] of the edge on which the disk rolls; 0 for a sharp edge."""
        return self.model.tabulated_law.law.rolling_fillet

    @property
    def events(self) -> tuple[MotionEvent, ...]:
        """The contact of the face with the table, if it ends the motion."""
        return face_events(self)

    @property
    def solves_contact(self) -> bool:
        """True, because the vibration of the contact is solved."""
        return True

    @property
    def moves_table(self) -> bool:
        """True if the modes of the table are coupled to the disk."""
        return self.model.modes is not None

    @cached_property
    def vibration_crossover(self) -> float:
        """Half the contact resonance [Hz] under the weight at the release."""
        tabulated = self.plan.tabulated_law
        assert tabulated is not None  # the contact is elastic
        first = self.state[:1, 1]
        resonance = tabulated.contact_resonance(first, self.disk.weight, 0.0)
        return float(resonance.frequency[0]) / 2

    @property
    def integrator(self) -> str:
        """Name of the time-stepping scheme, and its step rate."""
        return f"discrete gradient, {self.model.rate:.4g} steps/s"

    @property
    def _row_duration(self) -> float:
        """Time between two rows [s]."""
        return FORCES_PER_ROW * self.dt

    @property
    def _end(self) -> float:
        return (len(self.rows) - 1) * self._row_duration

    @cached_property
    def t(self) -> np.ndarray:
        """Breakpoints (n,) [s]: changes of regime, and times between small precessions."""
        max_piece_turn = 0.25  # largest precession in one piece [rad]
        turned = np.append(0.0, np.cumsum(np.abs(np.diff(self.rows[:, 0]))))
        first_of_piece = np.unique(turned // max_piece_turn, return_index=True)[1]
        nodes = np.append(first_of_piece, len(turned) - 1)
        changes = [event.t for event in self.transitions]
        return read_only(np.unique(np.append(nodes * self._row_duration, changes)))

    def at(self, t: ArrayLike) -> np.ndarray:
        """Return the COLUMNS (k, 11) at times t (k,) [s].

        Raises ValueError for times outside the motion.
        """
        rows = interpolate_rows(self.rows, self._fractional_rows(t), False)
        state = rows[:, : len(COLUMNS)]
        state[:, -1] = self.lost_by_cause(t).sum(axis=1)
        return state

    def force(self, t: ArrayLike) -> np.ndarray:
        """Return friction along a_1, a_2 and normal force (k, 3) [N] at t (k,) [s].

        The force is the derivative of the interpolated impulse. The normal force is not
        negative.
        """
        force = self._impulse_rate(self.impulses, t)
        force[:, 2] = np.maximum(force[:, 2], 0.0)
        return force

    def _impulse_rate(self, impulses: np.ndarray, t: ArrayLike) -> np.ndarray:
        """Return the derivative (k, m) [N] of impulses (n, m) [N s] at t (k,) [s]."""
        place = self._fractional_rows(t) * FORCES_PER_ROW
        return interpolate_rows(impulses, place, True) / self.dt

    def steady_load(self, t: ArrayLike) -> np.ndarray:
        """Return the normal force (k,) [N] at t (k,) [s] without contact vibration.

        It is the mean over half a turn of the contact with a Hann window, which retains
        nine tenths of the amplitude of nutation.
        """
        # Number of intervals in the mean of the force over half a turn
        load_window_parts = 24
        offset = np.linspace(-0.25, 0.25, load_window_parts + 1)[:, None]
        edges = np.asarray(t) + offset * self._turn_duration(t)
        edges = np.clip(edges, 0, self._end)
        place = self._fractional_rows(edges.ravel()) * FORCES_PER_ROW
        impulse = interpolate_rows(self.impulses, place, False)[:, 2]
        phase = np.pi * (np.arange(load_window_parts) + 0.5) / load_window_parts
        hann = np.sin(phase)[:, None] ** 2
        changes = np.diff(impulse.reshape(edges.shape), axis=0)
        durations = np.diff(edges, axis=0)
        return (hann * changes).sum(axis=0) / (hann * durations).sum(axis=0)

    def steady_nutation(self, t: ArrayLike) -> np.ndarray:
        """Return omega_1 (k,) [rad/s] at t (k,) [s] without contact vibration.

        It is the mean rate at which the inclination decreases over a sixteenth of a
        turn of the contact. This time is much longer than a period of the contact
        resonance and much shorter than a nutation.
        """
        t = np.asarray(t, dtype=float)
        turn = self._turn_duration(t)
        before = np.maximum(t - turn / 32, 0.0)
        after = np.minimum(t + turn / 32, self._end)
        return (self.at(before)[:, 1] - self.at(after)[:, 1]) / (after - before)

    def _turn_duration(self, t: ArrayLike) -> np.ndarray:
        """Return the duration (k,) [s] of one turn of the contact at times t (k,) [s]."""
        rate = np.abs(precession_rate(self.at(t)))
        return 2 * np.pi / np.maximum(rate, np.pi / self._end)

    def contact_resonance(self, inclination: ArrayLike) -> np.ndarray:
        """Return the normal contact resonance (k,) [Hz] at inclinations (k,) [rad].

        The load is the weight.
        """
        springs = self.model.tabulated_law.springs(inclination, self.disk.weight)[0]
        W = mobility(
            self.disk, inclination, self.model.tabulated_law.law.rolling_fillet
        )
        return np.sqrt(springs.kn * W[:, 2, 2]) / (2 * np.pi)

    def bandwidth(self, state: np.ndarray) -> np.ndarray:
        """Return the highest frequency (k,) [Hz] of the contact force at states (k, 11)."""
        # ratio of the bandwidth to the contact resonance; the force at higher frequencies is less
        # than a hundredth
        max_overtone = 2
        turning = np.abs(precession_rate(state)) / (2 * np.pi)
        beta = np.maximum(state[:, 1], MIN_CONTACT_INCLINATION)
        overtone = max_overtone * self.contact_resonance(beta)
        highest = np.maximum(FORCE_HARMONICS * turning, overtone)
        return np.minimum(highest, FORCE_SAMPLE_RATE / 2)

    def energy(self, t: ArrayLike) -> np.ndarray:
        """Return the total energy (k,) [J] at times t (k,) [s]."""
        return self._stored_at(t)[:, ENERGY_COLUMN]

    def lost_by_cause(self, t: ArrayLike) -> np.ndarray:
        """Return the energy (k, 7) [J] lost to each of CAUSES up to times t (k,) [s]."""
        return self._stored_at(t)[:, LOSS_COLUMNS]

    def energy_lost(self, t: ArrayLike) -> dict[str, np.ndarray]:
        """Return the energy (k,) [J] lost to each of CAUSES up to times t (k,) [s]."""
        return dict(zip(CAUSES, self.lost_by_cause(t).T, strict=True))

    def dissipation(self, t: ArrayLike) -> dict[str, np.ndarray]:
        """Return the power (k,) [W] dissipated by each of CAUSES, the mean of a row."""
        first = np.minimum(self._fractional_rows(t).astype(int), len(self.rows) - 2)
        lost = self.rows[first + 1, LOSS_COLUMNS] - self.rows[first, LOSS_COLUMNS]
        return dict(zip(CAUSES, lost.T / self._row_duration, strict=True))

    def table_energy(self, t: ArrayLike) -> np.ndarray:
        """Return the energy (k,) [J] of coupled table modes at times t (k,) [s]."""
        return self._stored_at(t)[:, TABLE_ENERGY_COLUMN]

    def disk_mode_energy(self, t: ArrayLike) -> np.ndarray:
        """Return the energy (k,) [J] of coupled disk modes at times t (k,) [s]."""
        return self._stored_at(t)[:, DISK_ENERGY_COLUMN]

    def largest_energy_gain_error(self) -> float:
        """Return the largest decrease [J] of the energy lost to one cause; see `Motion`."""
        lost = self.rows[:, LOSS_COLUMNS]
        return float((np.maximum.accumulate(lost, axis=0) - lost).max())

    def friction_excess(self) -> float:
        """Return the largest excess of friction over its limit, divided by the weight."""
        return self.max_friction_excess / self.disk.weight

    @property
    def contact_impulses(self) -> np.ndarray:
        """Normal impulse (n,) [N s] of the contact since the start."""
        return self.impulses[:, 2]

    def tensile_time(self) -> float:
        """Return `Motion.tensile_time`, from the mean forces between the impulses.

        At both ends of a loss of contact, two mean forces may be partly zero.
        """
        impulse = self.contact_impulses
        force = np.diff(impulse) / self.dt
        rounding = impulse_rounding(impulse, self.dt)
        t = self.dt * np.arange(len(force))
        open_contact = _is_within(self._flights + 2 * self.dt * np.array([-1, 1]), t)
        pulls = (force < -rounding) | ((force <= rounding) & ~open_contact)
        return float(self.dt * np.count_nonzero(pulls))

    def regime(self, t: ArrayLike) -> np.ndarray:
        """Return 'roll', 'slide' or 'flight' (k,) at times t (k,) [s]."""
        self._fractional_rows(t)
        return np.where(
            _is_within(self._flights, t),
            "flight",
            np.where(_is_within(self.slides, t), "slide", "roll"),
        )

    @cached_property
    def transitions(self) -> tuple[Transition, ...]:
        """Changes of regime, with the guards 'lift-off', 'impact', 'slip' and 'grip'."""
        t = np.concatenate([self._flights.T.ravel(), self.slides.T.ravel()])
        counts = np.repeat([len(self._flights), len(self.slides)], 2)
        order = np.argsort(t, kind="stable")
        order = order[(t[order] > 0) & (t[order] < self._end)]
        t = t[order]
        guards = np.repeat(["lift-off", "impact", "slip", "grip"], counts)[order]
        before = self.regime(np.nextafter(t, -1.0))
        after = self.regime(t)
        # a slide may begin or end at the very time of an impact or a lift-off
        changed = (before != after) & np.append(True, np.diff(t) > 0)[: len(t)]
        columns = (column[changed].tolist() for column in (t, before, after, guards))
        return tuple(Transition(*change) for change in zip(*columns, strict=True))

    @cached_property
    def t_end(self) -> float:
        """Time [s] at which a settled disk would be flat; the end of any other motion.

        The square root of the inclination is extrapolated from its last decade to zero.
        """
        decade = self._last_decade
        before, last = np.sqrt(self.rows[[decade, -1], 1])
        if self.rolling_outcome is not Outcome.SETTLED or not before > last:
            return self._end
        duration = self._end - decade * self._row_duration
        return float(self._end + last * duration / (before - last))

    @property
    def last_decade_precession(self) -> float:
        """Precession [rad] in the last decade of inclination."""
        return float(abs(self.rows[-1, 0] - self.rows[self._last_decade, 0]))

    @property
    def _last_decade(self) -> int:
        """Row after which the inclination remains below ten times its final value."""
        above = np.flatnonzero(self.rows[:, 1] > 10 * self.rows[-1, 1])
        return int(above[-1]) if len(above) else 0

    @cached_property
    def _flights(self) -> np.ndarray:
        begin, duration, _ = self.contact_losses.array.T
        return np.column_stack([begin, begin + duration])

    def _fractional_rows(self, t: ArrayLike) -> np.ndarray:
        """Return the fractional row indices of times t (k,) [s].

        Raises ValueError for times outside the motion.
        """
        return np.minimum(
            times_within(t, self._end) / self._row_duration, len(self.rows) - 1
        )

    def _stored_at(self, t: ArrayLike) -> np.ndarray:
        """Interpolate rows (k, 21) linearly, which preserves energy balances."""
        x = self._fractional_rows(t)
        first = np.minimum(x.astype(int), len(self.rows) - 2)
        before = self.rows[first]
        after = self.rows[first + 1]
        return before + (x - first)[:, None] * (after - before)


def impulse_rounding(impulse: np.ndarray, dt: float) -> float:
    """Return the rounding error [N] of the mean forces between impulses (n,) [N s].

    Each mean force is a sum over at most some tens of steps.
    """
    steps = 64
    return float(steps * np.spacing(np.abs(impulse).max()) / dt)


def _is_within(spans: np.ndarray, t: ArrayLike) -> np.ndarray:
    """Return a mask of the times t (k,) in the sorted, disjoint spans (n, 2)."""
    return np.searchsorted(spans[:, 0], t, "right") > np.searchsorted(
        spans[:, 1], t, "right"
    )


def solve_compliant_motion(
    plan: "MotionPlan",
    watch: Callable[[float, float, str], None],
    begin: tuple[np.ndarray, np.ndarray] | None = None,
    max_energy: float = np.inf,
) -> CompliantMotion:
    """Solve the full compliant motion of a plan from its release.

    Parameters
    ----------
    plan : MotionPlan
        Plan with an elastic contact that is solved in full.
    watch : callable
        Progress callback, as in `dynamics.simulate`.
    begin : tuple of (11,) and (3,) arrays, optional
        COLUMNS and force [N] at the start; default: those of the release.
    max_energy : float
        Largest total energy of disk, springs and table at the start [J].

    Returns
    -------
    CompliantMotion
        The solved motion.

    Raises
    ------
    ValueError
        If a profile cannot be read.
    ImpossibleContactError
        If the table bends by more than the radius of the disk, or if the energy is
        insufficient to bend it.
    """
    scene = plan.scene
    modes = plan.moving_modes
    if modes is not None:
        radius = scene.disk.radius
        sag = modes.compliance(radius) * scene.disk.weight
        if sag > radius:
            raise ImpossibleContactError(
                f"linear theory does not apply: the weight of the disk would bend the table by "
                f"{sag:.3g} m, more than the radius of the disk, {radius:g} m"
            )
    model = compliant_model(plan)
    final_inclination = (
        FLAT_INCLINATION
        if modes is not None or model.imperfection is not None
        else final_contact_inclination(plan.final_inclination)
    )
    if begin is None:
        tilt = np.radians(scene.release.inclination_deg)
        begin = (
            np.concatenate([[0.0, tilt, 0, 0, 0], scene.release.omega, [0, 0, 0]]),
            release_force(plan),
        )
    motion = simulate_from(
        plan,
        model,
        *begin,
        scene.numerics.time_limit,
        final_inclination,
        watch,
        max_energy,
    )
    may_repeat = scene.numerics.contact_rate is None and (
        plan.step_rate < MAX_REPEATED_STEP_RATE
    )
    if motion.rolling_outcome is Outcome.STALLED and may_repeat:
        shorter = replace(plan, step_rate=2 * plan.step_rate)
        return solve_compliant_motion(shorter, watch, begin, max_energy)
    return motion


def simulate_from(
    plan: "MotionPlan",
    model: CompliantModel,
    state: np.ndarray,
    force: np.ndarray,
    stop: float,
    final_inclination: float,
    watch: Callable[[float, float, str], None] = lambda t, inclination, doing: None,
    max_energy: float = np.inf,
) -> CompliantMotion:
    """Simulate a model of a plan from COLUMNS (11,) `state` and a force (3,) [N].

    The motion ends at the time `stop` [s] or at `final_inclination` [rad]. The total
    energy of disk, springs and table is at most `max_energy` [J] at the start. Raises
    ImpossibleContactError if the first step has no solution, or if the energy is
    insufficient to bend the table.
    """
    watch(0.0, float(state[1]), "loading or compiling the equations of the contact")
    steps_per_row = max(1, round(model.rate / FORCE_SAMPLE_RATE)) * FORCES_PER_ROW
    y = preloaded_compliant_state(model, state, force)
    dt = steps_per_row / FORCES_PER_ROW / model.rate
    row_duration = FORCES_PER_ROW * dt
    modes = model.supporting_modes(y)
    limit_energy(model, y, max_energy)
    stored = _stored_columns(model, y[None])
    impulse = np.zeros((1, 3))
    rows = RowStore(stored)
    impulses = RowStore(impulse)
    slides = RowStore(np.empty((0, 2)))
    losses = RowStore(np.empty((0, 3)))
    rises = RowStore(y[None, [STATE.velocity + 2, STATE.table_rise]])
    for piece in model.run(
        y,
        steps_per_row,
        max(stop, 2 * row_duration),
        final_inclination,
        FORCES_PER_ROW,
        modes,
    ):
        steps = np.vstack([0 * impulse[-1:], piece.force * dt])
        impulse = impulse[-1] + np.cumsum(steps, axis=0)
        stored = np.vstack([stored[-1:], _stored_columns(model, piece.state)])
        _unwrap_precession(stored, row_duration)
        rows.append(stored[1:])
        impulses.append(impulse[1:])
        slides.append(piece.slips)
        losses.append(piece.losses.array)
        rises.append(piece.state[:, [STATE.velocity + 2, STATE.table_rise]])
        if len(piece.t):
            watch(float(piece.t[-1]), float(inclination(y[None])[0]), "")
    written = rows.rows()
    if len(written) < 2:
        why = END_REASONS[piece.end_reason]
        if model.modes is not None:
            why = "the table bends so far that the disk touches it elsewhere"
        raise ImpossibleContactError(f"the first step cannot be solved: {why}")
    end = int(np.flatnonzero(written[:, 1] >= final_inclination)[-1])
    reason = piece.end_reason
    lift_off_speed = 0.0
    if model.film is not None:
        past = StoredMotion(
            row_duration,
            losses.rows(),
            impulses.rows()[::FORCES_PER_ROW, 2],
            rises.rows(),
        )
        end, reason = end_over_film(plan.scene.disk, past, end, reason)
        if reason == EndReason.IS_AIRBORNE:
            lift_off_speed = separation_speed(
                model, written[: end + 2][-1], past.rise[: end + 2][-1]
            )
    end = min(max(end, 1), len(written) - 1)
    motion = CompliantMotion(
        plan=plan,
        model=model,
        dt=dt,
        impulses=impulses.rows()[: FORCES_PER_ROW * end + 1],
        rows=written[: end + 1],
        slides=slides.rows(),
        contact_losses=losses_until(end * row_duration, losses.rows()),
        max_friction_excess=float(y[STATE.friction_excess]),
        rolling_outcome=OUTCOME_OF_END[reason],
        lift_off_speed=lift_off_speed,
    )
    if motion.rolling_outcome is Outcome.SETTLED:
        return replace(
            motion,
            rolling_outcome=outcome_when_flat(motion, motion.last_decade_precession),
        )
    return motion


class StoredMotion(NamedTuple):
    """What decides where a motion over a film of air ends.

    Attributes
    ----------
    row_duration : float
        Time [s] between rows.
    losses : ndarray, (k, 3)
        Losses of contact in their order, each with start [s], duration [s] and height [m].
    impulse : ndarray, (n,)
        Vertical impulse [N s] of the contact until each row.
    rise : ndarray, (n, 2)
        Upward velocities [m/s] of the centre of the disk and of the table below the contact.
    """

    row_duration: float
    losses: np.ndarray
    impulse: np.ndarray
    rise: np.ndarray


def end_over_film(
    disk: Disk, past: StoredMotion, row: int, reason: EndReason
) -> tuple[int, EndReason]:
    """Return the last row of a motion over a film, and the reason for its end.

    A disk that has left the table, or floats down with its low point at the table, ends where
    its contact is lost first after the film has begun to bear more than the contact for good.
    """
    begun = past.losses[:, 0]
    if reason == EndReason.IS_AIRBORNE:
        return int(begun[-1] / past.row_duration), reason
    if reason == EndReason.CONTINUES:  # the time limit, which may be reached in flight
        return row, reason
    before = last_row_before_flight(past.losses, past.row_duration, row)
    if reason != EndReason.LIES_FLAT:
        return before, reason
    if before < row:  # it becomes flat in flight
        return before, EndReason.IS_AIRBORNE
    contact = np.diff(past.impulse) / past.row_duration
    inertia = disk.mass * np.diff(past.rise[:, 0]) / past.row_duration
    lift = disk.weight + inertia - contact
    floats_from = row_since(lift[:row] > contact[:row]) * past.row_duration
    late = begun[(begun >= floats_from) & (begun < row * past.row_duration)]
    if not len(late):
        return row, reason
    return int(late[0] / past.row_duration), EndReason.IS_AIRBORNE


def row_since(holds: np.ndarray) -> int:
    """Return the row since which a condition (k,) holds until the end; k if it does not."""
    fails = np.flatnonzero(~holds)
    return int(fails[-1]) + 1 if len(fails) else 0


def last_row_before_flight(losses: np.ndarray, row_duration: float, row: int) -> int:
    """Return a row, or the last one before the loss of contact during which it is stored.

    `losses` (k, 3) are sorted, with start [s], duration [s] and height [m].
    """
    t = row * row_duration
    begun = losses[losses[:, 0] < t]
    if not len(begun) or t > begun[-1, 0] + begun[-1, 1]:
        return row
    return int(begun[-1, 0] / row_duration)


def separation_speed(model: CompliantModel, row: np.ndarray, rise: np.ndarray) -> float:
    """Return the vertical velocity [m/s] of the low point of the rim relative to the table,
    in a stored row (21,) in which centre and table rise by `rise` (2,) [m/s]."""
    place = model.tabulated_law.law.place(row[1])
    return float(rise[0] - place.f * row[5] - rise[1])


def losses_until(end: float, losses: np.ndarray) -> ContactLosses:
    """Return the losses of contact (k, 3) that begin before a time [s], cut off there.

    Each has its start [s], duration [s] and height [m]."""
    begun = losses[losses[:, 0] < end]
    begun[:, 1] = np.minimum(begun[:, 1], end - begun[:, 0])
    return ContactLosses(begun)


def compliant_model(plan: "MotionPlan") -> CompliantModel:
    """Return the model of a plan, coupled to the modes of its table if they move."""
    scene = plan.scene
    modes = plan.moving_modes
    dissipation = scene.dissipation
    disk = scene.disk
    bends = modes is not None  # the modes of the disk are coupled as well
    return CompliantModel(
        tabulated_law=replace(
            plan.series_tabulated_law,
            max_moving_frequency=MAX_MOVING_MODE_FREQUENCY * bends,
        ),
        friction=scene.friction,
        powers=tuple(power_laws(dissipation, disk)),
        viscous=(dissipation.viscous_moment, dissipation.viscous_force),
        profiles=profiles(scene.roughness, disk.radius),
        film=plan.film,
        friction_is_fitted=scene.roughness is not None
        and scene.roughness.loss == "fitted",
        modes=modes,
        disk_modes=moving_rim_modes(
            plan.series_tabulated_law.edge,
            scene.material.loss_factor,
        )
        if bends
        else NO_RIM_MODES,
        imperfection=scene.imperfection,
        bowl_curvature=scene.surface.curvature,
        bowl_place=scene.surface.place,
        rate=plan.step_rate,
    )


def _stored_columns(model: CompliantModel, y: np.ndarray) -> np.ndarray:
    """Return the stored columns (k, 21) of states y (k, STATE_SIZE).

    The precession is in (-pi, pi].
    """
    return motion_rows(
        columns(model, y),
        energy(model, y),
        y[:, ENERGY_LOSSES],
        y[:, STATE.table_mode_energy],
        y[:, STATE.disk_mode_energy],
    )


def _unwrap_precession(rows: np.ndarray, dt: float) -> None:
    """Make the precession continuous over rows (k, 21) that are dt [s] apart, in place."""
    rate = precession_rate(rows)
    step = np.diff(rows[:, 0])
    step -= 2 * np.pi * np.rint((step - (rate[1:] + rate[:-1]) / 2 * dt) / (2 * np.pi))
    rows[1:, 0] = rows[0, 0] + np.cumsum(step)
