"""Collect the data of the page (player, curves, 3-D views) as one JSON value.

Arrays are little-endian floats or integers in base64; sounds are FLAC data URLs.
"""

from base64 import b64encode
from collections.abc import Mapping
from dataclasses import dataclass
from io import BytesIO
from typing import TYPE_CHECKING, Any

import numpy as np
import soundfile
from scipy.spatial import ConvexHull, Delaunay

from dynamics import Motion
from dynamics.contact_geometry import centre_height, contact_reach, edge_profile
from dynamics.observables import plotted_rates
from modal import Modes, Support
from modal.tabletop.record import SurfaceModes
from sonify.hearing.audio_source import Recording, read_samples
from sonify.report.captions import describe_spectrogram
from sonify.report.lit_polygons import surface_polygons
from sonify.report.mode_names import mode_caption, table_caption
from sonify.sound.mastering import MasteredTrack, master_copy
from sonify.sound.playback import Channels, ScaledTrack, WeightedTrack, a_weighting
from sonify.sound.pressure import Sound

if TYPE_CHECKING:
    from sonify.result import Result

MAX_STORED_MOTION_TIMES = 22_000
"""Maximum number of times at which the page stores the motion.

Half of them are evenly spaced in time and half in the angle of the contact.
"""
MAX_STORED_LANDING_TIMES = 400
"""Number of times of a landing in the page."""
MAX_PAGE_SOUND_DURATION = 30.0
"""Maximum duration of the final part of a sound in the page [s]."""
MAX_PAGE_SOUND_SIZE = 2_500_000
"""Maximum size of all sounds in the page [base64 characters]; larger sounds are
shortened."""
MAX_TABLE_POINTS = 3_000
"""Approximate maximum number of points of a table in the page."""


def page_data(result: "Result", parts: dict[str, Any]) -> dict[str, Any]:
    """Return the data of a page.

    `parts` are the slow parts: the encoded `motion` and `sound`, and the `colours` of a
    spectrogram as bytes.
    """
    sound = result.sound
    motion = result.motion
    table = result.plan.rendered_table(result.table)
    return {
        "name": result.scene.name,
        "duration": sound.duration,
        "sample_rate": sound.sample_rate,
        "source_end": sound.source_end,
        "delay": sound.source_end - float(motion.rolling.t[-1]),
        "landing": encoded_landing(motion),
        "start": parts["sound"]["start"],
        "sounds": parts["sound"]["content"],
        "lines": {
            "rates": encoded_rates(motion.rolling),
            "modes": base64_array(np.unique(result.modes.frequency.round(1))),
        },
        "colours": base64_array(np.frombuffer(parts["colours"], np.uint8)),
        "disk": {
            "radius": motion.disk.radius,
            "thickness": motion.disk.thickness,
            "inner_radius": motion.disk.inner_radius,
            "weight": motion.disk.weight,
            "mirror": result.scene.surface.sag > 0,
            "edge": base64_array(edge_profile(motion.disk, motion.rolling_fillet, 8)),
            "contact": encoded_contact(motion),
        },
        "motion": parts["motion"],
        "shapes": encoded_mode_shapes(result.modes, result.scene.support),
        "table": encoded_table_shapes(table) if table else None,
        "seen": describe_spectrogram(result),
    }


def encoded_sounds(sound: Sound, longest: float | None = None) -> dict[str, Any]:
    """Return the stems, filter and gain of audible.wav, and the names of inaudible stems.

    Each sound is stored once: the player derives the audible copy from the stems. If a
    sound is longer than `longest` [s] (default: MAX_PAGE_SOUND_DURATION) or larger than
    MAX_PAGE_SOUND_SIZE, only its end is returned, which begins at `start` [s].
    """
    seconds = min(sound.duration, longest or MAX_PAGE_SOUND_DURATION)
    tracks = encoded_stems(sound.stems, sound.full_scale, sound.duration - seconds)
    size = sum(map(len, tracks.values()))
    if size > MAX_PAGE_SOUND_SIZE:
        seconds *= 0.95 * MAX_PAGE_SOUND_SIZE / size
        tracks = encoded_stems(sound.stems, sound.full_scale, sound.duration - seconds)
    start = sound.duration - seconds
    content = {
        "full_scale": sound.full_scale,
        "tracks": tracks,
        "audible": encoded_gain(sound.a_weighted, sound.audible, start),
        "inaudible": list(sound.inaudible_stems),
    }
    return {"start": start, "content": content}


