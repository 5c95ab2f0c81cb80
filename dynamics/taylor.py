"""The flow by heyoka's adaptive Taylor integrator, with every root of every guard in a step."""

from concurrent.futures import ThreadPoolExecutor
from copy import deepcopy
from functools import lru_cache

import heyoka
import numpy as np

from dynamics.dissipation import Resistance
from dynamics.equations import Law
from dynamics.film.wedge import Film, find_film
from dynamics.guards import Guard
from dynamics.hybrid import Arc
from dynamics.integrators.branch_formulas import formulas, prepared, shape
from dynamics.regime import Branch, Flow, Regime
from dynamics.rolling import restarted
from dynamics.switching import reversal

SYMBOLIC = Flow(heyoka.sin, heyoka.cos, heyoka.sqrt, lambda base, exponent: base**exponent)
STATE = ("r", "w1", "w2", "w3", "v1", "v2", "precession", "spin", "x", "y", "dissipated")
# warnings would go to standard output, which is for results; the checks assess each run
heyoka.set_logger_level_error()
SUCCESS, NOT_FINITE = heyoka.taylor_outcome.success, heyoka.taylor_outcome.err_nf_state
MOST_STEPS = 1000
MOST_COMPILED = 64
"""Number of branches kept in compiled form; one scene needs about a tenth of them."""
SHORT = 1e-11
"""Smallest tolerance at which a Taylor series has at most 14 terms."""
LIFT = 1e-300
"""Offset added to every guard: if a guard is exactly zero at the start of a step, heyoka finds this
root and misses the next one."""


class Compiled:
    """The compiled integrator of one branch; each run borrows a copy to hold its state.

    heyoka caches compiled code on disk, so the most frequent branches are compiled for speed:
    rolling in a vacuum, and all branches in an air film. Compact mode compiles six times faster,
    but the code runs at half the speed. It is used for branches in which a rotation sticks, for
    branches with other loads, and for slides in a vacuum at tolerances below SHORT; series of few
    terms compile quickly."""

    def __init__(self, branch: Branch, tolerance: float):
        y = heyoka.make_vars(*STATE)
        rates, guards = formulas(SYMBOLIC, y, branch, lambda i: heyoka.par[i])
        falling = heyoka.event_direction.negative
        self.guards = tuple(guards)
        self._idle = []
        self._integrator = heyoka.taylor_adaptive(
            [
                (a, heyoka.expression(b) if isinstance(b, float) else b)
                for a, b in zip(y, rates, strict=True)
            ],
            [1.0] * len(y),
            tol=tolerance,
            compact_mode=any(branch.stuck)
            or not is_common(branch.loads)
            or (branch.sliding and not branch.loads and tolerance < SHORT),
            opt_level=1,  # same instructions as level 2, in 5/6 of the time
            t_events=[heyoka.t_event(g + LIFT, direction=falling) for g in guards.values()],
        )

    def borrow(self):
        """Return an idle integrator, with views of its parameters, state and last Taylor series."""
        try:
            return self._idle.pop()
        except IndexError:
            own = deepcopy(self._integrator)
            return own, own.pars, own.state, own.tc

    def guard(self, outcome) -> Guard | None:
        """Return the guard that ended a run, or None; heyoka encodes guard i as -i - 1, above its
        code for success."""
        return self.guards[-int(outcome) - 1] if int(outcome) > int(SUCCESS) else None

    def give_back(self, borrowed) -> None:
        """Take back an integrator returned by `borrow`."""
        self._idle.append(borrowed)


def is_common(loads) -> bool:
    """Return True if the loads are none, or an air film with or without a Resistance."""
    laws = getattr(loads, "laws", (loads,))
    return loads is None or (
        bool(find_film(loads)) and all(isinstance(law, Film | Resistance) for law in laws)
    )


_compilers = ThreadPoolExecutor(thread_name_prefix="heyoka")


@lru_cache(MOST_COMPILED)
def compiled(branch: Branch, tolerance: float):
    """Return the future of a `Compiled`; heyoka compiles in the background, without Python's
    lock."""
    return _compilers.submit(Compiled, branch, tolerance)


def compile_in_background(regime: Regime, law: Law, loads, tolerance: float) -> None:
    """Start to compile the flow of a regime."""
    compiled(shape(regime, law, loads), tolerance)


def advance(y, regime: Regime, law: Law, loads, r_end: float, span: float, tolerance: float) -> Arc:
    """Integrate from y within `regime` until a guard falls through zero, for `span`, or for
    MOST_STEPS steps.

    Rolling continues through rotations that only reverse. DOP853 integrates the arc if a law is not
    analytic, such as a power of the precession at rest. Safe to call from several threads at once.
    Raises StalledError if the steps of DOP853 are too short."""
    future, parameters = prepared(compiled, regime, law, loads, r_end, tolerance)
    flow = future.result()
    integrator, pars, state, series = borrowed = flow.borrow()
    pars[:] = parameters
    state[:] = y
    start = y
    integrator.time = 0.0
    integrator.reset_cooldowns()
    branch = Branch.of(regime, law, loads)
    now = regime
    guard = None
    step = integrator.step
    t = 0.0
    times = []
    kept = []
    passed = []
    lost = [[0.0] * len(STATE)]
    for _ in range(MOST_STEPS):
        outcome, _ = step(span - t, True)
        since = t
        t = integrator.time
        times.append(t)
        kept.append(series.tobytes())  # faster than a copy into an array
        if outcome == SUCCESS:
            continue
        guard = flow.guard(outcome)
        after = guard and t > since and reversal(state.tolist(), now, branch, guard, law)
        if not after:
            break
        y, now = after
        state[:], origin = restarted(y)  # large components would make the steps longer
        lost.append(origin)
        pars[:] = prepared(compiled, now, law, loads, r_end, tolerance)[1]
        integrator.reset_cooldowns()
        passed.append((len(times), guard, now))
        guard = None
    coefficients = np.frombuffer(bytearray().join(kept)).reshape(-1, *series.shape).swapaxes(1, 2)
    if passed:
        origins = np.cumsum(lost, axis=0)
        pieces = np.diff([0, *(n for n, *_ in passed), len(times)])
        coefficients[:, 0] += np.repeat(origins, pieces, axis=0)
        state += origins[-1]
    end = state.tolist()
    flow.give_back(borrowed)
    if outcome == NOT_FINITE:
        from dynamics.integrators import dop853  # numba loads slowly

        return dop853.advance(start, regime, law, loads, r_end, span, tolerance)
    return Arc(np.array(times), coefficients, end, guard, tuple(passed))
