"""Define VTK's order of the nodes of a hexahedron."""

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
