"""TWO WAYS: what a table that acts back takes, where it breaks the contact, and how much earlier
the disk lies flat.

Each finding is judged again on the end of the motion in steps of half the length, and on a contact
twice as stiff: what it differs by is its margin. Whether contact is lost is uncertain where they do
not agree."""

from collections.abc import Callable
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from dynamics import Motion
from dynamics.compliant.compliant_motion import FORCES_PER_ROW, CompliantMotion, simulate_from
from dynamics.compliant.state_conversion import released_state
from dynamics.compliant.stepping.time_loop import FLAT_INCLINATION
from dynamics.compliant.two_way_onset import table_reaction
from dynamics.observables import precession_rate
from dynamics.surface import ACTS
from sonify.claims.finding import Finding, Measured, finding
from sonify.scene import Scene

ALL_BUT_FLAT = 2 * FLAT_INCLINATION
"""An inclination [rad] below which a disk touches and leaves a table that waves with one step and
not with another."""
LAST = 0.1
"""The part of the energy at which the halt begins."""
LEFT = "that was left when the table began to act back"
HALF_STEP, TWICE_STIFF = "half_step", "twice_stiff"
"""Names of the reruns with half the time step and with twice the contact stiffness."""
EVERY = 20
"""Steps between rows of a motion of which only the end is looked at."""
NEAR = 0.2
"""A loss of contact is at the resonance of a mode where n Omega/w is as near to 1."""


class Budget(NamedTuple):
    """Energy [J] at times t (k,) [s] of the whole motion: of the disk, a part of that in its
    `bending` modes, and of the modes of the table; what was lost since the first of the times to
    each of CAUSES, and what part of the loss in the table went off as `sound`; every row (k,)."""

    t: np.ndarray
    disk: np.ndarray
    bending: np.ndarray
    table: np.ndarray
    lost: dict[str, np.ndarray]
    sound: np.ndarray


def two_way(motion: Motion):
    """Return the part of a motion in which the table acts back, and when it begins [s]; None where
    it never does."""
    return next(
        ((part.motion, part.begin) for part in motion.parts if part.motion.moves_table), None
    )


def energy_budget(motion: Motion, t, heard=None) -> Budget:
    """Return the `Budget` at times t (k,) [s] at which the table acts back; without what is `heard`
    of the table, times (e,) [s] and power [W], as `sonify.claims.table.radiated_power` has it, its
    sound is 0. Raises ValueError at others."""
    found = two_way(motion)
    if found is None:
        raise ValueError("energy_budget: the table of this motion does not act back")
    part, begin = found
    now = np.minimum(np.asarray(t, dtype=float) - begin, part.t[-1])
    table = part.table_energy(now)
    sound = np.zeros(len(now))
    if heard is not None:
        sound = np.interp(t, heard[0], np.cumsum(heard[1]) * np.gradient(heard[0]))
    causes = {cause: lost - lost[0] for cause, lost in part.energy_lost(now).items()}
    return Budget(
        t, part.energy(now) - table, part.bending_energy(now), table, causes, sound - sound[0]
    )


def motion_findings(scene: Scene, motion: Motion) -> list[Finding]:
    """Return every claim on a table that acts back; none where it does not, or no end was
    reached."""
    found = two_way(motion)
    if found is None or motion.outcome.name not in ("SETTLED", "FELL"):
        return []
    others = reruns(scene, found[0])
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
    return [broken, count, *(varied(judge, scene, motion, others) for judge in judges)]


def reruns(scene: Scene, part: CompliantMotion) -> dict[str, CompliantMotion]:
    """Return the motion, from where the table begins to act back, with half the step and twice the
    stiffness."""
    start = begins(scene, part)
    span = scene.numerics.time_limit - start
    state = part.at([start])[0]
    force = part.force([start])[0]
    models = {HALF_STEP: part.model.finer(), TWICE_STIFF: part.model.stiffer()}
    return {
        name: simulate_from(model, state, force, span, FLAT_INCLINATION)
        for name, model in models.items()
    }


def varied(
    judge: Callable[[Scene, Motion], Finding],
    scene: Scene,
    motion: Motion,
    others: dict[str, CompliantMotion],
) -> Finding:
    """Return what `judge` finds, with a margin that reaches what it finds for the other motions."""
    found = judge(scene, motion)
    values = {name: judge(scene, other).value for name, other in others.items()}
    margin = max([found.margin, *(abs(value - found.value) for value in values.values())])
    return replace(found, details={**found.details, **values}, margin=margin)


def begins(scene: Scene, part: CompliantMotion) -> float:
    """Return when [s] in a motion on a table its modes begin to act back,
    `dynamics.compliant.two_way_onset`; 0 if before it."""
    acts = part.rows[:, 1] < table_reaction(scene, part.model.modes).inclination
    return float(acts.argmax() * FORCES_PER_ROW * part.dt)


