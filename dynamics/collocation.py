"""One long implicit step for a slide that starts (almost) without acceleration: mu_dynamic = mu_static.

The slip then grows with the square of time, and its direction relaxes at a rate that grows without bound towards the
start: explicit steps would have to be as short as the time already passed. Collocation follows the smooth solution.
"""

import math

import numpy as np

from .hybrid import Step
from .regime import ARRAY, FLOAT, V1, V2, R

ORDER = 9
NODES = (1 - np.cos(np.pi * (np.arange(ORDER) + 0.5) / ORDER)) / 2
"""Gauss-Chebyshev points on [0, 1]; the start, where the direction has no meaning, is not one of them."""
POWERS = np.arange(ORDER)
TO_POWERS = np.linalg.inv(NODES[:, None] ** POWERS)
INTEGRAL = NODES[:, None] ** (POWERS + 1) / (POWERS + 1) @ TO_POWERS
LENGTH = 0.02
"""First length to try, in units of r."""
COMPLEX_STEP = 1e-30


def grazing_step(y, nu, first, regime, branch, law) -> Step:
    """Return the first step of a slide from state y along nu, of a length on which the guards stay positive.

    Raises ArithmeticError where no length down to 1e-4 of LENGTH converges.
    """
    dt = LENGTH * y[R]
    for _ in range(13):
        states = _newton(_guess(y, nu, first, regime, branch, law, dt), y, regime, branch, law, dt)
        if states is not None and _valid(states[-1], regime, branch, law):
            return _step(y, states, regime, branch, law, dt)
        dt /= 2
    raise ArithmeticError(f"the slide that starts at inclination {y[R] ** 2:.6g} could not be followed")


def _rates(states, regime, branch, law):
    """Return dy/dtau at states (n, k)."""
    contact = ARRAY.contact(states.T, branch, regime.senses, law)
    return np.stack(np.broadcast_arrays(*ARRAY.rates(states.T, contact, branch, law)), axis=1)


def _guess(y, nu, first, regime, branch, law, dt):
    """Return states at the nodes with a slip that grows with the square of time along nu."""
    slope = np.array(FLOAT.rates(y, first, branch, law))
    direction = np.array([math.cos(nu), math.sin(nu)])
    states = np.array(y) + dt * NODES[:, None] * slope
    states[:, V1 : V2 + 1] = 0.0
    later = FLOAT.contact_along(states[-1].tolist(), (0.0, 0.0), tuple(direction), branch, regime.senses, law)
    push = np.array([first.du1, first.du2]) @ direction
    growth = np.array([later.du1, later.du2]) @ direction - push
    speed = dt * NODES * push + dt * NODES**2 * growth / (2 * NODES[-1])
    states[:, V1 : V2 + 1] = speed[:, None] * direction / y[R]
    return states


def _newton(states, y, regime, branch, law, dt):
    """Solve states = y + dt INTEGRAL rates(states) by Newton's method; None where it does not converge."""
    n, k = states.shape
    for _ in range(12):
        residual = states - y - dt * INTEGRAL @ _rates(states, regime, branch, law)
        tilted = states + 1j * COMPLEX_STEP * np.eye(k)[:, None, :]
        slopes = _rates(tilted.reshape(-1, k), regime, branch, law).imag.reshape(k, n, k) / COMPLEX_STEP
        matrix = np.eye(n * k) - dt * np.einsum("ij,bja->iajb", INTEGRAL, slopes).reshape(n * k, n * k)
        change = np.linalg.solve(matrix, residual.ravel()).reshape(n, k)
        states = states - change
        if not np.isfinite(states).all():
            return None
        if np.abs(change).max() < 1e-14 * max(1.0, np.abs(states).max()):
            return states
    return None


def _valid(y, regime, branch, law) -> bool:
    """Tell whether every guard is positive at y; the slip need not have passed the speed that ends a slide."""
    y = y.tolist()
    contact = FLOAT.contact(y, branch, regime.senses, law)
    guards = FLOAT.guards(y, contact, branch, regime.senses, law, 0.0)
    return all(value > 0 for name, value in guards.items() if name != "grip")


def _step(y, states, regime, branch, law, dt) -> Step:
    """Return the polynomial through the collocated rates."""
    rates = TO_POWERS @ _rates(states, regime, branch, law)
    rows = dt ** (-POWERS[:, None].astype(float)) * rates / (POWERS[:, None] + 1)
    return Step(regime, dt, [list(y), *rows.tolist()])
