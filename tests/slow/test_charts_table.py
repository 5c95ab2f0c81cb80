"""Claim: the chart of the table gives every method the same case, the closed form of this case is
correct, and the chart reports failures.

Source: the docstring of benchmarks/cases/table_case.py. Oracle: the equation of motion integrated
from rest by DOP853; the orders of the methods. Engines that are not installed are skipped.
"""

from importlib.util import find_spec

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from benchmarks.cases import table_case as case
from benchmarks.charts import table_chart
from benchmarks.methods.oscillator_steps import bilinear, semi_implicit_euler
from benchmarks.timed_runs import LEFT_OUT, Failure, distance_from_one, measure


def test_the_closed_form_is_where_a_mode_at_rest_comes_to():
    """After 14 decay times, the transient is below 1e-6."""
    end = 14 / (case.DAMPING_RATIO * case.MODE_OMEGA)

    def rate(t, y):
        force = (
            -case.LOAD * case.GRAVITY / case.MASS * np.exp(1j * case.CONTACT_OMEGA * t)
        )
        return [
            y[1],
            force
            - 2 * case.DAMPING_RATIO * case.MODE_OMEGA * y[1]
            - case.MODE_OMEGA**2 * y[0],
        ]

    z = solve_ivp(rate, (0, end), [0j, 0j], "DOP853", rtol=1e-10, atol=1e-14).y[0, -1]
    assert z * np.exp(
        -1j * case.CONTACT_OMEGA * end
    ) / case.amplitude() == pytest.approx(1, abs=5e-6)


@pytest.mark.parametrize(
    ("method", "order"), [(case.exact_hold, 2), (semi_implicit_euler, 1), (bilinear, 2)]
)
def test_our_steps_and_the_textbooks_have_their_orders(method, order):
    rates = (800, 1600, 3200)
    answers = [
        method(r) if method is case.exact_hold else case.textbook_steps(method, r)
        for r in rates
    ]
    errors = [distance_from_one(answer.values) for answer in answers]
    assert -np.polyfit(np.log(rates), np.log(errors), 1)[0] == pytest.approx(
        order, abs=0.1
    )


def test_the_disk_on_the_mode_is_the_weight_of_the_closed_form():
    """The disk starts in the steady motion of a rigid table; its nutation is below 1e-5."""
    coarse, fine = (
        distance_from_one(case.two_way_disk(rate).values) for rate in (4000, 16000)
    )
    assert fine < 3e-5
    assert coarse > 5 * fine


@pytest.mark.parametrize(
    "method",
    [
        name
        for name in table_chart.ENGINE_METHODS
        if "flexes" not in name and "areas" not in name
    ],
)
def test_engines_converge_to_the_closed_form(method):
    peer = table_chart.ENGINE_METHODS[method]
    if not find_spec(peer.package):
        pytest.skip(f"{peer.package} is not installed")
    coarse, fine = (
        distance_from_one(peer.solve(*peer.fixed, rate).values)
        for rate in peer.values[:2]
    )
    assert fine < 0.01
    assert coarse > 5 * fine


def test_what_cannot_be_asked_is_a_row():
    with pytest.raises(Failure, match=LEFT_OUT):
        table_chart.ENGINE_METHODS["PyBullet"].missing()
    if find_spec("mujoco"):
        flexes = next(
            work for work in table_chart.works(quick=True) if "flexes" in work.method
        )
        assert "no modes to be given" in measure(flexes).failure
