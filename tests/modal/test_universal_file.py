"""Claim: nodes, cells, units and groups of a universal file are read as they are written.

Source: modal/mesh/universal_file.py, of the universal file format. Oracle: the numbers in the file.
"""

import numpy as np
import pytest

from modal.mesh.universal_file import read_universal_file, real_numbers


def dataset(number, *lines):
    return "\n".join(["    -1", f"{number:6}", *lines, "    -1"]) + "\n"


POINTS = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [5, 5, 5]], float)
UNITS = dataset(164, "         5mm", "  1.0D+03  1.0D+00  1.0D+00", "  0.0D+00")
NODES = dataset(
    2411,
    *(
        line
        for label, point in zip((10, 11, 12, 13, 99), POINTS, strict=True)
        for line in (f"{label} 1 1 11", " ".join(f"{1e3 * x:.6E}" for x in point))
    ),
)
CELLS = dataset(
    2412,
    "7 111 1 1 7 4",
    "10 11 12 13",
    "8 21 1 1 7 2",  # a beam, which has one record more
    "0 1 1",
    "10 99",
    "9 91 1 1 7 3",
    "10 11 12",
)
GROUPS = dataset(2477, "1 0 0 0 0 0 0 3", "feet", "8 9 0 0 7 10 0 0", "7 12 0 0")


def read(tmp_path, *parts):
    path = tmp_path / "mesh.unv"
    path.write_text("".join(parts))
    return read_universal_file(path)


def test_a_mesh_in_millimetres_is_read_in_metres(tmp_path):
    mesh = read(tmp_path, UNITS, NODES, CELLS, GROUPS)
    assert mesh.points == pytest.approx(POINTS)
    assert [(block.type, block.data.tolist()) for block in mesh.cells] == [
        ("tetra", [[0, 1, 2, 3]]),
        ("triangle", [[0, 1, 2]]),
    ]
    assert mesh.point_sets["feet"].tolist() == [0, 2]
    assert [rows.tolist() for rows in mesh.cell_sets["feet"]] == [[], [0]]


def test_without_units_the_numbers_are_metres(tmp_path):
    assert read(tmp_path, NODES, CELLS).points == pytest.approx(1e3 * POINTS)


def test_exponents_begin_with_e_or_d():
    assert real_numbers(" 1.5D-01 2E2 -3d0") == [0.15, 200.0, -3.0]
