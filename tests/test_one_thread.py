"""Claim: BLAS has one thread while modes are sought or a scene is run, and afterwards as many as
the user set.

Source: the matrices are small; two threads take twice the processor time of one and are slower.
Oracle: threadpoolctl's own account of the libraries that are loaded.
"""

from concurrent.futures import ThreadPoolExecutor
from threading import Barrier, Thread

import pytest
import scipy.linalg  # noqa: F401  loads the BLAS that is asked about
from threadpoolctl import threadpool_info, threadpool_limits

from modal import eigenmodes
from modal.blas_threads import one_blas_thread
from sonify import run


def blas_threads() -> set[int]:
    return {
        library["num_threads"] for library in threadpool_info() if library["user_api"] == "blas"
    }


def set_threads(count: int) -> None:
    """Set them from a thread that ends: threadpoolctl lets nobody undo what a living one has
    set."""
    setting = Thread(target=threadpool_limits, args=(count, "blas"))
    setting.start()
    setting.join()


@pytest.fixture(autouse=True)
def two_threads():
    before = blas_threads()
    set_threads(2)
    if blas_threads() != {2}:
        pytest.skip("no BLAS here whose threads can be set to two")
    yield
    set_threads(max(before))


class Asked(Exception):
    """The work begins, with so many threads."""


def ask(*_):
    raise Asked(blas_threads())


@pytest.mark.parametrize(
    ("door", "work"), [(eigenmodes, "modal.solve.check_solvable"), (run, "sonify.pipeline.planned")]
)
def test_one_thread_inside_and_as_many_as_before_outside(door, work, scene, monkeypatch):
    monkeypatch.setattr(work, ask)
    with pytest.raises(Asked) as asked:
        door(scene)
    assert asked.value.args == ({1},)
    assert blas_threads() == {2}


@pytest.mark.parametrize("leaves_first", [0, 1])
def test_calls_that_overlap_leave_what_was_set(leaves_first):
    """Whoever came second must not give back the one thread that it found."""
    barrier = Barrier(2)

    @one_blas_thread
    def call(i):
        barrier.wait()
        if i != leaves_first:
            barrier.wait()

    def both(i):
        call(i)
        if i == leaves_first:
            barrier.wait()

    with ThreadPoolExecutor(2) as pool:
        list(pool.map(both, range(2)))
    assert blas_threads() == {2}
