"""Remaining time of quasi-steady motion, predicted from the dissipated power."""

from math import copysign, log, sqrt
from typing import Any

from dynamics.disk import Disk
from dynamics.equations import DiskConstants
from dynamics.regime import DISSIPATED, FLOAT_FORMULAS, Branch, Regime, rotation_rates
from dynamics.steady_motion import steady_omega


def time_to_flat(
    beta: float, disk: Disk, constants: DiskConstants, loads: Any
) -> float:
    """Return the time [s] in which the inclination falls from `beta` [rad] to 0.

    In quasi-steady motion at small inclinations, the resisting moments and the loads
    dissipate the energy 3/2 m g R beta. Their power is extrapolated by a power law with
    its local exponent at `beta`. The time is infinite if the exponent is at least 1, or
    if the power is zero.

    Raises ValueError if the disk is too thick or too steep for steady motion.
    """
    power = steady_power(beta, constants, loads)
    power_at_half = steady_power(beta / 2, constants, loads)
    if not power > 0:
        return float("inf")
    exponent = log(power / power_at_half) / log(2)
    if exponent >= 1:
        return float("inf")
    return (
        3 / 2 * (constants.K + 4) / 4 * beta / power / (1 - exponent) * disk.time_unit
    )


def steady_power(beta: float, constants: DiskConstants, loads: Any) -> float:
    """Return the dimensionless dissipated power of steady rolling at inclination `beta` [rad]."""
    r = sqrt(beta)
    y = [r, *(w / r for w in steady_omega(beta, constants)), *[0.0] * 7]
    first, second, third = rotation_rates(y)
    senses = copysign(1.0, first), copysign(1.0, second), copysign(1.0, third)
    regime = Regime(False, (False, False, False), senses)
    branch = Branch.of(regime, constants, loads)
    contact = FLOAT_FORMULAS.contact(y, branch, regime.senses, constants)
    return FLOAT_FORMULAS.rates(y, contact, branch, constants)[DISSIPATED]
