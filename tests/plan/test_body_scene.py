"""Claim: the sections on which the modes of a disk depend are a key of a cache: equal if and only if
the modes are.

Source: sonify/plan/body_scene.py. Oracle: the keys of a scene that modes read.
"""

import pytest

from sonify import load_scene
from sonify.plan.body_scene import body_scene

SCENE = load_scene("published")


@pytest.mark.parametrize(
    "change",
    ["audio.distance=2.0", "friction.mu_static=0.6", "release.inclination_deg=20"],
)
def test_other_sections_do_not_matter(change):
    assert body_scene(SCENE.replace(change)) == body_scene(SCENE)
    assert hash(body_scene(SCENE.replace(change))) == hash(body_scene(SCENE))


@pytest.mark.parametrize(
    "change", ["disk.radius=0.04", "material.poisson=0.3", "support.half_angle_deg=6"]
)
def test_disk_material_and_support_matter(change):
    assert body_scene(SCENE.replace(change)) != body_scene(SCENE)


def test_the_release_matters_on_a_contact_alone():
    held = SCENE.replace("contact.law=elastic", "support.kind=contact")
    assert body_scene(held) != body_scene(held.replace("release.inclination_deg=20"))
