"""Claim: the sound at the ears of a head and at a microphone near the disk is that of a rigid
sphere and of the near field.

Source: Duda & Martens 1998, J. Acoust. Soc. Am. 104, 3048; Kuhn 1977 and Woodworth 1938 for
the interaural time; Rayleigh's integral. Oracle: the incident and scattered waves with SciPy's
Bessel functions; the static potential in closed form; the pressure on the axis of a piston in
closed form; the distant kernels; finite elements around the disk.
"""

import numpy as np
import pytest
import soundfile
from scipy.sparse import csc_matrix
from scipy.sparse.linalg import splu
from scipy.special import eval_legendre, spherical_jn

from benchmarks.references import exterior_field
from benchmarks.references.exterior_field import ExteriorField
from modal.radiation import SOUND_SPEED
from sonify import SceneError, load_scene, solve, write
from sonify.sound.block_overlap import overlapping_blocks
from sonify.sound.film_radiation import EXTERIOR_MEAN_GAPS
from sonify.sound.force import ContactForce
from sonify.sound.head import EAR_LATENCY, Ear, ear_pressure_ratio, ear_taps
from sonify.sound.multipoles import associated_legendre, outgoing_hankel
from sonify.sound.near_field import (
    near_face_kernels,
    near_rim_kernels,
    rayleigh_waves,
)
from sonify.sound.radiation import (
    Listener,
    heave_kernel,
    listeners_of,
    tilt_kernel,
)
from sonify.sound.sources.protocol import SoundSource

HEAD = 0.0875  # m
RATE = 48000


def ear_at(degrees, distance=100.0):
    return Ear(
        head_radius=HEAD,
        source_distance=distance,
        cosine=float(np.cos(np.radians(degrees))),
    )


def scattered_by_hand(ear, hertz, terms=60):
    """Return the ratio as the sum of incident and scattered waves of a rigid sphere."""
    k = 2 * np.pi * hertz / SOUND_SPEED
    x = k * ear.head_radius
    total = 0
    for m in range(terms):
        scattered = spherical_jn(m, x, True) / outgoing_hankel(m, x, True)
        total += (
            (2 * m + 1)
            * eval_legendre(m, ear.cosine)
            * outgoing_hankel(m, k * ear.source_distance)
            * (spherical_jn(m, x) - scattered * outgoing_hankel(m, x))
        )
    return -1j * k * total * ear.path * np.exp(1j * k * ear.path)


@pytest.mark.parametrize("distance", [0.2, 0.5, 100.0])
@pytest.mark.parametrize("degrees", [0, 60, 120, 180])
def test_the_series_is_the_sum_of_incident_and_scattered_waves(distance, degrees):
    ear = ear_at(degrees, distance)
    hertz = np.array([300.0, 1000.0, 4000.0, 9000.0])
    expected = [scattered_by_hand(ear, f) for f in hertz]
    assert ear_pressure_ratio(ear, hertz) == pytest.approx(expected, abs=1e-7)


@pytest.mark.parametrize("degrees", [0.5, 45, 90, 179])
def test_slow_sound_is_the_static_potential_around_a_sphere(degrees):
    """sum (2 m + 1)/(m + 1) P_m t^(m + 1) = 2 t/D - ln((t - cos + D)/(1 - cos))."""
    ear = ear_at(degrees, 0.15)
    t = HEAD / 0.15
    root = np.sqrt(1 - 2 * t * ear.cosine + t * t)
    series = 2 * t / root - np.log((t - ear.cosine + root) / (1 - ear.cosine))
    found = ear_pressure_ratio(ear, np.array([0.01]))[0]
    assert found == pytest.approx(series * ear.path / HEAD, rel=1e-4)


def test_the_near_side_doubles_the_pressure_and_the_ears_are_known_times_apart():
    """The interaural time is 3 (a/c) sin at low, (a/c) (angle + sin) at high frequency.

    The creeping waves of the far ear are slower than rays, at 30 kHz by 1.6 %.
    """
    assert abs(ear_pressure_ratio(ear_at(0), np.array([3e4]))) == pytest.approx(
        2, rel=0.005
    )
    for degrees in (30, 60):
        turn = np.radians(degrees)
        ears = ear_at(90 - degrees), ear_at(90 + degrees)
        hertz = np.append(20.0, np.linspace(20, 30000, 15000))
        phases = [
            np.unwrap(np.angle(ear_pressure_ratio(ear, hertz)))
            - 2 * np.pi * hertz * ear.path / SOUND_SPEED
            for ear in ears
        ]
        time = (phases[0] - phases[1]) / (2 * np.pi * hertz)
        assert time[0] == pytest.approx(3 * HEAD / SOUND_SPEED * np.sin(turn), rel=1e-3)
        assert time[-1] == pytest.approx(
            HEAD / SOUND_SPEED * (turn + np.sin(turn)), rel=0.02
        )


