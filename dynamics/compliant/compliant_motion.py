"""Solution of a scene with an elastic contact, and the record that implements `Motion`."""

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from dynamics.compliant.law.hertz_mindlin import MIN_CONTACT_INCLINATION
from dynamics.compliant.law.linearised import mobility
from dynamics.compliant.law.roughness import profiles
from dynamics.compliant.law.tabulated import SeriesLawTable
from dynamics.compliant.model_inputs import (
    edge_flexibility,
    final_contact_inclination,
    is_two_way,
    law_table,
    step_rate,
)
from dynamics.compliant.model_selection import release_force
from dynamics.compliant.state_conversion import (
    columns,
    energy,
    inclination,
    limit_energy,
    released_state,
)
from dynamics.compliant.stepping.model import END_REASONS, CompliantModel, ContactLosses
from dynamics.compliant.stepping.rim_modes import (
    MAX_MOVING_FREQUENCY,
    NO_RIM_MODES,
    moving_rim_modes,
)
from dynamics.compliant.stepping.row_store import RowStore, interpolate_rows
from dynamics.compliant.stepping.state_layout import ENERGY_LOSSES, STATE
from dynamics.compliant.stepping.time_loop import FLAT_INCLINATION, EndReason
from dynamics.disk import Disk
from dynamics.dissipation import power_laws
from dynamics.film.activation import decide_film
from dynamics.film.wedge import Film
from dynamics.motion import CAUSES, COLUMNS, Jumps, MotionBase, Outcome, Transition, read_only
from dynamics.observables import precession_rate
from dynamics.rigid_motion import FORCE_HARMONICS
from dynamics.switching import ImpossibleContactError

FORCE_RATE = 1e5
"""Mean forces stored per second of motion."""
FORCES_PER_ROW = 4
"""Mean forces stored per row."""
MAX_OVERTONE = 2
"""Ratio of the bandwidth of the contact force to the contact resonance.

The force at higher frequencies is less than a hundredth.
"""
LOAD_WINDOW_PARTS = 24
"""Intervals in the mean of the force over half a turn."""
MAX_PIECE_TURN = 0.25
"""Largest precession in one piece of the motion [rad]."""
OUTCOME_OF_END = {
    EndReason.LIES_FLAT: Outcome.SETTLED,
    EndReason.STANDS_UPRIGHT: Outcome.UPRIGHT,
    EndReason.UNSOLVED: Outcome.STALLED,
    EndReason.CONTINUES: Outcome.TIME_LIMIT,
    EndReason.IS_AIRBORNE: Outcome.AIRBORNE,
}
"""Outcome of a motion for each reason of `step_motion`."""

# Columns of a row after COLUMNS.
ENERGY_COLUMN = len(COLUMNS)
"""Total energy [J]."""
TABLE_ENERGY_COLUMN = len(COLUMNS) + 1 + len(CAUSES)
"""Energy of the table modes [J]."""
DISK_ENERGY_COLUMN = len(COLUMNS) + 2 + len(CAUSES)
"""Energy of the disk modes [J]."""
LOSS_COLUMNS = slice(ENERGY_COLUMN + 1, TABLE_ENERGY_COLUMN)
"""Energy lost to each of CAUSES [J]."""


