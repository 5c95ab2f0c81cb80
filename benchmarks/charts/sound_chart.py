"""Chart the error of the pressure against processor time for methods that integrate
oscillators.

Only the time of the integration is measured. All methods use samples of the same force,
at a higher rate if they are oversampled. The pressures are compared at 48 kHz."""

from functools import cache, partial

import numpy as np
from numba import njit

from benchmarks.cases.sound_case import SAMPLE_RATE, SoundCase, sound_case
from benchmarks.charts.chart_page import milliseconds, number
from benchmarks.methods.oscillator_steps import STEPS, explicit_euler, matrices
from benchmarks.timed_runs import (
    Answer,
    Failure,
    Record,
    Work,
    measure,
    measured,
    most_accurate,
)
from sonify.sound.oscillators import OscillatorBank

PROBLEM = r"""
A force excites modes of angular frequency $\omega_m$ and decay rate $d_m$, which radiate by their accelerations,

$$\ddot q_m + 2 d_m \dot q_m + \omega_m^2 q_m = g(t), \qquad p(t) = \sum_m a_m \ddot q_m(t),$$

from rest, for one second. The force is *smooth*, or it has *jumps* between the samples, as at the transitions between
rolling and sliding. The reference is the closed form. Oversampled methods read the force at a higher sample rate.
"""
OUR_METHOD = "exact, first-order hold, jumps between samples"
PLAIN_EXACT_METHOD = "exact, first-order hold"

MAX_PROOF_ERROR = 2e-3
"""Largest error accepted in the proof for an oversampled second-order method on the
smooth force."""

PROOF_OVERSAMPLING = 64
"""Oversampling factor of the proof."""

MAX_GROWTH = 1e3
"""Ratio of the largest pressure to the exact one above which a method counts as
unstable."""


def pressure(case: SoundCase, method: str, factor: int) -> Answer:
    """Return the pressure (k,) [Pa] at SAMPLE_RATE by a method that steps at `factor`
    times that rate.

    Raises Failure if the pressure grows without limit.
    """
    g = _samples(case.name, factor)
    h = 1 / (factor * SAMPLE_RATE)
    if method == OUR_METHOD:
        bank = OscillatorBank(
            case.omega / (2 * np.pi), case.decay, factor * SAMPLE_RATE
        )
        bank.set_steady_state(np.zeros(len(case.omega)))
        heard = (
            bank.advance(g, case.knots(factor * SAMPLE_RATE))[::factor] @ case.radiated
        )
    else:
        table = np.ascontiguousarray(matrices(STEPS[method], case.omega, case.decay, h))
        heard = _run(g, table, case.omega**2, 2 * case.decay, factor) @ case.radiated
    if (
        not np.isfinite(heard).all()
        or np.abs(heard).max() > MAX_GROWTH * np.abs(case.exact).max()
    ):
        raise Failure("blows up")
    return Answer(heard, len(g) - 1)