GAIN_INTERVAL = 1e-3
"""Interval at which the page stores the gain of audible.wav [s]."""


def encoded_gain(
    weighted: WeightedTrack, audible: MasteredTrack | ScaledTrack, start: float
) -> dict[str, Any]:
    """Return filter and gain that make an audible copy from `start` [s] on."""
    gain_db = audible_gain_db(weighted, audible, start)
    return {
        "sections": a_weighting(weighted.sample_rate).tolist(),
        "interval": GAIN_INTERVAL,
        "gain": base64_array(np.round(100 * gain_db), np.int16),
    }


def audible_gain_db(
    weighted: WeightedTrack, audible: MasteredTrack | ScaledTrack, start: float
) -> np.ndarray:
    """Return the gain of an audible copy relative to the A-weighted pressure, in the
    middle of successive intervals from `start` [s] on.

    The gain (k,) [dB re 1/Pa] is that of the loudest sample of each interval; it is
    interpolated over silent intervals.
    """
    first = round(start * weighted.sample_rate)
    size = round(GAIN_INTERVAL * weighted.sample_rate)
    before = read_samples(weighted, first, weighted.frames)[:, 0]
    after = read_samples(audible, first, weighted.frames)[:, 0]
    extended = np.pad(before, (0, -len(before) % size)).reshape(-1, size)
    loudest = np.abs(extended).argmax(axis=1) + size * np.arange(len(extended))
    loudest = np.minimum(loudest, len(before) - 1)
    is_silent = np.abs(before[loudest]) <= 1e-9 * np.abs(before).max()
    if is_silent.all():
        return np.zeros(len(loudest))
    heard = np.flatnonzero(~is_silent)
    there = loudest[heard]
    gain = 20 * np.log10(np.abs(after[there] / before[there]))
    return np.interp(np.arange(len(loudest)), heard, gain)


def recording_data(recording: Recording, end: float) -> dict[str, Any]:
    """Return the data of the final part of a recording of a disk, to be heard beside a
    run. The disk stops at `end` [s]."""
    final_silence = 2.0  # s
    last = min(recording.frames / recording.sample_rate, end + final_silence)
    first = max(last - MAX_PAGE_SOUND_DURATION, 0.0)
    part = slice(*(round(time * recording.sample_rate) for time in (first, last)))
    samples = recording.samples[part]
    track = MonoTrack(samples=samples, sample_rate=recording.sample_rate)
    peak = float(np.abs(samples).max(initial=0.0)) or 1.0
    weighted = WeightedTrack(track=track)
    return {
        "name": recording.name,
        "duration": last,
        "sample_rate": recording.sample_rate,
        "source_end": end,
        "delay": 0.0,
        "landing": None,
        "start": first,
        "sounds": {
            "full_scale": peak,
            "tracks": encoded_stems({"recording": track}, peak, 0.0),
            "audible": encoded_gain(weighted, master_copy(track), 0.0),
            "inaudible": [],
        },
        "lines": None,
        "motion": None,
        "shapes": None,
        "table": None,
        "seen": f"Spectrogram of the recording, {last - first:.1f} s; the disk stops at {end:.2f} s.",
    }


@dataclass(frozen=True, kw_only=True, eq=False)
class MonoTrack(Recording):
    """Samples in memory as a track with one channel."""

    @property
    def channels(self) -> int:
        """Number of listeners."""
        return 1


