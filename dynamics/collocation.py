"""Implicit steps of high order for a slide so slow that its direction is stiff.

The slip direction relaxes at a rate of friction over slip speed. Where the slip speed hardly changes meanwhile, as
after a start without acceleration (mu_dynamic = mu_static), explicit steps of any order would have to be as short.
"""

import math

import numpy as np

from .first_root import first_fall
from .hybrid import Arc, StalledError, Step
from .regime import ARRAY, FLOAT, PRECESSION, STOP_SPEED, V1, V2, Branch, R, describe

ORDER = 9
NODES = (1 - np.cos(np.pi * (np.arange(ORDER) + 0.5) / ORDER)) / 2
"""Gauss-Chebyshev points on [0, 1]; the start, where the direction may have no meaning, is not one of them."""
POWERS = np.arange(ORDER)
TO_POWERS = np.linalg.inv(NODES[:, None] ** POWERS)
INTEGRAL = NODES[:, None] ** (POWERS + 1) / (POWERS + 1) @ TO_POWERS
LENGTH, LONGEST = 0.1, 0.5
"""First length of a step to try, in units of r, unless the direction relaxes in less; and the longest."""
GROWTH, SHRINK = 4.0, 0.4
"""Bounds on the ratio of a step to the last one."""
SHORTEST = 1e-12
REST = 1e-13
"""Slip speed over r at which a slow slide is at rest: there it is too slow for a last step along its tangent."""
COMPLEX_STEP = 1e-30
ACCURACY = 1e-12
SLOW, LAZY_GAIN, LAZY_LOSS = 0.05, 0.002, 0.05
"""A slide is stiff while its speed over r, and what it gains or loses, are less than these parts of friction.

Explicit steps are many times cheaper, but as a slide comes to rest their number has no bound.
"""
MOST_STEPS = 100


def is_stiff(y, contact, law) -> bool:
    """Tell whether the slide at state y is slow, and slow to change."""
    speed = math.hypot(y[V1], y[V2])
    friction = law.mu_dynamic * contact.Phi
    gain = (contact.du1 * y[V1] + contact.du2 * y[V2]) / (speed * friction)
    return speed < SLOW * friction and -LAZY_LOSS < gain < LAZY_GAIN


def grazing_step(y, nu, first, regime, branch, law) -> Step | None:
    """Return the first step of a slide from rest along nu, of a length on which every guard stays positive.

    None where the slip comes back to rest before it has the speed that ends a slide: then there is no slide to follow.
    Raises StalledError where no length down to SHORTEST converges.
    """
    dt, forward = LENGTH * y[R], (math.cos(nu), math.sin(nu))
    while dt > SHORTEST * y[R]:
        states = _newton(_at_rest(y, nu, first, regime, branch, law, dt), y, forward, regime, branch, law, dt)
        if states is not None and _error(powers := _powers(y, states, forward, regime, branch, law, dt), dt) < 1:
            step = Step(regime, dt, powers)
            grip, *others = _guards(np.vstack([states, step.end]).T, forward, regime, branch, law, 0.0).values()
            if min(map(np.min, others)) > 0 and grip.min() > -REST:
                return step if grip[-1] > STOP_SPEED else None
        dt /= 2
    raise StalledError(f"{describe(y)}: the slide that starts here could not be followed")


def advance(y, regime, law, loads, r_end, span, tolerance) -> Arc:
    """Integrate a stiff slide until a guard falls, for `span`, until it is stiff no more, or for MOST_STEPS steps.

    Raises StalledError where no length down to SHORTEST converges from the start.
    """
    branch = Branch.of(regime, law, loads)
    forward = np.array(y[V1 : V2 + 1])

    def guards(y):
        return _guards(y, forward, regime, branch, law, r_end)

    y = np.array(y)
    t, length, times, blocks, fired, values = 0.0, min(LENGTH, 2 * math.hypot(y[V1], y[V2])), [], [], None, guards(y)
    while t < span and fired is None and len(times) < MOST_STEPS:
        dt = min(length * y[R], span - t)
        powers, error = _step(y, regime, branch, law, dt)
        if powers is None:
            length *= SHRINK
            if length >= SHORTEST:
                continue
            if times:
                break
            raise StalledError(f"{describe(y)}: the slow slide could not be followed")
        curve = lambda s, rows=powers: np.polynomial.polynomial.polyval(s, rows)  # noqa: E731
        end, fired, values = first_fall(curve, 0.0, dt, guards, values)
        t, y, length = t + end, curve(end), min(min(GROWTH, 0.8 * error ** (-1 / ORDER)) * length, LONGEST)
        forward = y[V1 : V2 + 1]
        times.append(t)
        blocks.append(powers)
        if fired or not is_stiff(y, FLOAT.contact(y.tolist(), branch, regime.senses, law), law):
            if fired is None and values["grip"] < STOP_SPEED:  # it stops too fast to be slow, and has no guard left
                fired = "grip"
            break
    return Arc(np.array(times), np.array(blocks), y.tolist(), fired)


def _step(y, regime, branch, law, dt):
    """Return the powers (ORDER + 1, k) of one step of length dt, None where it is too long; its error over ACCURACY."""
    forward = y[V1 : V2 + 1]
    states = _newton(_onward(y, regime, branch, law, dt), y, forward, regime, branch, law, dt)
    if states is None:
        return None, math.inf
    powers = _powers(y, states, forward, regime, branch, law, dt)
    error = _error(powers, dt)
    return (powers if error < 1 else None), error


