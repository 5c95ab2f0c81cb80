"""Claim: table sound, infinite plate, page and glTF model have the contact at the same
place, the one at which the disk rolls.

Source: dynamics/contact_geometry.py. Oracle: the point of the body at rest, from the solved angular
velocity and central differences of the solved path of the centre; it does not use the shape of the
edge.
"""

from types import SimpleNamespace

import numpy as np
import pytest
from page_arrays import decoded
from scipy.spatial.transform import Rotation

from dynamics import simulate
from dynamics.contact_geometry import centre_height, contact_position, contact_reach
from sonify import load_scene
from sonify.export.disk_frame import contact_points
from sonify.export.model_geometry import body_poses, disk_mesh
from sonify.report.page_data import encoded_contact
from sonify.sound.radiation import listener_of
from sonify.sound.sources.infinite_plate import InfiniteTable
from sonify.sound.sources.tabletop import shapes_at_contact

FILLET = 1.6e-3
TIMES = np.array([0.11, 0.13, 0.17, 0.31])


@pytest.fixture(scope="module")
def rolling():
    """Return a scene with a rounded edge, its states while it rolls, and the place at rest: its
    position on the table, its distance from the centre and the height of the centre [m]."""
    scene = load_scene("published").replace(
        f"contact.fillet={FILLET}", "numerics.time_limit=0.4"
    )
    motion = simulate(scene)
    assert all(name.startswith("roll") for name in motion.regime(TIMES))
    step = 2e-5
    before, after = (motion.at(TIMES + h)[:, 3:5] for h in (-step, step))
    velocity = (after - before) / (2 * step)
    state = motion.at(TIMES)
    a1 = np.column_stack([np.cos(state[:, 0]), np.sin(state[:, 0])])
    a2 = np.column_stack([-a1[:, 1], a1[:, 0]])
    beta = state[:, 1]
    w1, w2, w3 = state[:, 5:8].T
    about_a2 = np.sin(beta) * w2 - np.cos(beta) * w3
    about_a3 = np.cos(beta) * w2 + np.sin(beta) * w3
    height = -np.sum(velocity * a2, axis=1) / w1
    reach = (np.sum(velocity * a1, axis=1) - height * about_a2) / about_a3
    return scene, motion, state, state[:, 3:5] + reach[:, None] * a2, reach, height


def test_the_place_of_the_contact_is_the_one_at_rest(rolling):
    """A sharp edge would be 1.6 mm off."""
    scene, motion, state, place, reach, height = rolling
    assert motion.rolling_fillet == pytest.approx(FILLET, rel=1e-12)
    assert contact_reach(state[:, 1], scene.disk, FILLET) == pytest.approx(
        reach, abs=1e-7
    )
    assert centre_height(state[:, 1], scene.disk, FILLET) == pytest.approx(
        height, abs=1e-6
    )
    assert contact_position(state, scene.disk, FILLET) == pytest.approx(place, abs=1e-7)
    sharp = contact_position(state, scene.disk)
    off = np.linalg.norm(sharp - place, axis=1)
    assert off.min() > 0.3e-3
    flat = contact_reach(1e-6, scene.disk) - contact_reach(1e-6, scene.disk, FILLET)
    assert flat == pytest.approx(FILLET, rel=1e-3)


def test_the_table_is_driven_at_this_place(rolling):
    """The shape of a mode stands for its place: w = x + 2 y."""
    scene, _, state, place, *_ = rolling
    plate = scene.replace(
        "surface={kind='plate',radius=0.15,thickness=0.006,young=7e10,poisson=0.2,density=2500,loss_factor=0.01}"
    )
    middle = np.array([0.01, 0.02])
    modes = SimpleNamespace(place=middle, at=lambda x, y: (x + 2 * y)[:, None])
    shapes = shapes_at_contact(modes, state, plate)
    x, y = (place + middle).T
    assert shapes[:, 0] == pytest.approx(x + 2 * y, abs=1e-6)


def test_the_sound_of_an_infinite_plate_leaves_from_this_place(rolling):
    scene, _, state, place, *_ = rolling
    infinite = scene.replace(
        "surface={kind='infinite',young=7e10,poisson=0.2,density=2500,loss_factor=0.01,thickness=0.006}"
    )
    listener = listener_of(infinite)
    force = np.ones((len(state), 3))
    film = np.zeros((len(state), 5))
    lead = InfiniteTable(infinite, listener).input_channels(force, state, film)[:, 1]
    towards = listener.position[:2] / listener.distance
    samples = place @ towards / listener.air.sound_speed * scene.audio.sample_rate
    assert lead == pytest.approx(samples, abs=1e-3)


def test_models_stand_on_the_table_at_this_place(rolling):
    """The edge of the model consists of 8 chords."""
    scene, _, state, place, _, height = rolling
    on_table = np.column_stack([place, np.zeros(len(place))])
    assert contact_points(state, scene.disk, FILLET) == pytest.approx(
        on_table, abs=1e-6
    )
    centre, quaternion = body_poses(state, scene.disk, FILLET)
    assert centre[:, 1] == pytest.approx(height, abs=1e-6)
    corners = disk_mesh(scene.disk, FILLET).points
    for turn, middle in zip(Rotation.from_quat(quaternion), centre, strict=True):
        low = (turn.apply(corners) + middle)[:, 1].min()
        assert -1e-9 < low < 0.005 * FILLET


def test_the_page_has_the_place_over_the_inclination(rolling):
    _, motion, state, _, reach, height = rolling
    columns = {name: decoded(c) for name, c in encoded_contact(motion).items()}
    for name, expected in (("reach", reach), ("height", height)):
        found = np.interp(state[:, 1], columns["inclination"], columns[name])
        assert found == pytest.approx(expected, abs=1e-6)


def test_the_model_has_no_gap_between_its_strips():
    """Each edge of a closed surface belongs to two triangles."""
    mesh = disk_mesh(load_scene("published").disk, FILLET)
    triangles = np.concatenate(list(mesh.triangles.values()))
    _, same = np.unique(mesh.points.round(9), axis=0, return_inverse=True)
    corners = same.ravel()[triangles]
    edges = np.sort(corners[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2), axis=1)
    _, counts = np.unique(edges, axis=0, return_counts=True)
    assert (counts == 2).all()
