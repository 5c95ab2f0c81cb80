"""Findings on two-way coupling: energy of the table, losses of contact, and the earlier
halt.

Each finding is evaluated again for the end of the motion with half the time step and
with twice the contact stiffness; the largest difference is its margin. The loss of
contact is undecided if these reruns disagree."""

from collections.abc import Callable
from dataclasses import replace
from math import inf
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from dynamics import Motion, Outcome
from dynamics.compliant.compliant_motion import (
    FORCES_PER_ROW,
    CompliantMotion,
    simulate_from,
)
from dynamics.compliant.state_conversion import preloaded_compliant_state
from dynamics.compliant.stepping.state_layout import STATE
from dynamics.compliant.stepping.time_loop import FLAT_INCLINATION
from dynamics.observables import precession_rate
from dynamics.solver_settings import MIN_RELEVANT_SHARE
from sonify.claims.finding import Finding, Measured, finding
from sonify.claims.limits import ALMOST_FLAT_INCLINATION, FINAL_ENERGY_SHARE
from sonify.runtime.progress import Watch, ignore_progress
from sonify.scene import Scene

if TYPE_CHECKING:
    from dynamics.compliant.stepping.model import CompliantModel

HALF_STEP = "half_step"
"""Name of the rerun with half the time step."""
TWICE_STIFF = "twice_stiff"
"""Name of the rerun with twice the contact stiffness."""
FINDINGS_CHAOTIC_AFTER_LOSS = ("loss_at_resonance", "waves_make_the_halt")
"""Keys of findings that are chaotic once contact is lost: a change of the release by
1e-5 may change them."""


class EnergyBudget(NamedTuple):
    """Energies (k,) [J] at times t (k,) [s] after the release.

    `disk` is the energy of the disk, including that of its `bending` modes; `table` is
    the energy of the table modes. `lost` is the energy lost to each of CAUSES since the
    first of the times, and `sound` is the energy radiated by the table since then."""

    t: np.ndarray
    disk: np.ndarray
    bending: np.ndarray
    table: np.ndarray
    lost: dict[str, np.ndarray]
    sound: np.ndarray


def two_way_part(motion: Motion) -> Any:
    """Return the part of a motion with two-way coupling and its start [s]; None without
    such a part."""
    return next(
        ((part.motion, part.begin) for part in motion.parts if part.motion.moves_table),
        None,
    )


def energy_budget(
    motion: Motion, t: np.ndarray, heard: tuple[np.ndarray, np.ndarray] | None = None
) -> EnergyBudget:
    """Return the `EnergyBudget` at times t (k,) [s] with two-way coupling.

    `heard` is the result of `sonify.claims.table.radiated_power`: times (e,) [s] and
    power (e,) [W]. Without it, the sound is 0. Raises ValueError for a motion without
    two-way coupling."""
    found = two_way_part(motion)
    if found is None:
        raise ValueError("energy_budget: this motion has no two-way coupling")
    part, begin = found
    now = np.minimum(np.asarray(t, dtype=float) - begin, part.t[-1])
    table = part.table_energy(now)
    sound = np.zeros(len(now))
    if heard is not None:
        sound = np.interp(t, heard[0], np.cumsum(heard[1]) * np.gradient(heard[0]))
    causes = {cause: lost - lost[0] for cause, lost in part.energy_lost(now).items()}
    return EnergyBudget(
        t,
        part.energy(now) - table,
        part.disk_mode_energy(now),
        table,
        causes,
        sound - sound[0],
    )


def motion_findings(
    scene: Scene,
    motion: Motion,
    watch: Watch = ignore_progress,
) -> list[Finding]:
    """Return the findings on two-way coupling.

    The list is empty without two-way coupling if the disk rattles or did not come
    to rest. `watch` receives the completed share of the reruns.
    """
    found = two_way_part(motion)
    if "two-way" not in motion.finding_groups:
        return []
    if motion.rolling_outcome is Outcome.AIRBORNE and motion.plan.may_be_two_way:
        return [air_carries_earlier(scene, motion)]
    if found is None or not motion.rolling_outcome.lies_flat:
        return []
    others = variation_runs(scene, found[0], watch)
    judges = [
        halt_comes_earlier,
        waves_make_the_halt,
        table_rings_at_the_halt,
        disk_rings_at_the_halt,
    ]
    if losses_above_flat(motion):
        judges.append(loss_at_resonance)
    broken = table_breaks_contact(motion)
    if any(table_breaks_contact(one).holds != broken.holds for one in others.values()):
        broken = replace(broken, margin=max(broken.value, 1.0))
    runs = [motion, *others.values()]
    if any(losses_above_flat(one) for one in runs):
        judged = [broken, number_of_losses(motion, list(others.values()))]
    else:
        judged = [broken]
    return [
        *judged,
        *(with_variation_margin(judge, scene, motion, others) for judge in judges),
    ]


