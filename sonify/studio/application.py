"""Serve the page of the studio, its runs and its recordings to a browser.

`serve` is the same page without the parts that start runs.
"""

import asyncio
import json
import re
from collections.abc import AsyncIterator, Callable
from contextlib import asynccontextmanager, closing
from functools import cache
from gzip import decompress
from importlib import resources
from itertools import count
from math import inf
from pathlib import Path
from secrets import token_urlsafe
from shutil import rmtree
from tempfile import TemporaryDirectory
from typing import Any

from jinja2 import ChoiceLoader, Environment, PackageLoader
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
from sonify.report.run_names import run_name
from sonify.runtime.files import create_folder, first_matching_folder, readable_text
from sonify.runtime.workers import WorkerDiedError
from sonify.scene import load_scene, present_scene_name, scene_record, shipped_scenes
from sonify.scene_errors import InputError
from sonify.studio.controls import changed_scene, control_key_of_error, controls
from sonify.studio.job_queue import Job, JobQueue
from sonify.studio.run_list import (
    embedded_run_data,
    finished_runs,
    shipped_run_entry,
)
from sonify.studio.server import (
    LOOPBACK,
    address,
    file_response,
    listening_socket,
    path_inside,
    run_application,
)
from sonify.studio.worker import (
    STREAM_FILE,
    analyse_recording,
    run_scene,
    write_takes,
)

MAX_UPLOAD_BYTES = 100_000_000
"""Largest accepted recording [bytes]; about 17 minutes of mono sound."""
UPLOAD_FOLDER = "upload"
"""Folder of a recording in the folder of its job."""
OPENING_RUN = "opening.json.gz"
"""Shipped run that the studio shows at first: the scene toy."""


def studio(folder: str | Path, port: int, note: Callable[..., Any]) -> None:
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
        run_application(app, listening)


def serve(
    folder: str | Path, host: str, port: int, note: Callable[[str], object]
) -> None:
    """Serve the runs in `folder` until interrupted; pass the address to `note`.

    Port 0 selects any free port. Raises InputError if the folder does not exist, or if
    the address or the port is invalid or unavailable.
    """
    if not Path(folder).is_dir():
        raise InputError(f"{folder}: no such folder; python -m sonify run creates it")
    with listening_socket(host, port) as listening:
        note(address(host, listening))
        run_application(read_only_application(folder, host), listening)


def application(folder: str | Path, token: str, queue: JobQueue) -> Starlette:
    """Return the web application; all its paths start with the token.

    The queue executes the jobs and is closed when the application ends.
    """
    session = Session(Path(folder).resolve(), queue)
    routes = [
        Route("/controls/{scene}", session.controls_of_scene),
        Route("/runs", session.run, methods=["POST"]),
        Route("/takes", session.takes, methods=["POST"]),
        Route("/recordings", session.recording, methods=["POST"]),
        Route("/stream/{number:int}", session.stream),
        Route("/session/{path:path}", session.session_file),
        *routes_of_runs(session.root, is_editable=True),
    ]

    @asynccontextmanager
    async def lifespan(app: Starlette) -> AsyncIterator[None]:
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


def read_only_application(folder: str | Path, host: str) -> Starlette:
    """Return the web application that shows the runs in `folder`.

    If `host` is a loopback address, requests with other host names are rejected.
    """
    names = [*LOOPBACK, "[::1]"] if host in LOOPBACK else ["*"]
    return Starlette(
        routes=routes_of_runs(Path(folder).resolve(), is_editable=False),
        middleware=[Middleware(TrustedHostMiddleware, allowed_hosts=names)],
    )


def routes_of_runs(root: Path, is_editable: bool) -> list[Route]:
    """Return the routes for the page, the list of runs in `root`, their data and
    files."""

    def listed() -> dict[str, Any]:
        shipped = [_opening_entry()] if is_editable else []
        return {
            "runs": [*finished_runs(root), *shipped],
            "root": readable_text(root.name),
            "is_editable": is_editable,
        }

    def page(request: Request) -> Response:
        content = listed() | _studio_assets() | page_assets()
        template = _templates().get_template("studio.html")
        return HTMLResponse(template.render(content, scenes=shipped_scenes()))

    def run_list(request: Request) -> Response:
        return HTMLResponse(_templates().get_template("run_list.html").render(listed()))

    def data(request: Request) -> Response:
        folder = path_inside(root, request.path_params["path"])
        text = embedded_run_data(folder / "report.html")
        return Response(text, media_type="application/json")

    def opening(request: Request) -> Response:
        compressed = {"Content-Encoding": "gzip"}
        return Response(
            _opening_data(), headers=compressed, media_type="application/json"
        )

    def file(request: Request) -> Response:
        return file_response(request, root)

    return [
        Route("/", page),
        Route("/list", run_list),
        Route("/opening", opening),
        Route("/data/{path:path}", data),
        Route("/runs/{path:path}", file),
    ]


async def _report_input_error(request: Request, error: Exception) -> Response:
    return JSONResponse(_error_record(error), 422)


