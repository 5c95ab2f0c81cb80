"""Worker process: solve one scene after another, and exit when idle.

`row_processes` starts it.
"""

import json
from time import perf_counter
from typing import Any

from sonify.runtime.signals import worker_loop
from sonify.sweeps.version import version

IDLE_TIMEOUT = 60.0
"""Idle time after which the process exits and frees its memory [s]."""


def timed_row(task: dict) -> dict[str, Any]:
    """Solve a task; return its row as plain values, with the run time [s] and the version."""
    from sonify.sweeps.run_row import row_of  # deferred: slow, and the parent does not need it

    began = perf_counter()
    try:
        row = row_of(**task)
    except OSError as error:
        row = {"stop": [error.errno, error.strerror, str(error.filename or task["folder"])]}
    return json.loads(json.dumps(row | {"seconds": perf_counter() - began, "version": version()}))


if __name__ == "__main__":
    import sonify.sweeps.run_row  # load before the first task  # noqa: F401

    worker_loop(idle=IDLE_TIMEOUT)
