"""Claim: the pressure is the sum of its sources, calibrated, free of artificial clicks and
repeatable.

Source: Newton's law for the heave, the equation of motion of the modes, Rayleigh's integral.
Oracle: the monopole at the end of the chain in closed form; the input frequencies and decay rates;
the files read back by libsndfile.
"""

from dataclasses import replace

import numpy as np
import pytest
import soundfile
from arithmetic import gamma

from dynamics import Outcome, simulate
from modal import eigenmodes
from sonify import load_scene
from sonify.hearing.loudness import Audibility
from sonify.sound.modal_forcing import (
    in_patch_frame,
    modal_forcing_function,
    rigid_acceleration,
)
from sonify.sound.pressure import STEMS
from sonify.sound.radiation import listener_of, listeners_of, piston_strength
from sonify.sound.render import FADE_IN, FADE_OUT, Renderer, render_sound
from sonify.sound.sources.protocol import SoundSource
from sonify.sound.wav import write_sound

HEAVE, TILT, SMOOTH, JUMPS = range(4)


@pytest.fixture(scope="module")
def modes(scene):
    return eigenmodes(scene, below=20e3)


@pytest.fixture(scope="module")
def stems(scene, motion, modes):
    return np.vstack(list(Renderer(scene, motion, modes).blocks()))


@pytest.fixture(scope="module")
def short(scene):
    return simulate(scene.replace("numerics.time_limit=0.5"))


def rms(samples):
    return np.sqrt(np.mean(np.square(samples), axis=0))


TABLE = "surface={kind='infinite', thickness=0.01, young=70e9, poisson=0.22, density=2500.0, loss_factor=0.1}"


@pytest.mark.slow
@pytest.mark.parametrize("change", ["name=published", "air.film=acts", TABLE])
def test_another_ear_hears_what_a_listener_there_hears(scene, modes, change):
    """A second ear hears the pressure of a listener at its position.

    The first ear is unchanged, bit for bit, although the modes are computed once for both.
    """
    scene, ear = scene.replace(change), listener_of(scene)
    short = simulate(scene.replace("numerics.time_limit=0.5"))
    both = Renderer(scene, short, modes, turn=1.0).sound().columns
    alone, there = (
        Renderer(scene, short, modes, listener=replace(ear, azimuth=ear.azimuth + turn))
        .sound()
        .columns
        for turn in (0.0, 1.0)
    )
    assert np.array_equal(both[:, :-1], alone)
    rounded = (
        4 * 2.0**-24 * np.abs(there).sum(axis=1)
    )  # the stems, their sum, and the signal of the other ear
    assert (np.abs(both[:, -1] - there[:, 0]) <= rounded).all()
    assert np.abs(there - alone).max() > 0.1 * np.abs(alone).max()


def test_the_heave_is_a_monopole_moved_by_the_normal_force(scene, motion, stems):
    rate = scene.audio.sample_rate
    disk = scene.disk
    t = np.arange(3 * rate, 5 * rate) / rate
    heave = (
        motion.force(t - scene.audio.distance / 343.2)[:, 2] - disk.weight
    ) / disk.mass
    expected = piston_strength(disk.radius, scene.audio.distance) * heave
    assert rms(stems[3 * rate : 5 * rate, HEAVE] - expected) < 0.02 * rms(expected)


def test_nothing_sounds_before_the_sound_arrives_but_what_fades_in(stems, scene):
    assert (
        np.abs(stems[: int(FADE_IN * scene.audio.sample_rate / 4)]).max()
        < 0.2 * np.abs(stems[:48000]).max()
    )


def test_a_settled_disk_is_silent_but_for_its_ringing(scene, motion, stems):
    after = int((motion.t[-1] + 0.01) * scene.audio.sample_rate)
    assert np.abs(stems[after:, [HEAVE, TILT]]).max() == 0
    assert len(stems) - after >= 3 * scene.audio.sample_rate


def test_the_end_is_no_click(scene, motion, stems):
    """The rigid stems decay continuously over the last milliseconds.

    No step between samples is larger than before the end.
    """
    end = int(motion.t[-1] * scene.audio.sample_rate)
    steps = np.abs(np.diff(stems[:, [HEAVE, TILT]].sum(axis=1)))
    assert steps[end - 100 : end + 1000].max() < steps[end - 9600 : end - 480].max()


