"""Findings on the halt of a disk that the air lifts off the table."""

import numpy as np

from dynamics import Motion
from dynamics.landing.landing_motion import TOUCH, LandingMotion
from dynamics.observables import precession_rate
from sonify.claims.finding import Finding, Measured, finding


def landing_findings(motion: Motion) -> list[Finding]:
    """Return the findings on the landing; empty unless the film lifts the disk."""
    landing = motion.landing
    if landing is None:
        return []
    return [
        halt_is_abrupt(landing),
        air_catches_disk(landing),
        one_impact_ends_it(landing),
    ]


@finding(needs=("motion",), at_most=1.0)
def halt_is_abrupt(landing: LandingMotion) -> Measured:
    """The turns from the lift-off until the disk precesses less than once per second."""
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
def one_impact_ends_it(landing: LandingMotion) -> float:
    """The largest share of the energy at the first touch that one impact dissipates."""
    touches = [event for event in landing.events if event.kind == TOUCH]
    if not touches:
        return 0.0
    times = [event.t for event in touches] + [landing.t_end]
    lost = np.diff(landing.energy_lost(times)["contact"])
    return float(lost.max() / touches[0].energy)
