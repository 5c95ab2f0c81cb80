"""Web application that lists finished runs, shows their pages and compares two runs.

The studio adds the pages that edit and run scenes.
"""

import json
import re
import socket
from collections.abc import Callable
from mimetypes import guess_type
from pathlib import Path

import uvicorn
from starlette.applications import Starlette
from starlette.exceptions import HTTPException
from starlette.middleware import Middleware
from starlette.middleware.trustedhost import TrustedHostMiddleware
from starlette.requests import Request
from starlette.responses import FileResponse, HTMLResponse, RedirectResponse, Response
from starlette.routing import Route

from sonify.claims.checks import Check
from sonify.report.page import page_assets, templates
from sonify.runtime.files import readable_text
from sonify.scene_errors import InputError

LOOPBACK = ("127.0.0.1", "localhost", "::1")
CONTENT_SECURITY_POLICY = {
    "default-src": "'none'",  # forbid everything that is not listed below
    "script-src": "'unsafe-inline' 'wasm-unsafe-eval' data:",  # audio stretching module
    "worker-src": "data:",  # audio worklet of that module
    "connect-src": "data:",  # WebAssembly code of that module
    "style-src": "'unsafe-inline'",
    "img-src": "'self' data:",
    "media-src": "'self' data:",
    "form-action": "'self'",  # form for the comparison of two runs
    "base-uri": "'none'",
    "frame-ancestors": "'none'",
}
"""Content that a page may load; the page of a run embeds its scripts, styles and
pictures."""
SECURITY_HEADERS = {
    "Content-Security-Policy": "; ".join(
        map(" ".join, CONTENT_SECURITY_POLICY.items())
    ),
    "X-Content-Type-Options": "nosniff",
    "Referrer-Policy": "no-referrer",
}
"""HTTP headers of every response."""


def serve(folder: str | Path, host: str, port: int, note: Callable[[str], object]):
    """Serve the runs in `folder` until interrupted; pass the address to `note`.

    Port 0 selects any free port. Raises InputError if the folder does not exist, or if
    the address or the port is invalid or unavailable."""
    if not Path(folder).is_dir():
        raise InputError(f"{folder}: no such folder; python -m sonify run creates it")
    with listening_socket(host, port) as listening:
        note(address(host, listening))
        run_application(application(folder, host), SECURITY_HEADERS, listening)


def listening_socket(host: str, port: int) -> socket.socket:
    """Return a socket that listens at an address.

    Raises InputError if the port is invalid or unavailable.
    """
    max_port = 65535
    if not 0 <= port <= max_port:
        raise InputError(f"--port = {port}: must be from 0 to {max_port}")
    try:
        return socket.create_server(
            (host, port), family=socket.AF_INET6 if ":" in host else socket.AF_INET
        )
    except OSError as error:
        raise InputError(
            f"--port = {port}: unavailable on {host}: {error.strerror}"
        ) from None


def address(host: str, listening: socket.socket) -> str:
    """Return the address of a listening socket for a browser."""
    return (
        f"http://{f'[{host}]' if ':' in host else host}:{listening.getsockname()[1]}/"
    )


def run_application(app: Starlette, headers: dict[str, str], listening: socket.socket):
    """Serve an application with these headers until interrupted."""
    config = uvicorn.Config(
        app,
        headers=[*headers.items()],
        log_level="warning",
        timeout_graceful_shutdown=1,
    )
    uvicorn.Server(config).run(sockets=[listening])


def application(folder: str | Path, host: str = "127.0.0.1") -> Starlette:
    """Return the web application for the runs in `folder`.

    If `host` is a loopback address, requests with other host names are rejected.
    """
    names = [*LOOPBACK, "[::1]"] if host in LOOPBACK else ["*"]
    return Starlette(
        routes=routes_of_runs(Path(folder).resolve(), "/"),
        middleware=[Middleware(TrustedHostMiddleware, allowed_hosts=names)],
    )


