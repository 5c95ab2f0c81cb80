"""Animate the end of a motion in real time, with its sound."""

import errno
from dataclasses import dataclass, replace
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import TYPE_CHECKING

import numpy as np
import soundfile
from matplotlib import font_manager
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from PIL import Image, ImageDraw, ImageFont

from dynamics.observables import precession_rate
from sonify.hearing.spectrogram import spectrogram
from sonify.report.perspective import (
    TABLE_COLOUR,
    Camera,
    contact_points,
    draw_blurred_disk,
    draw_table,
    draw_trace,
    rim_points,
)
from sonify.report.sound import draw_level_image, loudest_db, set_log_frequency_axis
from sonify.runtime.files import atomic_write
from sonify.runtime.progress import Watch, ignore_progress
from sonify.scene_errors import InputError

if TYPE_CHECKING:
    from sonify.result import Result

FRAME_RATE = 25  # frames per second
VIDEO_TAIL_DURATION = 1.0
"""Duration of the video after the end of the motion [s]."""
MIN_DRAWN_INCLINATION = np.radians(15.0)
"""Lower bound of the maximum inclination drawn in the video [rad]."""
MAX_TRACE_TURNS = 4
"""Maximum number of turns over which the path of the contact point is drawn."""
VIDEO_SIZE = (1280, 720)  # px
DISK_VIEW_SIZE = (800, 432)
"""Size of the view of the disk at the upper left of the video [px]."""

VIDEO_EXPLANATION = (
    "real time",
    f"inclination exaggerated: at least {np.degrees(MIN_DRAWN_INCLINATION):g}°",
    "at first; drawn as its square root",
    "blue: path of the contact,",
    f"at most its last {MAX_TRACE_TURNS} turns",
)
"""Explanation displayed in the video."""


@dataclass(frozen=True, kw_only=True)
class Clip:
    """Part of a result shown in the video, with `frames` frames.

    It begins at `start` [s], measured at the listener, who hears the source after the
    propagation delay. `max_inclination` [rad] is the maximum inclination in the clip.
    """

    result: object
    start: float
    frames: int
    max_inclination: float

    @property
    def span(self) -> tuple[float, float]:
        """Start and end of the clip [s]."""
        return self.start, self.start + self.frames / FRAME_RATE

    def states(self, t) -> np.ndarray:
        """Return the states (k, 11) of the disk that the listener hears at times t (k,)
        [s].

        They are constant before and after the motion.
        """
        motion = self.result.motion
        sound = self.result.sound
        return motion.at(
            np.clip(t - sound.source_end + motion.rolling.t[-1], 0.0, motion.t[-1])
        )

    def drawn_inclination(self, state) -> np.ndarray:
        """Return the drawn inclinations (k,) [rad] of states (k, 11).

        They are proportional to the square root of the true inclinations, which
        decreases more uniformly.
        """
        return max(self.max_inclination, MIN_DRAWN_INCLINATION) * np.sqrt(
            state[:, 1] / self.max_inclination
        )

    def drawn(self, state) -> np.ndarray:
        """Return the states (k, 11) with the drawn inclinations."""
        drawn = state.copy()
        drawn[:, 1] = self.drawn_inclination(state)
        return drawn


def require_encoder():
    """Raise InputError with an installation hint if the video encoder is missing."""
    try:
        from imageio_ffmpeg import get_ffmpeg_exe

        get_ffmpeg_exe()
    except (ImportError, RuntimeError) as error:
        raise InputError(
            "an animation requires a video encoder; install it with: "
            f'python -m pip install -e ".[animation]" ({error})'
        ) from None


def animate(result: "Result", watch: Watch = ignore_progress) -> Path:
    """Write an animation of the last seconds of a result to animation.mp4 (H.264, AAC);
    return its path.

    The file is written to the folder of the result. `watch(fraction)` is called with
    the completed fraction of the frames. Raises InputError if the encoder is missing,
    and OSError if the disk is full. Tested by tests/report/test_animation.py.
    """
    require_encoder()
    clip = final_clip(result)
    path = result.out / "animation.mp4"
    with atomic_write(path) as film, TemporaryDirectory() as folder:
        sound = write_clip_sound(clip, Path(folder) / "sound.wav")
        encode_film(film, sound, clip.frames, film_frames(clip), watch)
    return path


def final_clip(result: "Result") -> Clip:
    """Return the clip of the last seconds, which ends VIDEO_TAIL_DURATION seconds after
    the motion."""
    duration = 8.0  # s
    sound = result.sound
    end = min(sound.source_end + VIDEO_TAIL_DURATION, sound.duration)
    start = max(end - duration, 0.0)
    seen = Clip(
        result=result,
        start=start,
        frames=max(int((end - start) * FRAME_RATE), 1),
        max_inclination=MIN_DRAWN_INCLINATION,
    )
    inclination = seen.states(np.linspace(*seen.span, 2000))[:, 1]
    return replace(seen, max_inclination=float(inclination.max()))


def write_clip_sound(clip, path: Path) -> Path:
    """Write the sound of the clip with the full scale of sound.wav; return the path."""
    sound = clip.result.sound
    first, last = (int(t * sound.sample_rate) for t in clip.span)
    samples = sound.pressure.read(first, last) / sound.full_scale
    soundfile.write(path, samples, sound.sample_rate, "PCM_24")
    return path