@pytest.mark.parametrize("rate", [8000, 22050, 48000])
def test_the_ring_down_has_the_pitch_and_the_decay_of_its_mode_at_any_sample_rate(
    scene, motion, modes, stems, rate
):
    if rate != scene.audio.sample_rate:
        stems = np.vstack(
            list(
                Renderer(
                    scene.replace(f"audio.sample_rate={rate}"), motion, modes
                ).blocks()
            )
        )
    start = int((motion.t[-1] + 1.0) * rate)
    ringing = stems[start : start + 4 * rate, [SMOOTH, JUMPS]].sum(axis=1)
    spectrum = np.abs(np.fft.rfft(ringing * np.hanning(len(ringing))))
    mode = np.argmin(
        np.abs(
            modes.frequency
            - np.fft.rfftfreq(len(ringing), 1 / rate)[np.argmax(spectrum)]
        )
    )
    turning = ringing * np.exp(
        -2j * np.pi * modes.frequency[mode] * np.arange(len(ringing)) / rate
    )
    z = turning.reshape(40, -1).mean(axis=1)
    t = (np.arange(40) + 0.5) * len(ringing) / 40 / rate
    offset = np.polyfit(t, np.unwrap(np.angle(z)), 1)[0] / (2 * np.pi)
    assert abs(1200 * np.log2(1 + offset / modes.frequency[mode])) < 0.1
    assert -np.polyfit(t, np.log(np.abs(z)), 1)[0] == pytest.approx(
        modes.decay_rate[mode], rel=0.01
    )


def test_the_energy_of_the_modes_falls_at_twice_the_decay_rate(scene, motion, modes):
    """Late after the halt only the two slowest modes remain; the energy of each is exp(-2 d t)."""
    sound = Renderer(scene, motion, modes).sound()
    t = sound.energy_time
    energy = sound.energy
    late = t > motion.t[-1] + 2.0
    rate = -np.polyfit(t[late], np.log(energy[late]), 1)[0] / 2
    assert 0.98 * modes.decay_rate[0] < rate < 1.02 * modes.decay_rate[1]


def test_modes_above_half_the_sample_rate_are_left_out(scene, short, modes):
    renderer = Renderer(scene.replace("audio.sample_rate=8000"), short, modes)
    assert np.array_equal(
        renderer.modes.frequency, modes.frequency[modes.frequency < 4000]
    )


def test_listeners_at_unequal_distances_share_one_time_axis(scene, short, modes):
    """Every listener hears what it hears alone, followed by silence up to the common end.

    The delays of the ears of a head differ too, and so do those of any two listeners.
    """
    places = (
        '{kind="head", distance=0.5, facing_deg=30}, {distance=0.03, elevation_deg=90}'
    )
    several = scene.replace(f"audio.listeners=[{places}]")
    heard: list[tuple[int, int]] = []

    def listen(block, sample_rate, samples):
        heard.append((len(block), samples))

    few = range(3)
    sound = render_sound(several, short, modes, few, 0.0, None, listen=listen)
    alone = [
        Renderer(several, short, modes, few, listener=listener).sound()
        for listener in listeners_of(several)
    ]
    lengths = [one.samples for one in alone]
    assert len(set(lengths)) == 3
    assert sound.samples == max(lengths)
    assert sum(count for count, _ in heard) == sound.samples
    assert {samples for _, samples in heard} == {sound.samples}
    for one, expected in zip((sound, *sound.others), alone, strict=True):
        assert np.array_equal(one.columns[: expected.samples], expected.columns[:])
        assert not one.columns[expected.samples :].any()


def test_files_hold_what_they_say(scene, short, modes, tmp_path):
    sound = Renderer(scene, short, modes).sound()
    write_sound(sound, tmp_path)
    pressure, rate = soundfile.read(tmp_path / "pressure.wav", dtype="float32")
    parts = np.column_stack(
        [soundfile.read(file)[0] for file in (tmp_path / "stems").iterdir()]
    )
    copy = soundfile.read(tmp_path / "sound.wav")[0]
    assert rate == scene.audio.sample_rate
    assert parts.shape[1] == len(STEMS) - len(sound.inaudible_stems) + 1
    assert np.abs(pressure - parts.sum(axis=1)).max() <= 2**-23 * np.abs(parts).max()
    assert np.abs(copy).max() == pytest.approx(10 ** (-1 / 20), abs=1e-6)
    assert np.abs(copy * sound.full_scale - pressure).max() < sound.full_scale * 2**-23
    assert soundfile.info(tmp_path / "sound.wav").subtype == "PCM_24"
    assert soundfile.info(tmp_path / "audible.wav").subtype == "PCM_16"
    assert soundfile.info(tmp_path / "pressure.wav").subtype == "FLOAT"
    assert sound.samples == len(pressure)
    assert sorted(p.name for p in tmp_path.iterdir()) == [
        "audible.wav",
        "pressure.wav",
        "sound.wav",
        "stems",
    ]


