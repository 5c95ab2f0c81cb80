"""Integration by heyoka's adaptive Taylor method, which finds every root of the guards."""

import sys
from concurrent.futures import ThreadPoolExecutor
from copy import deepcopy
from functools import lru_cache
from importlib import import_module
from typing import TYPE_CHECKING, Any

import numpy as np

from dynamics.dissipation import Resistance, laws_of
from dynamics.equations import DiskConstants
from dynamics.film.wedge import Film, find_film
from dynamics.guards import Guard
from dynamics.hybrid import MAX_STEPS_PER_ARC, Arc
from dynamics.integrators.branch_formulas import (
    branch_to_compile,
    compiled_flow_and_constants,
    rates_and_guards,
)
from dynamics.regime import (
    Branch,
    FlowFormulas,
    Regime,
    StateVector,
    restart_quadratures,
)
from dynamics.switching import state_after_reversal

if TYPE_CHECKING:
    from concurrent.futures._base import Future


def _import_heyoka() -> Any:
    """Import heyoka as if its optional dependency SymPy were not installed.

    SymPy takes longer to import than heyoka itself; only conversions between the two
    need it.
    """
    if "sympy" in sys.modules:
        return import_module("heyoka")
    sys.modules["sympy"] = None  # type: ignore[assignment]
    try:
        return import_module("heyoka")
    finally:
        del sys.modules["sympy"]


heyoka = _import_heyoka()
SYMBOLIC_FORMULAS = FlowFormulas(
    heyoka.sin, heyoka.cos, heyoka.sqrt, lambda base, exponent: base**exponent
)
STATE_SYMBOLS = (
    "r",
    "w1",
    "w2",
    "w3",
    "v1",
    "v2",
    "precession",
    "spin",
    "x",
    "y",
    "dissipated",
)
"""Names of the components of the state in the expressions of heyoka, in their order."""
# heyoka would write warnings to standard output, which is reserved for results
heyoka.set_logger_level_error()
SUCCESS = heyoka.taylor_outcome.success
NOT_FINITE = heyoka.taylor_outcome.err_nf_state


class CompiledTaylor:
    """The compiled integrator of one branch; each run borrows a copy for its own state.

    Compact mode compiles six times faster, but the code runs at half the speed. It is
    used for rare branches: those with a sticking rotation, those with loads other than
    an air film, and slides in a vacuum at tolerances below
    `min_short_series_tolerance`, at which series are long. heyoka caches the code of
    all branches on disk.
    """

    def __init__(self, branch: Branch, tolerance: float) -> None:
        # smallest tolerance for which a Taylor series has at most 14 terms
        min_short_series_tolerance = 1e-11
        y = heyoka.make_vars(*STATE_SYMBOLS)
        rates, guards = rates_and_guards(
            SYMBOLIC_FORMULAS, y, branch, lambda i: heyoka.par[i]
        )
        falling = heyoka.event_direction.negative
        self.guards = tuple(guards)
        self._idle: list[Any] = []
        self._integrator = heyoka.taylor_adaptive(
            [
                (a, heyoka.expression(b) if isinstance(b, float) else b)
                for a, b in zip(y, rates, strict=True)
            ],
            [1.0] * len(y),
            tol=tolerance,
            compact_mode=any(branch.stuck)
            or not has_standard_loads_only(branch.loads)
            or (
                branch.sliding
                and not branch.loads
                and tolerance < min_short_series_tolerance
            ),
            opt_level=1,  # same instructions as level 2, in 5/6 of the compilation time
            # without the offset, heyoka would find a root at the start of a step and
            # miss the next one
            t_events=[
                heyoka.t_event(g + 1e-300, direction=falling) for g in guards.values()
            ],
        )

    def borrow(self) -> tuple[Any, np.ndarray, np.ndarray, np.ndarray]:
        """Return an idle integrator and its parameters, state and Taylor series."""
        try:
            return self._idle.pop()
        except IndexError:
            own = deepcopy(self._integrator)
            return own, own.pars, own.state, own.tc

    def guard(self, outcome: Any) -> Guard | None:
        """Return the guard for an outcome, or None; guard i has the code -i - 1."""
        return self.guards[-int(outcome) - 1] if int(outcome) > int(SUCCESS) else None

    def give_back(
        self, borrowed: tuple[Any, np.ndarray, np.ndarray, np.ndarray]
    ) -> None:
        """Return an integrator that was obtained from `borrow`."""
        self._idle.append(borrowed)


