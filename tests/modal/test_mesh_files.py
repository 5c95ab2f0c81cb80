"""Claim: every volume mesh of a common format is read with its named surfaces, whatever its cells; any
other file is refused in one line that says why, and no library writes to the terminal.

Source: the formats of Gmsh, Abaqus and universal files; quadratic shape functions. Oracle: the same
mesh in another format, written by pyuff or by the writers of this file; volumes and areas in closed
form; the exact volume of a quadratic map.
"""

import re
import subprocess
import sys

import meshio
import numpy as np
import pytest
import skfem

from modal import Material, Plate, Support, mesh_modes, plate_modes, write_uff
from modal.mesh.files import read_mesh_file
from modal.mesh.read import MAX_DISK_SIZE, MAX_TABLE_SIZE, read_checked, read_mesh
from modal.mesh.tetrahedra import EDGES, corner_lists, tetrahedra_of_cells

RADIUS = 0.03755
THICKNESS = 0.0128
STEEL = Material(young=195e9, poisson=0.28, loss_factor=3e-4)
FREE = Support(kind="free")


@pytest.fixture(autouse=True)
def silence(capfd, caplog):
    """Fail if a library writes to the terminal or to a log."""
    yield
    assert capfd.readouterr() == ("", "")
    assert not caplog.records


def disk_triangles():
    """Return the points (p, 2) and triangles (t, 3) of a polygon of 32 sides."""
    mesh = skfem.MeshTri.init_circle(3, smoothed=False).scaled(RADIUS)
    return mesh.p.T, mesh.t.T


def disk_wedges(layers=2):
    """Return the points and wedges of a disk in layers, and its lateral quadrilaterals."""
    plane, triangles = disk_triangles()
    heights = np.linspace(-THICKNESS / 2, THICKNESS / 2, layers + 1)
    points = np.vstack(
        [np.column_stack([plane, np.full(len(plane), z)]) for z in heights]
    )
    n = len(plane)
    wedges = np.vstack(
        [np.hstack([triangles + i * n, triangles + (i + 1) * n]) for i in range(layers)]
    )
    rim = skfem.MeshTri(plane.T, triangles.T)
    edges = rim.facets[:, rim.boundary_facets()].T
    sides = np.vstack(
        [np.hstack([edges, edges[:, ::-1] + n]) + i * n for i in range(layers)]
    )
    return points, wedges, sides


def second_order(points, cells, shape):
    """Return points and cells with a node in the middle of each edge."""
    edges = corner_lists(EDGES[shape])
    ends = np.sort(cells[:, edges], axis=2).reshape(-1, 2)
    pairs, place = np.unique(ends, axis=0, return_inverse=True)
    middles = points[pairs].mean(axis=1)
    numbers = len(points) + place.reshape(len(cells), len(edges))
    return np.vstack([points, middles]), np.hstack([cells, numbers])


def disk_tetrahedra():
    """Return points, tetrahedra and the lateral triangles of the disk."""
    points, wedges, _ = disk_wedges()
    points, cells = tetrahedra_of_cells(points, [("wedge", wedges)])
    mesh = skfem.MeshTet(points.T, cells.T)
    radius = np.hypot(*mesh.p[:2, mesh.facets[:, mesh.boundary_facets()]])
    height = np.ptp(mesh.p[2, mesh.facets[:, mesh.boundary_facets()]], axis=0)
    on_rim = (radius > 0.99 * RADIUS).all(axis=0) & (height > 0)
    return points, cells, mesh.facets[:, mesh.boundary_facets()[on_rim]].T


def volume(mesh):
    """Return the volume of a scikit-fem mesh."""
    return skfem.CellBasis(mesh, mesh.elem(), intorder=6).dx.sum()


def surface_area(mesh, facets):
    """Return the area of facets of a mesh."""
    return skfem.FacetBasis(mesh, mesh.elem(), facets=facets).dx.sum()


def rim_area():
    """Return the lateral area of the polygonal disk."""
    return 32 * 2 * RADIUS * np.sin(np.pi / 32) * THICKNESS


