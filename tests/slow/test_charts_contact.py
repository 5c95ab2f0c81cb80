"""Claim: the chart of the elastic contact compares methods that solve the same problem and shows
where each one fails.

Source: the closed forms of the impact; the filter and the full model of dynamics/compliant. Oracle:
the methods, compared with each other.
"""

import numpy as np
import pytest

from benchmarks.cases import contact_case
from benchmarks.charts import contact_chart
from benchmarks.timed_runs import Failure, measure


def test_every_way_through_the_impact_tends_to_its_closed_form():
    for step, order in ((contact_case.leap_frog, 2), (contact_case.explicit_euler, 1)):
        errors = [
            max(abs(v - 1) for v in contact_case.explicit_impact(step, rate).values)
            for rate in (1e6, 8e6)
        ]
        assert np.log2(errors[0] / errors[1]) / 3 > 0.8 * order
    assert (
        contact_case.explicit_impact(contact_case.explicit_euler, 1e6).values[1] > 1.001
    )
    depth, kept = contact_case.full_model_impact(8e5).values
    half_step = (
        contact_case.IMPACT_SPEED / 8e5 / 2 / contact_case.hertz_impact()[1]
    )  # error of the deepest row
    assert depth == pytest.approx(1, abs=0.625 * half_step**2)
    assert kept == pytest.approx(1, abs=1e-12)


def test_filter_and_full_model_hear_the_same_roughness():
    assert contact_case.filter_rms(9.6e4).values[0] == pytest.approx(
        contact_case.full_model_rms(2e5).values[0], rel=0.01
    )


def test_where_each_ends():
    with pytest.raises(Failure, match="too far in a step"):
        contact_case.filter_rms(6e3)
    with pytest.raises(Failure, match="one ellipse"):
        contact_case.relative_energy(3e-8)
    assert contact_case.contact_shift(1e-6) == pytest.approx(
        100 * contact_case.contact_shift(1e-8)
    )
    rigid = next(
        work for work in contact_chart.works(quick=True) if work.family == "rigid"
    )
    assert measure(rigid).failure == "wrong by 1e+02 %"
