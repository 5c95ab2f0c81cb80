"""Stretches of a motion over which the rungs are solved.

A rung that would take too long is solved from steady rolling at a smaller inclination,
and so are the others, so that its answers can be compared.
"""

from math import degrees, radians
from typing import Any, NamedTuple

import numpy as np

from dynamics.scene_constants import scene_constants
from dynamics.steady_motion import steady_omega
from sonify.ladder.rungs import Rungs, SceneRung, assignments, rungs_of
from sonify.plan.duration import predicted_run_seconds
from sonify.plan.motion import planned_scene
from sonify.runtime.progress import duration_in_words
from sonify.scene import Scene
from sonify.scene_errors import SceneError

MAX_RUNG_SECONDS = 600.0
"""Predicted time [s] above which a rung is solved over a stretch."""
WHOLE_MOTION = "whole motion"


class LadderRow(NamedTuple):
    """A rung over a stretch of the motion."""

    rung: SceneRung
    stretch: str


class OmittedRung(NamedTuple):
    """A rung that is too expensive over any stretch, with the predicted time [s]."""

    rung: SceneRung
    stretch: str


class LadderPlan(NamedTuple):
    """The rows of a ladder, and the rungs that are omitted over a stretch."""

    rows: list[LadderRow]
    omitted: list[OmittedRung]


def ladder_plan(scene: Scene, rungs: Rungs, limit: float) -> LadderPlan:
    """Return the rows of a ladder, each with a predicted time of at most `limit` [s].

    If a rung exceeds the limit, all rungs are also solved over the longest tried stretch
    that none of them exceeds.
    """
    rows = [LadderRow(r, WHOLE_MOTION) for r in rungs.usable if r.seconds <= limit]
    omitted = [OmittedRung(r, WHOLE_MOTION) for r in rungs.usable if r.seconds > limit]
    if omitted:
        release = stretch_release(scene, omitted, limit)
        if release:
            inclination = release["release.inclination_deg"]
            stretch = f"steady rolling from {inclination:g} degrees"
            rows += [LadderRow(released(r, release), stretch) for r in rungs.usable]
    return LadderPlan(rows, omitted)


def stretch_release(
    scene: Scene, long: list[OmittedRung], limit: float
) -> dict[str, Any]:
    """Return the release of the longest tried stretch on which no rung exceeds a limit.

    It is empty if there is none.
    """
    first = radians(scene.release.inclination_deg)
    for inclination in first * 2.0 ** -np.arange(1, 8):
        try:
            release = steady_release(scene, float(inclination))
            fits = [released(one.rung, release).seconds <= limit for one in long]
        except (SceneError, ValueError):  # no steady motion, or nothing remains
            continue
        if all(fits):
            return release
    return {}


def steady_release(scene: Scene, inclination: float) -> dict[str, Any]:
    """Return the release into steady rolling at an inclination [rad].

    Raises ValueError if there is no such motion.
    """
    rounded = float(f"{degrees(inclination):.3g}")
    omega = steady_omega(radians(rounded), scene_constants(scene))
    unit = scene.disk.time_unit
    return {
        "release.inclination_deg": rounded,
        "release.omega": [float(f"{rate / unit:.6g}") for rate in omega],
    }


def released(rung: SceneRung, release: dict[str, Any]) -> SceneRung:
    """Return a rung with another release. Raises SceneError if it is not possible."""
    scene, plan = planned_scene(rung.scene.replace(release))
    return SceneRung(
        rung.rung, rung.values | release, scene, predicted_run_seconds(scene, plan)
    )


def plan_lines(scene: Scene, limit: float = MAX_RUNG_SECONDS) -> list[str]:
    """Return lines that describe the rungs of a scene, with their predicted times.

    Nothing is solved or written. Raises SceneError if the scene cannot be solved.
    """
    rungs = rungs_of(scene)
    plan = ladder_plan(scene, rungs, limit)
    lines = []
    for row in plan.rows:
        rung, values, _, seconds = row.rung
        settings = f"--set {assignments(values)}" if values else "the scene itself"
        lines.append(f"{seconds:6.0f} s  {rung.name:24} {row.stretch}: {settings}")
    lines += [omission_line(one, limit) for one in plan.omitted]
    lines += [
        f"     no   {one.rung.name:24} {one.reason}" for one in rungs.inapplicable
    ]
    total = sum(row.rung.seconds for row in plan.rows)
    return [*lines, f"{len(plan.rows)} rows, about {duration_in_words(total)}"]


def omission_line(omitted: OmittedRung, limit: float) -> str:
    """Return a line on a rung that is too expensive over a stretch."""
    name = omitted.rung.rung.name
    seconds = omitted.rung.seconds
    return f"     no   {name:24} {omitted.stretch}: predicted {seconds:.0f} s, more than {limit:g} s"