def polygon_area():
    """Return the area of the polygon of 32 sides."""
    return 16 * RADIUS**2 * np.sin(np.pi / 16)


ELEMENTARY = {"tetra": 4, "tetra10": 11, "triangle": 2, "triangle6": 9}
"""Number of each cell type in Gmsh files."""


def write_gmsh_41(path, points, blocks, groups, binary=False):
    """Write format 4.1 with every block of cells as an entity of its own.

    `blocks` is a list of dimension, cell type and cells; `groups` gives the name of some blocks.
    """
    tags = list(groups)
    out = [b"$MeshFormat\n4.1 %d 8\n" % binary]
    out += [np.int32(1).tobytes() + b"\n"] if binary else []

    def put(values, kind):
        values = np.atleast_1d(np.asarray(values, kind))
        out.append(
            values.tobytes()
            if binary
            else (" ".join(map(repr, values.tolist())) + "\n").encode()
        )

    out.append(b"$EndMeshFormat\n$PhysicalNames\n%d\n" % len(tags))
    for tag, block in enumerate(tags, 1):
        out.append(f'{blocks[block][0]} {tag} "{groups[block]}"\n'.encode())
    out.append(b"$EndPhysicalNames\n$Entities\n")
    put([sum(dim == d for dim, *_ in blocks) for d in range(4)], "u8")
    for dimension in range(4):
        for i, (dim, *_) in enumerate(blocks):
            if dim == dimension:
                own = [tags.index(i) + 1] if i in groups else []
                put(i + 1, "i4")
                put([-1.0, -1.0, -1.0, 1.0, 1.0, 1.0], "f8")
                put(len(own), "u8")
                if own:
                    put(own, "i4")
                put(0, "u8")
    out.append(b"\n$EndEntities\n$Nodes\n")
    put([1, len(points), 1, len(points)], "u8")
    put([3, 1, 0], "i4")
    put(len(points), "u8")
    put(np.arange(1, len(points) + 1), "u8")
    put(points.ravel(), "f8")
    out.append(b"\n$EndNodes\n$Elements\n")
    count = sum(len(cells) for *_, cells in blocks)
    put([len(blocks), count, 1, count], "u8")
    label = 1
    for i, (dim, kind, cells) in enumerate(blocks):
        if kind == "tetra10":
            cells = cells[:, [0, 1, 2, 3, 4, 5, 6, 7, 9, 8]]
        put([dim, i + 1, ELEMENTARY[kind]], "i4")
        put(len(cells), "u8")
        put(
            np.column_stack([np.arange(label, label + len(cells)), cells + 1]).ravel(),
            "u8",
        )
        label += len(cells)
    out.append(b"\n$EndElements\n")
    path.write_bytes(b"".join(out))


@pytest.mark.parametrize("binary", [False, True])
@pytest.mark.parametrize("order", [1, 2])
def test_gmsh_files_of_which_only_a_part_is_in_groups(tmp_path, binary, order):
    """The groups are a surface; the volume and the other surfaces belong to none, as after SaveAll."""
    points, cells, rim = disk_tetrahedra()
    mesh = skfem.MeshTet(points.T, cells.T)
    others = mesh.facets[:, mesh.boundary_facets()].T[:9]
    kinds = ("tetra", "triangle")
    if order == 2:
        kinds = ("tetra10", "triangle6")
        points, cells = second_order(points, cells, "tetra")
        rim, others = (second_order_triangles(points, cells, t) for t in (rim, others))
    blocks = [(2, kinds[1], others), (2, kinds[1], rim), (3, kinds[0], cells)]
    write_gmsh_41(tmp_path / "disk.msh", points, blocks, {1: "rim"}, binary)
    read = read_mesh(tmp_path / "disk.msh")
    assert volume(read) == pytest.approx(polygon_area() * THICKNESS, rel=1e-12)
    assert list(read.boundaries) == ["rim"]
    assert surface_area(read, read.boundaries["rim"]) == pytest.approx(
        rim_area(), rel=1e-9
    )
    grouped = {0: "other", 1: "rim", 2: "steel"}
    write_gmsh_41(tmp_path / "all.msh", points, blocks, grouped, binary)
    again = read_mesh(tmp_path / "all.msh")
    assert (again.doflocs == read.doflocs).all()
    assert (again.boundaries["rim"] == read.boundaries["rim"]).all()


