"""TWO-WAY COUPLING: energy taken by the table, losses of contact, and the earlier halt.

Each finding is repeated for the end of the motion with half the time step and with twice the
contact stiffness; the largest difference is its margin. The loss of contact is undecided if these
reruns disagree on it.
"""

from collections.abc import Callable
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from dynamics import Motion
from dynamics.compliant.compliant_motion import FORCES_PER_ROW, CompliantMotion, simulate_from
from dynamics.compliant.state_conversion import released_state
from dynamics.compliant.stepping.time_loop import FLAT_INCLINATION, STATE
from dynamics.compliant.two_way_onset import table_reaction
from dynamics.observables import precession_rate
from dynamics.surface import MIN_TWO_WAY_SHARE
from sonify.claims.finding import Finding, Measured, finding
from sonify.scene import Scene

ALMOST_FLAT_INCLINATION = 2 * FLAT_INCLINATION
"""Inclination [rad] below which losses of contact depend on the time step and are not counted."""
LAST_ENERGY_SHARE = 0.1
"""Remaining share of the energy at which the halt begins."""
LEFT_AT_TWO_WAY_START = "that was left when the table began to act back"
HALF_STEP = "half_step"
"""Name of the rerun with half the time step."""
TWICE_STIFF = "twice_stiff"
"""Name of the rerun with twice the contact stiffness."""
STEPS_PER_ROW = 20
"""Time steps between the stored rows of the reference motion."""
RESONANCE_WIDTH = 0.2
"""Largest distance of n Omega/w from 1 at which a loss of contact counts as resonant."""


class EnergyBudget(NamedTuple):
    """Energies (k,) [J] at times t (k,) [s] after the release.

    `disk` is the energy of the disk and includes that of its `bending` modes; `table` is the energy
    of the table modes. `lost` is the energy lost to each of CAUSES since the first of the times.
    `sound` is the part of the loss in the table that is radiated.
    """

    t: np.ndarray
    disk: np.ndarray
    bending: np.ndarray
    table: np.ndarray
    lost: dict[str, np.ndarray]
    sound: np.ndarray


def two_way_part(motion: Motion):
    """Return the part of a motion with two-way coupling and its start [s], or None."""
    return next(
        ((part.motion, part.begin) for part in motion.parts if part.motion.moves_table), None
    )


def energy_budget(motion: Motion, t, heard=None) -> EnergyBudget:
    """Return the `EnergyBudget` at times t (k,) [s] with two-way coupling.

    `heard` is the result of `sonify.claims.table.radiated_power`: times (e,) [s] and power (e,)
    [W]. Without it, the sound is 0. Raises ValueError for a motion without two-way coupling.
    """
    found = two_way_part(motion)
    if found is None:
        raise ValueError("energy_budget: the table of this motion does not act back")
    part, begin = found
    now = np.minimum(np.asarray(t, dtype=float) - begin, part.t[-1])
    table = part.table_energy(now)
    sound = np.zeros(len(now))
    if heard is not None:
        sound = np.interp(t, heard[0], np.cumsum(heard[1]) * np.gradient(heard[0]))
    causes = {cause: lost - lost[0] for cause, lost in part.energy_lost(now).items()}
    return EnergyBudget(
        t, part.energy(now) - table, part.bending_energy(now), table, causes, sound - sound[0]
    )


def motion_findings(scene: Scene, motion: Motion) -> list[Finding]:
    """Return the findings on two-way coupling; empty without it or if the disk did not come to
    rest.
    """
    found = two_way_part(motion)
    if found is None or motion.outcome.name not in ("SETTLED", "FELL"):
        return []
    others = variation_runs(scene, found[0])
    judges = [
        halt_comes_earlier,
        waves_make_the_halt,
        table_rings_at_the_halt,
        disk_rings_at_the_halt,
    ]
    judges += [loss_at_resonance] if losses_above_flat(motion) else []
    broken = table_breaks_contact(motion)
    agree = all(table_breaks_contact(other).holds == broken.holds for other in others.values())
    broken = broken if agree else replace(broken, margin=max(broken.value, 1.0))
    count = number_of_losses(motion, list(others.values()))
    return [
        broken,
        count,
        *(with_variation_margin(judge, scene, motion, others) for judge in judges),
    ]


