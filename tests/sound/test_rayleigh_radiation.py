"""Claim: the pressure at the listener is Rayleigh's integral over the face of the disk.

Source: Rayleigh, The Theory of Sound, section 278. Oracle: the baffled piston in closed form, on
its axis and far away (Kinsler & Frey, chapter 7), and the integral by Gauss quadrature.
"""

import numpy as np
import pytest
from arithmetic import gamma
from scipy.special import j1

from sonify.plan.preflight import plan_with_modes
from sonify.sound.radiation import (
    AIR_DENSITY,
    SOUND_SPEED,
    Listener,
    heave_kernel,
    mode_taps,
    piston_strength,
    rayleigh,
    tabulated_directivity,
    tilt_kernel,
)

RADIUS = 0.03755
FREQUENCY = np.array([10.0, 300.0, 1000.0, 3000.0, 6000.0, 10000.0])


@pytest.fixture(scope="module")
def face():
    return face_with_hole(0.0, 30)


def face_with_hole(hole, count):
    """Return points (p, 2), weights (p,) and the shapes 1 and x/R (2, p) on a disk with a hole, with
    `count` points along a radius."""
    x, w = np.polynomial.legendre.leggauss(count)
    radius = hole + (x + 1) / 2 * (RADIUS - hole)
    angle = 2 * np.pi * np.arange(90) / 90
    points = np.column_stack(
        [np.outer(radius, f(angle)).ravel() for f in (np.cos, np.sin)]
    )
    weights = np.repeat(w / 2 * (RADIUS - hole) * radius, 90) * 2 * np.pi / 90
    return points, weights, np.array([np.ones(len(points)), points[:, 0] / RADIUS])


def pressure(face, shape, frequency, at):
    points, weights, shapes = face
    k = np.atleast_1d(2 * np.pi * frequency / SOUND_SPEED)
    return rayleigh(
        np.repeat(shapes[[shape]], len(k), axis=0), points, weights, k, np.asarray(at)
    )


def test_on_the_axis_of_a_piston(face):
    d = 0.3
    k = 2 * np.pi * FREQUENCY / SOUND_SPEED
    expected = (
        AIR_DENSITY / (1j * k) * (1 - np.exp(-1j * k * (np.hypot(d, RADIUS) - d)))
    )
    assert pressure(face, 0, FREQUENCY, [0, 0, d]) == pytest.approx(expected, rel=1e-9)


def test_far_from_a_piston(face):
    d = 300.0
    elevation = np.radians(40)
    k = 2 * np.pi * FREQUENCY / SOUND_SPEED
    x = k * RADIUS * np.cos(elevation)
    expected = piston_strength(RADIUS, d) * 2 * j1(x) / x
    found = pressure(
        face, 0, FREQUENCY, [d * np.cos(elevation), 0, d * np.sin(elevation)]
    )
    assert np.abs(found - expected).max() < 1e-3 * piston_strength(RADIUS, d)


@pytest.mark.parametrize(("shape", "kernel"), [(0, heave_kernel), (1, tilt_kernel)])
@pytest.mark.parametrize("elevation_deg", [0.0, 45.0, 80.0])
def test_the_kernels_are_rayleighs_integral_at_all_frequencies(
    face, shape, kernel, elevation_deg
):
    listener = Listener(distance=1.0, elevation=np.radians(elevation_deg))
    h = 1 / 192000
    at = np.array([np.cos(listener.elevation), 0, np.sin(listener.elevation)])
    expected = pressure(face, shape, FREQUENCY, at) / piston_strength(RADIUS, 1.0)
    _, taps = kernel(listener, RADIUS, h)
    n = np.arange(len(taps)) - len(taps) // 2
    found = np.exp(-2j * np.pi * np.outer(FREQUENCY, n) * h) @ taps
    assert (
        np.abs(found - expected).max() < 0.06
    )  # the phase k R^2 / 2 d of the near field, 0.1 at 10 kHz
    assert np.abs(found - expected)[:3].max() < 0.01


