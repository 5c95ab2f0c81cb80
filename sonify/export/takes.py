"""Export variations of a sound as trimmed WAV files with loop points, for samplers."""

from collections.abc import Callable
from dataclasses import replace
from math import isfinite
from pathlib import Path
from struct import pack
from typing import NamedTuple

import numpy as np

from modal import SurfaceModes
from modal.blas_threads import one_blas_thread
from sonify import __version__
from sonify.export.scene_source import scene_to_export
from sonify.hearing.audio_source import AudioSource, read_samples
from sonify.pipeline import DiskModesCache
from sonify.plan.preflight import plan_with_modes, solve_motion
from sonify.plan.table import audible_table, solve_table
from sonify.runtime.files import claimed_folder
from sonify.runtime.progress import Stages, Watch
from sonify.scene import Scene
from sonify.scene_errors import InputError, SceneError
from sonify.sound.fades import raised_cosine
from sonify.sound.mastering import Mastering
from sonify.sound.playback import ScaledTrack
from sonify.sound.pressure import Sound
from sonify.sound.render import render_sound
from sonify.sound.wav import BYTES_PER_SAMPLE, MAX_RIFF_BYTES, open_wav, rounded

FADE_IN = 0.005  # s
CUT_FADE_IN = 0.1  # s, of a sound that begins later than the take
FADE_OUT = 0.02  # s
MIN_LENGTH = 0.5  # s, of the final part of a take


class TakeContent(NamedTuple):
    """Part of a sound that a take contains.

    Attributes
    ----------
    last : float or None
        Length of the final part that is written [s]; None for the whole sound.
    audible : bool
        Whether to write the content of audible.wav, which is A-weighted and mastered
        for small loudspeakers, instead of the pressure.
    """

    last: float | None = None
    audible: bool = False


WHOLE_PRESSURE = TakeContent()


@one_blas_thread
def export_takes(
    scene: Scene | str | Path,
    takes: int = 1,
    seed: int = 1,
    rate: float | None = None,
    out: str | Path | None = None,
    stages: Stages | None = None,
    on_written: Callable[[Path], None] = lambda path: None,
    content: TakeContent = WHOLE_PRESSURE,
) -> list[Path]:
    """Render variations of the sound of a scene and write each to a WAV file.

    Every take has slightly different random release conditions and, if the scene has
    roughness, its own roughness seed. A take depends on `seed` and on its own number,
    but not on the number of takes.

    Parameters
    ----------
    scene : Scene, str or Path
        Scene, shipped name, scene file, or the folder or run.json of an earlier run.
    takes : int
        Number of takes.
    seed : int
        Seed of the random variations.
    rate : float, optional
        Sample rate [Hz], 48000 or 96000 (default: that of the scene).
    out : str or Path, optional
        Folder of the files <scene name>-01.wav, ... (default: the current folder).
    stages : Stages, optional
        Receives the progress.
    on_written : callable
        Called with the path of each file when it is complete.
    content : TakeContent
        Part that is written (default: the pressure of the whole sound).

    Returns
    -------
    list of Path
        Paths of the files.

    Raises
    ------
    InputError
        If a take cannot be solved or is silent, or if the sample rate or the length is
        not allowed.
    """
    if rate is not None and rate not in (48000, 96000):
        raise InputError(f"--rate = {rate:g}: must be 48000 or 96000 for a sound")
    last = content.last
    if last is not None and not (isfinite(last) and last >= MIN_LENGTH):
        raise InputError(f"--last = {last:g}: must be at least {MIN_LENGTH:g} s")
    scene, motion_plan = scene_to_export(scene)
    if rate is not None:
        scene = scene.replace(f"audio.sample_rate={round(rate)}")
    variations = [varied_scene(scene, seed, number) for number in range(1, takes + 1)]
    stages = stages or Stages()
    paths = []
    with claimed_folder(out or ".") as folder, stages.stage("takes") as watch:
        table = solve_table(scene, motion_plan)
        rendered = table and audible_table(table, scene)
        disk_modes = DiskModesCache()
        for number, (take, changes) in enumerate(variations, 1):
            title = f"take {number} of {takes}"

            def watch_take(
                share: float, note: str = "", done: int = number - 1, title: str = title
            ) -> None:
                watch((done + share) / takes, f"{title}{note and ': '}{note}")

            path = folder / f"{scene.name}-{number:0{max(2, len(str(takes)))}}.wav"
            try:
                sound = sound_of_take(take, table, rendered, disk_modes, watch_take)
                note = f"{title}, seed {seed}; {' '.join(changes)}"
                write_take(sound, path, note, content)
            except SceneError as error:
                raise InputError(f"{title}: {error}") from None
            paths.append(path)
            on_written(path)
    return paths


