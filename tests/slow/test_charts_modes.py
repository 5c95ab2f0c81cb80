"""Claim: uniform meshes do not resolve the edge of a patch, and linear tetrahedra lock; the methods
of `modal` avoid both errors.

Source: the singularity u ~ r^(1/2) at the edge of a clamped patch. Oracle: frequencies from an
independent method; Ritz's method. test_mode_frequencies.py, test_modal_synthesis.py and
test_free_modes.py in tests/modal compare the methods of `modal` with these frequencies.
"""

import math

import numpy as np
import pytest

from benchmarks.cases.modes_case import modes_case
from benchmarks.charts import modes_chart
from benchmarks.methods.plain_finite_elements import (
    ELEMENTS,
    SECTORS,
    patch_unknowns,
    plain_modes,
    sectors,
    uniform,
)
from benchmarks.timed_runs import Record, measure


def test_every_competitor_has_the_same_elasticity():
    modes_chart.prove()


def test_linear_tetrahedra_lock():
    case = modes_case("free")
    linear, quadratic = (
        case.error(plain_modes(case, f"{p} tetrahedra", 3, 2).values)
        for p in ("P1", "P2")
    )
    assert linear > modes_chart.MAX_FREQUENCY_ERROR > 10 * quadratic


@pytest.mark.parametrize(
    ("element", "mesh"), [("P1 tetrahedra", (2, 2)), ("P2 tetrahedra", (2, 1))]
)
def test_uniform_meshes_miss_the_edge_of_the_patch(element, mesh):
    case = modes_case("patch")
    assert case.error(plain_modes(case, element, *mesh).values) > 0.1


@pytest.mark.parametrize("element", ELEMENTS)
def test_uniform_meshes_hold_the_whole_patch_and_no_more(element):
    case = modes_case("patch")
    basis, segments = uniform(case, element, 1, 1)
    x, y, z = basis.doflocs[:, patch_unknowns(basis, case, segments)]
    assert np.abs(np.arctan2(y, x)).max() == pytest.approx(case.half_angle)
    assert np.ptp(z) == pytest.approx(case.plate.thickness)
    assert np.hypot(x, y).min() > 0.999 * case.plate.radius


def test_right_handed_cells_fill_the_disk():
    cells = sectors(2)
    du = cells[:, 2, 1] - cells[:, 0, 1]
    dv = cells[:, 1, 2] - cells[:, 1, 0]
    assert (du[:, 0] * dv[:, 1] - du[:, 1] * dv[:, 0]).min() > 0
    a = cells[:, 2, 2] - cells[:, 0, 0]
    b = cells[:, 0, 2] - cells[:, 2, 0]
    area = np.abs(a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]).sum() / 2
    assert area == pytest.approx(SECTORS / 2 * np.sin(2 * np.pi / SECTORS))


def test_equal_errors_are_read_off_the_line_of_the_best_runs():
    def run(seconds, error):
        return Record(
            family="f", method="m", setting="", case="c", seconds=seconds, error=error
        )

    runs = modes_chart.pareto_front(
        [
            run(10.0, 0.01),
            run(1.0, 0.1),
            run(2.0, 0.5),
            run(0.1, 1.0),
            run(5.0, math.nan),
        ]
    )
    assert [r.seconds for r in runs] == [0.1, 1.0, 10.0]
    assert modes_chart.seconds_at(runs, 0.1) == (pytest.approx(1.0), False)
    assert modes_chart.seconds_at(runs, 0.001) == (pytest.approx(100.0), True)


def test_the_comparison_says_what_was_measured_and_what_was_not():
    def run(family, setting, seconds, error):
        return Record(
            family=family,
            method="m",
            setting=setting,
            case="c",
            seconds=seconds,
            error=error,
        )

    default = run("ours", modes_chart.DEFAULT_ACCURACY, 1.0, 0.01)
    line = [run(modes_chart.PLAIN, "", 1.0, 1.0), run(modes_chart.PLAIN, "", 10.0, 0.1)]
    assert "extrapolated, not measured" in modes_chart.conclusion([default, *line])[0]
    assert (
        "1e+02 times as long for this error"
        in modes_chart.conclusion([default, *line])[0]
    )
    reached = modes_chart.conclusion(
        [default, *line, run(modes_chart.PLAIN, "", 20.0, 0.01)]
    )[0]
    assert "takes 20 times as long for this error." in reached


def test_a_missing_program_is_left_out_and_says_so(monkeypatch):
    monkeypatch.setattr(
        modes_chart,
        "OPTIONAL_PROGRAMS",
        {
            f: (name, lambda: None)
            for f, (name, _) in modes_chart.OPTIONAL_PROGRAMS.items()
        },
    )
    records = [
        measure(w)
        for w in modes_chart.works(modes_case("free"), quick=True)
        if w.family in modes_chart.OPTIONAL_PROGRAMS
    ]
    assert records
    assert all(r.left_out for r in records)
    assert "left out: CalculiX is not installed" in {r.failure for r in records}