def encoded_stems(
    stems: Mapping[str, Channels], full_scale: float, start: float
) -> dict[str, str]:
    """Return stems from `start` [s] on, divided by `full_scale` [Pa], by name.

    A single stem can be louder than the sum; it is then clipped.
    """
    return {
        name: flac_data_url(ScaledTrack(track=stem, full_scale=full_scale), start)
        for name, stem in stems.items()
    }


def flac_data_url(source: Channels, start: float = 0.0) -> str:
    """Encode a source from `start` [s] on as FLAC and return it as a data URL."""
    held = BytesIO()
    with soundfile.SoundFile(
        held, "w", source.sample_rate, source.channels, "PCM_16", format="FLAC"
    ) as file:
        for block in source.blocks(round(start * source.sample_rate)):
            file.write(np.clip(block, -1.0, 1.0))
    return f"data:audio/flac;base64,{b64encode(held.getvalue()).decode()}"


def encoded_rates(motion: Motion) -> dict[str, Any]:
    """Return precession and nutation [Hz] over time [s], with NaN where the disk does
    not nutate."""
    columns = zip(("t", "precession", "nutation"), plotted_rates(motion), strict=True)
    return {name: base64_array(column) for name, column in columns}


def encoded_motion(motion: Motion, longest: float | None = None) -> dict[str, Any]:
    """Return the motion at its sampled times [s], in the last `longest` seconds (default:
    MAX_PAGE_SOUND_DURATION).

    The columns are attitude [rad], centre [m], force along a_1, a_2, a_3 [N] and energy
    [J].
    """
    longest = longest or MAX_PAGE_SOUND_DURATION
    count = round(MAX_STORED_MOTION_TIMES * longest / MAX_PAGE_SOUND_DURATION)
    t = sample_times(motion.rolling, max(motion.t_end - longest, 0.0), count)
    if motion.landing is not None:
        t = np.append(
            t, landing_times(float(motion.rolling.t[-1]), float(motion.t[-1]))
        )
    state, force = motion.at_and_force(t)
    columns = dict(
        zip(("precession", "inclination", "spin", "x", "y"), state.T[:5], strict=True)
    )
    columns |= dict(zip(("friction_1", "friction_2", "normal"), force.T, strict=True))
    columns["energy"] = motion.energy(t)
    encoded = {name: base64_array(column) for name, column in columns.items()}
    return {"columns": list(columns), "t": base64_array(t, float)} | encoded


def encoded_contact(motion: Motion) -> dict[str, Any]:
    """Return the place of the contact relative to the centre, over the inclination [rad].

    The columns `reach` and `height` are the horizontal distance and the height of the
    centre [m].
    """
    inclination = np.linspace(0.0, np.pi / 2, 721)
    place = inclination, motion.disk, motion.rolling_fillet
    columns = {
        "inclination": inclination,
        "reach": contact_reach(*place),
        "height": centre_height(*place),
    }
    return {name: base64_array(column) for name, column in columns.items()}


def encoded_landing(motion: Motion) -> dict[str, Any] | None:
    """Return the height of the lowest point of the disk above the table [µm] over time
    [s] from the loss of the rolling contact on, or None if it was not lost."""
    if motion.landing is None:
        return None
    since = landing_times(0.0, float(motion.landing.t[-1]))
    gap = 1e6 * motion.landing.clearance(since)
    t = since + float(motion.rolling.t[-1])
    return {"t": base64_array(t, float), "gap": base64_array(gap)}


def landing_times(begin: float, end: float) -> np.ndarray:
    """Return MAX_STORED_LANDING_TIMES times [s] of a landing, half of them in its first 30 ms."""
    half = MAX_STORED_LANDING_TIMES // 2
    soon = min(begin + 0.03, end)
    later = np.linspace(soon, end, half + 1)[1:]
    return np.append(np.linspace(begin, soon, half + 1)[1:], later)


