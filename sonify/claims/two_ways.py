"""TWO WAYS: what a table that acts back takes, where it breaks the contact, and how much earlier the disk lies flat.

Each finding is judged again on the end of the motion in steps of half the length, and on a contact twice as stiff: what
it differs by is its margin. Whether contact is lost is uncertain where they do not agree.
"""

from collections.abc import Callable
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from dynamics import Motion
from dynamics.coupled.acting import acting
from dynamics.coupled.handover import release
from dynamics.coupled.march import LIES
from dynamics.coupled.motion import STATES, CompliantMotion, followed
from dynamics.coupled.state import CAUSES
from dynamics.rates import precession_rate
from dynamics.surface import ACTS
from sonify.claims.motion import Finding, finding
from sonify.scene import Scene

ALL_BUT_FLAT = 2 * LIES
"""An inclination [rad] below which a disk touches and leaves a table that waves with one step and not with another."""
LAST = 0.1
"""The part of the energy at which the halt begins."""
LEFT = "that was left when the table began to act back"
EVERY = 20
"""Steps between rows of a motion of which only the end is looked at."""
NEAR = 0.2
"""A loss of contact is at the resonance of a mode where n Omega/w is as near to 1."""


class Budget(NamedTuple):
    """Energy [J] at times t (k,) [s] of the whole motion: of the disk, a part of that in its `bending` modes, and of
    the modes of the table; what was lost since the first of the times to each of CAUSES, and what part of the loss in
    the table went off as `sound`; every row (k,)."""

    t: np.ndarray
    disk: np.ndarray
    bending: np.ndarray
    table: np.ndarray
    lost: dict[str, np.ndarray]
    sound: np.ndarray


def two_way(motion: Motion):
    """Return the part of a motion in which the table acts back, and when it begins [s]; None where it never does."""
    part, begin = getattr(motion, "then", motion), getattr(motion, "handed_over", 0.0)
    model = getattr(part, "model", None)
    return None if model is None or model.modes is None else (part, begin)


def energy_budget(motion: Motion, t, heard=None) -> Budget:
    """Return the `Budget` at times t (k,) [s] at which the table acts back; without what is `heard` of the table, times
    (e,) [s] and power [W], as `sonify.claims.table.radiated_power` has it, its sound is 0. Raises ValueError at others.
    """
    found = two_way(motion)
    if found is None:
        raise ValueError("energy_budget: the table of this motion does not act back")
    part, begin = found
    now = np.minimum(np.asarray(t, dtype=float) - begin, part.t[-1])
    table, lost, sound = part.table_energy(now), part.lost(now), np.zeros(len(now))
    if heard is not None:
        sound = np.interp(t, heard[0], np.cumsum(heard[1]) * np.gradient(heard[0]))
    causes = dict(zip(CAUSES, (lost - lost[0]).T, strict=True))
    return Budget(t, part.energy(now) - table, part.bending_energy(now), table, causes, sound - sound[0])


def motion_findings(scene: Scene, motion: Motion) -> list[Finding]:
    """Return every claim on a table that acts back; none where it does not, or no end was reached."""
    found = two_way(motion)
    if found is None or motion.outcome.name not in ("SETTLED", "FELL"):
        return []
    others = reruns(scene, found[0])
    judges = [halt_comes_earlier, waves_make_the_halt, table_rings_at_the_halt, disk_rings_at_the_halt]
    judges += [loss_at_resonance] if motion.contact_losses else []
    broken = table_breaks_contact(motion)
    agree = all(table_breaks_contact(other).holds == broken.holds for other in others.values())
    broken = broken if agree else replace(broken, margin=max(broken.value, 1.0))
    return [broken, *(varied(judge, scene, motion, others) for judge in judges)]


def reruns(scene: Scene, part: CompliantMotion) -> dict[str, CompliantMotion]:
    """Return the motion from where the table begins to act back on, with half the step and with a stiffer contact."""
    start, stop = begins(scene, part), scene.numerics.time_limit
    state, force = part.at([start])[0], part.force([start])[0]
    models = {"half the step": part.model.finer(), "a contact twice as stiff": part.model.stiffer()}
    return {name: followed(model, state, force, stop - start, LIES) for name, model in models.items()}


def varied(judge: Callable[[Scene, Motion], Finding], scene: Scene, motion: Motion, others) -> Finding:
    """Return what `judge` finds, give or take what it finds of the `others`, motions by name."""
    found = judge(scene, motion)
    values = {name: judge(scene, other).value for name, other in others.items()}
    told = ", ".join(f"{value:.3g} with {name}" for name, value in values.items())
    margin = max([found.margin, *(abs(value - found.value) for value in values.values())])
    return replace(found, unit=f"{found.unit}; {told}", margin=margin)


def begins(scene: Scene, part: CompliantMotion) -> float:
    """Return when [s] in a motion on a table its modes begin to act back, `dynamics.coupled.acting`; 0 if before it."""
    acts = part.rows[:, 1] < acting(scene, part.model.modes).inclination
    return float(acts.argmax() * STATES * part.dt)


