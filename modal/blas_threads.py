"""Limit BLAS to one thread, because more threads do not accelerate operations on small
matrices."""

from collections.abc import Callable
from functools import wraps
from threading import Lock
from typing import ParamSpec, TypeVar

from threadpoolctl import threadpool_limits

P = ParamSpec("P")
R = TypeVar("R")

_limit_lock = Lock()


def one_blas_thread(function: Callable[P, R]) -> Callable[P, R]:
    """Decorate a function so that BLAS uses a single thread while it runs.

    The previous setting is restored afterwards. The setting applies to the whole
    process; if calls overlap, the first one sets and restores it.
    """

    @wraps(function)
    def limited(*arguments: P.args, **options: P.kwargs) -> R:
        if not _limit_lock.acquire(blocking=False):
            return function(*arguments, **options)
        try:
            with threadpool_limits(1, user_api="blas"):
                return function(*arguments, **options)
        finally:
            _limit_lock.release()

    return limited