def second_order_triangles(points, cells, triangles):
    """Return triangles (t, 6) with the nodes in the middle of the edges of tetrahedra."""
    ends = np.sort(cells[:, corner_lists(EDGES["tetra"])], axis=2).reshape(-1, 2)
    middle = dict(
        zip(map(tuple, ends.tolist()), cells[:, 4:].ravel().tolist(), strict=True)
    )
    edges = np.sort(triangles[:, [[0, 1], [1, 2], [2, 0]]], axis=2)
    return np.column_stack(
        [triangles, [[middle[tuple(e)] for e in t] for t in edges.tolist()]]
    )


def test_a_named_surface_of_second_order_holds_its_facets(tmp_path):
    """Volume and surface have the same number of the group, as Gmsh allows."""
    points, cells, rim = disk_tetrahedra()
    points, cells = second_order(points, cells, "tetra")
    rim = second_order_triangles(points, cells, rim)
    meshio.Mesh(
        points,
        [("triangle6", rim), ("tetra10", cells)],
        cell_data={
            "gmsh:physical": [np.full(len(rim), 1), np.full(len(cells), 1)],
            "gmsh:geometrical": [np.full(len(rim), 1), np.full(len(cells), 1)],
        },
        field_data={"rim": np.array([1, 2]), "steel": np.array([1, 3])},
    ).write(tmp_path / "disk.msh", file_format="gmsh22")
    read = read_mesh(tmp_path / "disk.msh")
    assert surface_area(read, read.boundaries["rim"]) == pytest.approx(
        rim_area(), rel=1e-9
    )


@pytest.mark.parametrize(
    "names",
    [("C3D10", "CPS6"), ("c3d10", "cps6"), ("C3D10M", "S6"), ("C3D10HT", "M3D6")],
)
def test_abaqus_files_of_second_order(tmp_path, names):
    points, cells, rim = disk_tetrahedra()
    points, cells = second_order(points, cells, "tetra")
    rim = second_order_triangles(points, cells, rim)
    lines = ["*HEADING", " a disk", "*NODE"]
    lines += [", ".join(map(repr, [i, *x])) for i, x in enumerate(points.tolist(), 1)]
    for kind, elements, first, name in (
        (names[1], rim, 1, "rim"),
        (names[0], cells, 10**6, "all"),
    ):
        lines.append(f"*ELEMENT, type={kind}, ELSET={name}")
        lines += [
            ", ".join(map(str, [i, *e]))
            for i, e in enumerate((elements + 1).tolist(), first)
        ]
    (tmp_path / "disk.inp").write_text("\n".join(lines))
    read = read_mesh(tmp_path / "disk.inp")
    assert volume(read) == pytest.approx(polygon_area() * THICKNESS, rel=1e-12)
    assert surface_area(read, read.boundaries["rim"]) == pytest.approx(
        rim_area(), rel=1e-9
    )


ALONG_EDGES = {
    "tetra10": (118, [0, 4, 1, 5, 2, 6, 7, 8, 9, 3]),
    "wedge15": (113, [0, 6, 1, 7, 2, 8, 12, 13, 14, 3, 9, 4, 10, 5, 11]),
    "hexahedron20": (
        116,
        [0, 8, 1, 9, 2, 10, 3, 11, 16, 17, 18, 19, 4, 12, 5, 13, 6, 14, 7, 15],
    ),
    "tetra": (111, [0, 1, 2, 3]),
    "wedge": (112, [0, 1, 2, 3, 4, 5]),
    "hexahedron": (115, [0, 1, 2, 3, 4, 5, 6, 7]),
    "triangle": (91, [0, 1, 2]),
    "triangle6": (92, [0, 3, 1, 4, 2, 5]),
    "quad": (94, [0, 1, 2, 3]),
}
"""Descriptor of each element of a universal file, and its nodes around and between its layers."""


