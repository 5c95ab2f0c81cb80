"""Claim: the picture of the modes shows every mode in perspective and from above, labelled with its
frequency.

Oracle: the coloured pixels in the panels; the area and the volume enclosed by the drawn surface.
"""

from types import SimpleNamespace

import matplotlib.image
import meshio
import numpy as np
import pytest
import skfem

from modal import Body, Material, Plate, Support, plate_modes
from sonify.report.lit_polygons import surface_polygons
from sonify.report.mode_names import rigid_motion_share
from sonify.report.mode_shapes import (
    draw_modes,
    mode_caption,
    outer_and_hole_radius,
    top_face,
)

STEEL = Material(young=195e9, poisson=0.28, loss_factor=3e-4)
DISK = Plate(radius=0.03755, thickness=0.0128, material=STEEL, density=7737.27)


@pytest.fixture(scope="module")
def modes():
    return plate_modes(DISK, 20e3)


@pytest.fixture(scope="module")
def none():
    small = Plate(radius=0.003, thickness=0.001, material=STEEL, density=7737.27)
    return plate_modes(small, 20e3)


def ink(image, rows, columns):
    """Return the fraction of coloured pixels in one part of a picture."""
    height, width = image.shape[:2]
    part = image[
        int(rows[0] * height) : int(rows[1] * height),
        int(columns[0] * width) : int(columns[1] * width),
    ]
    return (part.std(axis=2) > 0.05).mean()


def test_the_picture_has_ink_in_both_panels_of_every_mode(modes, tmp_path):
    draw_modes(modes, tmp_path / "modes.png")
    image = matplotlib.image.imread(tmp_path / "modes.png")[..., :3]
    for column in range(len(modes)):
        for rows in ((0.2, 0.5), (0.5, 1.0)):
            assert ink(image, rows, (column / 5, (column + 1) / 5)) > 0.1, (
                "no colour in a panel"
            )
    assert ink(image, (0.2, 1.0), (0.8, 1.0)) < 0.01, "colour where there is no mode"


GREEN = np.array([44, 160, 44]) / 255
"""Colour of the patch, as RGB."""


def green(modes, path, support):
    """Return the number of pixels in the colour of the patch, in the view from above."""
    draw_modes(modes, path, slanted=False, support=support)
    return (
        np.abs(matplotlib.image.imread(path)[..., :3] - GREEN).max(axis=2) < 0.1
    ).sum()


def test_the_patch_is_drawn_as_wide_as_it_is(modes, tmp_path):
    """Oracle: in every mode, an arc of radius 95 pixels, 5/72 in wide at 100 pixels per inch."""
    path = tmp_path / "modes.png"
    assert green(modes, path, None) == green(modes, path, Support(kind="free")) == 0
    for angle in (2, 5, 40, 180):
        for height in (None, 0.004):
            pixels = green(modes, path, Support(half_angle_deg=angle, height=height))
            assert pixels == pytest.approx(
                len(modes) * 2 * np.deg2rad(angle) * 95 * 500 / 72, rel=0.4
            )


@pytest.mark.parametrize(
    "cell", [skfem.MeshHex1, skfem.MeshTet1, skfem.MeshTet2, skfem.MeshHex2]
)
def test_the_skin_of_a_cube_is_its_six_sides(cell, tmp_path):
    linear = skfem.MeshHex1 if "Hex" in cell.__name__ else skfem.MeshTet1
    cell.from_mesh(linear.init_tensor(*[np.linspace(0, 1, 3)] * 3)).save(
        str(tmp_path / "cube.vtu")
    )
    (block,) = (read := meshio.read(tmp_path / "cube.vtu")).cells
    body = Body(
        points=read.points,
        cells=block.data,
        cell_type=block.type,
        displacement=read.points[None],
    )
    corners = body.points[surface_polygons(body)]
    sides = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]) / 2
    if corners.shape[1] == 4:
        sides += (
            np.cross(corners[:, 2] - corners[:, 0], corners[:, 3] - corners[:, 0]) / 2
        )
    assert np.linalg.norm(sides, axis=1).sum() == pytest.approx(6)


