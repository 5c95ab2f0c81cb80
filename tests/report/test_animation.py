"""Claim: the film shows the solved motion of the disk on the table, in step with its sound and in a
common format.

Source: the geometry of a cylinder on a plane, (2.1) to (2.3); H.264 in yuv420p with AAC. Oracle:
the contact is the lowest point of the rim and is at rest while the disk rolls; the film is decoded
and its sound compared with sound.wav.
"""

import signal
import subprocess
import sys
from contextlib import closing
from types import SimpleNamespace

import numpy as np
import pytest
import soundfile
from arithmetic import gamma
from click.testing import CliRunner
from scipy.signal import correlate

from dynamics import simulate
from modal import eigenmodes
from sonify.__main__ import main
from sonify.report import animation
from sonify.report.animation import (
    DISK_VIEW_SIZE,
    FRAME_RATE,
    MIN_DRAWN_INCLINATION,
    VIDEO_SIZE,
    VIDEO_TAIL_DURATION,
    animate,
    clip_camera,
    final_clip,
)
from sonify.report.perspective import (
    TABLE_COLOUR,
    Camera,
    contact_points,
    draw_blurred_disk,
    draw_table,
    rim_points,
)
from sonify.sound.render import Renderer
from sonify.sound.wav import write_sound

DELAY_S = 1e-3


@pytest.fixture(scope="module")
def result(scene, tmp_path_factory):
    motion = simulate(scene.replace("numerics.time_limit=0.6"))
    out = tmp_path_factory.mktemp("film")
    sound = Renderer(scene, motion, eigenmodes(scene, below=20e3)).sound()
    write_sound(sound, out)
    return SimpleNamespace(scene=scene, motion=motion, sound=sound, out=out)


def test_the_disk_stands_on_the_table_where_the_contact_is(scene, motion):
    state = motion.at(np.linspace(0, 15, 50))
    body = rim_points(state, scene.disk)
    touching = contact_points(state, scene.disk)
    lowest = body[:, 0, :, 2].min(axis=1)
    corner = (
        scene.disk.radius * np.sin(state[:, 1]) * (1 - np.cos(np.pi / body.shape[2]))
    )  # between two points
    slack = gamma(30) * scene.disk.radius
    assert np.all((lowest >= -slack) & (lowest <= corner + slack))
    apart = np.linalg.norm(body[:, 0] - touching[:, None], axis=2).min(axis=1)
    assert np.all(apart < scene.disk.radius * np.pi / body.shape[2])
    assert np.linalg.norm(body[:, 1] - body[:, 0], axis=2) == pytest.approx(
        scene.disk.thickness, rel=1e-9
    )


def test_the_point_of_the_rim_in_contact_is_at_rest_while_the_disk_rolls(scene, motion):
    """The velocity at the contact is zero, from central differences of the drawn points."""
    t = np.array([1.0, 3.0, 6.0])
    h = 1e-6
    assert all(name.startswith("roll") for name in motion.regime(t))
    bodies = [rim_points(motion.at(t + e), scene.disk)[:, 0] for e in (-h, h)]
    speed = np.linalg.norm(bodies[1] - bodies[0], axis=2) / (2 * h)
    nearest = bodies[0][:, :, 2].argmin(axis=1)
    assert np.all(speed[np.arange(3), nearest] < 0.05 * speed.max(axis=1))


def test_the_camera_sees_its_target_in_the_middle_and_what_is_near_large():
    camera = Camera(
        target=np.array([0.1, 0.2, 0.0]),
        distance=1.0,
        elevation=0.4,
        focal=100.0,
        size=(80, 60),
    )
    assert camera.project(camera.target) == pytest.approx([40, 30])
    right, up = camera.target + camera.axes[:2] * 0.01
    assert camera.project(np.array([right, up])) == pytest.approx(
        np.array([[41, 30], [40, 29]])
    )
    assert np.linalg.norm(camera.position - camera.target) == pytest.approx(1.0)
    near = camera.project(camera.target + 0.5 * camera.axes[2] + 0.01 * camera.axes[0])
    assert near == pytest.approx([42, 30])


@pytest.fixture
def late(scene, motion):
    return SimpleNamespace(
        scene=scene,
        motion=motion,
        sound=SimpleNamespace(source_end=motion.t[-1], duration=motion.t[-1] + 9),
    )


