"""Scenes of the tests: those of the package, and the scene `dissipation` with each of its other laws."""

from sonify import load_scene
from sonify.scene import Scene

NO_CONTOUR_FRICTION = "dissipation.contour_moment=0"
LAWS: dict[str, tuple[str, ...]] = {
    "boundary_layer": (
        NO_CONTOUR_FRICTION,
        "dissipation.boundary_layer_viscosity=1.5e-5",
        "dissipation.air_density=1.2",
    ),
    "moffatt": (NO_CONTOUR_FRICTION, "dissipation.air_viscosity=1.8e-5"),
    "power": (
        NO_CONTOUR_FRICTION,
        "dissipation.power_coefficient=4e-9",
        "dissipation.power_exponent=2.5",
    ),
    "viscous": (
        NO_CONTOUR_FRICTION,
        "dissipation.viscous_moment=1e-6",
        "dissipation.viscous_force=1e-3",
        "numerics.time_limit=120",
    ),
}
"""Assignments that give the scene `dissipation` each law."""


def named_scene(name: str) -> Scene:
    """Return a shipped scene, or the scene `dissipation` with a law."""
    if name in LAWS:
        return load_scene("dissipation").replace(*LAWS[name])
    return load_scene(name)