@finding(
    "The table brings the halt forward",
    "s earlier than on a table that does not act back",
    "section 8: the vibrations will result in an abrupt halt",
    at_least=0.05,
)
def halt_comes_earlier(scene: Scene, motion: Motion):
    """By how much earlier [s] the disk lies flat than the same disk, on the same contact, on a table without modes.

    That one goes on from where the table begins to act back, and holds ACTS of the energy.
    """
    part, _ = two_way(motion)
    start = begins(scene, part)
    alone, below = replace(part.model, modes=None), max(part.rows[-1, 1], LIES)
    y = release(alone, part.at([start])[0], part.force([start])[0])
    *_, last = alone.run(y, EVERY, max(scene.numerics.time_limit - start, 1e-3), below)
    return start + last.t[-1] - part.t[-1], ACTS * last.t[-1]


@finding(
    "The waves of the table, and not impacts or friction, take the last energy",
    f"of the last {LAST:.0%} of the energy {LEFT}",
    "section 8: contact that is lost and regained ends the motion",
    at_least=0.5,
)
def waves_make_the_halt(scene: Scene, motion: Motion):
    """The share of the modes of the table in what the disk and its contact lose in the last LAST of the energy."""
    budget = _last(scene, motion)
    shares = {name: lost[-1] for name, lost in budget.lost.items()}
    shares["table"] += budget.table[-1] - budget.table[0]
    whole = sum(shares.values())
    told = ", ".join(f"{name} {share / whole:.2g}" for name, share in shares.items())
    return shares["table"] / whole, 0.0, f"; {told}"


@finding(
    "The table at last holds more energy than the disk",
    "of the energy of both",
    "abstract: the vibrations of disk and surface",
    at_least=0.5,
)
def table_rings_at_the_halt(scene: Scene, motion: Motion):
    """The share of the modes of the table in the energy of disk and table, when they hold most."""
    t = _times(scene, motion)
    budget = energy_budget(motion, t)
    most = budget.table.argmax()
    share = budget.table[most] / (budget.table[most] + abs(budget.disk[most]))
    return share, 0.0, f", {motion.t[-1] - t[most]:.3g} s before the end"


@finding(
    "The vibrations of the disk, and not those of the table alone, have a part in the halt",
    f"of the last {LAST:.0%} of the energy {LEFT} is the most that its elastic modes hold",
    "abstract: the vibrations of disk and surface",
    at_least=0.1,
)
def disk_rings_at_the_halt(scene: Scene, motion: Motion):
    """The greatest energy of the elastic modes of the disk over that with which the last LAST of the energy begins."""
    budget = _last(scene, motion)
    return budget.bending.max() / (budget.disk[0] + budget.table[0])


@finding(
    "A table that acts back breaks the contact",
    f"losses of contact above {ALL_BUT_FLAT:g} rad; how many is chaotic, whether any is asked with half the step and a "
    "stiffer contact too",
    "abstract: the vibrations will result in a loss of contact",
    at_least=1.0,
)
def table_breaks_contact(motion: Motion):
    """The number of losses of contact of a disk that does not lie all but flat."""
    begins = [loss.t for loss in motion.contact_losses]
    return int((motion.at(begins)[:, 1] > ALL_BUT_FLAT).sum()) if begins else 0


@finding(
    "Contact is first lost where its precession passes the waves of a mode",
    "n times the precession over the frequency of the nearest mode",
    "section 8: the vibrations will result in a loss of contact",
    at_least=1 - NEAR,
    at_most=1 + NEAR,
)
def loss_at_resonance(scene: Scene, motion: Motion):
    """n Omega/w at the first loss of contact, of the mode of the table that is nearest to 1 there; 0 without a loss."""
    if not motion.contact_losses:
        return 0.0, 0.0, ", contact is kept"
    first, modes = motion.contact_losses[0].t, two_way(motion)[0].model.modes
    around = np.linspace(max(first - 0.002, 0.0), first, 20)
    rate = np.abs(np.median(precession_rate(motion.at(around)))) / (2 * np.pi)
    x = (modes.order * rate / modes.frequency)[modes.order > 0]
    told = (
        f", {motion.t[-1] - first:.2g} s before the end and {rate:.3g} Hz; {len(motion.contact_losses)} losses in all"
    )
    return x[np.abs(x - 1).argmin()] if len(x) else 0.0, 0.0, told


def _times(scene, motion, count=4000):
    part, begin = two_way(motion)
    return np.linspace(begin + begins(scene, part), motion.t[-1], count)


def _last(scene, motion) -> Budget:
    """The budget from where LAST of the energy with which the table begins to act back is left."""
    budget = energy_budget(motion, _times(scene, motion))
    whole = budget.disk + budget.table
    return energy_budget(motion, budget.t[np.argmax(whole < LAST * whole[0]) :])
