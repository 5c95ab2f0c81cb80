"""Divide cells into tetrahedra."""

TETRAHEDRON_PARTS = [
    (0, 4, 6, 7),
    (4, 1, 5, 8),
    (6, 5, 2, 9),
    (7, 8, 9, 3),
    (4, 5, 6, 8),
    (4, 6, 7, 8),
    (5, 6, 8, 9),
    (6, 7, 8, 9),
]
"""Corners of the eight parts of a tetrahedron, numbered by its corners (0 to 3) and
edge midpoints (4 to 9)."""
