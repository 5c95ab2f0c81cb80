"""Parallel tasks in worker processes."""

from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor
from queue import SimpleQueue
from typing import Any

from sonify.hearing.recording_errors import RecordingError
from sonify.runtime.workers import WorkerDiedError, WorkerProcess


def in_worker_processes(
    function: Callable[..., Any], tasks: list[tuple[Any, ...]], count: int
) -> Iterator[Any]:
    """Yield `function(*task)` for every task in order, computed by `count` worker
    processes.

    Exceptions raised by the function are raised again. If its process dies, a task has
    the result RecordingError, and the remaining tasks have a new process.
    """
    idle: SimpleQueue[Any] = SimpleQueue[Any]()
    processes = [WorkerProcess() for _ in range(count)]
    for process in processes:
        idle.put(process)

    def done(task: tuple[Any, ...]) -> Any:
        process = idle.get()
        try:
            return process.call(function, *task)
        except WorkerDiedError as error:
            process = WorkerProcess()
            processes.append(process)
            return RecordingError(f"{task[0]}: the fitting process ended: {error}")
        finally:
            idle.put(process)

    pool = ThreadPoolExecutor(count)
    try:
        yield from pool.map(done, tasks)
    finally:
        pool.shutdown(wait=False, cancel_futures=True)
        for process in processes:
            process.kill()
