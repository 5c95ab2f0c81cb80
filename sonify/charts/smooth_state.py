"""The raw equations of motion of a state, for methods that make their own mind up about friction."""

import math

from dynamics.equations import Law, solve
from dynamics.regime import projections

ROLLING, SLIDING = False, True
FREE = (False, False, False)


def turnings(state) -> tuple[float, float, float]:
    """Return omega.a_1, omega.a_2, omega.a_3 of a state."""
    return projections(*state[:4], math.sin, math.cos)


def contact(state, sliding: bool, direction, senses, law: Law):
    """Solve the balance laws (4.1), (4.2) with slip `direction` and the senses of the moments given, none sticking."""
    return solve(*state, *direction, sliding, *FREE, *senses, law)


def rates(state, solved) -> list[float]:
    """Return the rates of (inclination, omega_1..3, slip_1, slip_2)."""
    return [-state[1], solved.domega1, solved.domega2, solved.domega3, solved.du1, solved.du2]
