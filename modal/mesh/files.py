"""Read a mesh file with meshio, or report in one sentence why it cannot be read."""

import sys
from collections.abc import Callable
from contextlib import redirect_stderr, redirect_stdout
from itertools import product
from pathlib import Path
from threading import get_ident
from types import FunctionType
from typing import TYPE_CHECKING, TextIO

from modal.mesh.universal_file import read_universal_file

if TYPE_CHECKING:
    import meshio
    import numpy as np


def read_mesh_file(path: str | Path) -> "meshio.Mesh":
    """Return the meshio mesh of a file.

    Gmsh files are recognised by their content, other formats by their suffix. Raises
    ValueError with the reason of the reader.
    """
    path = Path(path)
    if not path.is_file():
        raise ValueError(f"{path}: not a readable mesh: no such file")
    messages = [CapturedStream(sys.stdout), CapturedStream(sys.stderr)]
    try:
        with redirect_stdout(messages[0]), redirect_stderr(messages[1]):
            return reader_of(path)(path)
    except MemoryError:
        raise
    except (
        Exception,
        SystemExit,
    ) as error:  # readers raise errors of any type for broken files
        reason = reason_of(error, messages[0].text)
        raise ValueError(
            f"{path}: not a readable mesh: {reason}; save the volume mesh as a Gmsh file "
            "(.msh), a universal file (.unv), an Abaqus input file (.inp) or .vtu"
        ) from error


def reason_of(error: BaseException, printed: str) -> str:
    """Return the reason of an error of a reader in one line.

    meshio prints the reason and exits if the content does not have the format of the
    suffix.
    """
    if isinstance(error, SystemExit):
        reason = printed
    elif (
        isinstance(error, (ValueError, OSError, ImportError))
        or type(error).__name__ == "ReadError"
    ):
        reason = str(error)
    else:
        reason = f"{type(error).__name__}: {error}"
    return " ".join(reason.split()).rstrip(".;") or "its content is broken"


class CapturedStream:
    """Stream that collects the output of the current thread and forwards that of other
    threads."""

    def __init__(self, stream: TextIO) -> None:
        self._stream = stream
        self._thread = get_ident()
        self.text = ""

    def write(self, text: str) -> int:
        """Collect text of the captured thread, or forward it."""
        if get_ident() != self._thread:
            return self._stream.write(text)
        self.text += text
        return len(text)

    def flush(self) -> None:
        """Flush the stream to which other threads write."""
        self._stream.flush()

    def __getattr__(self, name: str) -> object:
        return getattr(self._stream, name)


def reader_of(path: Path) -> "Callable[[Path], meshio.Mesh]":
    """Return the function that reads a file."""
    import meshio
    from meshio._mesh import topological_dimension

    for kind in ("wedge15", "pyramid13"):  # missing in meshio 5.3
        topological_dimension.setdefault(kind, 3)

    with path.open("rb") as file:
        if file.read(64).lstrip().startswith((b"$MeshFormat", b"$Comments")):
            return read_gmsh
    suffix = path.suffix.lower()
    if suffix in {".unv", ".uff"}:
        return read_universal_file
    return read_abaqus if suffix == ".inp" else meshio.read


def read_gmsh(path: Path) -> "meshio.Mesh":
    """Return the meshio mesh of a Gmsh file.

    meshio refuses format 4.1 if only some entities belong to physical groups, and
    leaves complete wedges and pyramids of second order in the order of Gmsh.
    """
    import meshio

    try:
        mesh = meshio.gmsh.read(path)
    except ValueError:
        mesh = read_gmsh_with_ungrouped_cells(path)
    for block in mesh.cells:
        if order := GMSH_ORDER.get(block.type):
            block.data = block.data[:, order]
    return mesh


GMSH_ORDER = {
    "wedge18": [0, 1, 2, 3, 4, 5, 6, 9, 7, 12, 14, 13, 8, 10, 11, 15, 17, 16],
    "pyramid14": [0, 1, 2, 3, 4, 5, 8, 10, 6, 7, 9, 11, 12, 13],
}
"""Positions in Gmsh's order of the nodes in VTK's order."""


def read_gmsh_with_ungrouped_cells(path: Path) -> "meshio.Mesh":
    """Return the meshio mesh of a Gmsh file of format 4.1 without cell data that exist
    only for some blocks of cells.

    Named groups remain as `cell_sets`. The reader is that of meshio, but creates its
    mesh in another way.
    """
    import meshio
    from meshio.gmsh import _gmsh41
    from meshio.gmsh.main import _read_header

    def mesh_with_complete_data(
        points: "np.ndarray",
        cells: "list[meshio.CellBlock]",
        cell_data: "dict[str, list[np.ndarray]]",
        **others: object,
    ) -> "meshio.Mesh":
        complete = {
            key: data for key, data in cell_data.items() if len(data) == len(cells)
        }
        return meshio.Mesh(points, cells, cell_data=complete, **others)

    with path.open("rb") as file:
        while file.readline().strip() != b"$MeshFormat":
            pass
        version, data_size, is_ascii = _read_header(file)
        if version not in {"4", "4.1"}:
            raise ValueError(f"format {version} of Gmsh, not 2.2 or 4.1")
        names = vars(_gmsh41) | {"Mesh": mesh_with_complete_data}
        read = FunctionType(_gmsh41.read_buffer.__code__, names)
        return read(file, is_ascii, data_size)


def read_abaqus(path: Path) -> "meshio.Mesh":
    """Return the meshio mesh of an Abaqus input file.

    meshio does not know all types of solid and surface elements, and none in lower
    case.
    """
    import meshio
    from meshio.abaqus._abaqus import abaqus_to_meshio_type

    abaqus_to_meshio_type.update(ABAQUS_TYPES)
    lower_case = {name.lower(): kind for name, kind in abaqus_to_meshio_type.items()}
    abaqus_to_meshio_type.update(lower_case)
    return meshio.abaqus.read(path)


ABAQUS_SOLIDS = {
    "4": "tetra",
    "6": "wedge",
    "8": "hexahedron",
    "10": "tetra10",
    "15": "wedge15",
    "20": "hexahedron20",
}
ABAQUS_SIDES = {"3": "triangle", "4": "quad", "6": "triangle6", "8": "quad8"}
ABAQUS_TYPES = {
    f"{prefix}{nodes}{variant}": kind
    for prefix, kinds, variants in (
        ("C3D", ABAQUS_SOLIDS, ("", "H", "I", "R", "P", "T", "RH", "RP", "RT", "HT")),
        ("DC3D", ABAQUS_SOLIDS, ("",)),
        *(
            (prefix, ABAQUS_SIDES, ("", "R"))
            for prefix in ("CPS", "CPE", "CAX", "M3D", "SFM3D", "S", "DS")
        ),
    )
    for (nodes, kind), variant in product(kinds.items(), variants)
} | {"T3D3": "line3"}
"""meshio's cell type of elements of Abaqus and CalculiX, by number of nodes."""
