"""Worker processes that serve pickled calls and exit with their parent process."""

import atexit
import os
import pickle
import signal
import subprocess
import sys
import threading
from collections.abc import Callable
from concurrent.futures import Future, ThreadPoolExecutor
from contextlib import suppress
from functools import lru_cache, wraps
from queue import Empty, SimpleQueue
from typing import Any, TypeVar

from sonify.runtime.library_messages import hide_library_messages


def core_count() -> int:
    """Return the number of CPU cores available to this process."""
    if sys.platform == "linux":
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1


class WorkerDiedError(Exception):
    """Raised if a called worker process is dead."""


class WorkerProcess:
    """Process that runs a module of this program; the module must call `serve_calls`.

    The process has the import path of its parent but does not import the script of the
    user, which therefore needs no main guard. With `single_threaded`, its libraries use
    one thread, because other workers occupy the remaining cores."""

    def __init__(self, module: str = __name__, single_threaded: bool = True) -> None:
        environment = os.environ | {
            "PYTHONPATH": os.pathsep.join(folder or os.getcwd() for folder in sys.path)
        }
        if single_threaded:
            for library in ("OPENBLAS", "OMP", "MKL", "NUMBA", "VECLIB_MAXIMUM"):
                environment[f"{library}_NUM_THREADS"] = "1"
        self.process = subprocess.Popen(
            [sys.executable, "-P", "-m", module],
            env=environment,
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            start_new_session=True,  # Ctrl-C reaches only the parent
        )

    def call(
        self, function: Callable[..., Any], *arguments: Any, **options: Any
    ) -> Any:
        """Call a module-level `function` in the worker and return its result.

        Exceptions raised by the function are raised again. Raises WorkerDiedError if
        the worker is dead."""
        assert self.process.stdin
        assert self.process.stdout
        try:
            pickle.dump((function, arguments, options), self.process.stdin)
            self.process.stdin.flush()
            result, error = pickle.load(self.process.stdout)
        except (OSError, EOFError, ValueError, pickle.UnpicklingError) as failure:
            # ValueError: the pipes are closed
            raise WorkerDiedError(str(failure) or "no answer") from None
        if error:
            raise error
        return result

    def kill(self) -> None:
        """Kill the worker, wait for its exit, and close its pipes."""
        with suppress(OSError), self.process:
            self.process.kill()


class BackgroundWorker:
    """Worker process whose calls are made one after another in a background thread.

    Calls run in this process if the worker cannot be started or has died. The arguments
    are those of `WorkerProcess`."""

    def __init__(self, module: str, single_threaded: bool = True) -> None:
        self._waiting = ThreadPoolExecutor(1, module)
        self._worker = self._waiting.submit(WorkerProcess, module, single_threaded)

    def call_worker_or_run_here(
        self, function: Callable[..., Any], *arguments: Any, **options: Any
    ) -> Any:
        """Return the result of a module-level `function`."""
        try:
            return self._worker.result().call(function, *arguments, **options)
        except (OSError, WorkerDiedError):  # the worker was not started or has died
            return function(*arguments, **options)

    def close(self) -> None:
        """End the worker process."""
        with suppress(OSError):
            self._worker.result().kill()
        self._worker = Future()
        self._worker.set_exception(BrokenPipeError("ended"))


Worker = TypeVar("Worker", bound=BackgroundWorker)


def one_per_process(make: Callable[[], Worker]) -> Any:
    """Decorate a function without arguments that makes a `BackgroundWorker`.

    Every call in a process returns the same worker, which ends with the process. A
    forked process makes its own."""

    @lru_cache(1)
    @wraps(make)
    def one() -> Worker:
        worker = make()
        atexit.register(worker.close)
        return worker

    if sys.platform != "win32":
        os.register_at_fork(after_in_child=one.cache_clear)
    return one


def serve_calls(idle_timeout: float | None = None) -> None:
    """Serve calls until the parent exits or no call arrives for `idle_timeout` [s]."""
    hide_library_messages()
    # Windows sends Ctrl-C to all processes of a terminal.
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    output = os.fdopen(os.dup(1), "wb")
    os.dup2(2, 1)  # keep the output of libraries out of the results
    calls: SimpleQueue[Any] = SimpleQueue[Any]()
    threading.Thread(target=_receive_calls, args=(calls,), daemon=True).start()
    with suppress(Empty, BrokenPipeError):
        while True:
            function, arguments, options = calls.get(timeout=idle_timeout)
            try:
                answer: tuple[Any, Exception | None] = (
                    function(*arguments, **options),
                    None,
                )
            except Exception as error:
                answer = (None, error)
            pickle.dump(answer, output)
            output.flush()
    os._exit(0)  # exit without a message about the broken pipe


def _receive_calls(calls: SimpleQueue[Any]) -> None:
    try:
        while True:
            calls.put(pickle.load(sys.stdin.buffer))
    finally:  # input ended or invalid; the exit of this process informs the parent
        os._exit(0)


if __name__ == "__main__":
    serve_calls()
