"""Collect the data of each picture from the solved motion and the sound.

Every picture is readable without colour.
"""

from collections.abc import Callable, Sequence
from concurrent.futures import Executor, Future
from functools import partial
from io import BytesIO
from itertools import zip_longest
from typing import TYPE_CHECKING, Any

import numpy as np

from dynamics.observables import nutation_frequency, plotted_rates, precession_rate
from sonify.claims.contact import contact_resonance_curve
from sonify.claims.reference_scenes import is_paper_scene
from sonify.claims.rigid_motion import (
    PAPER_FORCING_FREQUENCY,
    PAPER_FORCING_FREQUENCY_TIME,
)
from sonify.claims.sound import FINAL_INTERVAL_DURATION
from sonify.claims.table import radiated_power
from sonify.claims.two_way import energy_budget, two_way_part
from sonify.hearing.spectrogram import (
    CONTACT_RATE_BAND_HZ,
    CONTACT_RATE_WINDOW_S,
    MODE_WINDOW_S,
    spectrogram,
)
from sonify.plan.supports import SupportStep, modes_over_run
from sonify.report.mode_names import table_caption
from sonify.report.render_worker import draw_png, painter
from sonify.result import output_folder
from sonify.runtime.files import atomic_write
from sonify.sound.radiation import listener_of

if TYPE_CHECKING:
    from PIL.Image import Image

    from dynamics.motion import Motion
    from sonify.result import Result, SolvedMotion


class Pictures:
    """Pictures of a run and the time-consuming parts of its page.

    The `painter` draws each picture as soon as its data are known.
    """

    def __init__(self, executor: Executor) -> None:
        self._executor = executor
        self._futures: dict[str, Future[Any]] = {}
        self._parts = {"colours": painter().draw("sound", "write_colour_table", dict)}

    @classmethod
    def of_result(cls, result: "Result", executor: Executor) -> "Pictures":
        """Start drawing all pictures of a result."""
        pictures = cls(executor)
        for stage in PAGE_PARTS:
            pictures._begin_stage(stage, result)
        return pictures

    def begin(self, found: "SolvedMotion") -> None:
        """Start drawing the pictures and encoding the page part of a completed stage."""
        self._begin_stage(found.completed_stage, found)

    def _begin_stage(self, stage: str, found: "SolvedMotion | Result") -> None:
        for name, (needs, module, function, shown) in PICTURES.items():
            if needs == stage and not _is_omitted(name, found):
                data = partial(shown, found)
                self._futures[name] = painter().draw(module, function, data)
        self._parts[stage] = self._executor.submit(PAGE_PARTS[stage], found)

    def page_parts(self) -> dict[str, Any]:
        """Return the argument `parts` of `page_data`, after both stages have begun."""
        return {name: part.result() for name, part in self._parts.items()}

    def write(self, result: "Result") -> None:
        """Write every picture of a result into its folder.

        Drafts omit the stems, and motions without two-way coupling omit the energies.
        """
        for name in PICTURES:
            path = output_folder(result) / f"{name}.png"
            if _is_omitted(name, result):
                path.unlink(missing_ok=True)  # left by an earlier run
                continue
            with atomic_write(path) as temporary:
                temporary.write_bytes(self._futures[name].result())


def encode_motion(found: "SolvedMotion | Result") -> dict[str, Any]:
    from sonify.report.page_data import encoded_motion  # slow import

    return encoded_motion(found.motion)


def encode_sounds(found: "Result") -> dict[str, Any]:
    from sonify.report.page_data import encoded_sounds  # slow import

    _ = found.sound.loudness  # computed early, because run.json contains it
    return encoded_sounds(found.sound)


PAGE_PARTS: dict[str, Callable[[Any], Any]] = {
    "motion": encode_motion,
    "sound": encode_sounds,
}
"""Function that encodes the part of the page of each stage."""


def _is_omitted(name: str, found: "SolvedMotion | Result") -> bool:
    if name == "energy":
        return not two_way_part(found.motion.rolling)
    return name == "stems" and found.plan.accuracy == "draft"


def picture(result: "Result", name: str) -> "Image":
    """Return one of the PICTURES of a result for a notebook.

    Raises ValueError for an unknown name.
    """
    from PIL import Image

    if name not in PICTURES:
        raise ValueError(
            f"there is no picture {name!r}; choose one of {', '.join(PICTURES)}"
        )
    _, module, function, shown = PICTURES[name]
    return Image.open(BytesIO(draw_png(module, function, shown(result)))).convert("RGB")


def spectrogram_data(found: "Result") -> dict[str, Any]:
    motion = found.motion.rolling
    sound = found.sound
    low = spectrogram(sound.pressure, CONTACT_RATE_WINDOW_S).band(*CONTACT_RATE_BAND_HZ)
    high = spectrogram(sound.pressure, MODE_WINDOW_S)
    table = found.plan.rendered_table(found.table)
    end = (
        max(sound.source_end - FINAL_INTERVAL_DURATION, 0.0),
        min(sound.source_end + FINAL_INTERVAL_DURATION / 4, sound.duration),
    )
    time, *rates = plotted_rates(motion)
    delay = sound.source_end - motion.t[-1]
    return {
        "bands": (low, high),
        "spans": [(0.0, sound.duration), end],
        "frequencies": found.modes.frequency,
        "table": table.frequency if table else [],
        "carrier": contact_resonance_curve(found.scene, motion, delay),
        "time": time + delay,
        "rates": rates,
    }


