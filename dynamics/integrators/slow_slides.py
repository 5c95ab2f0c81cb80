"""Implicit steps of high order for a slide so slow that its direction is stiff.

The slip direction relaxes at a rate of friction over slip speed. Where the slip speed hardly
changes meanwhile, as after a start without acceleration (mu_dynamic = mu_static), explicit steps of
any order would have to be as short. With the slip in polar coordinates that direction alone is
stiff. The slow solution is smooth through rest, if beyond it the speed counts as negative: so the
end of a slide is found."""

import math

import numpy as np

from dynamics.guards import GRIP, LIFT_OFF, guard_of
from dynamics.hybrid import Arc, StalledError
from dynamics.integrators.branch_formulas import prepared
from dynamics.integrators.codegen import compiled, machine
from dynamics.integrators.gauss_collocation import MOST_STEPS, REST, STEPS, integrate
from dynamics.regime import V1, V2, Flow, R, describe

REVERSAL = guard_of("nutation reverses")


class Polar(Flow):
    """The flow with the slip in polar coordinates: its signed speed over r at V1 of a state, its
    direction at V2.

    The rate of the direction is that of the direction times the speed, which is not singular at
    rest."""

    def contact(self, y, branch, senses, law):
        """Solve the balance laws at state y."""
        along, across = direction = self.cos(y[V2]), self.sin(y[V2])
        speed = y[R] * y[V1]
        return self.contact_along(
            y, (speed * along, speed * across), direction, branch, senses, law
        )

    def rates(self, y, contact, branch, law):
        """Return dy/dtau from the solved contact."""
        along = self.cos(y[V2])
        across = self.sin(y[V2])
        rates = super().rates(
            [*y[:V1], y[V1] * along, y[V1] * across, *y[V2 + 1 :]], contact, branch, law
        )
        dv1 = rates[V1]
        dv2 = rates[V2]
        rates[V1] = dv1 * along + dv2 * across
        rates[V2] = dv2 * along - dv1 * across
        return rates

    def grip(self, y):
        """Return the guard of a slide that comes to rest slowly."""
        return y[V1] - REST


def polar(branch):
    """Return the compiled flow of a slow slide, the names of its guards, and the numbers of grip,
    lift-off and the reversal of nutation, -1 where there is none."""
    flow, names = compiled(branch, Polar)
    return (
        flow,
        names,
        names.index(GRIP),
        names.index(LIFT_OFF),
        names.index(REVERSAL) if REVERSAL in names else -1,
    )


def advance(y, regime, law, loads, r_end, span) -> Arc | None:
    """Integrate a stiff slide until a guard falls, for `span`, until it is stiff no more, or for
    MOST_STEPS steps.

    It goes on through plain reversals of the nutation. None where it is not stiff, or no length
    down to SHORTEST converges. Safe to call from several threads at once."""
    speed = math.hypot(y[V1], y[V2])
    direction = math.atan2(y[V2], y[V1])
    arc = _integrated(y, speed, direction, regime, law, loads, r_end, span, MOST_STEPS)
    return arc if len(arc.times) else None


def graze(y, nu, regime, law, loads, r_end, most) -> Arc | None:
    """Integrate a slide that starts from rest along nu without a push, as `advance` does, for at
    most `most` steps.

    None where the slip comes back to rest before it has the speed that ends a slide: then there is
    no slide to follow. Raises StalledError where no length down to SHORTEST converges."""
    arc = _integrated(y, 0.0, nu, regime, law, loads, r_end, math.inf, most)
    if not len(arc.times) and arc.guard is None:
        raise StalledError(f"{describe(y)}: the slide that starts here could not be followed")
    return arc if len(arc.times) else None


def _integrated(y, speed, direction, regime, law, loads, r_end, span, most):
    (flow, names, *of), parameters = prepared(polar, regime, law, loads, r_end)
    start = np.array([*y[:V1], speed, direction, *y[V2 + 1 :]])
    times, powers, end, fired, turns = machine(integrate, STEPS)(
        flow, start, parameters, len(names), *of, law.mu_dynamic, span, most
    )
    guard = names[fired] if fired >= 0 else None
    passed = []
    for steps in turns.tolist():
        sense, *others = regime.senses
        regime = regime._replace(senses=(-sense, *others))
        passed.append((steps, REVERSAL, regime))
    return Arc(times, powers, end.tolist(), guard, tuple(passed))
