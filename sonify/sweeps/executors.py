"""TASKS -> ROWS: the threads that wait for runs, on this machine or, by Dask, on the workers of a
cluster."""

import logging
import os
import sys
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import FIRST_COMPLETED, CancelledError, Future, ThreadPoolExecutor, wait
from contextlib import contextmanager
from itertools import islice
from time import monotonic
from typing import Any

from sonify.runtime.signals import BrokenOffError
from sonify.scene_errors import InputError
from sonify.sweeps.row_processes import EndedError, end_all, solve_apart
from sonify.sweeps.version import version

LOCAL = "local"
"""Instead of an address: a scheduler of Dask that lives as long as the sweep, with one worker of so
many threads."""
AHEAD = 3
"""Tasks per process that wait or run: no process is ever without."""
PATIENCE = 4.0
"""Time in which a scheduler has to answer [s]."""
WORKER_PATIENCE = 5.0
"""Time in which a first worker has to join a scheduler [s]."""
GONE = "what has been found is kept, but the processes are gone"
Submit = Callable[..., "Future[dict[str, Any]]"]


def cores() -> int:
    """Return the number of cores that this process may use."""
    if sys.platform == "linux":
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1


@contextmanager
def engine(
    scheduler: str | None, processes: int | None
) -> Iterator[tuple[Submit, Callable[[], int]]]:
    """Yield what submits a call, and what tells how many processes there are; LOCAL is a scheduler
    of this machine's own. Raises InputError if the scheduler does not answer, if it has no workers,
    or if they have another version of this program."""
    if scheduler == LOCAL:
        count = processes or cores()
        local = dask().LocalCluster(n_workers=1, threads_per_worker=count, dashboard_address=None)
        with local, cluster(local.scheduler_address) as made:
            yield made
    else:
        with cluster(scheduler) if scheduler else machine(processes or cores()) as made:
            yield made


@contextmanager
def machine(processes: int):
    """So many processes of this machine; they end with the block, in whatever they do."""
    threads = ThreadPoolExecutor(processes)
    try:
        yield threads.submit, lambda: processes
    finally:
        threads.shutdown(wait=False, cancel_futures=True)
        end_all()
        threads.shutdown()
        end_all()


def dask():
    """Return Dask's package. Raises InputError where it is not installed."""
    try:
        import distributed
    except ModuleNotFoundError:
        raise InputError('--scheduler needs Dask: python -m pip install -e ".[cluster]"') from None
    return distributed


@contextmanager
def cluster(address: str):
    """The workers of the Dask scheduler at `address`."""
    distributed = dask()
    logging.getLogger("distributed").setLevel(logging.CRITICAL)
    try:
        client = distributed.Client(address, timeout=PATIENCE)
    except Exception as error:  # whatever is there need not speak Dask's language
        raise InputError(f"--scheduler {address}: no scheduler answers: {error}") from None
    try:
        _require_worker(client, address)
        _same_version(client)
        yield client.get_executor(pure=False).submit, _capacity(client)
    finally:
        client.close(timeout=1)


def _require_worker(client, address):
    """Wait for a first worker. Raises InputError if none joins the scheduler."""
    try:
        client.wait_for_workers(1, timeout=WORKER_PATIENCE)
    except TimeoutError:
        remedy = f"start one with: dask worker {address}"
        fault = f"--scheduler {address}: no worker within {WORKER_PATIENCE:g} s; {remedy}"
        raise InputError(fault) from None


def _capacity(client):
    """How many processes the workers have; a cluster grows and shrinks, and is asked once a
    second."""
    asked = -1.0
    found = 0

    def count():
        nonlocal asked, found
        if monotonic() - asked > 1:
            try:
                found = sum(client.nthreads().values())
            except (OSError, TimeoutError) as error:
                raise BrokenOffError(f"{GONE}: {error}") from None
            asked = monotonic()
        return found

    return count


def _same_version(client):
    """Prove that all workers have this version of the program, whose functions they import by
    name."""
    for worker, found in client.run(version, on_error="return").items():
        if found != version():
            raise InputError(
                f"--scheduler: worker {worker} has another version of the program, {found}: "
                f"{version()}"
            )


def rows_of(
    tasks: Iterable[tuple[int, dict]], limit: float, submit: Submit, processes: Callable[[], int]
):
    """Yield what is done of `tasks`, numbers and what to solve, as lists of (number, row), in any
    order; an empty list after a second without news. Raises BrokenOffError where no more can be
    done."""
    tasks = iter(tasks)
    running = dict[Future, int]()
    while True:
        for run, task in islice(tasks, max(AHEAD * max(processes(), 1) - len(running), 0)):
            running[submit(solve_apart, task, limit)] = run
        if not running:
            return
        done, _ = wait(running, timeout=1, return_when=FIRST_COMPLETED)
        yield [(running.pop(future), _row(future)) for future in done]


def _row(future):
    try:
        row = future.result()
    except (CancelledError, EndedError) as error:
        raise BrokenOffError(f"{GONE}: {error or 'the scheduler does not answer'}") from None
    except Exception as error:  # as Dask's KilledWorker: a run that took several workers with it
        return {
            "error": f"{type(error).__name__}: {' '.join(str(error).split())}",
            "version": version(),
        }
    if row["version"] != version():
        raise InputError(
            f"a process has another version of the program, {row['version']}: here it is "
            f"{version()}"
        )
    if "stop" in row:
        raise OSError(*row["stop"])
    return row
