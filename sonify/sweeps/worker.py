"""A process that solves one scene after the other: tasks come as JSON on its standard input, rows go out on its output.

`hand.py` starts it. It ends when its input does, which is when whoever started it has died, by whatever way, and when
there is nothing to do.
"""

import json
import os
import signal
import sys
import threading
from queue import Empty, SimpleQueue
from time import perf_counter

from sonify.sweeps.version import version

IDLE = 60.0
"""Time without a task [s] after which the process gives its memory back."""


def main():
    """Say which version this is, then answer every task, until there is no one left to answer."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # on Windows, Ctrl-C reaches all processes of a terminal
    with os.fdopen(os.dup(1), "w", encoding="utf-8") as answers:
        os.dup2(2, 1)  # what a library prints is no answer
        tasks: SimpleQueue = SimpleQueue()
        threading.Thread(target=_listen, args=(tasks,), daemon=True).start()
        from sonify.sweeps.work import row_of

        _say(answers, {"version": version()})
        while True:
            try:
                task = tasks.get(timeout=IDLE)
            except Empty:
                return
            began = perf_counter()
            try:
                row = row_of(**task)
            except OSError as error:
                row = {"stop": [error.errno, error.strerror, str(error.filename or task["folder"])]}
            _say(answers, row | {"seconds": perf_counter() - began, "version": version()})


def _listen(tasks):
    for line in sys.stdin:
        tasks.put(json.loads(line))
    os._exit(0)


def _say(answers, row):
    answers.write(json.dumps(row) + "\n")
    answers.flush()


if __name__ == "__main__":
    main()
