"""Claim: at audio rate, textbook integrators detune, become unstable or miss the jumps of the
force; our exact steps do not.

Source: the closed form of driven oscillators. Oracle: the same closed form, which shares no formula
with the steps.
"""

import csv
from itertools import pairwise

import numpy as np
import pytest
from click.testing import CliRunner
from scipy.integrate import solve_ivp

from benchmarks.cases.sound_case import FORCE_JUMP
from benchmarks.charts import sound_chart
from benchmarks.methods.oscillator_steps import STEPS, growth_and_tuning
from benchmarks.timed_runs import Failure
from sonify.__main__ import main

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


def test_bilinear_detunes_near_nyquist_and_the_exact_steps_do_not():
    w = 2 * np.pi * np.array([15000.0])
    h = 1 / sound_chart.SAMPLE_RATE
    cents = {
        name: 1200 * np.log2(growth_and_tuning(step, w, 0 * w + 1, h)[1][0])
        for name, step in STEPS.items()
    }
    assert cents["bilinear"] < -400
    assert abs(cents["exact, first-order hold"]) < 1e-6
    assert cents["bilinear"] == pytest.approx(
        1200 * np.log2(np.arctan(w[0] * h / 2) / (w[0] * h / 2)), abs=1
    )


@pytest.mark.parametrize(
    ("name", "limit"),
    [("Verlet", 2.0), ("semi-implicit Euler", 2.0), ("Runge-Kutta 4", 2.828)],
)
def test_explicit_steps_have_the_known_limit_of_stability(name, limit):
    w = np.array([0.99, 1.01]) * limit
    none = np.zeros(2)
    growth = growth_and_tuning(STEPS[name], w, none, 1.0)[0]
    assert growth[0] < 1 + 1e-9
    assert growth[1] > 1 + 1e-3


def test_the_quick_chart_is_written(tmp_path):
    done = CliRunner().invoke(
        main, ["chart", "sound", "--quick", "--out", str(tmp_path)]
    )
    assert done.exit_code == 0, done.output
    rows = list(csv.DictReader((tmp_path / "sound.csv").open(encoding="utf-8")))
    assert {row["method"] for row in rows} == {*STEPS, sound_chart.OUR_METHOD}
    assert "blows up" in (tmp_path / "sound.md").read_text("utf-8")
    assert (tmp_path / "sound.png").stat().st_size > 20_000
