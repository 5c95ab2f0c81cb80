"""Compute the elastic modes of a disk by the method appropriate to its support."""

from math import pi, radians
from typing import Any, Protocol

from modal import patch, spring_supported
from modal.blas_threads import one_blas_thread
from modal.elements.elastic import estimated_mode_count
from modal.mesh.sector import patch_edge
from modal.mesh.symmetry import check_no_rigid_motion
from modal.modes import (
    DEFAULT_HIGHEST_FREQUENCY,
    Material,
    Modes,
    Support,
    UnsolvableError,
)
from modal.spectral import axisymmetric
from modal.spectral.basis import Plate

MAX_MODE_COUNT = 600
"""Maximum number of modes; more would take minutes to compute and hours to render."""


def disk_density(disk: Any) -> float:
    """Return the density [kg/m^3] of a disk from its mass and volume.

    Raises ValueError for a shell without a wall.
    """
    return disk.mass / (
        pi * (disk.radius**2 - inner_radius(disk) ** 2) * disk.thickness
    )


def inner_radius(disk: Any) -> float:
    """Return the radius [m] of the hole of a disk, or 0 for a solid disk.

    Raises ValueError for a shell without a wall.
    """
    if disk.shape == "solid":
        return 0.0
    if not disk.wall:
        raise ValueError(
            f"disk.shape = {disk.shape!r}: elastic modes require disk.wall, "
            "the radial thickness of its wall, or disk.shape = 'solid'"
        )
    return disk.radius - disk.wall


def check_solvable(disk: Any, support: Support) -> None:
    """Raise ValueError if the solvers are not applicable to the disk on this support.

    Reasons are a shell without a wall, a long thin rod, a shell with a support other
    than "free", a patch taller than the disk, and held components that do not prevent
    all rigid-body motions.
    """
    max_aspect = 50  # ratio of thickness to radius
    inner_radius(disk)
    if disk.thickness > max_aspect * disk.radius:
        raise ValueError(
            f"disk.thickness = {disk.thickness:g} must not exceed {max_aspect} times disk.radius",
        )
    if support.kind != "free" and disk.shape != "solid":
        raise ValueError(
            f"support.kind = {support.kind!r}: must be 'free' for disk.shape = "
            f"{disk.shape!r}",
        )
    if support.kind == "patch" and (support.height or 0) > disk.thickness:
        raise ValueError(
            f"support.height = {support.height:g} must not exceed disk.thickness = "
            f"{disk.thickness:g}",
        )
    if support.kind == "patch":
        check_no_rigid_motion(
            patch_edge(disk.radius, disk.thickness, support), support.held
        )


class ElasticScene(Protocol):
    """Sections of a scene that `eigenmodes` reads.

    `disk` has radius, thickness [m], mass [kg], shape and, for a shell, wall [m];
    `numerics` has accuracy, which is "draft", "standard" or "reference". For a disk on
    its contact, the sections `contact` and `release` are also required.
    """

    @property
    def disk(self) -> Any: ...
    @property
    def material(self) -> Material: ...
    @property
    def support(self) -> Support: ...
    @property
    def numerics(self) -> Any: ...


@one_blas_thread
def eigenmodes(
    scene: ElasticScene,
    below: float = DEFAULT_HIGHEST_FREQUENCY,
    support: Support | None = None,
) -> Modes:
    """Compute the elastic modes of the disk of a scene.

    Parameters
    ----------
    scene : ElasticScene
        Scene with the sections disk, material, support and numerics.
    below : float, optional
        Exclusive upper limit of the frequencies [Hz].
    support : Support, optional
        Support that replaces that of the scene. A contact moving along the rim excites
        the modes of the free disk, ``Support(kind="free")``.

    Returns
    -------
    Modes
        Elastic modes in ascending order of frequency.

    Raises
    ------
    ValueError
        If the patch is taller than the disk or does not prevent all rigid-body motions,
        if a shell has no wall or a support other than "free", or if `below` is not
        positive.
    UnsolvableError
        If there are more than about 600 modes, if round-off exceeds the lowest modes on
        a small patch, or if the contact that supports the disk is not elastic.

    Examples
    --------
    >>> from sonify import load_scene
    >>> scene = load_scene("published").replace("support.kind=free", "numerics.accuracy=draft")
    >>> eigenmodes(scene, below=15e3).order.tolist()
    [2, 2]
    """
    support = support or scene.support
    if not below > 0:
        raise ValueError(f"below = {below:g} must be a frequency above 0 Hz")
    check_solvable(scene.disk, support)
    plate = free_plate(scene)
    highest = below * (
        patch.FREE_MODE_CUTOFF_RATIO if support.kind == "contact" else 1.0
    )
    count = estimated_mode_count(plate, highest)
    if count > MAX_MODE_COUNT:
        raise UnsolvableError(
            f"disk.radius = {scene.disk.radius:g} m, disk.thickness = {scene.disk.thickness:g} m, "
            f"density = {plate.density:.4g} kg/m^3, material.young = {scene.material.young:.4g} Pa: "
            f"the disk has at least about {count:.0f} modes below {highest:g} Hz, but at most "
            f"{MAX_MODE_COUNT} can be computed; make it smaller, lighter or of a stiffer material, "
            f"or reduce audio.sample_rate"
        )
    accuracy = scene.numerics.accuracy
    if support.kind == "free":
        return axisymmetric.plate_modes(plate, below, accuracy)
    if support.kind == "contact":
        inclination, springs = contact_springs(scene, support)
        return spring_supported.contact_modes(
            plate, springs, inclination, below, accuracy
        )
    return patch.held_modes(plate, support, below, accuracy)


def free_plate(scene: ElasticScene) -> Plate:
    """Return the disk of a scene as a `Plate` with a free edge."""
    disk = scene.disk
    return Plate(
        radius=disk.radius,
        thickness=disk.thickness,
        inner_radius=inner_radius(disk),
        material=scene.material,
        density=disk_density(disk),
    )


def contact_springs(scene: Any, support: Support) -> tuple[float, Any]:
    """Return the inclination [rad] of a disk on its contact and the springs of the
    contact.

    Raises UnsolvableError if the contact has no springs.
    """
    inclination = radians(support.inclination_deg or scene.release.inclination_deg)
    try:
        return inclination, scene.contact.suspension(scene, inclination)
    except ValueError as error:
        raise UnsolvableError(f"support.kind = 'contact': {error}") from None