@pytest.mark.parametrize("degrees", [0, 90, 150])
def test_the_filter_of_an_ear_has_this_response(degrees):
    ear = ear_at(degrees, 0.5)
    taps = ear_taps(ear, RATE)
    hertz = np.array([50.0, 500.0, 5000.0, 15000.0, 20000.0])
    late = np.arange(len(taps)) - EAR_LATENCY
    found = np.exp(-2j * np.pi / RATE * np.outer(hertz, late)) @ taps
    assert found == pytest.approx(ear_pressure_ratio(ear, hertz), abs=0.005)


def response(kernel, hertz, h):
    """Return the frequency response of the taps of a kernel."""
    late = (np.arange(len(kernel[1])) - len(kernel[1]) // 2) * h
    return np.exp(-2j * np.pi * np.outer(hertz, late)) @ kernel[1]


@pytest.mark.parametrize("distance", [0.03, 0.1])
def test_a_step_on_the_axis_is_that_of_a_piston_in_closed_form(distance):
    """p = rho c (t - z/c) a until the wave of the rim arrives."""
    disk = load_scene("published").disk
    height = disk.thickness / 2
    near = Listener(distance=distance, elevation=np.pi / 2, face_height=height)
    step = near_face_kernels(near, disk, 1 / RATE)[0][0]
    path = np.linspace(distance - height, np.hypot(distance - height, disk.radius), 50)
    unit = disk.radius**2 / (2 * distance)
    found = unit * step((path - distance) / SOUND_SPEED)
    assert found == pytest.approx(path - path[0], abs=2e-3 * path[-1])


@pytest.mark.parametrize("elevation", [20.0, 45.0])
def test_far_away_the_near_kernels_are_the_distant_ones(elevation):
    """The difference falls as the square of radius over distance, and so does that of the rim.

    The rim radiates like the face where its size does not matter.
    """
    disk = load_scene("published").disk
    h = 1 / RATE
    hertz = np.array([50.0, 500.0, 2000.0])
    for radii, error in ((4, 0.03), (16, 0.004)):
        far = Listener(distance=radii * disk.radius, elevation=np.radians(elevation))
        near = Listener(
            distance=far.distance, elevation=far.elevation, face_height=1e-12
        )
        distant = [
            kernel(far, disk.radius, h) for kernel in (heave_kernel, tilt_kernel)
        ]
        for mine, other in zip(near_face_kernels(near, disk, h), distant, strict=True):
            expected = np.abs(response(other, hertz, h))
            found = np.abs(response(mine, hertz, h))
            assert found == pytest.approx(expected, rel=error)
        rim = near_rim_kernels(near, disk, h)[:2]
        for mine, other in zip(rim, distant, strict=True):
            slow = np.abs(response(other, hertz[:1], h))
            found = np.abs(response(mine, hertz[:1], h))
            assert found == pytest.approx(slow, rel=0.01 + 1 / radii**2)


def pressure_of_elements(field, n, k, place):
    """Return the pressures (3,) of heave, tilt and rim flow at one place inside the hemisphere."""
    r, z = exterior_field.quadrature_coordinates(field._hemisphere)
    shapes = associated_legendre(n, z / np.hypot(r, z))
    load = exterior_field.boundary_load_form
    waves = [load.assemble(field._hemisphere, weight=w) for w in shapes]
    waves = np.array(waves) / field.far**2
    order = n + 2 * np.arange(len(waves))
    outgoing = outgoing_hankel(order, k * field.far, True)
    outgoing = k * field.far**2 * outgoing / outgoing_hankel(order, k * field.far)
    stiffness, azimuthal, mass = field._forms
    matrix = stiffness + n * n * azimuthal - k * k * mass
    matrix = (matrix - csc_matrix((waves.T * outgoing) @ waves)).tocsc()
    free = np.setdiff1d(np.arange(waves.shape[1]), field._axis if n else [])
    pressure = np.zeros((waves.shape[1], 3), complex)
    loads = field.loads.T[free].astype(complex)
    pressure[free] = splu(matrix[free][:, free]).solve(loads)
    return (field._basis.probes(place) @ pressure)[0]


@pytest.mark.parametrize(("height", "error_db"), [(0.34, 4.0), (0.05, 1.1)])
def test_finite_elements_around_the_disk_differ_by_what_the_plan_says(height, error_db):
    """At 1.2 and 0.8 radii from the centre the disk's edge scatters the sound."""
    scene = load_scene("granite")
    thickness = height * scene.disk.radius
    scene = scene.replace(f"disk.thickness={thickness}", "contact.fillet=1e-4")
    gap = EXTERIOR_MEAN_GAPS[0]
    far = 1.5 * np.hypot(1.0, height + EXTERIOR_MEAN_GAPS[1])
    field = ExteriorField(height, gap, far)
    for radii, elevation in ((0.8, np.radians(70)), (1.2, np.radians(45))):
        near = Listener(
            distance=radii * scene.disk.radius,
            elevation=elevation,
            face_height=thickness / 2,
        )
        centre = gap + height / 2
        place = radii * np.array([[np.cos(elevation)], [np.sin(elevation)]])
        for k in (0.3, 2.0):
            face, rim = rayleigh_waves(near, scene.disk, np.array([k]), 2)
            waves = [
                pressure_of_elements(field, n, k, place + np.array([[0.0], [centre]]))
                for n in range(2)
            ]
            found = np.abs([face[0, 0], face[0, 1], rim[0, 0], rim[0, 1]])
            expected = np.abs([waves[0][0], waves[1][1], waves[0][2], waves[1][2]])
            assert np.abs(20 * np.log10(found / expected)).max() < error_db


@pytest.mark.slow
def test_a_head_has_two_ears_and_a_near_microphone_is_loud(tmp_path):
    """A head that faces the disk hears it in the middle; turned, on its nearer side."""
    scene = load_scene("published").replace(
        "numerics.time_limit=0.3",
        "numerics.accuracy=draft",
        'audio.listeners=[{distance=0.4, kind="head", facing_deg=90}, '
        "{distance=0.03, elevation_deg=90}]",
    )
    left, right, near = listeners_of(scene)
    assert near.is_in_near_field
    assert not left.is_in_near_field
    assert np.linalg.norm(left.position - right.position) == pytest.approx(2 * HEAD)
    result = solve(scene)
    write(result, tmp_path)
    samples, _ = soundfile.read(tmp_path / "pressure.wav")
    level = np.sqrt(np.mean(samples**2, axis=0))
    assert level[1] > 1.2 * level[0]  # the nose points left of the disk
    assert level[2] > 5 * level[1]
    assert any("rigid sphere" in line for line in result.plan.modelled)
    assert any("4 dB" in line for line in result.plan.left_out)


@pytest.mark.parametrize(
    ("listener", "message"),
    [
        ("{distance=0.03}", "distance = 0.03: must be greater than disk.radius, or"),
        ("{distance=1.0, facing_deg=20}", "facing_deg: requires"),
        ("{distance=0.1, kind='head'}", "distance = 0.1: must be greater than"),
        ("{distance=0.5, kind='head', elevation_deg=3}", "the head would touch"),
    ],
)
def test_impossible_listeners_are_named(listener, message):
    with pytest.raises(SceneError, match=f"audio.listeners.0.*{message}"):
        load_scene("published").replace(f"audio.listeners=[{listener}]")


class LateSource(SoundSource):
    """The force itself, late by some samples, as filters of different lengths at two ears."""

    names = ("late",)
    channel_ends = np.array([[0.0, 0.0]])
    tail_duration = 0.0

    def __init__(self, latency):
        self.latency = latency

    def input_channels(self, force, state, film):
        return force[:, 2:]

    def make_block_renderer(self, first, note):
        extend = overlapping_blocks(self.latency, first=0.0)
        return lambda force: extend(force.samples[1:])[: len(force.t) - 1]


@pytest.mark.parametrize("latencies", [(3, 8), (8, 3), (5, 5)])
def test_both_ears_hear_at_once_whatever_the_length_of_their_filters(latencies):
    first, second = map(LateSource, latencies)
    pair = first.with_second_ear(second, 0.1)
    render = pair.make_block_renderer(np.zeros(2), lambda t, energy: None)
    pulse = np.zeros((41, 2))
    pulse[10] = 1.0
    heard = []
    for start in (0, 20):
        block = pulse[start : start + 21]
        force = ContactForce.without_jumps(np.arange(21.0), block, np.zeros_like(block))
        heard.append(render(force))
    heard = np.concatenate(heard)
    assert pair.latency == max(latencies)
    assert np.array_equal(heard[:, 0], heard[:, 1])
    assert np.flatnonzero(heard[:, 0]).tolist() == [9 + pair.latency]
