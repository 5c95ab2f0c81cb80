"""TASK -> ROW: solve each run in a separate process.

A run that crashes or exceeds its time limit ends only that process. Each thread has one such
process, on a single machine and on each worker of a cluster.
"""

import sys
import threading
from typing import Any

from sonify.runtime.signals import WorkerGoneError, call_worker, end_worker, start_worker
from sonify.sweeps.version import version
from sonify.sweeps.worker_loop import timed_row

MAX_ATTEMPTS = 2
"""Number of processes that a run may crash before its row reports an error."""
THREAD_LOCAL = threading.local()
RUNNING_PROCESSES: set["RowProcess"] = set()


class RowProcess:
    """Process that waits for tasks; `late` is True if a task exceeded its time limit."""

    def __init__(self):
        self.process = start_worker(sys.executable, "sonify.sweeps.worker_loop")
        self.late = False
        RUNNING_PROCESSES.add(self)
        self.version = self._answer(version)

    def row(self, task: dict, limit: float) -> dict[str, Any] | None:
        """Return the row of a task, or None if the process died or exceeded `limit` [s]."""
        clock = threading.Timer(limit, self._too_late)
        clock.start()
        try:
            return self._answer(timed_row, task)
        finally:
            clock.cancel()

    def _answer(self, function, *arguments):
        try:
            return call_worker(self.process, function, *arguments)
        except WorkerGoneError:
            return None

    def end(self):
        """Kill the process, even during a task."""
        RUNNING_PROCESSES.discard(self)
        end_worker(self.process)

    def _too_late(self):
        self.late = True
        self.process.kill()


class ProcessesEndedError(Exception):
    """The processes were ended during a run, or a process cannot be started."""


def solve_in_process(task: dict, limit: float) -> dict[str, Any]:
    """Solve a task in the process of this thread within `limit` [s], and return its row.

    If the process dies, a new one repeats the task once. If that also dies, or if the task exceeds
    the limit, the row contains the error.
    """
    for _ in range(MAX_ATTEMPTS):
        hand = process_of_thread()
        if (row := hand.row(task, limit)) is not None:
            return row
        THREAD_LOCAL.hand = None
        ended = hand not in RUNNING_PROCESSES
        hand.end()
        if ended:
            raise ProcessesEndedError("ended")
        if hand.late:
            return {
                "error": f"took longer than the limit of {limit:g} s",
                "seconds": limit,
                "version": hand.version,
            }
    if hand.version is None:
        raise ProcessesEndedError("python -m sonify.sweeps.worker_loop does not start")
    told = f"its process ended with status {hand.process.returncode}, {MAX_ATTEMPTS} times"
    return {"error": told, "seconds": None, "version": hand.version}


def process_of_thread() -> RowProcess:
    """Return the process of this thread; start one if none runs, e.g. after an idle timeout."""
    hand: RowProcess | None = getattr(THREAD_LOCAL, "hand", None)
    if hand and hand.process.poll() is not None:
        hand.end()
        hand = None
    if hand is None:
        hand = THREAD_LOCAL.hand = RowProcess()
    return hand


def end_all_processes():
    """End the processes of all threads."""
    for hand in tuple(RUNNING_PROCESSES):
        hand.end()
