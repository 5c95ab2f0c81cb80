"""Claim: BLAS runs with one thread during a modal analysis and during the run of a scene; the
user's setting is restored afterwards.

Source: the matrices are small; two threads take twice the processor time of one and are slower.
Oracle: the numbers of threads that threadpoolctl reports for the loaded libraries.
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
        library["num_threads"]
        for library in threadpool_info()
        if library["user_api"] == "blas"
    }


def set_threads(count: int) -> None:
    """Set the number of BLAS threads from a thread that ends.

    The limits set by a living threadpoolctl controller cannot be reset.
    """
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
    """The work starts, with this number of BLAS threads."""


def ask(*_):
    raise Asked(blas_threads())


@pytest.mark.parametrize(
    ("door", "work"),
    [
        (eigenmodes, "modal.solve.check_solvable"),
        (run, "sonify.pipeline.plan_of_run"),
    ],
)
def test_one_thread_inside_and_as_many_as_before_outside(
    door, work, scene, monkeypatch
):
    monkeypatch.setattr(work, ask)
    with pytest.raises(Asked) as asked:
        door(scene)
    assert asked.value.args == ({1},)
    assert blas_threads() == {2}


@pytest.mark.parametrize("leaves_first", [0, 1])
def test_calls_that_overlap_leave_what_was_set(leaves_first):
    """The call that starts second must not restore the one thread that it found."""
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
