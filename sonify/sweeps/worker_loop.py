"""A process that solves one scene after the other, and ends when there is nothing to do; `hand.py`
starts it."""

import json
from time import perf_counter
from typing import Any

from sonify.runtime.signals import what_is_asked
from sonify.sweeps.version import version

IDLE = 60.0
"""Time without a task [s] after which the process gives its memory back."""


def solved(task: dict) -> dict[str, Any]:
    """Return the row of a task as plain values, with the seconds that it took and the version of
    the program."""
    from sonify.sweeps.run_row import row_of  # loads slowly, and who asks has no need of it

    began = perf_counter()
    try:
        row = row_of(**task)
    except OSError as error:
        row = {"stop": [error.errno, error.strerror, str(error.filename or task["folder"])]}
    return json.loads(json.dumps(row | {"seconds": perf_counter() - began, "version": version()}))


if __name__ == "__main__":
    import sonify.sweeps.run_row  # before the first task  # noqa: F401

    what_is_asked(idle=IDLE)
