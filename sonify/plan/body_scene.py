"""Sections of a scene on which the modes of its disk depend."""

from dataclasses import dataclass

from dynamics.compliant.law.sections import Contact
from dynamics.disk import Disk, Release
from dynamics.solver_settings import Numerics
from modal.modes import Material, Support
from sonify.scene import Scene


@dataclass(frozen=True, kw_only=True)
class BodyScene:
    """Sections of a scene that `modal.eigenmodes` reads.

    `contact` and `release` are None unless the support is the contact. Scenes with
    equal sections have the same modes, so a BodyScene can be a cache key for modes."""

    disk: Disk
    material: Material
    support: Support
    numerics: Numerics
    contact: Contact | None = None
    release: Release | None = None


def body_scene(scene: Scene) -> BodyScene:
    """Return the sections of a scene on which the modes of its disk depend."""
    on_contact = scene.support.kind == "contact"
    return BodyScene(
        disk=scene.disk,
        material=scene.material,
        support=scene.support,
        numerics=scene.numerics,
        contact=scene.contact if on_contact else None,
        release=scene.release if on_contact else None,
    )
