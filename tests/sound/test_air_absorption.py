"""Claim: the atmosphere absorbs sound as the standard requires; the filter shifts no phase and runs
only where the absorption is audible.

Source: ISO 9613-1, 20 degrees Celsius and 50 % relative humidity. Oracle: table 1 of the standard;
the unfiltered sound, convolved with the filter.
"""

import numpy as np
import pytest

from dynamics import Air, simulate
from modal import eigenmodes
from sonify import load_scene
from sonify.plan.air import absorption_sentences
from sonify.sound import absorption
from sonify.sound.absorption import (
    absorbed_db,
    absorption_latency,
    absorption_taps,
    propagation_filter,
)
from sonify.sound.radiation import Listener
from sonify.sound.render import Renderer

RATE = 48000


@pytest.mark.parametrize(("distance", "taken"), [(1.0, 0.105), (10.0, 1.05)])
def test_what_is_taken_at_8_khz(distance, taken):
    assert absorbed_db(Air(), distance, 8e3) == pytest.approx(taken, rel=0.01)


@pytest.mark.parametrize("distance", [2.0, 10.0, 100.0])
@pytest.mark.parametrize("frequency", [125.0, 1000.0, 4000.0, 8000.0, 16000.0])
def test_the_filter_takes_that_and_does_not_shift(distance, frequency):
    """The attenuation is correct to 1 % plus 0.02 dB, also across the boundary of two blocks."""
    n = np.arange(8000)
    wave = np.exp(2j * np.pi * frequency / RATE * n)
    listener = Listener(distance=distance, elevation=0.5, air=Air())
    advance = propagation_filter(listener, RATE)
    stems = np.column_stack([wave.real, wave.imag])
    out = np.vstack([advance(stems[:3001]), advance(stems[3001:])]) @ [1, 1j]
    half = absorption_latency(Air(), distance)
    kept = (out[half:] / wave[:-half])[2 * half :]
    taken = absorbed_db(Air(), distance, frequency)
    assert np.abs(-20 * np.log10(np.abs(kept)) - taken).max() < 0.02 + 0.01 * taken
    assert np.abs(np.angle(kept)).max() < 1e-3


def test_the_air_of_a_listener_is_by_default_that_of_a_scene():
    """Until it was annotated, the default air had no absorption, and the filter failed."""
    listener = Listener(distance=100.0, elevation=0.5)
    explicit = Listener(distance=100.0, elevation=0.5, air=Air())
    impulse = np.eye(1, 400, 200).T
    filtered = propagation_filter(listener, RATE)(impulse)
    assert np.array_equal(filtered, propagation_filter(explicit, RATE)(impulse))
    assert filtered.sum() == pytest.approx(1.0, abs=1e-3)  # no absorption at 0 Hz


def test_near_by_nothing_is_filtered_and_the_plan_says_how_much_that_is():
    scene = load_scene("published")
    assert absorption_latency(scene.air, 0.5) == 0
    assert not absorption_sentences(scene)[0]
    assert "0.053 dB at 8 kHz" in absorption_sentences(scene)[1][0]
    far = scene.replace("audio.distance=10")
    assert "1.1 dB at 8 kHz" in absorption_sentences(far)[0][0]
    assert not absorption_sentences(far)[1]
    assert (
        absorption_latency(scene.replace("air.pressure=0", "air.density=0").air, 100.0)
        == 0
    )


def test_a_listener_afar_hears_the_same_instant_through_more_air(monkeypatch):
    """The rendered sound equals the unfiltered one convolved with the filter, sample by sample."""
    scene = load_scene("published").replace(
        "audio.distance=10", "numerics.time_limit=0.5", "numerics.accuracy=draft"
    )
    motion = simulate(scene)
    modes = eigenmodes(scene, below=5000.0)
    heard = np.vstack(list(Renderer(scene, motion, modes).blocks(10000)))
    monkeypatch.setattr(absorption, "MIN_AUDIBLE_ABSORPTION_DB", np.inf)
    open_air = np.vstack(list(Renderer(scene, motion, modes).blocks(10000)))
    assert len(heard) == len(open_air)
    taps = absorbing_taps(scene)
    middle = slice(RATE // 20, RATE // 3)
    for mine, other in zip(heard.T, open_air.T, strict=True):
        expected = np.convolve(other, taps, "same")
        assert np.abs(mine - expected)[middle].max() < 1e-9 * np.abs(other).max()
    assert np.abs(heard - open_air)[middle].max() > 1e-4 * np.abs(open_air).max()


def absorbing_taps(scene):
    """Return the impulse response of the absorption filter."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(absorption, "MIN_AUDIBLE_ABSORPTION_DB", 0.0)
        return absorption_taps(scene.air, 10.0, RATE)
