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

    def __init__(
        self, folder: Path, function: Callable[..., Any], *arguments: Any
    ) -> None:
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
            return json.loads((self.folder / PROGRESS_FILE).read_text("utf-8"))
        except (OSError, ValueError):
            return {"line": "", "share": None, "heard": False, "streams": False}


class JobQueue:
    """First-in, first-out queue of jobs for one worker process that is kept ready."""

    def __init__(
        self,
        start_worker: Callable[[], WorkerProcess] = lambda: WorkerProcess(
            "sonify.studio.worker", single_threaded=False
        ),
        warm: bool = True,
    ) -> None:
        self._start_worker = start_worker
        self._warm = warm
        self._submitted: SimpleQueue[Job | None] = SimpleQueue()
        self._lock = Lock()
        self._worker: WorkerProcess | None = None
        self._jobs: list[Job] = []
        self._running: Job | None = None
        self._closed = False
        self._thread = Thread(target=self._work, daemon=True)
        self._thread.start()

    def submit(self, job: Job) -> Job:
        """Append a job."""
        with self._lock:
            self._jobs.append(job)
        self._submitted.put(job)
        return job

    def jobs_before(self, job: Job) -> int:
        """Return the number of jobs ahead of this one."""
        with self._lock:
            return self._jobs.index(job) if job in self._jobs else 0

    def cancel(self, job: Job) -> None:
        """Cancel a job; kill the worker if the job is running."""
        with self._lock:
            job.cancelled = True
            if job is self._running:
                self._kill_worker()
            else:
                self._remove(job)

    def close(self) -> None:
        """Cancel all jobs and end the worker."""
        with self._lock:
            self._closed = True
            self._kill_worker()
        self._submitted.put(None)
        self._thread.join(timeout=10.0)

    def _work(self) -> None:
        self._ensure_worker()
        while (job := self._submitted.get()) is not None:
            self._execute(job)
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
                with self._lock:
                    self._kill_worker()
                return None
        return worker

    def _execute(self, job: Job) -> None:
        worker = self._ensure_worker()
        with self._lock:
            self._running = None if job.cancelled else job
        try:
            if job.cancelled or worker is None:
                raise WorkerDiedError("cancelled" if job.cancelled else "no worker")
            job.result = worker.call(job.function, *job.arguments)
        except WorkerDiedError as error:
            job.error = error
            if not job.cancelled:
                with self._lock:
                    self._kill_worker()
        except Exception as error:
            job.error = error
        finally:
            with self._lock:
                self._running = None
                self._remove(job)
            job.ended.set()

    def _kill_worker(self) -> None:
        """Kill the worker, if there is one; the lock is held."""
        if self._worker is not None:
            self._worker.kill()
            self._worker = None

    def _remove(self, job: Job) -> None:
        """Remove a job, if it has not yet been removed; the lock is held."""
        if job in self._jobs:
            self._jobs.remove(job)
