"""A process that fits one recording after the other: tasks come pickled on its standard input, fits go out.

`apart.py` starts it.
"""

import os
import pickle
import signal
import sys

from sonify.fitting.result import fit_one
from sonify.hearing.recording import RecordingError


def main():
    """Answer every task with its fit, or with the line that says why there is none, until the input ends."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # on Windows, Ctrl-C reaches all processes of a terminal
    with os.fdopen(os.dup(1), "wb") as answers:
        os.dup2(2, 1)  # what a library prints is no answer
        while True:
            try:
                task = pickle.load(sys.stdin.buffer)
            except EOFError:
                return
            try:
                pickle.dump(fit_one(*task), answers)
            except RecordingError as error:
                pickle.dump(str(error), answers)
            answers.flush()


if __name__ == "__main__":
    main()
