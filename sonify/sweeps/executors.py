"""Distribution of runs among local processes or the workers of a Dask cluster."""

import logging
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import (
    FIRST_COMPLETED,
    CancelledError,
    Future,
    ThreadPoolExecutor,
    wait,
)
from contextlib import contextmanager
from itertools import islice
from time import monotonic
from typing import TYPE_CHECKING, Any

from sonify.extras import require_extra
from sonify.runtime.signals import AbortedError
from sonify.runtime.workers import core_count
from sonify.scene_errors import InputError
from sonify.sweeps.row_processes import (
    ProcessesEndedError,
    end_all_processes,
    solve_isolated,
)
from sonify.sweeps.version import version

if TYPE_CHECKING:
    from distributed import Client

WORKERS_LOST_MESSAGE = "the worker processes are lost; the finished runs are saved"
Submit = Callable[..., "Future[Any]"]


@contextmanager
def open_executor(
    scheduler: str | None, processes: int | None
) -> Iterator[tuple[Submit, Callable[[], int]]]:
    """Yield a function that submits a call, and one that returns the number of
    processes.

    Without the address of a `scheduler`, the processes run on this machine. Raises
    InputError if the scheduler does not answer, has no workers, or has workers with
    another version of this program."""
    if scheduler == "local":
        raise InputError(
            "--scheduler local: removed in 0.3; without --scheduler the runs use the "
            "cores of this machine"
        )
    processes = processes or core_count()
    executor = dask_executor(scheduler) if scheduler else local_executor(processes)
    with executor as submit_and_count:
        yield submit_and_count


@contextmanager
def local_executor(processes: int) -> Iterator[tuple[Submit, Callable[[], int]]]:
    """Yield an executor with `processes` local processes, which are killed at the
    end."""
    threads = ThreadPoolExecutor(processes)
    try:
        yield threads.submit, lambda: processes
    finally:
        threads.shutdown(wait=False, cancel_futures=True)
        end_all_processes()
        threads.shutdown()
        end_all_processes()


@contextmanager
def dask_executor(address: str) -> Iterator[tuple[Submit, Callable[[], int]]]:
    """Yield an executor for the workers of the Dask scheduler at `address`."""
    require_extra("--scheduler", "distributed", "cluster")
    import distributed

    logging.getLogger("distributed").setLevel(logging.CRITICAL)
    try:
        client = distributed.Client(address, timeout=4.0)
    except Exception as error:  # the address may belong to another kind of server
        raise InputError(
            f"--scheduler {address}: no scheduler answers: {error}"
        ) from None
    try:
        wait_for_first_worker(client, address)
        _require_same_version(client)
        yield client.get_executor(pure=False).submit, _worker_counter(client)
    finally:
        client.close(timeout=1)


def wait_for_first_worker(client: "Client", address: str) -> None:
    """Wait for the first worker. Raises InputError if none joins the scheduler."""
    timeout = 5.0  # s
    try:
        client.wait_for_workers(1, timeout=timeout)
    except TimeoutError:
        remedy = f"start one with: dask worker {address}"
        fault = f"--scheduler {address}: no worker within {timeout:g} s; {remedy}"
        raise InputError(fault) from None


def _worker_counter(client: "Client") -> Callable[[], int]:
    """Return a function that counts the worker threads with at most one query per
    second.

    The count may change during the sweep.
    """
    last_query = -1.0
    found = 0

    def count() -> int:
        nonlocal last_query, found
        if monotonic() - last_query > 1:
            try:
                found = sum(client.nthreads().values())
            except (OSError, TimeoutError) as error:
                raise AbortedError(f"{WORKERS_LOST_MESSAGE}: {error}") from None
            last_query = monotonic()
        return found

    return count


def _require_same_version(client: "Client") -> None:
    """Raise InputError unless all workers have this version of the program.

    Workers import functions of the program by name.
    """
    for worker, found in client.run(version, on_error="return").items():
        if found != version():
            raise InputError(
                f"--scheduler: worker {worker} has another version of the program, {found} instead of "
                f"{version()}"
            )


def solve_tasks(
    tasks: Iterable[tuple[int, dict[str, Any]]],
    limit: float,
    submit: Submit,
    processes: Callable[[], int],
) -> Iterator[list[tuple[int, dict[str, Any]]]]:
    """Solve `tasks`, pairs (run number, task), and yield lists of (run number, row) in
    any order.

    The list is empty after one second without a result. The time limit of a task is
    `limit` [s]. Raises AbortedError if the processes or the scheduler are lost."""
    tasks = iter(tasks)
    running = dict[Future[Any], int]()
    tasks_per_process = 3  # running or waiting; enough to keep each process busy
    while True:
        for run, task in islice(
            tasks, max(tasks_per_process * max(processes(), 1) - len(running), 0)
        ):
            running[submit(solve_isolated, task, limit)] = run
        if not running:
            return
        done, _ = wait(running, timeout=1, return_when=FIRST_COMPLETED)
        yield [(running.pop(future), row_of_future(future)) for future in done]


def row_of_future(future: Future[dict[str, Any]]) -> dict[str, Any]:
    """Return the row of a finished task, or a row with the error of a failed one.

    Raises AbortedError, InputError or OSError if the sweep cannot continue.
    """
    try:
        row = future.result()
    except (CancelledError, ProcessesEndedError) as error:
        raise AbortedError(
            f"{WORKERS_LOST_MESSAGE}: {error or 'the scheduler does not answer'}"
        ) from None
    except (
        Exception
    ) as error:  # e.g. KilledWorker of Dask: the run killed several workers
        return {
            "error": f"{type(error).__name__}: {' '.join(str(error).split())}",
            "version": version(),
        }
    if row["version"] != version():
        raise InputError(
            f"a process has another version of the program, {row['version']} instead of {version()}"
        )
    if "stop" in row:
        raise OSError(*row["stop"])
    return row