def _error(powers, dt):
    """Return the error of a step over ACCURACY: the last coefficient in Chebyshev's polynomials on the step."""
    last = np.abs(powers[-1]).max() * dt**ORDER / 2 ** (2 * ORDER - 1)
    return last / (ACCURACY * max(1.0, np.abs(powers[0]).max())) + 1e-30


def _slip(y, forward):
    """Return slip velocity and direction at states y (k, ...); the direction stays `forward` where the slip runs back.

    So continued, the slow solution is smooth through rest, and a step that overshoots the end of the slide finds it.
    """
    v1, v2 = y[V1], y[V2]
    speed = np.sqrt(v1 * v1 + v2 * v2) * np.where(np.real(v1) * forward[0] + np.real(v2) * forward[1] < 0, -1.0, 1.0)
    return (y[R] * v1, y[R] * v2), (v1 / speed, v2 / speed)


def _rates(states, forward, regime, branch, law):
    """Return dy/dtau at states (n, k)."""
    y = states.T
    contact = ARRAY.contact_along(y, *_slip(y, forward), branch, regime.senses, law)
    return np.stack(np.broadcast_arrays(*ARRAY.rates(y, contact, branch, law)), axis=1)


def _at_rest(y, nu, first, regime, branch, law, dt):
    """Return states at the nodes with a slip that starts at rest along nu and gains speed at a rate that grows."""
    direction = np.array([math.cos(nu), math.sin(nu)])
    states = np.array(y) + dt * NODES[:, None] * np.array(FLOAT.rates(y, first, branch, law))
    states[:, V1 : V2 + 1] = 0.0
    later = FLOAT.contact_along(states[-1].tolist(), (0.0, 0.0), tuple(direction), branch, regime.senses, law)
    push = np.array([first.du1, first.du2]) @ direction
    growth = np.array([later.du1, later.du2]) @ direction - push
    speed = dt * NODES * push + dt * NODES**2 * growth / (2 * NODES[-1])
    states[:, V1 : V2 + 1] = speed[:, None] * direction / y[R]
    return states


def _onward(y, regime, branch, law, dt):
    """Return states at the nodes with a slip that keeps its direction."""
    slope = _rates(y[None], y[V1 : V2 + 1], regime, branch, law)[0]
    along = y[V1 : V2 + 1] / np.hypot(*y[V1 : V2 + 1])
    slope[V1 : V2 + 1] = along * (slope[V1 : V2 + 1] @ along)
    return y + dt * NODES[:, None] * slope


def _newton(states, y, forward, regime, branch, law, dt):
    """Solve states = y + dt INTEGRAL rates(states) by Newton's method; None where it does not converge.

    What is only integrated along, from PRECESSION on, follows when the rest is known.
    """
    for _ in range(12):
        residual = (states - y - dt * INTEGRAL @ _rates(states, forward, regime, branch, law))[:, :PRECESSION]
        change = np.linalg.solve(_matrix(states, forward, regime, branch, law, dt), residual.ravel())
        states[:, :PRECESSION] -= change.reshape(residual.shape)
        size = np.abs(change).max()
        if not np.isfinite(size):
            return None
        if size < ACCURACY * max(1.0, np.abs(states[:, :PRECESSION]).max()):
            return _with_quadratures(states, y, forward, regime, branch, law, dt)
    return None


def _with_quadratures(states, y, forward, regime, branch, law, dt):
    """Return the states with precession and quadratures that follow from the others."""
    for _ in range(2):  # the path turns with the precession
        rates = _rates(states, forward, regime, branch, law)
        states[:, PRECESSION:] = y[PRECESSION:] + dt * (INTEGRAL @ rates)[:, PRECESSION:]
    return states


def _matrix(states, forward, regime, branch, law, dt):
    """Return 1 - dt INTEGRAL d(rates)/d(states) up to PRECESSION; slopes by complex steps, which cancel nothing."""
    n, k = len(states), PRECESSION
    tilted = states + 1j * COMPLEX_STEP * np.eye(k, states.shape[1])[:, None, :]
    rates = _rates(tilted.reshape(k * n, -1), forward, regime, branch, law)[:, :k]
    slopes = rates.imag.reshape(k, n, k) / COMPLEX_STEP
    return np.eye(n * k) - dt * np.einsum("ij,bja->iajb", INTEGRAL, slopes).reshape(n * k, n * k)


def _guards(y, forward, regime, branch, law, r_end):
    """Return the guards at states y (k, ...) by name, grip first: it is negative where the slip runs back."""
    slip, (c, s) = _slip(y, forward)
    contact = ARRAY.contact_along(y, slip, (c, s), branch, regime.senses, law)
    grip = {"grip": y[V1] * c + y[V2] * s - REST}
    return grip | {**ARRAY.guards(y, contact, branch, regime.senses, law, r_end), **grip}


def _powers(y, states, forward, regime, branch, law, dt):
    """Return the Taylor coefficients (ORDER + 1, k) of the polynomial through the collocated rates."""
    rates = TO_POWERS @ _rates(states, forward, regime, branch, law)
    return np.vstack([y, dt ** (-POWERS[:, None].astype(float)) * rates / (POWERS[:, None] + 1)])