def write_universal_file(path, points, blocks, groups=None, factor=1.0):
    """Write datasets 164, 2411, 2412 and 2467 in the columns of the format.

    `blocks` is a list of cell type and cells; `groups` gives the labels of elements and nodes by name.
    """
    lines = [
        "    -1",
        "   164",
        f"{1:10d}{'SI':20s}{2:10d}",
        f"{factor:25.17E}{1.0:25.17E}{1.0:25.17E}",
    ]
    lines += [f"{273.15:25.17E}".replace("E", "D"), "    -1", "    -1", "  2411"]
    for i, x in enumerate(points.tolist(), 1):
        lines.append(f"{i:10d}{1:10d}{1:10d}{11:10d}")
        lines.append("".join(f"{v * factor:25.16E}" for v in x).replace("E", "D"))
    lines += [
        "    -1",
        "    -1",
        "  2412",
        f"{900001:10d}{11:10d}{2:10d}{1:10d}{7:10d}{2:10d}",
    ]
    lines += [f"{0:10d}{1:10d}{1:10d}", f"{1:10d}{2:10d}"]
    label = 0
    for kind, cells in blocks:
        descriptor, order = ALONG_EDGES[kind]
        for cell in (cells + 1).tolist():
            label += 1
            lines.append(
                "".join(f"{v:10d}" for v in (label, descriptor, 2, 1, 7, len(cell)))
            )
            nodes = [cell[i] for i in order]
            for start in range(0, len(nodes), 8):
                lines.append("".join(f"{v:10d}" for v in nodes[start : start + 8]))
    lines.append("    -1")
    if groups:
        lines += ["    -1", "  2467"]
        for number, (name, entities) in enumerate(groups.items(), 1):
            lines.append(
                "".join(f"{v:10d}" for v in (number, 0, 0, 0, 0, 0, 0, len(entities)))
            )
            lines.append(name)
            for start in range(0, len(entities), 2):
                pairs = entities[start : start + 2]
                lines.append(
                    "".join(f"{kind:10d}{tag:10d}{0:10d}{0:10d}" for kind, tag in pairs)
                )
        lines.append("    -1")
    path.write_text("\n".join(lines) + "\n")


@pytest.mark.parametrize("factor", [1.0, 1000.0])
@pytest.mark.parametrize("order", [1, 2])
def test_universal_files_with_groups(tmp_path, order, factor):
    """The groups are elements and nodes; factor 1000 is a file in millimetres that states its unit."""
    points, cells, rim = disk_tetrahedra()
    corners = np.unique(rim) + 1
    blocks = [("triangle", rim), ("tetra", cells)]
    if order == 2:
        points, cells = second_order(points, cells, "tetra")
        blocks = [
            ("triangle6", second_order_triangles(points, cells, rim)),
            ("tetra10", cells),
        ]
    groups = {
        "rim": [(8, i) for i in range(1, len(rim) + 1)],
        "nodes of the rim": [(7, i) for i in corners.tolist()],
    }
    write_universal_file(tmp_path / "disk.unv", points, blocks, groups, factor)
    read = read_mesh(tmp_path / "disk.unv")
    assert volume(read) == pytest.approx(polygon_area() * THICKNESS, rel=1e-12)
    for name in groups:
        assert surface_area(read, read.boundaries[name]) == pytest.approx(
            rim_area(), rel=1e-9
        )


@pytest.mark.parametrize("kind", ["wedge15", "hexahedron20", "hexahedron", "wedge"])
def test_universal_files_of_other_solids(tmp_path, kind):
    shape = kind.rstrip("0123456789")
    points, cells, _ = disk_wedges()
    size = polygon_area() * THICKNESS
    if shape == "hexahedron":
        cube = skfem.MeshHex().refined(1).scaled(0.02)
        points = cube.p.T
        cells = cube.t.T[:, [7, 4, 1, 5, 6, 2, 0, 3]]
        size = 0.02**3
    if kind != shape:
        points, cells = second_order(points, cells, shape)
    write_universal_file(tmp_path / "body.unv", points, [(kind, cells)])
    assert volume(read_mesh(tmp_path / "body.unv")) == pytest.approx(size, rel=1e-12)