def test_inaudible_stems_are_one_file_and_all_files_add_up(
    scene, short, modes, tmp_path, monkeypatch
):
    """An audible stem keeps its file; the sum has the rounding of one more float32."""
    loud = Renderer(scene, short, modes).sound()
    (tmp_path / "stems").mkdir()
    (tmp_path / "stems" / "tilt.wav").touch()  # left by an earlier run
    everything = replace(loud, others=(replace(loud),))
    monkeypatch.setattr("sonify.sound.pressure.audibility", quiet_but("heave"))
    for sound in (replace(loud), everything):
        assert sound.inaudible_stems == ("tilt", "ringing_smooth", "ringing_jumps")
        write_sound(sound, tmp_path)
        files = sorted((tmp_path / "stems").iterdir())
        assert [file.name for file in files] == ["heave.wav", "rest.wav"]
        parts = [soundfile.read(file)[0] for file in files]
        pressure = soundfile.read(tmp_path / "pressure.wav")[0]
        rounding = 2**-23 * np.abs(parts).max()
        assert np.abs(sum(parts) - pressure).max() <= rounding
    tilt = loud.track("tilt").read()
    assert np.abs(tilt).max() > 100 * rounding


def quiet_but(name):
    """Return a stand-in for `audibility` by which only the stem `name` is audible."""

    def audibility(track):
        level = np.array([1.0 if track.name == name else -1.0])
        return Audibility(time=np.zeros(1), a_weighted=level, above_threshold=level)

    return audibility


def test_the_samples_do_not_depend_on_the_block(scene, short, modes):
    whole, parts = (
        np.vstack(list(Renderer(scene, short, modes).blocks(size)))
        for size in (1 << 16, 1000)
    )
    assert np.abs(whole - parts).max() < gamma(100) * np.abs(whole).max()


def test_a_renderer_and_its_sound_are_read_again_and_again(
    scene, short, modes, monkeypatch
):
    """Readings may be nested, and sounds kept in memory and in a file give the same samples."""
    renderer = Renderer(scene, short, modes)
    once, again = (np.vstack(list(renderer.blocks(10_000))) for _ in range(2))
    pairs = list(zip(renderer.blocks(10_000), renderer.blocks(10_000), strict=True))
    assert np.array_equal(once, again)
    assert all(np.array_equal(one, other) for one, other in pairs)
    held = renderer.sound()
    monkeypatch.setattr("sonify.sound.pressure.MAX_BYTES_IN_MEMORY", 0)
    filed = renderer.sound()
    for name in ("pressure", *STEMS):
        for start in (0, 70_000):
            parts = [
                np.vstack(list(sound.track(name).blocks(start)))
                for sound in (held, filed, filed)
            ]
            assert np.array_equal(parts[0], parts[1])
            assert np.array_equal(parts[0], parts[2])
    assert (filed.peak, filed.stem_peaks) == (held.peak, held.stem_peaks)