def variation_runs(scene: Scene, part: CompliantMotion) -> dict[str, CompliantMotion]:
    """Return the motion from the onset of two-way coupling with half the time step, and with twice
    the contact stiffness.
    """
    start = two_way_start(scene, part)
    span = scene.numerics.time_limit - start
    state = part.at([start])[0]
    force = part.force([start])[0]
    models = {
        HALF_STEP: part.model.with_half_time_step(),
        TWICE_STIFF: part.model.with_double_stiffness(),
    }
    return {
        name: simulate_from(model, state, force, span, FLAT_INCLINATION)
        for name, model in models.items()
    }


def with_variation_margin(
    judge: Callable[[Scene, Motion], Finding],
    scene: Scene,
    motion: Motion,
    others: dict[str, CompliantMotion],
) -> Finding:
    """Return the finding of `judge`, with a margin that covers its values for the other motions."""
    found = judge(scene, motion)
    values = {name: judge(scene, other).value for name, other in others.items()}
    margin = max([found.margin, *(abs(value - found.value) for value in values.values())])
    return replace(found, details={**found.details, **values}, margin=margin)


def two_way_start(scene: Scene, part: CompliantMotion) -> float:
    """Return the time [s] within a motion at which the reaction of the table begins to matter.

    The criterion is that of `dynamics.compliant.two_way_onset`. The time is 0 if the reaction
    matters from the start.
    """
    acts = part.rows[:, 1] < table_reaction(scene, part.model.modes).inclination
    return float(acts.argmax() * FORCES_PER_ROW * part.dt)


@finding(
    "The table brings the halt forward",
    f"s earlier at {FLAT_INCLINATION:g} rad than on a table that does not act back",
    "section 8: the vibrations will result in an abrupt halt",
    needs=("scene", "motion"),
    at_least=0.05,
)
def halt_comes_earlier(scene: Scene, motion: Motion):
    """The time [s] by which the table modes bring forward the inclination FLAT_INCLINATION.

    The reference is the same disk and contact without table modes, from the onset of two-way
    coupling. The advance at ten times this inclination is among the details. The margin is the
    share ACTS of its duration: the share of the energy that the table holds at the onset.
    """
    part, _ = two_way_part(motion)
    start = two_way_start(scene, part)
    alone = replace(part.model, modes=None)
    y = released_state(alone, part.at([start])[0], part.force([start])[0])
    span = max(scene.numerics.time_limit - start, 1e-3)
    pieces = list(alone.run(y, STEPS_PER_ROW, span, FLAT_INCLINATION))
    sine = np.concatenate([piece.state[:, STATE.sin_inclination] for piece in pieces])
    t = np.concatenate([piece.t for piece in pieces])
    own_t = np.arange(len(part.rows)) * FORCES_PER_ROW * part.dt
    advance = [
        start
        + last_time_above(inclination, t, np.arcsin(sine))
        - last_time_above(inclination, own_t, part.rows[:, 1])
        for inclination in (FLAT_INCLINATION, 10 * FLAT_INCLINATION)
    ]
    details = {"advance_at_100_urad": float(advance[1])}
    return Measured(advance[0], MIN_TWO_WAY_SHARE * t[-1], details)


def last_time_above(least: float, t: np.ndarray, inclination: np.ndarray) -> float:
    """Return the time [s] after which inclinations (k,) [rad] at times t (k,) stay below `least`."""
    above = np.flatnonzero(inclination >= least)
    return float(t[min(above[-1] + 1, len(t) - 1)] if len(above) else t[0])


@finding(
    "The waves of the table, and not impacts or friction, take the last energy",
    f"of the last {LAST_ENERGY_SHARE:.0%} of the energy {LEFT_AT_TWO_WAY_START}",
    "section 8: contact that is lost and regained ends the motion",
    needs=("scene", "motion"),
    at_least=0.5,
)
def waves_make_the_halt(scene: Scene, motion: Motion):
    """The share of the table modes in the energy that the disk and its contact lose during the
    halt.
    """
    budget = final_energy_budget(scene, motion)
    shares = {name: lost[-1] for name, lost in budget.lost.items()}
    shares["table"] += budget.table[-1] - budget.table[0]
    whole = sum(shares.values())
    return Measured(
        shares["table"] / whole, details={name: share / whole for name, share in shares.items()}
    )


