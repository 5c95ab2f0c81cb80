"""TASK -> ROW: solve each run in a separate process.

A run that crashes or exceeds its time limit ends only that process. Each thread has one such
process, on a single machine and on each worker of a cluster.
"""

import threading
from collections.abc import Callable
from typing import Any

from sonify.runtime.workers import WorkerDiedError, WorkerProcess
from sonify.sweeps.version import version
from sonify.sweeps.worker_loop import solve_task

THREAD_PROCESS = threading.local()
"""`process` is the RowProcess of the current thread."""
LIVE_PROCESSES: set["RowProcess"] = set()
"""Processes of all threads; `end_all_processes` removes a process before killing it."""


class ProcessesEndedError(Exception):
    """The processes were ended during a run, or a process cannot be started."""


class RowProcess:
    """Worker process that solves runs; `timed_out` is True if a run exceeded its time limit."""

    def __init__(self):
        self.worker = WorkerProcess("sonify.sweeps.worker_loop")
        self.timed_out = False
        LIVE_PROCESSES.add(self)
        self.version = self._call(version)

    def solve(self, task: dict, limit: float) -> dict[str, Any] | None:
        """Return the row of a task, or None if the process died or exceeded `limit` [s]."""
        timer = threading.Timer(limit, self._time_out)
        timer.start()
        try:
            return self._call(solve_task, task)
        finally:
            timer.cancel()

    def kill(self):
        """Kill the process, even during a task."""
        LIVE_PROCESSES.discard(self)
        self.worker.kill()

    def _call(self, function: Callable, *arguments: Any) -> Any:
        try:
            return self.worker.call(function, *arguments)
        except WorkerDiedError:
            return None

    def _time_out(self):
        self.timed_out = True
        self.worker.process.kill()


def solve_isolated(task: dict, limit: float) -> dict[str, Any]:
    """Solve a task in the process of this thread within `limit` [s], and return its row.

    If the process dies, a new one repeats the task once. If that also dies, or if the task exceeds
    the limit, the row contains the error.
    """
    max_attempts = 2
    for _ in range(max_attempts):
        process = _process_of_thread()
        if (row := process.solve(task, limit)) is not None:
            return row
        THREAD_PROCESS.process = None
        killed_by_sweep = process not in LIVE_PROCESSES
        process.kill()
        if killed_by_sweep:
            raise ProcessesEndedError("ended")
        if process.timed_out:
            error = f"took longer than the limit of {limit:g} s"
            return {"error": error, "seconds": limit, "version": process.version}
    if process.version is None:
        raise ProcessesEndedError("python -m sonify.sweeps.worker_loop does not start")
    status = process.worker.process.returncode
    error = f"its process ended with status {status}, {max_attempts} times"
    return {"error": error, "seconds": None, "version": process.version}


def _process_of_thread() -> RowProcess:
    """Return the process of this thread; start one if none runs, e.g. after an idle timeout."""
    process: RowProcess | None = getattr(THREAD_PROCESS, "process", None)
    if process and process.worker.process.poll() is not None:
        process.kill()
        process = None
    if process is None:
        process = THREAD_PROCESS.process = RowProcess()
    return process


def end_all_processes():
    """Kill the processes of all threads."""
    for process in tuple(LIVE_PROCESSES):
        process.kill()
