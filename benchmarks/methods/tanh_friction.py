"""Regularise the Coulomb laws by tanh(v/width) in place of sign(v), so that a contact
creeps instead of rolling.

The maximum of the friction coefficient, at small slip speeds, is the static
coefficient. The law therefore tends to (3.2) as the width tends to 0. A contact that
should roll creeps at a fraction of the width."""

import math
from functools import cache

import numpy as np
from scipy.optimize import brentq

from benchmarks.cases.motion_case import Case
from benchmarks.methods.sign_friction import (
    SLIDING,
    angular_rates,
    integrate,
    rates,
    solve_sign_contact,
)
from benchmarks.timed_runs import Answer
from dynamics.equations import DiskConstants

DECAY_WIDTHS = 10.0
"""Slip speed, in widths, over which the friction coefficient decays from the static to
the dynamic one."""


@cache
def static_excess(mu_static: float, mu_dynamic: float) -> float:
    """Return the amplitude of the decaying term for which the maximum of `coefficient`
    is mu_static."""
    x = np.linspace(0.1, DECAY_WIDTHS, 2000)

    def excess(amplitude):
        return (
            float(
                (
                    np.tanh(x)
                    * (mu_dynamic + amplitude * np.exp(-((x / DECAY_WIDTHS) ** 2)))
                ).max()
            )
            - mu_static
        )

    return brentq(excess, 0.0, 2 * mu_static)


def coefficient(x: float, law: DiskConstants) -> float:
    """Return the ratio of friction to normal force at the slip speed x, in widths."""
    amplitude = static_excess(law.mu_static, law.mu_dynamic)
    return math.tanh(x) * (
        law.mu_dynamic + amplitude * math.exp(-((x / DECAY_WIDTHS) ** 2))
    )


def regularised_contact(state, law: DiskConstants, width: float):
    """Solve the contact with tanh(v/width) in place of every sign(v)."""
    speed = math.hypot(state[4], state[5])
    factor = coefficient(speed / width, law) / law.mu_dynamic / speed if speed else 0.0
    senses = [math.tanh(rate / width) for rate in angular_rates(state)]
    return solve_sign_contact(
        state, SLIDING, (factor * state[4], factor * state[5]), senses, law
    )


def tanh_regularised(case: Case, method: str, width: float, tolerance: float) -> Answer:
    """Solve a case with friction and moments regularised over the velocity `width`."""
    return integrate(
        lambda state: rates(state, regularised_contact(state, case.law, width)),
        case,
        method,
        tolerance,
    )
