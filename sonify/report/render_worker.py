"""Draw pictures in a worker process while the main process renders a sound.

The worker also imports matplotlib and solves modes while the main process solves a
motion.
"""

import atexit
import gc
import os
import sys
from collections.abc import Callable
from concurrent.futures import Future, ThreadPoolExecutor
from contextlib import suppress
from functools import lru_cache
from importlib import import_module
from io import BytesIO
from typing import Any

from sonify.runtime.workers import WorkerDiedError, WorkerProcess, serve_calls


def draw_png(module: str, name: str, data: dict) -> bytes:
    """Return the PNG drawn from `data` by the function `name` of a module of this
    package."""
    file = BytesIO()
    getattr(import_module(f"sonify.report.{module}"), name)(path=file, **data)
    return file.getvalue()


class Painter:
    """Draws pictures in a worker process, or in this process if no worker can be
    started.

    The worker exits with this process.
    """

    def __init__(self):
        self._gathering = ThreadPoolExecutor(1, "gathering")
        self._waiting = ThreadPoolExecutor(1, "painter")
        self._worker = self._waiting.submit(
            WorkerProcess, __name__, single_threaded=False
        )
        self._loaded = False

    def draw(self, module: str, name: str, data: Callable[[], dict]) -> Future:
        """Return the Future of `draw_png`; pictures are drawn one after another.

        A thread calls `data` while the worker draws the previous picture.
        """
        gathered = self._gathering.submit(data)
        return self._waiting.submit(
            lambda: self._call_worker_or_run_here(
                draw_png, module, name, gathered.result()
            )
        )

    def call(self, function: Callable, *arguments, **options) -> Any:
        """Return the result of a module-level `function`.

        The function runs in the worker if the worker has completed a task before, and
        otherwise in this process.
        """
        if not self._loaded:
            return function(*arguments, **options)
        return self._waiting.submit(
            self._call_worker_or_run_here, function, *arguments, **options
        ).result()

    def _call_worker_or_run_here(self, function, *arguments, **options):
        try:
            answer = self._worker.result().call(function, *arguments, **options)
        except (OSError, WorkerDiedError):  # the worker was not started or has died
            return function(*arguments, **options)
        self._loaded = True
        return answer

    def close(self):
        """End the worker process."""
        with suppress(OSError):
            self._worker.result().kill()
        self._worker = Future()
        self._worker.set_exception(BrokenPipeError("ended"))


@lru_cache(1)
def painter() -> Painter:
    """Return the single painter of this process; the first call starts its worker."""
    one = Painter()
    atexit.register(one.close)
    return one


if sys.platform != "win32":
    os.register_at_fork(
        after_in_child=painter.cache_clear
    )  # processes cannot share a painter


def serve():
    """Worker loop: serve drawing requests until the parent process exits."""
    if sys.platform != "win32":
        os.nice(5)  # solvers have priority
    gc.disable()  # it would scan all of matplotlib about ten times per picture
    for module in ("motion", "sound", "mode_shapes"):
        import_module(f"sonify.report.{module}")
    gc.freeze()  # later collections ignore the loaded modules
    serve_calls(gc.collect)


if __name__ == "__main__":
    serve()
