"""The rungs of a scene: the values that each model sets, and why others do not apply.

A rung is the scene with replaced values, so that `run` reproduces it.
"""

from collections.abc import Iterator
from typing import Any, NamedTuple

from dynamics import MotionPlan
from dynamics.compliant.model_selection import (
    MAX_FORCE_RMS_FOR_ONE_CONTACT,
    MAX_RELATIVE_CURVATURE_FOR_ROLLING,
    greatest_curvature_number,
    predicted_force_rms,
)
from dynamics.film.activation import reason_against_film
from sonify.plan.duration import predicted_motion_seconds, predicted_run_seconds
from sonify.plan.motion import planned_scene
from sonify.plan.preflight import check_solvable_disk, motion_plan_with_table
from sonify.plan.rungs import LEVELS, Level, Rung, rung_of
from sonify.scene import Scene
from sonify.scene_errors import SceneError

LEVELS_WITH_FILTER_CONTACT = ("elastic", "one-way", "two-way")
MODE_LEVELS = ("late-table", "moving-table")
"""Levels that need a table with modes."""
TABLE_ACTION = {
    "two-way": "motion",
    "late-table": "auto",
    "moving-table": "motion",
    "many": "motion",
}
"""Value of surface.action by level; "sound" for the others."""


class SceneRung(NamedTuple):
    """A rung of a scene, with the scene that it solves."""

    rung: Rung
    values: dict[str, Any]
    """Values that replace those of the scene, by key; None removes a key."""
    scene: Scene
    seconds: float
    """Predicted duration of a run [s]."""


class Inapplicable(NamedTuple):
    """A rung that does not apply to a scene, with the reason."""

    rung: Rung
    reason: str


class Rungs(NamedTuple):
    """The rungs of a scene, from the simplest to the most complete one."""

    own: Rung
    """The rung of the scene itself."""
    usable: list[SceneRung]
    inapplicable: list[Inapplicable]


def rungs_of(scene: Scene) -> Rungs:
    """Return the rungs of a scene.

    Raises SceneError if the scene itself cannot be solved.
    """
    scene, plan = planned_scene(scene)
    check_solvable_disk(scene)
    if plan.rolls_on_roughness:  # their modes decide the coupling
        plan = motion_plan_with_table(scene, plan)
    own = rung_of(plan)
    usable: list[SceneRung] = []
    inapplicable: list[Inapplicable] = []
    for rung in candidates(scene, own):
        if rung == own:
            seconds = predicted_run_seconds(scene, plan)
            usable.append(SceneRung(rung, {}, scene, seconds))
            continue
        reason = reason_against_many(plan) if rung.level == "many" else ""
        if reason:
            inapplicable.append(Inapplicable(rung, reason))
            continue
        found = scene_rung(scene, rung, predicted_motion_seconds(plan))
        if isinstance(found, SceneRung):
            usable.append(found)
        else:
            inapplicable.append(found)
    return Rungs(own, usable, inapplicable)


def candidates(scene: Scene, own: Rung) -> list[Rung]:
    """Return the rungs to be tried, in their order.

    The film acts on all levels if it can exist. The lowest level and that of the scene
    itself are also solved without it.
    """
    film = not reason_against_film(scene)
    found = {Rung(level, film) for level in LEVELS}
    found |= {Rung("rigid", False), own}
    return sorted(found, key=lambda rung: rung.order)


def scene_rung(scene: Scene, rung: Rung, duration: float) -> SceneRung | Inapplicable:
    """Return a scene on a rung, or the reason why the rung does not apply.

    `duration` is the predicted duration [s] of the motion of the scene itself. A motion
    without losses that end it is solved for four times as long.
    """
    if reason := reason_against_level(scene, rung.level):
        return Inapplicable(rung, reason)
    values = rung_values(scene, rung)
    try:
        changed, plan = planned_scene(scene.replace(values))
        time_limit = float(f"{4 * duration:.2g}")
        if predicted_motion_seconds(plan) >= changed.numerics.time_limit > time_limit:
            values["numerics.time_limit"] = time_limit
            changed, plan = planned_scene(scene.replace(values))
    except SceneError as error:
        return Inapplicable(rung, str(error))
    return SceneRung(rung, values, changed, predicted_run_seconds(changed, plan))


