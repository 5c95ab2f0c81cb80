"""Claim: random heights along the rim have the prescribed slope and rms, and the curvature number
kappa follows from them.

Source: tests/helpers/rim_unevenness.py. Oracle: closed forms.
"""

import numpy as np
import pytest
from rim_unevenness import (
    burst_depths,
    contact_depth,
    curvature_number,
    damping_ratio,
    precession_rate_exponent,
    random_amplitudes,
    restitution_from,
    rim_heights,
)

from dynamics.compliant.law import unevenness

WEIGHT = 8.5e-3 * 9.81


def test_burst_depths_of_a_mode_kicked_once_per_turn():
    assert burst_depths(100.0, 30.0, 3) == pytest.approx(
        [0.937, 0.513, 0.348], rel=0.01
    )
    assert burst_depths(5.0, 30.0, 1) == pytest.approx([0.053], rel=0.01)


@pytest.mark.parametrize(("modulus", "depth"), [(40e9, 0.067e-6), (4e9, 0.312e-6)])
def test_depth_of_the_static_contact_of_a_coin(modulus, depth):
    assert contact_depth(WEIGHT, modulus, 12.875e-3, 0.5e-3, 0.1) == pytest.approx(
        depth, rel=0.02
    )


@pytest.mark.parametrize("inclination", [0.1, 0.05, 0.02])
def test_curvature_number_of_white_slopes_is_a_ninth_of_height_over_depth(inclination):
    depth = contact_depth(WEIGHT, 40e9, 12.875e-3, 0.5e-3, inclination)
    amplitudes = random_amplitudes(5 * depth, 0.0, 300, seed=0)
    kappa = curvature_number(amplitudes, 12.875e-3, inclination, depth)
    assert kappa == pytest.approx(5 / 9, rel=0.05)


def test_random_rim_has_the_given_root_mean_square_height():
    heights = rim_heights(random_amplitudes(3e-6, 0.5, 300, seed=1), 4096)
    assert np.sqrt(np.mean(heights**2)) == pytest.approx(3e-6)


@pytest.mark.parametrize("restitution", [0.05, 0.1, 0.3, 0.5, 0.65, 0.8, 0.97])
def test_the_damping_ratio_gives_the_restitution_of_an_integrated_impact(restitution):
    ratio = unevenness.damping_ratio(restitution)
    assert restitution_from(ratio) == pytest.approx(restitution, abs=1e-6)
    assert damping_ratio(restitution) == pytest.approx(ratio, abs=1e-5)


def test_a_dashpot_that_never_pulls_is_softer_than_one_that_does():
    """The clipped patch gives .652 where exp(-pi zeta/sqrt(1 - zeta^2)) is .65, and so on."""
    asked = np.array([0.65, 0.70, 0.50, 0.40, 0.30, 0.05])
    logarithm = -np.log(asked) / np.pi
    ratios = logarithm / np.sqrt(1 + logarithm**2)
    found = [unevenness.restitution_of_patch(ratio) for ratio in ratios]
    assert found == pytest.approx([0.652, 0.697, 0.524, 0.444, 0.370, 0.192], abs=1e-3)


@pytest.mark.parametrize(("slope", "exponent"), [(0, 0.5), (0.5, 0.429), (1, 0.333)])
def test_exponent_of_the_rate_of_turning(slope, exponent):
    assert precession_rate_exponent(slope) == pytest.approx(exponent, abs=1e-3)
