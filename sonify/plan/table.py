"""Plan of the table: its model, its omissions and a check that it can be solved."""

from dataclasses import replace
from pathlib import Path

import numpy as np

from dynamics import Motion
from dynamics.compliant.model_selection import choose_contact_model
from dynamics.compliant.two_way_onset import (
    may_be_two_way,
    must_compute_table_modes,
    reason_against_contact_law,
    reason_against_full_model,
    reason_against_two_way,
    table_modes,
    table_reaction,
)
from dynamics.contact_geometry import contact_position
from dynamics.solver_settings import MAX_AUDIBLE_FREQUENCY
from modal import SurfaceModes, UnsolvableError, surface_modes
from sonify.plan import sentences
from sonify.plan.plan import MIN_MODE_ENERGY_SHARE, Decision, Plan, audible_mode_indices
from sonify.scene import Scene, SceneError
from sonify.sound.sources.tabletop import response_to_unit_jump

MAX_DEFLECTION_RATIO = 0.5
"""Ratio of deflection to thickness above which a plate also stretches and linear theory
fails."""


def check_table(scene: Scene):
    """Raise SceneError before any computation if the table cannot be solved."""
    surface = scene.surface
    what = instead = ""
    if surface.action == "motion":
        what = "surface.action = 'motion'"
        instead = reason_against_two_way(scene) or reason_against_full_model(scene)
    elif scene.imperfection is not None:
        what = "imperfection"
        instead = reason_against_contact_law(scene) or reason_against_full_model(scene)
    if instead:
        raise SceneError(f"{what} with {instead}")
    if surface.kind == "mesh" and not Path(surface.file).is_file():
        raise SceneError(f"surface.file = {surface.file!r}: no such file")


def with_table(plan: Plan, scene: Scene) -> tuple[Plan, SurfaceModes | None]:
    """Return the plan with the model of the table, and all modes of the table.

    The motion uses all these modes, and the sound those of `Plan.sounding_table`. The
    modes are None for a rigid or infinite table. Raises SceneError if they cannot be
    computed."""
    if scene.imperfection:
        plan = without_unknown_predictions(plan, scene).with_additions(
            modelled=[sentences.WAVY_TABLE_MODELLED],
            left_out=[sentences.NO_ERROR_PREDICTION_WITH_TABLE],
        )
    if scene.surface.kind == "rigid":
        plan = with_disk(plan, scene, joins_table=False)
        return plan.with_additions(left_out=[sentences.RIGID_TABLE_NEGLECTED]), None
    if scene.surface.kind == "infinite":
        reason = sentences.INFINITE_ACTION_REASON.format(action=scene.surface.action)
        infinite = Decision(
            subject="table", choice=sentences.TABLE_SOUNDS_ONLY, reason=reason
        )
        plan = with_disk(plan, scene, joins_table=False)
        return plan.with_additions(
            infinite,
            modelled=[sentences.INFINITE_TABLE_MODELLED],
            left_out=[*sentences.TABLE_NEGLECTED, sentences.NEAR_LISTENER_NEGLECTED],
        ), None
    modes = modes_of_table(scene, plan.highest_mode)
    moving_modes = table_modes(
        scene, modes if must_compute_table_modes(scene) else None
    )
    action, joins = table_action(scene, modes if moving_modes is None else moving_modes)
    audible = audible_table_modes(modes, scene, plan.highest_mode)
    plan = replace(plan, sounding_table=tuple(audible.tolist()))
    selection = Decision(
        subject="rendered modes of the table",
        choice=f"{len(audible)} of {(modes.frequency < plan.highest_mode).sum()} below "
        f"{plan.highest_mode:g} Hz; {modes.method}, {modes.unknowns} unknowns",
        reason=sentences.TABLE_MODES_REASON.format(
            range_db=scene.numerics.level.range_db, energy=MIN_MODE_ENERGY_SHARE
        )
        + (sentences.MOTION_USES_ALL_MODES_CLAUSE if joins else ""),
    )
    plan = without_unknown_predictions(plan, scene).with_additions(
        action, selection, modelled=sentences.TABLE_MODELLED[scene.surface.kind]
    )
    neglected = [
        *sentences.TABLE_NEGLECTED[1 if joins else 0 :],
        sentences.NO_ERROR_PREDICTION_WITH_TABLE,
        *deflection_limits(modes, scene),
    ]
    plan = with_disk(plan, scene, joins_table=joins)
    return plan.with_additions(left_out=neglected), modes


def modes_of_table(scene: Scene, highest_audible: float) -> SurfaceModes:
    """Return the modes of the table that motion or sound may use; none for a rigid one.

    The sound uses those below `highest_audible` [Hz], the highest frequency of the plan.
    The motion uses those below MAX_AUDIBLE_FREQUENCY, whatever the sample rate.
    Raises SceneError if they cannot be computed.
    """
    moves = must_compute_table_modes(scene)
    try:
        return surface_modes(
            scene, below=MAX_AUDIBLE_FREQUENCY if moves else highest_audible
        )
    except UnsolvableError as error:
        raise SceneError(str(error)) from None
    except ValueError as error:
        raise SceneError(f"surface: {str(error).removeprefix('surface: ')}") from None