class Session:
    """Session of the studio with its jobs, the folder of its runs, and a folder of
    temporary files."""

    folder: Path
    """Folder of the temporary files."""

    def __init__(self, root: Path, queue: JobQueue) -> None:
        self.root = root
        self._queue = queue
        self._numbers = count(1)
        self._runs: dict[int, Job] = {}

    def controls_of_scene(self, request: Request) -> Response:
        """Return the controls of a shipped scene."""
        name = present_scene_name(request.path_params["scene"])
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
        out = self._new_output(f"studio-{scene.name}")
        number, folder = self._new_folder()
        job = Job(folder, run_scene, scene.document, out, folder)
        self._runs[number] = job
        places = {
            "place": out.name,
            "name": run_name(scene_record(scene)).words,
            "stream": f"stream/{number}",
        }
        return self._stream(request, job, places)

    async def takes(self, request: Request) -> Response:
        """Write takes of a scene and stream the progress; closing the response cancels
        it."""
        from sonify.export.takes import MIN_LENGTH  # slow import

        max_takes = 99
        try:
            document = json.loads(await _body(request, 100_000))
            name, values = str(document["scene"]), dict(document["values"])
            takes, audible = int(document["takes"]), bool(document["audible"])
            last = None if document["last"] is None else float(document["last"])
        except (ValueError, LookupError, TypeError):
            return JSONResponse(
                {"error": "invalid takes: expected takes, last and audible"}, 400
            )
        if not 1 <= takes <= max_takes:
            raise InputError(f"takes = {takes}: must be from 1 to {max_takes}")
        if last is not None and not MIN_LENGTH <= last < inf:
            raise InputError(f"last = {last:g}: must be at least {MIN_LENGTH:g} s")
        scene = changed_scene(name, values)
        out = self._new_output(f"takes-{scene.name}")
        _, folder = self._new_folder()
        settings = takes, last, audible
        job = Job(folder, write_takes, scene.document, out, folder, *settings)
        return self._stream(request, job, {"place": out.name})

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

    def _new_output(self, name: str) -> Path:
        """Return a new folder for results, called `name`, `name`-2 and so on."""
        out = first_matching_folder(
            self.root / name, lambda folder: not folder.exists()
        )
        out.mkdir(parents=True)
        return out

    def _new_folder(self) -> tuple[int, Path]:
        number = next(self._numbers)
        folder = self.folder / str(number)
        folder.mkdir()
        return number, folder

    def _stream(self, request: Request, job: Job, places: dict[str, Any]) -> Response:
        lines = self._lines(request, self._queue.submit(job), places)
        return StreamingResponse(lines, media_type="application/x-ndjson")

    async def _lines(
        self, request: Request, job: Job, places: dict[str, Any]
    ) -> AsyncIterator[str]:
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
            if job.result is None and "place" in places:
                rmtree(self.root / places["place"], ignore_errors=True)


def file_name(given: str) -> str:
    """Return a file name for a recording whose name in the browser is given.

    Letters that a file system may refuse are replaced by `_`."""
    max_length = 200  # bytes
    name = re.sub(r'[\x00-\x1f\x7f<>:"/\\|?*]', "_", given).strip(". ")
    short = name.encode("utf-8", "replace")[-max_length:].decode("utf-8", "ignore")
    return short or "recording"


async def _growing_file(job: Job) -> AsyncIterator[bytes]:
    """Yield the sound of a run until it is complete or the run has ended."""
    polling_interval = 0.1  # s
    with open(job.folder / STREAM_FILE, "rb") as file:
        while True:
            complete = job.ended.is_set() or job.progress()["heard"]
            while piece := file.read(1 << 16):
                yield piece
            if complete:
                return
            await asyncio.sleep(polling_interval)


def _final_record(job: Job) -> dict[str, Any]:
    if job.error is None:
        return {"done": True, "heard": True, "result": job.result}
    if isinstance(job.error, WorkerDiedError):
        return {"error": "the run was cancelled or its process died", "key": ""}
    return _error_record(job.error)


def _error_record(error: BaseException) -> dict[str, Any]:
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
    """Return the controls of a shipped scene."""
    return controls(load_scene(name))


def _opening_data() -> bytes:
    """Return the data of the shipped run as compressed JSON."""
    return (resources.files("sonify.studio") / OPENING_RUN).read_bytes()


@cache
def _opening_entry() -> dict[str, Any]:
    """Return the list entry of the shipped run, whose place is empty."""
    return shipped_run_entry(json.loads(decompress(_opening_data()))["record"], "")


@cache
def _templates() -> Environment:
    packages = PackageLoader("sonify.studio"), PackageLoader("sonify.report")
    return Environment(loader=ChoiceLoader(packages), autoescape=True)


def _studio_assets() -> dict[str, Markup]:
    """Return script and style of the studio page."""
    folder = resources.files("sonify.studio") / "templates"
    files = {"studio_script": "studio.js", "studio_style": "studio.css"}
    return {
        name: Markup((folder / file).read_text("utf-8")) for name, file in files.items()
    }
