"""CLAIM -> WHAT IT HANGS ON, read from the arguments of the function that judges it."""

import inspect
from collections.abc import Callable
from functools import cache
from importlib import import_module
from pkgutil import iter_modules
from types import ModuleType

from sonify import claims
from sonify.claims.checks import Check
from sonify.claims.motion import Finding

HEARD = "the tone that is tracked in the sound alone"
WORDS = {
    "modes": "the modes of the disk",
    "film": "the law of the film",
    "expected": "the law of the contact",
    "error": "",  # of the sound, which is in the margin
} | dict.fromkeys(("heard", "tone", "last", "early"), HEARD)
"""Argument of a claim -> what it is in words."""


@cache
def modules() -> tuple[ModuleType, ...]:
    """Return the modules of the claims."""
    return tuple(import_module(f"{claims.__name__}.{module.name}") for module in iter_modules(claims.__path__))


@cache
def judges() -> dict[str, Callable]:
    """Return the function of every finding and check by its key."""
    return {
        name: function
        for module in modules()
        for name, function in inspect.getmembers(module, inspect.isfunction)
        if name[0] != "_" and inspect.signature(function).return_annotation in (Finding, Check)
    }


def hangs_on(key: str) -> str:
    """Return in words what the finding of a key is a function of."""
    told = [WORDS.get(name, f"the {name}") for name in inspect.signature(judges()[key]).parameters]
    return ", ".join(dict.fromkeys(filter(None, told)))
