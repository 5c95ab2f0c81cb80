"""Compute plan, modes and motion of a scene, or raise a SceneError with a one-line
reason."""

from collections.abc import Callable
from dataclasses import replace
from math import inf
from pathlib import Path
from time import perf_counter
from typing import Any

from dynamics import ImpossibleContactError, Motion, MotionPlan, Outcome
from dynamics.progress import MotionProgress
from dynamics.simulation import solve_planned_motion
from modal import Modes, SurfaceModes, UnsolvableError, eigenmodes, with_radiation
from modal.radiation import TOP_FACE
from modal.solve import check_solvable
from sonify.claims.resonance_matching import resonances
from sonify.plan.air import with_air
from sonify.plan.contact import with_contact
from sonify.plan.motion import planned_scene
from sonify.plan.plan import Plan, highest_mode_of, plan_of, with_sounding_modes
from sonify.plan.supports import support_comparison
from sonify.plan.table import solve_table, table_exit_time, with_table
from sonify.runtime.progress import Watch, ignore_progress
from sonify.scene import Scene
from sonify.scene_errors import SceneError
from sonify.sound.audible_modes import response_to_unit_jump


def check_solvable_scene(scene: Scene | str | Path, accuracy: str | None) -> Scene:
    """Return the scene with the given accuracy, after a check that it can be solved.

    Raises SceneError if the table, disk, support, integrator or air film cannot be
    solved."""
    return solvable_scene(scene, accuracy)[0]


def solvable_scene(
    scene: Scene | str | Path, accuracy: str | None
) -> tuple[Scene, MotionPlan]:
    """Return the scene with the given accuracy and the decisions of its motion, after
    `check_solvable_scene`."""
    scene, motion = planned_scene(scene, accuracy)
    check_solvable_disk(scene)
    return scene, motion


def check_solvable_disk(scene: Scene) -> None:
    """Raise SceneError if the modes of the disk cannot be solved on its support."""
    try:
        check_solvable(scene.disk, scene.support)
    except ValueError as error:
        raise SceneError(str(error)) from None


def known_resonances(scene: Scene) -> list[tuple[str, float]]:
    """Return the resonances of a scene with which a recording is compared.

    Raises SceneError if the scene cannot be solved."""
    check_solvable_scene(scene, None)
    try:
        return resonances(scene)
    except ValueError as error:  # too many modes, or an unreadable mesh
        raise SceneError(str(error)) from None


def plan_with_modes(
    scene: Scene,
    eigenmodes: Callable[..., Modes] = eigenmodes,
    motion: MotionPlan | None = None,
) -> tuple[Plan, Modes]:
    """Return the plan, including the selection of audible modes, and the modes of the
    disk.

    `eigenmodes` computes the modes. The decisions of the motion are made here if they are
    not given. Raises SceneError if there are too many modes, if round-off dominates the
    patch, or if there are more measured decay rates than modes.
    """
    plan = plan_of(scene, motion)
    modes = solve_modes(scene, eigenmodes)
    if scene.support.kind == "contact":
        plan = plan.with_additions(support_comparison(scene, modes, plan.highest_mode))
    return with_contact(
        with_sounding_modes(plan, scene, modes, *response_to_unit_jump(modes, scene)),
        scene,
    ), modes


def plan_of_run(
    scene: Scene,
    motion: MotionPlan,
    table: SurfaceModes | None,
    eigenmodes: Callable[..., Modes],
) -> tuple[Plan, Modes]:
    """Return the complete plan of a run and the modes of the disk; see
    `plan_with_modes`."""
    plan, modes = plan_with_modes(scene, eigenmodes, motion)
    return with_table(with_air(plan, scene), scene, table), modes


def solve_modes(scene: Scene, eigenmodes: Callable[..., Modes] = eigenmodes) -> Modes:
    """Return the radiating modes of the disk below the highest frequency of a run.

    See `plan_with_modes`.
    """
    try:
        elastic = eigenmodes(scene, below=highest_mode_of(scene))
    except UnsolvableError as error:
        raise SceneError(str(error)) from None
    return with_measured_damping(
        with_radiation(elastic, (TOP_FACE,), scene.air), scene.material.decay_rates
    )


def with_measured_damping(modes: Modes, measured: tuple[float, ...]) -> Modes:
    """Return the modes with the `measured` decay rates [1/s] assigned to the lowest
    ones."""
    if len(measured) > len(modes):
        raise SceneError(
            f"material.decay_rates: {len(measured)} values, but only {len(modes)} modes were computed"
        )
    return (
        modes.with_decay([*measured, *modes.decay_rate[len(measured) :]])
        if measured
        else modes
    )


def motion_plan_with_table(scene: Scene, motion: MotionPlan) -> MotionPlan:
    """Return the decisions of a motion, completed by those on a table that may act back.

    Raises SceneError if the modes of the table cannot be computed.
    """
    if not motion.lacks_surface_modes:
        return motion
    return motion.with_surface_modes(solve_table(scene, motion))


def solve_motion(motion: MotionPlan, watch: Watch = ignore_progress) -> Motion:
    """Return the motion of a plan.

    It ends at the latest when the contact leaves the table. Raises SceneError if no
    contact force satisfies the balance laws.
    """
    progress = MotionProgress(motion)
    min_interval = 0.05  # s, between two reports of an inclination
    reported = -inf

    def show(t: float, inclination: float, doing: str) -> None:
        nonlocal reported
        now = perf_counter()
        if not doing and now - reported < min_interval:
            return
        reported = now
        note = doing or f"t = {t:.2f} s, inclination {inclination:.2g} rad"
        watch(progress.solved_fraction(t, inclination), note)

    try:
        solved: Any = solve_planned_motion(motion, show)
        if (end := table_exit_time(solved.rolling)) is None:
            return solved
        numerics = replace(motion.scene.numerics, time_limit=end)
        solved = solve_planned_motion(motion.part(numerics=numerics), show)
        return replace(solved, rolling_outcome=Outcome.LEFT_TABLE)
    except ImpossibleContactError as error:
        raise SceneError(f"friction, release: {error}") from None