def varied_scene(scene: Scene, seed: int, number: int) -> tuple[Scene, list[str]]:
    """Return the scene of a take and its changes as assignments for `Scene.replace`."""
    draw = np.random.default_rng([seed, number])
    steeper, faster = 0.02 * draw.uniform(-1, 1, 2)  # relative changes
    released = scene.release
    halfway_upright = (released.inclination_deg + 90) / 2
    inclination = min(released.inclination_deg * (1 + steeper), halfway_upright)
    max_release_rate = 1e6  # rad/s
    omega = np.clip(
        np.array(released.omega) * (1 + faster), -max_release_rate, max_release_rate
    )
    changes = [
        f"release.inclination_deg={max(float(inclination), 1e-6)!r}",
        f"release.omega={[float(rate) for rate in omega]}",
    ]
    if scene.roughness is not None:
        changes.append(f"roughness.seed={draw.integers(10**9)}")
    return scene.replace(*changes), changes


def sound_of_take(
    scene: Scene,
    table: SurfaceModes | None,
    rendered: SurfaceModes | None,
    disk_modes: DiskModesCache,
    watch: Watch,
) -> Sound:
    """Return the sound of a take.

    The motion uses the modes `table`, the sound those in `rendered`.
    """
    scene, motion_plan = scene_to_export(scene)
    plan, modes = plan_with_modes(scene, disk_modes, motion_plan)
    if motion_plan.lacks_surface_modes:
        motion_plan = motion_plan.with_surface_modes(table)

    def watch_motion(share: float, note: str = "") -> None:
        watch(share / 2, note)

    def watch_sound(share: float, note: str = "") -> None:
        watch(0.5 + share / 2, note or "sound")

    return render_sound(
        scene,
        solve_motion(motion_plan, watch_motion),
        modes,
        plan.sounding,
        plan.max_contact_turn,
        rendered,
        watch_sound,
    )


def write_take(
    sound: Sound, path: Path, note: str, content: TakeContent = WHOLE_PRESSURE
) -> None:
    """Write a sound without the silence at both ends, as 24-bit PCM with loop points.

    Only the part that `content` selects is written. The true peak is below -1 dBTP. The
    text fields contain the scene, the program with its version, the scale, and `note`.
    Raises InputError if the sound is silent or too long for a WAV file.
    """
    last, audible = content
    copy = sound.audible if audible else copy_below_limit(sound.playback_copy)
    rate = sound.sample_rate
    first, end = audible_range(copy)
    fade_in = FADE_IN
    if last is not None and end - first > round(last * rate):
        first, fade_in = end - round(last * rate), CUT_FADE_IN
    samples = read_samples(copy, first, end)
    apply_fades(samples, rate, fade_in)
    if samples.size * BYTES_PER_SAMPLE["PCM_24"] > MAX_RIFF_BYTES:
        raise InputError(f"{path.name}: the sound is too long for a WAV file of 4 GiB")
    loop = loop_points(samples[:, 0], rate)
    chunk = b"" if loop is None else sampler_chunk(rate, *loop)
    scale = (
        f"A-weighted, {sound.dynamics} dynamics, not in pascal"
        if audible
        else f"1.0 = {copy.full_scale:.9g} pascal at the listener"
    )
    with open_wav(path, rate, copy.channels, "PCM_24", "WAV", chunk) as file:
        file.title = f"Euler's disk, {sound.name}"
        file.comment = f"{scale}; {note}"
        file.software = f"eulers-disk-sonify {__version__}"
        file.write(rounded(samples, "PCM_24"))


