"""Claim: one description of the air serves both the sound and the drag on the disk.

Source: the ideal gas law; kinetic theory for the mean free path. Oracle: tabulated values of dry
air at 20 degrees Celsius.
"""

import pytest

from dynamics import Air
from modal.radiation import STANDARD_AIR
from sonify import load_scene
from sonify.sound.radiation import listener_of


def test_the_standard_air_is_one():
    air = Air()
    assert (air.density, air.sound_speed) == tuple(STANDARD_AIR)
    assert air.mean_free_path == pytest.approx(66e-9, rel=0.02)


def test_density_follows_pressure_and_temperature_unless_it_is_given():
    thin = load_scene("published").replace("air.pressure=10132.5")
    assert thin.air.density == pytest.approx(0.1204)
    assert thin.replace("air.density=0.118").air.density == 0.118
    assert thin.replace("air.temperature=586.3").air.density == pytest.approx(0.0602)
    assert thin.replace("air.temperature=586.3").air.sound_speed == pytest.approx(
        343.2 * 2**0.5
    )


def test_the_listener_hears_through_the_air_of_the_scene():
    scene = load_scene("published").replace("air.temperature=400", "air.pressure=2e5")
    assert listener_of(scene).delay == pytest.approx(0.5 / scene.air.sound_speed)
    assert listener_of(scene).air.density == scene.air.density


@pytest.mark.parametrize(
    ("frequency", "lost"), [(1000, 4.66), (2000, 9.89), (4000, 29.7), (8000, 105.0)]
)
def test_what_air_takes_of_a_sound_is_that_of_the_standard(frequency, lost):
    """Attenuation [dB/km] at 20 degrees Celsius and 50 % relative humidity, ISO 9613-1, table 1."""
    assert 1000 * Air().absorption(frequency) == pytest.approx(lost, rel=0.01)