def routes_of_runs(root: Path, list_path: str) -> list[Route]:
    """Return the routes for the list of runs in `root`, their files and the
    comparison."""

    def index(request: Request) -> Response:
        return _page(
            "index.html",
            runs=finished_runs(root),
            root=readable_text(root.name),
            style=page_assets()["style"],
        )

    def file(request: Request) -> Response:
        return file_response(request, root)

    def compare(request: Request) -> Response:
        names = [request.query_params.get(which, "") for which in "ab"]
        pages = [path_inside(root, name) / "report.html" for name in names]
        data = [embedded_run_data(page) for page in pages]
        return _page("compare.html", names=names, data=data, **page_assets())

    return [
        Route(list_path, index),
        Route("/compare", compare),
        Route("/runs/{path:path}", file),
    ]


def file_response(request: Request, root: Path) -> Response:
    """Return the file in `root` named in a request; for the folder of a run, its
    page."""
    path = path_inside(root, request.path_params["path"])
    if path.is_dir():
        if not request.url.path.endswith("/"):
            return RedirectResponse(f"{request.url.path}/")
        path /= "report.html"
    if not path.is_file():
        raise HTTPException(404, "no such file")
    return FileResponse(
        path, media_type=guess_type(path.name)[0] or "application/octet-stream"
    )


def path_inside(root: Path, name: str) -> Path:
    """Return the path of `name` in `root`.

    Raises HTTPException 404 for hidden files and for paths that lead outside `root`.
    """
    try:
        path = (root / name).resolve()
        hidden = any(part.startswith(".") for part in Path(name).parts)
        if path.is_relative_to(root) and path.exists() and not hidden:
            return path
    except (OSError, ValueError):  # the name is too long or contains a null character
        pass
    raise HTTPException(404, "no such file")


def finished_runs(root: Path) -> list[dict]:
    """Return the list entry of every finished run in `root`, newest first."""
    records = [
        path for depth in range(4) for path in root.glob("*/" * depth + "run.json")
    ]
    records.sort(key=lambda path: path.stat().st_mtime, reverse=True)
    return [run for path in records if (run := _run_entry(root, path))]


def _run_entry(root, path):
    """Return the list entry of a run.json, or None if the file is not a readable record
    of a run.

    A folder whose name is not UTF-8 has no address, so that its page is not offered.
    """
    folder = path.parent.relative_to(root).as_posix()
    place = readable_text(folder)
    try:
        record = json.loads(path.read_text(encoding="utf-8"))
        return {
            "place": place,
            "name": record["scene"]["name"],
            "outcome": record["outcome"]["sentence"],
            "headline": record.get("headline", ""),
            "failed": _failed_check_lines(record["checks"]),
            "checks": len(record["checks"]),
            "page": place == folder and (path.parent / "report.html").is_file(),
        }
    except (OSError, ValueError, LookupError, TypeError, RecursionError):
        return None


def _failed_check_lines(checks):
    """Return one line for each failed self-check of a run."""
    failed = []
    for record in checks:
        if not record["passed"]:
            numbers = {
                name: float(record[name]) for name in ("value", "expected", "tolerance")
            }
            check = Check(
                key="",
                name=record["name"],
                source="",
                one_sided=record["one_sided"],
                **numbers,
            )
            failed.append(
                f"{check.name}: {check.value:.4g}, expected {check.expectation}"
            )
    return failed


def embedded_run_data(page: Path) -> str:
    """Return the JSON data embedded in the page of a run.

    Raises HTTPException 404 if the page does not exist or contains no data.
    """
    text = page.read_text(encoding="utf-8") if page.is_file() else ""
    embedded = '<script type="application/json" class="run">(.*?)</script>'
    if data := re.search(embedded, text, re.DOTALL):
        return data[1]
    raise HTTPException(404, "no such run")


def _page(name, **values):
    return HTMLResponse(templates().get_template(name).render(**values))
