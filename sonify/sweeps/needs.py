"""QUESTION -> STAGES: which stages of a run answer it, read from what the claims are functions of."""

import inspect
from collections.abc import Iterable
from functools import cache
from importlib import import_module
from pkgutil import iter_modules

from sonify import claims
from sonify.claims.checks import Check
from sonify.claims.motion import Finding
from sonify.scene_errors import InputError

STAGES = ("motion", "modes", "sound")
"""A sound needs, and tells, all that the others tell."""
SCALARS = {"outcome": "motion", "t_end": "motion", "passed": "motion"}
SCALARS |= dict.fromkeys(("sound_seconds", "peak_pascal", "energy_below_100_hz", "energy_below_300_hz"), "sound")
READ = {"motion": {"motion", "scene", "friction"}, "modes": {"modes", "scene", "disk"}}
"""What the claims on a stage may be functions of; those of anything else are on the sound."""
KEPT = {"arrays": "motion", "wav": "sound", "page": "sound"}
"""What a run may write -> the stage it needs."""


@cache
def stage_of() -> dict[str, str]:
    """Return the stage that finds it by the name of every scalar, finding and check."""
    modules = [import_module(f"{claims.__name__}.{module.name}") for module in iter_modules(claims.__path__)]
    functions = {name: f for module in modules for name, f in inspect.getmembers(module, inspect.isfunction)}
    told = {name: inspect.signature(f) for name, f in functions.items() if name[0] != "_"}
    judges = {name: s for name, s in told.items() if s.return_annotation in (Finding, Check)}
    return SCALARS | {name: _stage(set(signature.parameters)) for name, signature in judges.items()}


def _stage(parameters):
    return next((stage for stage, read in READ.items() if parameters <= read), "sound")


def needed(find: Iterable[str], keep: Iterable[str]) -> tuple[str, ...]:
    """Return the stages that tell what to `find`, by names of stages, scalars, findings or checks, and that yield the
    files to `keep`: the sound where nothing is named. Raises InputError for an unknown name."""
    known = stage_of() | {stage: stage for stage in STAGES}
    stages = {KEPT[kind] for kind in keep}
    for name in find:
        key = name.removesuffix("_holds").removesuffix("_passed")
        if key not in known:
            raise InputError(f"find = {name!r}: unknown; known: {', '.join(known)}")
        stages.add(known[key])
    return ("sound",) if "sound" in stages or not find else tuple(stage for stage in STAGES if stage in stages)
