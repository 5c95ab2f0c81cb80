"""Plan of the table: its model, its omissions and a check that it can be solved."""

from dataclasses import replace

import numpy as np

from dynamics import MeshSurface, Motion, MotionPlan, PlateSurface
from dynamics.compliant.air_reaction import film_level_change
from dynamics.contact_geometry import contact_position
from dynamics.solver_settings import MAX_AUDIBLE_FREQUENCY
from modal import SurfaceModes, UnsolvableError, surface_modes
from sonify.plan import sentences
from sonify.plan.plan import (
    MIN_MODE_ENERGY_SHARE,
    Decision,
    Plan,
    audible_mode_indices,
    highest_mode_of,
)
from sonify.scene import Scene
from sonify.scene_errors import SceneError
from sonify.sound.sources.tabletop import response_to_unit_jump

MAX_DEFLECTION_RATIO = 0.5
"""Ratio of deflection to thickness above which a plate also stretches and linear theory
fails."""


def has_table_modes(scene: Scene) -> bool:
    """Return True if the table of a scene has modes; a rigid or infinite one has none."""
    return scene.surface.kind not in ("rigid", "infinite")


def with_table(plan: Plan, scene: Scene, modes: SurfaceModes | None) -> Plan:
    """Return the plan with the model of the table.

    The motion uses all `modes`, and the sound those of `Plan.sounding_table`."""
    if scene.imperfection:
        plan = without_unknown_predictions(plan, scene).with_additions(
            modelled=[sentences.WAVY_TABLE_MODELLED],
            left_out=[sentences.NO_ERROR_PREDICTION_WITH_TABLE],
        )
    if scene.surface.kind == "rigid":
        plan = with_disk(plan, scene, joins_table=False)
        return plan.with_additions(left_out=[sentences.RIGID_TABLE_NEGLECTED])
    if scene.surface.kind == "infinite":
        plan = with_disk(plan, scene, joins_table=False)
        return with_rough_table(plan).with_additions(
            infinite_table_action(plan.motion),
            modelled=[sentences.INFINITE_TABLE_MODELLED],
            left_out=[*sentences.TABLE_NEGLECTED, sentences.NEAR_LISTENER_NEGLECTED],
        )
    assert modes is not None
    joins = plan.motion.two_way.is_two_way
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
        table_action(plan.motion),
        selection,
        modelled=sentences.TABLE_MODELLED[scene.surface.kind],
    )
    neglected = [
        *sentences.TABLE_NEGLECTED[1 if joins else 0 :],
        sentences.NO_ERROR_PREDICTION_WITH_TABLE,
        *deflection_limits(modes, scene),
    ]
    plan = with_rough_table(with_disk(plan, scene, joins_table=joins))
    return plan.with_additions(left_out=neglected)


def with_rough_table(plan: Plan) -> Plan:
    """Return the plan with the effect of the table on a rough contact: on its filter, and
    on the motion after a hand-over to time steps."""
    found = plan.motion.rough_table
    if found is None:
        return plan
    is_handed_over = plan.motion.switches_to_two_way
    if is_handed_over:
        handed_over = sentences.ROUGH_HAND_OVER_MODELLED.format(
            inclination=plan.motion.two_way.inclination
        )
        plan = plan.with_additions(modelled=[handed_over])
    if not plan.motion.filter_is_two_way:
        return plan
    modelled = [sentences.ROUGH_TABLE_MODELLED.format(level=found.level_error)]
    neglected = [sentences.ROUGH_TABLE_NEGLECTED, film_reaction_sentence(plan.motion)]
    if found.linear_until and not is_handed_over:
        limit = sentences.LINEAR_TABLE_LIMIT.format(
            inclination=found.linear_until, limit=found.limit
        )
        neglected.append(limit)
    return plan.with_additions(modelled=modelled, left_out=neglected)


def film_reaction_sentence(motion: MotionPlan) -> str:
    """Return a sentence on the neglected reaction of the air, with the largest change of
    level at the inclinations of the plan at which the filter is used and the gap exceeds
    the mean free path."""
    assert motion.rough_table is not None
    inclination = motion.rough_table.inclination
    air = motion.scene.air
    free_path = air.mean_free_path if air.pressure else 0.0
    lowest = free_path / motion.scene.disk.radius
    if motion.switches_to_two_way:
        lowest = max(lowest, motion.two_way.inclination)
    first = inclination[:1]  # the filter is used at the release
    filtered = np.union1d(first, inclination[inclination >= lowest])
    changes = [film_level_change(motion, float(beta)) for beta in filtered]
    return sentences.FILM_REACTION_NEGLECTED.format(change=np.abs(changes).max())


def infinite_table_action(motion: MotionPlan) -> Decision:
    """Return the decision on the coupling of an infinite plate."""
    action = motion.scene.surface.action
    choice = sentences.TABLE_SOUNDS_ONLY
    reason = sentences.INFINITE_ACTION_REASON.format(action=action)
    if motion.rough_table is not None:
        reason = f"surface.action = {action!r}: {motion.rough_table.reason}"
        if motion.two_way.reason_unsolved:
            reason += f", but {motion.two_way.reason_unsolved}"
    if motion.filter_is_two_way:
        choice = sentences.TABLE_YIELDS_AND_SOUNDS
    return Decision(subject="table", choice=choice, reason=reason)


