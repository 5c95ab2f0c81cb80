"""Make the plan of a motion, or raise a SceneError with a one-line reason.

The import is fast, so that the flows of the motion can be compiled while the other stages
are imported.
"""

from pathlib import Path

from dynamics.motion_plan import MotionPlan, plan_motion
from dynamics.simulation import chosen_integrator
from sonify.scene import Scene, scene_with_accuracy
from sonify.scene_errors import SceneError


def planned_scene(
    scene: Scene | str | Path, accuracy: str | None = None
) -> tuple[Scene, MotionPlan]:
    """Return the scene with the given accuracy, and the decisions of its motion.

    Raises SceneError if the air film, contact, integrator or table of the motion is
    impossible."""
    scene = scene_with_accuracy(scene, accuracy)
    surface = scene.surface
    if surface.kind == "mesh" and not Path(surface.file).is_file():
        raise SceneError(f"surface.file = {surface.file!r}: no such file")
    try:
        chosen_integrator(scene.numerics.integrator)
        return scene, plan_motion(scene)
    except ValueError as error:
        raise SceneError(str(error)) from None
