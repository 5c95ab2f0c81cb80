"""The rung of a run on the ladder of models, and what a higher rung would change.

The sizes are the predictions of the plan of the motion; nothing is decided here.
"""

from collections.abc import Iterator
from math import inf, isfinite
from textwrap import shorten
from typing import Literal, NamedTuple

from dynamics import MotionPlan
from dynamics.compliant.model_selection import (
    LIFT_OFF_FORCE_RMS,
    MAX_FORCE_RMS_FOR_ONE_CONTACT,
    MAX_RELATIVE_CURVATURE_FOR_ROLLING,
    greatest_curvature_number,
    predicted_force_rms,
)
from dynamics.compliant.rough_table import predict_rough_table, scene_receptance
from dynamics.compliant.two_way_onset import table_reaction

Level = Literal[
    "rigid",
    "elastic",
    "one-way",
    "two-way",
    "one-contact",
    "late-table",
    "moving-table",
    "many",
]
LEVELS: dict[Level, str] = {
    "rigid": "rigid contact",
    "elastic": "smooth elastic contact",
    "one-way": "rough contact, one-way",
    "two-way": "rough contact, two-way",
    "one-contact": "one contact in time steps",
    "late-table": "one contact, table moves at the end",
    "moving-table": "one contact, table moves",
    "many": "contacts anywhere on the rim",
}
"""Contact models from the simplest to the most complete one, with their descriptions.

Each includes the landing."""
MIN_REPORTED_LEVEL_CHANGE = 1.0
"""Change of the level of the table [dB] from which it changes the answer."""


class Rung(NamedTuple):
    """Model of a motion: a level of LEVELS, with or without the air film."""

    level: Level
    film: bool

    @property
    def order(self) -> tuple[int, bool]:
        """The place on the ladder, from the simplest to the most complete model."""
        return list(LEVELS).index(self.level), self.film

    @property
    def name(self) -> str:
        """The name of the rung in tables."""
        return f"{self.level}, air film" if self.film else f"{self.level}, no film"

    @property
    def words(self) -> str:
        """The description of the rung."""
        return f"{LEVELS[self.level]}, {'air film' if self.film else 'no film'}"


class HigherRungEffect(NamedTuple):
    """Answer that a higher rung would change, with the predicted size in words."""

    answer: Literal["sound", "contact", "end"]
    size: str


def rung_of(plan: MotionPlan) -> Rung:
    """Return the rung of the plan of a motion.

    A table that may act back on the disk, depending on modes that are unknown, counts as
    moving at the end.
    """
    return Rung(_ladder_level(plan), plan.film is not None)


def _ladder_level(plan: MotionPlan) -> Level:
    if plan.contact.kind == "many":
        return "many"
    undecided = plan.lacks_surface_modes and not plan.rolls_on_roughness
    requested = plan.scene.surface.action == "motion"
    if plan.is_two_way_from_release or (undecided and requested):
        return "moving-table"
    if plan.switches_to_two_way or undecided:
        return "late-table"
    if plan.contact.kind == "full":
        return "one-contact"
    if plan.contact.kind == "rigid":
        return "rigid"
    if plan.scene.roughness is None:
        return "elastic"
    return "two-way" if plan.filter_is_two_way else "one-way"


def rung_line(plan: MotionPlan, length: int) -> str:
    """Return one line of at most `length` characters on the rung of a run and on the
    answers that a higher rung would change."""
    rung = rung_of(plan)
    sizes: dict[str, list[str]] = {}
    for effect in effects_of_higher_rungs(plan):
        sizes.setdefault(effect.answer, []).append(effect.size)
    effects = [f"{answer} ({'; '.join(found)})" for answer, found in sizes.items()]
    if effects:
        line = f"model: {rung.words}; higher ones change {', '.join(effects)}"
    else:
        line = f"model: {rung.words}; higher ones change no answer"
    return shorten(line, length, placeholder=" ...")


def effects_of_higher_rungs(plan: MotionPlan) -> list[HigherRungEffect]:
    """Return the answers that a higher rung would change by more than the limit of its
    prediction."""
    return [*_contact_effects(plan), *_table_effects(plan), *_film_effects(plan)]


def _contact_effects(plan: MotionPlan) -> Iterator[HigherRungEffect]:
    """Yield the predicted effects of a more complete model of the contact."""
    if plan.contact.kind == "rigid":
        yield HigherRungEffect("sound", "size unknown")
    if plan.scene.roughness is None or plan.contact.kind not in ("filter", "full"):
        return
    curvature, _ = greatest_curvature_number(plan)
    if curvature > MAX_RELATIVE_CURVATURE_FOR_ROLLING:
        yield HigherRungEffect("contact", f"relative curvature {curvature:.2g}")
        return
    assert plan.tabulated_law is not None  # the contact is elastic
    _, rms = predicted_force_rms(plan, plan.tabulated_law, plan.contact_receptance)
    filtered = plan.contact.kind == "filter"
    limit = LIFT_OFF_FORCE_RMS if filtered else MAX_FORCE_RMS_FOR_ONE_CONTACT
    if rms.max(initial=0.0) > limit:
        yield HigherRungEffect("contact", f"force rms {rms.max():.2g} of the weight")


def _table_effects(plan: MotionPlan) -> Iterator[HigherRungEffect]:
    """Yield the predicted effects of a table that yields or moves."""
    scene = plan.scene
    if scene.surface.kind == "rigid" or plan.two_way.is_two_way:
        return
    one_way = plan.contact.kind in ("filter", "full") and not plan.filter_is_two_way
    if scene.roughness is not None and one_way:
        receptance = scene_receptance(scene, plan.surface_modes)
        found = plan.rough_table or predict_rough_table(plan, receptance)
        if abs(found.level_error) > MIN_REPORTED_LEVEL_CHANGE:
            yield HigherRungEffect("sound", f"table {-found.level_error:+.2g} dB")
    if plan.surface_modes is None:
        return
    inclination, _ = table_reaction(plan, plan.surface_modes)
    if inclination > plan.film_decision.airborne_inclination:
        yield HigherRungEffect("end", f"table {_last_seconds(plan, inclination)}")


def _last_seconds(plan: MotionPlan, inclination: float) -> str:
    """Return the part of a motion below an inclination [rad] in words."""
    try:
        seconds = plan.time_to_flat(inclination)
    except ValueError:  # the disk is too thick for steady motion
        seconds = inf
    if isfinite(seconds):
        return f"last {seconds:.2g} s"
    return f"below {inclination:.1g} rad"


def _film_effects(plan: MotionPlan) -> Iterator[HigherRungEffect]:
    """Yield the predicted effect of an air film that the scene excludes."""
    found = plan.excluded_film
    if found is not None and found.film is not None:
        yield HigherRungEffect("end", f"film from {found.time:.1g} s")
