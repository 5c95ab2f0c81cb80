"""QUESTION -> STAGES: which stages of a run answer it, from what its findings need."""

import inspect
from collections.abc import Callable, Iterable
from functools import cache

from dynamics import Motion
from modal import Modes
from sonify.claims.provenance import judges, modules
from sonify.claims.rigid_motion import Finding
from sonify.scene import Scene
from sonify.scene_errors import InputError
from sonify.suggestions import did_you_mean

STAGES = ("motion", "modes", "sound")
"""A sound needs, and tells, all that the others tell."""
SCALARS = dict.fromkeys(("outcome", "t_end", "passed", "ended_by", "film_squeezed"), "motion")
SCALARS |= dict.fromkeys(
    ("sound_seconds", "peak_pascal", "energy_below_100_hz", "energy_below_300_hz"), "sound"
)
READ = {"motion": {"motion", "scene", "film law"}, "modes": {"modes", "scene"}}
"""What the findings of a stage may need; those that need anything else are found with the sound."""
HOOKS = {"motion": ("motion_findings", "motion_checks"), "modes": ("mode_findings", "mode_checks")}
"""Stage -> functions by which a module of the claims returns what that stage can judge by
itself."""
KEPT = {"arrays": "motion", "wav": "sound", "page": "sound"}
"""What a run may write -> the stage it needs."""


def hooked(hook: str) -> list[Callable[..., list]]:
    """Return what the modules of the claims define under the name `hook`, as motion_findings."""
    found = [getattr(module, hook, None) for module in modules()]
    return [
        f
        for f, module in zip(found, modules(), strict=True)
        if f and f.__module__ == module.__name__
    ]


def found_by(hook: str, scene: Scene, solved: Motion | Modes) -> list[Finding]:
    """Return the findings of all that is called `hook`, a function of what was `solved`, or of the
    scene and that."""
    return [
        finding
        for judge in hooked(hook)
        for finding in judge(*[scene, solved][-len(inspect.signature(judge).parameters) :])
    ]


@cache
def stage_of() -> dict[str, str]:
    """Return the stage that finds it by the name of every scalar, finding and check."""
    return SCALARS | {
        key: _stage(set(judge.needs), judge.function.__module__) for key, judge in judges().items()
    }


def _stage(needs, module):
    """A stage tells by itself what is a function of nothing else, and is asked for by a hook of its
    module."""
    own = {
        stage
        for stage, hooks in HOOKS.items()
        for hook in hooks
        for f in hooked(hook)
        if f.__module__ == module
    }
    return next((stage for stage, read in READ.items() if needs <= read and stage in own), "sound")


def needed(find: Iterable[str], keep: Iterable[str]) -> tuple[str, ...]:
    """Return the stages that tell what to `find`, by names of stages, scalars, findings or checks,
    and that yield the files to `keep`: the sound where nothing is named. Raises InputError for an
    unknown name."""
    known = stage_of() | {stage: stage for stage in STAGES}
    stages = {KEPT[kind] for kind in keep}
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
