"""Claim: the contact stem is the sound of the additional force from an elastic, rough contact,
radiated by the same disk.

Source: linear systems; Rayleigh's integral over a disk; the resonance of the contact
(dynamics/compliant/law/linearised.py). Oracle: transfer functions in closed form, the same force
supplied directly, symmetry, repetition.
"""

import tracemalloc
from concurrent.futures import ThreadPoolExecutor
from types import SimpleNamespace

import numpy as np
import pytest
from contact_scenes import steady_precession_rate, steady_speed
from scenes import Attitudes
from scipy.signal import welch
from scipy.special import jv

from dynamics import Outcome, simulate
from dynamics.compliant.law.height_profile import SMOOTH_PROFILE
from dynamics.compliant.law.linear_response import predicted_spectrum
from dynamics.compliant.model_inputs import contact_law, tabulated_contact_law
from dynamics.motion import ForceJumps
from modal import eigenmodes
from modal.radiation import SOUND_SPEED
from sonify import load_scene
from sonify.scene import from_document
from sonify.sound.modal_forcing import in_patch_frame, rigid_acceleration
from sonify.sound.radiation import piston_strength
from sonify.sound.render import Renderer
from sonify.sound.sources.contact import (
    ContactFilter,
    ContactVibration,
    decimate,
    windowed_sinc_taps,
)

RATE = 48000
HEARD = RATE // 2
"""Number of evaluated samples."""


@pytest.fixture(scope="module")
def rough():
    changes = (
        "support.kind=free",
        "contact.law=elastic",
        "numerics.contact=filter",
        "numerics.time_limit=0.6",
    )
    return load_scene("published").replace(
        *changes, "roughness.rms=1e-8", "material.loss_factor=0.05"
    )


@pytest.fixture(scope="module")
def moved(rough):
    return simulate(rough), eigenmodes(rough, below=18e3)


def rows(scene, moved, size=1 << 16, wanted=(0, 1)):
    return np.vstack(list(Renderer(scene, *moved, wanted).blocks(size)))


def test_the_other_stems_are_those_of_the_rigid_contact_and_the_sum_has_one_more(
    rough, moved
):
    rigid = rough.replace("contact.law=rigid")
    assert Renderer(rough, *moved).names == (
        "heave",
        "tilt",
        "ringing_smooth",
        "ringing_jumps",
        "contact",
    )
    assert np.array_equal(rows(rigid, moved), rows(rough, moved)[:, :4])


def test_the_bits_depend_on_neither_block_nor_thread(rough, moved):
    """The stem, as written in single precision, is identical for every block size and thread.

    In double precision the last bits of sums of products depend on the memory alignment of a
    thread.
    """
    once = rows(rough, moved)[:, 4].astype(np.float32)
    with ThreadPoolExecutor(2) as pool:
        others = list(
            pool.map(
                lambda size: rows(rough, moved, size)[:, 4].astype(np.float32),
                (777, 1 << 16),
            )
        )
    assert all(np.array_equal(once, other) for other in others)
    assert once.any()


@pytest.mark.slow
def test_another_seed_is_another_sound_as_loud(rough, moved):
    """Noise with a bandwidth of 100 Hz and a duration of 0.5 s has correlations of about
    1/sqrt(100) and levels that scatter by half of that."""
    smooth = rows(without_roughness(rough), moved)[:, 4]
    stems = [
        (rows(rough.replace(f"roughness.seed={seed}"), moved)[:, 4] - smooth)[:HEARD]
        for seed in range(3)
    ]
    levels = [np.sqrt(np.mean(stem**2)) for stem in stems]
    assert levels == pytest.approx([np.mean(levels)] * 3, rel=4 / 2 / np.sqrt(100))
    assert abs(np.corrcoef(stems)[np.triu_indices(3, 1)]).max() < 4 / np.sqrt(100)


def test_the_sound_is_linear_in_the_heights_and_without_them_only_slips_ring(
    rough, moved
):
    none = rows(without_roughness(rough), moved)[:, 4]
    one, two = (
        rows(rough.replace(f"roughness.rms={rms}"), moved)[:, 4] for rms in (1e-8, 2e-8)
    )
    assert two - none == pytest.approx(2 * (one - none), abs=1e-9 * np.abs(two).max())
    assert 0 < np.abs(none).max() < np.abs(one).max()


def without_roughness(scene):
    return from_document(
        {key: part for key, part in scene.document.items() if key != "roughness"}
    )


def steadily(table, beta, seconds):
    """Return the motion of a disk that slides steadily under its weight on a tabulated law."""
    law = table.law
    disk = law.disk
    speed = steady_speed(law, beta)
    weight = [0.0, 0.0, disk.weight]
    none = ForceJumps(np.zeros(0), np.zeros((0, 3)), np.zeros((0, 3)))

    def at(t):
        state = np.zeros((len(t), 11))
        state[:, 0] = steady_precession_rate(law, beta) * t
        state[:, 1] = beta
        state[:, 2] = -speed / disk.radius * t
        return state

    t = np.array([0.0, seconds])
    return Attitudes(
        disk, at(t), t, jumps=none, at=at,
        force=lambda t: np.tile(weight, (len(t), 1)), at_and_force=lambda t: (at(t), np.tile(weight, (len(t), 1))),
        bandwidth=lambda state: np.full(len(state), 100.0), regime=lambda t: np.full(len(t), "slide"),
        rolling_outcome=Outcome.ROLLING_ON,
        plan=SimpleNamespace(
            film=None,
            tabulated_law=table,
            filter_is_two_way=False,
            surface_modes=None,
            plate_mobility=0.0,
            scene=SimpleNamespace(
                surface=SimpleNamespace(kind="rigid"), roughness=None
            ),
        ),
    )  # fmt: skip


