"""SCENE -> PLAN of the table: its model and omissions, and checks that it can be solved."""

from dataclasses import replace
from pathlib import Path

import numpy as np

from dynamics import Motion
from dynamics.compliant.two_way_onset import (
    may_be_two_way,
    needs_table_modes,
    reason_against_contact_law,
    reason_against_full_model,
    reason_against_two_way,
    table_modes,
    table_reaction,
)
from modal import SurfaceModes, UnsolvableError, surface_modes
from sonify.plan.plan import ENERGY_SHARE, Decision, Plan, counted
from sonify.plan.predictions import END, SOUND
from sonify.scene import Scene, SceneError
from sonify.sound.sources.tabletop import contact_place, response_to_unit_jump

BENT = 0.5
"""Deflection over thickness beyond which a plate also stretches and linear theory fails."""


def check_table(scene: Scene):
    """Raise SceneError before any computation if the table cannot be solved."""
    surface = scene.surface
    if scene.surface.action == "motion":
        what = "surface.action = 'motion'"
        instead = reason_against_two_way(scene) or reason_against_full_model(scene)
    else:
        what = "imperfection"
        wavy = scene.imperfection is not None
        instead = (
            (reason_against_contact_law(scene) or reason_against_full_model(scene)) if wavy else ""
        )
    if instead:
        raise SceneError(f"{what} with {instead}")
    if surface.kind == "mesh" and not Path(surface.file).is_file():
        raise SceneError(f"surface.file = {surface.file!r}: no such file")


def with_table(plan: Plan, scene: Scene) -> tuple[Plan, SurfaceModes | None]:
    """Return the plan with its treatment of the table, and the modes of the table that sound.

    The modes are None for a rigid or infinite table. Raises SceneError if they cannot be computed.
    """
    if scene.imperfection:
        plan = with_table_heard(plan, scene).also(modelled=[WAVY], left_out=[UNTOLD])
    if scene.surface.kind == "rigid":
        return with_disk(plan, scene, joins_table=False).also(left_out=[RIGID]), None
    if scene.surface.kind == "infinite":
        why = f"surface.action = '{scene.surface.action}': a table that acts back must have modes"
        endless = Decision(subject="table", choice=SOUNDS, reason=why)
        plan = with_disk(plan, scene, joins_table=False)
        return plan.also(endless, modelled=[ENDLESS], left_out=[*LEFT_OUT, FROM_AFAR]), None
    try:
        every = surface_modes(scene, below=plan.highest_mode)
    except UnsolvableError as error:
        raise SceneError(str(error)) from None
    except ValueError as error:
        raise SceneError(f"surface: {error}".replace("surface: surface", "surface")) from None
    modes = every.select(heard(every, scene))
    moving_modes = table_modes(scene, modes if needs_table_modes(scene) else None)
    acts = action(scene, modes if moving_modes is None else moving_modes)
    which = Decision(
        subject="modes of the table",
        choice=f"{len(modes)} of {len(every)} below {plan.highest_mode:g} Hz; {every.method}, "
        f"{every.unknowns} unknowns",
        reason=f"the others are more than {scene.numerics.level.range_db:g} dB(A) below the "
        f"loudest at the "
        f"listener, and hold less than {ENERGY_SHARE:.0%} of the energy",
    )
    plan = with_table_heard(plan, scene).also(acts, which, modelled=MODELLED[scene.surface.kind])
    plan = with_disk(plan, scene, joins_table=acts.choice != SOUNDS)
    return plan.also(
        left_out=[*LEFT_OUT[acts.choice != SOUNDS :], UNTOLD, *bending(every, scene)]
    ), modes


def with_disk(plan: Plan, scene: Scene, joins_table: bool) -> Plan:
    """Return the plan with the model of the disk.

    `joins_table` is True if the motion becomes two-way coupled with the table.
    """
    if not joins_table:
        disk = Decision(
            subject="disk and table" if scene.surface.kind == "rigid" else "disk",
            choice="rigid in the motion",
            reason=f"surface.kind = {scene.surface.kind!r}; the elastic modes of a disk only sound",
        )
        return plan.also(disk, modelled=[DISK_ON_PLANE], left_out=[NO_MODAL_REACTION + "."])
    elastic = scene.contact.body == "elastic" and scene.disk.shape == "solid"
    motion = DISK_JOINS_TABLE
    if elastic:
        motion += " The elastic modes of the disk below 20 kHz move with it, too."
    until = ", until the table moves with the disk"
    disk = Decision(subject="disk", choice="rigid" + until, reason=motion.removesuffix("."))
    return plan.also(disk, modelled=[motion], left_out=[NO_MODAL_REACTION + until + "."])


