"""Claim: each finding on a rattling disk comes out "no" for a motion or a sound that contradicts it.

Source: sonify/claims/rattling.py. Oracle: a smooth coin that contour friction brings to rest, with
the exponent 1/3; a coin that rolls unless its modes vibrate; noise without lines.
"""

from types import SimpleNamespace

import numpy as np
import pytest
from rattling_coin import coin, model_of, settle

from dynamics import plan_motion
from dynamics.rattling.rattling_motion import solve_rattling_motion
from sonify.claims.loss_causes import vibration_opens_contact
from sonify.claims.rattling import (
    disk_rattles,
    free_modes_are_heard,
    impacts_end_it,
    rate_follows_unevenness,
    rate_is_that_of_the_table,
)


@pytest.fixture(scope="module")
def rolling():
    scene = coin(1e-8, 1.0, 0.5, 0, 0.06, "dissipation.contour_moment=3.2e-6")
    return scene, settle(model_of(scene), scene, 0.006)


def test_a_coin_that_friction_stops_contradicts_the_claims_on_impacts(rolling):
    scene, motion = rolling
    assert disk_rattles(motion).verdict == "no"
    assert impacts_end_it(motion).verdict == "no"
    exponent = rate_follows_unevenness(1.0, motion)
    assert exponent.verdict == "no"
    assert exponent.value == pytest.approx(1 / 3, abs=0.02)
    assert rate_is_that_of_the_table(scene, motion).verdict == "no"


@pytest.mark.slow
def test_vibration_is_named_where_contact_is_lost_by_the_modes_alone():
    """A coin on 60 nm, a depth of its contact, whose rigid body hardly leaves the table."""
    scene = coin(
        6e-8, 1.0, 0.5, 1, 0.12, "contact.body=elastic", "numerics.time_limit=0.3"
    )
    verdict = vibration_opens_contact(scene, solve_rattling_motion(plan_motion(scene)))
    assert verdict.verdict == "yes"
    assert verdict.cause == "vibration"


def test_noise_is_not_the_sound_of_modes():
    noise = np.random.default_rng(0).standard_normal((48000, 1))
    pressure = SimpleNamespace(blocks=lambda: iter([noise]))
    sound = SimpleNamespace(pressure=pressure, sample_rate=48000)
    modes = SimpleNamespace(frequency=np.array([10600.0, 17800.0]))
    assert free_modes_are_heard(sound, modes).verdict == "no"
