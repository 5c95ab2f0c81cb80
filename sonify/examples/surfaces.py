"""
Answers on each surface
=======================

Print the table of docs/surfaces.md from the findings of seven scenes. The last column is
for the same scene with an air film under the disk."""

from collections.abc import Mapping, Sequence

from sonify import load_scene, solve
from sonify.claims import air, two_way
from sonify.claims.finding import Finding
from sonify.claims.surface_summary import SURFACE_BY_SCENE, answer_table
from sonify.plan.preflight import (
    motion_plan_with_table,
    solvable_scene,
    solve_motion,
)


def findings_with_air_film(name: str, accuracy: str) -> list[Finding]:
    """Return the findings on the motion of a scene with its air film."""
    in_air = load_scene(name).replace("air.film=acts")
    scene, plan = solvable_scene(in_air, accuracy)
    motion = solve_motion(motion_plan_with_table(scene, plan)).rolling
    return [
        *air.motion_findings(scene, motion),
        *two_way.motion_findings(scene, motion),
    ]


def main(
    accuracy: str = "standard",
    names: tuple[str, ...] = tuple(SURFACE_BY_SCENE),
    known: Mapping[str, Sequence[Finding]] | None = None,
) -> str:
    """Return the table in Markdown.

    The scenes are solved one after another if their findings are not `known`."""
    runs = known or {name: solve(name, accuracy).findings for name in names}
    in_air = {
        name: findings_with_air_film(name, accuracy)
        if load_scene(name).air.film == "none"
        else runs[name]
        for name in names
    }
    return answer_table(runs, in_air)


if __name__ == "__main__":
    print(main())