@njit
def _run(g, table, stiffness, damping, factor):
    """Step from rest through the samples g (k + 1, m); return q'' (k // factor, m) at
    every `factor`-th sample."""
    q = np.zeros(g.shape[1])
    v = np.zeros(g.shape[1])
    out = np.empty(((g.shape[0] - 1) // factor, g.shape[1]))
    for n in range(g.shape[0] - 1):
        for m in range(g.shape[1]):
            if n % factor == 0:
                out[n // factor, m] = g[n, m] - stiffness[m] * q[m] - damping[m] * v[m]
            q1 = (
                table[0, 0, m] * q[m]
                + table[0, 1, m] * v[m]
                + table[0, 2, m] * g[n, m]
                + table[0, 3, m] * g[n + 1, m]
            )
            v1 = (
                table[1, 0, m] * q[m]
                + table[1, 1, m] * v[m]
                + table[1, 2, m] * g[n, m]
                + table[1, 3, m] * g[n + 1, m]
            )
            q[m] = q1
            v[m] = v1
    return out


CASES = {"smooth force": False, "force with jumps": True}
"""Name of each case, and whether its force has jumps."""


@cache
def case_of(name: str) -> SoundCase:
    """Return the case of one second with this name."""
    return sound_case(name, 1.0, CASES[name])


@cache
def _samples(name, factor):
    return case_of(name).samples(factor * SAMPLE_RATE)


def error(name: str, heard) -> float:
    """Return the rms of the difference from the exact pressure, divided by the rms of
    the exact pressure."""
    exact = case_of(name).exact
    return float(np.sqrt(np.mean((heard - exact) ** 2) / np.mean(exact**2)))


def work(name: str, method: str, factor: int) -> Work:
    """Return the run of a method that steps at `factor` times SAMPLE_RATE."""
    family = "exact" if method.startswith("exact") else "approximate"
    call = partial(pressure, case_of(name), method, factor)
    return Work(
        family,
        method,
        f"{factor} x {SAMPLE_RATE} Hz",
        name,
        call,
        partial(error, name),
        max_error=1.0,
    )


def prove() -> list[Record]:
    """Raise ArithmeticError if a method does not solve the same equation.

    With oversampling, stable methods must agree with the exact pressure. Explicit Euler
    is unstable at all practical sample rates, so only one short step must agree with
    the exact step to second order."""
    stable_methods = [m for m in (*STEPS, OUR_METHOD) if m != "explicit Euler"]
    records = [
        measure(work("smooth force", m, PROOF_OVERSAMPLING)) for m in stable_methods
    ]
    wrong = [
        f"{r.method}: {r.failure or r.error}"
        for r in records
        if not r.error <= MAX_PROOF_ERROR * _error_allowance(r.method)
    ]
    wrong += (
        []
        if _agrees_in_a_short_step(explicit_euler)
        else ["explicit Euler: another step"]
    )
    if wrong:
        raise ArithmeticError(
            f"not the same pressure on a smooth force: {'; '.join(wrong)}"
        )
    return records


def _agrees_in_a_short_step(step, short=1e-4) -> bool:
    """Return True if a step with w h = short under a steady force differs from the
    exact step by less than short^2."""
    tables = [
        matrices(one, np.ones(1), np.full(1, 0.01), short)
        for one in (step, STEPS[PLAIN_EXACT_METHOD])
    ]
    difference = (tables[0] - tables[1]) @ np.ones(1)
    return bool(
        np.abs([*difference[:, :2].T, difference[:, 2:].sum(axis=1)]).max() < short**2
    )


def _error_allowance(method):
    """Return the factor on the allowed error, which is larger for methods of first
    order."""
    return 50 if "zero" in method or "invariant" in method or "Euler" in method else 1


def run(quick: bool, watch=lambda fraction, note: None) -> list[Record]:
    """Return the records of the chart; `watch(fraction, note)` is called before every
    run."""
    prove()
    factors = (1, 4) if quick else (1, 2, 4, 8, 16, 32)
    runs = [
        work(name, m, k)
        for name in CASES
        for m in (*STEPS, OUR_METHOD)
        for k in factors
    ]
    return measured(runs, watch, warm=lambda work: True)


def conclusion(records: list[Record]) -> list[str]:
    """Return two sentences per case on the best method at 48 kHz and the most accurate
    approximate method."""
    lines = []
    for case in dict.fromkeys(r.case for r in records):
        best = most_accurate(records, case=case, setting=f"1 x {SAMPLE_RATE} Hz")
        lines.append(
            f"{case}: use {best.method}; at {SAMPLE_RATE} Hz its error is {number(best.error)} in "
            f"{milliseconds(best)}."
        )
        if other := most_accurate(records, case=case, family="approximate"):
            lines.append(
                f"{case}: the most accurate textbook method is {other.method}, oversampled to "
                f"{other.setting}: "
                f"{number(other.error)} in {milliseconds(other)}, "
                f"{other.seconds / best.seconds:.0f} times as long."
            )
    return lines
