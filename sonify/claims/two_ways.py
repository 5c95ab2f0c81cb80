"""TWO WAYS: what a table that acts back takes, where it breaks the contact, and how much earlier the disk lies flat."""

from dataclasses import replace
from typing import NamedTuple

import numpy as np

from dynamics import Motion
from dynamics.coupled.acting import ACTS, acting
from dynamics.coupled.handover import release
from dynamics.coupled.march import LIES
from dynamics.coupled.motion import STATES
from dynamics.coupled.state import CAUSES
from dynamics.rates import precession_rate
from sonify.claims.motion import Finding
from sonify.scene import Scene

CHAOS = 0.01
"""By how much [s] the halt moves with step, stiffness and phase, tests/test_table_acts_back.py."""
LAST = 0.1
"""The part of the energy at which the halt begins."""
EVERY = 20
"""Steps between rows of a motion of which only the end is looked at."""
NEAR = 0.2
"""A loss of contact is at the resonance of a mode where n Omega/w is as near to 1."""


class Budget(NamedTuple):
    """Energy [J] at times t (k,) [s] of the whole motion: of the disk and of the modes of the table, and what was lost
    since the first of the times to each of CAUSES, every row (k,)."""

    t: np.ndarray
    disk: np.ndarray
    table: np.ndarray
    lost: dict[str, np.ndarray]


def two_way(motion: Motion):
    """Return the part of a motion in which the table acts back, and when it begins [s]; None where it never does."""
    part, begin = getattr(motion, "then", motion), getattr(motion, "handed_over", 0.0)
    model = getattr(part, "model", None)
    return None if model is None or model.modes is None else (part, begin)


def energy_budget(motion: Motion, t) -> Budget:
    """Return the `Budget` at times t (k,) [s] at which the table acts back. Raises ValueError at others."""
    found = two_way(motion)
    if found is None:
        raise ValueError("energy_budget: the table of this motion does not act back")
    part, begin = found
    now = np.asarray(t, dtype=float) - begin
    table, lost = part.table_energy(now), part.lost(now)
    return Budget(t, part.energy(now) - table, table, dict(zip(CAUSES, (lost - lost[0]).T, strict=True)))


def motion_findings(scene: Scene, motion: Motion) -> list[Finding]:
    """Return every claim on a table that acts back; none where it does not, or no end was reached."""
    found = two_way(motion)
    if found is None or motion.outcome.name not in ("SETTLED", "FELL"):
        return []
    losses = [loss_at_resonance(motion)] if motion.contact_losses else []
    return [halt_comes_earlier(scene, motion), waves_make_the_halt(motion), table_rings_at_the_halt(motion), *losses]


def halt_comes_earlier(scene: Scene, motion: Motion) -> Finding:
    """By how much earlier [s] the disk lies flat than the same disk, on the same contact, on a table without modes.

    That one goes on from where the table begins to act back, `dynamics.coupled.acting`, and holds ACTS of the energy.
    """
    part, _ = two_way(motion)
    acts = part.rows[:, 1] < acting(scene, part.model.modes).inclination
    start = float(acts.argmax() * STATES * part.dt)
    alone, below = replace(part.model, modes=None), max(part.rows[-1, 1], LIES)
    y = release(alone, part.at([start])[0], part.force([start])[0])
    *_, last = alone.run(y, EVERY, max(scene.numerics.time_limit - start, 1e-3), below)
    return Finding(
        key="halt_comes_earlier",
        claim="The table brings the halt forward",
        value=start + last.t[-1] - part.t[-1],
        unit="s earlier than on a table that does not act back",
        at_least=0.05,
        margin=CHAOS + ACTS * last.t[-1],
        source="section 8: the vibrations will result in an abrupt halt",
    )


def waves_make_the_halt(motion: Motion) -> Finding:
    """The share of the modes of the table in what the disk and its contact lose in the last LAST of the energy."""
    budget = _last(motion)
    shares = {name: lost[-1] for name, lost in budget.lost.items()}
    shares["table"] += budget.table[-1] - budget.table[0]
    whole = sum(shares.values())
    told = ", ".join(f"{name} {share / whole:.2g}" for name, share in shares.items())
    return Finding(
        key="waves_make_the_halt",
        claim="The waves of the table, and not impacts or friction, take the last energy",
        value=shares["table"] / whole,
        unit=f"of the last {LAST:.0%} of the energy; {told}",
        at_least=0.5,
        margin=0.05,
        source="section 8: contact that is lost and regained ends the motion",
    )


def table_rings_at_the_halt(motion: Motion) -> Finding:
    """The share of the modes of the table in the energy of disk and table, when they hold most."""
    t = _times(motion)
    budget = energy_budget(motion, t)
    most = budget.table.argmax()
    return Finding(
        key="table_rings_at_the_halt",
        claim="The table at last holds more energy than the disk",
        value=budget.table[most] / (budget.table[most] + abs(budget.disk[most])),
        unit=f"of the energy of both, {motion.t[-1] - t[most]:.3g} s before the end",
        at_least=0.5,
        source="abstract: the vibrations of disk and surface",
    )


def loss_at_resonance(motion: Motion) -> Finding:
    """n Omega/w at the first loss of contact, of the mode of the table that is nearest to 1 there."""
    first, modes = motion.contact_losses[0].t, two_way(motion)[0].model.modes
    around = np.linspace(max(first - 0.002, 0.0), first, 20)
    rate = np.abs(np.median(precession_rate(motion.at(around)))) / (2 * np.pi)
    x = (modes.order * rate / modes.frequency)[modes.order > 0]
    return Finding(
        key="loss_at_resonance",
        claim="Contact is first lost where its precession passes the waves of a mode",
        value=float(x[np.abs(x - 1).argmin()]) if len(x) else 0.0,
        unit=f"n times the precession over the frequency of the nearest mode, at {first:.4g} s and {rate:.3g} Hz; "
        f"{len(motion.contact_losses)} losses in all",
        at_least=1 - NEAR,
        at_most=1 + NEAR,
        source="section 8: the vibrations will result in a loss of contact",
    )


def _times(motion, count=4000):
    return np.linspace(two_way(motion)[1], motion.t[-1], count)


def _last(motion) -> Budget:
    """The budget from where LAST of the energy with which the table begins to act back is left."""
    budget = energy_budget(motion, _times(motion))
    whole = budget.disk + budget.table
    return energy_budget(motion, budget.t[np.argmax(whole < LAST * whole[0]) :])
