"""Claim: the chart of the contact models solves one problem by all models, and the limits of the
models that it shows are those with which the motion is planned.

Source: the time steps and the filter of dynamics. Oracle: contacts anywhere on the rim with smaller
steps; closed form 1/(1 + alpha cos) of the force on one wave, whose second harmonic one contact
below the lowest point lacks; the table of the chart in outputs/shown.
"""

from functools import cache
from pathlib import Path

import numpy as np
import pytest

from benchmarks.cases import contact_models_case
from benchmarks.cases.contact_models_case import CASES, errors, predicted_force_rms
from benchmarks.charts import contact_models_chart as chart
from benchmarks.charts.contact_models_records import (
    LONG_WAVES,
    MAX_MOTION_ERROR,
    MOTION_QUANTITIES,
    SHORT_WAVES,
    last_holding,
    motion_error,
)
from benchmarks.timed_runs import Failure, Record, read_csv
from dynamics import plan_motion
from dynamics.compliant.law.unevenness import curvature_number
from dynamics.compliant.model_inputs import contact_law
from dynamics.compliant.model_selection import (
    LIFT_OFF_FORCE_RMS,
    MAX_FORCE_RMS_FOR_ONE_CONTACT,
    MAX_RELATIVE_CURVATURE_FOR_ROLLING,
)
from dynamics.rattling.rattling_motion import edge_depth

SHOWN = Path(__file__).parents[2] / "outputs" / "shown" / "charts"


@cache
def solved(name, model, rate):
    return CASES[name].solve(model, rate).values


def test_all_models_agree_on_a_smooth_table():
    weight = CASES["smooth, 0"].scene.disk.weight
    reference = solved("smooth, 0", "many", 3e5)
    for model in ("filter", "full", "full, tracked"):
        assert max(errors(solved("smooth, 0", model, 2e5), reference, weight)) < 2e-4


def test_the_heights_have_the_curvature_number_of_the_case():
    for name in ("rough, long waves, 0.25", "rough, short waves, 0.05", "wavy, 0.5"):
        case = CASES[name]
        disk = case.scene.disk
        depth = edge_depth(disk, contact_law(case.scene), 0.1)
        waves = np.fft.rfft(case.heights) * 2 / len(case.heights)
        assert curvature_number(waves, disk.radius, 0.1, depth) == pytest.approx(
            case.curvature_number, rel=1e-6
        )


def test_on_one_wave_only_contacts_anywhere_have_the_second_harmonic():
    def harmonics(model):
        f, power = solved("wavy, 0.25", model, 3e5).spectrum()
        return [
            power[(f > low) & (f < high)].sum()
            for low, high in ((125, 275), (325, 475))
        ]

    first, second = harmonics("many")
    alpha = 0.25 * np.sqrt(2)
    ratio = (1 - np.sqrt(1 - alpha**2)) / alpha
    assert np.sqrt(second / first) > ratio
    for model in ("full, tracked", "full"):  # the contact does not follow the heights
        assert harmonics(model)[0] == pytest.approx(first, rel=0.15)
        assert harmonics(model)[1] < 1e-3 * second


@pytest.mark.parametrize(
    ("constant", "value", "message"),
    [
        ("MAX_DURATION", 0.05, "ends at"),
        ("LAST_INCLINATION", 0.099, "reaches 0.099 rad after"),
    ],
)
def test_a_stretch_that_ends_early_is_a_failure(constant, value, message, monkeypatch):
    monkeypatch.setattr(contact_models_case, constant, value)
    with pytest.raises(Failure, match=message):
        CASES["smooth, 0"].solve("full", 2e5)


def test_the_plan_has_the_limits_of_the_shown_chart():
    records = read_csv(SHOWN / "contact_models.csv")
    for model in ("filter", "full"):
        last, _ = last_holding(records, model, LONG_WAVES)
        assert last.curvature_number == MAX_RELATIVE_CURVATURE_FOR_ROLLING
    for model, limit in (
        ("filter", LIFT_OFF_FORCE_RMS),
        ("full", MAX_FORCE_RMS_FOR_ONE_CONTACT),
    ):
        last, first = last_holding(records, model, SHORT_WAVES)
        assert predicted_force_rms(last) == pytest.approx(limit, rel=0.05)
        assert predicted_force_rms(last) < limit < predicted_force_rms(first)


def test_the_shown_records_have_every_case():
    records = read_csv(SHOWN / "contact_models.csv")
    assert {r.case for r in records} == set(CASES)


def test_a_run_without_a_solution_does_not_hold():
    about = {"setting": "9 1/s", "case": "rough, long waves, 0.1"}
    good = [
        Record(family="full", method=quantity, error=MAX_MOTION_ERROR / 2, **about)
        for quantity in MOTION_QUANTITIES
    ]
    assert motion_error(good, "full", about["case"]) == MAX_MOTION_ERROR / 2
    assert last_holding(good, "full", LONG_WAVES)[1] is None
    none = [Record(family="full", method=chart.NO_SOLUTION, error=np.inf, **about)]
    assert motion_error(none, "full", about["case"]) == np.inf
    assert last_holding(none, "full", LONG_WAVES)[0] is None


def test_the_smooth_scene_of_the_chart_is_planned_as_a_filter():
    plan = plan_motion(CASES["smooth, 0"].scene.replace("friction.mu_static=10.0"))
    assert plan.contact.kind == "filter"