def solve_table(scene: Scene, motion: MotionPlan) -> SurfaceModes | None:
    """Return the modes of the table that motion or sound may use.

    The sound uses those below the highest frequency of the plan. The motion uses those
    below MAX_AUDIBLE_FREQUENCY, whatever the sample rate. The modes are None for a rigid
    or infinite table. Raises SceneError if they cannot be computed.
    """
    if not has_table_modes(scene):
        return None
    moves = motion.lacks_surface_modes
    highest = MAX_AUDIBLE_FREQUENCY if moves else highest_mode_of(scene)
    try:
        return surface_modes(scene, below=highest)
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
    if plan.motion.contact.kind == "many":
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
        neglected = [sentences.MODAL_REACTION_NEGLECTED]
    else:
        choice = sentences.RIGID_UNTIL_TWO_WAY
        reason = sentences.COUPLED_DISK_REASON
        modelled = [sentences.DISK_COUPLED_LATER_MODELLED]
        if scene.contact.body == "elastic" and scene.disk.shape == "solid":
            modelled.append(sentences.DISK_MODES_COUPLED_MODELLED)
        neglected = [sentences.EARLY_MODAL_REACTION_NEGLECTED]
    disk = Decision(subject=subject, choice=choice, reason=reason)
    return plan.with_additions(disk, modelled=modelled, left_out=neglected)


def without_unknown_predictions(plan: Plan, scene: Scene) -> Plan:
    """Return the plan without the predictions that are invalid for the table of the
    scene.

    The error of the sound samples is kept for a rough contact, except for a filtered
    contact on a table with modes. The error of the end is removed if the table is wavy
    or may affect the motion."""
    filtered = has_table_modes(scene) and plan.motion.contact.kind == "filter"
    unknown = set()
    if filtered or not scene.roughness:
        unknown.add("sound")
    if plan.motion.may_be_two_way or scene.imperfection:
        unknown.add("end")
    known = tuple(p for p in plan.predictions if p.key not in unknown)
    return replace(plan, predictions=known)


def table_action(motion: MotionPlan) -> Decision:
    """Return the decision on two-way coupling with the table."""
    action = motion.scene.surface.action
    reaction = motion.two_way
    if action == "motion" and motion.filter_is_two_way:
        reason = f"surface.action = 'motion': {reaction.reason}"
    elif action == "motion":
        reason = sentences.MOTION_ACTION_REASON
    elif action == "sound":
        reason = "surface.action = 'sound'"
    else:
        reason = f"surface.action = 'auto': {reaction.reason}"
        if reaction.reason_unsolved:
            reason += f", but {reaction.reason_unsolved}"
        if reaction.is_two_way and motion.contact.kind == "many":
            reason += sentences.FROM_RELEASE_CLAUSE
    return Decision(subject="table", choice=table_choice(motion), reason=reason)


def table_choice(motion: MotionPlan) -> str:
    """Return what the table does, in words."""
    below = motion.two_way.inclination
    if motion.filter_is_two_way:
        if motion.switches_to_two_way:
            return sentences.TABLE_YIELDS_THEN_MOVES.format(inclination=below)
        return sentences.TABLE_YIELDS_AND_SOUNDS
    if motion.switches_to_two_way:
        choice = sentences.TABLE_MOVES_BELOW_INCLINATION.format(inclination=below)
        is_rigid = motion.contact.kind == "rigid"
        return choice + sentences.ON_ELASTIC_CONTACT_CLAUSE * is_rigid
    if motion.two_way.is_two_way:
        return sentences.TABLE_MOVES_AND_SOUNDS
    return sentences.TABLE_SOUNDS_ONLY


def audible_table_modes(
    modes: SurfaceModes, scene: Scene, below: float = MAX_AUDIBLE_FREQUENCY
) -> np.ndarray:
    """Return the indices (k,) of the table modes below a frequency [Hz] that are audible
    after a force jump."""
    low = np.flatnonzero(modes.frequency < below)
    jump = response_to_unit_jump(modes.select(low), scene)
    return low[audible_mode_indices(*jump, scene.numerics.level.range_db)]


def audible_table(modes: SurfaceModes, scene: Scene) -> SurfaceModes:
    """Return the modes of the table that the sound needs."""
    return modes.select(audible_table_modes(modes, scene, highest_mode_of(scene)))


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


def table_exit_time(motion: Motion) -> float | None:
    """Return the time [s] at which the contact first leaves a plate or mesh; None if
    never."""
    surface = motion.plan.scene.surface
    if not isinstance(surface, PlateSurface | MeshSurface):
        return None
    t = np.linspace(0.0, motion.t[-1], 4096)
    place = contact_position(motion.at(t), motion.disk, motion.rolling_fillet)
    place = place + surface.place
    off = (
        np.hypot(*place.T) > surface.radius
        if isinstance(surface, PlateSurface)
        else points_off_mesh(surface.file, place)
    )
    return float(t[off.argmax()]) if off.any() else None


def points_off_mesh(file: str, place: np.ndarray) -> np.ndarray:
    """Return a mask (k,) of the points (k, 2) [m] outside the top face of the mesh in a
    file."""
    from modal.mesh.read import MAX_TABLE_SIZE, read_checked
    from modal.tabletop.meshed import on_top_face, top_face_triangles  # load slowly

    mesh = read_checked(file, MAX_TABLE_SIZE)
    return ~on_top_face(top_face_triangles(mesh, file), place)
