"""A process beside this one, in which matplotlib loads and pictures are drawn while a sound is
rendered; and modes are solved while a motion is."""

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

from sonify.runtime.signals import GoneError, asked, ended, what_is_asked

MODULES = ("motion", "sound", "mode_shapes")
"""Of this package: they draw, and load slowly."""


def drawn(module: str, name: str, data: dict) -> bytes:
    """Return the PNG that function `name` of a module of this package draws of `data`, its
    arguments."""
    file = BytesIO()
    getattr(import_module(f"sonify.report.{module}"), name)(path=file, **data)
    return file.getvalue()


class Painter:
    """Draws in a process of its own, which ends when this one does; where that cannot be had, in
    this process."""

    def __init__(self):
        self._gathering, self._waiting = (
            ThreadPoolExecutor(1, name) for name in ("gathering", "painter")
        )
        self._process = self._waiting.submit(_started)
        self._loaded = False

    def draw(self, module: str, name: str, data: Callable[[], dict]) -> Future:
        """Return the future of `drawn`; the pictures come one after the other. A thread calls
        `data`, while the picture before is drawn."""
        gathered = self._gathering.submit(data)
        return self._waiting.submit(lambda: self._ask(drawn, module, name, gathered.result()))

    def call(self, function: Callable, *arguments, **options) -> Any:
        """Return what `function`, of a module, returns: called there once a picture has been drawn
        there, else here, where it need not wait until that process is ready."""
        if not self._loaded:
            return function(*arguments, **options)
        return self._waiting.submit(self._ask, function, *arguments, **options).result()

    def _ask(self, function, *arguments, **options):
        try:
            answer = asked(self._process.result(), function, *arguments, **options)
        except (OSError, GoneError):  # there is none, or it died
            return function(*arguments, **options)
        self._loaded = True
        return answer

    def close(self):
        """End the process."""
        with suppress(OSError):
            ended(self._process.result())
        self._process = Future()
        self._process.set_exception(BrokenPipeError("ended"))


def _started():
    code = f"import sys; sys.path[:] = {sys.path!r}; from sonify.report.render_worker import serve; serve()"
    return Popen([sys.executable, "-c", code], stdin=PIPE, stdout=PIPE, process_group=0)


@lru_cache(1)
def painter() -> Painter:
    """Return the one painter of this process, which loads what it needs as soon as it is first
    asked for."""
    one = Painter()
    atexit.register(one.close)
    return one


if sys.platform != "win32":
    os.register_at_fork(
        after_in_child=painter.cache_clear
    )  # two processes cannot share one painter


def serve():
    """Draw what is asked for until nobody asks any more."""
    if sys.platform != "win32":
        os.nice(5)  # what is solved goes first
    gc.disable()  # it would look through all of matplotlib some ten times a picture
    for module in MODULES:
        import_module(f"sonify.report.{module}")
    gc.freeze()  # and what is loaded now stays
    what_is_asked(gc.collect)