@finding(
    "The table brings the halt forward",
    "s earlier than on a table that does not act back",
    "section 8: the vibrations will result in an abrupt halt",
    needs=("scene", "motion"),
    at_least=0.05,
)
def halt_comes_earlier(scene: Scene, motion: Motion):
    """By how much earlier [s] the disk lies flat than the same disk, on the same contact, on a
    table without modes.

    That one goes on from where the table begins to act back, and holds ACTS of the energy.
    """
    part, _ = two_way(motion)
    start = begins(scene, part)
    alone = replace(part.model, modes=None)
    below = max(part.rows[-1, 1], FLAT_INCLINATION)
    y = released_state(alone, part.at([start])[0], part.force([start])[0])
    *_, last = alone.run(y, EVERY, max(scene.numerics.time_limit - start, 1e-3), below)
    return Measured(start + last.t[-1] - part.t[-1], ACTS * last.t[-1])


@finding(
    "The waves of the table, and not impacts or friction, take the last energy",
    f"of the last {LAST:.0%} of the energy {LEFT}",
    "section 8: contact that is lost and regained ends the motion",
    needs=("scene", "motion"),
    at_least=0.5,
)
def waves_make_the_halt(scene: Scene, motion: Motion):
    """The share of the modes of the table in what the disk and its contact lose in the last LAST of
    the energy."""
    budget = _last(scene, motion)
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
    """The share of the modes of the table in the energy of disk and table, when they hold most."""
    t = _times(scene, motion)
    budget = energy_budget(motion, t)
    most = budget.table.argmax()
    share = budget.table[most] / (budget.table[most] + abs(budget.disk[most]))
    return Measured(share, details={"before_end": motion.t[-1] - t[most]})


@finding(
    "The vibrations of the disk, and not those of the table alone, have a part in the halt",
    f"of the last {LAST:.0%} of the energy {LEFT} is the most that its elastic modes hold",
    "abstract: the vibrations of disk and surface",
    needs=("scene", "motion"),
    at_least=0.1,
)
def disk_rings_at_the_halt(scene: Scene, motion: Motion):
    """The greatest energy of the elastic modes of the disk over that with which the last LAST of
    the energy begins."""
    budget = _last(scene, motion)
    return budget.bending.max() / (budget.disk[0] + budget.table[0])


@finding(
    "A table that acts back breaks the contact",
    f"losses of contact above {ALL_BUT_FLAT:g} rad; whether any occurs is checked with half the "
    f"time step and twice "
    "the contact stiffness",
    "abstract: the vibrations will result in a loss of contact",
    needs=("motion",),
    at_least=1.0,
)
def table_breaks_contact(motion: Motion):
    """The number of losses of contact of a disk that does not lie all but flat."""
    return losses_above_flat(motion)


@finding(
    "The contact is lost a definite number of times",
    f"losses of contact above {ALL_BUT_FLAT:g} rad",
    "the same motion with half the time step and with twice the contact stiffness",
    needs=("motion",),
    at_least=1.0,
)
def number_of_losses(motion: Motion, others: list[CompliantMotion]):
    """The number of losses of contact; chaotic if another step or stiffness changes it."""
    number = losses_above_flat(motion)
    numbers = [losses_above_flat(other) for other in others]
    spread = max(abs(other - number) for other in numbers)
    details = dict(zip((HALF_STEP, TWICE_STIFF), numbers, strict=True))
    return Measured(number, spread, details, "chaotic" if spread else "")


def losses_above_flat(motion: Motion) -> int:
    """Return the number of losses of contact that begin above the inclination ALL_BUT_FLAT."""
    begins = [loss.t for loss in motion.contact_losses]
    return int((motion.at(begins)[:, 1] > ALL_BUT_FLAT).sum()) if begins else 0


@finding(
    "Contact is first lost where its precession passes the waves of a mode",
    "n times the precession over the frequency of the nearest mode",
    "section 8: the vibrations will result in a loss of contact",
    needs=("scene", "motion"),
    at_least=1 - NEAR,
    at_most=1 + NEAR,
)
def loss_at_resonance(scene: Scene, motion: Motion):
    """n Omega/w at the first loss of contact, of the mode of the table that is nearest to 1 there;
    0 without a loss."""
    if not motion.contact_losses:
        return Measured(0.0)
    first = motion.contact_losses[0].t
    modes = two_way(motion)[0].model.modes
    around = np.linspace(max(first - 0.002, 0.0), first, 20)
    rate = np.abs(np.median(precession_rate(motion.at(around)))) / (2 * np.pi)
    x = (modes.order * rate / modes.frequency)[modes.order > 0]
    details = {
        "before_end": motion.t[-1] - first,
        "precession_frequency": rate,
        "number": len(motion.contact_losses),
    }
    return Measured(x[np.abs(x - 1).argmin()] if len(x) else 0.0, details=details)


def _times(scene, motion, count=4000):
    part, begin = two_way(motion)
    return np.linspace(begin + begins(scene, part), motion.t[-1], count)


def _last(scene, motion) -> Budget:
    """The budget from where LAST of the energy with which the table begins to act back is left."""
    budget = energy_budget(motion, _times(scene, motion))
    whole = budget.disk + budget.table
    return energy_budget(motion, budget.t[np.argmax(whole < LAST * whole[0]) :])
