"""Termination signals and closed output streams."""

import errno
import os
import signal
import sys
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager, redirect_stderr, redirect_stdout
from stat import S_ISREG
from types import FrameType
from typing import Any, TextIO, TypeVar

R = TypeVar("R")

TERMINATION_SIGNALS = [signal.SIGINT, signal.SIGTERM]
"""Signals that end a command: Ctrl-C, the end of a batch job and, except on Windows, a
closed terminal."""
if sys.platform != "win32":
    TERMINATION_SIGNALS.append(signal.SIGHUP)
NO_READER_ERRORS = {errno.EPIPE, errno.EIO, errno.EINVAL}
"""Error codes for output to a closed pipe or terminal."""


class AbortedError(RuntimeError):
    """Raised with a one-line message if a command with valid input cannot continue."""


@contextmanager
def orderly_exit() -> Iterator[None]:
    """Convert termination signals to KeyboardInterrupt(number) and ignore closed output
    streams."""
    with (
        installed_signal_handlers(),
        redirect_stdout(AbandonableStream(sys.stdout)),
        redirect_stderr(AbandonableStream(sys.stderr)),
    ):
        yield


@contextmanager
def installed_signal_handlers() -> Iterator[None]:
    """Install the signal handlers, in the main thread only.

    Signals that are already ignored, e.g. under nohup, remain ignored.
    """

    def end(number: int, frame: FrameType | None) -> None:
        if not _is_importing(frame):
            raise KeyboardInterrupt(number)
        repeat_interval = 0.05  # s; repeat the signal until the import has finished
        threading.Timer(
            repeat_interval, send_signal, [threading.get_ident(), number]
        ).start()

    main = threading.current_thread() is threading.main_thread()
    before = {
        number: signal.signal(number, end)
        for number in TERMINATION_SIGNALS
        if main and signal.getsignal(number) is not signal.SIG_IGN
    }
    try:
        yield
    finally:
        for number, answer in before.items():
            signal.signal(number, answer)


def send_signal(thread: int, number: int) -> None:
    """Send a signal to a thread and wake it; on Windows, raise it in the current
    thread."""
    if sys.platform != "win32":
        signal.pthread_kill(thread, number)
    else:
        signal.raise_signal(number)


def _is_importing(frame: FrameType | None) -> bool:
    """Return True if a module is being imported.

    Some modules would mistake the interrupt for a missing dependency.
    """
    while frame and not frame.f_code.co_filename.startswith("<frozen importlib"):
        frame = frame.f_back
    return frame is not None


class AbandonableStream:
    """Text stream that discards its output after the reader closes it, so that the run
    continues."""

    def __init__(self, stream: TextIO) -> None:
        self._stream = stream

    def __getattr__(self, name: str) -> Any:
        return getattr(self._stream, name)

    def write(self, text: str) -> int:
        """Write to the stream."""
        return self._ignore_closed_pipe(self._stream.write, text)

    def flush(self) -> None:
        """Flush the stream."""
        self._ignore_closed_pipe(self._stream.flush)

    def _ignore_closed_pipe(self, function: Callable[..., R], *arguments: Any) -> R:
        try:
            return function(*arguments)
        except OSError as error:
            if error.errno not in NO_READER_ERRORS or S_ISREG(
                os.fstat(self.fileno()).st_mode
            ):
                raise
            os.dup2(os.open(os.devnull, os.O_WRONLY), self.fileno())
            return function(*arguments)
