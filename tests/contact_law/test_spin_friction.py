"""Claim: the contact ellipse resists pivoting by slip and by creep as Hertz and Kalker say.

Source: Hertz's pressure; Kalker (1967), spin creep.
Oracle: integrals over the ellipse; boundary elements; closed forms; the limits of fast and slow slip.
"""

import numpy as np
import pytest
from contact_elements import elliptical_elements
from contact_scenes import granite
from scipy.integrate import dblquad

from dynamics.compliant.law.spin_friction import (
    pivoting_polynomials,
    slip_arm,
    spin_coefficient,
    spin_creep_moment_coefficient,
)
from dynamics.pivoting import (
    PIVOTING_COEFFICIENT_COUNT,
    friction_limited_arm,
    pivoting_arm,
)

LAW = granite()
WEIGHT = LAW.disk.weight


def over_pressure(a, b, weight):
    """Return the mean of weight(x, y) over Hertz's pressure on the ellipse."""

    def part(of):
        return dblquad(
            lambda angle, r: (
                of(a * r * np.cos(angle), b * r * np.sin(angle))
                * np.sqrt(1 - r * r)
                * r
            ),
            0,
            1,
            0,
            np.pi / 2,
        )[0]

    return part(weight) / part(lambda x, y: 1.0)


@pytest.mark.parametrize("beta", [1.4, 0.1])
def test_the_slip_arm_is_the_mean_distance_over_the_pressure(beta):
    a, b = LAW.semi_axes(beta, WEIGHT)
    assert slip_arm(LAW, beta, WEIGHT) == pytest.approx(
        over_pressure(a, b, np.hypot), rel=1e-5
    )


def test_the_arms_of_a_circle_and_of_a_long_ellipse():
    sphere = granite(fillet=0.03755, thickness=0.0751)
    a, _ = sphere.semi_axes(1.0, WEIGHT)
    assert slip_arm(sphere, 1.0, WEIGHT) == pytest.approx(3 * np.pi / 16 * a, rel=1e-12)
    for beta in (0.1, 0.01):
        a, _ = LAW.semi_axes(beta, WEIGHT)
        assert slip_arm(LAW, beta, WEIGHT) == pytest.approx(3 / 8 * a, rel=0.01)


def test_the_arms_on_granite():
    """Those of the published disk with mu = 0.3; its given arm is 5.4 and 2.3 times as large."""
    arms = 0.3 * slip_arm(LAW, np.array([0.1, 0.01]), WEIGHT)
    assert arms == pytest.approx([5.6e-5, 1.3e-4], rel=0.1)
    assert 3.004e-4 / arms == pytest.approx([5.4, 2.3], rel=0.1)
    rolling = (
        spin_creep_moment_coefficient(LAW, 0.1, WEIGHT)
        * LAW.disk.aspect
        * 0.1
        / LAW.disk.radius
    )
    assert rolling == pytest.approx(1e-7, rel=1.0)


@pytest.mark.parametrize("ratio", [0.1, 0.03])
def test_spin_creep_of_a_steadily_rolling_ellipse(ratio):
    """Boundary elements for Poisson's ratio 0, as for the creep along the rolling direction.

    The tractions across it have no moment, since each row is symmetric about its middle.
    """
    _, y, dx, dy, grown = elliptical_elements(ratio, 20)
    traction = np.linalg.solve(grown, -y * dx)
    found = -(y * traction).sum() * dx * dy / ratio**2
    assert found == pytest.approx(spin_coefficient(ratio, 0.0), rel=0.04)


def test_the_polynomials_are_the_law():
    coefficients = pivoting_polynomials(LAW)
    beta = np.geomspace(1e-7, np.pi / 2, 41)
    slipping, rolling = (
        LAW.disk.radius
        * pivoting_arm(np.sin(beta), 1.0, v, 0.0, False, 0.3, coefficients)
        for v in (0.0, 1e6)
    )
    assert slipping == pytest.approx(0.3 * slip_arm(LAW, beta, WEIGHT), rel=1e-4)
    creep = spin_creep_moment_coefficient(LAW, beta, WEIGHT) / LAW.disk.radius
    assert rolling == pytest.approx(creep / 1e6, rel=1e-4)
    assert len(coefficients) == 2 * PIVOTING_COEFFICIENT_COUNT


@pytest.mark.parametrize("beta", [1.4, 0.01])
def test_the_moment_of_a_contact_that_slips_fast(beta):
    """It is mu N <y^2> w/u for a slip u along x, here averaged over the directions of slip."""
    a, b = LAW.semi_axes(beta, WEIGHT)
    mean = over_pressure(a, b, lambda x, y: (x * x + y * y) / 2)
    arm = friction_limited_arm(slip_arm(LAW, beta, WEIGHT), 0.0, 1e-3, 1.0, True, 0.3)
    assert arm == pytest.approx(0.3 * mean * 1e-3, rel=0.1)
    still = friction_limited_arm(slip_arm(LAW, beta, WEIGHT), 0.0, -2.0, 0.0, True, 0.3)
    assert still == pytest.approx(-0.3 * slip_arm(LAW, beta, WEIGHT), rel=1e-9)
