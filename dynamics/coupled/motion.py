"""SCENE -> MOTION on an elastic contact: the record of a compliant motion, which answers as every `Motion` does."""

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from ..disk import Disk
from ..dissipation import power_laws
from ..film.acting import film_of
from ..film.law import Film
from ..motion import COLUMNS, Answers, Jumps, Outcome, Transition, read_only
from ..rates import precession_rate
from ..rigid_motion import HARMONICS
from ..switching import ImpossibleContactError
from .bending import MOVES, RIGID, bending_of
from .choice import first_force
from .contact import LEAST_INCLINATION
from .from_scene import acts_back, edge_of, last_inclination, law_table, step_rate
from .full import ENDS, Compliant, Losses
from .handover import columns, energy, inclination, release
from .march import CARRIED, FLAT, GOES, LIES, UNSOLVED, UPRIGHT
from .record import Record, between
from .resonance import mobility
from .roughness import profiles
from .state import BODY, CAUSES, EXCESS, LOSSES, SURFACE
from .table import InSeries

FORCES_A_SECOND, STATES = 1e5, 4
"""Mean forces that are kept a second, and how many of them for each state."""
OVERTONES = 2
"""Multiples of the resonance of the contact that the force is taken to hold: above, it has less than a hundredth."""
PARTS = 24
"""Means that make up a mean over half a turn."""
TURN = 0.25
"""The contact turns by so much [rad] in a piece of the motion, or less."""
OUTCOMES = {
    FLAT: Outcome.SETTLED,
    UPRIGHT: Outcome.UPRIGHT,
    UNSOLVED: Outcome.STALLED,
    GOES: Outcome.TIME_LIMIT,
    CARRIED: Outcome.AIRBORNE,
}
ENERGY, TABLE, DISK = len(COLUMNS), len(COLUMNS) + 1 + len(CAUSES), len(COLUMNS) + 2 + len(CAUSES)
LOST = slice(ENERGY + 1, TABLE)
"""Kept of a state besides COLUMNS: its energy, what was lost to each of CAUSES, the energies of the modes of table and
disk [J]."""


