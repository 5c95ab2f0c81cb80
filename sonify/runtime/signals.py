"""How a command meets the system around it: the signals that end it, and readers who leave before
it is done."""

import errno
import os
import pickle
import signal
import subprocess
import sys
import threading
from contextlib import contextmanager, redirect_stderr, redirect_stdout, suppress
from pathlib import Path
from queue import Empty, SimpleQueue
from stat import S_ISREG

ENDS = [signal.SIGINT, signal.SIGTERM]
"""Signals that end a command: Ctrl-C, the end of a batch job, and, except on Windows, the end of
the terminal."""
if sys.platform != "win32":
    ENDS.append(signal.SIGHUP)
AGAIN = 0.05
"""So long [s] a signal waits, and again, for the end of an import."""
LEFT = {errno.EPIPE, errno.EIO, errno.EINVAL}
"""What a stream answers whose reader has left: a closed pipe, a closed terminal, a closed pipe of
Windows."""


ONE_THREAD = ("OPENBLAS", "OMP", "MKL", "NUMBA", "VECLIB_MAXIMUM")
"""Whose threads a process has one of: the cores are taken by other runs."""


class BrokenOffError(RuntimeError):
    """A command cannot go on, though nothing was wrong with what it was given; the message is one
    line."""


class GoneError(Exception):
    """The process that was asked is dead."""


@contextmanager
def well_behaved():
    """Within, every signal that ends is a KeyboardInterrupt that holds its number, and unread
    streams are no error."""
    with _signals(), redirect_stdout(Unread(sys.stdout)), redirect_stderr(Unread(sys.stderr)):
        yield


@contextmanager
def _signals():
    """Only the main thread may set what answers a signal; one that is ignored, as under nohup,
    stays so."""

    def end(number, frame):
        if not _imports(frame):
            raise KeyboardInterrupt(number)
        threading.Timer(AGAIN, _send, [threading.get_ident(), number]).start()

    main = threading.current_thread() is threading.main_thread()
    heeded = [number for number in ENDS if main and signal.getsignal(number) is not signal.SIG_IGN]
    before = {number: signal.signal(number, end) for number in heeded}
    try:
        yield
    finally:
        for number, answer in before.items():
            signal.signal(number, answer)


def _send(thread, number):
    """Send a signal to a thread, even a sleeping one; Windows can only raise it in this thread."""
    if sys.platform != "win32":
        signal.pthread_kill(thread, number)
    else:
        signal.raise_signal(number)


def _imports(frame):
    """Whether a module is just being imported: some would take the interrupt for a dependency that
    is missing."""
    while frame and not frame.f_code.co_filename.startswith("<frozen importlib"):
        frame = frame.f_back
    return frame is not None


class Unread:
    """A text stream that goes on into nothing once its reader has left, for the files are wanted
    all the same."""

    def __init__(self, stream):
        self._stream = stream

    def __getattr__(self, name):
        return getattr(self._stream, name)

    def write(self, text: str) -> int:
        """Write as the stream does."""
        return self._unheard(self._stream.write, text)

    def flush(self):
        """Flush as the stream does."""
        self._unheard(self._stream.flush)

    def _unheard(self, act, *what):
        try:
            return act(*what)
        except OSError as error:
            if error.errno not in LEFT or S_ISREG(os.fstat(self.fileno()).st_mode):
                raise
            os.dup2(os.open(os.devnull, os.O_WRONLY), self.fileno())
            return act(*what)


def started(python: str, module: str, **how) -> subprocess.Popen:
    """Return a process of one thread that runs a module of this program, with pipes to its input
    and from its output; no script of the user's is run again in it."""
    home = str(Path(__file__).parent.parent)
    environment = os.environ | {f"{name}_NUM_THREADS": "1" for name in ONE_THREAD}
    environment["PYTHONPATH"] = os.pathsep.join(filter(None, [home, os.environ.get("PYTHONPATH")]))
    return subprocess.Popen(
        [python, "-m", module],
        env=environment,
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        start_new_session=True,  # Ctrl-C of a terminal is for the driver
        **how,
    )


def asked(process, function, *arguments, **options):
    """Return what `function`, of a module, returns in a process that does `what_is_asked`. Raises
    what it raises there, and GoneError where that process is dead."""
    try:
        pickle.dump((function, arguments, options), process.stdin)
        process.stdin.flush()
        answer, fault = pickle.load(process.stdout)
    except (
        OSError,
        EOFError,
        ValueError,
        pickle.UnpicklingError,
    ) as error:  # ValueError: its pipes are closed
        raise GoneError(str(error) or "no answer") from None
    if fault:
        raise fault
    return answer


def what_is_asked(rest=lambda: None, idle: float | None = None):
    """Do what is `asked` of this process, with a `rest` after each answer, until whoever asked is
    gone, by whatever way, or asks nothing for a time of `idle` [s]."""
    signal.signal(
        signal.SIGINT, signal.SIG_IGN
    )  # on Windows, Ctrl-C reaches all processes of a terminal
    answers = os.fdopen(os.dup(1), "wb")
    os.dup2(2, 1)  # what a library prints is no answer
    tasks: SimpleQueue = SimpleQueue()
    threading.Thread(target=_listen, args=(tasks,), daemon=True).start()
    with suppress(Empty, BrokenPipeError):
        while True:
            function, arguments, options = tasks.get(timeout=idle)
            try:
                answer = function(*arguments, **options)
                fault = None
            except Exception as error:
                answer = None
                fault = error
            pickle.dump((answer, fault), answers)
            answers.flush()
            rest()
    os._exit(0)  # without a word on the broken pipe


def _listen(tasks):
    try:
        while True:
            tasks.put(pickle.load(sys.stdin.buffer))
    finally:  # the input has ended, or is none: whoever asked knows by the end of this process
        os._exit(0)


def ended(process: subprocess.Popen):
    """Kill a process, wait until it is gone, and close the pipes to it."""
    with suppress(OSError), process:
        process.kill()


if __name__ == "__main__":
    what_is_asked()
