"""Serve a web application on a socket, and files of a folder with safe headers."""

import socket
from mimetypes import guess_type
from pathlib import Path

import uvicorn
from starlette.applications import Starlette
from starlette.exceptions import HTTPException
from starlette.requests import Request
from starlette.responses import FileResponse, RedirectResponse, Response

from sonify.scene_errors import InputError

LOOPBACK = ("127.0.0.1", "localhost", "::1")
CONTENT_SECURITY_POLICY = {
    "default-src": "'none'",  # forbid everything that is not listed below
    "script-src": "'unsafe-inline' 'wasm-unsafe-eval' data:",  # audio stretching module
    "worker-src": "data:",  # audio worklet of that module
    "connect-src": "'self' data:",  # data of runs; WebAssembly code of that module
    "style-src": "'unsafe-inline'",
    "img-src": "'self' data:",
    "media-src": "'self' data:",
    "form-action": "'self'",
    "base-uri": "'none'",
    "frame-ancestors": "'none'",
}
"""Content that a page may load; every page embeds its scripts and styles."""
SECURITY_HEADERS = {
    "Content-Security-Policy": "; ".join(
        map(" ".join, CONTENT_SECURITY_POLICY.items())
    ),
    "X-Content-Type-Options": "nosniff",
    "Referrer-Policy": "no-referrer",
}
"""HTTP headers of every response."""


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


def run_application(app: Starlette, listening: socket.socket) -> None:
    """Serve an application until interrupted."""
    config = uvicorn.Config(
        app,
        headers=[*SECURITY_HEADERS.items()],
        log_level="warning",
        timeout_graceful_shutdown=1,
    )
    uvicorn.Server(config).run(sockets=[listening])


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
