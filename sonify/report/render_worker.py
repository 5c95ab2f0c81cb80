"""Worker process that draws pictures while this process renders a sound.

It also loads matplotlib, and it solves modes while this process solves a motion.
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
from subprocess import PIPE, Popen
from typing import Any

from sonify.runtime.signals import WorkerGoneError, call_worker, end_worker, worker_loop

MODULES = ("motion", "sound", "mode_shapes")
"""Drawing modules of this package, which the worker imports in advance."""


def drawn(module: str, name: str, data: dict) -> bytes:
    """Return the PNG that a function `name` of a module of this package draws from `data`."""
    file = BytesIO()
    getattr(import_module(f"sonify.report.{module}"), name)(path=file, **data)
    return file.getvalue()


class Painter:
    """Draws in a worker process, or in this process if no worker can be started.

    The worker ends with this process.
    """

    def __init__(self):
        self._gathering, self._waiting = (
            ThreadPoolExecutor(1, name) for name in ("gathering", "painter")
        )
        self._process = self._waiting.submit(_started)
        self._loaded = False

    def draw(self, module: str, name: str, data: Callable[[], dict]) -> Future:
        """Return the Future of `drawn`; pictures are drawn one after the other.

        A thread calls `data` while the worker draws the previous picture.
        """
        gathered = self._gathering.submit(data)
        return self._waiting.submit(lambda: self._ask(drawn, module, name, gathered.result()))

    def call(self, function: Callable, *arguments, **options) -> Any:
        """Return the result of a module-level `function`.

        It runs in the worker once that has completed a first task, and otherwise in this process.
        """
        if not self._loaded:
            return function(*arguments, **options)
        return self._waiting.submit(self._ask, function, *arguments, **options).result()

    def _ask(self, function, *arguments, **options):
        try:
            answer = call_worker(self._process.result(), function, *arguments, **options)
        except (OSError, WorkerGoneError):  # it was not started, or it died
            return function(*arguments, **options)
        self._loaded = True
        return answer

    def close(self):
        """End the worker process."""
        with suppress(OSError):
            end_worker(self._process.result())
        self._process = Future()
        self._process.set_exception(BrokenPipeError("ended"))


def _started():
    code = f"import sys; sys.path[:] = {sys.path!r}; from sonify.report.render_worker import serve; serve()"
    return Popen([sys.executable, "-c", code], stdin=PIPE, stdout=PIPE, process_group=0)


@lru_cache(1)
def painter() -> Painter:
    """Return the only painter of this process; the first call starts its worker."""
    one = Painter()
    atexit.register(one.close)
    return one


if sys.platform != "win32":
    os.register_at_fork(
        after_in_child=painter.cache_clear
    )  # two processes cannot share one painter


def serve():
    """Worker loop: serve drawing requests until the parent process exits."""
    if sys.platform != "win32":
        os.nice(5)  # solvers have priority
    gc.disable()  # it would scan all of matplotlib about ten times per picture
    for module in MODULES:
        import_module(f"sonify.report.{module}")
    gc.freeze()  # later collections ignore the loaded modules
    worker_loop(gc.collect)
