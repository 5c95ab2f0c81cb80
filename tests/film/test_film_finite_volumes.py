"""Claim: the compressible film is solved on any mesh without an initial guess, and its relative
power at Lam = 100 is 0.0135.

Source: Reynolds' equation of an isothermal gas. Oracle: finite volumes in polar coordinates; the
flow follows the cells, so that they do not smear it. The pressure of the volumes stays positive at
the contact, and their error falls with the square of the cell size. A worked example had a power of
0.0155, relative to that of incompressible air, 15 % above both methods.
"""

import numpy as np
import pytest
from scipy.sparse import csr_array, diags_array
from scipy.sparse.linalg import spsolve

from benchmarks.methods.rotating_film import (
    RotatingFilmMesh,
    compressible_wedge_response,
)
from dynamics.film.wedge import ROTATION_POWER_COEFFICIENT


def newton_pressure(spread, turned, given):
    """Return the positive pressures (n,) with spread P^2/2 + turned P + given = 0."""
    P = np.ones(len(given))
    step = 1.0
    while np.abs(step).max() > 1e-9:
        step = spsolve(
            (spread @ diags_array(P) + turned).tocsc(),
            -(spread @ P**2 / 2 + given + turned @ P),
        )
        P += np.maximum(step, -0.7 * P)
    return P


def volumes(Lam, n):
    """Return relative power, lift over p pi R^2 and least pressure on n x 2 n volumes.

    The power is relative to that of incompressible air.
    """
    rim = np.tanh(3 * np.linspace(0, 1, n + 1)) / np.tanh(3)
    turn = np.sinh(2.5 * np.linspace(-1, 1, 2 * n + 1))
    turn = np.pi + np.pi * turn / turn[-1]
    r = (rim[1:] + rim[:-1]) / 2
    t = (turn[1:] + turn[:-1]) / 2
    dr = np.diff(rim)
    dt = np.diff(turn)
    ahead = np.diff(t, append=t[0] + 2 * np.pi)
    cell = np.arange(2 * n * n).reshape(n, 2 * n)
    after = np.roll(cell, -1, axis=1)
    entries: list = []

    def enter(row, column, value):
        entries.append([np.ravel(a) for a in np.broadcast_arrays(row, column, value)])

    def matrix():
        row, column, value = (
            np.concatenate(part) for part in zip(*entries, strict=True)
        )
        entries.clear()
        return csr_array((value, (row, column)), (cell.size, cell.size))

    def enter_flow(one, other, flow):
        enter(one, other, flow)
        enter(one, one, -flow)
        enter(other, one, flow)
        enter(other, other, -flow)

    def gap(radius, angle):
        return 1 + radius * np.cos(angle)

    edges = rim[1:-1, None]
    enter_flow(
        cell[:-1], cell[1:], edges * gap(edges, t) ** 3 * dt / np.diff(r)[:, None]
    )
    enter_flow(cell, after, gap(r[:, None], turn[1:]) ** 3 * (dr / r)[:, None] / ahead)
    edge = gap(1.0, t) ** 3 * dt / (1 - r[-1])
    given = np.zeros(cell.size)
    enter(cell[-1], cell[-1], -edge)
    given[cell[-1]] = edge / 2
    spread = matrix()
    far = np.roll(after, -1, axis=1)
    lean = (np.roll(t, -1) - turn[1:]) % (2 * np.pi) / np.roll(ahead, -1)
    carried = (Lam * r * dr)[:, None]
    for row, sign in (
        (cell, 1),
        (after, -1),
    ):  # linear upwind differences
        enter(row, after, sign * carried * (1 + lean))
        enter(row, far, -sign * carried * lean)
    turned = matrix() @ diags_array(gap(r[:, None], t).ravel())
    P = newton_pressure(spread, turned, given)
    excess = (P.reshape(cell.shape) - 1) * np.diff(rim**2)[:, None] / 2 * dt
    return (
        abs((excess * r[:, None] * np.sin(t)).sum())
        / (Lam * ROTATION_POWER_COEFFICIENT),
        excess.sum() / np.pi,
        P.min(),
    )


@pytest.mark.parametrize(
    ("Lam", "power", "lift"),
    [(1.0, 0.7466, 0.0425), (10.0, 0.2196, 0.431), (100.0, 0.01346, 1.204)],
)
def test_two_methods_have_one_compressible_film(Lam, power, lift):
    """Volumes and elements agree within 1 %; extrapolated volumes match within 0.5 %."""
    coarse, fine = (np.array(volumes(Lam, n)) for n in (30, 60))
    assert fine[2] > 0.5
    assert (4 * fine - coarse)[:2] / 3 == pytest.approx([power, lift], rel=5e-3)
    lifts, powers, _ = compressible_wedge_response(
        [Lam], RotatingFilmMesh(12, nearest=7.0)
    )
    assert [powers[0], lifts[0]] == pytest.approx([power, lift], rel=0.01)


@pytest.mark.parametrize("nearest", [4.0, 5.0, 7.0, 9.0])
def test_the_compressible_film_is_solved_on_every_mesh(nearest):
    """From air at rest, every mesh gives the power within 10 %, however coarse or truncated.

    The part beyond a mesh that ends at exp(-4) of the radius contributes 4 % of the lift.
    """
    for cells in (6, 11):
        lift, power, flow = compressible_wedge_response(
            [100.0], RotatingFilmMesh(cells, nearest=nearest)
        )
        assert power[0] == pytest.approx(0.01346, rel=0.1)
        assert lift[0] == pytest.approx(1.204, rel=0.05 if nearest < 5 else 0.03)
        assert np.abs(flow[:, 0]).max() < 1e-9


@pytest.mark.parametrize(("nearest", "falling"), [(5.0, 0.0), (7.0, 0.5)])
def test_what_leaves_at_the_rim_is_told_by_the_rim_alone(nearest, falling):
    """The flow at the rim does not depend on the continuation of the test waves into the film.

    This also holds on a mesh with stronger numerical diffusion (nearest 5) and for a closing gap.
    """
    mesh = RotatingFilmMesh(6, nearest=nearest)
    P = mesh.steady_rotating_pressure(100.0, falling=falling)
    out = mesh.rim_mass_flow(P, 100.0, falling=falling)
    mesh._waves(3)[mesh._inner] = 0
    np.testing.assert_allclose(
        mesh.rim_mass_flow(P, 100.0, falling=falling), out, atol=1e-9
    )


@pytest.mark.parametrize("falling", [3.0])
def test_so_is_one_that_falls_as_it_turns(falling):
    """A fall increases the lift on every mesh, without an initial guess."""
    lifts = []
    for cells in (8, 12):
        mesh = RotatingFilmMesh(cells, nearest=6.0)
        lifts.append(
            [
                mesh.integral(mesh.steady_rotating_pressure(10.0, falling=f) - 1)
                for f in (0.0, falling)
            ]
        )
    assert lifts[0] == pytest.approx(lifts[1], rel=0.02)
    assert lifts[0][1] > lifts[0][0]
