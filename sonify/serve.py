"""FINISHED RUNS -> BROWSER: a list of them, the page of each, two of them side by side."""

import json
import re
import socket
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
from sonify.report.page import bundle, templates
from sonify.scene_errors import InputError

LOOPBACK = ("127.0.0.1", "localhost", "::1")
LAST_PORT = 65535
CONTENT_SECURITY_POLICY = {
    "default-src": "'none'",  # nothing that is not named below, and nothing from other servers
    "script-src": "'unsafe-inline' 'wasm-unsafe-eval' data:",  # a stretcher of sound: data: module
    "worker-src": "data:",  # its audio worklet
    "connect-src": "data:",  # its machine code
    "style-src": "'unsafe-inline'",
    "img-src": "'self' data:",
    "media-src": "'self' data:",
    "form-action": "'self'",  # the form that compares two runs
    "base-uri": "'none'",
    "frame-ancestors": "'none'",
}
"""What a page may load; the page of a run holds its scripts, styles and pictures itself."""
HEADERS = {
    "Content-Security-Policy": "; ".join(map(" ".join, CONTENT_SECURITY_POLICY.items())),
    "X-Content-Type-Options": "nosniff",
    "Referrer-Policy": "no-referrer",
}
"""Headers of every response."""
RUN = re.compile(r'<script type="application/json" class="run">(.*?)</script>', re.DOTALL)
"""The numbers of a run in its page."""
DEEPEST = 4
"""Runs are sought so many folders down."""


def serve(folder: str | Path, host: str = "127.0.0.1", port: int = 8000, note=print):
    """Serve the runs in `folder` until interrupted; `note(address)` is told where. A port of 0 is
    any that is free.

    Raises InputError if there is no such folder or the port cannot be had.
    """
    if not Path(folder).is_dir():
        raise InputError(
            f"{folder}: no such folder; python -m sonify run makes one with its first run in it"
        )
    if not host:
        raise InputError("--host = '': must be an address; 0.0.0.0 is every one of this machine")
    if not 0 <= port <= LAST_PORT:
        raise InputError(f"--port = {port}: must be from 0 to {LAST_PORT}")
    try:
        listening = socket.create_server(
            (host, port), family=socket.AF_INET6 if ":" in host else socket.AF_INET
        )
    except OSError as error:
        raise InputError(f"--port = {port}: cannot be had on {host}: {error.strerror}") from None
    note(f"http://{f'[{host}]' if ':' in host else host}:{listening.getsockname()[1]}/")
    config = uvicorn.Config(
        application(folder, host),
        headers=[*HEADERS.items()],
        log_level="warning",
        timeout_graceful_shutdown=1,
    )
    with listening:
        uvicorn.Server(config).run(sockets=[listening])


def application(folder: str | Path, host: str = "127.0.0.1") -> Starlette:
    """Return the web application that shows the runs in `folder`; on loopback it answers to no
    other name."""
    root = Path(folder).resolve()

    def index(request: Request) -> Response:
        return _page("index.html", runs=found(root), root=root.name, style=bundle()["style"])

    def file(request: Request) -> Response:
        path = inside(root, request.path_params["path"])
        if path.is_dir() and not request.url.path.endswith("/"):
            return RedirectResponse(f"{request.url.path}/")
        path = path / "report.html" if path.is_dir() else path
        if not path.is_file():
            raise HTTPException(404, "no such file")
        kind = guess_type(path.name)[0] or "application/octet-stream"
        return FileResponse(path, media_type=kind)

    def compare(request: Request) -> Response:
        names = [request.query_params.get(which, "") for which in "ab"]
        pages = [inside(root, name) / "report.html" for name in names]
        data = [numbers(page) for page in pages]
        return _page("compare.html", names=names, data=data, **bundle())

    names = [*LOOPBACK, "[::1]"] if host in LOOPBACK else ["*"]
    return Starlette(
        routes=[Route("/", index), Route("/compare", compare), Route("/runs/{path:path}", file)],
        middleware=[Middleware(TrustedHostMiddleware, allowed_hosts=names)],
    )


def inside(root: Path, name: str) -> Path:
    """Return the path of that name in `root`; whatever lies elsewhere, by dots or by links, does
    not exist: 404."""
    try:
        path = (root / name).resolve()
        hidden = any(part.startswith(".") for part in Path(name).parts)
        if path.is_relative_to(root) and path.exists() and not hidden:
            return path
    except (OSError, ValueError):  # a name that is too long, or has a zero in it
        pass
    raise HTTPException(404, "no such file")


def found(root: Path) -> list[dict]:
    """Return what the list tells of every finished run in `root`, the newest first."""
    records = [path for depth in range(DEEPEST) for path in root.glob("*/" * depth + "run.json")]
    records = sorted(records, key=lambda path: path.stat().st_mtime, reverse=True)
    return [run for run in (_told(root, path) for path in records) if run]


def _told(root, path):
    """What a run.json tells, or nothing if it cannot be read or is that of another program."""
    try:
        record = json.loads(path.read_text(encoding="utf-8"))
        claims = [finding["holds"] for finding in record["findings"]]
        return {
            "place": path.parent.relative_to(root).as_posix(),
            "name": record["scene"]["name"],
            "outcome": record["outcome"]["sentence"],
            "claims": f"{claims.count(True)} of {len(claims)}",
            "failed": _failed(record["checks"]),
            "checks": len(record["checks"]),
            "page": (path.parent / "report.html").is_file(),
        }
    except (OSError, ValueError, LookupError, TypeError, RecursionError):
        return None


def _failed(checks):
    """What is wrong with a run, a sentence for each self-check that failed."""
    failed = []
    for record in checks:
        if not record["passed"]:
            bars = {name: float(record[name]) for name in ("value", "expected", "tolerance")}
            one_sided = record["one_sided"]
            check = Check(key="", name=record["name"], source="", one_sided=one_sided, **bars)
            failed.append(f"{check.name}: {check.value:.4g}, expected {check.expectation}")
    return failed


def numbers(page: Path) -> str:
    """Return the numbers in the page of a run, JSON; 404 if there is no such page or it holds
    none."""
    held = RUN.search(page.read_text(encoding="utf-8")) if page.is_file() else None
    if not held:
        raise HTTPException(404, "no such run, or one whose sound is too long for a page")
    return held[1]


def _page(name, **values):
    return HTMLResponse(templates().get_template(name).render(**values))
