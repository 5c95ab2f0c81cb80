"""One BLAS thread while something is solved: the matrices are small, and more threads only wait for each other."""

from collections.abc import Callable
from functools import wraps
from threading import Lock
from typing import ParamSpec, TypeVar

from threadpoolctl import threadpool_limits

P = ParamSpec("P")
R = TypeVar("R")

_limiting = Lock()


def one_blas_thread(function: Callable[P, R]) -> Callable[P, R]:
    """Decorate a function so that BLAS has one thread while it runs, and afterwards as many as before.

    BLAS has one setting for the whole process: where calls overlap, the first of them sets it and gives it back.
    """

    @wraps(function)
    def limited(*arguments: P.args, **options: P.kwargs) -> R:
        if not _limiting.acquire(blocking=False):
            return function(*arguments, **options)
        try:
            with threadpool_limits(1, user_api="blas"):
                return function(*arguments, **options)
        finally:
            _limiting.release()

    return limited
