"""Parts of a run of a scene without its findings; each part is solved when it is first read."""

from dataclasses import dataclass
from functools import cache, cached_property

from dynamics import Motion, MotionPlan, plan_motion
from modal import Modes, SurfaceModes, eigenmodes
from sonify import load_scene
from sonify.plan.plan import Plan
from sonify.plan.preflight import plan_of_run, solve_modes, solve_motion
from sonify.plan.table import solve_table
from sonify.scene import Scene
from sonify.sound.pressure import Sound
from sonify.sound.render import Renderer


@cache
def modes_of_sections(disk, material, support, numerics, below) -> Modes:
    """Return the modes of a patch or a free disk, which depend on no other section."""
    scene = load_scene("published")
    sections = {
        "disk": disk,
        "material": material,
        "support": support,
        "numerics": numerics,
    }
    for name, section in sections.items():
        object.__setattr__(scene, name, section)
    return eigenmodes(scene, below=below)


def remembered_modes(scene: Scene, below: float) -> Modes:
    """Return the result of `eigenmodes`, which is solved once for equal sections."""
    if scene.support.kind == "contact":
        return eigenmodes(scene, below=below)
    sections = scene.disk, scene.material, scene.support, scene.numerics
    return modes_of_sections(*sections, below)


@dataclass
class PreparedRun:
    """Run of a scene."""

    scene: Scene

    @cached_property
    def table(self) -> SurfaceModes | None:
        """Modes of the table, if it has any."""
        return solve_table(self.scene, self._first_motion_plan)

    @cached_property
    def modes(self) -> Modes:
        """Radiating modes of the disk."""
        return solve_modes(self.scene, remembered_modes)

    @cached_property
    def plan(self) -> Plan:
        """Complete plan of the run."""
        return plan_of_run(self.scene, self._motion_plan, self.table, remembered_modes)[
            0
        ]

    @cached_property
    def motion(self) -> Motion:
        """Solved motion."""
        return solve_motion(self._motion_plan)

    @cached_property
    def renderer(self) -> Renderer:
        """Renderer of the sound."""
        return Renderer(
            self.scene,
            self.motion,
            self.modes,
            self.plan.sounding,
            self.plan.max_contact_turn,
            self.plan.rendered_table(self.table),
        )

    @cached_property
    def sound(self) -> Sound:
        """Pressure and stems at the listener."""
        return self.renderer.sound()

    @cached_property
    def _first_motion_plan(self) -> MotionPlan:
        return plan_motion(self.scene)

    @cached_property
    def _motion_plan(self) -> MotionPlan:
        first = self._first_motion_plan
        if first.lacks_surface_modes:
            return first.with_surface_modes(self.table)
        return first
