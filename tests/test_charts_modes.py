"""Claim: uniform meshes do not resolve the edge of a patch, and linear tetrahedra lock; the methods of `modal` do not.

Source: the edge of a held patch is singular, u ~ r^(1/2). Oracle: frequencies by a different method, and by Ritz.
"""

import pytest

from sonify.charts import modes
from sonify.charts.modes_case import modes_case
from sonify.charts.plain_elements import plain_modes


def test_every_competitor_has_the_same_elasticity():
    modes.prove()


@pytest.mark.parametrize(("kind", "accuracy", "limit"), [("patch", "standard", 0.02), ("free", "standard", 1e-5)])
def test_ours_is_right_at_both_supports(kind, accuracy, limit):
    case = modes_case(kind)
    assert case.error(modes.ours(case, accuracy).values) < limit


def test_linear_tetrahedra_lock():
    case = modes_case("free")
    linear, quadratic = (case.error(plain_modes(case, f"{p} tetrahedra", 3, 2).values) for p in ("P1", "P2"))
    assert linear > modes.WRONG > 10 * quadratic


@pytest.mark.parametrize(("element", "mesh"), [("P2 tetrahedra", (3, 2)), ("Q2 hexahedra", (2, 1))])
def test_uniform_meshes_miss_the_edge_of_the_patch(element, mesh):
    case = modes_case("patch")
    assert case.error(plain_modes(case, element, *mesh).values) > 0.05
