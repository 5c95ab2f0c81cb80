"""Coulomb's laws smeared out: sign(v) becomes tanh(v/width), and the contact never quite rolls.

The peak of the smeared law at small slip speeds is the static coefficient, so that it tends to the law (3.2) with its
width; a contact that should roll creeps at a fraction of it.
"""

import math
from functools import cache

import numpy as np
from scipy.optimize import brentq

from dynamics.equations import Law
from sonify.charts.motion_case import Case
from sonify.charts.naive import SLIDING, contact, integrate, rates, turnings
from sonify.charts.records import Answer

FADE = 10.0
"""Widths over which the static coefficient fades to the dynamic one."""


@cache
def hump(mu_static: float, mu_dynamic: float) -> float:
    """Return the height of the hump that makes mu_static the peak of `coefficient`."""
    x = np.linspace(0.1, FADE, 2000)

    def excess(height):
        return float((np.tanh(x) * (mu_dynamic + height * np.exp(-((x / FADE) ** 2)))).max()) - mu_static

    return brentq(excess, 0.0, 2 * mu_static)


def coefficient(x: float, law: Law) -> float:
    """Return friction over normal force at slip speed x, in widths."""
    height = hump(law.mu_static, law.mu_dynamic)
    return math.tanh(x) * (law.mu_dynamic + height * math.exp(-((x / FADE) ** 2)))


def smeared(state, law: Law, width: float):
    """Solve the contact with every sign() smeared over `width`."""
    speed = math.hypot(state[4], state[5])
    share = coefficient(speed / width, law) / law.mu_dynamic / speed if speed else 0.0
    senses = [math.tanh(turning / width) for turning in turnings(state)]
    return contact(state, SLIDING, (share * state[4], share * state[5]), senses, law)


def tanh_regularised(case: Case, method: str, width: float, tolerance: float) -> Answer:
    """Solve a case with friction and moments smeared over the velocity `width`."""
    return integrate(lambda state: rates(state, smeared(state, case.law, width)), case, method, tolerance)
