"""MISSPELT NAME -> the known name that was meant, for the end of a message."""

from collections.abc import Iterable
from difflib import get_close_matches


def did_you_mean(word: str, known: Iterable[str]) -> str:
    """Return "; did you mean toy?" for the known name closest to `word`, or "" if none is close.

    Case, "-" and "_" make no difference.
    """
    spelt = {_plain(name): name for name in known}
    closest = get_close_matches(_plain(word), spelt, n=1)
    return question([spelt[name] for name in closest])


def question(names: list[str]) -> str:
    """Return "; did you mean a or b?", or "" without names."""
    return f"; did you mean {' or '.join(names)}?" if names else ""


def _plain(name):
    return name.lower().replace("-", "").replace("_", "")
