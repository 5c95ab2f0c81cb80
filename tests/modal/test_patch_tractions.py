"""Claim: the tractions on a patch do the work that quadrature gives, and their exponent at a corner
is that of the elastic wedge.

Source: modal/synthesis/tractions.py. Oracle: quadrature with another substitution; the equation of
Williams (1952).
"""

import numpy as np
import pytest
from numpy.polynomial.legendre import leggauss
from scipy.special import eval_chebyt, eval_jacobi, eval_legendre

from modal import Material, Plate, Support
from modal.synthesis.tractions import BasisSizes, PatchTractions, corner_exponent

PLATE = Plate(
    radius=0.04,
    thickness=0.012,
    density=7800.0,
    material=Material(young=2e11, poisson=0.28),
)
SIZES = BasisSizes()


def tractions(half_angle=15.0, **changes):
    support = Support(half_angle_deg=half_angle, **changes)
    return PatchTractions(plate=PLATE, support=support, richness=SIZES)


@pytest.mark.parametrize("poisson", [0.0, 0.28, 0.45])
def test_the_exponent_solves_the_equation_of_the_wedge(poisson):
    q = corner_exponent(poisson) + 1
    k = 3 - 4 * poisson
    assert 4 * k * np.sin(q * np.pi / 2) ** 2 == pytest.approx((k + 1) ** 2 - 4 * q**2)
    assert 0.5 < q <= 1


@pytest.mark.parametrize("y", [1, -1])
def test_work_round_the_rim_is_that_of_quadrature(y):
    """With theta = a sin(x), the root in the denominator cancels."""
    orders = np.array([0.0, 1.0, 7.0])
    angle = np.radians(15.0)
    x, weight = leggauss(60)
    x, weight = x * np.pi / 2, weight * np.pi / 2
    theta = angle * np.sin(x)
    work = tractions().circumferential_work(orders, y)
    for i, n in enumerate(orders):
        for j in range(SIZES.circumferential_tractions):
            even, odd = (eval_chebyt(2 * j + m, np.sin(x)) for m in (0, 1))
            cosine = angle * PLATE.radius * np.sum(weight * even * np.cos(n * theta))
            sine = angle * PLATE.radius * np.sum(weight * odd * np.sin(n * theta))
            radial, tangential = (cosine, sine) if y > 0 else (sine, -cosine)
            expected = [radial, tangential, radial]
            assert work[:, i, j] == pytest.approx(expected, abs=1e-12)


@pytest.mark.parametrize("even", [1, -1])
def test_work_through_the_thickness_is_that_of_quadrature(even):
    """With zeta = sin(x), the tractions at the faces become (cos x)^(2 p + 1), which is smooth
    enough for many points."""
    corner = corner_exponent(PLATE.material.poisson)
    x, weight = leggauss(400)
    x, weight = x * np.pi / 2, weight * np.pi / 2
    zeta = np.sin(x)
    work = tractions().axial_work(even)
    l = np.arange(SIZES.thickness_tractions)[:, None]
    m = np.arange(SIZES.size[1])[:, None]
    for i, (odd, power) in enumerate(
        [(even < 0, corner), (even < 0, 0.0), (even > 0, corner)]
    ):
        traction = np.cos(x) ** (2 * power + 1) * eval_jacobi(
            2 * l + odd, power, power, zeta
        )
        exact = (weight * traction) @ eval_legendre(2 * m + odd, zeta).T
        assert work[i] == pytest.approx(
            exact * PLATE.thickness / 2, abs=3e-5 * PLATE.thickness
        )


def test_held_components_and_refused_patches():
    assert tractions(held=("tangential", "axial")).held == [1, 2]
    for wrong in ({"height": 0.005}, {"half_angle": 175.0}, {"kind": "free"}):
        with pytest.raises(ValueError, match="patch over the whole thickness"):
            tractions(**wrong)
