"""Worker process of `row_processes`, which solves scenes one by one and exits when
idle."""

import json
from importlib import import_module
from time import perf_counter
from typing import Any

from sonify.runtime.workers import serve_calls
from sonify.sweeps.version import version

ROW_SOLVER = "sonify.sweeps.run_row:row_of"
"""Function that solves a task, unless it names another one."""


def solve_task(task: dict[str, Any]) -> dict[str, Any]:
    """Return the row of a task as plain values, with the run time [s] and the
    version.

    The task consists of the arguments of `run_row.row_of`, or of another function if it
    names one as `solver`, such as "sonify.ladder.row:rung_row"."""
    # slow to import and not needed by the parent
    from sonify.runtime.json_values import plain_value

    arguments = dict(task)
    module, _, name = arguments.pop("solver", ROW_SOLVER).partition(":")
    row_of = getattr(import_module(module), name)
    began = perf_counter()
    try:
        row = row_of(**arguments)
    except OSError as error:
        place = str(error.filename or task.get("folder", ""))
        row = {"stop": [error.errno, error.strerror, place]}
    complete = row | {"seconds": perf_counter() - began, "version": version()}
    return json.loads(json.dumps(complete, default=plain_value))


if __name__ == "__main__":
    import sonify.sweeps.run_row  # load before the first task  # noqa: F401

    serve_calls(idle_timeout=60.0)  # s; an idle process exits and frees its memory
