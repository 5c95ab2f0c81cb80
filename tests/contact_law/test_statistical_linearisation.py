"""Claim: strong vibration, comparable to the static load, softens the contact as statistical
linearisation predicts.

Source: Caughey (1963). Oracle: the full motion on a rough table; closed forms for small vibrations;
additional iterations.
"""

import numpy as np
import pytest
from contact_scenes import granite, middle, steady_speed
from scipy.signal import welch
from table_models import GRIPS, steady

from dynamics.compliant.law.linear_response import predicted_spectrum
from dynamics.compliant.law.roughness import edge_profile, table_profile
from dynamics.compliant.law.sections import Roughness
from dynamics.compliant.law.statistical_linearisation import (
    LINEARISATION_ROUNDS,
    effective_load_factor,
    mean_stiffness,
)
from dynamics.compliant.law.tabulated import TabulatedLaw
from dynamics.compliant.state_conversion import preloaded_compliant_state
from dynamics.compliant.stepping.model import CompliantModel

TABULATED_LAW, ROUGHNESS = TabulatedLaw(law=granite()), Roughness(rms=1e-7)
DISK = TABULATED_LAW.law.disk


def test_small_vibrations():
    """To second order in x, scatter over approach, the stiffness is 1 - x^2/4.

    The scatter and the shift of the mean contribute x^2/8 each.
    """
    K = 1.6e10
    load = 4.3
    x = 0.03
    still = (load / K) ** (2 / 3)
    assert mean_stiffness(K, load, 0.0) == pytest.approx(1.5 * load / still, rel=1e-12)
    assert mean_stiffness(K, load, x * still) / (1.5 * load / still) == pytest.approx(
        1 - x * x / 4, abs=x**3
    )


def test_the_full_motion_rings_as_low():
    """Steady rolling on 0.1 um rms: a linear contact overestimates the frequency by 5 %."""
    beta = 0.02
    power = 0.0
    speed = steady_speed(TABULATED_LAW.law, beta)
    start, _ = steady(TABULATED_LAW.law, beta)
    for seed in (0, 1):
        rough = Roughness(rms=1e-7, seed=seed)
        profiles = table_profile(rough), edge_profile(rough, DISK.radius)
        model = CompliantModel(
            tabulated_law=TABULATED_LAW,
            friction=GRIPS,
            profiles=profiles,
            rate=2e5,
        )
        force = np.concatenate(
            [
                piece.force
                for piece in model.run(preloaded_compliant_state(model, start), 4, 1.0)
            ]
        )[2500:, 2]
        f, one = welch(force, model.rate / 4, nperseg=2048)
        power = power + one
    factor = effective_load_factor(
        TABULATED_LAW, ROUGHNESS, [beta], DISK.weight, speed
    )[0]
    soft, linear = (
        middle(
            f[1:],
            predicted_spectrum(
                TABULATED_LAW, ROUGHNESS, beta, part * DISK.weight, speed, f[1:]
            ),
        )
        for part in (factor, 1.0)
    )
    found = middle(f[1:], power[1:])
    assert found == pytest.approx(soft, rel=0.025)
    assert linear / soft > 1.04


def test_so_many_rounds_are_enough():
    beta = [0.3, 0.01]
    speed = [steady_speed(TABULATED_LAW.law, b) for b in (0.3, 0.01)]
    few, many = (
        effective_load_factor(
            TABULATED_LAW, ROUGHNESS, beta, DISK.weight, speed, rounds
        )
        for rounds in (LINEARISATION_ROUNDS, 3 * LINEARISATION_ROUNDS)
    )
    assert few == pytest.approx(many, rel=0.03)
    assert (many < 1).all()
