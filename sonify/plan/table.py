"""TABLE: what a run computes of it and what it leaves out, and where a table cannot be solved."""

from dataclasses import replace
from pathlib import Path

import numpy as np

from dynamics import Motion
from dynamics.coupled.acting import acting, no_one_contact, unsolved
from modal import SurfaceModes, UnsolvableError, surface_modes
from sonify.plan.plan import ENERGY_SHARE, NO_ACTION, ON_A_PLANE, Decision, Plan, counted
from sonify.plan.predictions import END, SOUND
from sonify.scene import Scene, SceneError
from sonify.sound.table import after_a_newton, contact_place

BENT = 0.5
"""Deflection over thickness beyond which a plate also stretches: linear theory is left."""


def acts_back(scene: Scene) -> bool:
    """Return whether the motion is solved with the modes of the table, which may act back somewhere."""
    asked = getattr(scene.surface, "action", "sound")
    return asked == "motion" or (asked == "auto" and not unsolved(scene))


def check_table(scene: Scene):
    """Raise SceneError, before any work, where the table cannot be solved."""
    surface = scene.surface
    if getattr(surface, "action", "") == "motion":
        what, instead = "surface.action = 'motion'", unsolved(scene) or not_in_full(scene)
    else:
        what, wavy = "imperfection", scene.imperfection is not None
        instead = (no_one_contact(scene) or not_in_full(scene)) if wavy else ""
    if instead:
        raise SceneError(f"{what} with {instead}")
    if surface.kind == "mesh" and not Path(surface.file).is_file():
        raise SceneError(f"surface.file = {surface.file!r}: no such file")


def not_in_full(scene: Scene) -> str:
    """Return why the contact of a scene is not solved in full from the release on; nothing if it is."""
    if scene.contact.law == "rigid":
        return "contact.law = 'rigid': such a table needs an elastic contact"
    filtered = scene.numerics.contact == "filter"
    return "numerics.contact = 'filter': such a table needs 'full'" if filtered else ""


def with_table(plan: Plan, scene: Scene) -> tuple[Plan, SurfaceModes | None]:
    """Return the plan with what it does about the table, and the modes of the table that sound; None of a rigid one.

    Raises SceneError where the modes cannot be sought.
    """
    if scene.imperfection:
        plan = with_table_heard(plan, scene).also(modelled=[WAVY], left_out=[UNTOLD])
    if scene.surface.kind == "rigid":
        return plan.also(left_out=[RIGID]), None
    if scene.surface.kind == "infinite":
        why = f"surface.action = '{scene.surface.action}': a table that acts back must have modes"
        endless = Decision(subject="table", choice=SOUNDS, reason=why)
        return plan.also(endless, modelled=[ENDLESS], left_out=[*LEFT_OUT, FROM_AFAR]), None
    try:
        every = surface_modes(scene, below=plan.highest_mode)
    except UnsolvableError as error:
        raise SceneError(str(error)) from None
    except ValueError as error:
        raise SceneError(f"surface: {error}".replace("surface: surface", "surface")) from None
    modes = every.select(heard(every, scene))
    acts = action(scene, modes)
    which = Decision(
        subject="modes of the table",
        choice=f"{len(modes)} of {len(every)} below {plan.highest_mode:g} Hz; {every.method}, "
        f"{every.unknowns} unknowns",
        reason=f"the others are more than {scene.numerics.level.range_db:g} dB(A) below the loudest at the "
        f"listener, and hold less than {ENERGY_SHARE:.0%} of the energy",
    )
    plan = with_table_heard(plan, scene).also(acts, which, modelled=MODELLED[scene.surface.kind])
    plan = plan if acts.choice == SOUNDS else moving(plan, scene)
    return plan.also(left_out=[*LEFT_OUT[acts.choice != SOUNDS :], UNTOLD, *bending(every, scene)]), modes


def moving(plan: Plan, scene: Scene) -> Plan:
    """Return a plan which says of a disk that moves with its table what holds in place of a rigid one on a plane."""
    bends = scene.contact.body == "elastic" and scene.disk.shape == "solid"
    others = {ON_A_PLANE: MOVES + BENDS * bends, NO_ACTION: NO_ACTION[:-1] + BEFORE}
    disk = Decision(subject="disk", choice="rigid" + BEFORE[:-1], reason=(MOVES + BENDS * bends)[:-1])
    return replace(
        plan,
        decisions=tuple(disk if decision.subject == "disk" else decision for decision in plan.decisions),
        modelled=tuple(others.get(sentence, sentence) for sentence in plan.modelled),
        left_out=tuple(others.get(sentence, sentence) for sentence in plan.left_out),
    )