def stem_level_data(found: "Result") -> dict[str, Any]:
    sound = found.sound
    stems = {
        name: (one.time, one.a_weighted, one.above_threshold)
        for name, one in sound.stem_audibility.items()
    }
    return {"stems": stems, "end": sound.source_end, "duration": sound.duration}


def motion_curve_data(found: "SolvedMotion | Result") -> dict[str, Any]:
    """Return the time histories of a motion and, for the paper's scene, the curves of
    its figures.
    """
    motion = found.motion.rolling
    paper = _paper_figures(motion) if is_paper_scene(found.scene) else None
    return {"motion": _time_histories(motion), "paper": paper}


def _time_histories(motion: "Motion") -> dict[str, Any]:
    """Return the time histories of a motion in SI units, with inclination in
    degrees."""
    t = np.linspace(0, motion.t[-1], 24_000)
    state, force = motion.at_and_force(t)
    rates = np.array(plotted_rates(motion))
    return {
        "time": t,
        "inclination": np.degrees(state[:, 1]),
        "energy": motion.energy(t),
        "force": (force[:, 2], motion.disk.weight),
        "centre": 1e3 * state[:, 3:5].T,
        "rates": rates,
        "before_end": np.vstack([motion.t_end - rates[:1], rates[1:]]),
    }


def _paper_figures(motion: "Motion") -> dict[str, Any]:
    """Return the curves of the paper's figures and the weight in their unit of
    force."""
    disk = motion.disk
    chi = disk.time_unit
    t = np.linspace(0, motion.t[-1], 12000)
    state = motion.at(t)
    peaks, frequency = nutation_frequency(motion)
    curves = (
        (t / chi, np.pi / 2 - state[:, 1]),
        (t / chi, motion.energy(t) * chi**2 / (disk.mass * disk.radius**2)),
        (t / chi, motion.normal_load(t)),
        (peaks / chi, frequency * chi),
        (state[:, 3] / disk.radius, state[:, 4] / disk.radius),
        (t / chi, precession_rate(state) * chi),
    )
    weight = motion.normal_load([0.0])[0] * disk.weight / motion.force([0.0])[0, 2]
    return {
        "curves": curves,
        "weight": weight,
        "chi": chi,
        "frequency": PAPER_FORCING_FREQUENCY,
        "reached": PAPER_FORCING_FREQUENCY_TIME,
    }


def energy_data(found: "Result") -> dict[str, Any]:
    """Return the energies of a two-way coupled motion at times that are spaced more
    closely towards its end."""
    motion = found.motion.rolling
    end = motion.t[-1]
    t = times_of_two_way_coupling(two_way_part(motion)[1], end)
    heard = radiated_power(found.sound, listener_of(found.scene))
    budget = energy_budget(motion, t, heard)
    held = {
        "disk": budget.disk,
        "modes of the table": budget.table,
        "modes of the disk": budget.bending,
    }
    return {
        "left": end - t,
        "held": held,
        "lost": budget.lost | {"sound of the table": budget.sound},
    }


def times_of_two_way_coupling(begin: float, end: float) -> np.ndarray:
    """Return times [s] from `begin` to `end`, spaced more closely towards `end`."""
    return np.maximum(
        end - np.geomspace(end - begin, 1e-4 * (end - begin), 2000), begin
    )  # round-off must not produce earlier times


def mode_shape_data(found: "SolvedMotion | Result") -> dict[str, Any]:
    """Return the modes of disk and table; drafts omit the oblique view."""
    steps = modes_over_run(found.scene, found.motion.rolling, found.plan.highest_mode)
    shown = {
        "modes": found.modes,
        "slanted": found.plan.accuracy != "draft",
        "support": found.scene.support,
        "moving": mode_changes_text(steps),
    }
    table = found.plan.rendered_table(found.table)
    if table:
        few = range(min(len(table), 10))
        captions = [table_caption(table, i) for i in few]
        shown["table"] = (table.points, table.face[few], captions, len(table))
    return shown


def mode_changes_text(steps: Sequence[SupportStep]) -> str:
    """Return one line for each mode of a disk on its contact.

    It lists the frequency [Hz] at each inclination [degrees] as the disk falls.
    """
    if not steps:
        return ""
    columns = [
        [f"{f:.0f}" for f in step.modes.frequency] if step.modes else []
        for step in steps
    ]
    at = ",\n".join(
        f"{step.name} {np.degrees(step.inclination):.2g}°" for step in steps
    )
    lines = [f"[Hz] at {at}"]
    for i, row in enumerate(zip_longest(*columns, fillvalue="none"), 1):
        lines.append(f"{i}: {' → '.join(row)}")
    return "\n".join(lines)


PICTURES: dict[str, tuple[str, str, str, Callable[[Any], dict[str, Any]]]] = {
    "spectrogram": ("sound", "sound", "draw_spectrogram", spectrogram_data),
    "stems": ("sound", "sound", "draw_stems", stem_level_data),
    "motion": ("motion", "motion", "draw_motion", motion_curve_data),
    "energy": ("sound", "motion", "draw_energy", energy_data),
    "modes": ("motion", "mode_shapes", "draw_modes", mode_shape_data),
}
"""Required stage, module, drawing function and data-collecting function of each
picture, by its name."""
