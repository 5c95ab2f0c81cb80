"""Statistical linearisation of the contact spring (Caughey 1963).

A strongly vibrating contact is softer than a linear one. The approach of the Hertz
contact is assumed to be Gaussian. Its variance is that of a linear contact with the
mean stiffness. Its mean is such that the mean force equals the load.
"""

import numpy as np
from scipy.optimize import brentq

from dynamics.compliant.law.linear_response import predicted_rms
from dynamics.compliant.law.sections import Roughness
from dynamics.compliant.law.tabulated import LAW_COLUMNS, TabulatedLaw

GAUSSIAN_NODES = np.linspace(-6.0, 6.0, 241)
"""Nodes of the integral over a Gaussian distribution, in standard deviations."""
GAUSSIAN_WEIGHTS = np.exp(-(GAUSSIAN_NODES**2) / 2)
GAUSSIAN_WEIGHTS /= GAUSSIAN_WEIGHTS.sum()
"""Weights of this integral."""
LINEARISATION_ROUNDS = 6
"""Number of iterations.

The load factor is then accurate to 3 %, and the resonance, which varies as its sixth
root, to 0.5 %.
"""


def effective_load_factor(
    tabulated: TabulatedLaw,
    roughness: Roughness,
    inclination: float | np.ndarray,
    load: float | np.ndarray,
    speed: float | np.ndarray,
    rounds: int = LINEARISATION_ROUNDS,
) -> np.ndarray:
    """Return the load factors (k,) that account for the vibration of the contact.

    Under the loads times these factors, the linear contact has the mean stiffness of
    the vibrating contact. The arguments (k,) are inclinations [rad], loads [N] and
    speeds of the contact [m/s].
    """
    motions = np.broadcast_arrays(np.atleast_1d(inclination), load, speed)
    factors = []
    for beta, force, velocity in zip(*motions, strict=True):
        factors.append(
            _load_factor_of_motion(tabulated, roughness, beta, force, velocity, rounds)
        )
    return np.array(factors)


def _load_factor_of_motion(
    tabulated: TabulatedLaw,
    roughness: Roughness,
    inclination: float,
    load: float,
    speed: float,
    rounds: int,
) -> float:
    """Return the load factor in one steady motion by fixed-point iteration."""
    at = np.array([inclination])
    factor = 1.0
    K0 = tabulated.columns(at)[0, LAW_COLUMNS.hertz_stiffness]
    alone = tabulated.springs(at, load)[0].kn[0]
    for _ in range(rounds):
        rms = predicted_rms(tabulated, roughness, at, factor * load, speed, above=0.0)[
            0
        ]
        scatter = rms / (alone * np.cbrt(factor))
        factor = np.sqrt(factor * (mean_stiffness(K0, load, scatter) / alone) ** 3)
    return factor


def mean_stiffness(K: float, load: float, scatter: float) -> float:
    """Return the mean of the stiffness 1.5 K d^0.5 [N/m] for a Gaussian approach d.

    d has the standard deviation `scatter` [m]. The mean of K d^1.5 is the `load` [N];
    for d < 0 the force is zero.
    """
    still = (load / K) ** (2 / 3)
    if not scatter > 0:
        return 1.5 * K * np.sqrt(still)

    def mean_power(mean: float, exponent: float) -> float:
        pressed = np.maximum(mean + scatter * GAUSSIAN_NODES, 0.0)
        return float(K * GAUSSIAN_WEIGHTS @ pressed**exponent)

    mean = brentq(
        lambda mean: mean_power(mean, 1.5) - load,
        GAUSSIAN_NODES[0] * scatter,
        still + GAUSSIAN_NODES[-1] * scatter,
    )
    return 1.5 * mean_power(mean, 0.5)
