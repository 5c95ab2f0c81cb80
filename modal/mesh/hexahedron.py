"""Define VTK's order of the nodes of a hexahedron."""

from itertools import product

VTK_HEXAHEDRON27 = list(
    zip(
        map(int, "022002201210121002200211111"),
        map(int, "002200220121012100221102111"),
        map(int, "000022220000222211111111021"),
        strict=True,
    )
)
"""Twice the reference coordinates x, y, z of the nodes, in the order of
VTK_TRIQUADRATIC_HEXAHEDRON: corners, edges, sides and centre."""

HEXAHEDRON_PARTS = [
    [
        VTK_HEXAHEDRON27.index((i + x // 2, j + y // 2, k + z // 2))
        for x, y, z in VTK_HEXAHEDRON27[:8]
    ]
    for i, j, k in product((0, 1), repeat=3)
]
"""Nodes of the eight parts of a hexahedron with 27 nodes, both in VTK's order."""
