"""
Contact open or closed
======================

Print what a cell of 1.5 V and the microphone input of a phone would record if the contact
of a metal disk with a metal plate were a switch: the toy on polished steel and a coin on
brushed metal, with intervals from runs in which one assumed value at a time takes the ends
of its range."""

from collections.abc import Iterator, Mapping
from math import radians
from typing import Any, NamedTuple

import numpy as np

from dynamics import Motion, simulate
from dynamics.scene_constants import scene_constants
from dynamics.steady_motion import steady_omega
from sonify import Scene, load_scene
from sonify.runtime.markdown import markdown_table

TOY_INCLINATION_DEG = 2.2
"""Inclination at which the toy starts to roll steadily, 2.6 s before its end."""
MAX_PLATE_DEVIATION = 1e-5
"""Departure [m] of a real plate from a plane, which the floating disk touches."""
ASSUMED_RANGES: dict[str, dict[str, tuple[float, ...]]] = {
    "toy on polished steel": {
        "roughness.rms_edge": (1e-8, 1e-7),
        "roughness.rms": (5e-9, 5e-8),
        "roughness.exponent": (0.5, 1.5),
        "contact.loss_factor": (0.005, 0.08),
    },
    "coin on brushed metal": {
        "roughness.rms": (1.5e-6, 6e-6),
        "roughness.seed": (1, 2),
        "contact.restitution": (0.3, 0.75),
        "contact.fillet": (3.6e-4, 7e-4),
    },
}
"""Column -> assumed value -> both ends of its range."""


class Trace(NamedTuple):
    """What the circuit records of a motion.

    Attributes
    ----------
    open_percent : float
        Share of the last second of rolling or rattling without contact [%].
    openings : float
        Number of openings in this second, without the last one.
    longest : float
        Longest of these openings [ms].
    last : float
        Duration of the last opening [s], in which the disk floats, until it touches a
        plate that is plane within MAX_PLATE_DEVIATION or until the end of a solved rattle.
    """

    open_percent: float
    openings: float
    longest: float
    last: float


ROW_NAMES_BY_FIELD = {
    "open_percent": "time without contact in the last second of rolling [%]",
    "openings": "openings in this second, without the last one",
    "longest": "longest of these [ms]",
    "last": "duration of the last opening, at least [s]",
}
"""Field of `Trace` -> its row in the table."""


def rolling_toy(scene: Scene) -> Scene:
    """Return a scene whose disk rolls steadily from TOY_INCLINATION_DEG on."""
    steady = steady_omega(radians(TOY_INCLINATION_DEG), scene_constants(scene))
    omega = [float(rate) / scene.disk.time_unit for rate in steady]
    return scene.replace(
        {"release.inclination_deg": TOY_INCLINATION_DEG, "release.omega": omega}
    )


def scenes() -> dict[str, Scene]:
    """Return the scene of each column of the table.

    The toy has a time-stepped contact on a plane, rigid block of steel.
    """
    steel = {
        "surface": {"sag": 0.0},
        "contact.young": 200e9,
        "contact.poisson": 0.29,
        "roughness.rms": 2e-8,
        "roughness.loss": None,
        "numerics.contact": "full",
    }
    toy, coin = ASSUMED_RANGES
    return {
        toy: rolling_toy(load_scene("toy").replace(steel)),
        coin: load_scene("coin-grain").replace("numerics.accuracy=draft"),
    }


def varied(scene: Scene, ranges: Mapping[str, tuple[float, ...]]) -> Iterator[Scene]:
    """Yield a scene as it is, and with each assumed value at both ends of its range."""
    yield scene
    for key, ends in ranges.items():
        for value in ends:
            yield scene.replace({key: value})


def trace(motion: Motion) -> Trace:
    """Return what the circuit records of a motion."""
    rolling = motion.rolling
    end = float(rolling.t[-1])
    recent = [loss for loss in rolling.contact_losses if loss.t > end - 1]
    lasts = np.array([min(loss.duration, end - loss.t) for loss in recent])
    afloat = time_afloat(motion)
    closed = lasts
    stays_open = len(lasts) > 0 and recent[-1].t + lasts[-1] > end - 1e-6
    if motion.landing is None and stays_open:
        afloat = float(lasts[-1])
        closed = lasts[:-1]
    return Trace(
        open_percent=100 * float(lasts.sum()),
        openings=len(closed),
        longest=1e3 * float(closed.max(initial=0.0)),
        last=afloat,
    )


def time_afloat(motion: Motion) -> float:
    """Return the time [s] from the end of rolling until a floating disk touches the plate.

    It is 0 if the motion does not continue after rolling, or in a vacuum.
    """
    landing = motion.landing
    if landing is None or landing.model.film is None:
        return 0.0
    gap = float(landing.clearance(landing.t[-1:])[0])
    sinking = landing.model.film.sink_time(gap, MAX_PLATE_DEVIATION, motion.disk.weight)
    return float(landing.t[-1]) + sinking


def cell(values: list[float], digits: int | None = None) -> str:
    """Return the first value with the range of all; by default with one digit, or three
    if all are below 1."""
    if digits is None:
        digits = 3 if max(values) < 1 else 1
    first, low, high = values[0], min(values), max(values)
    return f"{first:.{digits}f} ({low:.{digits}f} to {high:.{digits}f})"


def rows_of_fields(
    names: Mapping[str, str],
    columns: Mapping[str, list[Any]],
    digits: Mapping[str, int],
) -> list[list[str]]:
    """Return the rows of a table whose columns have the runs of one scene each: the head,
    and a row for each field of the runs, with its name and its digits."""
    rows = [["", *columns]]
    for field, words in names.items():
        cells = [
            cell([getattr(run, field) for run in runs], digits.get(field))
            for runs in columns.values()
        ]
        rows.append([words, *cells])
    return rows


def table(columns: Mapping[str, list[Trace]]) -> str:
    """Return the table in Markdown; each column has the runs of one scene."""
    digits = {"open_percent": 1, "openings": 0, "longest": 1, "last": 2}
    return markdown_table(rows_of_fields(ROW_NAMES_BY_FIELD, columns, digits))


def main() -> str:
    """Return the second table of docs/predictions.md."""
    return table(
        {
            name: [trace(simulate(one)) for one in varied(scene, ASSUMED_RANGES[name])]
            for name, scene in scenes().items()
        }
    )


if __name__ == "__main__":
    print(main())