@finding(
    "The table at last holds more energy than the disk",
    "of the energy of both",
    "abstract: the vibrations of disk and surface",
    needs=("scene", "motion"),
    at_least=0.5,
)
def table_rings_at_the_halt(scene: Scene, motion: Motion):
    """The share of the table modes in the energy of disk and table, when they hold the most."""
    t = times_towards_end(scene, motion)
    budget = energy_budget(motion, t)
    most = budget.table.argmax()
    share = budget.table[most] / (budget.table[most] + abs(budget.disk[most]))
    return Measured(share, details={"before_end": motion.t[-1] - t[most]})


@finding(
    "The vibrations of the disk, and not those of the table alone, have a part in the halt",
    f"of the last {LAST_ENERGY_SHARE:.0%} of the energy {LEFT_AT_TWO_WAY_START} is the most that "
    "its elastic modes hold",
    "abstract: the vibrations of disk and surface",
    needs=("scene", "motion"),
    at_least=0.1,
)
def disk_rings_at_the_halt(scene: Scene, motion: Motion):
    """The greatest energy of the elastic modes of the disk during the halt, over the total initial
    energy of the halt.
    """
    budget = final_energy_budget(scene, motion)
    return budget.bending.max() / (budget.disk[0] + budget.table[0])


@finding(
    "A table that acts back breaks the contact",
    f"losses of contact above {ALMOST_FLAT_INCLINATION:g} rad; whether any occurs is checked with half the "
    f"time step and twice "
    "the contact stiffness",
    "abstract: the vibrations will result in a loss of contact",
    needs=("motion",),
    at_least=1.0,
)
def table_breaks_contact(motion: Motion):
    """The number of losses of contact above the inclination ALMOST_FLAT_INCLINATION."""
    return losses_above_flat(motion)


@finding(
    "The contact is lost a definite number of times",
    f"losses of contact above {ALMOST_FLAT_INCLINATION:g} rad",
    "the same motion with half the time step and with twice the contact stiffness",
    needs=("motion",),
    at_least=1.0,
)
def number_of_losses(motion: Motion, others: list[CompliantMotion]):
    """The number of losses of contact; chaotic if another time step or stiffness changes it."""
    number = losses_above_flat(motion)
    numbers = [losses_above_flat(other) for other in others]
    spread = max(abs(other - number) for other in numbers)
    details = dict(zip((HALF_STEP, TWICE_STIFF), numbers, strict=True))
    return Measured(number, spread, details, "chaotic" if spread else "")


def losses_above_flat(motion: Motion) -> int:
    """Return the number of losses of contact that begin above the inclination ALMOST_FLAT_INCLINATION."""
    begins = [loss.t for loss in motion.contact_losses]
    return int((motion.at(begins)[:, 1] > ALMOST_FLAT_INCLINATION).sum()) if begins else 0


@finding(
    "Contact is first lost where its precession passes the waves of a mode",
    "n times the precession over the frequency of the nearest mode",
    "section 8: the vibrations will result in a loss of contact",
    needs=("scene", "motion"),
    at_least=1 - RESONANCE_WIDTH,
    at_most=1 + RESONANCE_WIDTH,
)
def loss_at_resonance(scene: Scene, motion: Motion):
    """n Omega/w at the first loss of contact, for the table mode closest to resonance; 0 without a
    loss.
    """
    if not motion.contact_losses:
        return Measured(0.0)
    first = motion.contact_losses[0].t
    modes = two_way_part(motion)[0].model.modes
    around = np.linspace(max(first - 0.002, 0.0), first, 20)
    rate = np.abs(np.median(precession_rate(motion.at(around)))) / (2 * np.pi)
    x = (modes.order * rate / modes.frequency)[modes.order > 0]
    details = {
        "before_end": motion.t[-1] - first,
        "precession_frequency": rate,
        "number": len(motion.contact_losses),
    }
    return Measured(x[np.abs(x - 1).argmin()] if len(x) else 0.0, details=details)


def times_towards_end(scene, motion, count=4000):
    part, begin = two_way_part(motion)
    return np.linspace(begin + two_way_start(scene, part), motion.t[-1], count)


def final_energy_budget(scene, motion) -> EnergyBudget:
    """Return the budget from the instant when the share LAST_ENERGY_SHARE of the energy at the onset of two-way
    coupling remains.
    """
    budget = energy_budget(motion, times_towards_end(scene, motion))
    whole = budget.disk + budget.table
    return energy_budget(motion, budget.t[np.argmax(whole < LAST_ENERGY_SHARE * whole[0]) :])