def test_the_disk_stays_in_the_picture(result, late):
    """The frame contains the disk at its steepest and at the end; the margin shows the table."""
    for clip in (final_clip(result), final_clip(late)):
        camera = clip_camera(clip)
        disk = clip.result.scene.disk
        state = clip.states(np.linspace(*clip.span, 200))
        bodies = rim_points(clip.drawn(state), disk)
        place = camera.project(bodies)
        assert np.all((place > 0) & (place < np.array(DISK_VIEW_SIZE)))
        image = draw_blurred_disk(camera, draw_table(camera, disk.radius), bodies[:1])
        assert tuple(image[-1, 0]) == TABLE_COLOUR
        assert np.ptp(image.reshape(-1, 3), axis=0).max() > 100


def test_a_small_inclination_is_drawn_larger_and_a_large_one_as_it_is(result, late):
    early = final_clip(result)
    clip = final_clip(late)
    state = early.states(np.linspace(*early.span, 500))
    assert early.drawn_inclination(state).max() == pytest.approx(
        state[:, 1].max(), rel=1e-3
    )
    end = late.motion.t[-1]
    assert clip.span == pytest.approx((end - 7, end + 1))
    assert clip.drawn_inclination(
        clip.states(np.linspace(*clip.span, 2000))
    ).max() == pytest.approx(MIN_DRAWN_INCLINATION)


def test_the_film_plays_anywhere_and_its_sound_is_in_step(result):
    ffmpeg = pytest.importorskip(
        "imageio_ffmpeg", reason="the extra `animation` is not installed"
    )
    done = []
    path = animate(result, done.append)
    assert done[-1] == pytest.approx(1.0)
    with closing(
        ffmpeg.read_frames(path)
    ) as reader:  # read to its end it would leave pipes open
        about = next(reader)
    command = [ffmpeg.get_ffmpeg_exe(), "-v", "error", "-i", str(path)]
    raw = subprocess.run(
        [*command, "-f", "rawvideo", "-pix_fmt", "rgb24", "-"],
        check=True,
        stdout=subprocess.PIPE,
    )
    frames = np.frombuffer(raw.stdout, np.uint8).reshape(
        -1, VIDEO_SIZE[1], VIDEO_SIZE[0], 3
    )
    assert about["codec"] == "h264"
    assert about["pix_fmt"].startswith("yuv420p")
    assert about["audio_codec"] == "aac"
    assert about["fps"] == FRAME_RATE
    assert len(frames) == int(
        (result.sound.source_end + VIDEO_TAIL_DURATION) * FRAME_RATE
    )
    changed = np.abs(frames[-1].astype(float) - frames[0]).mean(axis=2) > 20
    assert (
        changed[: DISK_VIEW_SIZE[1], : DISK_VIEW_SIZE[0]].mean() > 0.02
    )  # the disk has moved, and so has the cursor
    assert changed[DISK_VIEW_SIZE[1] :].any(axis=0).sum() < 20
    heard = path.with_name("heard.wav")
    subprocess.run([*command, "-vn", str(heard)], check=True)
    samples, rate = soundfile.read(heard)
    whole, _ = soundfile.read(result.out / "sound.wav")
    lag = np.argmax(correlate(samples, whole[: len(samples)])) - (len(samples) - 1)
    assert abs(lag) <= DELAY_S * rate


def test_a_full_disk_leaves_no_half_film(result, monkeypatch):
    """A limit on the file size simulates the full storage device."""
    pytest.importorskip(
        "imageio_ffmpeg", reason="the extra `animation` is not installed"
    )
    resource = pytest.importorskip(
        "resource", reason="this system cannot limit the size of files"
    )
    signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
    monkeypatch.setattr(
        animation, "write_clip_sound", lambda clip, path: result.out / "sound.wav"
    )
    before = resource.getrlimit(resource.RLIMIT_FSIZE)
    (result.out / "animation.mp4").unlink(missing_ok=True)
    resource.setrlimit(resource.RLIMIT_FSIZE, (20_000, before[1]))
    try:
        with pytest.raises(OSError, match=r"could not be written in full|frames"):
            animate(result)
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, before)
    assert list(result.out.glob("*.mp4")) + list(result.out.glob(".*")) == []


def test_without_the_encoder_one_line_says_how_to_get_it_and_nothing_is_written(
    tmp_path, monkeypatch
):
    monkeypatch.setitem(sys.modules, "imageio_ffmpeg", None)
    asked = CliRunner().invoke(
        main, ["run", "--animation", "--out", str(tmp_path / "out")]
    )
    assert asked.exit_code == 2
    assert len(asked.stderr.splitlines()) == 1
    assert "pip install" in asked.stderr
    assert not (tmp_path / "out").exists()
