"""Execute the jobs of the studio one after another in a worker process."""

import json
from collections.abc import Callable
from pathlib import Path
from queue import SimpleQueue
from threading import Event, Lock, Thread
from typing import Any

from sonify.runtime.workers import WorkerDiedError, WorkerProcess
from sonify.studio.worker import PROGRESS_FILE, warm_up


class Job:
    """One function call in the worker process, which writes its progress to
    `folder`."""

    def __init__(self, number: int, folder: Path, function: Callable, *arguments: Any):
        self.number = number
        self.folder = folder
        self.function = function
        self.arguments = arguments
        self.cancelled = False
        self.ended = Event()
        self.result: dict[str, Any] | None = None
        self.error: Exception | None = None

    def progress(self) -> dict[str, Any]:
        """Return the latest progress written by the worker."""
        try:
            content = json.loads(
                (self.folder / PROGRESS_FILE).read_text(encoding="utf-8")
            )
        except (OSError, ValueError):
            content = {"line": "", "share": None, "heard": False, "streams": False}
        return content


class JobQueue:
    """First-in, first-out queue of jobs for one worker process that is kept ready."""

    def __init__(
        self,
        start_worker: Callable[[], WorkerProcess] = lambda: WorkerProcess(
            "sonify.studio.worker", single_threaded=False
        ),
        warm: bool = True,
    ):
        self._start_worker = start_worker
        self._warm = warm
        self._jobs: SimpleQueue[Job | None] = SimpleQueue()
        self._lock = Lock()
        self._worker: WorkerProcess | None = None
        self._current: Job | None = None
        self._waiting: list[Job] = []
        self._closed = False
        self._thread = Thread(target=self._work, daemon=True)
        self._thread.start()

    def submit(self, job: Job) -> Job:
        """Append a job."""
        with self._lock:
            self._waiting.append(job)
        self._jobs.put(job)
        return job

    def jobs_before(self, job: Job) -> int:
        """Return the number of jobs ahead of this one."""
        with self._lock:
            ahead = self._waiting.index(job) if job in self._waiting else 0
            return ahead + (self._current is not None and self._current is not job)

    def cancel(self, job: Job):
        """Cancel a job; kill the worker if the job is running."""
        with self._lock:
            if job.ended.is_set():
                return
            job.cancelled = True
            if job in self._waiting:
                self._waiting.remove(job)
            if self._current is job and self._worker is not None:
                self._worker.kill()
                self._worker = None

    def close(self):
        """Cancel all jobs and end the worker."""
        with self._lock:
            self._closed = True
            if self._worker:
                self._worker.kill()
                self._worker = None
        self._jobs.put(None)
        self._thread.join(timeout=10.0)

    def _work(self):
        self._ensure_worker()
        while (job := self._jobs.get()) is not None:
            self._execute(job)
            if not self._closed and self._worker is None:
                self._ensure_worker()

    def _ensure_worker(self) -> WorkerProcess | None:
        """Return the worker; start and warm up a new one if none is running."""
        with self._lock:
            if self._closed or self._worker is not None:
                return self._worker
            worker = self._worker = self._start_worker()
        if self._warm:
            try:
                worker.call(warm_up)
            except WorkerDiedError:
                self._discard_worker(worker)
                return None
        return worker

    def _execute(self, job):
        worker = self._ensure_worker()
        with self._lock:
            if job in self._waiting:
                self._waiting.remove(job)
            if not job.cancelled:
                self._current = job
        try:
            if job.cancelled or worker is None:
                raise WorkerDiedError("cancelled" if job.cancelled else "no worker")
            job.result = worker.call(job.function, *job.arguments)
        except WorkerDiedError as error:
            job.error = error
            if not job.cancelled:
                self._discard_worker(worker)
        except Exception as error:
            job.error = error
        finally:
            with self._lock:
                self._current = None
            job.ended.set()

    def _discard_worker(self, worker: WorkerProcess | None):
        """Remove a dead worker."""
        with self._lock:
            if worker is not None and self._worker is worker:
                worker.kill()
                self._worker = None
