"""Decide whether a scene is one to which a printed or recorded number refers."""

from math import isclose

from dynamics import Disk
from dynamics.compliant.law.sections import Contact
from sonify.scene import Scene, load_scene

PAPER_SECTIONS = (
    "disk",
    "friction",
    "dissipation",
    "release",
    "surface",
    "contact",
    "air",
)
"""Sections of a scene that determine the motion in the paper."""
MAX_RELATIVE_DIFFERENCE = 0.02
"""Largest relative difference between the constants of a scene and those of a recording."""


def is_paper_scene(scene: Scene) -> bool:
    """Return True if a scene has the values of (7.1), (7.3) and (7.4)."""
    paper = load_scene("published")
    return all(vars(scene)[name] == vars(paper)[name] for name in PAPER_SECTIONS)


def is_toy_disk(disk: Disk) -> bool:
    """Return True if a disk has the dimensions and the mass of the recorded toy."""
    toy = load_scene("granite").disk
    return disk.shape == toy.shape and _agree_within_tolerance(
        (disk.radius, disk.thickness, disk.mass),
        (toy.radius, toy.thickness, toy.mass),
    )


def is_toy_on_granite(scene: Scene) -> bool:
    """Return True if a scene is the recorded toy on an elastic table of granite."""
    is_elastic = scene.contact.law == "elastic"
    return is_toy_disk(scene.disk) and is_elastic and _is_granite(scene.contact)


def may_lie_on_granite(scene: Scene) -> bool:
    """Return True unless the table of a scene is of a material other than granite.

    A rigid table that does not move has no material."""
    is_rigid = scene.contact.law == "rigid" and scene.surface.kind == "rigid"
    return is_rigid or _is_granite(scene.contact)


def _is_granite(contact: Contact) -> bool:
    """Return True if the table of a contact has the elastic constants of granite."""
    granite = load_scene("granite").contact
    return _agree_within_tolerance(
        (contact.young, contact.poisson), (granite.young, granite.poisson)
    )


def _agree_within_tolerance(
    values: tuple[float, ...], others: tuple[float, ...]
) -> bool:
    """Return True if all values agree within MAX_RELATIVE_DIFFERENCE."""
    pairs = zip(values, others, strict=True)
    return all(isclose(a, b, rel_tol=MAX_RELATIVE_DIFFERENCE) for a, b in pairs)
