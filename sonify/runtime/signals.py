"""Termination signals, closed output streams and worker processes."""

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

ENDING_SIGNALS = [signal.SIGINT, signal.SIGTERM]
"""Signals that end a command: Ctrl-C, end of a batch job, and (not on Windows) closed terminal."""
if sys.platform != "win32":
    ENDING_SIGNALS.append(signal.SIGHUP)
RETRY_INTERVAL = 0.05
"""Interval at which a signal is repeated until an import has finished [s]."""
READER_GONE_ERRORS = {errno.EPIPE, errno.EIO, errno.EINVAL}
"""Error codes of a stream without a reader: closed pipe, closed terminal, closed Windows pipe."""


THREAD_VARIABLES = ("OPENBLAS", "OMP", "MKL", "NUMBA", "VECLIB_MAXIMUM")
"""Libraries limited to one thread per process, because other runs occupy the remaining cores."""


class AbortedError(RuntimeError):
    """A command cannot continue although its input is valid; the message is one line."""


class WorkerGoneError(Exception):
    """The called worker process is dead."""


@contextmanager
def orderly_exit():
    """Turn termination signals into KeyboardInterrupt(number) and ignore closed output streams."""
    with (
        _signals(),
        redirect_stdout(ReaderlessStream(sys.stdout)),
        redirect_stderr(ReaderlessStream(sys.stderr)),
    ):
        yield


@contextmanager
def _signals():
    """Install the signal handlers, in the main thread only.

    Signals that are already ignored, e.g. under nohup, remain ignored.
    """

    def end(number, frame):
        if not _imports(frame):
            raise KeyboardInterrupt(number)
        threading.Timer(RETRY_INTERVAL, _send, [threading.get_ident(), number]).start()

    main = threading.current_thread() is threading.main_thread()
    heeded = [
        number
        for number in ENDING_SIGNALS
        if main and signal.getsignal(number) is not signal.SIG_IGN
    ]
    before = {number: signal.signal(number, end) for number in heeded}
    try:
        yield
    finally:
        for number, answer in before.items():
            signal.signal(number, answer)


def _send(thread, number):
    """Send a signal to a thread and wake it; Windows can only raise it in the current thread."""
    if sys.platform != "win32":
        signal.pthread_kill(thread, number)
    else:
        signal.raise_signal(number)


def _imports(frame):
    """Return True if a module is being imported.

    Some modules would mistake the interrupt for a missing dependency.
    """
    while frame and not frame.f_code.co_filename.startswith("<frozen importlib"):
        frame = frame.f_back
    return frame is not None


class ReaderlessStream:
    """Text stream that discards its output once the reader has left, so that the run continues."""

    def __init__(self, stream):
        self._stream = stream

    def __getattr__(self, name):
        return getattr(self._stream, name)

    def write(self, text: str) -> int:
        """Write to the stream."""
        return self._unheard(self._stream.write, text)

    def flush(self):
        """Flush the stream."""
        self._unheard(self._stream.flush)

    def _unheard(self, act, *what):
        try:
            return act(*what)
        except OSError as error:
            if error.errno not in READER_GONE_ERRORS or S_ISREG(os.fstat(self.fileno()).st_mode):
                raise
            os.dup2(os.open(os.devnull, os.O_WRONLY), self.fileno())
            return act(*what)


def start_worker(python: str, module: str, **how) -> subprocess.Popen:
    """Start a worker process with single-threaded libraries, and pipes to its input and output.

    The process runs a module of this program; it does not import the script of the user.
    """
    home = str(Path(__file__).parent.parent)
    environment = os.environ | {f"{name}_NUM_THREADS": "1" for name in THREAD_VARIABLES}
    environment["PYTHONPATH"] = os.pathsep.join(filter(None, [home, os.environ.get("PYTHONPATH")]))
    return subprocess.Popen(
        [python, "-m", module],
        env=environment,
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        start_new_session=True,  # Ctrl-C reaches only the parent
        **how,
    )


def call_worker(process, function, *arguments, **options):
    """Call a module-level `function` in a worker process, and return its result.

    The process runs `worker_loop`. Exceptions of the function are raised here. Raises GoneError
    if the process is dead.
    """
    try:
        pickle.dump((function, arguments, options), process.stdin)
        process.stdin.flush()
        answer, fault = pickle.load(process.stdout)
    except (
        OSError,
        EOFError,
        ValueError,
        pickle.UnpicklingError,
    ) as error:  # ValueError: the pipes are closed
        raise WorkerGoneError(str(error) or "no answer") from None
    if fault:
        raise fault
    return answer


def worker_loop(rest=lambda: None, idle: float | None = None):
    """Worker loop: serve pickled calls until the parent exits, or no call arrives for `idle` [s].

    `rest` is called after each answer.
    """
    signal.signal(
        signal.SIGINT, signal.SIG_IGN
    )  # Windows sends Ctrl-C to all processes of a terminal
    answers = os.fdopen(os.dup(1), "wb")
    os.dup2(2, 1)  # keep the output of libraries out of the answers
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
    os._exit(0)  # exit without a message about the broken pipe


def _listen(tasks):
    try:
        while True:
            tasks.put(pickle.load(sys.stdin.buffer))
    finally:  # input ended or invalid; the exit of this process informs the parent
        os._exit(0)


def end_worker(process: subprocess.Popen):
    """Kill a process, wait for its exit, and close its pipes."""
    with suppress(OSError), process:
        process.kill()


if __name__ == "__main__":
    worker_loop()