def sample_times(motion: Motion, begin: float, count: int) -> np.ndarray:
    """Return about `count` times [s] from `begin` to the end.

    They are spaced more closely where the contact revolves faster.
    """
    first = max(int(np.searchsorted(motion.t, begin, "right")) - 1, 0)
    some = slice(first, None, max((len(motion.t) - first) // 200_000, 1))
    t = motion.t[some]
    precession = motion.state[some, 0]
    turned = np.abs(np.diff(precession, prepend=precession[0])).cumsum()
    progress = turned / (turned[-1] or 1.0) + (t - t[0]) / (t[-1] - t[0])
    even = np.interp(np.linspace(0, progress[-1], count), progress, t)
    return np.unique(np.concatenate([t[:1], even, motion.t[-1:]]))


def encoded_mode_shapes(modes: Modes, support: Support) -> dict[str, Any]:
    """Return the surface of the disk [m] and the shapes of its lowest modes.

    Each shape is normalised to its greatest component.
    """
    squares = surface_polygons(modes.body)
    nodes, numbers = np.unique(squares, return_inverse=True)
    corners: np.ndarray = numbers.reshape(squares.shape)
    triangles = np.concatenate(
        [corners[:, [0, i, i + 1]] for i in range(1, corners.shape[1] - 1)]
    )
    few = stored_modes(modes)
    held = support.kind == "patch"
    captions = [mode_caption(modes, i, held).replace("\n", ", ") for i in few]
    moved = [modes.body.displacement[i][nodes] for i in few]
    return _encoded_shapes(modes.body.points[nodes], triangles, captions, moved)


def encoded_table_shapes(table: SurfaceModes) -> dict[str, Any]:
    """Return the top face of a table [m] and the axial shapes of its lowest modes,
    normalised as in `encoded_mode_shapes`."""
    few = stored_modes(table)
    captions = [table_caption(table, i) for i in few]
    kept = thinned(table.points, MAX_TABLE_POINTS)
    points = table.points[kept]
    triangles = Delaunay(points).simplices
    level = np.column_stack([points, np.zeros(len(points))])
    return _encoded_shapes(
        level, triangles, captions, [table.face[i][kept] for i in few]
    )


def thinned(points: np.ndarray, count: int) -> np.ndarray:
    """Return the indices of about `count` points (k, 2) that cover all of them: one in
    each cell of a square grid, and the corners of the outline."""
    if len(points) <= count:
        return np.arange(len(points))
    low = points.min(axis=0)
    cell = np.sqrt(np.ptp(points, axis=0).prod() / count)
    _, first = np.unique(np.floor((points - low) / cell), axis=0, return_index=True)
    return np.union1d(first, ConvexHull(points).vertices)


def stored_modes(modes: Modes | SurfaceModes) -> range:
    """Return the indices of the modes in the page, the lowest ones."""
    max_stored_modes = 24
    return range(min(len(modes), max_stored_modes))


def _encoded_shapes(
    points: np.ndarray,
    triangles: np.ndarray,
    captions: list[str],
    moved: list[np.ndarray],
) -> dict[str, Any]:
    return {
        "points": base64_array(points),
        "triangles": base64_array(triangles, np.uint32),
        "captions": captions,
        "shapes": [
            base64_array(32767 * u / (np.abs(u).max() or 1.0), np.int16) for u in moved
        ],
    }


def base64_array(values: np.ndarray, kind: Any = np.float32) -> dict[str, str]:
    """Return the little-endian bytes of a flattened array in base64.

    Arrays of uint8 keep their type; all others are converted to `kind`.
    """
    values = np.asarray(values)
    kind = np.dtype(values.dtype if values.dtype == np.uint8 else kind)
    content = np.ascontiguousarray(values, kind.newbyteorder("<")).tobytes()
    return {"dtype": kind.name, "base64": b64encode(content).decode()}