def has_standard_loads_only(loads: Any) -> bool:
    """Return True if there are no loads, or only an air film and perhaps a Resistance."""
    return loads is None or (
        bool(find_film(loads))
        and all(isinstance(law, Film | Resistance) for law in laws_of(loads))
    )


_compilers = ThreadPoolExecutor(thread_name_prefix="heyoka")


@lru_cache(64)  # one scene needs about a tenth of them
def compiled_taylor_future(branch: Branch, tolerance: float) -> "Future[Any]":
    """Return the Future of a `CompiledTaylor`; heyoka releases the GIL to compile it."""
    return _compilers.submit(CompiledTaylor, branch, tolerance)


def compile_in_background(
    regime: Regime, constants: DiskConstants, loads: Any, tolerance: float
) -> None:
    """Start a background thread that compiles the flow of a regime."""
    compiled_taylor_future(branch_to_compile(regime, constants, loads), tolerance)


def advance(
    y: StateVector,
    regime: Regime,
    constants: DiskConstants,
    loads: Any,
    r_end: float,
    span: float,
    tolerance: float,
) -> Arc:
    """Integrate from y within `regime` until a guard falls, for at most `span`.

    It takes at most MAX_STEPS_PER_ARC steps and is thread-safe. A rolling disk
    continues through simple reversals of a rotation. DOP853 replaces the Taylor method
    if a law is not analytic, for example a power law where the precession stops; it
    raises StalledError if its steps are too short.
    """
    flow, parameters = _flow_and_constants(regime, constants, loads, r_end, tolerance)
    borrowed = flow.borrow()
    integrator, pars, state, series = borrowed
    pars[:] = parameters[: len(pars)]  # some branches do not use the last ones
    state[:] = y
    integrator.time = 0.0
    integrator.reset_cooldowns()
    now = regime
    guard = None
    t = 0.0
    times = []
    kept = []
    regime_changes: list[tuple[int, Any, Regime]] = []
    lost = [[0.0] * len(STATE_SYMBOLS)]
    for _ in range(MAX_STEPS_PER_ARC):
        outcome = integrator.step(span - t, True)[0]
        since = t
        t = integrator.time
        times.append(t)
        kept.append(series.tobytes())  # faster than copying to an array
        if outcome == SUCCESS:
            continue
        guard = flow.guard(outcome)
        after = (
            guard
            and t > since
            and state_after_reversal(
                state.tolist(),
                now,
                Branch.of(regime, constants, loads),
                guard,
                constants,
            )
        )
        if not after:
            break
        now = after[1]
        # large components would make the steps longer
        state[:], origin = restart_quadratures(after[0], constants.bowl > 0)
        lost.append(origin)
        parameters = compiled_flow_and_constants(
            compiled_taylor_future, now, constants, loads, r_end, tolerance
        )[1]
        pars[:] = parameters[: len(pars)]
        integrator.reset_cooldowns()
        regime_changes.append((len(times), guard, now))
        guard = None
    coefficients = np.frombuffer(bytearray().join(kept)).reshape(-1, *series.shape)
    coefficients = coefficients.swapaxes(1, 2)
    if regime_changes:
        state += _add_origins(coefficients, lost, regime_changes)
    end = state.tolist()
    flow.give_back(borrowed)
    if outcome == NOT_FINITE:
        from dynamics.integrators import dop853  # numba loads slowly

        return dop853.advance(y, regime, constants, loads, r_end, span, tolerance)
    return Arc(np.array(times), coefficients, end, guard, tuple(regime_changes))


def _flow_and_constants(
    regime: Regime,
    constants: DiskConstants,
    loads: Any,
    r_end: float,
    tolerance: float,
) -> tuple[CompiledTaylor, np.ndarray]:
    """Return the compiled flow of a regime, after waiting for it, and its constants."""
    future, parameters = compiled_flow_and_constants(
        compiled_taylor_future, regime, constants, loads, r_end, tolerance
    )
    return future.result(), parameters


def _add_origins(
    coefficients: np.ndarray,
    lost: list[list[float]],
    regime_changes: list[tuple[int, Any, Regime]],
) -> np.ndarray:
    """Add the offsets `lost` at changes of regime to coefficients (n, ORDER + 1, k).

    Returns the sum of all offsets (k,).
    """
    origins = np.cumsum(lost, axis=0)
    pieces = np.diff([0, *(n for n, *_ in regime_changes), len(coefficients)])
    coefficients[:, 0] += np.repeat(origins, pieces, axis=0)
    return origins[-1]
