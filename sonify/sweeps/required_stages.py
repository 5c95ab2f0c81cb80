"""Stages of a run required for the requested quantities."""

from collections.abc import Iterable
from functools import cache

from dynamics import Motion
from sonify.claims import (
    air,
    checks,
    landing,
    literature,
    loss_causes,
    rigid_motion,
    table,
    two_way,
    verdict,
    vibration_level,
)
from sonify.claims.finding import Finding, Need
from sonify.claims.provenance import registered_judges
from sonify.scene import Scene
from sonify.scene_errors import InputError
from sonify.suggestions import did_you_mean

STAGES = ("motion", "modes", "verdict", "sound")
"""Stages of a run. The sound stage includes the results of motion and modes. The
verdict stage judges the claims of the paper on the motion of the simplest sufficient
model."""
STAGE_OF_SCALAR = dict.fromkeys(
    ("outcome", "t_end", "passed", "ended_by", "film_squeezed"), "motion"
)
STAGE_OF_SCALAR |= dict.fromkeys(
    ("sound_seconds", "peak_pascal", "energy_below_100_hz", "energy_below_300_hz"),
    "sound",
)
FINDING_INPUTS_BY_STAGE = {
    "motion": {"motion", "scene", "film law"},
    "modes": {"modes", "scene"},
    "verdict": {"motion", "scene", "contact law", "modes"},
}
"""Inputs of the findings of each stage; findings with other inputs need the sound
stage."""
STAGE_MODULES = {
    "motion": (air, checks, landing, literature, rigid_motion, table, two_way),
    "modes": (checks, rigid_motion),
    "verdict": (verdict, loss_causes, vibration_level),
}
"""Modules whose claims can be judged after each stage, without sound."""
STAGE_OF_OUTPUT = {"arrays": "motion", "wav": "sound", "page": "sound"}
"""Stage required for each kind of output file."""


def motion_findings(scene: Scene, motion: Motion) -> list[Finding]:
    """Return the findings that follow from a motion and its landing alone."""
    landed = landing.landing_findings(motion)
    motion = motion.rolling
    return [
        *landed,
        *air.motion_findings(scene, motion),
        *literature.motion_findings(motion),
        *rigid_motion.motion_findings(scene, motion),
        *table.motion_findings(scene, motion),
        *two_way.motion_findings(scene, motion),
    ]


@cache
def stage_by_quantity() -> dict[str, str]:
    """Return the stage that computes each scalar, finding and check, by name."""
    return STAGE_OF_SCALAR | {
        key: _stage_of_finding(set(judge.needs), judge.function.__module__)
        for key, judge in registered_judges().items()
    }


def _stage_of_finding(needs: set[Need], module: str) -> str:
    """Return the stage that computes a finding with the inputs `needs`.

    A stage without sound suffices if it provides all inputs and judges the claims of
    `module`."""
    for stage, readable in FINDING_INPUTS_BY_STAGE.items():
        if needs <= readable and module in [
            judging.__name__ for judging in STAGE_MODULES[stage]
        ]:
            return stage
    return "sound"


def stages_for(find: Iterable[str], keep: Iterable[str]) -> tuple[str, ...]:
    """Return the stages required for the quantities in `find` and the files in `keep`.

    `find` names stages, scalars, findings or checks; if it is empty, the sound stage is
    required. Raises InputError for an unknown name."""
    known = stage_by_quantity() | dict(zip(STAGES, STAGES, strict=True))
    stages = {STAGE_OF_OUTPUT[kind] for kind in keep}
    for name in find:
        key = name.removesuffix("_holds").removesuffix("_passed")
        if key not in known:
            hint = did_you_mean(key, known)
            raise InputError(
                f"find = {name!r}: unknown quantity; known: {', '.join(known)}{hint}"
            )
        stages.add(known[key])
    if "sound" in stages or not find:
        return ("sound",)
    return tuple(stage for stage in STAGES if stage in stages)