def test_a_hole_is_left_out(modes, tmp_path):
    ring = plate_modes(Plate(**vars(DISK) | {"inner_radius": 0.02}), 20e3)
    assert outer_and_hole_radius(ring) == pytest.approx((0.03755, 0.02), rel=1e-3)
    assert outer_and_hole_radius(modes)[1] == 0
    x, y, _ = top_face(ring, 0, *outer_and_hole_radius(ring))
    assert (np.hypot(x, y).min(), np.hypot(x, y).max()) == pytest.approx(
        (0.02, 0.03755), rel=1e-3
    )
    points = ring.body.points[surface_polygons(ring.body)].mean(axis=1)
    assert np.hypot(*points[:, :2].T).min() > 0.019
    draw_modes(ring, tmp_path / "ring.png")


def test_a_disk_without_modes_says_so(none, tmp_path):
    assert len(none) == 0
    draw_modes(none, tmp_path / "none.svg")
    assert "no modes below" in (tmp_path / "none.svg").read_text()


def test_the_modes_of_a_table_are_below_those_of_the_disk(none, tmp_path):
    """Two artificial shapes on a square fill the two lower cells; the third is empty.

    The scale bar is below all cells.
    """
    points = np.stack(np.meshgrid(*[np.linspace(0, 0.4, 21)] * 2), axis=-1).reshape(
        -1, 2
    )
    face = np.array([points[:, 0] - 0.2, points[:, 1] - 0.2])
    draw_modes(
        none,
        tmp_path / "table.png",
        slanted=False,
        table=(points, face, ["1: 100 Hz", "2: 200 Hz"], 2),
    )
    image = matplotlib.image.imread(tmp_path / "table.png")[..., :3]
    shares = [
        ink(image, (0.6, 0.8), (column / 5, (column + 1) / 5)) for column in range(3)
    ]
    assert min(shares[:2]) > 0.3
    assert shares[2] < 0.01


def test_a_stiff_disk_that_turns_about_its_patch_swings():
    """Oracle: a rotation about a point of the rim, and half of it with equal bending added."""
    angle = 2 * np.pi * np.arange(64) / 64
    c = np.cos(angle)
    s = np.sin(angle)
    turned = np.column_stack(
        [-s, 1 - c, 0 * c]
    )  # e_z x (x - e_x), radial and tangential
    bent = np.column_stack([0 * c, 0 * c, np.cos(2 * angle)]) * np.sqrt(
        2 * np.square(turned).sum() / 64
    )
    names = {
        "partner": [-1] * 2,
        "parity": ["even"] * 2,
        "family": ["extensional"] * 2,
        "order": [0] * 2,
    }
    rims = {"rim_angle": angle, "rim_shape": np.array([turned, turned + bent])}
    modes = SimpleNamespace(
        frequency=[800.0, 900.0], decay_rate=[0.0, 0.0], **names, **rims
    )
    assert [rigid_motion_share(modes, i) for i in (0, 1)] == pytest.approx([1, 0.5])
    assert mode_caption(modes, 0, held=True) == "1: 800 Hz\nswing, in plane"
    assert mode_caption(modes, 1, held=True) == "2: 900 Hz\nextensional, order 0"
    assert mode_caption(modes, 0) == "1: 800 Hz\nextensional, order 0"


def test_captions_say_what_a_mode_is(modes):
    assert mode_caption(modes, 0) == "1: 10603 Hz, T60 0.69 s\nflexural, even, order 2"
    silent = SimpleNamespace(
        frequency=modes.frequency,
        decay_rate=0 * modes.decay_rate,
        decay_time=modes.decay_time,
    )
    vars(silent).update(
        parity=modes.parity,
        partner=modes.partner,
        family=modes.family,
        order=modes.order,
    )
    assert "T60" not in mode_caption(silent, 0)