def test_the_universal_file_of_modes_is_a_mesh_again(tmp_path):
    """pyuff writes the nodes and elements."""
    pytest.importorskip("pyuff", reason="the optional package pyuff is not installed")
    plate = Plate(radius=RADIUS, thickness=THICKNESS, material=STEEL, density=7850.0)
    write_uff(plate_modes(plate, 12e3, "draft"), tmp_path / "modes.uff")
    exact = np.pi * RADIUS**2 * THICKNESS
    assert 0.98 * exact < volume(read_mesh(tmp_path / "modes.uff")) < exact


def mixed_cells():
    """Return the points of a body of a cube, a wedge, a pyramid and a tetrahedron, and its cells."""
    cube = [
        (0, 0, 0),
        (1, 0, 0),
        (1, 1, 0),
        (0, 1, 0),
        (0, 0, 1),
        (1, 0, 1),
        (1, 1, 1),
        (0, 1, 1),
    ]
    points = np.array(
        [*cube, (0.5, 0.5, 1.5), (2, 0, 0), (2, 1, 0), (1.5, -1, 0.5)], float
    )
    blocks = [
        ("hexahedron", np.array([[0, 1, 2, 3, 4, 5, 6, 7]])),
        ("pyramid", np.array([[4, 5, 6, 7, 8]])),
        ("wedge", np.array([[1, 9, 5, 2, 10, 6]])),
        ("tetra", np.array([[1, 9, 5, 11]])),
    ]
    volume_of_body = 1 + 1 / 6 + 1 / 2 + 1 / 6
    slanted = np.linalg.norm(np.cross((-0.5, -1, 0.5), (-1, 0, 1))) / 2
    area_of_wedge = 1 + 1 / 2 + np.sqrt(2)
    area_of_tetrahedron = 2 * np.sqrt(1.25) / 2 + slanted
    area = 4 + 4 * np.sqrt(0.5) / 2 + area_of_wedge + area_of_tetrahedron
    return points, blocks, volume_of_body, area


def shuffled_cells(points, blocks, generator, order):
    """Return points of the body in random order, and its cells, of second order if asked for."""
    number = generator.permutation(len(points))
    shuffled = np.empty_like(points)
    shuffled[number] = points
    blocks = [(kind, number[cells]) for kind, cells in blocks]
    if order == 1:
        return shuffled, blocks
    names = {"hexahedron": 20, "pyramid": 13, "wedge": 15, "tetra": 10}
    complete = []
    for kind, cells in blocks:
        shuffled, whole = second_order(shuffled, cells, kind)
        complete.append((f"{kind}{names[kind]}", whole))
    return shuffled, complete


@pytest.mark.parametrize("seed", range(12))
@pytest.mark.parametrize("order", [1, 2])
def test_cells_of_several_types_become_tetrahedra_that_fit_together(seed, order):
    """Gaps between neighbours would add to the surface; numbers of the nodes decide where cells are
    cut."""
    points, blocks, volume_of_body, area = mixed_cells()
    generator = np.random.default_rng(seed)
    shuffled, blocks = shuffled_cells(points, blocks, generator, order)
    found, cells = tetrahedra_of_cells(shuffled, blocks)
    mesh = (skfem.MeshTet if order == 1 else skfem.MeshTet2)(found.T, cells.T)
    straight = merged(skfem.MeshTet(found.T, cells[:, :4].T))
    assert volume(mesh) == pytest.approx(volume_of_body, rel=1e-12)
    assert surface_area(straight, straight.boundary_facets()) == pytest.approx(
        area, rel=1e-12
    )


def merged(mesh):
    """Return a mesh of tetrahedra with coincident nodes merged."""
    points, number = np.unique(mesh.p.T.round(9), axis=0, return_inverse=True)
    return skfem.MeshTet(points.T, number.ravel()[mesh.t])


