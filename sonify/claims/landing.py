"""Findings on the halt of a disk that loses its rolling contact."""

from dataclasses import replace

import numpy as np

from dynamics import Motion
from dynamics.landing.equations import LandingState
from dynamics.landing.landing_motion import TOUCH, LandingMotion
from dynamics.landing.solution import solve_landing
from dynamics.landing.stop import stop_below
from dynamics.observables import precession_rate
from sonify.claims.finding import Finding, Measured, finding

RESTITUTIONS = (0.28, 0.46, 0.79)
"""Coefficients of restitution at which the loss in one impact is stated."""
SLAP_DURATION = 3e-3
"""Time [s] after the beginning of the first impact that contains its loss."""
MIN_PAUSE = 2e-4
"""Time without a loss [s] that separates two impacts."""
MIN_IMPACT_LOSS_SHARE = 1e-3
"""Smallest loss of an impact over the energy at the loss of contact."""


def landing_findings(motion: Motion) -> list[Finding]:
    """Return the findings on the end of a motion that loses its rolling contact."""
    landing = motion.landing
    if landing is None:
        return []
    found = [halt_is_abrupt(landing), one_impact_ends_it(landing)]
    if landing.model.film is not None:
        found.insert(1, air_catches_disk(landing))
    return found


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
def one_impact_ends_it(landing: LandingMotion) -> Measured:
    """The largest share of the energy at the first impact that one impact dissipates.

    The details repeat it with other restitutions, shortly beyond the first impact.
    """
    own = impacts(landing)
    if not len(own):
        return Measured(0.0)
    until = own[0, 0] + SLAP_DURATION
    details = {
        f"at_{round(100 * restitution)}": _largest_loss(
            impacts(_with_restitution(landing, restitution, until))
        )
        for restitution in RESTITUTIONS
    }
    return Measured(_largest_loss(own), details=details)


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
    solution = solve_landing(model._replace(stop=other), start, duration)
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
