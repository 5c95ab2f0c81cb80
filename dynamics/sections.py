"""The sections of a scene that determine its motion."""

from dataclasses import dataclass, field, fields
from typing import Any

from dynamics.air import Air
from dynamics.compliant.law.sections import Contact, Imperfection, Roughness
from dynamics.disk import Disk, Friction, Release
from dynamics.dissipation import Dissipation
from dynamics.solver_settings import Numerics
from dynamics.surface import AnySurface, Surface


@dataclass(frozen=True, kw_only=True)
class MotionScene:
    """A disk, its release, and everything else that determines its motion.

    `sonify.Scene` adds the sections that concern the sound.

    Attributes
    ----------
    name : str
        Name of the scene.
    disk : Disk
        Size and mass of the disk.
    material : object, optional
        Elastic constants of the disk. Its `loss_factor` is required if the modes of the
        disk are coupled to a vibrating table.
    friction : Friction
        Friction at the contact.
    release : Release
        State at the release.
    surface : AnySurface
        The table.
    dissipation : Dissipation
        Dissipation in addition to friction.
    contact : Contact
        Law of the contact.
    roughness : Roughness, optional
        Roughness of table and edge; by default both are smooth.
    imperfection : Imperfection, optional
        Waviness of table and edge; by default there is none.
    air : Air
        The air and the film under the disk; by default there is no film.
    numerics : Numerics
        Accuracy and limits of the solution.

    Examples
    --------
    >>> from dynamics import Disk, Friction, MotionScene, Release, simulate
    >>> scene = MotionScene(
    ...     disk=Disk(radius=0.0375, thickness=0.012, density=7850.0),
    ...     friction=Friction(mu_static=0.3, mu_dynamic=0.2, arm_nutation=1e-6, arm_pivoting=1e-5),
    ...     release=Release(inclination_deg=5.0, omega=(0.0, 0.0, 15.0)),
    ... )
    >>> scene.surface.kind
    'rigid'
    """

    name: str = "scene"
    disk: Disk
    material: Any = None
    friction: Friction
    release: Release
    surface: AnySurface = field(default_factory=Surface)
    dissipation: Dissipation = field(default_factory=Dissipation)
    contact: Contact = field(default_factory=Contact)
    roughness: Roughness | None = None
    imperfection: Imperfection | None = None
    air: Air = field(default_factory=lambda: Air(film="none"))
    numerics: Numerics = field(default_factory=Numerics)

    @property
    def elastic_edge(self) -> Any:
        """The compliance at the edge of the disk as an elastic body; None if unknown."""
        return None

    def part(self, **sections: Any) -> "MotionScene":
        """Return the scene of a part of the motion.

        Parameters
        ----------
        **sections
            Sections that replace those of this scene. Contradictions between sections
            are not checked.

        Returns
        -------
        MotionScene
            The scene of the part, with the `elastic_edge` of this scene.
        """
        kept = {
            section.name: vars(self)[section.name] for section in fields(MotionScene)
        }
        return _ScenePart(whole=self, **(kept | sections))


def as_motion_scene(scene: Any) -> MotionScene:
    """Convert an object with the attributes of a scene to a MotionScene.

    A MotionScene is returned unchanged. Attributes that are absent or None have their defaults.
    """
    if isinstance(scene, MotionScene):
        return scene
    names = [section.name for section in fields(MotionScene)]
    given = {name: value for name, value in vars(scene).items() if value is not None}
    return MotionScene(**{name: given[name] for name in names if name in given})


@dataclass(frozen=True, kw_only=True)
class _ScenePart(MotionScene):
    """The scene for a part of the motion of the scene `whole`."""

    whole: MotionScene

    @property
    def elastic_edge(self) -> Any:
        """The compliance at the edge of the disk, taken from the whole scene."""
        return self.whole.elastic_edge