def piston_responses(scene, beta, f):
    """Return the directivities (n,) of heave and tilt at frequencies f (n,) [Hz], per unit force."""
    disk = scene.disk
    elevation = np.radians(scene.audio.elevation_deg)
    distance = scene.audio.distance
    x = np.maximum(2 * np.pi * f, 1.0) * disk.radius * np.cos(elevation) / SOUND_SPEED
    turn = rigid_acceleration(
        in_patch_frame([[0.0, 0.0, 1.0]], np.array([beta])), disk
    )[0, 4]
    near = (
        disk.radius
        * np.cos(elevation)
        / distance
        * (2 * jv(2, x) / x - 2 * jv(3, x))
        / x
    )
    heave = 2 * jv(1, x) / x / disk.mass
    return heave, disk.radius * turn * np.hypot(2 * jv(2, x) / x, near)


@pytest.mark.parametrize("beta", [0.1, 0.01])
def test_a_steady_disk_that_slides_on_roughness_has_the_spectrum_of_closed_form(
    rough, beta
):
    """The spectrum is that of N' from the mobility and the heights, times the pressure of a heaving
    and tilting disk.

    The disk turns under the listener: half the power of the tilt counts, and its cross term with
    the heave vanishes. The modes are omitted; only the table is rough, since the edge would repeat
    and produce spectral lines.
    """
    seconds = 8.0
    scene = rough.replace("roughness.rms_edge=0.0")
    disk = scene.disk
    law = contact_law(scene)
    speed = steady_speed(law, beta)
    table = tabulated_contact_law(scene)
    motion = steadily(table, beta, seconds)
    free = eigenmodes(scene, below=18e3)
    added = ContactVibration(
        scene,
        motion,
        *Renderer(scene.replace("contact.law=rigid"), motion, free, []).sources,
    )
    n = int(seconds * RATE)
    pressure = added.make_block_renderer(np.zeros(0), None)(
        SimpleNamespace(t=np.arange(n + 1) / RATE)
    )[RATE:, 0]
    f, power = welch(pressure, RATE, nperseg=1 << 13)
    heave, tilt = piston_responses(scene, beta, f)
    theory = predicted_spectrum(
        table,
        scene.roughness,
        beta,
        disk.weight,
        speed,
        f[1:],
        rolls=False,
    )
    expected = (
        piston_strength(disk.radius, scene.audio.distance) ** 2
        * (heave**2 + tilt**2 / 2)[1:]
        * theory
    )
    around = slice(f.searchsorted(300.0), f.searchsorted(6000.0))
    assert power[1:][around].sum() == pytest.approx(expected[around].sum(), rel=0.15)
    assert f[1:][around][power[1:][around].argmax()] == pytest.approx(
        f[1:][around][expected[around].argmax()], rel=0.02
    )


def test_decimation_keeps_what_is_below_half_the_rate():
    """The Hann window of 16 samples attenuates to -44 dB within an eighth of the rate; the samples
    belong to the stated instants."""
    over = 3
    weight = windowed_sinc_taps(3)
    t = np.arange(-len(weight) // 2 + 1, 3 * 400) / (over * RATE)
    for tone, kept in ((4e3, 1.0), (17e3, 1.0), (31e3, 0.0), (50e3, 0.0)):
        found = decimate(np.cos(2 * np.pi * tone * t)[:, None], weight, over)[:, 0]
        instants = np.arange(len(found)) / RATE + t[len(weight) // 2]
        assert found == pytest.approx(
            kept * np.cos(2 * np.pi * tone * instants), abs=10 ** (-44 / 20)
        )


def test_filter_and_full_model_sound_alike_where_the_disk_rolls():
    """The levels agree within 10 % while the disk rolls.

    The surfaces are the same, but the contact paths differ by more than one wavelength of the
    roughness.
    """
    scene = load_scene("polished").replace(
        "air.film=none", "numerics.time_limit=1.2", "material.loss_factor=0.05"
    )
    modes = eigenmodes(scene, below=18e3)
    heard = slice(RATE // 4, int(1.1 * RATE))
    levels = {}
    for kind in ("filter", "full"):
        solved = scene.replace(f"numerics.contact={kind}", "numerics.accuracy=draft")
        motion = simulate(solved)
        assert set(motion.regime(np.linspace(0.25, 1.1, 200))) == {"roll"}
        renderer = Renderer(solved, motion, modes, (0, 1))
        assert renderer.names[-1] == "contact"
        stems = np.vstack(list(renderer.blocks()))[heard]
        levels[kind] = np.sqrt(np.mean(stems[:, [0, 1, 4]] ** 2, axis=0))
    assert levels["filter"] == pytest.approx(levels["full"], rel=0.1)


@pytest.mark.slow
def test_memory_does_not_grow_with_the_length(rough):
    """The test compares a steady disk over 6 s and over 60 s."""
    table = tabulated_contact_law(rough)
    peaks = []
    for seconds in (6.0, 60.0):
        motion = steadily(table, 0.1, seconds)
        tracemalloc.start()
        frames = sum(
            len(block)
            for block in ContactFilter(
                motion, table, (SMOOTH_PROFILE, SMOOTH_PROFILE), RATE, 0.0
            ).blocks()
        )
        peaks.append(tracemalloc.get_traced_memory()[1])
        tracemalloc.stop()
        assert frames == pytest.approx(seconds * RATE, abs=RATE)
    assert peaks[1] < 1.1 * peaks[0]
