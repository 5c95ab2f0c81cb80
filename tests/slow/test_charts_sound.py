"""Claim: at audio rate, textbook integrators detune, become unstable or miss the jumps of the
force; our exact steps do not.

Source: the closed form of driven oscillators. Oracle: the same closed form, which shares no formula
with the steps. test_charts_stability.py tests by how much the steps detune and where they become
unstable.
"""

from itertools import pairwise

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from benchmarks.cases.sound_case import FORCE_JUMP
from benchmarks.charts import sound_chart
from benchmarks.methods.oscillator_steps import STEPS
from benchmarks.timed_runs import Failure

SMOOTH, JUMPY = sound_chart.CASES


def error(name, method, factor=1):
    return sound_chart.error(
        name, sound_chart.pressure(sound_chart.case_of(name), method, factor).values
    )


def test_the_closed_form_is_the_solution_of_the_equation():
    case = sound_chart.case_of(JUMPY)
    mode = 1
    until = 0.012
    w = case.omega[mode]
    d = case.decay[mode]

    def rate(t, y):
        force = case.smooth([t])[0] + FORCE_JUMP * np.searchsorted(
            case.jumps, t, side="right"
        )
        return y[1], force - w * w * y[0] - 2 * d * y[1]

    t = np.arange(int(until * sound_chart.SAMPLE_RATE)) / sound_chart.SAMPLE_RATE
    state = (0.0, 0.0)
    out = []
    edges = [0.0, *case.jumps[case.jumps < until], until]
    for start, stop in pairwise(edges):
        inside = t[(t >= start) & (t < stop)]
        solved = solve_ivp(
            rate,
            (start, stop),
            state,
            "DOP853",
            np.append(inside, stop),
            rtol=1e-11,
            atol=1e-20,
        )
        force = case.smooth(inside) + FORCE_JUMP * np.searchsorted(
            case.jumps, inside, side="right"
        )
        out.append(force - w * w * solved.y[0, :-1] - 2 * d * solved.y[1, :-1])
        state = solved.y[:, -1]
    expected = np.concatenate(out)
    assert (
        np.abs(case._acceleration(t, w, d) - expected).max()
        < 1e-6 * np.abs(expected).max()
    )


def test_every_method_solves_the_same_equation():
    assert len(sound_chart.prove()) == len(STEPS)


def test_ours_is_exact_but_for_the_curvature_of_the_force():
    assert error(SMOOTH, sound_chart.OUR_METHOD) < 3e-4
    assert error(JUMPY, sound_chart.OUR_METHOD) < 3e-4


@pytest.mark.parametrize("method", STEPS)
def test_without_jumps_between_samples_every_method_misses_them(method):
    if method in ("Verlet", "semi-implicit Euler", "explicit Euler"):
        with pytest.raises(Failure, match="blows up"):
            error(JUMPY, method)
    else:
        assert error(JUMPY, method) > 100 * error(JUMPY, sound_chart.OUR_METHOD)


@pytest.mark.parametrize("factor", [1, 4, 16])
def test_explicit_euler_blows_up_at_any_rate(factor):
    with pytest.raises(Failure, match="blows up"):
        error(SMOOTH, "explicit Euler", factor)