def with_table_heard(plan: Plan, scene: Scene) -> Plan:
    """Return the plan without the predictions that fail in the presence of a table.

    The error of the samples is removed unless roughness is present, because the rough contact then
    dominates the sound. The error of the end is removed if the table may act on the motion or is
    wavy.
    """
    unknown = set() if scene.roughness else {SOUND}
    unknown |= {END} if may_be_two_way(scene) or scene.imperfection else set()
    return replace(plan, predictions=tuple(p for p in plan.predictions if p.name not in unknown))


def action(scene: Scene, modes: SurfaceModes) -> Decision:
    """Return the decision on two-way coupling with the table, and the inclination at its start."""
    chosen = SOUNDS
    reason = "surface.action = 'sound'"
    asked = scene.surface.action
    if asked == "motion":
        chosen = "it moves with the disk, and sounds"
        reason = "surface.action = 'motion': the contact is at the least gap between rim and deflected table, and the "
        reason += "modes take the force that it has there"
    elif asked == "auto":
        found = table_reaction(scene, modes)
        reason = f"surface.action = 'auto': {found.reason}" + f", but {found.unsolved}" * bool(
            found.unsolved
        )
        if found.acts:
            chosen = f"it sounds, and moves with the disk from an inclination of {found.inclination:.2g} rad on"
            chosen += ", on an elastic contact" * (scene.contact.law == "rigid")
    return Decision(subject="table", choice=chosen, reason=reason)


def heard(modes: SurfaceModes, scene: Scene) -> np.ndarray:
    """Return the indices (k,) of the modes that sound after a force jump."""
    return counted(*response_to_unit_jump(modes, scene), scene.numerics.level.range_db)


def bending(modes: SurfaceModes, scene: Scene) -> list[str]:
    """Return a sentence on the stretching of the plate that linear theory leaves out.

    The list is empty if the weight of the disk bends the plate by less than BENT of its thickness.
    """
    if scene.surface.kind not in ("plate", "infinite"):
        return []
    thickness = scene.surface.thickness
    deflection = modes.compliance() * scene.disk.weight
    if deflection < BENT * thickness:
        return []
    return [
        f"The stretching of the plate: the weight of the disk alone would bend it by "
        f"{1e3 * deflection:.3g} mm, its "
        f"thickness is {1e3 * thickness:.3g} mm, and linear theory is left."
    ]


def off_since(scene: Scene, motion: Motion) -> float | None:
    """Return the time [s] at which the contact first leaves a plate or mesh; None if never."""
    surface = scene.surface
    t = np.linspace(0.0, motion.t[-1], 4096)
    if surface.kind not in ("plate", "mesh"):
        return None
    place = contact_place(motion.at(t), scene.disk) + surface.place
    off = (
        np.hypot(*place.T) > surface.radius
        if surface.kind == "plate"
        else off_mesh(surface.file, place)
    )
    return float(t[off.argmax()]) if off.any() else None


def off_mesh(file: str, place) -> np.ndarray:
    """Return a mask (k,) of the points (k, 2) [m] off the top face of the mesh in a file."""
    from modal.mesh.read import read_checked
    from modal.tabletop.meshed import on_top_face, top_face_triangles  # load slowly

    return ~on_top_face(top_face_triangles(read_checked(file)[0], file), place)


DISK_ON_PLANE = "A rigid disk rolls and slides on a rigid plane."
DISK_JOINS_TABLE = (
    "A rigid disk rolls and slides on a rigid plane until the table moves with it; from then on "
    "its contact is elastic "
    "and is at the least gap between rim and deflected table."
)
NO_MODAL_REACTION = "Sound of impacts; the action of the elastic modes on the motion"
WAVY = (
    "The table is wavy round the circle of the contact, which goes with the disk; the contact is "
    "where the gap between "
    "rim and waves is least."
)
UNTOLD = (
    "How far the samples of a table's sound are from those of a finer run: that is not predicted."
)
RIGID = "The sound of the table, which is rigid."
SOUNDS = "it only sounds"
UNDER = (
    "The contact force pushes the table where the contact is at the moment, and drives its modes.",
    "The top face of the table radiates into the half space above it, as in a baffle (Rayleigh's "
    "integral, above "
    "coincidence and below), the part under the disk like the rest.",
)
MODELLED = {
    "plate": ("The table is a round elastic plate.", *UNDER),
    "mesh": ("The table is an elastic solid.", *UNDER),
    "modes": (
        "The table is what its modes say. The contact circle, which goes with the disk, is all of "
        "it that is known, "
        "and alone radiates.",
        *UNDER,
    ),
}
ENDLESS = (
    "The table is an endless plate, pushed where the contact is; it is heard as from afar, in "
    "closed form, with the "
    "waves of the plate that run ahead of the sound coming after it."
)
FROM_AFAR = "How loud a near listener hears a near contact: the contact's distance changes when it is heard alone."
LEFT_OUT = (
    "The action of the table on the motion: what it takes from the disk, and that it deflects "
    "under it.",
    "The friction on the table, the sound of its other faces, its damping by the air, and what "
    "the disk hides of it.",
)
