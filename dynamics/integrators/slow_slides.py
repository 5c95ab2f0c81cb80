"""Implicit high-order integration of slow slides, in which the slip direction is stiff.

The slip direction relaxes at a rate equal to friction divided by slip speed. If the
slip speed hardly changes during this relaxation, for example after a start without
acceleration (mu_dynamic = mu_static), explicit steps of any order would have to be as
short as the relaxation time. In polar coordinates of the slip, only the direction is
stiff. If the speed may become negative, the solution is smooth through rest, which
locates the end of a slide.
"""

import math
from typing import TYPE_CHECKING, Any

import numpy as np

from dynamics.guards import GRIP, LIFT_OFF, Guard, guard_named
from dynamics.hybrid import Arc, StalledError
from dynamics.integrators.branch_formulas import compiled_flow_and_constants
from dynamics.integrators.codegen import compile_branch, compiled_function
from dynamics.integrators.gauss_collocation import (
    INTEGRATE_SIGNATURE,
    REST_SLIP_SPEED,
    GuardIndices,
    integrate_slow_slide,
)
from dynamics.regime import (
    V1,
    V2,
    Branch,
    FlowFormulas,
    R,
    Regime,
    StateVector,
    describe_state,
)

if TYPE_CHECKING:
    from dynamics.equations import ContactSolution, DiskConstants, NumberOrExpression

NUTATION_REVERSAL = guard_named("nutation reverses")
MAX_SLIDE_STEPS = 40
"""Largest number of steps in one arc of a slow slide."""


class PolarSlipFormulas(FlowFormulas):
    """Equations of motion with the slip in polar coordinates.

    The state contains the signed slip speed divided by r at V1, and the slip direction
    at V2. The rate at V2 is that of the direction times the speed, which is regular at
    rest.
    """

    def contact(
        self, y: StateVector, branch: Branch, senses: Any, constants: "DiskConstants"
    ) -> "ContactSolution":
        """Solve the balance laws at state y with its slip direction."""
        along = self.cos(y[V2])
        across = self.sin(y[V2])
        speed = y[R] * y[V1]
        slip = (speed * along, speed * across)
        return self.contact_with_friction_along(
            y, slip, (along, across), branch, senses, constants
        )

    def rates(
        self,
        y: StateVector,
        contact: "ContactSolution",
        branch: Branch,
        constants: "DiskConstants",
    ) -> "list[NumberOrExpression]":
        """Return dy/dtau for the solved contact."""
        along = self.cos(y[V2])
        across = self.sin(y[V2])
        rates = super().rates(
            [*y[:V1], y[V1] * along, y[V1] * across, *y[V2 + 1 :]],
            contact,
            branch,
            constants,
        )
        dv1 = rates[V1]
        dv2 = rates[V2]
        rates[V1] = dv1 * along + dv2 * across
        rates[V2] = dv2 * along - dv1 * across
        return rates

    def excess_slip_speed(self, y: StateVector) -> "NumberOrExpression":
        """Return slip speed/r minus REST_SLIP_SPEED, the value of the guard GRIP."""
        return y[V1] - REST_SLIP_SPEED


def compile_polar_slip(branch: Branch) -> tuple[Any, tuple[Guard, ...], GuardIndices]:
    """Return the compiled flow of a slow slide, its guards, and their `GuardIndices`."""
    flow, names = compile_branch(branch, PolarSlipFormulas)
    indices = GuardIndices(
        len(names),
        names.index(GRIP),
        names.index(LIFT_OFF),
        names.index(NUTATION_REVERSAL) if NUTATION_REVERSAL in names else -1,
    )
    return flow, names, indices


def advance_slow_slide(
    y: StateVector,
    regime: Regime,
    constants: "DiskConstants",
    loads: Any,
    r_end: float,
    span: float,
) -> Arc | None:
    """Integrate a stiff slide until a guard falls, for at most `span`.

    It ends early if the slide is no longer stiff, and continues through clear reversals
    of the nutation. Returns None if the slide is not stiff at the start, or if no step
    length converges. The function is thread-safe.
    """
    speed = math.hypot(y[V1], y[V2])
    direction = math.atan2(y[V2], y[V1])
    slip = speed, direction
    arc = _integrate_slide(y, slip, regime, constants, loads, r_end, span)
    return arc if len(arc.times) else None


def advance_grazing_slide(
    y: StateVector,
    nu: float,
    regime: Regime,
    constants: "DiskConstants",
    loads: Any,
    r_end: float,
    single_step: bool,
) -> Arc | None:
    """Integrate a slide that starts along nu [rad] with almost no acceleration.

    Returns None if the slip speed returns to zero before it exceeds STOP_SLIP_SPEED,
    since the contact does not slide then. Raises StalledError if no step length
    converges.
    """
    max_steps = 1 if single_step else MAX_SLIDE_STEPS
    slip = 0.0, nu
    arc = _integrate_slide(
        y, slip, regime, constants, loads, r_end, math.inf, max_steps
    )
    if not len(arc.times) and arc.guard is None:
        raise StalledError(
            f"{describe_state(y)}: the slide that starts here cannot be integrated"
        )
    return arc if len(arc.times) else None


def _integrate_slide(
    y: StateVector,
    slip: tuple[float, float],
    regime: Regime,
    constants: "DiskConstants",
    loads: Any,
    r_end: float,
    span: float,
    max_steps: int = MAX_SLIDE_STEPS,
) -> Arc:
    """Integrate a slide with a slip speed and direction [rad] for a few steps."""
    (flow, names, indices), parameters = compiled_flow_and_constants(
        compile_polar_slip, regime, constants, loads, r_end
    )
    start = np.array([*y[:V1], *slip, *y[V2 + 1 :]])
    times, powers, end, fired, turns = compiled_function(
        integrate_slow_slide, INTEGRATE_SIGNATURE
    )(flow, start, parameters, indices, constants.mu_dynamic, span, max_steps)
    guard = names[fired] if fired >= 0 else None
    regime_changes = []
    for steps in turns.tolist():
        nutation, axial, in_plane = regime.senses
        regime = regime._replace(senses=(-nutation, axial, in_plane))
        regime_changes.append((steps, NUTATION_REVERSAL, regime))
    return Arc(times, powers, end.tolist(), guard, tuple(regime_changes))
