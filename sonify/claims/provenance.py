"""Descriptions of the inputs of each finding."""

from functools import cache
from importlib import import_module
from pkgutil import iter_modules

from sonify import claims
from sonify.claims.finding import JUDGE_BY_KEY, Judge

NEED_IN_WORDS = {
    "tone": "the rising tone, tracked in the sound alone",
    "film law": "the law of the air film",
}
"""Descriptions of inputs that differ from "the" followed by the name."""


@cache
def registered_judges() -> dict[str, Judge]:
    """Return the function and the inputs of every finding, sorted by key."""
    for module in iter_modules(claims.__path__):
        import_module(f"{claims.__name__}.{module.name}")
    return dict(sorted(JUDGE_BY_KEY.items()))


def depends_on(key: str) -> str:
    """Return a description of the inputs of the finding with this key."""
    return ", ".join(
        NEED_IN_WORDS.get(need, f"the {need}")
        for need in registered_judges()[key].needs
    )