@pytest.mark.parametrize("seed", range(4))
def test_curved_cells_keep_their_volume(seed):
    """A quadratic map is exact for quadratic cells, and so is its Jacobian for the volume."""
    points, blocks, _, _ = mixed_cells()
    generator = np.random.default_rng(seed)
    quadratic = 0.02 * generator.standard_normal((3, 3, 3))
    shuffled, complete = shuffled_cells(points, blocks, generator, 2)
    reference, tetrahedra = tetrahedra_of_cells(points, blocks)
    basis = skfem.CellBasis(
        skfem.MeshTet(reference.T, tetrahedra.T), skfem.ElementTetP1(), intorder=6
    )
    x = np.asarray(basis.global_coordinates())
    gradient = np.eye(3)[:, :, None, None] + np.einsum(
        "ijk,kcq->ijcq", quadratic + quadratic.swapaxes(1, 2), x
    )
    exact = (np.linalg.det(gradient.transpose(2, 3, 0, 1)) * basis.dx).sum()
    curved = shuffled + np.einsum("ijk,pj,pk->pi", quadratic, shuffled, shuffled)
    found, cells = tetrahedra_of_cells(curved, complete)
    assert volume(skfem.MeshTet2(found.T, cells.T)) == pytest.approx(exact, rel=1e-12)


@pytest.mark.parametrize("suffix", ["msh", "vtu", "vtk", "inp", "mesh", "unv"])
def test_a_disk_extruded_from_triangles_is_read(tmp_path, suffix):
    """Wedges with a named rim of quadrilaterals, in formats that store names."""
    points, wedges, sides = disk_wedges()
    path = tmp_path / f"disk.{suffix}"
    if suffix == "unv":
        groups = {"rim": [(8, i) for i in range(1, len(sides) + 1)]}
        write_universal_file(path, points, [("quad", sides), ("wedge", wedges)], groups)
    else:
        numbers = [np.ones(len(sides), int), np.full(len(wedges), 2)]
        groups = dict.fromkeys(["gmsh:physical", "gmsh:geometrical"], numbers)
        no_wedges = np.zeros(0, int)
        named = {"rim": [np.arange(len(sides)), no_wedges]} if suffix == "inp" else {}
        meshio.Mesh(
            points,
            [("quad", sides), ("wedge", wedges)],
            cell_sets=named,
            cell_data=groups if suffix == "msh" else {},
            field_data={"rim": np.array([1, 2])},
        ).write(path, **({"file_format": "gmsh22"} if suffix == "msh" else {}))
    read = read_mesh(path)
    assert volume(read) == pytest.approx(polygon_area() * THICKNESS, rel=1e-12)
    if suffix in {"msh", "inp", "unv"}:
        assert surface_area(read, read.boundaries["rim"]) == pytest.approx(
            rim_area(), rel=1e-9
        )


@pytest.mark.parametrize("kind", ["wedge18", "pyramid14"])
def test_complete_second_order_cells_of_gmsh_are_in_its_order(tmp_path, kind):
    """Source: the numbering of nodes in the manual of Gmsh. The middle of each edge is its node."""
    corners = {
        "wedge18": [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (0, 1, 1)],
        "pyramid14": [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0.5, 0.5, 1)],
    }[kind]
    edges = {
        "wedge18": "01 02 03 12 14 25 34 35 45",
        "pyramid14": "01 03 04 12 14 23 24 34",
    }[kind]
    number = {"wedge18": 13, "pyramid14": 14}[kind]
    points = 0.02 * np.array(corners, float)
    points = np.vstack([points, points[corner_lists(edges)].mean(axis=1)])
    points = np.vstack([points, np.zeros((int(kind[-2:]) - len(points), 3))])
    lines = ["$MeshFormat", "2.2 0 8", "$EndMeshFormat", "$Nodes", str(len(points))]
    lines += [" ".join(map(repr, [i, *x])) for i, x in enumerate(points.tolist(), 1)]
    nodes = " ".join(map(str, range(1, len(points) + 1)))
    lines += [
        "$EndNodes",
        "$Elements",
        "1",
        f"1 {number} 2 1 1 {nodes}",
        "$EndElements",
        "",
    ]
    (tmp_path / "cell.msh").write_text("\n".join(lines))
    (block,) = read_mesh_file(tmp_path / "cell.msh").cells
    shape = kind[:-2]
    ends = block.data[0, corner_lists(EDGES[shape])]
    middles = block.data[0, len(corners) : len(corners) + len(ends)]
    assert points[middles] == pytest.approx(points[ends].mean(axis=1), abs=1e-15)