def variation_runs(
    scene: Scene,
    part: CompliantMotion,
    watch: Watch = ignore_progress,
) -> dict[str, CompliantMotion]:
    """Return reruns with half the time step and with twice the contact stiffness, by
    name.

    They start at the onset of two-way coupling. `watch` receives the completed share.
    """
    start = two_way_start(part)
    span = scene.numerics.time_limit - start
    state = part.at([start])[0]
    force = part.force([start])[0]
    models = {
        HALF_STEP: part.model.with_half_time_step(),
        TWICE_STIFF: part.model.with_double_stiffness(),
    }
    expected = part.t[-1] - start

    def rerun(number: int, model: "CompliantModel") -> CompliantMotion:
        def show(t: float, inclination: float, doing: str) -> None:
            watch((number + min(t / expected, 1.0)) / len(models))

        return simulate_from(
            part.plan, model, state, force, span, FLAT_INCLINATION, show
        )

    return {
        name: rerun(number, model)
        for number, (name, model) in enumerate(models.items())
    }


def with_variation_margin(
    judge: Callable[[Scene, Motion], Finding],
    scene: Scene,
    motion: Motion,
    others: dict[str, CompliantMotion],
) -> Finding:
    """Return the finding of `judge` with a margin that covers its values for the other
    motions."""
    found = judge(scene, motion)
    values = {name: judge(scene, other).value for name, other in others.items()}
    lost = any(losses_above_flat(one) for one in (motion, *others.values()))
    chaotic = lost and found.key in FINDINGS_CHAOTIC_AFTER_LOSS
    return replace(
        found,
        details={**found.details, **values},
        margin=max(found.margin, *(abs(v - found.value) for v in values.values())),
        undecided_because="chaotic" if chaotic else "",
    )


def two_way_start(part: CompliantMotion) -> float:
    """Return the time [s] within a motion at which the reaction of the table becomes
    significant.

    The criterion is that of `dynamics.compliant.two_way_onset`; the time is 0 if it is
    met from the start."""
    is_two_way = part.rows[:, 1] < part.plan.two_way.inclination
    return float(is_two_way.argmax() * FORCES_PER_ROW * part.dt)


@finding(needs=("scene", "motion"), at_least=0.05)
def halt_comes_earlier(scene: Scene, motion: Motion) -> Measured:
    """The time [s] by which the table modes advance the passage of FLAT_INCLINATION.

    The reference is the same disk and contact without table modes, from the onset of
    two-way coupling. The details include the advance at ten times this inclination. The
    margin is MIN_RELEVANT_SHARE, the energy share of the table at the onset, times the
    duration."""
    part, _ = two_way_part(motion)
    start = two_way_start(part)
    t, alone = motion_without_table_modes(scene, part)
    own_t = np.arange(len(part.rows)) * FORCES_PER_ROW * part.dt
    advance = [
        last_time_above(inclination, t, alone)
        - last_time_above(inclination, own_t, part.rows[:, 1])
        for inclination in (FLAT_INCLINATION, 10 * FLAT_INCLINATION)
    ]
    details = {"advance_at_100_urad": advance[1]}
    return Measured(advance[0], MIN_RELEVANT_SHARE * (t[-1] - start), details)


@finding(needs=("scene", "motion"), at_least=0.05)
def air_carries_earlier(scene: Scene, motion: Motion) -> Measured:
    """The time [s] by which the table modes advance the end of a disk that the air
    carries.

    The reference is the same disk and contact without table modes, from the onset of
    two-way coupling; without two-way coupling the value is 0."""
    found = two_way_part(motion)
    if found is None:
        return Measured(0.0, details={"acts_before_end": 0.0})
    part, _ = found
    t, _ = motion_without_table_modes(scene, part)
    details = {"acts_before_end": part.t[-1] - two_way_start(part)}
    return Measured(t[-1] - part.t[-1], part.dt * FORCES_PER_ROW, details)


def motion_without_table_modes(
    scene: Scene, part: CompliantMotion
) -> tuple[np.ndarray, np.ndarray]:
    """Return times (k,) [s] and inclinations (k,) [rad] of the motion without table
    modes.

    It starts at the onset of two-way coupling within `part`, with the same disk and
    contact."""
    start = two_way_start(part)
    alone = replace(part.model, modes=None)
    y = preloaded_compliant_state(alone, part.at([start])[0], part.force([start])[0])
    span = max(scene.numerics.time_limit - start, 1e-3)
    steps_per_row = 20
    pieces = list(alone.run(y, steps_per_row, span, FLAT_INCLINATION))
    sine = np.concatenate([piece.state[:, STATE.sin_inclination] for piece in pieces])
    t = np.concatenate([piece.t for piece in pieces])
    return start + t, np.arcsin(sine)


