"""Serve the page of the studio, its runs and its recordings to a browser."""

import asyncio
import json
import re
from collections.abc import AsyncIterator, Callable
from contextlib import asynccontextmanager, closing
from functools import cache
from importlib import resources
from itertools import count
from math import inf
from pathlib import Path
from secrets import token_urlsafe
from shutil import rmtree
from tempfile import TemporaryDirectory
from typing import Any

from jinja2 import Environment, PackageLoader
from markupsafe import Markup
from starlette.applications import Starlette
from starlette.exceptions import HTTPException
from starlette.middleware import Middleware
from starlette.middleware.trustedhost import TrustedHostMiddleware
from starlette.requests import Request
from starlette.responses import (
    HTMLResponse,
    JSONResponse,
    Response,
    StreamingResponse,
)
from starlette.routing import Mount, Route

from sonify.report.page import page_assets
from sonify.runtime.files import create_folder, first_matching_folder
from sonify.runtime.workers import WorkerDiedError
from sonify.scene import load_scene, shipped_scenes
from sonify.scene_errors import InputError
from sonify.serve import (
    CONTENT_SECURITY_POLICY,
    LOOPBACK,
    SECURITY_HEADERS,
    address,
    file_response,
    listening_socket,
    routes_of_runs,
    run_application,
)
from sonify.studio.controls import changed_scene, control_key_of_error, controls
from sonify.studio.job_queue import Job, JobQueue
from sonify.studio.worker import PREVIEW_FILE, STREAM_FILE, analyse_recording, run_scene

MAX_UPLOAD_BYTES = 100_000_000
"""Largest accepted recording [bytes]; about 17 minutes of mono sound."""
UPLOAD_FOLDER = "upload"
"""Folder of a recording in the folder of its job."""
STUDIO_POLICY = CONTENT_SECURITY_POLICY | {
    "connect-src": "'self' data:",
    "media-src": "'self' data: blob:",
    "frame-src": "'self'",  # for the page of a run
    "frame-ancestors": "'self'",
}
STUDIO_HEADERS = SECURITY_HEADERS | {
    "Content-Security-Policy": "; ".join(map(" ".join, STUDIO_POLICY.items()))
}


def studio(folder: str | Path, port: int, note: Callable):
    """Serve the studio on this machine until interrupted, and pass its address to
    `note`.

    Runs are written to `folder`. Port 0 selects any free port. Raises InputError if the
    port is invalid or in use, and OutputError if the folder cannot be written.
    """
    host = LOOPBACK[0]
    with listening_socket(host, port) as listening:
        root = create_folder(folder)
        token = token_urlsafe(16)
        note(f"{address(host, listening)}{token}/")
        app = application(root, token, JobQueue())
        run_application(app, STUDIO_HEADERS, listening)


def application(folder: str | Path, token: str, queue: JobQueue) -> Starlette:
    """Return the web application; all its paths start with the token.

    The queue executes the jobs and is closed when the application ends.
    """
    session = Session(Path(folder).resolve(), queue)
    routes = [
        Route("/", session.page),
        Route("/controls/{scene}", session.controls_of_scene),
        Route("/runs", session.run, methods=["POST"]),
        Route("/recordings", session.recording, methods=["POST"]),
        Route("/stream/{number:int}", session.stream),
        Route("/session/{path:path}", session.session_file),
        *routes_of_runs(session.root, "/list"),
    ]

    @asynccontextmanager
    async def lifespan(app):
        temporary = TemporaryDirectory(
            prefix="sonify-studio-", ignore_cleanup_errors=True
        )
        with temporary as name, closing(queue):
            session.folder = Path(name).resolve()
            yield

    return Starlette(
        routes=[Mount(f"/{token}", routes=routes)],
        middleware=[Middleware(TrustedHostMiddleware, allowed_hosts=[*LOOPBACK[:2]])],
        lifespan=lifespan,
        exception_handlers={InputError: _report_input_error},
    )


async def _report_input_error(request, error) -> Response:
    return JSONResponse(_error_record(error), 422)