def test_nodes_that_belong_to_no_cell_do_not_count(tmp_path):
    """Centres of arcs and the like; a far one would be the radius of the disk or its top."""
    points, cells, _ = disk_tetrahedra()
    with_more = np.vstack([[(5, 5, 5)], points, [(0, 0, 9)]])
    for number, (all_points, first) in enumerate([(points, 0), (with_more, 1)]):
        meshio.Mesh(all_points, [("tetra", cells + first)]).write(
            tmp_path / f"{number}.vtu"
        )
    given, padded = (read_mesh(tmp_path / f"{number}.vtu") for number in range(2))
    assert (padded.doflocs == given.doflocs).all()


@pytest.mark.parametrize(
    ("size", "largest", "message"),
    [
        (2.2, MAX_TABLE_SIZE, None),
        (19.0, MAX_TABLE_SIZE, None),
        (21.0, MAX_TABLE_SIZE, "its size is 21 m, and at most 20 m .* millimetres"),
        (2.2, MAX_DISK_SIZE, None),
        (22.0, MAX_DISK_SIZE, "its size is 22 m, and at most 5 m .* millimetres"),
        (0.0005, MAX_DISK_SIZE, "its size is 0.0005 m, and at least 0.001 m .* metres"),
    ],
)
def test_only_an_implausible_size_is_taken_for_another_unit(
    tmp_path, size, largest, message
):
    cube = skfem.MeshTet().refined(1).scaled((size, size / 2, size / 70))
    meshio.Mesh(cube.p.T, [("tetra", cube.t.T)]).write(tmp_path / "body.vtu")
    if message is None:
        assert np.ptp(
            read_checked(tmp_path / "body.vtu", largest).p[0]
        ) == pytest.approx(size)
        return
    with pytest.raises(ValueError, match=message):
        read_checked(tmp_path / "body.vtu", largest)


POINTS = np.array([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)], float)


def surface_of_tetrahedron(path, **options):
    meshio.Mesh(POINTS, [("triangle", np.array([[0, 1, 2], [0, 1, 3]]))]).write(
        path, **options
    )


def text(content):
    return lambda path: path.write_text(content)


REFUSED = {
    "absent.msh": (lambda path: None, "no such file"),
    "folder.msh": (lambda path: path.mkdir(), "no such file"),
    "solid.stl": (
        surface_of_tetrahedron,
        "no volume cells, only triangle; mesh the volume",
    ),
    "flat.msh": (
        lambda path: surface_of_tetrahedron(path, file_format="gmsh"),
        "no volume cells, only triangle; mesh the volume",
    ),
    "flat.obj": (surface_of_tetrahedron, "no volume cells, only triangle"),
    "part.step": (text("ISO-10303-21;"), "Could not deduce file format"),
    "disk": (text("a disk"), "Could not deduce file format"),
    "empty.inp": (text(""), "no volume cells; mesh the volume"),
    "odd.inp": (
        text("*NODE\n1, 0.0, 0.0, 0.0\n*ELEMENT, type=C3D77\n1, 1\n"),
        "Element type not available: C3D77",
    ),
    "polydata.vtk": (
        text("# vtk DataFile Version 3.0\ndata\nASCII\nDATASET POLYDATA\n"),
        "not a readable mesh: ",
    ),
    "old.msh": (
        text("$MeshFormat\n1.0 0 8\n$EndMeshFormat\n"),
        "format 1.0 of Gmsh, not 2.2 or 4.1",
    ),
    "parametric.msh": (
        text(
            "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Nodes\n1 1 1 1\n2 1 1 1\n1\n0 0 0 0 0\n$EndNodes\n"
        ),
        "parametric nodes not implemented",
    ),
    "cut.msh": (
        text("$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Nodes\n1 9"),
        "not a readable mesh: ",
    ),
    "empty.unv": (text("    -1\n   151\n    -1\n"), "a universal file without nodes"),
    "solid.unv": (
        text(
            "    -1\n  2411\n         1 1 1 1\n 0.0 0.0 0.0\n    -1\n    -1\n  2412\n 7 117 1 1 1 1\n 1\n    -1\n"
        ),
        "element 7 is a solid of the unknown kind 117",
    ),
    "cubic.msh": (
        lambda path: meshio.Mesh(
            np.random.default_rng(1).random((20, 3)),
            [("tetra20", np.arange(20)[None])],
            cell_data={name: [[1]] for name in ("gmsh:physical", "gmsh:geometrical")},
        ).write(path, file_format="gmsh22"),
        "its cells are tetra20; save tetrahedra, hexahedra, wedges or pyramids",
    ),
}