def with_disk(plan: Plan, scene: Scene, joins_table: bool) -> Plan:
    """Return the plan with the model of the disk.

    `joins_table` is True if the motion becomes two-way coupled with the table.
    """
    subject = "disk"
    choice = "rigid in the motion"
    if choose_contact_model(scene).kind == "many":
        if scene.contact.body == "elastic":
            choice = "the free modes of the disk move its edge"
        reason = f"contact anywhere on the rim, contact.body = {scene.contact.body!r}"
        modelled = []
        neglected = [sentences.TABLE_SLOPE_NEGLECTED] if joins_table else []
    elif not joins_table:
        if scene.surface.kind == "rigid":
            subject = "disk and table"
        reason = sentences.RIGID_DISK_REASON.format(kind=scene.surface.kind)
        modelled = [sentences.RIGID_DISK_MODELLED]
        neglected = [f"{sentences.MODAL_REACTION_NEGLECTED}."]
    else:
        motion = sentences.DISK_COUPLED_LATER_MODELLED
        if scene.contact.body == "elastic" and scene.disk.shape == "solid":
            motion += sentences.DISK_MODES_COUPLED_MODELLED
        choice = f"rigid{sentences.UNTIL_TWO_WAY_CLAUSE}"
        reason = motion.removesuffix(".")
        modelled = [motion]
        until = sentences.UNTIL_TWO_WAY_CLAUSE
        neglected = [f"{sentences.MODAL_REACTION_NEGLECTED}{until}."]
    disk = Decision(subject=subject, choice=choice, reason=reason)
    return plan.with_additions(disk, modelled=modelled, left_out=neglected)


def without_unknown_predictions(plan: Plan, scene: Scene) -> Plan:
    """Return the plan without the predictions that are invalid for the table of the
    scene.

    The error of the sound samples is kept for a rough contact, except for a filtered
    contact on a table with modes. The error of the end is removed if the table is wavy
    or may affect the motion."""
    has_modes = scene.surface.kind not in ("rigid", "infinite")
    filtered = has_modes and choose_contact_model(scene).kind == "filter"
    unknown = set()
    if filtered or not scene.roughness:
        unknown.add("sound")
    if may_be_two_way(scene) or scene.imperfection:
        unknown.add("end")
    known = tuple(p for p in plan.predictions if p.key not in unknown)
    return replace(plan, predictions=known)


def table_action(scene: Scene, modes: SurfaceModes) -> tuple[Decision, bool]:
    """Return the decision on two-way coupling with the table, and True if it occurs."""
    action = scene.surface.action
    is_two_way = action == "motion"
    choice = sentences.TABLE_MOVES_AND_SOUNDS
    if action == "motion":
        reason = sentences.MOTION_ACTION_REASON
    elif action == "sound":
        reason = "surface.action = 'sound'"
    else:
        reaction = table_reaction(scene, modes)
        is_two_way = reaction.is_two_way
        reason = f"surface.action = 'auto': {reaction.reason}"
        if reaction.reason_unsolved:
            reason += f", but {reaction.reason_unsolved}"
        if is_two_way and choose_contact_model(scene).kind == "many":
            reason += sentences.FROM_RELEASE_CLAUSE
        elif is_two_way:
            choice = sentences.TABLE_MOVES_BELOW_INCLINATION.format(
                inclination=reaction.inclination
            )
            if scene.contact.law == "rigid":
                choice += sentences.ON_ELASTIC_CONTACT_CLAUSE
    if not is_two_way:
        choice = sentences.TABLE_SOUNDS_ONLY
    return Decision(subject="table", choice=choice, reason=reason), is_two_way


def audible_table_modes(
    modes: SurfaceModes, scene: Scene, below: float = MAX_AUDIBLE_FREQUENCY
) -> np.ndarray:
    """Return the indices (k,) of the table modes below a frequency [Hz] that are audible
    after a force jump."""
    low = np.flatnonzero(modes.frequency < below)
    jump = response_to_unit_jump(modes.select(low), scene)
    return low[audible_mode_indices(*jump, scene.numerics.level.range_db)]


def deflection_limits(modes: SurfaceModes, scene: Scene) -> list[str]:
    """Return a sentence on the stretching of the plate, which linear theory neglects.

    The list is empty if the weight of the disk deflects the plate by less than
    MAX_DEFLECTION_RATIO of its thickness."""
    if scene.surface.kind not in ("plate", "infinite"):
        return []
    thickness = scene.surface.thickness
    deflection = modes.compliance() * scene.disk.weight
    if deflection < MAX_DEFLECTION_RATIO * thickness:
        return []
    return [
        sentences.PLATE_STRETCHING_NEGLECTED.format(
            deflection=1e3 * deflection, thickness=1e3 * thickness
        )
    ]


def table_exit_time(scene: Scene, motion: Motion) -> float | None:
    """Return the time [s] at which the contact first leaves a plate or mesh; None if
    never."""
    surface = scene.surface
    if surface.kind not in ("plate", "mesh"):
        return None
    t = np.linspace(0.0, motion.t[-1], 4096)
    place = contact_position(motion.at(t), scene.disk, motion.rolling_fillet)
    place = place + surface.place
    off = (
        np.hypot(*place.T) > surface.radius
        if surface.kind == "plate"
        else points_off_mesh(surface.file, place)
    )
    return float(t[off.argmax()]) if off.any() else None


def points_off_mesh(file: str, place) -> np.ndarray:
    """Return a mask (k,) of the points (k, 2) [m] outside the top face of the mesh in a
    file."""
    from modal.mesh.read import MAX_TABLE_SIZE, read_checked
    from modal.tabletop.meshed import on_top_face, top_face_triangles  # load slowly

    mesh = read_checked(file, MAX_TABLE_SIZE)
    return ~on_top_face(top_face_triangles(mesh, file), place)