@pytest.mark.parametrize("name", ["dissipation", "published"])
def test_the_modes_ring_out_however_the_motion_ends(name):
    """The cases are a fall and a motion that is cut off.

    Afterwards each mode decays at its own rate, and the rigid disk is silent.
    """
    scene = load_scene(name).replace(
        "audio.sample_rate=8000", *(["numerics.time_limit=2.0"] * (name == "published"))
    )
    motion = simulate(scene).rolling
    modes = eigenmodes(scene, below=4e3)
    assert motion.rolling_outcome in (Outcome.FELL, Outcome.ROLLING_ON)
    renderer = Renderer(scene, motion, modes)
    stems = np.vstack(list(renderer.blocks()))
    rate = 8000
    end = int(renderer.source_end * rate)
    assert np.abs(stems[end + 20 :, [HEAVE, TILT]]).max() == 0
    ringing = stems[end + 20 : -int(FADE_OUT * rate) - 1, [SMOOTH, JUMPS]].sum(axis=1)
    assert len(ringing) > rate / 2
    before = stems[end - rate // 2 : end, [SMOOTH, JUMPS]].sum(axis=1).reshape(10, -1)
    assert (
        rms(ringing[: rate // 20]) < 1.5 * rms(before.T).max()
    )  # the end itself is not a blow
    t = np.arange(len(ringing)) / rate
    poles = -modes.decay_rate + 1j * np.sqrt(
        (2 * np.pi * modes.frequency) ** 2 - modes.decay_rate**2
    )
    waves = np.exp(np.outer(t, poles))
    basis = np.hstack([waves.real, waves.imag])
    left = ringing - basis @ np.linalg.lstsq(basis, ringing, rcond=None)[0]
    assert rms(left) < 1e-6 * rms(ringing)


def test_a_scene_may_have_any_causes_of_sound(scene, short, modes, tmp_path):
    """A further source, which radiates the normal force without delay, leaves the other stems
    unchanged."""

    class Weight(SoundSource):
        names = ("weight",)
        channel_ends = np.zeros((1, 2))
        tail_duration = 0.0
        latency = 0

        def input_channels(self, force, state, film):
            return force[:, 2:]

        def make_block_renderer(self, first, note):
            return lambda force: force.samples[:-1]

    class More(Renderer):
        def _sources_at(self, listener):
            elastic, sources = super()._sources_at(listener)
            return elastic, [*sources, Weight()]

    few = Renderer(scene, short, modes).sound()
    more = More(scene, short, modes).sound()
    assert more.names == (*STEMS, "weight")
    assert all(
        np.array_equal(few.track(name).read(), more.track(name).read())
        for name in STEMS
    )
    heard = more.track("weight").read(20_000, 22_000)
    t = (
        np.arange(20_000, 22_000) / scene.audio.sample_rate
        - scene.audio.distance / 343.2
    )
    assert heard == pytest.approx(short.force(t)[:, 2], rel=1e-6), (
        "it is heard when the others are"
    )
    write_sound(more, tmp_path)
    assert (tmp_path / "stems" / "weight.wav").exists()
    total = np.sum(
        [track.read().astype(float) for track in more.stems.values()], axis=0
    )
    assert np.array_equal(more.pressure.read(), total.astype(np.float32))


def test_the_frame_of_the_patch_keeps_size_and_work(motion):
    t = np.linspace(0.1, 15, 500)
    force = motion.force(t)
    inclination = motion.at(t)[:, 1]
    has_second_ear = in_patch_frame(force, inclination)
    assert np.linalg.norm(has_second_ear, axis=1) == pytest.approx(
        np.linalg.norm(force, axis=1), rel=gamma(20)
    )
    flat = in_patch_frame([[1.0, 2.0, 3.0]], np.zeros(1))[0]
    assert flat == pytest.approx(
        [2.0, -1.0, 3.0]
    )  # radially out along a_2, tangentially against a_1, up


def test_the_angular_acceleration_is_that_of_the_motion(scene, motion):
    """About the horizontal axis of rolling, the expected value is J1 w1' of the solved motion less
    the gyroscopic and the resisting moment."""
    disk = scene.disk
    t = np.linspace(1.0, 1.5, 200)
    h = 1e-5
    state = motion.at(t)
    chi = disk.time_unit
    w = state[:, 5:8]
    rate = (motion.at(t + h)[:, 5] - motion.at(t - h)[:, 5]) / (2 * h)
    J1 = disk.mass * (disk.radius**2 / 4 + disk.thickness**2 / 12)
    J2 = disk.mass * disk.radius**2 / 2
    gyroscopic = J2 * w[:, 1] * w[:, 2] - J1 * w[:, 2] ** 2 / np.tan(state[:, 1])
    resisting = scene.friction.arm_nutation * motion.force(t)[:, 2] * np.sign(w[:, 0])
    about_e1 = -rigid_acceleration(in_patch_frame(motion.force(t), state[:, 1]), disk)[
        :, 4
    ]
    assert about_e1 == pytest.approx(
        rate - (gyroscopic - resisting) / J1, abs=1e-4 / chi**2
    )


def test_a_load_that_travels_round_a_free_disk_drives_order_n_at_n_times_its_rate(
    scene,
):
    free = scene.replace("support.kind=free")
    modes = eigenmodes(free, below=24e3)
    rate = 50.0
    t = np.arange(4000) / 4000
    attitude = np.column_stack([0 * t, np.full(len(t), 1e-6), -2 * np.pi * rate * t])
    drive = modal_forcing_function(modes, free)(
        np.tile([0.0, 0.0, 4.3], (len(t), 1)), attitude
    )
    spectrum = np.abs(np.fft.rfft(drive, axis=0))
    assert (spectrum.argmax(axis=0) / t.size * 4000).tolist() == (
        modes.order * rate
    ).tolist()
    assert {2, 3} <= set(modes.order.tolist())