@dataclass(frozen=True, kw_only=True, eq=False)
class CompliantMotion(MotionBase):
    """A `Motion` as rows at equal time steps.

    Polynomials interpolate the impulses and the columns between rows, straight lines the energies.

    Attributes
    ----------
    model : CompliantModel
        Disk and contact.
    dt : float
        Time between two impulses [s].
    impulses : (n, 3) array
        Impulse of the contact force since the start [N s].
    rows : (r, 21) array
        COLUMNS, energies and losses; one row for every FORCES_PER_ROW impulses.
    slides : (s, 2) array
        Begin and end of each slip [s].
    contact_losses : ContactLosses
        Losses of contact.
    excess : float
        Largest excess of the friction over its cone [N].
    outcome : Outcome
        Outcome of the motion.
    """

    model: CompliantModel
    dt: float
    impulses: np.ndarray
    rows: np.ndarray
    slides: np.ndarray
    contact_losses: ContactLosses
    excess: float
    outcome: Outcome

    def __repr__(self):
        """Return a one-line summary."""
        lost = f"{len(self.contact_losses)} losses of contact"
        return f"Motion({self._end:.6g} s, {self.outcome.name}, {len(self.transitions)} transitions, {lost})"

    @property
    def disk(self) -> Disk:
        """The disk."""
        return self.model.table.law.disk

    @property
    def loads(self) -> Film | None:
        """The air film that acts on the disk."""
        return self.model.film

    @property
    def film(self) -> Film | None:
        """The air film that acts on the disk, or None."""
        return self.model.film

    @property
    def solves_contact(self) -> bool:
        """True: the vibration of the contact is solved."""
        return True

    @property
    def moves_table(self) -> bool:
        """True with two-way coupling to the modes of the table."""
        return self.model.modes is not None

    @property
    def integrator(self) -> str:
        """Name and rate of the time-stepping scheme."""
        return f"discrete gradient, {self.model.rate:.4g} steps/s"

    @property
    def _end(self) -> float:
        return (len(self.rows) - 1) * FORCES_PER_ROW * self.dt

    @cached_property
    def t(self) -> np.ndarray:
        """Ends of the pieces (n,) [s]: changes of regime, and instants between which the contact
        hardly turns.
        """
        turned = np.append(0.0, np.cumsum(np.abs(np.diff(self.rows[:, 0]))))
        nodes = np.unique(
            np.append(
                np.unique(turned // MAX_PIECE_TURN, return_index=True)[1],
                len(turned) - 1,
            )
        )
        changes = [event.t for event in self.transitions]
        return read_only(np.unique(np.concatenate([nodes * (FORCES_PER_ROW * self.dt), changes])))

    def at(self, t) -> np.ndarray:
        """Return the state (k, 11) at times t (k,) [s]: COLUMNS in SI units, omega in the
        precessing frame.

        Raises ValueError for times outside the motion.
        """
        x = self._row_positions(t)
        state = interpolate_rows(self.rows, x, False)[:, : len(COLUMNS)]
        state[:, -1] = self._interpolate_linearly(x)[:, LOSS_COLUMNS].sum(axis=1)
        return state

    def force(self, t) -> np.ndarray:
        """Return the contact force (k, 3) [N] at times t (k,) [s]: friction along a_1 and a_2,
        normal force.

        It is the derivative of the interpolated impulse, so its integral is exact. The normal force
        is never negative.
        """
        force = (
            interpolate_rows(self.impulses, self._row_positions(t) * FORCES_PER_ROW, True) / self.dt
        )
        force[:, 2] = np.maximum(force[:, 2], 0.0)
        return force

    def steady_load(self, t) -> np.ndarray:
        """Return the normal force (k,) [N] at t (k,) without the vibration of the contact.

        It is the mean over half a turn of the contact with a Hann window, which keeps nine tenths
        of a nutation.
        """
        turn = 2 * np.pi / np.maximum(np.abs(precession_rate(self.at(t))), np.pi / self._end)
        edges = np.asarray(t) + np.linspace(-0.25, 0.25, LOAD_WINDOW_PARTS + 1)[:, None] * turn
        impulse = interpolate_rows(
            self.impulses,
            self._row_positions(np.clip(edges, 0, self._end).ravel()) * FORCES_PER_ROW,
            False,
        )[:, 2]
        lasts = np.diff(np.clip(edges, 0, self._end), axis=0)
        hann = (
            np.sin(np.pi * (np.arange(LOAD_WINDOW_PARTS) + 0.5) / LOAD_WINDOW_PARTS)[:, None] ** 2
        )
        return (
            hann
            * np.diff(
                impulse.reshape(edges.shape),
                axis=0,
            )
        ).sum(axis=0) / (hann * lasts).sum(axis=0)

    def steady_nutation(self, t) -> np.ndarray:
        """Return omega_1 (k,) [rad/s] at t (k,) [s] without the vibration of the contact.

        It is the mean fall of the inclination over a sixteenth of a turn of the contact, which is
        far longer than a period of the contact resonance and far shorter than a nutation.
        """
        t = np.asarray(t, dtype=float)
        turn = 2 * np.pi / np.maximum(np.abs(precession_rate(self.at(t))), np.pi / self._end)
        before = np.maximum(t - turn / 32, 0.0)
        after = np.minimum(t + turn / 32, self._end)
        return (self.at(before)[:, 1] - self.at(after)[:, 1]) / (after - before)

    def carrier(self, inclination) -> np.ndarray:
        """Return the contact resonance (k,) [Hz] along the normal under the weight at inclinations
        (k,) [rad].
        """
        springs = self.model.table.springs(inclination, self.disk.weight)[0]
        W = mobility(self.disk, inclination)
        return np.sqrt(springs.kn * W[:, 2, 2]) / (2 * np.pi)

    def bandwidth(self, state) -> np.ndarray:
        """Return the highest frequency (k,) [Hz] of the contact force at states (k, 11)."""
        turning = np.abs(precession_rate(state)) / (2 * np.pi)
        held = np.maximum(
            FORCE_HARMONICS * turning,
            MAX_OVERTONE * self.carrier(np.maximum(state[:, 1], MIN_CONTACT_INCLINATION)),
        )
        return np.minimum(held, FORCE_RATE / 2)

    def energy(self, t) -> np.ndarray:
        """Return the total energy (k,) [J] at times t (k,) [s]; zero at rest on the table."""
        return self._interpolate_linearly(self._row_positions(t))[:, ENERGY_COLUMN]

    def lost(self, t) -> np.ndarray:
        """Return the energy (k, 7) [J] lost to each of CAUSES until t (k,) [s]."""
        return self._interpolate_linearly(self._row_positions(t))[:, LOSS_COLUMNS]

    def energy_lost(self, t) -> dict[str, np.ndarray]:
        """Return the energy (k,) [J] lost until the times t (k,) [s], by cause."""
        return dict(zip(CAUSES, self.lost(t).T, strict=True))

    def dissipation(self, t) -> dict[str, np.ndarray]:
        """Return the dissipated power (k,) [W] at t (k,) [s], by cause: the mean between two
        rows."""
        first = np.minimum(self._row_positions(t).astype(int), len(self.rows) - 2)
        power = (self.rows[first + 1, LOSS_COLUMNS] - self.rows[first, LOSS_COLUMNS]) / (
            FORCES_PER_ROW * self.dt
        )
        return dict(zip(CAUSES, power.T, strict=True))

    def table_energy(self, t) -> np.ndarray:
        """Return the energy (k,) [J] of the table modes at t (k,) [s]; 0 without two-way
        coupling."""
        return self._interpolate_linearly(self._row_positions(t))[:, TABLE_ENERGY_COLUMN]

    def bending_energy(self, t) -> np.ndarray:
        """Return the energy (k,) [J] of the moving disk modes at t (k,) [s]."""
        return self._interpolate_linearly(self._row_positions(t))[:, DISK_ENERGY_COLUMN]

    def largest_regain(self) -> float:
        """Return the largest decrease [J] of any energy loss between two rows."""
        lost = self.rows[:, LOSS_COLUMNS]
        return float((np.maximum.accumulate(lost, axis=0) - lost).max())

    def friction_excess(self) -> float:
        """Return the largest excess of the friction over its cone, divided by the weight."""
        return self.excess / self.disk.weight

    def regime(self, t) -> np.ndarray:
        """Return the name of the regime at times t (k,) [s]: roll, slide or flight."""
        self._row_positions(t)
        return np.where(
            _is_within(self._flights, t),
            "flight",
            np.where(_is_within(self.slides, t), "slide", "roll"),
        )

    @cached_property
    def transitions(self) -> tuple[Transition, ...]:
        """All changes of regime: 'lift-off' and 'impact', 'slip' and 'grip'."""
        t = np.concatenate([self._flights.T.ravel(), self.slides.T.ravel()])
        counts = np.repeat([len(self._flights), len(self.slides)], 2)
        order = np.argsort(t, kind="stable")
        order = order[(t[order] > 0) & (t[order] < self._end)]
        t = t[order]
        guards = np.repeat(["lift-off", "impact", "slip", "grip"], counts)[order]
        before = self.regime(np.nextafter(t, -1.0))
        after = self.regime(t)
        changed = before != after
        columns = (column[changed].tolist() for column in (t, before, after, guards))
        return tuple(Transition(*change) for change in zip(*columns, strict=True))

    @cached_property
    def jumps(self) -> Jumps:
        """No jumps: the force of an elastic contact is continuous."""
        return Jumps(np.zeros(0), np.zeros((0, 3)), np.zeros((0, 3)))

    @cached_property
    def t_end(self) -> float:
        """Time [s] at which the inclination reaches zero.

        It is extrapolated from the steady decrease of the square root of the inclination.
        """
        decade = self._last_decade
        r = np.sqrt(self.rows[[decade, -1], 1])
        t = np.array([decade, len(self.rows) - 1]) * FORCES_PER_ROW * self.dt
        if self.outcome is not Outcome.SETTLED or not r[0] > r[1]:
            return self._end
        return float(t[1] + r[1] * (t[1] - t[0]) / (r[0] - r[1]))

    @property
    def fell(self) -> bool:
        """True if the disk precessed by less than 1 rad in the last decade of its inclination."""
        flat = self.outcome is Outcome.SETTLED
        return flat and abs(self.rows[-1, 0] - self.rows[self._last_decade, 0]) < 1

    @property
    def _last_decade(self) -> int:
        """Row after which the inclination stays below ten times its final value."""
        above = np.flatnonzero(self.rows[:, 1] > 10 * self.rows[-1, 1])
        return int(above[-1]) if len(above) else 0

    @cached_property
    def _flights(self) -> np.ndarray:
        begin, duration, _ = self.contact_losses.array.T
        return np.column_stack([begin, begin + duration])

    def _row_positions(self, t) -> np.ndarray:
        """Return the positions of times t (k,) [s] among the rows. Raises ValueError for times
        outside the motion.
        """
        t = np.atleast_1d(np.asarray(t, dtype=float))
        if t.ndim > 1:
            raise ValueError(
                f"t must be a time or a row of times [s], not an array of shape {t.shape}"
            )
        if t.size and not (t.min() >= 0 and t.max() <= self._end * (1 + 1e-14)):
            raise ValueError(f"t must lie within the motion, 0 to {self._end:.9g} s")
        return np.minimum(t / (FORCES_PER_ROW * self.dt), len(self.rows) - 1)

    def _interpolate_linearly(self, x) -> np.ndarray:
        """Interpolate the rows (k, 21) linearly at positions x (k,), which keeps linear balances
        exact.
        """
        first = np.minimum(x.astype(int), len(self.rows) - 2)
        return self.rows[first] + (x - first)[:, None] * (self.rows[first + 1] - self.rows[first])


def _is_within(spans, t):
    """Return whether times t (k,) are in one of the spans (n, 2), which are sorted and disjoint."""
    return np.searchsorted(spans[:, 0], t, "right") > np.searchsorted(spans[:, 1], t, "right")


def solve_compliant_motion(
    scene,
    watch: Callable[[float, float, str], None] = lambda t, inclination, doing: None,
    surface_modes=None,
    begin=None,
    most_energy: float = np.inf,
) -> CompliantMotion:
    """Solve the full compliant motion of a scene from its release.

    Parameters
    ----------
    scene : MotionScene
        Scene with an elastic contact.
    watch : callable
        Progress callback, as in `dynamics.simulate`.
    surface_modes : modal.SurfaceModes, optional
        Modes of a table with two-way coupling.
    begin : tuple of (11,) and (3,) arrays, optional
        COLUMNS and force [N] at the start; default: those of the release.
    most_energy : float
        Largest total energy of disk, springs and table at the start [J].

    Returns
    -------
    CompliantMotion
        The solved motion.

    Raises
    ------
    ValueError
        If a profile cannot be read, or if a table with two-way coupling has no modes.
    ImpossibleContactError
        If the table bends by more than the radius of the disk, or if the energy does not suffice to
        bend it.
    """
    modes = surface_modes if is_two_way(scene) else None
    radius = scene.disk.radius
    if is_two_way(scene) and modes is None:
        raise ValueError("surface.action = 'motion': solve needs the surface_modes of the table")
    if modes is not None and (sag := modes.compliance(radius) * scene.disk.weight) > radius:
        raise ImpossibleContactError(
            f"the weight of the disk would bend the table by {sag:.3g} m, more than the radius of "
            f"the disk, "
            f"{radius:g} m, and linear theory does not hold"
        )
    model = compliant_model(scene, modes)
    last = (
        FLAT_INCLINATION
        if modes is not None or model.imperfection is not None
        else final_contact_inclination(scene)
    )
    if begin is None:
        tilt = np.radians(scene.release.inclination_deg)
        begin = (
            np.concatenate([[0.0, tilt, 0, 0, 0], scene.release.omega, [0, 0, 0]]),
            release_force(scene),
        )
    return simulate_from(model, *begin, scene.numerics.time_limit, last, watch, most_energy)


def simulate_from(
    model: CompliantModel,
    state,
    force,
    stop: float,
    last: float,
    watch: Callable[[float, float, str], None] = lambda t, inclination, doing: None,
    most_energy: float = np.inf,
) -> CompliantMotion:
    """Simulate a model from COLUMNS (11,) and a force (3,) [N] until a time [s] or an inclination
    [rad].

    The total energy of disk, springs and table is at most `most_energy` [J] at the start. Raises
    ImpossibleContactError if the first step has no solution, or if the energy does not suffice to
    bend the table.
    """
    watch(0.0, float(state[1]), "loading or compiling the equations of the contact")
    steps_per_row = max(1, round(model.rate / FORCE_RATE)) * FORCES_PER_ROW
    y = released_state(model, state, force)
    dt = steps_per_row / FORCES_PER_ROW / model.rate
    waves = model.waves(y)
    limit_energy(model, y, most_energy)
    stored = _stored_columns(model, y[None])
    impulse = np.zeros((1, 3))
    rows = RowStore(stored)
    impulses = RowStore(impulse)
    slides = RowStore(np.empty((0, 2)))
    losses = RowStore(np.empty((0, 3)))
    for piece in model.run(
        y,
        steps_per_row,
        max(stop, 2 * FORCES_PER_ROW * dt),
        last,
        FORCES_PER_ROW,
        waves,
    ):
        impulse = impulse[-1] + np.cumsum(np.vstack([0 * impulse[-1:], piece.force * dt]), axis=0)
        stored = _unwrap_precession(
            np.vstack([stored[-1:], _stored_columns(model, piece.state)]),
            FORCES_PER_ROW * dt,
        )
        rows.append(stored[1:])
        impulses.append(impulse[1:])
        slides.append(piece.slips)
        losses.append(piece.losses.array)
        if len(piece.t):
            watch(float(piece.t[-1]), float(inclination(y[None])[0]), "")
    written = rows.rows()
    flights = losses.rows()
    if len(written) < 2:
        bent = "the table bends so far that the disk touches another wave than the one under its release"
        raise ImpossibleContactError(
            f"no first step: {END_REASONS[piece.why] if model.modes is None else bent}"
        )
    end = np.flatnonzero(written[:, 1] >= last)[-1]
    if piece.why == EndReason.IS_AIRBORNE:  # the motion ends where contact was lost
        end = int(flights[-1, 0] / (FORCES_PER_ROW * dt))
        flights = flights[:-1]
    written = written[: max(end, 1) + 1]
    motion = CompliantMotion(
        model=model,
        dt=dt,
        impulses=impulses.rows()[: FORCES_PER_ROW * (len(written) - 1) + 1],
        rows=written,
        slides=slides.rows(),
        contact_losses=ContactLosses(
            flights[flights[:, 0] < (len(written) - 1) * FORCES_PER_ROW * dt]
        ),
        excess=float(y[STATE.friction_excess]),
        outcome=OUTCOME_OF_END[piece.why],
    )
    return replace(motion, outcome=Outcome.FELL) if motion.fell else motion


def compliant_model(scene, modes=None) -> CompliantModel:
    """Return the model of a scene, with two-way coupling to the modes of its table if given."""
    dissipation = scene.dissipation
    disk = scene.disk
    bends = modes is not None  # the modes of the disk then move
    return CompliantModel(
        table=law_table(scene, SeriesLawTable, moves=MAX_MOVING_FREQUENCY * bends),
        friction=scene.friction,
        powers=tuple(power_laws(dissipation, disk)),
        viscous=(dissipation.viscous_moment, dissipation.viscous_force),
        profiles=profiles(scene.roughness, disk.radius),
        film=decide_film(scene).film,
        fitted=scene.roughness is not None and scene.roughness.loss == "fitted",
        modes=modes,
        bending=moving_rim_modes(
            edge_flexibility(scene),
            scene.material.loss_factor,
        )
        if bends
        else NO_RIM_MODES,
        imperfection=scene.imperfection,
        rate=step_rate(scene),
    )


def _stored_columns(model, y) -> np.ndarray:
    """Return the stored columns (k, 21) of states y (k, STATE_SIZE); the precession is in (-pi,
    pi].
    """
    lost = y[:, ENERGY_LOSSES]
    return np.column_stack(
        [
            columns(model, y),
            energy(model, y),
            lost,
            y[:, STATE.table_mode_energy],
            y[:, STATE.disk_mode_energy],
        ]
    )


def _unwrap_precession(rows, dt) -> np.ndarray:
    """Make the precession of rows (k, 21), dt [s] apart, continuous from the first row."""
    rate = precession_rate(rows)
    step = np.diff(rows[:, 0])
    step -= 2 * np.pi * np.rint((step - (rate[1:] + rate[:-1]) / 2 * dt) / (2 * np.pi))
    rows[1:, 0] = rows[0, 0] + np.cumsum(step)
    return rows
