"""RESULT -> NUMBERS OF THE PAGE: the data of player, curves and 3-D views, as one JSON value.

Arrays are little-endian floats or integers in base64; sounds are data URLs of FLAC.
"""

from base64 import b64encode
from io import BytesIO
from typing import TYPE_CHECKING, Any

import numpy as np
import soundfile
from scipy.spatial import Delaunay

from dynamics import Motion
from dynamics.observables import drawn_rates
from modal import Modes, Support
from modal.tabletop.record import SurfaceModes
from sonify.report.captions import spectrogram
from sonify.report.lit_polygons import surface_polygons
from sonify.report.mode_names import mode_caption, table_caption
from sonify.report.render_worker import painter
from sonify.sound.playback import Copy, Weighted
from sonify.sound.pressure import Sound

if TYPE_CHECKING:
    from sonify.result import Result

MAX_INSTANTS = 40_000
"""Largest number of instants of the motion in the page.

Half are evenly spaced in time, half in the rotation angle of the contact.
"""
MAX_SHAPES = 24
"""Largest number of modes in the page; the lowest modes are kept."""
MAX_SOUND_BYTES = 24_000_000
"""Largest size of all sounds in the page [bytes of FLAC]; larger ones are in files only."""


def page_data(result: "Result", parts: dict[str, Any] | None = None) -> dict[str, Any]:
    """Return the data of a page.

    `parts` are the slow parts, if already known: the `instants` of the motion, the `sounds`, and
    the colours of a spectrogram as bytes.
    """
    sound = result.sound
    motion = result.motion
    parts = parts or {
        "motion": encoded_motion(motion),
        "sound": encoded_sounds(sound),
        "colours": painter().draw("sound", "draw_colours", dict).result(),
    }
    return {
        "name": result.scene.name,
        "duration": sound.duration,
        "sample_rate": sound.sample_rate,
        "source_end": sound.source_end,
        "delay": sound.source_end - float(motion.t[-1]),
        "sounds": parts["sound"],
        "lines": {
            "rates": encoded_rates(motion),
            "modes": base64_array(np.unique(result.modes.frequency.round(1))),
        },
        "colours": base64_array(np.frombuffer(parts["colours"], np.uint8)),
        "disk": {
            "radius": motion.disk.radius,
            "thickness": motion.disk.thickness,
            "inner_radius": motion.disk.inner_radius,
            "weight": motion.disk.weight,
        },
        "motion": parts["motion"],
        "shapes": encoded_mode_shapes(result.modes, result.scene.support),
        "table": encoded_table_shapes(result.table)
        if result.table is not None and len(result.table)
        else None,
        "seen": spectrogram(result),
    }


def encoded_sounds(sound: Sound) -> dict[str, Any]:
    """Return every stem at two scales: A-weighted as in audible.wav, and true as in sound.wav.

    The result is empty if the stems are too long for a page.
    """
    bytes_per_sample = 1  # upper estimate for disk sound as 16-bit FLAC
    if 2 * len(sound.stems) * sound.samples * bytes_per_sample > MAX_SOUND_BYTES:
        return {}
    audible = sound.audible.full_scale
    whole = sound.full_scale
    return {
        "audible": {
            "full_scale": audible,
            "unit": "dB(A)",
            "tracks": encoded_stems(sound, audible, True),
        },
        "true": {
            "full_scale": whole,
            "unit": "dB SPL",
            "tracks": encoded_stems(sound, whole, False),
        },
    }


def encoded_stems(sound: Sound, full_scale: float, weighted: bool) -> dict[str, str]:
    """Return the stems, divided by `full_scale` [Pa], by name.

    A single stem can be louder than the sum; it is then clipped.
    """
    stems = [Weighted(track=track) if weighted else track for track in sound.stems.values()]
    copies = [Copy(track=stem, full_scale=full_scale) for stem in stems]
    return dict(
        zip(sound.stems, map(flac_data_url, copies), strict=True)
    )  # one by one, because the run analyses the sound meanwhile


