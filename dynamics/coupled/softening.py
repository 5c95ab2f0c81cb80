"""How far a contact that vibrates strongly is softer than a linear one: where it is nearly lost it hardly resists.

Statistical linearisation (Caughey 1963): the approach of Hertz's spring scatters about a mean as a Gaussian, by what
the linear contact of the mean stiffness gives; the mean of its force is the load.
"""

import numpy as np
from scipy.optimize import brentq

from .filter import predicted_rms
from .roughness import Roughness
from .table import K, LawTable

AWAY = np.linspace(-6.0, 6.0, 241)
NORMAL = np.exp(-(AWAY**2) / 2) / np.exp(-(AWAY**2) / 2).sum()
ROUNDS = 6
"""Each at the mean of the last two: the factor then stands to 3 %, the resonance, its sixth root, to 0.5 %."""


def softened(table: LawTable, roughness: Roughness, inclination, load, speed, rounds: int = ROUNDS) -> np.ndarray:
    """Return the factors (k,) on loads [N] under which the linear contact is as stiff as the vibrating one is in the
    mean, at inclinations [rad] and speeds [m/s] (k,)."""
    every = np.broadcast_arrays(np.atleast_1d(inclination), load, speed)
    return np.array([_factor(table, roughness, *one, rounds) for one in zip(*every, strict=True)])


def _factor(table, roughness, inclination, load, speed, rounds):
    at, factor = np.array([inclination]), 1.0
    K0, alone = table.columns(at)[0, K], table.springs(at, load)[0].kn[0]
    for _ in range(rounds):
        rms = predicted_rms(table, roughness, at, factor * load, speed, above=0.0)[0]
        scatter = rms / (alone * np.cbrt(factor))
        factor = np.sqrt(factor * (mean_stiffness(K0, load, scatter) / alone) ** 3)
    return factor


def mean_stiffness(K, load, scatter) -> float:
    """Return the mean of 1.5 K d^0.5 [N/m] over approaches d [m] that scatter by `scatter`, of which K d^1.5 has the
    mean `load` [N]; d < 0 holds nothing."""
    still = (load / K) ** (2 / 3)
    if not scatter > 0:
        return 1.5 * K * np.sqrt(still)

    def held(mean, power):
        return K * NORMAL @ np.maximum(mean + scatter * AWAY, 0.0) ** power

    mean = brentq(lambda mean: held(mean, 1.5) - load, AWAY[0] * scatter, still + AWAY[-1] * scatter)
    return 1.5 * held(mean, 0.5)
