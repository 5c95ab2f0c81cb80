"""CLAIM -> INPUTS: the inputs of each finding, in words."""

from functools import cache
from importlib import import_module
from pkgutil import iter_modules
from types import ModuleType

from sonify import claims
from sonify.claims.finding import JUDGES, Judge

NEED_IN_WORDS = {
    "tone": "the rising tone, tracked in the sound alone",
    "film law": "the law of the air film",
}
"""Inputs of findings whose description is not simply "the" and their name."""


@cache
def finding_modules() -> tuple[ModuleType, ...]:
    """Return the modules of the claims."""
    return tuple(
        import_module(f"{claims.__name__}.{module.name}")
        for module in iter_modules(claims.__path__)
    )


@cache
def registered_judges() -> dict[str, Judge]:
    """Return the function and the inputs of every finding, by key."""
    finding_modules()
    return dict(sorted(JUDGES.items()))


def depends_on(key: str) -> str:
    """Return the inputs of the finding with this key, in words."""
    return ", ".join(
        NEED_IN_WORDS.get(need, f"the {need}") for need in registered_judges()[key].needs
    )
