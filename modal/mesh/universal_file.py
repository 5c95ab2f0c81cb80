"""Read a mesh from a universal file (I-deas, Salome, Gmsh).

Source: the universal file format, datasets 15, 164, 781, 2411, 2412, 2435, 2452, 2467
and 2477. Nodes of quadratic elements are numbered along their edges, layer by layer.
"""

from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    import meshio

Dataset = tuple[str, list[str]]
"""Number and lines of a dataset."""

BEAM_DESCRIPTORS = {11, 21, 22, 23, 24}
"""Descriptors of elements with an additional record."""
ELEMENTS = {
    111: ("tetra", range(4)),
    112: ("wedge", range(6)),
    113: ("wedge15", (0, 2, 4, 9, 11, 13, 1, 3, 5, 10, 12, 14, 6, 7, 8)),
    115: ("hexahedron", range(8)),
    116: (
        "hexahedron20",
        (0, 2, 4, 6, 12, 14, 16, 18, 1, 3, 5, 7, 13, 15, 17, 19, 8, 9, 10, 11),
    ),
    118: ("tetra10", (0, 2, 4, 9, 1, 3, 5, 6, 7, 8)),
    **dict.fromkeys((41, 51, 61, 74, 81, 91), ("triangle", range(3))),
    **dict.fromkeys((42, 52, 62, 72, 82, 92), ("triangle", (0, 2, 4))),
    **dict.fromkeys((44, 54, 64, 71, 84, 94), ("quad", range(4))),
    **dict.fromkeys((45, 55, 65, 75, 85, 95), ("quad", (0, 2, 4, 6))),
}
"""meshio's cell type by descriptor, and the positions of its nodes in a record; sides
without the nodes of their edges."""
SOLIDS = range(101, 120)
"""Descriptors of solid elements."""
GROUP_SETS = {"2435", "2452", "2467", "2477"}
"""Datasets that contain named groups of nodes and elements."""


def read_universal_file(path: Path) -> "meshio.Mesh":
    """Return the meshio mesh of a universal file, in metres.

    Raises ValueError if the file has no nodes or an element of unknown form.
    """
    import meshio

    datasets = read_datasets(path)
    labels, points = nodes_of(datasets)
    index = {label: i for i, label in enumerate(labels)}
    cells, place = cells_of(datasets, index)
    point_sets = {}
    cell_sets = {}
    for name, entities in groups_of(datasets):
        nodes = [index[tag] for kind, tag in entities if kind == 7 and tag in index]
        rows: list[list[int]] = [[] for _ in cells]
        for kind, tag in entities:
            if kind == 8 and tag in place:
                block, row = place[tag]
                rows[block].append(row)
        if nodes:
            point_sets[name] = np.array(nodes)
        if any(rows):
            cell_sets[name] = [np.array(found, int) for found in rows]
    return meshio.Mesh(
        points / length_factor(datasets),
        [(kind, np.array(numbers)) for kind, numbers in cells.items()],
        point_sets=point_sets,
        cell_sets=cell_sets,
    )


def read_datasets(path: Path) -> list[Dataset]:
    """Return the number and the lines of each dataset of a file."""
    datasets: list[tuple[str, list[str]]] = []
    lines: list[str] | None = None
    with open(path, encoding="utf-8", errors="replace") as file:
        for line in file:
            if line.strip() != "-1":
                if lines is not None:
                    lines.append(line.rstrip("\n"))
            elif lines is None:
                lines = []
            else:
                if lines:
                    datasets.append((lines[0].strip(), lines[1:]))
                lines = None
    return datasets


def real_numbers(line: str) -> list[float]:
    """Return the numbers of a line; exponents begin with E or D."""
    return [float(word.upper().replace("D", "E")) for word in line.split()]


def nodes_of(datasets: list[Dataset]) -> tuple[list[int], np.ndarray]:
    """Return the labels and the coordinates (p, 3) of the nodes."""
    labels = []
    points = []
    for number, lines in datasets:
        if number in {"781", "2411"}:
            labels += [int(line.split()[0]) for line in lines[::2]]
            points += [real_numbers(line) for line in lines[1::2]]
        elif number == "15":
            labels += [int(line.split()[0]) for line in lines]
            points += [real_numbers(line)[4:] for line in lines]
    if not labels:
        raise ValueError("a universal file without nodes (datasets 15, 781 and 2411)")
    return labels, np.array(points)


def length_factor(datasets: list[Dataset]) -> float:
    """Return the unit of length of the file as a fraction of a metre, inverted."""
    for number, lines in datasets:
        if number == "164":
            return real_numbers(lines[1])[0]
    return 1.0


def cells_of(
    datasets: list[Dataset], index: dict[int, int]
) -> tuple[dict[str, list[list[int]]], dict[int, tuple[int, int]]]:
    """Return the node numbers of the cells by type, and the block and row of each
    element label.

    `index` is the number of each node label. Beams, springs and masses are left out.
    """
    cells: dict[str, list[list[int]]] = {}
    place: dict[int, tuple[int, int]] = {}
    words = [
        word
        for number, lines in datasets
        if number == "2412"
        for line in lines
        for word in line.split()
    ]
    numbers = list(map(int, words))
    start = 0
    while start < len(numbers):
        label, descriptor, *_, count = numbers[start : start + 6]
        start += 9 if descriptor in BEAM_DESCRIPTORS else 6
        nodes = numbers[start : start + count]
        start += count
        if descriptor not in ELEMENTS:
            if descriptor in SOLIDS:
                raise ValueError(
                    f"element {label} is a solid of the unknown kind {descriptor}"
                )
            continue
        kind, order = ELEMENTS[descriptor]
        block = cells.setdefault(kind, [])
        place[label] = (list(cells).index(kind), len(block))
        block.append([index[nodes[i]] for i in order])
    return cells, place


def groups_of(datasets: list[Dataset]) -> list[tuple[str, list[tuple[int, int]]]]:
    """Return the name of each group, and the kind and label of its entities.

    Kind 7 is a node, kind 8 an element.
    """
    groups = []
    for number, lines in datasets:
        if number not in GROUP_SETS:
            continue
        start = 0
        while start < len(lines):
            count = int(lines[start].split()[-1])
            name = lines[start + 1].strip()
            end = start + 2 + (count + 1) // 2
            words = " ".join(lines[start + 2 : end]).split()
            numbers = list(map(int, words))
            groups.append((name, list(zip(numbers[::4], numbers[1::4], strict=True))))
            start = end
    return groups
