"""Claim: the static contact of the rim has the depth of Hertz's edge, and a damping ratio gives the
restitution of an impact.

Source: dynamics/compliant/law/unevenness.py. Oracle: the same depth by another function; an
integrated impact.
"""

import numpy as np
import pytest
from rim_unevenness import contact_depth, restitution_from

from dynamics.compliant.law import unevenness

WEIGHT = 8.5e-3 * 9.81


@pytest.mark.parametrize(("modulus", "depth"), [(40e9, 0.067e-6), (4e9, 0.312e-6)])
def test_depth_of_the_static_contact_of_a_coin(modulus, depth):
    coin = (WEIGHT, modulus, 12.875e-3, 0.5e-3, 0.1)
    assert unevenness.static_depth(*coin) == pytest.approx(depth, rel=0.02)
    assert contact_depth(*coin) == pytest.approx(unevenness.static_depth(*coin))


@pytest.mark.parametrize("restitution", [0.05, 0.1, 0.3, 0.5, 0.65, 0.8, 0.97])
def test_the_damping_ratio_gives_the_restitution_of_an_integrated_impact(restitution):
    ratio = unevenness.damping_ratio(restitution)
    assert restitution_from(ratio) == pytest.approx(restitution, abs=1e-6)


def test_a_dashpot_that_never_pulls_is_softer_than_one_that_does():
    """The clipped patch gives .652 where exp(-pi zeta/sqrt(1 - zeta^2)) is .65, and so on."""
    asked = np.array([0.65, 0.70, 0.50, 0.40, 0.30, 0.05])
    logarithm = -np.log(asked) / np.pi
    ratios = logarithm / np.sqrt(1 + logarithm**2)
    found = [unevenness.restitution_of_patch(ratio) for ratio in ratios]
    assert found == pytest.approx([0.652, 0.697, 0.524, 0.444, 0.370, 0.192], abs=1e-3)
