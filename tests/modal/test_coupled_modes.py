"""Claim: tractions on a patch couple the free modes as springs of the omitted flexibility do.

Source: modal/synthesis/clamped.py. Oracle: one mode on a spring; Cauchy's interlacing; the Hurwitz
zeta function.
"""

from itertools import pairwise

import numpy as np
import pytest
from scipy.special import zeta

from modal.synthesis.clamped import (
    FreeSymmetryClass,
    coupled_modes,
    tail_sum_edges,
    traction_work_on_order,
)


def test_one_mode_and_one_traction_are_a_mass_on_a_spring():
    value, work, flexibility, inertia = 9.0, 2.0, 0.5, 0.3
    rest = np.array([flexibility, inertia, 0.0])[:, None, None]
    free = FreeSymmetryClass(
        values=np.array([value]), work=np.array([[work]]), omitted_flexibility=rest
    )
    square, modes, tractions = coupled_modes(free, 1e9)
    force = work / flexibility
    mass = 1 + force**2 * inertia
    assert square == pytest.approx([(value + work * force) / mass])
    assert abs(modes) == pytest.approx(np.array([[mass**-0.5]]))
    assert tractions == pytest.approx(force * modes)


def test_tractions_raise_frequencies_and_fewer_raise_them_less():
    random = np.random.default_rng(1)
    root = random.normal(size=(3, 3))
    values = np.sort(random.uniform(1, 50, 6))
    work = random.normal(size=(3, 6))
    flexibility = root @ root.T + np.eye(3)

    def squares(count):
        rest = np.zeros((3, count, count))
        rest[0] = flexibility[:count, :count]
        free = FreeSymmetryClass(
            values=values, work=work[:count], omitted_flexibility=rest
        )
        return coupled_modes(free, 1e9)[0]

    found = [values, *map(squares, (1, 2, 3))]
    for fewer, more in pairwise(found):
        assert np.all(more >= fewer - 1e-9)
        # one further traction moves no frequency beyond the next one
        assert np.all(more[:-1] <= fewer[1:] + 1e-9)


def test_only_modes_below_the_limit_are_returned():
    free = FreeSymmetryClass(
        values=np.array([1.0, 4.0, 9.0]),
        work=np.zeros((1, 3)),
        omitted_flexibility=np.array([1.0, 0.0, 0.0])[:, None, None],
    )
    assert coupled_modes(free, 5.0)[0] == pytest.approx([1.0, 4.0])


def test_the_work_of_tractions_is_the_product_of_their_factors():
    around = np.array([[2.0, 3.0], [5.0, 7.0]])
    through = np.array([[[1.0, 10.0]], [[100.0, 1000.0]]])
    expected = [[2, 20, 0, 0], [3, 30, 0, 0], [0, 0, 500, 5000], [0, 0, 700, 7000]]
    assert traction_work_on_order(around, through).tolist() == expected


@pytest.mark.parametrize("angle", [0.02, 0.3])
def test_the_midpoint_rule_sums_over_the_orders(angle):
    first, span = 30.5, 2000.0
    edges = tail_sum_edges(first, angle, span)
    middle, width = (edges[1:] + edges[:-1]) / 2, np.diff(edges)
    assert edges[0] == first
    assert edges[-1] >= first + span - max(1.0, 0.3 / angle)
    assert np.all(width <= max(1.0, 0.3 / angle) + 1e-9)
    exact = zeta(2, first + 0.5) - zeta(2, edges[-1] + 0.5)
    assert np.sum(width / middle**2) == pytest.approx(exact, rel=1e-3)
