"""RATTLING DISK -> FINDINGS: losses of contact, impacts, and the law of the precession rate."""

import numpy as np

from dynamics.rattling.rattling_motion import RattlingMotion
from dynamics.rattling.unevenness import rate_exponent
from sonify.claims.contact import micro_flights
from sonify.claims.finding import Finding, Measured, finding, register_judge
from sonify.claims.literature import energy_taken
from sonify.scene import Scene

MIN_RATTLING_SHARE = 0.2
"""Share of time without contact from which a disk is said to rattle."""
EXPONENT_TOLERANCE = 0.05
"""Largest difference between the exponents of the precession rate in theory and in a motion."""
FIT_SAMPLES = 400
"""Number of instants to which the law of the precession rate is fitted."""


def rattling_findings(scene: Scene, motion: RattlingMotion) -> list[Finding]:
    """Return the findings on a motion with contact anywhere on the rim."""
    found = [disk_rattles(motion)]
    if motion.contact_losses:
        found.append(micro_flights(motion))
    found.append(impacts_end_it(motion))
    if scene.roughness is not None and motion.outcome.name == "SETTLED":
        found.append(rate_follows_unevenness(scene.roughness.exponent, motion))
    return found


@finding(
    "The disk rattles: it flies from crest to crest of the unevenness",
    "of the time without contact",
    "an uneven table opens the contact where the curvature of its heights exceeds that of the rim",
    needs=("motion", "contact law"),
    at_least=MIN_RATTLING_SHARE,
)
def disk_rattles(motion: RattlingMotion):
    """The share of the time without contact.

    Flights count as independent events in its margin.
    """
    lasts = motion.contact_losses.array[:, 1]
    margin = 2 * np.sqrt(np.sum(lasts**2)) / motion.t[-1]
    details = {
        "impacts_per_second": motion.impact_rate,
        "curvature_number": motion.model.curvature_number(float(motion.state[0, 1])),
        "rms_over_depth": motion.model.roughness_rms / motion.model.depth(motion.state[0, 1]),
    }
    return Measured(motion.open_share, margin, details)


@finding(
    "Impacts bring the disk to rest",
    "of the energy lost, in the dashpots of the contacts",
    "thousands of small impacts on the crests of an uneven table",
    needs=("motion", "contact law"),
    at_least=0.5,
)
def impacts_end_it(motion: RattlingMotion):
    """The share of the energy loss in the compression of the contacts.

    The margin is the energy that the balance does not explain.
    """
    taken = energy_taken(motion)
    total = sum(taken.values())
    start, end = motion.energy(motion.t[[0, -1]])
    return Measured(taken["contact"] / total, abs(start - end - total) / total)


@register_judge(needs=("motion", "contact law"))
def rate_follows_unevenness(spectrum_exponent: float, motion: RattlingMotion) -> Finding:
    """The exponent n of the precession rate ~ (t_end - t)^-n, and that of the unevenness.

    The margin is the change of the exponent if the first or the last third is left out.
    """
    expected = rate_exponent(spectrum_exponent)
    t = np.linspace(0.0, motion.t[-1], FIT_SAMPLES + 1)[:-1]
    inclination = motion.inclination(t)
    third = FIT_SAMPLES // 3
    value = fitted_exponent(t, inclination)
    others = [
        fitted_exponent(t[part], inclination[part])
        for part in (slice(third, None), slice(0, -third))
    ]
    return Finding(
        key="rate_follows_unevenness",
        claim="The precession rate rises as the spectrum of the unevenness demands",
        value=value,
        unit="exponent n of the precession rate ~ (t_end - t)^-n",
        at_least=expected,
        at_most=expected,
        tolerance=EXPONENT_TOLERANCE,
        margin=max(abs(other - value) for other in others),
        needs=("motion", "contact law"),
        source="n = (2 - H)/(4 - H) for a power spectrum k^-(1 + 2H) of the heights",
    )


def fitted_exponent(t: np.ndarray, inclination: np.ndarray) -> float:
    """Return n of the precession rate ~ (t_end - t)^-n for inclinations (k,) [rad] at times (k,)
    [s].

    The rate is proportional to the inverse root of the inclination. The end is the one of the best
    fit.
    """
    logarithm = np.log(inclination)
    span = t[-1] - t[0]
    best = (np.inf, 0.0)
    for end in t[-1] + span * np.geomspace(1e-4, 3.0, 300):
        line, rest, *_ = np.polyfit(np.log(end - t), logarithm, 1, full=True)
        best = min(best, (float(rest[0]), float(line[0]) / 2))
    return best[1]
