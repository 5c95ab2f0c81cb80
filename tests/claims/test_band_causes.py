"""Claim: the cause of a noise band is what moves it when it is switched off in the linear filter.

Source: sonify/claims/band_causes.py. Oracle: levels of the mirror from an independent program, with the
table as receptance and without; tables for which the cause is known beforehand: a mirror, whose
modes lie at the contact resonance, and slabs that do not yield, under a film that amplifies.
"""

from types import SimpleNamespace

import numpy as np
import pytest

from dynamics import plan_motion
from dynamics.compliant.law.linear_response import predicted_spectrum
from dynamics.compliant.law.sections import Roughness
from dynamics.compliant.law.table_receptance import RIGID_TABLE
from dynamics.compliant.law.tabulated import TabulatedLaw
from dynamics.compliant.model_inputs import contact_law
from dynamics.compliant.model_selection import steady_precession_rate
from modal import surface_modes
from sonify import load_scene
from sonify.claims.band_causes import (
    BandCauses,
    SteadyVibration,
    band_causes,
    stiffness_moves_carrier,
    table_moves_carrier,
    table_sound,
)
from sonify.claims.contact import air_moves_carrier, cause_findings
from sonify.hearing.loudness import a_weighting_db
from sonify.sound.radiation import listener_of

SILENT_SLAB = (
    "surface={kind='infinite', thickness=5.0, young=60e9, poisson=0.2, density=2700.0}"
)


@pytest.fixture(scope="module")
def mirror():
    scene = load_scene("toy")
    return scene, plan_motion(scene, surface_modes(scene, 20e3))


@pytest.mark.parametrize(
    ("beta", "one_way", "two_way"), [(0.03, 82.2, 56.0), (0.01, 71.2, 55.9)]
)
def test_the_level_of_the_mirror_is_that_of_the_reference(
    mirror, beta, one_way, two_way
):
    """The disk is a rigid body without tangential spring, on white heights of 30 nm."""
    scene, plan = mirror
    heights = Roughness(rms=30e-9, rms_edge=0.0, shortest=1e-4, longest=0.1)
    law = TabulatedLaw(law=contact_law(scene))
    rate = steady_precession_rate(scene, beta)
    speed = rate * abs(float(law.law.place(beta).f))
    f = np.arange(20.0, 20e3, 2.0)
    sound = table_sound(scene, plan.surface_modes, listener_of(scene), f)
    for receptance, expected in (
        (RIGID_TABLE, one_way),
        (plan.contact_receptance, two_way),
    ):
        force = predicted_spectrum(
            law, heights, beta, scene.disk.weight, speed, f, False, receptance
        )
        power = sound.power(f, force * (f > 200), rate)
        squared = np.trapezoid(power * 10 ** (a_weighting_db(f) / 10), f)
        assert 10 * np.log10(squared / 20e-6**2) == pytest.approx(expected, abs=1.0)


def causes_of(scene, plan, film=True):
    """Return the causes of the band of a scene at eight inclinations, with the predicted band as heard."""
    law = plan.tabulated_law
    steady = []
    for beta in np.geomspace(0.2, 0.01, 8):
        speed = steady_precession_rate(scene, beta) * abs(float(law.law.place(beta).f))
        steady.append([SteadyVibration(beta, scene.disk.weight, speed, True)])
    motion = SimpleNamespace(plan=plan, film=film, disk=scene.disk)
    found = band_causes(scene, motion, law, plan.contact_receptance, steady, np.ones(8))
    return found._replace(heard=found.complete)


@pytest.fixture(scope="module")
def mirror_causes(mirror):
    return causes_of(*mirror)


def test_the_mirror_sets_its_band(mirror_causes):
    found = mirror_causes
    assert table_moves_carrier(found).holds
    assert table_moves_carrier(found).value == pytest.approx(1.37, abs=0.05)
    assert not air_moves_carrier(found).holds
    assert not stiffness_moves_carrier(found).holds
    keys = [one.key for one in cause_findings(found, has_film=False)]
    assert keys == [
        "table_moves_carrier",
        "carrier_is_contact",
        "stiffness_moves_carrier",
    ]


def test_a_prediction_that_misses_the_sound_names_no_cause(mirror_causes):
    other = mirror_causes._replace(heard=1.3 * mirror_causes.complete)
    assert table_moves_carrier(other).verdict == "undecided"


def test_the_contact_sets_the_band_on_a_slab():
    scene = load_scene("toy").replace(SILENT_SLAB, "air.film=none")
    found = causes_of(scene, plan_motion(scene), film=False)
    assert not table_moves_carrier(found).holds
    assert stiffness_moves_carrier(found).value == pytest.approx(1.0, abs=0.02)


def test_the_film_sets_the_band_where_it_amplifies(monkeypatch):
    """The film is replaced by one that amplifies a band at 3.6 kHz by 70 dB."""

    class Amplified:
        def __init__(self, *described):
            pass

        def mean_square_pressure(self, inclination, f, mean_gap=None):
            rise = 0.0 if mean_gap is not None else 1e7
            return 1.0 + rise * np.exp(-(((f - 3600) / 50) ** 2))

    monkeypatch.setattr("sonify.claims.band_causes.VibratingDisk", Amplified)
    scene = load_scene("toy").replace(SILENT_SLAB)
    found = causes_of(scene, plan_motion(scene))
    assert air_moves_carrier(found).holds
    assert found.complete == pytest.approx(3600, rel=0.03)
    assert not stiffness_moves_carrier(found).holds


def test_what_moves_a_band_down_is_a_cause_too():
    one = np.full(3, 1000.0)
    found = BandCauses(one, one, 1.3 * one, one, 1.4 * one, 1.2 * one)
    assert table_moves_carrier(found).value == pytest.approx(1.3)
