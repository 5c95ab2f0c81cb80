"""RESULT -> NUMBERS OF THE PAGE: what the player, the curves and the two views in 3-D show, as one
JSON value.

Arrays are base64 of little-endian floats or integers, sounds are data URLs of FLAC.
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
from sonify.report.lit_polygons import skin
from sonify.report.mode_names import caption, table_caption
from sonify.report.render_worker import painter
from sonify.sound.playback import Copy, Weighted
from sonify.sound.pressure import Sound

if TYPE_CHECKING:
    from sonify.result import Result

MOST_INSTANTS = 40_000
"""Instants of the motion in the page: half of them share the time evenly, the others the turning of
the contact."""
MOST_SHAPES = 24
"""Modes in the page, the lowest."""
MOST_SOUND = 24_000_000
"""Bytes of FLAC in the page. A sound of more is in the files beside it."""
PER_SAMPLE = 1.0
"""Bytes that FLAC of 16 bits takes for a sample of a disk, or a little less."""


def page_data(result: "Result", parts: dict[str, Any] | None = None) -> dict[str, Any]:
    """Return the numbers of a page, of which the `parts` that take long may be known already: the
    `instants` of its motion, the `sounds`, and the colours of a spectrogram as bytes."""
    sound = result.sound
    motion = result.motion
    parts = parts or {
        "motion": instants(motion),
        "sound": sounds(sound),
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
            "rates": rates(motion),
            "modes": packed(np.unique(result.modes.frequency.round(1))),
        },
        "colours": packed(np.frombuffer(parts["colours"], np.uint8)),
        "disk": {
            "radius": motion.disk.radius,
            "thickness": motion.disk.thickness,
            "inner_radius": motion.disk.inner_radius,
            "weight": motion.disk.weight,
        },
        "motion": parts["motion"],
        "shapes": shapes(result.modes, result.scene.support),
        "table": table_shapes(result.table)
        if result.table is not None and len(result.table)
        else None,
        "seen": spectrogram(result),
    }


def sounds(sound: Sound) -> dict[str, Any]:
    """Return every stem in two scales: A-weighted and loud, as audible.wav, and true, as sound.wav;
    empty where they are too long for a page."""
    if 2 * len(sound.stems) * sound.samples * PER_SAMPLE > MOST_SOUND:
        return {}
    audible = sound.audible.full_scale
    whole = sound.full_scale
    return {
        "audible": {"full_scale": audible, "unit": "dB(A)", "tracks": tracks(sound, audible, True)},
        "true": {"full_scale": whole, "unit": "dB SPL", "tracks": tracks(sound, whole, False)},
    }


def tracks(sound: Sound, full_scale: float, weighted: bool) -> dict[str, str]:
    """Return the stems over `full_scale` [Pa] by name; a stem alone may be louder than their sum,
    and is clipped."""
    stems = [Weighted(track=track) if weighted else track for track in sound.stems.values()]
    copies = [Copy(track=stem, full_scale=full_scale) for stem in stems]
    return dict(
        zip(sound.stems, map(compressed, copies), strict=True)
    )  # one by one: a run listens meanwhile


def compressed(source) -> str:
    """Return a source as a data URL of FLAC."""
    held = BytesIO()
    with soundfile.SoundFile(
        held, "w", source.sample_rate, source.channels, "PCM_16", format="FLAC"
    ) as file:
        for block in source.blocks():
            file.write(np.clip(block, -1.0, 1.0))
    return f"data:audio/flac;base64,{b64encode(held.getvalue()).decode()}"


def rates(motion: Motion) -> dict[str, Any]:
    """Return precession and nutation [Hz] over time [s]; the nutation is not a number where the
    disk has none."""
    columns = zip(("t", "precession", "nutation"), drawn_rates(motion), strict=True)
    return {name: packed(column) for name, column in columns}


def instants(motion: Motion) -> dict[str, Any]:
    """Return the time [s] and, at each, attitude [rad], centre [m], force along a_1, a_2, a_3 [N]
    and energy [J]."""
    t = chosen(motion)
    state, force = motion.at_and_force(t)
    columns = dict(zip(("precession", "inclination", "spin", "x", "y"), state.T[:5], strict=True))
    columns |= dict(zip(("friction_1", "friction_2", "normal"), force.T, strict=True))
    columns["energy"] = motion.energy(t)
    whole = {
        "t": packed(t, float),
        "precession": packed(state[:, 0], float),
        "spin": packed(state[:, 2], float),
    }
    return {"columns": list(columns), **{name: packed(c) for name, c in columns.items()}, **whole}


def chosen(motion: Motion) -> np.ndarray:
    """Return at most MOST_INSTANTS instants [s], from the first to the last: denser where the
    contact turns faster."""
    some = slice(None, None, max(len(motion.t) // 200_000, 1))
    t = motion.t[some]
    precession = motion.state[some, 0]
    turned = np.abs(np.diff(precession, prepend=precession[0])).cumsum()
    progress = turned / (turned[-1] or 1.0) + (t - t[0]) / (t[-1] - t[0])
    even = np.interp(np.linspace(0, progress[-1], MOST_INSTANTS), progress, t)
    return np.unique(np.concatenate([t[:1], even, motion.t[-1:]]))


def shapes(modes: Modes, support: Support) -> dict[str, Any]:
    """Return the surface of the disk [m] and how the lowest modes move it, each over its greatest
    displacement."""
    squares = skin(modes.body)
    nodes, numbers = np.unique(squares, return_inverse=True)
    corners = numbers.reshape(squares.shape)
    triangles = np.concatenate([corners[:, [0, i, i + 1]] for i in range(1, corners.shape[1] - 1)])
    few = range(min(len(modes), MOST_SHAPES))
    captions = [caption(modes, i, support.kind == "patch").replace("\n", ", ") for i in few]
    return _moving(
        modes.body.points[nodes],
        triangles,
        captions,
        [modes.body.displacement[i][nodes] for i in few],
    )


def table_shapes(table: SurfaceModes) -> dict[str, Any]:
    """Return the top face of a table [m] and how its lowest modes move it, as `shapes` does."""
    few = range(min(len(table), MOST_SHAPES))
    flat = np.zeros(len(table.points))
    moved = [np.stack([flat, flat, table.face[i]], axis=1) for i in few]
    captions = [table_caption(table, i) for i in few]
    return _moving(
        np.column_stack([table.points, flat]), Delaunay(table.points).simplices, captions, moved
    )


def _moving(points, triangles, captions, moved):
    return {
        "points": packed(points),
        "triangles": packed(triangles, np.uint32),
        "captions": captions,
        "shapes": [packed(32767 * u / (np.abs(u).max() or 1.0), np.int16) for u in moved],
    }


def packed(values, kind: Any = np.float32) -> dict[str, str]:
    """Return an array, flat, as base64 of its little-endian bytes; integers keep their kind."""
    values = np.asarray(values)
    kind = np.dtype(values.dtype if values.dtype == np.uint8 else kind)
    content = np.ascontiguousarray(values, kind.newbyteorder("<")).tobytes()
    return {"dtype": kind.name, "base64": b64encode(content).decode()}