def last_time_above(limit: float, t: np.ndarray, inclination: np.ndarray) -> float:
    """Return the time [s] after which the inclinations (k,) [rad] at times t (k,) stay
    below `limit`."""
    above = np.flatnonzero(inclination >= limit)
    return float(t[min(above[-1] + 1, len(t) - 1)] if len(above) else t[0])


@finding(needs=("scene", "motion"), at_least=0.5)
def waves_make_the_halt(scene: Scene, motion: Motion) -> Measured:
    """The share of the table modes in the energy lost by the disk and its contact
    during the halt."""
    budget = final_energy_budget(scene, motion)
    taken = {name: lost[-1] for name, lost in budget.lost.items()}
    taken["table"] += budget.table[-1] - budget.table[0]
    whole = sum(taken.values())
    shares = {name: energy / whole for name, energy in taken.items()}
    return Measured(shares["table"], details=shares)


@finding(needs=("scene", "motion"), at_least=0.5)
def table_rings_at_the_halt(scene: Scene, motion: Motion) -> Measured:
    """The share of the table modes in the energy of disk and table at their maximum
    energy."""
    t = times_of_two_way_coupling(scene, motion)
    budget = energy_budget(motion, t)
    most = budget.table.argmax()
    share = budget.table[most] / (budget.table[most] + abs(budget.disk[most]))
    return Measured(share, details={"before_end": motion.t[-1] - t[most]})


@finding(needs=("scene", "motion"), at_least=0.1)
def disk_rings_at_the_halt(scene: Scene, motion: Motion) -> float:
    """The greatest energy of the elastic modes of the disk during the halt, relative to
    the total energy at its start."""
    budget = final_energy_budget(scene, motion)
    return budget.bending.max() / (budget.disk[0] + budget.table[0])


@finding(needs=("motion",), at_least=1.0)
def table_breaks_contact(
    motion: Motion, measured: Measured | None = None
) -> float | Measured:
    """The number of losses of contact above the inclination ALMOST_FLAT_INCLINATION.

    For a motion that is not repeated, `sonify.claims.loss_causes.table_vibration` gives
    the `measured` value."""
    return losses_above_flat(motion) if measured is None else measured


@finding(needs=("motion",), at_least=1.0)
def number_of_losses(motion: Motion, others: list[CompliantMotion]) -> Measured:
    """The number of losses of contact, which is chaotic unless it is 0."""
    number = losses_above_flat(motion)
    numbers = [losses_above_flat(other) for other in others]
    spread = max(abs(other - number) for other in numbers)
    details = dict(zip((HALF_STEP, TWICE_STIFF), numbers, strict=True))
    return Measured(number, spread, details, "chaotic" if number or spread else "")


def losses_above_flat(motion: Motion, since: float = -inf) -> int:
    """Return the number of losses of contact that begin above ALMOST_FLAT_INCLINATION,
    after a time [s]."""
    begins = [loss.t for loss in motion.contact_losses if loss.t >= since]
    if not begins:
        return 0
    return int((motion.at(begins)[:, 1] > ALMOST_FLAT_INCLINATION).sum())


@finding(needs=("scene", "motion"), at_least=0.8, at_most=1.2)
def loss_at_resonance(scene: Scene, motion: Motion) -> Measured:
    """The ratio n Omega/w at the first loss of contact for the table mode closest to
    resonance, or 0."""
    if not motion.contact_losses:
        return Measured(0.0)
    first = motion.contact_losses[0].t
    modes = two_way_part(motion)[0].model.modes
    before = np.linspace(max(first - 0.002, 0.0), first, 20)
    rate = np.abs(np.median(precession_rate(motion.at(before)))) / (2 * np.pi)
    x = (modes.order * rate / modes.frequency)[modes.order > 0]
    details = {
        "before_end": motion.t[-1] - first,
        "precession_frequency": rate,
        "number": len(motion.contact_losses),
    }
    return Measured(x[np.abs(x - 1).argmin()] if len(x) else 0.0, details=details)


def times_of_two_way_coupling(scene: Scene, motion: Motion) -> np.ndarray:
    """Return equally spaced times (k,) [s] from the onset of two-way coupling to
    the end."""
    time_count = 4000
    part, begin = two_way_part(motion)
    return np.linspace(begin + two_way_start(part), motion.t[-1], time_count)


def final_energy_budget(scene: Scene, motion: Motion) -> EnergyBudget:
    """Return the budget of the last FINAL_ENERGY_SHARE of the energy at the onset of
    two-way coupling."""
    budget = energy_budget(motion, times_of_two_way_coupling(scene, motion))
    whole = budget.disk + budget.table
    late = np.argmax(whole < FINAL_ENERGY_SHARE * whole[0])
    return energy_budget(motion, budget.t[late:])
