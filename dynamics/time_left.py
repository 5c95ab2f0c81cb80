"""How long a disk that turns steadily still needs to lie flat, from the power that it loses."""

from math import copysign, log, sin, sqrt

from .disk import Disk, Friction
from .dissipation import Dissipation, resistance
from .equations import law_of
from .regime import DISSIPATED, FLOAT, Branch, Regime, turnings
from .steady import steady_precession


def time_left(beta: float, disk: Disk, friction: Friction, dissipation: Dissipation | None) -> float:
    """Return the time [s] in which a disk in steady motion with a fixed centre declines from `beta` [rad], small, to 0.

    Its energy, 3/2 m g R beta, goes with the power that resisting moments and dissipation take in the steady motion; as
    beta falls the power is taken to go with the power of beta that it has there. Infinite if that is 1 or more, or if
    nothing is lost.
    """
    law = law_of(disk, friction)
    loads = resistance(dissipation, disk)
    power, lower = (steady_power(b, law, loads) for b in (beta, beta / 2))
    if not power > 0:
        return float("inf")
    exponent = log(power / lower) / log(2)
    if exponent >= 1:
        return float("inf")
    return 3 / 2 * (law.K + 4) / 4 * beta / power / (1 - exponent) * disk.time_unit


def steady_power(beta: float, law, loads) -> float:
    """Return the rate at which rolling in steady motion at inclination `beta` [rad] dissipates, dimensionless."""
    w3, r = steady_precession(beta, law.h, law.K) * sin(beta), sqrt(beta)
    y = [r, 0.0, law.h * w3 / r, w3 / r, *[0.0] * 7]
    regime = Regime(False, (False,) * 3, tuple(copysign(1.0, turning) for turning in turnings(y)))
    branch = Branch.of(regime, law, loads)
    return FLOAT.rates(y, FLOAT.contact(y, branch, regime.senses, law), branch, law)[DISSIPATED]