def test_a_process_that_reads_meshes_says_nothing(tmp_path):
    """Warnings of NumPy and logs without a handler would go to standard error."""
    points, cells, rim = disk_tetrahedra()
    points, cells = second_order(points, cells, "tetra")
    rim = second_order_triangles(points, cells, rim)
    blocks = [(2, "triangle6", rim), (3, "tetra10", cells)]
    write_gmsh_41(tmp_path / "disk.msh", points, blocks, {0: "rim", 1: "steel"})
    surface_of_tetrahedron(tmp_path / "solid.stl")
    program = "\n".join(
        [
            "from modal.mesh.read import read_mesh",
            f"read_mesh({str(tmp_path / 'disk.msh')!r})",
            "try:",
            f"    read_mesh({str(tmp_path / 'solid.stl')!r})",
            "except ValueError:",
            "    pass",
        ]
    )
    done = subprocess.run(
        [sys.executable, "-c", program], capture_output=True, text=True, check=True
    )
    assert (done.stdout, done.stderr) == ("", "")


@pytest.mark.parametrize("name", REFUSED)
def test_other_files_are_refused_in_one_line_with_the_reason(tmp_path, name, capfd):
    make, message = REFUSED[name]
    make(tmp_path / name)
    capfd.readouterr()  # of the writer
    with pytest.raises(ValueError, match=message) as error:
        read_mesh(tmp_path / name)
    sentence = str(error.value)
    assert "\n" not in sentence
    assert sentence.startswith(f"{tmp_path / name}: ")
    if "not a readable mesh" in sentence:
        assert re.search("save the volume mesh as a Gmsh file|no such file", sentence)


def test_orders_of_cells_that_do_not_fit_are_refused(tmp_path):
    points, cells = second_order(POINTS, np.array([[0, 1, 2, 3]]), "tetra")
    points = np.vstack([points, [(1, 1, 1)]])
    blocks = [("tetra10", cells), ("tetra", np.array([[1, 2, 3, 10]]))]
    meshio.Mesh(points, blocks).write(tmp_path / "both.vtu")
    with pytest.raises(
        ValueError, match=r"its cells are tetra and tetra10; save .* either all linear"
    ):
        read_mesh(tmp_path / "both.vtu")


def test_a_name_without_facets_holds_nothing(tmp_path):
    """Gmsh's format 2.2 keeps the names of groups even if all elements are saved without them."""
    points, cells, rim = disk_tetrahedra()
    none = [np.zeros(len(rim), int), np.zeros(len(cells), int)]
    meshio.Mesh(
        points,
        [("triangle", rim), ("tetra", cells)],
        cell_data=dict.fromkeys(["gmsh:physical", "gmsh:geometrical"], none),
        field_data={"rim": np.array([1, 2])},
    ).write(tmp_path / "disk.msh", file_format="gmsh22")
    with pytest.raises(
        ValueError, match="the surface 'rim' contains no complete facet"
    ):
        mesh_modes(tmp_path / "disk.msh", STEEL, 7737.0, Support(), patch="rim")
