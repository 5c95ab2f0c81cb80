"""RECORDINGS -> FITS, several at once: processes that read what to fit from their standard input."""

import pickle
import sys
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from queue import SimpleQueue
from typing import IO, Any, cast

from sonify.hearing.recording import RecordingError
from sonify.process import ended, started


def each(tasks: list[tuple], count: int) -> Iterator[Any]:
    """Yield `fit_one(*task)` for every task, in order, from `count` processes. Raises RecordingError as it does."""
    idle: SimpleQueue = SimpleQueue()
    processes = [started(sys.executable, "sonify.fitting.worker") for _ in range(count)]
    for process in processes:
        idle.put(process)

    def fitted(task):
        process = idle.get()
        try:
            pickle.dump(task, cast(IO[bytes], process.stdin))
            cast(IO[bytes], process.stdin).flush()
            return pickle.load(cast(IO[bytes], process.stdout))
        except (EOFError, OSError) as error:
            raise RecordingError(f"{task[0]}: the process that fitted it ended: {error or 'no answer'}") from None
        finally:
            idle.put(process)

    pool = ThreadPoolExecutor(count)
    try:
        for answer in pool.map(fitted, tasks):
            if isinstance(answer, str):
                raise RecordingError(answer)
            yield answer
    finally:
        pool.shutdown(wait=False, cancel_futures=True)
        for process in processes:
            ended(process)