@pytest.mark.parametrize(("shape", "kernel"), [(0, heave_kernel), (1, tilt_kernel)])
@pytest.mark.parametrize("elevation_deg", [0.0, 45.0])
def test_the_kernels_of_a_face_with_a_hole_are_rayleighs_integral_over_what_is_left(
    shape, kernel, elevation_deg
):
    hole = 0.92 * RADIUS
    h = 1 / 192000
    listener = Listener(distance=1.0, elevation=np.radians(elevation_deg))
    at = np.array([np.cos(listener.elevation), 0, np.sin(listener.elevation)])
    expected = pressure(
        face_with_hole(hole, 12), shape, FREQUENCY, at
    ) / piston_strength(RADIUS, 1.0)
    _, taps = kernel(listener, RADIUS, h, hole)
    n = np.arange(len(taps)) - len(taps) // 2
    found = np.exp(-2j * np.pi * np.outer(FREQUENCY, n) * h) @ taps
    share = 1 - (hole / RADIUS) ** (2, 4)[shape]
    assert found[0] == pytest.approx(expected[0], abs=2e-3 * share)
    assert (
        np.abs(found - expected).max() < 0.15 * share
    )  # the phase k R^2 / 2 d of the near field, 0.13 at 10 kHz


@pytest.mark.parametrize("hole", [0.0, 0.9 * RADIUS])
@pytest.mark.parametrize("kernel", [heave_kernel, tilt_kernel])
def test_the_step_response_is_that_of_the_taps(kernel, hole):
    """Over many samples a step between two samples equals the ramp from one to the next."""
    listener = Listener(distance=1.0, elevation=0.3)
    h = 1e-7
    step, taps = kernel(listener, RADIUS, h, hole)
    t = (np.arange(len(taps)) - len(taps) // 2) * h
    assert np.abs(step(t + h / 2) - np.cumsum(taps)).max() < 1e-2
    assert step(np.array([-1.0]))[0] == pytest.approx(0, abs=gamma(20))


def test_a_piston_seen_from_above_is_at_least_a_sample_wide():
    step, taps = heave_kernel(
        Listener(distance=1.0, elevation=np.pi / 2), RADIUS, 1 / 48000
    )
    assert taps.sum() == pytest.approx(1)
    assert step(np.array([0.0]))[0] == 0.5
    assert np.abs(
        tilt_kernel(Listener(distance=1.0, elevation=np.pi / 2), RADIUS, 1 / 48000)[1]
    ).max() < gamma(20)


@pytest.fixture(scope="module")
def modes(scene):
    return plan_with_modes(scene)[1]


@pytest.mark.parametrize("sample_rate", [48000, 96000, 192000])
def test_the_taps_radiate_a_mode_exactly_at_its_own_frequency_and_at_rest(
    modes, sample_rate
):
    listener = Listener(distance=0.5, elevation=np.radians(45))
    delays = np.outer(2 * np.pi * modes.frequency / sample_rate, [1, 0, -1])
    three = mode_taps(modes, listener, sample_rate)
    exact = tabulated_directivity(modes, listener, 512)
    found = np.sum(three * np.exp(1j * delays), axis=2)
    bar = gamma(20) * np.abs(three).sum(axis=2)
    assert (np.abs(found - exact) <= bar).all()
    assert (
        np.abs(
            three.sum(axis=2)
            - tabulated_directivity(modes, listener, 512, at_zero_frequency=True).real
        )
        <= bar
    ).all()


def test_the_taps_stay_bounded_at_half_the_sample_rate(modes):
    listener = Listener(distance=0.5, elevation=np.radians(45))
    highest = modes.frequency[-1]
    far, near = (
        np.abs(mode_taps(modes, listener, rate * highest)[:, -1]).max()
        for rate in (2.2, 2.0001)
    )
    assert near < 20 * far
