"""TASK -> ROW: solve each run in a separate process.

A run that crashes or exceeds its time limit ends only that process. Each thread has one such
process, on a single machine and on each worker of a cluster.
"""

import sys
import threading
from typing import Any

from sonify.runtime.signals import GoneError, asked, ended, started
from sonify.sweeps.version import version
from sonify.sweeps.worker_loop import solved

TRIES = 2
"""Number of processes that a run may crash before its row reports an error."""
OWN = threading.local()
HANDS: set["Hand"] = set()


class Hand:
    """Process that waits for tasks; `late` is True if a task exceeded its time limit."""

    def __init__(self):
        self.process = started(sys.executable, "sonify.sweeps.worker_loop")
        self.late = False
        HANDS.add(self)
        self.version = self._answer(version)

    def row(self, task: dict, limit: float) -> dict[str, Any] | None:
        """Return the row of a task, or None if the process died or exceeded `limit` [s]."""
        clock = threading.Timer(limit, self._too_late)
        clock.start()
        try:
            return self._answer(solved, task)
        finally:
            clock.cancel()

    def _answer(self, function, *arguments):
        try:
            return asked(self.process, function, *arguments)
        except GoneError:
            return None

    def end(self):
        """Kill the process, even during a task."""
        HANDS.discard(self)
        ended(self.process)

    def _too_late(self):
        self.late = True
        self.process.kill()


class EndedError(Exception):
    """The processes were ended during a run, or a process cannot be started."""


def solve_apart(task: dict, limit: float) -> dict[str, Any]:
    """Solve a task in the process of this thread within `limit` [s], and return its row.

    If the process dies, a new one repeats the task once. If that also dies, or if the task exceeds
    the limit, the row contains the error.
    """
    for _ in range(TRIES):
        hand = own_hand()
        if (row := hand.row(task, limit)) is not None:
            return row
        OWN.hand = None
        ended = hand not in HANDS
        hand.end()
        if ended:
            raise EndedError("ended")
        if hand.late:
            return {
                "error": f"took longer than the limit of {limit:g} s",
                "seconds": limit,
                "version": hand.version,
            }
    if hand.version is None:
        raise EndedError("python -m sonify.sweeps.worker_loop does not start")
    told = f"its process ended with status {hand.process.returncode}, {TRIES} times"
    return {"error": told, "seconds": None, "version": hand.version}


def own_hand() -> Hand:
    """Return the process of this thread; start one if none runs, e.g. after an idle timeout."""
    hand: Hand | None = getattr(OWN, "hand", None)
    if hand and hand.process.poll() is not None:
        hand.end()
        hand = None
    if hand is None:
        hand = OWN.hand = Hand()
    return hand


def end_all():
    """End the processes of all threads."""
    for hand in tuple(HANDS):
        hand.end()
