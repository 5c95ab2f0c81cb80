"""Claim: both forms of the shapes of a table return cubic shapes and their slopes exactly.

Source: modal/tabletop/record.py. Oracle: the polynomials from which the shapes are made; the sum of
the modal flexibilities.
"""

from dataclasses import fields

import numpy as np
import pytest

from modal import SurfaceModes
from modal.tabletop.record import fit_round_shapes, fit_splines, spline_values

RADIUS = 0.2
X, Y = RADIUS * np.array([[0.3, -0.5, 0.0, 0.6], [0.4, 0.1, 0.0, -0.7]])


def round_shapes():
    """Return the two shapes (1 + 2 s - s^3) rho^2 cos(2 theta) and sin(2 theta)."""
    return fit_round_shapes(
        lambda rho: np.tile(rho**2 * (1 + 2 * rho**2 - rho**6), (2, 1)),
        RADIUS,
        RADIUS,
        np.array([2, 2]),
        np.array([False, True]),
    )


def test_round_shapes_are_the_waves_they_were_made_from():
    x, y = X / RADIUS, Y / RADIUS
    s = x**2 + y**2
    expected = np.transpose([x**2 - y**2, 2 * x * y] * (1 + 2 * s - s**3))
    assert round_shapes().at(X, Y) == pytest.approx(expected, abs=1e-12)


def test_slopes_of_round_shapes_are_the_derivatives():
    x, y = X / RADIUS, Y / RADIUS
    s = x**2 + y**2
    g, change = 1 + 2 * s - s**3, 2 - 3 * s**2
    along_x = [
        2 * x * change * (x**2 - y**2) + 2 * x * g,
        4 * x**2 * y * change + 2 * y * g,
    ]
    along_y = [
        2 * y * change * (x**2 - y**2) - 2 * y * g,
        4 * x * y**2 * change + 2 * x * g,
    ]
    for slope, expected in {(1, 0): along_x, (0, 1): along_y}.items():
        found = round_shapes().at(X, Y, slope) * RADIUS
        assert found == pytest.approx(np.transpose(expected), abs=1e-10)


def test_points_outside_a_round_table_have_the_value_at_the_rim():
    angle = np.array([0.2, 2.0])
    cos, sin = np.cos(angle), np.sin(angle)
    rim = round_shapes().at(RADIUS * cos, RADIUS * sin)
    assert round_shapes().at(3 * RADIUS * cos, 3 * RADIUS * sin) == pytest.approx(rim)


def test_a_round_shape_has_only_first_derivatives():
    with pytest.raises(ValueError, match="must be"):
        round_shapes().at(X, Y, (1, 1))


def splines():
    """Return the splines of x^3 y^2 - y^3 and of 1 on a rectangle."""
    return fit_splines(
        lambda x, y: np.array([x**3 * y**2 - y**3, np.ones_like(x)]),
        np.array([-0.2, -0.3]),
        np.array([0.2, 0.3]),
        0.3,
    )


@pytest.mark.parametrize(
    ("slope", "expected"),
    [
        ((0, 0), X**3 * Y**2 - Y**3),
        ((1, 0), 3 * X**2 * Y**2),
        ((0, 1), 2 * X**3 * Y - 3 * Y**2),
        ((1, 1), 6 * X**2 * Y),
        ((2, 0), 6 * X * Y**2),
    ],
)
def test_splines_return_cubic_shapes_and_their_derivatives(slope, expected):
    found = spline_values(*splines(), X, Y, slope)[:, 0]
    assert found == pytest.approx(expected, abs=1e-12)


def test_points_outside_the_splines_have_the_value_at_the_edge():
    found = spline_values(*splines(), np.array([5.0]), np.array([0.1]))
    assert found == pytest.approx(
        spline_values(*splines(), np.array([0.2]), np.array([0.1]))
    )


def test_the_compliance_of_modes_is_the_sum_of_their_flexibilities():
    knots, coefficients = splines()
    given = {
        "frequency": np.array([10.0, 20.0]),
        "knots": knots,
        "coefficients": coefficients[:, :, [1, 1]] * [1.0, 3.0],
        "place": np.zeros(2),
    }
    rest = {field.name: np.zeros((2, 0)) for field in fields(SurfaceModes)}
    modes = SurfaceModes(**rest | given | {"round_shapes": None})
    each = np.array([1.0, 9.0]) / (2 * np.pi * given["frequency"]) ** 2
    assert modes.compliance(0.1) == pytest.approx(each.sum())
    assert modes.select([1]).compliance(0.1) == pytest.approx(each[1])
