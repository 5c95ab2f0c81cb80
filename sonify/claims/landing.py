"""Findings on the halt of a disk and its cause, with or without an impact."""

from dataclasses import replace
from typing import cast

import numpy as np

from dynamics import Motion, Outcome
from dynamics.landing.equations import LandingState
from dynamics.landing.landing_motion import TOUCH, LandingMotion
from dynamics.landing.solution import solve_landing
from dynamics.landing.stop import stop_below
from dynamics.observables import precession_rate
from sonify.claims.air import what_ends
from sonify.claims.finding import Finding, Measured, finding
from sonify.claims.limits import FINAL_ENERGY_SHARE

OUTCOMES_WITHOUT_END = {
    Outcome.ROLLING_ON,
    Outcome.LIFTED_OFF,
    Outcome.UPRIGHT,
    Outcome.LEFT_TABLE,
    Outcome.STALLED,
    Outcome.CASCADE,
}
"""Outcomes of a rolling motion that no loss of energy has ended: the run was interrupted, or
another motion follows."""
RESTITUTIONS = (0.28, 0.46, 0.79)
"""Coefficients of restitution at which the loss in one impact is stated."""
IMPACT_LOSS_DURATION = 3e-3
"""Time [s] after the beginning of the first impact that contains its loss."""
MIN_PAUSE = 2e-4
"""Time without a loss [s] that separates two impacts."""
MIN_IMPACT_LOSS_SHARE = 1e-3
"""Smallest loss of an impact over the energy at the loss of contact."""


def landing_findings(motion: Motion) -> list[Finding]:
    """Return the findings on the end of a motion.

    Some need a loss of the rolling contact. Of a motion that begins without this contact, and
    ends without it, only the film under the disk that finally lies flat is judged."""
    landing = motion.landing
    at_rest = motion.outcome is Outcome.AT_REST
    ended = end_findings(motion)
    if landing is None:
        found = [one_impact_ends_it(motion)] if at_rest else []
        if not motion.rolling.finding_groups and rests_on_air(motion):
            found.insert(0, air_catches_disk(cast("LandingMotion", motion)))
        return [*ended, *found]
    found = [halt_is_abrupt(landing), one_impact_ends_it(motion)]
    if landing.model.film is not None:
        found.insert(1, air_catches_disk(landing))
    return [*ended, *found]


def end_findings(motion: Motion) -> list[Finding]:
    """Return what ends a motion, if its end is known.

    It is judged on the rolling motion, unless this does not lose the last part of the energy.
    Impacts end a rattling disk, see `sonify.claims.rattling`."""
    rolling = motion.rolling
    if "rattling" in rolling.finding_groups:
        return []
    is_interrupted = rolling.rolling_outcome in OUTCOMES_WITHOUT_END
    if motion.outcome is Outcome.AT_REST and (
        is_interrupted or ends_without_rolling(motion)
    ):
        return [what_ends(motion)]
    return [] if is_interrupted else [what_ends(rolling)]


def ends_without_rolling(motion: Motion) -> bool:
    """Return True if the disk loses the last part of its energy after its rolling contact, or
    never had this contact."""
    if not motion.rolling.finding_groups:
        return True
    if motion.landing is None:
        return False
    first, left, last = motion.energy([0.0, motion.rolling.t[-1], motion.t[-1]])
    return bool(left - last > FINAL_ENERGY_SHARE * (first - last))


def rests_on_air(motion: Motion) -> bool:
    """Return True if the disk finally lies on its film of air."""
    return any(event.kind == "rests on a cushion of air" for event in motion.events)


@finding(needs=("motion",), at_most=1.0)
def halt_is_abrupt(landing: LandingMotion) -> Measured:
    """The turns from the loss of contact until the disk precesses less than once per second."""
    slow = 2 * np.pi  # rad/s
    state = landing.at(landing.t)
    rate = np.abs(precession_rate(state))
    stops = int(np.argmax(rate < slow))
    if not rate[stops] < slow:
        stops = -1
    turns = abs(state[stops, 0] - state[0, 0]) / (2 * np.pi)
    return Measured(turns, details={"milliseconds": landing.t[stops] * 1e3})