def encode_film(path, sound, frames: int, images, watch):
    """Encode images (h, w, 3) and a sound file as a video.

    Raises OSError if the video does not contain all frames.
    """
    from imageio_ffmpeg import count_frames_and_secs, write_frames

    writer = write_frames(
        path,
        VIDEO_SIZE,
        fps=FRAME_RATE,
        codec="libx264",
        quality=7,
        ffmpeg_log_level="fatal",
        audio_path=str(sound),
        audio_codec="aac",
    )
    writer.send(None)
    try:
        for i, image in enumerate(images):
            writer.send(image)
            watch((i + 1) / frames)
        writer.close()
        written = count_frames_and_secs(path)[0]
    except (OSError, RuntimeError) as error:
        raise OSError(
            errno.ENOSPC, "could not be written in full", str(path)
        ) from error
    if written != frames:
        message = f"contains only {written} of {frames} frames"
        raise OSError(errno.ENOSPC, message, str(path))


def film_frames(clip):
    """Yield the frames (h, w, 3) of a clip."""
    base, across = spectrogram_background(clip)
    camera = clip_camera(clip)
    empty = draw_table(camera, clip.result.scene.disk.radius)
    font = ImageFont.truetype(font_manager.findfont("DejaVu Sans"), 22)
    for n in range(clip.frames):
        t = clip.start + n / FRAME_RATE
        frame = base.copy()
        frame.paste(disk_image(clip, camera, empty, t), (0, 0))
        pen = ImageDraw.Draw(frame)
        place = (DISK_VIEW_SIZE[0] + 10, 60)
        pen.text(place, frame_caption(clip, t), (30, 30, 30), font, spacing=12)
        x = across(t)
        cursor = [x, DISK_VIEW_SIZE[1] + 14, x, VIDEO_SIZE[1] - 60]
        pen.line(cursor, "white", 3)
        pen.line(cursor, "black", 1)
        yield np.asarray(frame)


def clip_camera(clip) -> Camera:
    """Return a camera that keeps the disk in view during the whole clip."""
    disk = clip.result.scene.disk
    place = clip.states(np.linspace(*clip.span, 400))[:, 3:5]
    middle = (place.max(axis=0) + place.min(axis=0)) / 2
    reach = disk.radius + np.linalg.norm(place - middle, axis=1).max()
    return Camera(
        target=np.append(middle, 0.3 * reach),
        distance=7 * reach,
        elevation=np.radians(25),
        focal=7 * 0.55 * DISK_VIEW_SIZE[1],
        size=DISK_VIEW_SIZE,
    )


def disk_image(clip, camera, empty, t: float) -> Image.Image:
    """Return the image of the disk in the frame at t [s], with the trace of the
    contact.

    The shutter is open for the whole duration of the frame.
    """
    exposures_per_frame = 12
    disk = clip.result.scene.disk
    exposures = (np.arange(exposures_per_frame) + 0.5) / exposures_per_frame
    state = clip.states(t + exposures / FRAME_RATE)
    fillet = clip.result.motion.rolling_fillet
    rims = rim_points(clip.drawn(state), disk, fillet)
    hole = disk.inner_radius / (disk.radius - fillet)
    image = draw_blurred_disk(camera, empty, rims, hole)
    last = min(t + 1 / FRAME_RATE, clip.result.sound.source_end)
    turn = 2 * np.pi / abs(precession_rate(clip.states(np.array([last])))[0])
    first = last - min(0.3, MAX_TRACE_TURNS * turn)
    touching = clip.states(np.linspace(first, last, 100 * MAX_TRACE_TURNS))
    path = contact_points(clip.drawn(touching), disk, fillet)
    return draw_trace(camera, image, path if t < last else path[:0])


def frame_caption(clip, t: float) -> str:
    """Return the caption at t [s]: time, inclination [degrees] and precession [Hz]."""
    state = clip.states(np.array([t]))
    settled = clip.result.motion.outcome.is_rest
    lines = [f"{'at rest' if settled else 'solution ended'}; its modes ring", ""]
    if t < clip.result.sound.source_end:
        turns = abs(precession_rate(state)[0]) / (2 * np.pi)
        lines = [
            f"inclination {np.degrees(state[0, 1]):.3g}°",
            f"the contact revolves at {turns:.3g} Hz",
        ]
    return "\n".join([f"{t:.2f} s", *lines, "", *VIDEO_EXPLANATION])


def spectrogram_background(clip):
    """Return the background image with the spectrogram and a function from time [s] to
    image column [px].
    """
    width, height = VIDEO_SIZE
    figure = Figure(figsize=(width / 100, height / 100), dpi=100, facecolor="w")
    below = (height - DISK_VIEW_SIZE[1] - 74) / height
    axes = figure.add_axes((0.066, 60 / height, 0.84, below), facecolor="k")
    band = (20.0, 10e3)  # Hz
    seen = spectrogram(clip.result.sound.pressure, 0.05, span=clip.span).band(*band)
    set_log_frequency_axis(axes, band)
    axes.set(xlim=clip.span, ylabel="frequency [Hz]", xlabel="time at the listener [s]")
    image = draw_level_image(axes, seen, 1.0, loudest_db(seen))
    bar = figure.add_axes((0.92, 60 / height, 0.015, below))
    figure.colorbar(image, cax=bar, label="level [dB re 20 µPa]")
    canvas = FigureCanvasAgg(figure)
    canvas.draw()
    picture = Image.fromarray(np.asarray(canvas.buffer_rgba())[..., :3])
    picture.paste(TABLE_COLOUR, (0, 0, width, DISK_VIEW_SIZE[1]))
    return picture, lambda t: axes.transData.transform((t, 100.0))[0]
