"""Compute plan, modes and motion of a scene, or raise a SceneError with a one-line
reason."""

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

from dynamics import ImpossibleContactError, Motion, Outcome, simulate
from dynamics.film.activation import decide_film
from dynamics.simulation import chosen_integrator
from modal import Modes, SurfaceModes, UnsolvableError, eigenmodes, with_radiation
from modal.radiation import TOP_FACE
from modal.solve import check_solvable
from sonify.claims.resonance_matching import resonances
from sonify.plan.contact import with_contact
from sonify.plan.plan import Plan, plan_of, with_sounding_modes
from sonify.plan.supports import support_comparison
from sonify.plan.table import check_table, table_exit_time
from sonify.scene import Scene, SceneError, scene_with_accuracy
from sonify.sound.audible_modes import response_to_unit_jump


def check_solvable_scene(scene: Scene | str | Path, accuracy: str | None) -> Scene:
    """Return the scene with the given accuracy, after a check that it can be solved.

    Raises SceneError if the table, disk, support, integrator or air film cannot be
    solved."""
    scene = scene_with_accuracy(scene, accuracy)
    check_table(scene)
    try:
        check_solvable(scene.disk, scene.support)
        chosen_integrator(scene.numerics.integrator)
        decide_film(scene)
    except ValueError as error:
        raise SceneError(str(error)) from None
    return scene


def known_resonances(scene: Scene) -> list[tuple[str, float]]:
    """Return the resonances of a scene with which a recording is compared.

    Raises SceneError if the scene cannot be solved."""
    check_solvable_scene(scene, None)
    try:
        return resonances(scene)
    except ValueError as error:  # too many modes, or an unreadable mesh
        raise SceneError(str(error)) from None


def plan_with_modes(
    scene: Scene, eigenmodes: Callable[..., Modes] = eigenmodes
) -> tuple[Plan, Modes]:
    """Return the plan, including the selection of audible modes, and the modes of the
    disk.

    `eigenmodes` computes the modes. Raises SceneError if there are too many modes, if
    round-off dominates the patch, or if there are more measured decay rates than modes.
    """
    plan = plan_of(scene)
    try:
        elastic = eigenmodes(scene, below=plan.highest_mode)
    except UnsolvableError as error:
        raise SceneError(str(error)) from None
    modes = with_measured_damping(
        with_radiation(elastic, (TOP_FACE,), scene.air), scene.material.decay_rates
    )
    if scene.support.kind == "contact":
        plan = plan.with_additions(support_comparison(scene, modes, plan.highest_mode))
    return with_contact(
        with_sounding_modes(plan, scene, modes, *response_to_unit_jump(modes, scene)),
        scene,
    ), modes


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


def solve_motion(
    scene: Scene,
    watch: Callable[..., None] = lambda t, inclination, doing: None,
    table: SurfaceModes | None = None,
) -> Motion:
    """Return the motion of a scene on a table with the given modes.

    The motion ends at the latest when the contact leaves the table.

    Raises SceneError if no contact force satisfies the balance laws.
    """
    try:
        motion: Any = simulate(scene, watch, surface_modes=table)
        if (end := table_exit_time(scene, motion)) is None:
            return motion
        motion = simulate(
            scene.replace(f"numerics.time_limit={end}"), watch, surface_modes=table
        )
        return replace(motion, outcome=Outcome.LEFT_TABLE)
    except ImpossibleContactError as error:
        raise SceneError(f"friction, release: {error}") from None
