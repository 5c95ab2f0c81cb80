"""The chart of the sound: error of the pressure against seconds, for the ways to step an oscillator.

The seconds are those of the stepping alone: every method reads the same samples of the force, and more of them where it
is oversampled. The pressure is compared at 48 kHz.
"""

from functools import cache, partial

import numpy as np
from numba import njit

from sonify.charts.page import milliseconds, number
from sonify.charts.records import Answer, Failure, Record, Work, measure, measured, nearest
from sonify.charts.sound_case import RATE, SoundCase, sound_case
from sonify.charts.steps import STEPS, explicit_euler, matrices
from sonify.sound.oscillators import OscillatorBank

PROBLEM = r"""
Modes of frequency $\omega_m$ and decay rate $d_m$ ring under a force and are heard through their accelerations,

$$\ddot q_m + 2 d_m \dot q_m + \omega_m^2 q_m = g(t), \qquad p(t) = \sum_m a_m \ddot q_m(t),$$

from rest, for a second: a *smooth force*, and a *force with jumps* between the samples, as the changes between rolling
and sliding make them. The reference is the closed form. Oversampled methods read the force more often.
"""
OURS = "exact, first-order hold, jumps between samples"
PLAIN = "exact, first-order hold"
PROOF, PROOF_FACTOR = 2e-3, 64
"""Error below which, so many times oversampled, a method is believed to solve the same equation (smooth force)."""
BLOWN_UP = 1e3
"""Error, relative to the signal, above which a method has blown up."""


def pressure(case: SoundCase, method: str, factor: int) -> Answer:
    """Return the pressure (k,) [Pa] at RATE by `method` at `factor` times that rate. Raises Failure where it grows."""
    g, h = _samples(case.name, factor), 1 / (factor * RATE)
    if method == OURS:
        bank = OscillatorBank(case.omega / (2 * np.pi), case.decay, factor * RATE)
        bank.settle(np.zeros(len(case.omega)))
        heard = bank.advance(g, case.knots(factor * RATE))[::factor] @ case.radiated
    else:
        table = np.ascontiguousarray(matrices(STEPS[method], case.omega, case.decay, h))
        heard = _run(g, table, case.omega**2, 2 * case.decay, factor) @ case.radiated
    if not np.isfinite(heard).all() or np.abs(heard).max() > BLOWN_UP * np.abs(case.exact).max():
        raise Failure("blows up")
    return Answer(heard, len(g) - 1)


@njit
def _run(g, table, stiffness, damping, factor):
    """Step from rest through the samples g (k + 1, m); return q'' (k // factor, m) at every `factor`-th sample."""
    q, v = np.zeros(g.shape[1]), np.zeros(g.shape[1])
    out = np.empty(((g.shape[0] - 1) // factor, g.shape[1]))
    for n in range(g.shape[0] - 1):
        for m in range(g.shape[1]):
            if n % factor == 0:
                out[n // factor, m] = g[n, m] - stiffness[m] * q[m] - damping[m] * v[m]
            q1 = table[0, 0, m] * q[m] + table[0, 1, m] * v[m] + table[0, 2, m] * g[n, m] + table[0, 3, m] * g[n + 1, m]
            v1 = table[1, 0, m] * q[m] + table[1, 1, m] * v[m] + table[1, 2, m] * g[n, m] + table[1, 3, m] * g[n + 1, m]
            q[m], v[m] = q1, v1
    return out


CASES = {"smooth force": False, "force with jumps": True}
DURATION = 1.0


@cache
def case_of(name: str) -> SoundCase:
    """Return a case of CASES."""
    return sound_case(name, DURATION, CASES[name])


@cache
def _samples(name, factor):
    return case_of(name).samples(factor * RATE)


def error(name: str, heard) -> float:
    """Return the rms of the difference from the exact pressure over that of the pressure."""
    exact = case_of(name).exact
    return float(np.sqrt(np.mean((heard - exact) ** 2) / np.mean(exact**2)))


def work(name: str, method: str, factor: int) -> Work:
    """Return the run of a method at `factor` times RATE."""
    family = "exact" if method.startswith("exact") else "approximate"
    call = partial(pressure, case_of(name), method, factor)
    return Work(family, method, f"{factor} x {RATE} Hz", name, call, partial(error, name), wrong=1.0)


def prove() -> list[Record]:
    """Raise ArithmeticError unless every method solves the same equation.

    Those that are stable anywhere must come near the exact pressure, oversampled; explicit Euler, which grows at any
    rate of samples that fits a memory, must agree with the exact step to the second order of a short one.
    """
    records = [measure(work("smooth force", m, PROOF_FACTOR)) for m in (*STEPS, OURS) if m != "explicit Euler"]
    wrong = [f"{r.method}: {r.failure or r.error}" for r in records if not r.error <= PROOF * _slack(r.method)]
    wrong += [] if _agrees_in_a_short_step(explicit_euler) else ["explicit Euler: another step"]
    if wrong:
        raise ArithmeticError(f"not the same pressure on a smooth force: {'; '.join(wrong)}")
    return records


def _agrees_in_a_short_step(step, short=1e-4) -> bool:
    """Tell whether a step of w h = short under a steady force differs from the exact one by less than that squared."""
    tables = [matrices(one, np.ones(1), np.full(1, 0.01), short) for one in (step, STEPS[PLAIN])]
    difference = (tables[0] - tables[1]) @ np.ones(1)
    return bool(np.abs([*difference[:, :2].T, difference[:, 2:].sum(axis=1)]).max() < short**2)


def _slack(method):
    """Return how many times further off a method of first order may be."""
    return 50 if "zero" in method or "invariant" in method or "Euler" in method else 1


def run(quick: bool, watch=lambda share, note: None) -> list[Record]:
    """Return the records of the chart; `watch(share, note)` is called before every run."""
    prove()
    factors = (1, 4) if quick else (1, 2, 4, 8, 16, 32)
    runs = [work(name, m, k) for name in CASES for m in (*STEPS, OURS) for k in factors]
    return measured(runs, watch, warm=lambda work: True)


def conclusion(records: list[Record]) -> list[str]:
    """Return for every case what to take, and what the nearest of the textbook methods needs, in a sentence each."""
    lines = []
    for case in dict.fromkeys(r.case for r in records):
        best = nearest(records, case=case, setting=f"1 x {RATE} Hz")
        told = f"{number(best.error)} in {milliseconds(best)}"
        lines.append(f"{case}: take {best.method}: at {RATE} Hz its error is {told}.")
        if near := nearest(records, case=case, family="approximate"):
            lines.append(
                f"{case}: of the textbook methods {near.method}, oversampled to {near.setting}, comes nearest: "
                f"{number(near.error)} in {milliseconds(near)}, {near.seconds / best.seconds:.0f} times as long."
            )
    return lines
