"""Statistical linearisation of the contact spring.

A strongly vibrating contact is softer than a linear one. The approach of Hertz's spring is a
Gaussian variable (Caughey 1963). Its variance follows from the linear contact with the mean
stiffness. Its mean follows from the condition that the mean force equals the load.
"""

import numpy as np
from scipy.optimize import brentq

from dynamics.compliant.law.linear_response import predicted_rms
from dynamics.compliant.law.roughness import Roughness
from dynamics.compliant.law.tabulated import LAW_COLUMNS, LawTable

SCATTER_NODES = np.linspace(-6.0, 6.0, 241)
"""Nodes of the integral over a Gaussian variable, in standard deviations."""
SCATTER_WEIGHTS = np.exp(-(SCATTER_NODES**2) / 2) / np.exp(-(SCATTER_NODES**2) / 2).sum()
"""Weights of this integral."""
LINEARISATION_ROUNDS = 6
"""Number of iterations.

The load factor is then accurate to 3 %, and the resonance, its sixth root, to 0.5 %.
"""


def effective_load_factor(
    table: LawTable,
    roughness: Roughness,
    inclination,
    load,
    speed,
    rounds: int = LINEARISATION_ROUNDS,
) -> np.ndarray:
    """Return the factors (k,) on the loads that account for the vibration of the contact.

    With these loads, the linear contact has the mean stiffness of the vibrating contact. The
    arguments
    (k,) are inclinations [rad], loads [N] and speeds of the contact [m/s].
    """
    every = np.broadcast_arrays(np.atleast_1d(inclination), load, speed)
    return np.array([_factor(table, roughness, *one, rounds) for one in zip(*every, strict=True)])


def _factor(table, roughness, inclination, load, speed, rounds):
    """Return the factor at one inclination, load and speed, by fixed-point iteration."""
    at = np.array([inclination])
    factor = 1.0
    K0 = table.columns(at)[0, LAW_COLUMNS.hertz_stiffness]
    alone = table.springs(at, load)[0].kn[0]
    for _ in range(rounds):
        rms = predicted_rms(table, roughness, at, factor * load, speed, above=0.0)[0]
        scatter = rms / (alone * np.cbrt(factor))
        factor = np.sqrt(factor * (mean_stiffness(K0, load, scatter) / alone) ** 3)
    return factor


def mean_stiffness(K, load, scatter) -> float:
    """Return the mean stiffness 1.5 K d^0.5 [N/m] over a Gaussian approach d with standard
    deviation `scatter` [m].

    The mean of K d^1.5 is the `load` [N]; there is no force for d < 0.
    """
    still = (load / K) ** (2 / 3)
    if not scatter > 0:
        return 1.5 * K * np.sqrt(still)

    def held(mean, power):
        return K * SCATTER_WEIGHTS @ np.maximum(mean + scatter * SCATTER_NODES, 0.0) ** power

    mean = brentq(
        lambda mean: held(mean, 1.5) - load,
        SCATTER_NODES[0] * scatter,
        still + SCATTER_NODES[-1] * scatter,
    )
    return 1.5 * held(mean, 0.5)
