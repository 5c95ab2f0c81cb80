"""Worker process of `row_processes`, which solves scenes one by one and exits when
idle."""

import json
from time import perf_counter
from typing import Any

from sonify.runtime.workers import serve_calls
from sonify.sweeps.version import version


def solve_task(task: dict[str, Any]) -> dict[str, Any]:
    """Return the row of a task as plain values, with the run time [s] and the
    version."""
    # slow to import and not needed by the parent
    from sonify.runtime.json_values import plain_value
    from sonify.sweeps.run_row import row_of

    began = perf_counter()
    try:
        row = row_of(**task)
    except OSError as error:
        row = {
            "stop": [error.errno, error.strerror, str(error.filename or task["folder"])]
        }
    complete = row | {"seconds": perf_counter() - began, "version": version()}
    return json.loads(json.dumps(complete, default=plain_value))


if __name__ == "__main__":
    import sonify.sweeps.run_row  # load before the first task  # noqa: F401

    serve_calls(idle_timeout=60.0)  # s; an idle process exits and frees its memory
