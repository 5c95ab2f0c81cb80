"""Suggest the known names closest to a misspelt one, as a question that ends a
message."""

from collections.abc import Iterable
from difflib import get_close_matches


def did_you_mean(word: str, known: Iterable[str]) -> str:
    """Return "; did you mean toy?" for the known name closest to `word`, or "" if none
    is close.

    Case, "-" and "_" are ignored.
    """
    spelt = {_plain(name): name for name in known}
    closest = get_close_matches(_plain(word), spelt, n=1)
    return did_you_mean_question([spelt[name] for name in closest])


def did_you_mean_question(names: list[str]) -> str:
    """Return "; did you mean a or b?", or "" if `names` is empty."""
    return f"; did you mean {' or '.join(names)}?" if names else ""


def _plain(name: str) -> str:
    return name.lower().replace("-", "").replace("_", "")