def reason_against_many(plan: MotionPlan) -> str:
    """Return the reason why one contact suffices for a scene, or "".

    The limits are those up to which one contact gives the motion within 2 %. Below them,
    contacts anywhere on the rim would cost more for the same motion.
    """
    scene = plan.scene
    if scene.roughness is None:
        return "" if scene.imperfection else "smooth table and edge have one contact"
    if plan.contact.kind == "many":
        return ""
    curvature, _ = greatest_curvature_number(plan)
    if curvature > MAX_RELATIVE_CURVATURE_FOR_ROLLING:
        return ""
    words = f"the curvature of the heights is {curvature:.2g} of that of the rim"
    if plan.tabulated_law is None:
        return f"one contact suffices: {words}"
    _, rms = predicted_force_rms(plan, plan.tabulated_law, plan.contact_receptance)
    if rms.max() > MAX_FORCE_RMS_FOR_ONE_CONTACT:
        return ""
    return f"one contact suffices: {words}, and the rms of N' is {rms.max():.2g} of the weight"


def reason_against_level(scene: Scene, level: Level) -> str:
    """Return the reason why a level does not apply to a scene, or ""."""
    kind = scene.surface.kind
    rough = scene.roughness is not None
    if level in ("one-way", "two-way") and not rough:
        return "table and edge are smooth"
    if level == "two-way" and kind == "rigid":
        return "the table is rigid"
    if level in MODE_LEVELS and kind in ("rigid", "infinite"):
        return f"surface.kind = '{kind}' has no modes"
    if level == "late-table" and rough:
        return "a rough contact is handed over to time steps only if no film lifts the disk"
    return ""


def rung_values(scene: Scene, rung: Rung) -> dict[str, Any]:
    """Return the values by which a scene differs from its rung; None removes a key."""
    wanted = dict(_wanted_values(scene, rung))
    sections = vars(scene)
    changed = {}
    for path, value in wanted.items():
        section, _, key = path.partition(".")
        present = sections[section]
        if present is not None and key:
            present = vars(present)[key]
        if present != value:
            changed[path] = value
    return changed


def _wanted_values(scene: Scene, rung: Rung) -> Iterator[tuple[str, Any]]:
    """Yield the keys that a rung determines, with their values."""
    level, film = rung
    many = level == "many"
    yield "contact.law", "rigid" if level == "rigid" else "elastic"
    yield "numerics.contact", _contact_model(level)
    if scene.surface.kind != "rigid":
        has_modes = scene.surface.kind != "infinite"
        moves = TABLE_ACTION.get(level, "sound")
        yield "surface.action", moves if has_modes or not many else "sound"
    yield "air.film", "acts" if film else "none"
    if scene.contact.restitution is not None and not many:
        yield "contact.restitution", None
        if level != "rigid":
            yield "contact.loss_factor", _loss_factor(scene.contact.restitution)
    if scene.roughness is not None and level == "elastic":
        yield "roughness", None
    elif scene.roughness is not None and not many:
        yield "roughness.grain", False
    if level == "rigid":
        yield "imperfection", None


def _contact_model(level: Level) -> str:
    """Return the value of numerics.contact on a level."""
    if level in LEVELS_WITH_FILTER_CONTACT:
        return "filter"
    return {"rigid": "auto", "many": "many"}.get(level, "full")


def _loss_factor(restitution: float) -> float:
    """Return the loss factor of a contact with a coefficient of restitution.

    It is twice the damping ratio, since the loss factor is that of the resonance."""
    from dynamics.compliant.law.unevenness import damping_ratio  # loads SciPy

    return float(f"{min(2 * damping_ratio(restitution), 0.99):.4g}")


def assignments(values: dict[str, Any]) -> str:
    """Return values as the arguments of --set, and the removed keys in words."""
    given = [
        f"{key}={_toml(value)}" for key, value in values.items() if value is not None
    ]
    removed = [key for key, value in values.items() if value is None]
    words = f"without {', '.join(removed)}" if removed else ""
    return "; ".join(filter(None, (" ".join(given), words)))


def _toml(value: Any) -> str:
    """Return a value in TOML; texts are bare words."""
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, list):
        return f"[{','.join(map(_toml, value))}]"
    return str(value)
