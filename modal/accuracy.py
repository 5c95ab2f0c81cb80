"""The one table of what an accuracy means for modes; for motion and sound it is that of `dynamics.numerics`."""

from dataclasses import replace
from math import pi
from typing import Any, NamedTuple

from modal.mesh.half_disk import Blocks

COARSE = Blocks(width=pi / 4, depth=0.5, rings=1, lead=0.25, legs=1)
WIDE = Blocks(width=pi / 5, depth=0.5, rings=1, lead=0.4)
ROUGH = Blocks(width=pi / 6, depth=0.45, rings=2)
MIDDLE = Blocks(width=pi / 8, depth=0.38, rings=2)
NARROW = Blocks(width=pi / 10, depth=0.32, rings=4, ratio=0.5)
FINE = Blocks(width=pi / 8, depth=0.38, rings=3, split=2)


class Level(NamedTuple):
    """What one of draft, standard, reference buys.

    free     -- estimated relative error of the frequencies of a free disk; the true one is several times smaller.
    meshes   -- of a held one the mesh whose modes are given, and the coarser one that estimates their errors.
    part     -- the same for a patch over part of the thickness, which needs many more cells.
    richness -- in what synthesis differs from its standard `Richness`, at least.
    table    -- how many unknowns a symmetry class of a meshed table may have, once every cell is cut in eight.
    """

    free: float
    meshes: tuple[Blocks, Blocks]
    part: tuple[Blocks, Blocks]
    richness: dict[str, Any]
    table: int


LEVELS = {
    "draft": Level(
        free=1e-4,
        meshes=(ROUGH, COARSE),
        part=(replace(ROUGH, rings=1), replace(COARSE, rings=0)),
        richness={"size": (9, 6), "around": 4, "through": 3},
        table=20_000,
    ),
    "standard": Level(
        free=3e-6, meshes=(NARROW, WIDE), part=(MIDDLE, replace(COARSE, lead=0.15)), richness={}, table=60_000
    ),
    "reference": Level(
        free=1e-8,
        meshes=(FINE, MIDDLE),
        part=(FINE, MIDDLE),
        richness={"size": (12, 8), "around": 9, "through": 6},
        table=250_000,
    ),
}
