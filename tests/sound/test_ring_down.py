"""Claim: after the air film has taken over the disk, its modes decay at the stated rates down to
-60 dB.

Source: the contact has ended, so that material, radiation and the air film at the mean gap of that
instant damp the modes. Oracle: the poles of the rendered pressure by a matrix pencil (Hua and
Sarkar 1990), which uses no modal data; the slope of the logarithm of a band-passed envelope; loss
factor times pi times frequency, plus the radiated power.
"""

import json

import numpy as np
import pytest
from scipy.signal import butter, hilbert, sosfiltfilt

from dynamics import Outcome, plan_motion
from modal import radiation_decay
from sonify import load_scene, run
from sonify.plan.plan import decay_decision, omissions_after_end
from sonify.plan.preflight import plan_with_modes, solve_motion
from sonify.sound.audible_modes import MAX_RING_TIME, RING_DOWN_DB, RingDown
from sonify.sound.audible_modes import ring_down_time as audible_for
from sonify.sound.force import ContactForce
from sonify.sound.radiation import listener_of
from sonify.sound.render import Renderer
from sonify.sound.response import SolvedModes
from sonify.sound.sources.protocol import FADE_OUT


def poles(samples, rate, count):
    """Return frequencies [Hz] and decay rates [1/s] (count,) of damped sines in samples (n,)."""
    rows = np.lib.stride_tricks.sliding_window_view(samples, len(samples) // 2)
    signal = np.linalg.svd(rows, full_matrices=False)[2][: 2 * count].T
    z = rate * np.log(
        np.linalg.eigvals(np.linalg.pinv(signal[:-1]) @ signal[1:]).astype(complex)
    )
    z = z[z.imag > 0]
    z = z[np.argsort(z.imag)]
    return z.imag / (2 * np.pi), -z.real


def level_db(samples):
    return 10 * np.log10(np.mean(np.square(samples)))


def assert_rings_as_stated(pressure, rate, end, ringing, first, last):
    """Assert that the sound from `first` to `last` [s] after its end has the poles of the stated
    modes, beside one that does not oscillate: the disk that still sinks."""
    part = pressure[int((end + first) * rate) : int((end + last) * rate)].astype(float)
    frequency, decay_rate = poles(part, rate, len(ringing.frequency) + 1)
    order = np.argsort(ringing.frequency)
    assert frequency == pytest.approx(ringing.frequency[order], rel=1e-4)
    assert decay_rate == pytest.approx(ringing.decay_rate[order], rel=0.02)


@pytest.fixture(scope="module")
def carried():
    """The renderer and the pressure of the published disk, released at 3 degrees and finally
    carried by the air film."""
    changes = (
        "air.film=acts",
        "support.kind=free",
        "release.inclination_deg=3",
        "release.omega=[0.0,0.0,-7.2]",
    )
    scene = load_scene("published").replace("numerics.accuracy=draft", *changes)
    plan, modes = plan_with_modes(scene)
    motion = solve_motion(plan_motion(scene))
    assert motion.rolling_outcome is Outcome.AIRBORNE
    renderer = Renderer(scene, motion, modes, plan.sounding)
    return renderer, np.vstack(list(renderer.blocks())).sum(axis=1)


def test_the_modes_ring_at_the_stated_rates_once_the_air_carries_the_disk(carried):
    renderer, pressure = carried
    ringing = renderer.ringing
    rate = renderer.sample_rate
    assert_rings_as_stated(pressure, rate, renderer.rest, ringing, 0.005, 0.045)
    sos = butter(4, [16e3, 18e3], "band", fs=rate, output="sos")
    first = int((renderer.rest + 0.01) * rate)
    envelope = np.abs(hilbert(sosfiltfilt(sos, pressure)))[first : first + rate // 10]
    slope = np.polyfit(np.arange(len(envelope)) / rate, np.log(envelope), 1)[0]
    highest = np.argmax(ringing.frequency)
    assert -slope == pytest.approx(ringing.decay_rate[highest], rel=0.02)


def test_the_stated_rate_is_that_of_material_radiation_and_film(carried):
    renderer, _ = carried
    scene = renderer.scene
    modes = renderer.modes
    ringing = renderer.ringing
    material = np.pi * modes.frequency * scene.material.loss_factor
    upwards = radiation_decay(modes, faces=[1], air=listener_of(scene).air)
    assert ringing.decay_rate_without_film == pytest.approx(
        material + upwards, rel=1e-3
    )
    landing = renderer.motion.landing
    assert ringing.gap == pytest.approx(landing.film_gap(landing.t_end)[0])
    by_film = ringing.decay_rate - ringing.decay_rate_without_film
    assert (
        by_film[:2] > 3 * ringing.decay_rate_without_film[:2]
    ).all()  # the film shortens the ring


def test_the_end_of_the_contact_does_not_mute_what_rings(carried):
    """The contact force falls to zero continuously at the end.

    It drives the modes up to the last instant and not afterwards.
    """
    renderer, _ = carried
    sampler = renderer.sampler
    end = renderer.motion.switch_time
    dwell = 1e-3  # s; the low point presses without the lift of the compressed air
    last = np.array([end - 0.004, end - 0.002])
    state, force = renderer.motion.at_and_force(last)
    film = renderer.motion.film_loads(last, state)
    drive = renderer.sources[1].input_channels(force, state, film)[:, 3:]
    assert np.abs(drive).max() > 0
    assert sampler._evaluate_channels(last)[1][
        :, -len(renderer.modes) :
    ] == pytest.approx(drive)
    assert sampler._apply_fade(last, sampler._evaluate_channels(last)[1])[
        :, -len(renderer.modes) :
    ] == pytest.approx(drive)
    after = sampler.block(
        int(np.ceil((end + dwell - sampler.start) * sampler.sample_rate)), 5
    )
    assert after.samples[:, -len(renderer.modes) :] == pytest.approx(0.0, abs=1e-12)


def test_the_sound_continues_until_the_ring_is_60_db_down_and_no_longer(carried):
    renderer, pressure = carried
    rate = renderer.sample_rate
    end = renderer.rest
    audible = audible_for(renderer.modes, renderer.scene, renderer.ringing.decay_rate)
    assert (
        3 * np.log(10) / renderer.ringing.decay_rate.max() / 2 < audible < MAX_RING_TIME
    )
    assert len(pressure) == pytest.approx((end + audible + FADE_OUT) * rate, abs=1)
    tail = pressure[int(end * rate) : -int(FADE_OUT * rate)]
    width = rate // 200
    assert (
        np.abs(tail)
        .reshape(-1)[: len(tail) // width * width]
        .reshape(-1, width)
        .max(axis=1)
        > 0
    ).all()
    assert level_db(tail[-width:]) < level_db(tail[:width]) - RING_DOWN_DB + 15
    assert (
        np.abs(pressure[-width:]).max() > 0
    )  # the file ends with the ring, without digital zero


def test_the_plan_states_the_decay_and_names_the_landing(carried):
    renderer, _ = carried
    decision = decay_decision(renderer.ringing)
    for frequency, decay_rate in zip(
        renderer.ringing.frequency, renderer.ringing.decay_rate, strict=True
    ):
        assert f"{frequency:.0f} Hz: {decay_rate:.3g} 1/s" in decision.choice
    assert f"{1e6 * renderer.ringing.gap:.3g} um" in decision.reason
    assert any("lands" in line for line in omissions_after_end(renderer.motion))


class Swinging:
    """A motion of 0.01 s with one mode, which has displacement 0 and velocity 1 at the end."""

    t = np.array([0.0, 0.01])

    def vibration(self, t):
        return np.tile([[0.0], [1.0], [0.0]], (len(t), 1, 1))


def test_modes_that_a_motion_carries_ring_as_stated_too():
    ringing = RingDown(
        frequency=np.array([1e3]),
        decay_rate=np.array([200.0]),
        decay_rate_without_film=np.array([5.0]),
        gap=1e-4,
    )
    t = np.arange(2400) / 48e3
    still = np.zeros((len(t), 1))
    force = ContactForce.without_jumps(t, still, still)
    moved = SolvedModes(Swinging(), np.array([0]), ringing).advance(force)[0, :, 0]
    frequency, decay_rate = poles(moved[500:1500], 48e3, 1)
    assert frequency == pytest.approx(np.sqrt(1e6 - (200 / (2 * np.pi)) ** 2), rel=1e-6)
    assert decay_rate == pytest.approx(200.0, rel=1e-6)


@pytest.mark.slow
def test_a_run_writes_a_ring_of_the_stated_rates(tmp_path):
    """The disk vibrates on an elastic, rough contact until the air film lifts it.

    A coin no longer rings when it rests: its modes fall by 58 dB in 10 ms.
    """
    result = run("granite", tmp_path, "draft")
    assert result.motion.outcome is Outcome.AT_REST
    assert result.motion.rolling_outcome is Outcome.AIRBORNE
    sound = result.sound
    record = json.loads((tmp_path / "run.json").read_text())
    assert record["sound"]["ring_down"]["decay_rate"] == pytest.approx(
        sound.ringing.decay_rate.tolist()
    )
    assert (
        json.loads((tmp_path / "modes.json").read_text())["ring_down"]
        == record["sound"]["ring_down"]
    )
    assert_rings_as_stated(
        sound.pressure.read(),
        sound.sample_rate,
        sound.source_end + result.motion.landing.t_end,
        sound.ringing,
        0.01,
        0.05,
    )
    assert any("lands" in line for line in record["plan"]["left_out"])
