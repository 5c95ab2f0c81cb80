"""
What a phone can refute
=======================

Print what the program predicts for the last second of the toy, on its concave mirror, on
a plane plate, and on a plane plate with a hole under the disk. The intervals cover all
runs in which one assumed value is replaced by an end of its range."""

from collections.abc import Iterator, Mapping
from math import pi
from typing import NamedTuple

from dynamics import Motion, Outcome, simulate
from sonify import Scene, load_scene
from sonify.claims.landing import halt_is_abrupt
from sonify.examples.contact_circuit import rows_of_fields
from sonify.runtime.markdown import markdown_table

HOLE_DIAMETER = 0.06
"""Diameter of the hole [m]."""
ASSUMED_RANGES: dict[str, tuple[tuple[str, ...], ...]] = {
    "viscosity of the air, 2 %": (
        ("air.viscosity=1.784e-5",),
        ("air.viscosity=1.856e-5",),
    ),
    "contour friction": (
        ("dissipation.contour_moment=2.4e-6",),
        ("dissipation.contour_moment=4.3e-6",),
    ),
    "sliding friction": (
        ("friction.mu_static=0.15", "friction.mu_dynamic=0.12"),
        ("friction.mu_static=0.4", "friction.mu_dynamic=0.3"),
    ),
}
"""Assumed value -> the changes at both ends of its range, as in the sweep verdict-mirror."""
MIRROR_DEPTH_RANGE = (("surface.sag=0.5e-3",), ("surface.sag=2e-3",))
"""Changes at both ends of the range of the depth of the mirror."""


class LastSecond(NamedTuple):
    """What is measured of a motion.

    Attributes
    ----------
    duration : float
        Time [s] until the rolling motion ends.
    rate_at_1s, rate_at_100ms : float
        Turns of the contact per second, 1 s and 0.1 s before this end.
    last_rate : float
        Turns of the contact per second in the last 20 ms before this end.
    turns : float
        Turns from this end until the contact would turn less than once per second.
    is_lifted : bool
        True if the air film lifts the disk at this end.
    """

    duration: float
    rate_at_1s: float
    rate_at_100ms: float
    last_rate: float
    turns: float
    is_lifted: bool


ROW_NAMES_BY_FIELD = {
    "duration": "duration [s]",
    "rate_at_1s": "turns per second, 1 s before the end",
    "rate_at_100ms": "turns per second, 0.1 s before the end",
    "last_rate": "turns per second, in the last 20 ms",
    "turns": "turns after the contact is lost",
}
"""Field of `LastSecond` -> its row in the table."""


def toy_on(surface: Mapping[str, float]) -> Scene:
    """Return the toy on a rigid, smooth table of a shape given by the section `surface`.

    Neither the roughness nor the vibration of the mirror changes the motion of the toy;
    they make its sound.
    """
    sections = ("roughness", "support", "contact.law")
    return load_scene("toy").replace(dict.fromkeys(sections) | {"surface": surface})


def scenes() -> dict[str, Scene]:
    """Return the scene of each column of the table."""
    mirror = load_scene("toy").surface
    shape = {"sag": mirror.sag, "diameter": mirror.diameter or 0.0}
    return {
        "mirror": toy_on(shape),
        "plane plate": toy_on({"sag": 0.0}),
        "plane plate with a 60 mm hole": toy_on({"hole": HOLE_DIAMETER}),
    }


def varied(scene: Scene) -> Iterator[Scene]:
    """Yield a scene as it is, and with each assumed value at both ends of its range."""
    ends = [end for both in ASSUMED_RANGES.values() for end in both]
    if scene.surface.sag:
        ends += MIRROR_DEPTH_RANGE
    yield scene
    for changes in ends:
        yield scene.replace(*changes)


def turns_per_second(motion: Motion, time: float, window: float) -> float:
    """Return the mean turns of the contact per second around a time [s]."""
    span = [time - window / 2, time + window / 2]
    first, last = motion.precession(span)
    return float(abs(last - first) / (2 * pi) / window)


def last_second(scene: Scene) -> LastSecond:
    """Solve the motion of a scene and measure its last second."""
    motion = simulate(scene)
    rolling = motion.rolling
    end = float(rolling.t[-1])
    landing = motion.landing
    if landing is None:
        raise ValueError(f"the disk did not leave the table: {rolling.rolling_outcome}")
    return LastSecond(
        duration=end,
        rate_at_1s=turns_per_second(rolling, end - 1, 0.1),
        rate_at_100ms=turns_per_second(rolling, end - 0.1, 0.05),
        last_rate=turns_per_second(rolling, end - 0.01, 0.02),
        turns=float(halt_is_abrupt(landing).value),
        is_lifted=rolling.rolling_outcome is Outcome.AIRBORNE,
    )


def table(columns: Mapping[str, list[LastSecond]]) -> str:
    """Return the table in Markdown; each column has the runs of one scene."""
    rows = rows_of_fields(ROW_NAMES_BY_FIELD, columns, {})
    lifted = [
        f"{sum(run.is_lifted for run in runs)} of {len(runs)}"
        for runs in columns.values()
    ]
    return markdown_table([*rows, ["runs in which the air lifts the disk", *lifted]])


def main() -> str:
    """Return the table of docs/predictions.md."""
    return table(
        {
            name: [last_second(one) for one in varied(scene)]
            for name, scene in scenes().items()
        }
    )


if __name__ == "__main__":
    print(main())
