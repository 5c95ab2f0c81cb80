"""Solution of each run in a separate process.

A run that crashes or exceeds its time limit ends only its process. Each thread has one
such process, both locally and on the workers of a cluster."""

import threading
from collections.abc import Callable
from typing import Any

from sonify.runtime.workers import WorkerDiedError, WorkerProcess
from sonify.sweeps.version import version
from sonify.sweeps.worker_loop import solve_task

THREAD_PROCESS = threading.local()
"""Storage for the RowProcess of each thread, in its attribute `process`."""
LIVE_PROCESSES: set["RowProcess"] = set()
"""Processes of all threads; a process is removed before it is killed."""


class ProcessesEndedError(Exception):
    """Raised if the processes were killed during a run or cannot be started."""


class RowProcess:
    """Worker process that solves runs; `timed_out` is True if a run exceeded its time
    limit."""

    def __init__(self) -> None:
        self.worker = WorkerProcess("sonify.sweeps.worker_loop")
        self.timed_out = False
        LIVE_PROCESSES.add(self)
        self.version = self._call(version)

    def solve(self, task: dict[str, Any], limit: float) -> dict[str, Any] | None:
        """Return the row of a task, or None if the process died or exceeded `limit`
        [s]."""
        timer = threading.Timer(limit, self._time_out)
        timer.start()
        try:
            return self._call(solve_task, task)
        finally:
            timer.cancel()

    def kill(self) -> None:
        """Kill the process, possibly during a task."""
        LIVE_PROCESSES.discard(self)
        self.worker.kill()

    def _call(self, function: Callable[..., Any], *arguments: Any) -> Any:
        try:
            return self.worker.call(function, *arguments)
        except WorkerDiedError:
            return None

    def _time_out(self) -> None:
        self.timed_out = True
        self.worker.process.kill()


def solve_isolated(task: dict[str, Any], limit: float) -> dict[str, Any]:
    """Solve a task in the worker process of the calling thread, and return its row.

    The task may take `limit` [s].

    If the process dies, the task is repeated once in a new process. If it dies again or
    the task exceeds the limit, the row contains the error."""
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
        raise ProcessesEndedError("python -m sonify.sweeps.worker_loop failed to start")
    status = process.worker.process.returncode
    error = f"the process ended with status {status} in {max_attempts} attempts"
    return {"error": error, "seconds": None, "version": process.version}


def _process_of_thread() -> RowProcess:
    """Return the running process of this thread, or start one."""
    process: RowProcess | None = getattr(THREAD_PROCESS, "process", None)
    if process and process.worker.process.poll() is not None:
        process.kill()
        process = None
    if process is None:
        process = THREAD_PROCESS.process = RowProcess()
    return process


def end_all_processes() -> None:
    """Kill the processes of all threads."""
    for process in tuple(LIVE_PROCESSES):
        process.kill()
