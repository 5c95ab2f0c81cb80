"""TASK -> ROW in a process of its own, which a run that takes too long, or that crashes, takes with
it and no more.

The same on one machine and on every worker of a cluster: each thread has one such process.
"""

import sys
import threading
from typing import Any

from sonify.runtime.signals import GoneError, asked, ended, started
from sonify.sweeps.version import version
from sonify.sweeps.worker_loop import solved

TRIES = 2
"""Processes that a run may bring down before that is its result."""
OWN = threading.local()
HANDS: set["Hand"] = set()


class Hand:
    """A process that waits for tasks; `late` where it was ended because one took too long."""

    def __init__(self):
        self.process = started(sys.executable, "sonify.sweeps.worker_loop")
        self.late = False
        HANDS.add(self)
        self.version = self._answer(version)

    def row(self, task: dict, limit: float) -> dict[str, Any] | None:
        """Return the row of a task, None if the process has died of it."""
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
        """End the process, whatever it does."""
        HANDS.discard(self)
        ended(self.process)

    def _too_late(self):
        self.late = True
        self.process.kill()


class EndedError(Exception):
    """The processes were ended while one solved, or none can be started."""


def solve_apart(task: dict, limit: float) -> dict[str, Any]:
    """Return the row of a task, solved in the process of this thread within `limit` [s]; if that
    process dies, in a new one; if that dies too, or is late, the row says so."""
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
    """Return the living process of this thread; one that had nothing to do has ended itself."""
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
