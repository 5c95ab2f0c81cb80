"""Implicit steps of high order for a slide so slow that its direction is stiff.

The slip direction relaxes at a rate of friction over slip speed. Where the slip speed hardly changes meanwhile, as
after a start without acceleration (mu_dynamic = mu_static), explicit steps of any order would have to be as short.
The slow solution is smooth through rest, if beyond it the speed counts as negative: so the end of a slide is found.
"""

import math

import numpy as np

from .hybrid import Arc, StalledError, Step
from .implicit_steps import FORWARD, LENGTH, NODES, ORDER, SHORTEST, STEP, STEPS, collocate, integrate
from .regime import FLOAT, STOP_SPEED, V1, V2, Branch, Flow, R, describe
from .runge_kutta import GUARDS
from .symbolic import constants, shape
from .trace import compiled, machine

REST = 1e-13
"""Slip speed over r at which a slow slide is at rest: there it is too slow for a last step along its tangent."""


class Onward(Flow):
    """The flow continued through rest: a slip that runs against the last two of a state has a negative speed."""

    FUNCTIONS, SIZE = (*Flow.FUNCTIONS, "copysign"), FORWARD + 2

    def __init__(self, *functions):
        super().__init__(*functions[:-1])
        self.copysign = functions[-1]

    def speed(self, y):
        """Return the signed slip speed over r."""
        return self.copysign(super().speed(y), y[V1] * y[FORWARD] + y[V2] * y[FORWARD + 1])

    def grip(self, y):
        """Return the guard of a slide that comes to rest slowly."""
        return self.speed(y) - REST


def _prepared(regime, law, loads, r_end):
    """Return the compiled flow of a slow slide, the names of its guards, and its constants (n,)."""
    flow, names = compiled(shape(regime, law, loads), Onward)
    return flow, names, np.array(constants(regime, law, loads, r_end))


def grazing_step(y, nu, first, regime, law, loads) -> Step | None:
    """Return the first step of a slide from rest along nu, of a length on which every guard stays positive.

    None where the slip comes back to rest before it has the speed that ends a slide: then there is no slide to follow.
    Raises StalledError where no length down to SHORTEST converges.
    """
    flow, names, parameters = _prepared(regime, law, loads, 0.0)
    start, dt, grip = np.array([*y, math.cos(nu), math.sin(nu)]), LENGTH * y[R], names.index("grip")
    others = [i for i in range(len(names)) if i != grip]
    while dt > SHORTEST * y[R]:
        guards = np.ones((ORDER + 1, GUARDS))
        guess = _at_rest(start, first, regime, law, loads, dt)
        c, error = machine(collocate.py_func, STEP)(flow, parameters, guess, start, dt, guards)
        if error < 1 and guards[:, others].min() > 0 and guards[:, grip].min() > -REST:
            powers = c[:, :FORWARD] / dt ** np.arange(ORDER + 1.0)[:, None]
            return Step(regime, dt, powers) if guards[-1, grip] > STOP_SPEED else None
        dt /= 2
    raise StalledError(f"{describe(y)}: the slide that starts here could not be followed")


def _at_rest(start, first, regime, law, loads, dt):
    """Return states at the nodes with a slip that starts at rest and gains speed at a rate that grows."""
    y, direction, branch = start[:FORWARD], start[FORWARD:], Branch.of(regime, law, loads)
    states = np.tile(start, (ORDER, 1))
    states[:, :FORWARD] += dt * NODES[:, None] * np.array(FLOAT.rates(y.tolist(), first, branch, law))
    states[:, V1 : V2 + 1] = 0.0
    later = FLOAT.contact_along(states[-1].tolist(), (0.0, 0.0), tuple(direction), branch, regime.senses, law)
    push = np.array([first.du1, first.du2]) @ direction
    growth = np.array([later.du1, later.du2]) @ direction - push
    speed = dt * NODES * push + dt * NODES**2 * growth / (2 * NODES[-1])
    states[:, V1 : V2 + 1] = speed[:, None] * direction / y[R]
    return states


def advance(y, regime, law, loads, r_end, span, tolerance) -> Arc:
    """Integrate a stiff slide until a guard falls, for `span`, until it is stiff no more, or for MOST_STEPS steps.

    Safe to call from several threads at once. Raises StalledError where no length down to SHORTEST converges.
    """
    flow, names, parameters = _prepared(regime, law, loads, r_end)
    start, of = np.array([*y, y[V1], y[V2]]), (names.index("grip"), names.index("lift-off"))
    times, powers, end, fired = machine(integrate, STEPS)(
        flow, start, parameters, len(names), *of, law.mu_dynamic, span
    )
    if not len(times):
        raise StalledError(f"{describe(y)}: the slow slide could not be followed")
    return Arc(times, powers[..., :FORWARD], end[:FORWARD].tolist(), names[fired] if fired >= 0 else None)