@finding(needs=("motion",), at_most=0.0)
def air_catches_disk(landing: LandingMotion) -> Measured:
    """The number of times that the low point of the rim touches the table again."""
    clearance = landing.clearance(landing.t)
    highest = int(np.argmax(clearance))
    touches = [event for event in landing.events if event.kind == TOUCH]
    return Measured(
        float(len(touches)),
        details={
            "clearance": clearance[highest] * 1e6,
            "milliseconds": landing.t[highest] * 1e3,
            "gap": landing.film_gap(landing.t_end)[0] * 1e6,
        },
    )


@finding(needs=("motion",), at_least=0.5)
def one_impact_ends_it(motion: Motion) -> Measured:
    """The largest share of the final energy that one impact dissipates.

    After a landing, the final energy is that at the first impact, and the details repeat the
    share with other restitutions. Otherwise it is the last part of the initial energy, and an
    impact is the loss in the contact within IMPACT_LOSS_DURATION; a disk that never loses contact has
    no impact."""
    if motion.landing is not None:
        return _largest_share_after_landing(motion.landing)
    if not motion.contact_losses:
        return Measured(0.0, variant="kept")
    return Measured(_largest_share_of_contact(motion), variant="rattling")


def _largest_share_after_landing(landing: LandingMotion) -> Measured:
    """Return the largest loss in one impact over the energy at the first impact."""
    own = impacts(landing)
    if not len(own):
        return Measured(0.0)
    until = own[0, 0] + IMPACT_LOSS_DURATION
    details = {
        f"at_{round(100 * restitution)}": _largest_loss(
            impacts(_with_restitution(landing, restitution, until))
        )
        for restitution in RESTITUTIONS
    }
    return Measured(_largest_loss(own), details=details)


def _largest_share_of_contact(motion: Motion) -> float:
    """Return the largest loss in the contact within IMPACT_LOSS_DURATION over the final energy."""
    t = motion.t
    energy = motion.energy(t)
    final_energy = FINAL_ENERGY_SHARE * (energy[0] - energy[-1])
    start = np.argmax(energy - energy[-1] < final_energy)
    lost = motion.energy_lost(t)["contact"]
    in_window = np.interp(t[start:] + IMPACT_LOSS_DURATION, t, lost) - lost[start:]
    return float(in_window.max() / final_energy)


def _largest_loss(found: np.ndarray) -> float:
    """Return the largest loss of energy in one of n impacts (n, 3) over the energy before the
    first one."""
    return float(found[:, 2].max() / found[0, 1]) if len(found) else 0.0


def _with_restitution(
    landing: LandingMotion, restitution: float, duration: float
) -> LandingMotion:
    """Return a landing on asperities with another restitution, cut at a duration [s]."""
    model = landing.model
    stop = model.stop
    other = stop_below(
        stop.radius, landing.disk.mass, restitution, stop.height, stop.stiffness
    )
    start = LandingState(*landing.solution.path(0.0))
    solution = solve_landing(replace(model, stop=other), start, duration)
    return replace(landing, solution=solution)


def impacts(landing: LandingMotion) -> np.ndarray:
    """Return time [s], energy before [J] and loss [J] (n, 3) of each impact on the table.

    Losses less than MIN_PAUSE apart belong to one impact; impacts that take less than
    MIN_IMPACT_LOSS_SHARE of the energy are left out.
    """
    t = landing.t
    lost = landing.energy_lost(t)["contact"]
    energy = landing.energy(t)
    strikes = np.flatnonzero(np.diff(lost) > 1e-9 * energy[0])
    groups = np.split(strikes, np.flatnonzero(np.diff(t[strikes]) > MIN_PAUSE) + 1)
    rows = [
        (t[group[0]], energy[group[0]], lost[group[-1] + 1] - lost[group[0]])
        for group in groups
        if len(group)
    ]
    found = np.reshape(rows, (-1, 3))
    return found[found[:, 2] > MIN_IMPACT_LOSS_SHARE * energy[0]]