def with_table_heard(plan: Plan, scene: Scene) -> Plan:
    """Return the plan with the predictions that hold beside a table: not its samples, nor the end of a motion that
    waves shake.

    Of a rough contact the sound is that contact's.
    """
    unknown = set() if scene.roughness else {SOUND}
    unknown |= {END} if acts_back(scene) or scene.imperfection else set()
    return replace(plan, predictions=tuple(p for p in plan.predictions if p.name not in unknown))


def action(scene: Scene, modes: SurfaceModes) -> Decision:
    """Return whether the table acts back, and from when on."""
    chosen, reason, asked = SOUNDS, "surface.action = 'sound'", getattr(scene.surface, "action", "sound")
    if asked == "motion":
        chosen = "it moves with the disk, and sounds"
        reason = "surface.action = 'motion': the contact is at the least gap between rim and deflected table, and the "
        reason += "modes take the force that it has there"
    elif asked == "auto":
        found = acting(scene, modes)
        reason = f"surface.action = 'auto': {found.reason}" + f", but {found.unsolved}" * bool(found.unsolved)
        if found.acts:
            chosen = f"it sounds, and moves with the disk from an inclination of {found.inclination:.2g} rad on"
            chosen += ", on an elastic contact" * (scene.contact.law == "rigid")
    return Decision(subject="table", choice=chosen, reason=reason)


def heard(modes: SurfaceModes, scene: Scene) -> np.ndarray:
    """Return which modes (k,) count after a jump of the force, at the accuracy of the scene."""
    return counted(*after_a_newton(modes, scene), scene.numerics.level.range_db)


def bending(modes: SurfaceModes, scene: Scene) -> list[str]:
    """Return what linear theory leaves out where the weight of the disk bends a plate by BENT of its thickness."""
    thickness = getattr(scene.surface, "thickness", np.inf)
    deflection = modes.compliance() * scene.disk.weight
    if deflection < BENT * thickness:
        return []
    return [
        f"The stretching of the plate: the weight of the disk alone would bend it by {1e3 * deflection:.3g} mm, its "
        f"thickness is {1e3 * thickness:.3g} mm, and linear theory is left."
    ]


def off_since(scene: Scene, motion: Motion) -> float | None:
    """Return when [s] the contact first is beyond the edge of a plate or a mesh; None if never."""
    surface, t = scene.surface, np.linspace(0.0, motion.t[-1], 4096)
    if surface.kind not in ("plate", "mesh"):
        return None
    place = contact_place(motion.at(t), scene.disk) + surface.place
    off = np.hypot(*place.T) > surface.radius if surface.kind == "plate" else off_mesh(surface.file, place)
    return float(t[off.argmax()]) if off.any() else None


def off_mesh(file: str, place) -> np.ndarray:
    """Return whether places (k, 2) [m] are beyond the top face of the mesh in a file, (k,)."""
    from modal.elements.table import on_top, top_triangles  # load slowly
    from modal.mesh.read import read_checked

    return ~on_top(top_triangles(read_checked(file)[0], file), place)


BEFORE = ", until the table moves with the disk."
MOVES = (
    "A rigid disk rolls and slides on a rigid plane until the table moves with it; from then on its contact is elastic "
    "and lies at the least gap between rim and deflected table."
)
BENDS = " The elastic modes of the disk below 20 kHz move with it, too."
WAVY = (
    "The table is wavy round the circle of the contact, which goes with the disk; the contact is where the gap between "
    "rim and waves is least."
)
UNTOLD = "How far the samples of a table's sound are from those of a finer run: that is not predicted."
RIGID = "The sound of the table, which is rigid."
SOUNDS = "it only sounds"
UNDER = (
    "The contact force pushes the table where the contact is at the moment, and drives its modes.",
    "The top face of the table radiates into the half space above it, as in a baffle (Rayleigh's integral, above "
    "coincidence and below), the part under the disk like the rest.",
)
MODELLED = {
    "plate": ("The table is a round elastic plate.", *UNDER),
    "mesh": ("The table is an elastic solid.", *UNDER),
    "modes": (
        "The table is what its modes say. The contact circle, which goes with the disk, is all of it that is known, "
        "and alone radiates.",
        *UNDER,
    ),
}
ENDLESS = (
    "The table is an endless plate, pushed where the contact is; it is heard as from afar, in closed form, with the "
    "waves of the plate that run ahead of the sound coming after it."
)
FROM_AFAR = "How loud a near listener hears a near contact: the contact's distance changes when it is heard alone."
LEFT_OUT = (
    "The action of the table on the motion: what it takes from the disk, and that it deflects under it.",
    "The friction on the table, the sound of its other faces, its damping by the air, and what the disk hides of it.",
)
