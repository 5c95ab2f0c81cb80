"""Claim: the cells around a patch fill the disk without folds or gaps, and represent the field at
the patch edge exactly.

Source: at an edge between held and free sides u ~ r^(1/2) (Williams 1952); quarter-point elements
represent it along their sides (Henshell & Shaw 1975, Barsoum 1976), squared ones in the whole cell.
Oracle: sqrt(z) itself; the volume of a cylinder; every side of a cell belongs to two cells or to
the boundary.
"""

from itertools import product

import numpy as np
import pytest
from arithmetic import gamma
from skfem.quadrature import get_quadrature

from modal import Material, Plate, Support
from modal.accuracy import (
    COARSE_DRAFT_MESH,
    COARSE_STANDARD_MESH,
    DRAFT_MESH,
    REFERENCE_COARSE_MESH,
    STANDARD_MESH,
)
from modal.elements.patch import resolving_mesh_size
from modal.elements.sample import (
    locate_in_cells,
    map_from_unit_square,
    quadratic_shape_functions,
)
from modal.mesh.half_disk import MeshSize, half_disk, singular_edge_blocks
from modal.mesh.sector import sector

PLAIN = MeshSize(width=np.pi / 8, depth=0.38, rings=0)


def interpolation_errors(block, power):
    """Return the largest error of the biquadratic interpolant of z^power, and its ratio to
    rounding.

    The points lie on the image of a block, given by its nine nodes as in the cell. The rounding
    includes that of the field and of z times its slope.
    """
    nodes = block(*np.meshgrid([0, 0.5, 1], [0, 0.5, 1], indexing="ij"))
    u, v = np.meshgrid(np.linspace(0.05, 0.95, 7), np.linspace(0.05, 0.95, 7))

    def interpolated(values):
        return np.einsum(
            "abi,abj,ij->ab",
            quadratic_shape_functions(u),
            quadratic_shape_functions(v),
            values,
        )

    corners = nodes @ [1, 1j]
    z = interpolated(corners)
    error = np.abs(interpolated(corners**power) - z**power)
    slope = power * np.abs(z) ** (power - 1)
    rounding = gamma(30) * (
        np.abs(corners**power).max() + slope * np.abs(corners).max()
    )
    return error.max(), (error / rounding).max()


def test_squared_cells_hold_the_square_root_exactly():
    ring = singular_edge_blocks(STANDARD_MESH)[:4]
    inner = singular_edge_blocks(STANDARD_MESH)[4:]
    assert max(interpolation_errors(block, 0.5)[1] for block in inner) < 1
    assert max(interpolation_errors(block, 1)[1] for block in inner) < 1
    assert 1e-3 < max(interpolation_errors(block, 0.5)[0] for block in ring) < 0.03
    assert (
        max(
            interpolation_errors(block, 0.5)[0] for block in singular_edge_blocks(PLAIN)
        )
        > 0.1
    )


def test_squared_cells_touch_the_edge_and_the_sides_it_parts():
    """On the sides of a half turn z is real: free to the right of the edge, held to the left."""
    blocks = singular_edge_blocks(REFERENCE_COARSE_MESH)
    edge = [block(np.zeros(1), np.zeros(1)) for block in blocks]
    assert np.abs(edge).sum(axis=2).min() == 0
    corners = np.concatenate(
        [block(*np.meshgrid([0, 1], [0, 1])).reshape(-1, 2) for block in blocks]
    )
    assert corners[:, 1].min() == pytest.approx(0, abs=gamma(10))
    assert corners[:, 0].min() == -1
    assert corners[:, 0].max() == 1


