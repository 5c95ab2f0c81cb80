"""Claim: a plate without a baffle radiates as a dipole at low frequencies, and as solved by others.

Source: sonify/sound/unbaffled.py. Oracles: the closed form 4/(3 pi) k a cos(theta) of a rigid disk,
and boundary elements (tests/references/unbaffled_plate.py), which are about 0.5 dB too loud because
a panel at the edge reaches over it.
"""

import json
from math import pi

import numpy as np
import pytest
from paths import ROOT
from scipy.special import j1

from modal import surface_modes
from sonify import SceneError, load_scene
from sonify.sound.radiation import Listener
from sonify.sound.sources.tabletop import (
    radiation_kernels,
    table_latency,
    table_radiation,
)
from sonify.sound.unbaffled import UnbaffledRatio

REFERENCE = json.loads(
    (ROOT / "tests/references/unbaffled_plate.json").read_text("utf-8")
)
SOUND_SPEED = 343.0
NODE, SHARE = np.polynomial.legendre.leggauss(40)


def disk_grid():
    r = np.repeat((NODE + 1) / 2, 64)
    phi = np.tile(np.arange(64) * 2 * pi / 64, 40)
    return np.column_stack([r * np.cos(phi), r * np.sin(phi)]), np.repeat(
        SHARE / 2, 64
    ) * r


def rectangle_grid():
    x, y = np.meshgrid(NODE, NODE * 2 / 3)
    return np.column_stack([x.ravel(), y.ravel()]), np.outer(SHARE, SHARE).ravel()


def level(grid, size, elevation, shape):
    """Return the level [dB] without a baffle over that in a baffle."""
    points, weights = grid
    direction = np.array([np.cos(elevation), 0.0, np.sin(elevation)])
    edge = UnbaffledRatio(points, weights, direction, SOUND_SPEED)
    wave = weights * shape(*points.T) * np.exp(1j * size * direction[0] * points[:, 0])
    factor = edge.ratio_at(size * SOUND_SPEED / (2 * pi))
    return 20 * np.log10(abs((wave * factor).sum() / wave.sum()))


@pytest.mark.parametrize("elevation_deg", [20.0, 45.0, 90.0])
@pytest.mark.parametrize("size", [0.02, 0.1, 0.3])
def test_a_rigid_disk_is_a_dipole(size, elevation_deg):
    """The closed form is the limit k a -> 0; its error is of the order of (k a)^2."""
    elevation = np.radians(elevation_deg)
    found = level(disk_grid(), size, elevation, lambda x, y: np.ones_like(x))
    along = size * np.cos(elevation)
    directivity = 2 * j1(along) / along if along > 1e-9 else 1.0
    closed = 4 / (3 * pi) * size * np.sin(elevation) / directivity
    assert found == pytest.approx(20 * np.log10(closed), abs=0.02 + 6.0 * size**2)


SHAPES = {
    "disk": {
        "piston": lambda x, y: np.ones_like(x),
        "supported": lambda x, y: 1 - 1.2 * (x**2 + y**2) + 0.2 * (x**2 + y**2) ** 2,
        "rocking": lambda x, y: x,
        "saddle": lambda x, y: x**2 - y**2,
    },
    "rectangle": {
        "piston": lambda x, y: np.ones_like(x),
        "bow": lambda x, y: np.cos(pi / 2 * x) * np.cos(pi / 2 * y * 1.5),
    },
}


@pytest.mark.slow
@pytest.mark.parametrize(
    ("outline", "name"), [(o, n) for o, shapes in SHAPES.items() for n in shapes]
)
def test_boundary_elements_agree(outline, name):
    """Within 1 dB up to k a = 3; a table of another outline is stretched to a disk."""
    grid = disk_grid() if outline == "disk" else rectangle_grid()
    elevation = np.radians(REFERENCE["elevation_deg"])
    for size, expected in zip(
        REFERENCE["sizes"][:5], REFERENCE[outline][name], strict=False
    ):
        found = level(grid, size, elevation, SHAPES[outline][name])
        assert found == pytest.approx(expected, abs=1.0)


@pytest.mark.parametrize("frequency", [60.0, 320.0, 2e3, 15e3])
def test_the_kernels_of_an_open_edge_have_its_spectrum(frequency):
    table = surface_modes(load_scene("glass-plate"), 3000.0)
    listener = Listener(distance=0.5, elevation=pi / 4)
    late = table_latency(table, listener, 48000)
    kernel = radiation_kernels(table, listener, 48000, late, baffle=False)
    turn = np.exp(-2j * pi * frequency / 48000 * (np.arange(len(kernel)) - late))
    exact = table_radiation(table, listener, [frequency], baffle=False)[0]
    baffled = table_radiation(table, listener, [frequency])[0]
    assert np.abs(turn @ kernel - exact).max() < 0.02 * np.abs(baffled).max()


def test_an_infinite_plate_cannot_be_without_a_baffle():
    surface = "surface={kind='infinite', thickness=0.02, young=1e10, poisson=0.3, density=600.0}"
    infinite = load_scene("published").replace(surface)
    assert infinite.surface.baffle
    with pytest.raises(
        SceneError, match="baffle = false: an infinite plate is its own baffle"
    ):
        infinite.replace("surface.baffle=false")
