"""The flow by heyoka's adaptive Taylor integrator, with every root of every guard in a step."""

from concurrent.futures import ThreadPoolExecutor
from copy import deepcopy
from functools import lru_cache

import heyoka
import numpy as np

from dynamics.dissipation import Resistance
from dynamics.equations import DiskConstants
from dynamics.film.wedge import Film, find_film
from dynamics.guards import Guard
from dynamics.hybrid import Arc
from dynamics.integrators.branch_formulas import branch_to_compile, compiled_flow, rates_and_guards
from dynamics.regime import Branch, FlowFormulas, Regime
from dynamics.rolling import restart_quadratures
from dynamics.switching import after_reversal

SYMBOLIC_FORMULAS = FlowFormulas(
    heyoka.sin, heyoka.cos, heyoka.sqrt, lambda base, exponent: base**exponent
)
STATE_SYMBOLS = ("r", "w1", "w2", "w3", "v1", "v2", "precession", "spin", "x", "y", "dissipated")
# warnings would go to standard output, which is for results; the checks assess each run
heyoka.set_logger_level_error()
SUCCESS = heyoka.taylor_outcome.success
NOT_FINITE = heyoka.taylor_outcome.err_nf_state
MAX_STEPS_PER_CALL = 1000
MAX_COMPILED_BRANCHES = 64
"""Number of branches kept in compiled form; one scene needs about a tenth of them."""
MIN_SHORT_SERIES_TOLERANCE = 1e-11
"""Smallest tolerance at which a Taylor series has at most 14 terms."""
GUARD_OFFSET = 1e-300
"""Offset added to every guard: if a guard is exactly zero at the start of a step, heyoka finds this
root and misses the next one."""


class CompiledTaylor:
    """The compiled integrator of one branch; each run borrows a copy to hold its state.

    heyoka caches compiled code on disk, so the most frequent branches are compiled for speed:
    rolling in a vacuum, and all branches in an air film. Compact mode compiles six times faster,
    but the code runs at half the speed. It is used for branches in which a rotation sticks, for
    branches with other loads, and for slides in a vacuum at tolerances below MIN_SHORT_SERIES_TOLERANCE; series of few
    terms compile quickly."""

    def __init__(self, branch: Branch, tolerance: float):
        y = heyoka.make_vars(*STATE_SYMBOLS)
        rates, guards = rates_and_guards(SYMBOLIC_FORMULAS, y, branch, lambda i: heyoka.par[i])
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
            or not is_common_load(branch.loads)
            or (branch.sliding and not branch.loads and tolerance < MIN_SHORT_SERIES_TOLERANCE),
            opt_level=1,  # same instructions as level 2, in 5/6 of the time
            t_events=[heyoka.t_event(g + GUARD_OFFSET, direction=falling) for g in guards.values()],
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


def is_common_load(loads) -> bool:
    """Return True if the loads are none, or an air film with or without a Resistance."""
    laws = getattr(loads, "laws", (loads,))
    return loads is None or (
        bool(find_film(loads)) and all(isinstance(law, Film | Resistance) for law in laws)
    )


_compilers = ThreadPoolExecutor(thread_name_prefix="heyoka")


@lru_cache(MAX_COMPILED_BRANCHES)
def compiled_taylor(branch: Branch, tolerance: float):
    """Return the future of a `CompiledTaylor`; heyoka compiles in the background, without Python's
    lock."""
    return _compilers.submit(CompiledTaylor, branch, tolerance)


def compile_in_background(regime: Regime, law: DiskConstants, loads, tolerance: float) -> None:
    """Start to compile the flow of a regime."""
    compiled_taylor(branch_to_compile(regime, law, loads), tolerance)


def advance(
    y, regime: Regime, law: DiskConstants, loads, r_end: float, span: float, tolerance: float
) -> Arc:
    """Integrate from y within `regime` until a guard falls through zero, for `span`, or for
    MAX_STEPS_PER_CALL steps.

    Rolling continues through rotations that only reverse. DOP853 integrates the arc if a law is not
    analytic, such as a power of the precession at rest. Safe to call from several threads at once.
    Raises StalledError if the steps of DOP853 are too short."""
    future, parameters = compiled_flow(compiled_taylor, regime, law, loads, r_end, tolerance)
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
    lost = [[0.0] * len(STATE_SYMBOLS)]
    for _ in range(MAX_STEPS_PER_CALL):
        outcome, _ = step(span - t, True)
        since = t
        t = integrator.time
        times.append(t)
        kept.append(series.tobytes())  # faster than a copy into an array
        if outcome == SUCCESS:
            continue
        guard = flow.guard(outcome)
        after = guard and t > since and after_reversal(state.tolist(), now, branch, guard, law)
        if not after:
            break
        y, now = after
        state[:], origin = restart_quadratures(y)  # large components would make the steps longer
        lost.append(origin)
        pars[:] = compiled_flow(compiled_taylor, now, law, loads, r_end, tolerance)[1]
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
