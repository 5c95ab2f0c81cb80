"""QUANTITIES -> STAGES: determine the stages of a run that the requested quantities need."""

import inspect
from collections.abc import Callable, Iterable
from functools import cache

from dynamics import Motion
from modal import Modes
from sonify.claims.provenance import finding_modules, registered_judges
from sonify.claims.rigid_motion import Finding
from sonify.scene import Scene
from sonify.scene_errors import InputError
from sonify.suggestions import did_you_mean

STAGES = ("motion", "modes", "sound")
"""Stages of a run; the sound stage includes the results of the other two."""
STAGE_OF_SCALAR = dict.fromkeys(
    ("outcome", "t_end", "passed", "ended_by", "film_squeezed"), "motion"
)
STAGE_OF_SCALAR |= dict.fromkeys(
    ("sound_seconds", "peak_pascal", "energy_below_100_hz", "energy_below_300_hz"), "sound"
)
READABLE_FIELDS = {"motion": {"motion", "scene", "film law"}, "modes": {"modes", "scene"}}
"""Stage -> inputs available to its findings; findings with other inputs need the sound stage."""
STAGE_HOOKS = {
    "motion": ("motion_findings", "motion_checks"),
    "modes": ("mode_findings", "mode_checks"),
}
"""Stage -> names of the functions in `sonify.claims` that judge this stage without the sound."""
STAGE_OF_OUTPUT = {"arrays": "motion", "wav": "sound", "page": "sound"}
"""Kind of output file -> stage that it needs."""


def hook_functions(hook: str) -> list[Callable[..., list]]:
    """Return the functions named `hook`, e.g. motion_findings, that the finding modules define."""
    found = [getattr(module, hook, None) for module in finding_modules()]
    return [
        f
        for f, module in zip(found, finding_modules(), strict=True)
        if f and f.__module__ == module.__name__
    ]


def findings_of_stage(hook: str, scene: Scene, solved: Motion | Modes) -> list[Finding]:
    """Return the findings of all functions named `hook`.

    These functions take either (solved,) or (scene, solved).
    """
    return [
        finding
        for judge in hook_functions(hook)
        for finding in judge(*[scene, solved][-len(inspect.signature(judge).parameters) :])
    ]


@cache
def stage_of() -> dict[str, str]:
    """Return a map from each scalar, finding and check to the stage that computes it."""
    return STAGE_OF_SCALAR | {
        key: _stage(set(judge.needs), judge.function.__module__)
        for key, judge in registered_judges().items()
    }


def _stage(needs, module):
    """Return the stage that computes a finding with the inputs `needs`.

    Motion or modes suffice if they provide all inputs and the module defines a hook for them;
    otherwise the sound stage is needed.
    """
    own = {
        stage
        for stage, hooks in STAGE_HOOKS.items()
        for hook in hooks
        for f in hook_functions(hook)
        if f.__module__ == module
    }
    return next(
        (stage for stage, read in READABLE_FIELDS.items() if needs <= read and stage in own),
        "sound",
    )


def stages_for(find: Iterable[str], keep: Iterable[str]) -> tuple[str, ...]:
    """Return the stages needed for the quantities in `find` and for the files in `keep`.

    `find` names stages, scalars, findings or checks; if it is empty, the sound stage is needed.
    Raises InputError for an unknown name.
    """
    known = stage_of() | {stage: stage for stage in STAGES}
    stages = {STAGE_OF_OUTPUT[kind] for kind in keep}
    for name in find:
        key = name.removesuffix("_holds").removesuffix("_passed")
        if key not in known:
            hint = did_you_mean(key, known)
            raise InputError(f"find = {name!r}: unknown; known: {', '.join(known)}{hint}")
        stages.add(known[key])
    return (
        ("sound",)
        if "sound" in stages or not find
        else tuple(stage for stage in STAGES if stage in stages)
    )