class Session:
    """Session of the studio with its jobs, the folder of its runs, and a folder of
    temporary files."""

    folder: Path
    """Folder of the temporary files."""

    def __init__(self, root: Path, queue: JobQueue):
        self.root = root
        self._queue = queue
        self._numbers = count(1)
        self._runs: dict[int, Job] = {}

    def page(self, request: Request) -> Response:
        """Return the page of the studio."""
        style = page_assets()["style"]
        page = _templates().get_template("studio.html")
        text = page.render(scenes=shipped_scenes(), style=style, **_studio_assets())
        return HTMLResponse(text)

    def controls_of_scene(self, request: Request) -> Response:
        """Return the controls of a shipped scene."""
        name = request.path_params["scene"]
        if name not in shipped_scenes():
            raise HTTPException(404, "no such scene")
        return JSONResponse(_controls(name))

    async def run(self, request: Request) -> Response:
        """Run a scene and stream its progress; closing the response cancels the run."""
        try:
            document = json.loads(await _body(request, 100_000))
            name, values = str(document["scene"]), dict(document["values"])
        except (ValueError, LookupError, TypeError):
            return JSONResponse(
                {"error": "invalid run: expected scene and values"}, 400
            )
        scene = changed_scene(name, values)
        out = first_matching_folder(
            self.root / f"studio-{scene.name}", lambda folder: not folder.exists()
        )
        out.mkdir(parents=True)
        number, folder = self._new_folder()
        job = Job(folder, run_scene, scene.document, out, folder)
        self._runs[number] = job
        places = {
            "page": f"runs/{out.name}/",
            "sound": f"session/{number}/{PREVIEW_FILE}",
            "stream": f"stream/{number}",
        }
        return self._stream(request, job, places)

    async def recording(self, request: Request) -> Response:
        """Analyse the recording in the body, which the query names, and compare it with
        the scene of the query."""
        query = request.query_params
        try:
            values = dict(json.loads(query.get("values", "{}")))
            span = (float(query.get("from", 0.0)), float(query.get("to", inf)))
        except (ValueError, TypeError):
            return JSONResponse(
                {"error": "invalid recording: expected scene, values, from and to"}, 400
            )
        scene = changed_scene(query.get("scene", ""), values)
        content = await _body(request, MAX_UPLOAD_BYTES)
        number, folder = self._new_folder()
        path = folder / UPLOAD_FOLDER / file_name(query.get("name", ""))
        path.parent.mkdir()
        path.write_bytes(content)
        job = Job(folder, analyse_recording, path, scene.document, folder, span)
        return self._stream(request, job, {"folder": f"session/{number}/"})

    def session_file(self, request: Request) -> Response:
        """Return a sound or picture of this session."""
        return file_response(request, self.folder)

    def stream(self, request: Request) -> Response:
        """Return the sound of a run while it is rendered."""
        job = self._runs.get(request.path_params["number"])
        if job is None or not (job.folder / STREAM_FILE).exists():
            raise HTTPException(404, "no such sound")
        return StreamingResponse(_growing_file(job), media_type="audio/wav")

    def _new_folder(self):
        number = next(self._numbers)
        folder = self.folder / str(number)
        folder.mkdir()
        return number, folder

    def _stream(self, request, job, places):
        lines = self._lines(request, self._queue.submit(job), places)
        return StreamingResponse(lines, media_type="application/x-ndjson")

    async def _lines(self, request, job, places) -> AsyncIterator[str]:
        """Yield the progress of a job as lines of JSON; cancel the job if the client
        disconnects."""
        polling_interval = 0.1  # s
        try:
            while not job.ended.is_set():
                if await request.is_disconnected():
                    return
                progress = (
                    places | job.progress() | {"before": self._queue.jobs_before(job)}
                )
                yield json.dumps(progress) + "\n"
                await asyncio.sleep(polling_interval)
            yield json.dumps(places | _final_record(job)) + "\n"
        finally:
            self._queue.cancel(job)
            rmtree(job.folder / UPLOAD_FOLDER, ignore_errors=True)
            if job.result is None and "page" in places:
                rmtree(self.root / Path(places["page"]).name, ignore_errors=True)


def file_name(given: str) -> str:
    """Return a file name for a recording whose name in the browser is given.

    Letters that a file system may refuse are replaced by `_`."""
    max_length = 200  # bytes
    name = re.sub(r'[\x00-\x1f\x7f<>:"/\\|?*]', "_", given).strip(". ")
    short = name.encode("utf-8", "replace")[-max_length:].decode("utf-8", "ignore")
    return short or "recording"


async def _growing_file(job) -> AsyncIterator[bytes]:
    """Yield the sound of a run until it is complete or the run has ended."""
    polling_interval = 0.1  # s
    with open(job.folder / STREAM_FILE, "rb") as file:
        while True:
            complete = job.ended.is_set() or (job.folder / PREVIEW_FILE).exists()
            while piece := file.read(1 << 16):
                yield piece
            if complete:
                return
            await asyncio.sleep(polling_interval)


def _final_record(job) -> dict[str, Any]:
    if job.error is None:
        return {"done": True, "heard": True, "result": job.result}
    if isinstance(job.error, WorkerDiedError):
        return {"error": "the run was cancelled or its process died", "key": ""}
    return _error_record(job.error)


def _error_record(error):
    sentence = " ".join(str(error).split()) or type(error).__name__
    return {"error": sentence, "key": control_key_of_error(sentence)}


async def _body(request: Request, most: int) -> bytes:
    """Return the body of a request; raises HTTPException if it is longer than `most`
    bytes."""
    content = bytearray()
    async for piece in request.stream():
        content += piece
        if len(content) > most:
            raise HTTPException(413, f"the request is larger than {most / 1e6:g} MB")
    return bytes(content)


@cache
def _controls(name: str) -> list[dict[str, Any]]:
    """Return the controls of a shipped scene, which take up to a second to check."""
    return controls(load_scene(name))


@cache
def _templates() -> Environment:
    return Environment(loader=PackageLoader("sonify.studio"), autoescape=True)


def _studio_assets() -> dict[str, Markup]:
    """Return script and style of the studio page."""
    folder = resources.files("sonify.studio") / "templates"
    files = {"studio_script": "studio.js", "studio_style": "studio.css"}
    return {
        name: Markup((folder / file).read_text("utf-8")) for name, file in files.items()
    }