PATCHES = [
    (5, 0.34, 0.5),
    (39, 0.34, 0.24),
    (180, 1.2, 0.96),
    (3, 0.34, 0.984),
    (10, 0.1, 0.3),
    (0.5, 2, 0.05),
]
DISK = Plate(
    radius=0.03755,
    thickness=0.001,
    material=Material(young=195e9, poisson=0.28),
    density=7739.0,
)
THIN = {
    f"thin, {name}": resolving_mesh_size(size, DISK, 2e4)
    for name, size in (
        ("standard", STANDARD_MESH),
        ("coarse standard", COARSE_STANDARD_MESH),
    )
}
SIZES = {
    "coarse reference": REFERENCE_COARSE_MESH,
    "standard": STANDARD_MESH,
    "coarse standard": COARSE_STANDARD_MESH,
    "draft": DRAFT_MESH,
    "coarse draft": COARSE_DRAFT_MESH,
    **THIN,
}
WHOLE = [
    (1, 0.34, 1),
    (8, 0.05, 1),
    (20, 1, 1),
    (22.5, 0.1, 1),
    (40, 0.1, 1),
    (100, 0.05, 1),
    (150, 0.34, 1),
]


def sectors(half_angle_deg, aspect, share, size):
    for position in ("middle", "bottom")[
        : 1 if share == 1 else 2
    ]:  # over the whole height they are the same
        support = Support(
            half_angle_deg=half_angle_deg, height=share * aspect, position=position
        )
        yield sector(1.0, aspect, support, size)


@pytest.mark.slow
@pytest.mark.parametrize("size", SIZES)
@pytest.mark.parametrize(("half_angle_deg", "aspect", "share"), PATCHES)
def test_every_side_of_a_cell_is_shared_or_lies_on_the_boundary(
    half_angle_deg, aspect, share, size
):
    for part in sectors(half_angle_deg, aspect, share, SIZES[size]):
        mesh = part.mesh
        x, y, z = mesh.p[:, mesh.facets[:, mesh.f2t[1] < 0]]
        on_rim = np.abs(np.hypot(x, y) - 1).max(axis=0) < 1e-9
        on_plane = np.abs(y).max(axis=0) < 1e-9
        levels = (mesh.p[2].min(), mesh.p[2].max())
        on_face = (
            np.min([np.abs(z - level).max(axis=0) for level in levels], axis=0) < 1e-9
        )
        assert (on_rim | on_plane | on_face).all()


LARGE = {((180, 1.2, 0.96), "thin, standard"), ((0.5, 2, 0.05), "thin, standard")}
"""Meshes that need seconds to compute a volume; the slow test suite includes them."""
MESHES = [
    pytest.param(
        *patch, size, marks=[pytest.mark.slow] if (patch, size) in LARGE else []
    )
    for patch, size in product([*PATCHES, *WHOLE], SIZES)
]


@pytest.mark.slow
@pytest.mark.parametrize(("half_angle_deg", "aspect", "share", "size"), MESHES)
def test_no_cell_folds_and_the_volume_is_that_of_the_disk(
    half_angle_deg, aspect, share, size
):
    for part in sectors(half_angle_deg, aspect, share, SIZES[size]):
        points, weights = get_quadrature(part.mesh.elem, 8)
        volume = part.mesh.mapping().detDF(points)
        assert volume.min() > 0
        filled = part.mirror_image_count * (volume @ weights).sum()
        assert filled == pytest.approx(
            np.pi * aspect, rel=4e-3 if size == "coarse draft" else 5e-4
        )


@pytest.mark.slow
@pytest.mark.parametrize("size", SIZES)
@pytest.mark.parametrize("half_angle_deg", [0.1, 5, 20, 45, 107, 150])
def test_every_point_of_a_face_is_found_in_a_cell_that_holds_it(half_angle_deg, size):
    """A point in the wrong cell would have the displacement of another point."""
    cells = half_disk(np.deg2rad(half_angle_deg), SIZES[size])
    places = np.random.default_rng(0).random((len(cells), 20, 2))
    points = map_from_unit_square(cells[:, None], places)[0].reshape(-1, 2)
    cell, place = locate_in_cells(points, cells)
    assert (
        np.abs(
            map_from_unit_square(cells[cell][:, None], place[:, None])[0][:, 0] - points
        ).max()
        < 1e-7
    )