@dataclass(frozen=True, kw_only=True, eq=False)
class CompliantMotion(Answers):
    """A `Motion` as rows at even times: every `dt` [s] the impulse (n, 3) [N s] of the contact force since the start,
    and every STATES of them the COLUMNS, the energy and what was lost to each of CAUSES.

    Between rows the impulses and columns are polynomials, energies straight lines. `slides` (s, 2) and the losses of
    contact are intervals [s]; `excess` [N] is by how much friction ever exceeded its cone.
    """

    model: Compliant
    dt: float
    impulses: np.ndarray
    rows: np.ndarray
    slides: np.ndarray
    contact_losses: Losses
    excess: float
    outcome: Outcome

    def __repr__(self):
        """In one line."""
        lost = f"{len(self.contact_losses)} losses of contact"
        return f"Motion({self._end:.6g} s, {self.outcome.name}, {len(self.transitions)} transitions, {lost})"

    @property
    def disk(self) -> Disk:
        """The disk."""
        return self.model.table.law.disk

    @property
    def loads(self) -> Film | None:
        """The film of air that acts on it."""
        return self.model.film

    @property
    def integrator(self) -> str:
        """How it was solved."""
        return f"discrete gradient, {self.model.rate:.4g} steps/s"

    @property
    def _end(self) -> float:
        return (len(self.rows) - 1) * STATES * self.dt

    @cached_property
    def t(self) -> np.ndarray:
        """Ends of the pieces, (n,) [s]: the changes of regime, and instants between which the contact hardly turns."""
        turned = np.append(0.0, np.cumsum(np.abs(np.diff(self.rows[:, 0]))))
        nodes = np.unique(np.append(np.unique(turned // TURN, return_index=True)[1], len(turned) - 1))
        changes = [event.t for event in self.transitions]
        return read_only(np.unique(np.concatenate([nodes * (STATES * self.dt), changes])))

    def at(self, t) -> np.ndarray:
        """Return the state at the times t (k,) [s] as (k, 11): COLUMNS, in SI units; the frame of omega precesses.

        Raises ValueError for times outside the motion.
        """
        x = self._place(t)
        state = between(self.rows, x, False)[:, : len(COLUMNS)]
        state[:, -1] = self._line(x)[:, LOST].sum(axis=1)
        return state

    def force(self, t) -> np.ndarray:
        """Return the contact force at times t (k,) [s] as (k, 3) [N]: friction along a_1, a_2, and the normal force.

        It is the slope of the impulse that the steps gave, of which nothing is lost between rows; N is never negative.
        """
        force = between(self.impulses, self._place(t) * STATES, True) / self.dt
        force[:, 2] = np.maximum(force[:, 2], 0.0)
        return force

    def steady_load(self, t) -> np.ndarray:
        """Return the normal force (k,) [N] at t (k,) without the vibration of the contact: its mean over half a turn of
        the contact, weighed by Hann's window, which leaves nine tenths of a nutation."""
        turn = 2 * np.pi / np.maximum(np.abs(precession_rate(self.at(t))), np.pi / self._end)
        edges = np.asarray(t) + np.linspace(-0.25, 0.25, PARTS + 1)[:, None] * turn
        impulse = between(self.impulses, self._place(np.clip(edges, 0, self._end).ravel()) * STATES, False)[:, 2]
        lasts = np.diff(np.clip(edges, 0, self._end), axis=0)
        hann = np.sin(np.pi * (np.arange(PARTS) + 0.5) / PARTS)[:, None] ** 2
        return (hann * np.diff(impulse.reshape(edges.shape), axis=0)).sum(axis=0) / (hann * lasts).sum(axis=0)

    def carrier(self, inclination) -> np.ndarray:
        """Return the frequency (k,) [Hz] of the contact's normal resonance under the weight at inclinations (k,)."""
        springs, W = self.model.table.springs(inclination, self.disk.weight)[0], mobility(self.disk, inclination)
        return np.sqrt(springs.kn * W[:, 2, 2]) / (2 * np.pi)

    def bandwidth(self, state) -> np.ndarray:
        """Return the highest frequency (k,) [Hz] that the contact force is taken to hold at states (k, 11)."""
        turning = np.abs(precession_rate(state)) / (2 * np.pi)
        held = np.maximum(HARMONICS * turning, OVERTONES * self.carrier(np.maximum(state[:, 1], LEAST_INCLINATION)))
        return np.minimum(held, FORCES_A_SECOND / 2)

    def energy(self, t) -> np.ndarray:
        """Return kinetic, potential and elastic energy [J] at times t (k,) [s], zero at rest on the table."""
        return self._line(self._place(t))[:, ENERGY]

    def lost(self, t) -> np.ndarray:
        """Return what was lost to each of CAUSES until t (k,) [s], (k, 7) [J]."""
        return self._line(self._place(t))[:, LOST]

    def table_energy(self, t) -> np.ndarray:
        """Return the energy of the modes of the table at t (k,) [s], (k,) [J]: 0 of a table that does not act back."""
        return self._line(self._place(t))[:, TABLE]

    def bending_energy(self, t) -> np.ndarray:
        """Return the energy of the elastic modes of the disk at t (k,) [s], (k,) [J]: 0 of those that do not move."""
        return self._line(self._place(t))[:, DISK]

    def largest_regain(self) -> float:
        """Return by how much [J] the energy lost to any one cause ever falls, from any row to any later one."""
        lost = self.rows[:, LOST]
        return float((np.maximum.accumulate(lost, axis=0) - lost).max())

    def friction_excess(self) -> float:
        """Return by how much, over the weight, friction exceeded what its cone holds in any step."""
        return self.excess / self.disk.weight

    def regime(self, t) -> np.ndarray:
        """Return the name of the regime at the times t (k,) [s], an array of strings: roll, slide or flight."""
        self._place(t)
        return np.where(_within(self._flights, t), "flight", np.where(_within(self.slides, t), "slide", "roll"))

    @cached_property
    def transitions(self) -> tuple[Transition, ...]:
        """Every change of regime: 'lift-off' and 'impact', 'slip' and 'grip'."""
        t = np.concatenate([self._flights.T.ravel(), self.slides.T.ravel()])
        counts = np.repeat([len(self._flights), len(self.slides)], 2)
        order = np.argsort(t, kind="stable")
        order = order[(t[order] > 0) & (t[order] < self._end)]
        t, guards = t[order], np.repeat(["lift-off", "impact", "slip", "grip"], counts)[order]
        before, after = self.regime(np.nextafter(t, -1.0)), self.regime(t)
        changed = before != after
        columns = (column[changed].tolist() for column in (t, before, after, guards))
        return tuple(Transition(*change) for change in zip(*columns, strict=True))

    @cached_property
    def jumps(self) -> Jumps:
        """None: an elastic contact has no discontinuities of its force."""
        return Jumps(np.zeros(0), np.zeros((0, 3)), np.zeros((0, 3)))

    @cached_property
    def t_end(self) -> float:
        """The time [s] at which the inclination of a settled motion would be zero: its square root falls steadily."""
        decade = self._last_decade
        r, t = np.sqrt(self.rows[[decade, -1], 1]), np.array([decade, len(self.rows) - 1]) * STATES * self.dt
        if self.outcome is not Outcome.SETTLED or not r[0] > r[1]:
            return self._end
        return float(t[1] + r[1] * (t[1] - t[0]) / (r[0] - r[1]))

    @property
    def fell(self) -> bool:
        """Whether the disk came flat without turning: through the last decade of the inclination by less than 1 rad."""
        flat = self.outcome is Outcome.SETTLED
        return flat and abs(self.rows[-1, 0] - self.rows[self._last_decade, 0]) < 1

    @property
    def _last_decade(self) -> int:
        """The row after which the inclination stays below ten times its last."""
        above = np.flatnonzero(self.rows[:, 1] > 10 * self.rows[-1, 1])
        return int(above[-1]) if len(above) else 0

    @cached_property
    def _flights(self) -> np.ndarray:
        begin, duration, _ = self.contact_losses.array.T
        return np.column_stack([begin, begin + duration])

    def _place(self, t) -> np.ndarray:
        """Return where among the rows times t (k,) [s] lie. Raises ValueError for times outside the motion."""
        t = np.atleast_1d(np.asarray(t, dtype=float))
        if t.ndim > 1:
            raise ValueError(f"t must be a time or a row of times [s], not an array of shape {t.shape}")
        if t.size and not (t.min() >= 0 and t.max() <= self._end * (1 + 1e-14)):
            raise ValueError(f"t must lie within the motion, 0 to {self._end:.9g} s")
        return np.minimum(t / (STATES * self.dt), len(self.rows) - 1)

    def _line(self, x) -> np.ndarray:
        """Return rows (k, 21) at places x (k,) by straight lines, on which a balance between rows holds as at them."""
        first = np.minimum(x.astype(int), len(self.rows) - 2)
        return self.rows[first] + (x - first)[:, None] * (self.rows[first + 1] - self.rows[first])


def _within(spans, t):
    """Return whether times t (k,) lie in one of the spans (n, 2), which are in order and apart."""
    return np.searchsorted(spans[:, 0], t, "right") > np.searchsorted(spans[:, 1], t, "right")


def solve(
    scene,
    watch: Callable[[float, float, str], None] = lambda t, inclination, doing: None,
    surface_modes=None,
    begin=None,
) -> CompliantMotion:
    """Solve the full compliant motion of a scene from its release; `watch` is that of `dynamics.simulate`.

    `surface_modes` are those of a table that acts back; `begin` the COLUMNS (11,) and the force (3,) [N] from which it
    goes on, those of the release unless given. Raises ValueError where a profile cannot be read, or where such
    a table has no modes, and ImpossibleContactError where it bends by more than a disk is wide.
    """
    modes, radius = surface_modes if acts_back(scene) else None, scene.disk.radius
    if acts_back(scene) and modes is None:
        raise ValueError("surface.action = 'motion': simulate needs the surface_modes of the table")
    if modes is not None and (sag := modes.compliance(radius) * scene.disk.weight) > radius:
        raise ImpossibleContactError(
            f"the weight of the disk would bend the table by {sag:.3g} m, more than the radius of the disk, "
            f"{radius:g} m, and linear theory does not hold"
        )
    model = compliant(scene, modes)
    last = LIES if modes is not None or model.imperfection is not None else last_inclination(scene)
    if begin is None:
        tilt = np.radians(scene.release.inclination_deg)
        begin = np.concatenate([[0.0, tilt, 0, 0, 0], scene.release.omega, [0, 0, 0]]), first_force(scene)
    return followed(model, *begin, scene.numerics.time_limit, last, watch)


def followed(
    model: Compliant,
    state,
    force,
    stop: float,
    last: float,
    watch: Callable[[float, float, str], None] = lambda t, inclination, doing: None,
) -> CompliantMotion:
    """Follow a disk from the COLUMNS (11,) and the force (3,) [N] on, to the time `stop` [s] or an inclination [rad].

    Raises ImpossibleContactError where there is no first step.
    """
    every = max(1, round(model.rate / FORCES_A_SECOND)) * STATES
    y, dt = release(model, state, force), every / STATES / model.rate
    waves = model.waves(y)
    kept, given = _kept(model, y[None]), np.zeros((1, 3))
    rows, impulses, slides, losses = Record(kept), Record(given), Record(np.empty((0, 2))), Record(np.empty((0, 3)))
    for piece in model.run(y, every, max(stop, 2 * STATES * dt), last, STATES, waves):
        given = given[-1] + np.cumsum(np.vstack([0 * given[-1:], piece.force * dt]), axis=0)
        kept = _unwound(np.vstack([kept[-1:], _kept(model, piece.state)]), STATES * dt)
        rows.append(kept[1:])
        impulses.append(given[1:])
        slides.append(piece.slips)
        losses.append(piece.losses.array)
        if len(piece.t):
            watch(float(piece.t[-1]), float(inclination(y[None])[0]), "")
    written, flights = rows.rows(), losses.rows()
    if len(written) < 2:
        bent = "the table bends so far that the disk touches another wave of it than that on which it was let go"
        raise ImpossibleContactError(f"no first step: {ENDS[piece.why] if model.modes is None else bent}")
    end = np.flatnonzero(written[:, 1] >= last)[-1]
    if piece.why == CARRIED:  # it ends where the contact was lost
        end, flights = int(flights[-1, 0] / (STATES * dt)), flights[:-1]
    written = written[: max(end, 1) + 1]
    motion = CompliantMotion(
        model=model,
        dt=dt,
        impulses=impulses.rows()[: STATES * (len(written) - 1) + 1],
        rows=written,
        slides=slides.rows(),
        contact_losses=Losses(_before_flat(flights, written, STATES * dt, last)),
        excess=float(y[EXCESS]),
        outcome=OUTCOMES[piece.why],
    )
    return replace(motion, outcome=Outcome.FELL) if motion.fell else motion


def _before_flat(flights, rows, dt, last):
    """Return the flights (f, 3) that begin before the end of `rows`, dt apart, while the disk is above `last` [rad]."""
    row = (flights[:, 0] / dt).astype(int)
    return flights[(row < len(rows) - 1) & (rows[np.minimum(row, len(rows) - 1), 1] >= last)]


def compliant(scene, modes=None) -> Compliant:
    """Return the model of a scene, on a table that acts back by its modes where they are given."""
    dissipation, disk = getattr(scene, "dissipation", None), scene.disk
    bends = modes is not None  # the disk then does so by its modes
    return Compliant(
        table=law_table(scene, InSeries, moves=MOVES * bends),
        friction=scene.friction,
        powers=tuple(power_laws(dissipation, disk)) if dissipation else (),
        viscous=(dissipation.viscous_moment, dissipation.viscous_force) if dissipation else (0.0, 0.0),
        profiles=profiles(scene.roughness, disk.radius),
        film=film_of(scene).film,
        fitted=scene.roughness is not None and scene.roughness.loss == "fitted",
        modes=modes,
        bending=bending_of(edge_of(scene), scene.material.loss_factor) if bends else RIGID,
        imperfection=getattr(scene, "imperfection", None),
        rate=step_rate(scene),
    )


def _kept(model, y) -> np.ndarray:
    """Return what is kept of states y (k, SIZE), (k, 21); the precession is in (-pi, pi]."""
    lost = y[:, LOSSES : LOSSES + len(CAUSES)]
    return np.column_stack([columns(model, y), energy(model, y), lost, y[:, SURFACE], y[:, BODY]])


def _unwound(rows, dt) -> np.ndarray:
    """Return rows (k, 21), dt [s] apart, with the precession going on from the first of them at its rate."""
    rate = precession_rate(rows)
    step = np.diff(rows[:, 0])
    step -= 2 * np.pi * np.rint((step - (rate[1:] + rate[:-1]) / 2 * dt) / (2 * np.pi))
    rows[1:, 0] = rows[0, 0] + np.cumsum(step)
    return rows
