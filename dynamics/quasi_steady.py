"""Remaining time of quasi-steady motion until the disk is flat, from the dissipated power."""

from math import copysign, log, sin, sqrt

from dynamics.disk import Disk, Friction
from dynamics.dissipation import Dissipation, resistance_of
from dynamics.equations import disk_constants
from dynamics.regime import DISSIPATED, FLOAT_FORMULAS, Branch, Regime, rotation_rates
from dynamics.steady_motion import steady_precession


def time_left(
    beta: float,
    disk: Disk,
    friction: Friction,
    dissipation: Dissipation | None,
) -> float:
    """Return the time [s] of quasi-steady decline from a small inclination `beta` [rad] to 0.

    The energy 3/2 m g R beta is dissipated by the resisting moments and the laws of dissipation.
    Their power is extrapolated as a power of beta, with its exponent at `beta`. The time is
    infinite if the exponent is 1 or more, or if nothing is dissipated.
    """
    return decline_time(
        beta, disk, disk_constants(disk, friction), resistance_of(dissipation, disk)
    )


def decline_time(beta: float, disk: Disk, law, loads) -> float:
    """Return `time_left` [s] for a dimensionless law of friction and `loads` such as an air film.

    Raises ValueError if the disk is too thick or too steep for steady motion.
    """
    power = steady_power(beta, law, loads)
    power_at_half = steady_power(beta / 2, law, loads)
    if not power > 0:
        return float("inf")
    exponent = log(power / power_at_half) / log(2)
    if exponent >= 1:
        return float("inf")
    return 3 / 2 * (law.K + 4) / 4 * beta / power / (1 - exponent) * disk.time_unit


def steady_power(beta: float, law, loads) -> float:
    """Return the dimensionless dissipated power of steady rolling at inclination `beta` [rad]."""
    w3 = steady_precession(beta, law.h, law.K) * sin(beta)
    r = sqrt(beta)
    y = [r, 0.0, law.h * w3 / r, w3 / r, *[0.0] * 7]
    regime = Regime(
        False, (False,) * 3, tuple(copysign(1.0, turning) for turning in rotation_rates(y))
    )
    branch = Branch.of(regime, law, loads)
    contact = FLOAT_FORMULAS.contact(y, branch, regime.senses, law)
    return FLOAT_FORMULAS.rates(y, contact, branch, law)[DISSIPATED]
