"""Draw pictures in a worker process while the main process renders a sound.

The worker imports NumPy and matplotlib alone, the latter instead of the main process.
"""

import gc
import os
import sys
from collections.abc import Callable
from concurrent.futures import Future, ThreadPoolExecutor
from importlib import import_module
from io import BytesIO
from typing import Any

from sonify.runtime.library_messages import hide_library_messages
from sonify.runtime.workers import BackgroundWorker, one_per_process, serve_calls


def draw_png(module: str, name: str, data: dict[str, Any]) -> bytes:
    """Return the PNG drawn from `data` by the function `name` of a module of this
    package."""
    file = BytesIO()
    getattr(import_module(f"sonify.report.{module}"), name)(path=file, **data)
    return file.getvalue()


class Painter(BackgroundWorker):
    """Draws pictures in a worker process, or in this process if no worker can be
    started.

    The worker exits with this process.
    """

    def __init__(self) -> None:
        super().__init__(__name__, single_threaded=False)
        self._gathering = ThreadPoolExecutor(1, "gathering")

    def draw(
        self, module: str, name: str, data: Callable[[], dict[str, Any]]
    ) -> Future[Any]:
        """Return the Future of `draw_png`; pictures are drawn one after another.

        A thread calls `data` while the worker draws the previous picture.
        """
        gathered = self._gathering.submit(data)
        return self._waiting.submit(
            lambda: self.call_worker_or_run_here(
                draw_png, module, name, gathered.result()
            )
        )


@one_per_process
def painter() -> Painter:
    """Return the single painter of this process; the first call starts its worker."""
    return Painter()


def serve() -> None:
    """Worker loop: serve drawing requests until the parent process exits."""
    if sys.platform != "win32":
        os.nice(5)  # solvers have priority
    hide_library_messages()  # matplotlib reports that it builds its font cache
    gc.disable()
    for module in ("motion", "sound", "mode_shapes"):
        import_module(f"sonify.report.{module}")
    gc.freeze()  # later collections ignore the loaded modules
    gc.set_threshold(100_000)  # new objects, those of about five pictures
    gc.enable()
    serve_calls()


if __name__ == "__main__":
    serve()