def flac_data_url(source) -> str:
    """Encode a source as FLAC and return it as a data URL."""
    held = BytesIO()
    with soundfile.SoundFile(
        held, "w", source.sample_rate, source.channels, "PCM_16", format="FLAC"
    ) as file:
        for block in source.blocks():
            file.write(np.clip(block, -1.0, 1.0))
    return f"data:audio/flac;base64,{b64encode(held.getvalue()).decode()}"


def encoded_rates(motion: Motion) -> dict[str, Any]:
    """Return precession and nutation [Hz] over time [s]; NaN where the disk does not nutate."""
    columns = zip(("t", "precession", "nutation"), drawn_rates(motion), strict=True)
    return {name: base64_array(column) for name, column in columns}


def encoded_motion(motion: Motion) -> dict[str, Any]:
    """Return the motion at its sampled instants [s].

    The columns are attitude [rad], centre [m], force along a_1, a_2, a_3 [N] and energy [J].
    """
    t = sample_times(motion)
    state, force = motion.at_and_force(t)
    columns = dict(zip(("precession", "inclination", "spin", "x", "y"), state.T[:5], strict=True))
    columns |= dict(zip(("friction_1", "friction_2", "normal"), force.T, strict=True))
    columns["energy"] = motion.energy(t)
    whole = {
        "t": base64_array(t, float),
        "precession": base64_array(state[:, 0], float),
        "spin": base64_array(state[:, 2], float),
    }
    return {
        "columns": list(columns),
        **{name: base64_array(c) for name, c in columns.items()},
        **whole,
    }


def sample_times(motion: Motion) -> np.ndarray:
    """Return about MAX_INSTANTS instants [s], including the first and the last.

    They are denser where the contact turns faster.
    """
    some = slice(None, None, max(len(motion.t) // 200_000, 1))
    t = motion.t[some]
    precession = motion.state[some, 0]
    turned = np.abs(np.diff(precession, prepend=precession[0])).cumsum()
    progress = turned / (turned[-1] or 1.0) + (t - t[0]) / (t[-1] - t[0])
    even = np.interp(np.linspace(0, progress[-1], MAX_INSTANTS), progress, t)
    return np.unique(np.concatenate([t[:1], even, motion.t[-1:]]))


def encoded_mode_shapes(modes: Modes, support: Support) -> dict[str, Any]:
    """Return the surface of the disk [m] and the shapes of its lowest modes.

    Each shape is normalised to its greatest component.
    """
    squares = surface_polygons(modes.body)
    nodes, numbers = np.unique(squares, return_inverse=True)
    corners = numbers.reshape(squares.shape)
    triangles = np.concatenate([corners[:, [0, i, i + 1]] for i in range(1, corners.shape[1] - 1)])
    few = range(min(len(modes), MAX_SHAPES))
    captions = [mode_caption(modes, i, support.kind == "patch").replace("\n", ", ") for i in few]
    return _encoded_shapes(
        modes.body.points[nodes],
        triangles,
        captions,
        [modes.body.displacement[i][nodes] for i in few],
    )


def encoded_table_shapes(table: SurfaceModes) -> dict[str, Any]:
    """Return the top face of a table [m] and the shapes of its lowest modes, as in `shapes`."""
    few = range(min(len(table), MAX_SHAPES))
    flat = np.zeros(len(table.points))
    moved = [np.stack([flat, flat, table.face[i]], axis=1) for i in few]
    captions = [table_caption(table, i) for i in few]
    return _encoded_shapes(
        np.column_stack([table.points, flat]), Delaunay(table.points).simplices, captions, moved
    )


def _encoded_shapes(points, triangles, captions, moved):
    return {
        "points": base64_array(points),
        "triangles": base64_array(triangles, np.uint32),
        "captions": captions,
        "shapes": [base64_array(32767 * u / (np.abs(u).max() or 1.0), np.int16) for u in moved],
    }


def base64_array(values, kind: Any = np.float32) -> dict[str, str]:
    """Return the little-endian bytes of a flattened array in base64.

    Arrays of uint8 keep their type; all others are converted to `kind`.
    """
    values = np.asarray(values)
    kind = np.dtype(values.dtype if values.dtype == np.uint8 else kind)
    content = np.ascontiguousarray(values, kind.newbyteorder("<")).tobytes()
    return {"dtype": kind.name, "base64": b64encode(content).decode()}