def copy_below_limit(copy: ScaledTrack) -> ScaledTrack:
    """Return a copy with the true peak of a master, which every meter reads below
    -1 dBTP."""
    limit = 10 ** (Mastering().limit_dbtp / 20)
    return replace(copy, full_scale=copy.full_scale * copy.true_peak / limit)


def audible_range(source: AudioSource) -> tuple[int, int]:
    """Return the first sample and the end of the part that is not silent.

    The durations of the fades are added at both ends. The length is even, because some
    programs expect an even number of bytes. Raises InputError if the sound is silent.
    """
    silence_db = -60.0  # relative to the peak
    tops = [np.abs(block).max(axis=1) for block in source.blocks()]
    level = np.concatenate(tops)
    loud = np.flatnonzero(level > level.max() * 10 ** (silence_db / 20))
    if not len(loud):
        raise InputError("the sound is silent")
    rate = source.sample_rate
    first = max(int(loud[0]) - round(FADE_IN * rate), 0)
    last = min(int(loud[-1]) + 1 + round(FADE_OUT * rate), source.frames)
    return first, last - (last - first) % 2 if last - first > 1 else last


def apply_fades(
    samples: np.ndarray, sample_rate: int, fade_in: float = FADE_IN
) -> None:
    """Apply fades to both ends of samples (k, channels) in place.

    The first one lasts `fade_in` [s].
    """
    for part, seconds in ((samples, fade_in), (samples[::-1], FADE_OUT)):
        count = min(round(seconds * sample_rate), len(samples))
        part[:count] *= raised_cosine(np.arange(count) / count)[:, None]


def loop_points(samples: np.ndarray, sample_rate: int) -> tuple[int, int] | None:
    """Return the first and last sample of a loop in samples (k,), or None if there is
    no loop.

    The loop is in the middle. It starts at an upward zero crossing and ends before
    another one, around which the waveform is most similar to that around the start.
    """
    crossings = np.flatnonzero((samples[:-1] < 0) & (samples[1:] >= 0)) + 1
    around = round(
        0.005 * sample_rate
    )  # samples on each side over which waveforms are compared
    crossings = crossings[(crossings >= around) & (crossings <= len(samples) - around)]
    if len(crossings) < 2:
        return None
    length = min(1.0 * sample_rate, len(samples) / 2)
    begin = crossings[np.abs(crossings - (len(samples) - length) / 2).argmin()]
    later = crossings[crossings > begin]
    if not len(later):
        return None
    max_length_change = 0.2
    near = later[np.abs(later - begin - length) <= max_length_change * length]
    if not len(near):
        near = later[[np.abs(later - begin - length).argmin()]]
    pattern = samples[begin - around : begin + around]
    differences = [
        np.square(samples[end - around : end + around] - pattern).sum() for end in near
    ]
    return int(begin), int(near[int(np.argmin(differences))]) - 1


def sampler_chunk(sample_rate: int, begin: int, end: int) -> bytes:
    """Return a `smpl` chunk with one forward loop from sample `begin` to `end`,
    inclusive.

    The root note is middle C.
    """
    middle_c = 60
    period = round(1e9 / sample_rate)  # ns
    sampler = pack("<9I", 0, 0, period, middle_c, 0, 0, 0, 1, 0)
    content = sampler + pack("<6I", 0, 0, begin, end, 0, 0)
    return b"smpl" + pack("<I", len(content)) + content
