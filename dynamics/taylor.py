"""The flow by heyoka's adaptive Taylor integrator: steps of high order, and every root of every guard within a step."""

import functools

import heyoka
import numpy as np

from .equations import Law
from .hybrid import Arc
from .regime import Branch, Flow, Regime

SYMBOLIC = Flow(heyoka.sin, heyoka.cos, heyoka.sqrt, lambda base, exponent: base**exponent)
STATE = ("r", "w1", "w2", "w3", "v1", "v2", "precession", "spin", "x", "y", "dissipated")
MOST_STEPS = 1000
LIFT = 1e-300
"""Added to every guard: of one that is exactly zero where a step starts, heyoka finds that root and misses the next."""


@functools.cache
def compiled(branch: Branch, tolerance: float):
    """Compile the integrator of one branch, once a process; the numbers of a scene are its runtime parameters.

    heyoka keeps what it has compiled on disk, so the branches that every motion has are compiled for speed. The rare
    ones in which something sticks are compiled in compact mode, which is ready much sooner and runs a little slower.
    """
    y = heyoka.make_vars(*STATE)
    law = Law(*(heyoka.par[i] for i in range(len(Law._fields))))
    senses = tuple(heyoka.par[len(law) + i] for i in range(3))
    contact = SYMBOLIC.contact(y, branch, senses, law)
    rates = SYMBOLIC.rates(y, contact, branch, law)
    guards = SYMBOLIC.guards(y, contact, branch, senses, law, heyoka.par[len(law) + 3])
    falling = heyoka.event_direction.negative
    integrator = heyoka.taylor_adaptive(
        [(a, heyoka.expression(b) if isinstance(b, float) else b) for a, b in zip(y, rates, strict=True)],
        [1.0] * len(y),
        tol=tolerance,
        compact_mode=any(branch.stuck),
        opt_level=2,
        t_events=[heyoka.t_event(g + LIFT, direction=falling) for g in guards.values()],
    )
    return integrator, tuple(guards)


def advance(y, regime: Regime, law: Law, loads, r_end: float, span: float, tolerance: float) -> Arc:
    """Integrate from y within `regime` until a guard falls through zero, for `span`, or for MOST_STEPS steps."""
    integrator, names = compiled(Branch.of(regime, law, loads), tolerance)
    constants = (*law, *regime.senses, r_end)
    integrator.pars[:] = constants[: len(integrator.pars)]
    integrator.state[:] = y
    integrator.time = 0.0
    integrator.reset_cooldowns()
    times, coefficients, guard = [], [], None
    step, success, series = integrator.step, heyoka.taylor_outcome.success, integrator.tc  # a view of the last step's
    for _ in range(MOST_STEPS):
        outcome, _h = step(max_delta_t=span - integrator.time, write_tc=True)
        coefficients.append(series.copy())
        times.append(integrator.time)
        if outcome == success:
            continue
        if outcome != heyoka.taylor_outcome.time_limit:
            guard = names[-int(outcome) - 1]
        break
    return Arc(np.array(times), np.array(coefficients).swapaxes(1, 2), integrator.state.tolist(), guard)
