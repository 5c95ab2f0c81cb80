"""The decisions of a motion, made once from its scene: `plan_motion`."""

from dataclasses import dataclass, replace
from functools import cached_property
from math import acos, isfinite, pi
from typing import TYPE_CHECKING, Any, Literal, NamedTuple

from dynamics.compliant.law.sections import SwitchedContact
from dynamics.contact_options import (
    ContactOption,
    contact_options,
    rattling_duration,
)
from dynamics.dissipation import OwnLaw, combined_loads, resistance_of
from dynamics.equations import DiskConstants
from dynamics.film.activation import FilmDecision, decide_film, final_inclination
from dynamics.film.wedge import Film
from dynamics.quasi_steady import time_to_flat
from dynamics.scene_constants import scene_constants
from dynamics.sections import MotionScene, as_motion_scene
from dynamics.solver_settings import MIN_SOLVED_INCLINATION
from dynamics.surface import InfiniteSurface, ModesSurface

if TYPE_CHECKING:
    from dynamics.compliant.law.table_receptance import TableReceptance
    from dynamics.compliant.law.tabulated import TabulatedLaw
    from dynamics.compliant.rough_table import RoughTable

MAX_RATTLING_INCLINATION = acos(0.1)
"""Inclination [rad] up to which the contacts on the lower rim alone describe a rattling disk."""
ContactModel = Literal["rigid", "filter", "full", "many"]
"""Model of the contact: rigid, elastic as a linear filter on the rigid motion, one elastic
contact in time steps, or contacts anywhere on the rim in time steps."""


class ModelChoice(NamedTuple):
    """Contact model of a motion.

    Attributes
    ----------
    kind : ContactModel
        The model.
    reason : str
        Reason for the choice.
    """

    kind: ContactModel
    reason: str


class TableReaction(NamedTuple):
    """Reaction of the table on the motion of the disk.

    Attributes
    ----------
    is_two_way : bool
        True if the motion is solved with two-way coupling.
    inclination : float
        Inclination [rad] below which the reaction is relevant; 0 if it never is or if the
        modes of the table are unknown.
    reason : str
        Reason for the result.
    reason_unsolved : str
        Reason why a relevant reaction is not solved, or "".
    """

    is_two_way: bool
    inclination: float
    reason: str
    reason_unsolved: str = ""


@dataclass(frozen=True, kw_only=True, eq=False)
class MotionBasis:
    """What all contact models of a scene share.

    Parameters
    ----------
    scene : MotionScene
        The scene.
    constants : DiskConstants
        Dimensionless constants of disk, friction and table.
    film_decision : FilmDecision
        Whether the air film acts, with the reason and its predicted onset.
    loads : OwnLaw, Resistance, Film, CombinedLoads or None
        Loads other than those of the contact.
    final_inclination : float
        Inclination [rad] at which the motion counts as settled.
    """

    scene: MotionScene
    constants: DiskConstants
    film_decision: FilmDecision
    loads: Any
    final_inclination: float

    @property
    def film(self) -> Film | None:
        """The air film that acts on the disk, or None."""
        return self.film_decision.film


@dataclass(frozen=True, kw_only=True, eq=False)
class MotionPlan(MotionBasis):
    """The decisions of a motion, with their reasons: the result of `plan_motion`.

    Solver, sound, claims and texts read the plan and decide nothing from the scene.

    Parameters
    ----------
    scene : MotionScene
        The scene.
    constants : DiskConstants
        Dimensionless constants of disk, friction and table.
    film_decision : FilmDecision
        Whether the air film acts, with the reason and its predicted onset.
    loads : OwnLaw, Resistance, Film, CombinedLoads or None
        Loads other than those of the contact.
    final_inclination : float
        Inclination [rad] at which the motion counts as settled.
    tabulated_law : TabulatedLaw or None
        The tabulated law of an elastic contact.
    contact : ModelChoice
        Model of the contact.
    step_rate : float
        Time steps per second of the models "full" and "many"; 0 for the others.
    obstacle_to_two_way : str
        Reason why two-way coupling with the table is impossible, or "".
    two_way : TableReaction
        Whether and from where the table acts back on the disk.
    surface_modes : modal.SurfaceModes or None
        Modes of the table, if they are known.
    rough_table : RoughTable or None
        Predicted effect of the table on a rough contact on which the disk rolls, if it is
        known.

    Examples
    --------
    >>> from dynamics import plan_motion
    >>> from sonify import load_scene
    >>> plan = plan_motion(load_scene("published"))
    >>> plan.contact.kind, plan.film_decision.reason
    ('rigid', "air.film = 'none'")
    """

    tabulated_law: "TabulatedLaw | None"
    contact: ModelChoice
    step_rate: float
    obstacle_to_two_way: str
    two_way: TableReaction
    surface_modes: Any
    rough_table: "RoughTable | None" = None

    @property
    def max_rolling_inclination(self) -> float:
        """Inclination [rad] above which the contact model does not apply."""
        return MAX_RATTLING_INCLINATION if self.contact.kind == "many" else pi / 2

    @property
    def rolls_on_roughness(self) -> bool:
        """True if the disk rolls on a rough elastic contact, whose table is coupled by a
        predicted error."""
        scene = self.scene
        return (
            scene.roughness is not None
            and self.contact.kind in ("filter", "full")
            and (scene.surface.action == "auto" or requests_two_way_filter(scene))
            and scene.surface.kind != "rigid"
        )

    @property
    def may_be_two_way(self) -> bool:
        """True if the table may act back on the disk, depending on its modes."""
        return self.scene.surface.action != "sound" and not self.obstacle_to_two_way

    @property
    def lacks_surface_modes(self) -> bool:
        """True if motion or contact force may depend on modes of the table that are
        unknown."""
        coupled = self.may_be_two_way or self.rolls_on_roughness
        has_modes = self.scene.surface.kind not in ("rigid", "infinite")
        return coupled and has_modes and self.surface_modes is None

    @property
    def is_two_way_from_release(self) -> bool:
        """True if the table and the disk are coupled in time steps from the release on."""
        requested = self.scene.surface.action == "motion"
        on_roughness = self.rolls_on_roughness and self.contact.kind == "full"
        from_release = requested or on_roughness or self.contact.kind == "many"
        return self.two_way.is_two_way and from_release

    @property
    def filter_is_two_way(self) -> bool:
        """True if the filter of a rough contact includes the receptance of the table."""
        if self.rough_table is None or self.contact.kind != "filter":
            return False
        return self.rough_table.needs_two_way or requests_two_way_filter(self.scene)

    @property
    def plate_mobility(self) -> float:
        """Mobility [s/kg] of an infinite plate, or 0."""
        surface = self.scene.surface
        if not isinstance(surface, InfiniteSurface):
            return 0.0
        from dynamics.compliant.law.table_receptance import infinite_plate_mobility

        return float(infinite_plate_mobility(surface))

    @cached_property
    def contact_receptance(self) -> "TableReceptance":
        """The receptance of the table that the contact force includes.

        It is that of a rigid table with one-way coupling and for a rattling disk.
        """
        from dynamics.compliant.law.table_receptance import RIGID_TABLE
        from dynamics.compliant.rough_table import scene_receptance

        in_time_steps = self.contact.kind == "full" and self.moving_modes is not None
        if self.filter_is_two_way or in_time_steps:
            return scene_receptance(self.scene, self.surface_modes)
        return RIGID_TABLE

    @property
    def switches_to_two_way(self) -> bool:
        """True if the table and the disk are coupled below an inclination only."""
        return self.two_way.is_two_way and not self.is_two_way_from_release

    @property
    def moving_modes(self) -> Any:
        """The `modal.SurfaceModes` that move from the release on, or None."""
        return self.surface_modes if self.is_two_way_from_release else None

    @cached_property
    def excluded_film(self) -> FilmDecision | None:
        """The prediction for the air film that air.film = 'none' excludes, or None."""
        if self.scene.air.film != "none":
            return None
        allowed = self.scene.part(air=replace(self.scene.air, film="auto"))
        return motion_basis(allowed).film_decision

    @cached_property
    def series_tabulated_law(self) -> "TabulatedLaw":
        """The tabulated law with the flexibility of the edge in series with every spring.

        It exists for an elastic contact only.
        """
        assert self.tabulated_law is not None
        from dynamics.compliant.law.tabulated import EdgeSeriesLaw  # loads SciPy

        return EdgeSeriesLaw(law=self.tabulated_law.law, edge=self.tabulated_law.edge)

    @cached_property
    def contact_options(self) -> tuple[ContactOption, ...]:
        """Predicted errors and processor seconds of each model of an elastic contact."""
        return contact_options(self)

    @cached_property
    def roughness_energy_share(self) -> float:
        """Predicted fraction of the energy that roughness dissipates on a rolling disk."""
        if self.tabulated_law is None:
            return 0.0
        from dynamics.compliant.model_selection import roughness_energy_share

        return roughness_energy_share(self, self.tabulated_law, self.contact_receptance)

    @cached_property
    def predicted_end_error(self) -> float:
        """Predicted error [s] of the end of the motion, if the disk settles.

        It is the time by which a quasi-steady motion is stopped too early, and 0 with an
        air film, which ends the motion at a solved event. For a disk that rattles on a
        rough table, it is the change of the chaotic duration with the time step.
        """
        if self.contact.kind == "many" and self.scene.roughness:
            return rattling_end_error(self.scene)
        if self.film:
            return 0.0
        left = self.time_to_flat(self.final_inclination)
        if not isfinite(left):
            return 0.0
        return left - self.time_to_flat(MIN_SOLVED_INCLINATION)

    def time_to_flat(self, inclination: float) -> float:
        """Return the predicted time in which the inclination falls to 0.

        The motion is quasi-steady, and the air film is neglected.

        Parameters
        ----------
        inclination : float
            Inclination [rad].

        Returns
        -------
        float
            Time [s]; infinite if nothing dissipates the energy in a finite time.

        Raises
        ------
        ValueError
            If the disk is too thick or too steep for steady motion.
        """
        disk = self.scene.disk
        loads = resistance_of(self.scene.dissipation, disk)
        return time_to_flat(inclination, disk, self.constants, loads)

    def with_surface_modes(self, surface_modes: Any) -> "MotionPlan":
        """Return the plan of the motion on a table with known modes.

        Parameters
        ----------
        surface_modes : modal.SurfaceModes
            Modes of the table.

        Returns
        -------
        MotionPlan
            The plan, with the reaction of the table.
        """
        action = self.scene.surface.action
        plan = replace(self, surface_modes=surface_modes)
        if action == "sound":
            return plan
        if self.rolls_on_roughness:
            return _coupled_by_error(plan)
        from dynamics.compliant.two_way_onset import table_reaction  # loads SciPy

        inclination, reason = table_reaction(self, surface_modes)
        if action == "motion":
            found = TableReaction(True, inclination, "surface.action = 'motion'")
        elif not inclination:
            found = TableReaction(False, 0.0, reason)
        else:
            obstacle = self.obstacle_to_two_way
            found = TableReaction(not obstacle, inclination, reason, obstacle)
        return replace(plan, two_way=found)

    def with_own_law(self, law: OwnLaw) -> "MotionPlan":
        """Return the plan with a user-defined law that replaces the dissipation.

        Parameters
        ----------
        law : OwnLaw
            The law.

        Returns
        -------
        MotionPlan
            The plan.

        Raises
        ------
        ValueError
            If the contact model or the table does not support such a law.
        """
        reason = ""
        if self.contact.kind == "many":
            reason = "is not supported for a rattling disk"
        elif self.switches_to_two_way:
            reason = "requires a rigid table: set surface.action = 'sound'"
        elif self.contact.kind == "full":
            reason = "requires a rigid contact, or numerics.contact = 'filter'"
        if reason:
            raise ValueError(f"loads: a user-defined law {reason}")
        return replace(self, loads=combined_loads(law, self.film))

    def part(self, **sections: Any) -> "MotionPlan":
        """Return the plan of a part or variant of the motion, with the same decisions.

        Parameters
        ----------
        **sections
            Sections that replace those of the scene, as in `MotionScene.part`. They must
            not change the constants.

        Returns
        -------
        MotionPlan
            The plan.
        """
        scene = self.scene.part(**sections)
        plan = replace(
            self,
            scene=scene,
            final_inclination=final_inclination(scene, self.film),
            tabulated_law=_tabulated_law(scene)
            if "contact" in sections
            else self.tabulated_law,
        )
        rate = _step_rate(plan, plan.contact, self.is_two_way_from_release)
        return replace(plan, step_rate=rate)

    def coupled_part(self, **sections: Any) -> "MotionPlan":
        """Return the plan of the part in which the table acts back on the disk.

        A rigid contact becomes elastic and remains smooth; the roughness of an elastic
        contact is kept.

        Parameters
        ----------
        **sections
            Sections that replace those of the scene, as in `part`.

        Returns
        -------
        MotionPlan
            The plan.
        """
        contact = self.scene.contact
        roughness = self.scene.roughness
        if contact.law == "rigid":
            contact = SwitchedContact(**{**vars(contact), "law": "elastic"})
            roughness = None
        surface: Any = self.scene.surface
        coupled = replace(self, contact=ModelChoice("full", self.two_way.reason))
        return coupled.part(
            contact=contact,
            roughness=roughness,
            surface=replace(surface, action="motion"),
            **sections,
        )


def plan_motion(scene: MotionScene, surface_modes: Any = None) -> MotionPlan:
    """Make the decisions of the motion of a scene.

    Parameters
    ----------
    scene : MotionScene
        The scene, or any object with some of its attributes, as for `simulate`.
    surface_modes : modal.SurfaceModes, optional
        Modes of the table, as returned by `modal.surface_modes(scene)`. They replace
        those of a scene that lists its modes. Without them, the reaction of a plate or a
        mesh remains undecided (`MotionPlan.lacks_surface_modes`) until
        `MotionPlan.with_surface_modes`.

    Returns
    -------
    MotionPlan
        The decisions.

    Raises
    ------
    ValueError
        If the requested air film, contact or two-way coupling is impossible, or if a
        height profile cannot be read.

    Examples
    --------
    >>> from dynamics import plan_motion
    >>> from sonify import load_scene
    >>> plan = plan_motion(load_scene("coin"))
    >>> plan.contact.kind, plan.contact.reason
    ('many', "numerics.contact = 'many'")
    """
    scene = as_motion_scene(scene)
    basis = motion_basis(scene)
    tabulated_law = None if scene.contact.law == "rigid" else _tabulated_law(scene)
    contact = _contact_choice(basis, tabulated_law)
    obstacle = _obstacle_to_two_way(basis, contact.kind)
    plan = MotionPlan(
        **vars(basis),
        tabulated_law=tabulated_law,
        contact=contact,
        step_rate=_step_rate(basis, contact),
        obstacle_to_two_way=obstacle,
        two_way=_undecided_reaction(scene, obstacle),
        surface_modes=None,
    )
    if plan.rolls_on_roughness and isinstance(scene.surface, InfiniteSurface):
        return _coupled_by_error(plan)
    if surface_modes is None and isinstance(scene.surface, ModesSurface):
        from dynamics.compliant.modes_from_scene import modes_from_numbers

        surface_modes = modes_from_numbers(scene.surface, scene.disk.radius)
    return plan if surface_modes is None else plan.with_surface_modes(surface_modes)


def _coupled_by_error(plan: MotionPlan) -> MotionPlan:
    """Return the plan of a rough contact with the coupling that its error requires.

    One-way coupling suffices if it changes the level of the table by less than
    MAX_ONE_WAY_LEVEL_ERROR. Otherwise the contact model is that for the force on the
    yielding table: the filter with the receptance of the table, or time steps with its
    modes from the release on. The filter hands over to time steps where the table acts on
    the motion or the filter is not valid.
    """
    from dynamics.compliant.rough_table import predict_rough_table, scene_receptance

    scene = plan.scene
    receptance = scene_receptance(scene, plan.surface_modes)
    found = predict_rough_table(plan, receptance)
    plan = replace(plan, rough_table=found)
    if found.needs_two_way:
        choice = _contact_choice(plan, plan.tabulated_law, receptance)
        obstacle = _obstacle_to_two_way(plan, choice.kind)
        plan = replace(plan, contact=choice, obstacle_to_two_way=obstacle)
        if choice.kind != "filter" and not obstacle:
            reaction = TableReaction(True, float(found.inclination[0]), found.reason)
            rate = _step_rate(plan, choice, moves_table=True)
            return replace(plan, two_way=reaction, step_rate=rate)
    reaction = _late_reaction(plan, found)
    obstacle = "" if reaction.is_two_way else plan.obstacle_to_two_way
    rate = _step_rate(plan, plan.contact)
    return replace(plan, two_way=reaction, obstacle_to_two_way=obstacle, step_rate=rate)


def _late_reaction(plan: MotionPlan, rough_table: "RoughTable") -> TableReaction:
    """Return the reaction on the motion on a rough contact that begins on the way.

    It begins where the table acts on the motion, or where the filter of the vibration is
    not valid. `rough_table` gives the reason for the coupling of the vibration."""
    reason = rough_table.reason
    obstacle = plan.obstacle_to_two_way
    if plan.surface_modes is None:
        return TableReaction(False, 0.0, reason, obstacle)
    from dynamics.compliant.two_way_onset import (
        MAX_REACTION_BEFORE_LIFT_OFF,
        NO_LATE_TABLE_IN_STEPS,
        film_lifts_first,
        table_reaction,
    )

    inclination, late = table_reaction(plan, plan.surface_modes)
    if plan.filter_is_two_way and rough_table.linear_until > inclination:
        inclination = rough_table.linear_until
        late = rough_table.limit
    if not inclination:
        return TableReaction(False, 0.0, reason)
    if plan.contact.kind != "filter":
        obstacle = obstacle or NO_LATE_TABLE_IN_STEPS
    elif (
        obstacle == film_lifts_first(plan)
        and inclination > MAX_REACTION_BEFORE_LIFT_OFF
    ):
        obstacle = ""
    return TableReaction(not obstacle, inclination, f"{reason}; {late}", obstacle)


def rattling_end_error(scene: MotionScene) -> float:
    """Return the predicted error [s] of the end of a motion that rattles on a rough table."""
    duration_scatter = 0.02  # relative, with the time step
    return duration_scatter * rattling_duration(scene)


def motion_basis(scene: MotionScene) -> MotionBasis:
    """Return the constants, air film, loads and final inclination of a scene."""
    constants = scene_constants(scene)
    decision = decide_film(scene, constants)
    resistance = resistance_of(scene.dissipation, scene.disk)
    return MotionBasis(
        scene=scene,
        constants=constants,
        film_decision=decision,
        loads=combined_loads(resistance, decision.film),
        final_inclination=final_inclination(scene, decision.film),
    )


def _tabulated_law(scene: MotionScene) -> "TabulatedLaw":
    """Return the tabulated law of the elastic contact of a scene."""
    from dynamics.compliant.model_inputs import tabulated_contact_law  # loads SciPy

    return tabulated_contact_law(scene)


def _contact_choice(
    basis: MotionBasis,
    tabulated_law: "TabulatedLaw | None",
    *receptance: "TableReceptance",
) -> ModelChoice:
    """Select the contact model of a scene; see `numerics.contact`.

    `receptance` is that of a table with two-way coupling, if there is one."""
    scene = basis.scene
    if tabulated_law is None:
        return ModelChoice("rigid", "contact.law = 'rigid'")
    if scene.numerics.contact == "many":
        return ModelChoice("many", "numerics.contact = 'many'")
    if scene.imperfection:
        return ModelChoice("full", "imperfection: the table is wavy")
    from dynamics.compliant.model_selection import choose_contact_model

    return ModelChoice(*choose_contact_model(basis, tabulated_law, *receptance))


def _step_rate(
    basis: MotionBasis, contact: ModelChoice, moves_table: bool = False
) -> float:
    """Return the time steps per second [1/s] of a contact model; 0 if it has none.

    A disk on a moving table passes through all inclinations."""
    if contact.kind == "full":
        from dynamics.compliant.model_inputs import step_rate

        final = 0.0 if moves_table else basis.final_inclination
        return step_rate(basis.scene, final)
    if contact.kind == "many":
        from dynamics.rattling.rattling_motion import rattling_step_rate

        return rattling_step_rate(basis.scene)
    return 0.0


def _obstacle_to_two_way(basis: MotionBasis, model: ContactModel) -> str:
    """Return the reason why two-way coupling to a table is impossible or has no effect,
    or "".

    Raises ValueError if it is requested although it is impossible, or if a wavy table
    does not have the contact that it requires.
    """
    scene = basis.scene
    surface = scene.surface
    not_full = _reason_against_full_model(scene)
    if scene.imperfection is not None and not_full:
        raise ValueError(f"imperfection with {not_full}")
    if requests_two_way_filter(scene):
        return "numerics.contact = 'filter': the table moves with the vibration only"
    if surface.kind in ("rigid", "infinite"):
        obstacle = (
            f"surface.kind = '{surface.kind}': two-way coupling requires table modes"
        )
    else:
        from dynamics.compliant.two_way_onset import reason_against_two_way

        obstacle = reason_against_two_way(basis, model)
    if surface.action == "motion":
        obstacle = obstacle or not_full
        if obstacle:
            raise ValueError(f"surface.action = 'motion' with {obstacle}")
    return obstacle


def requests_two_way_filter(scene: MotionScene) -> bool:
    """Return True if a scene requests the filter of a rough contact with the receptance
    of its table, by surface.action = 'motion' and numerics.contact = 'filter'."""
    return (
        scene.surface.action == "motion"
        and scene.numerics.contact == "filter"
        and scene.contact.law == "elastic"
        and scene.roughness is not None
    )


def _reason_against_full_model(scene: MotionScene) -> str:
    """Return the reason why the contact of a scene is not solved in full, or ""."""
    if scene.contact.law == "rigid":
        return "contact.law = 'rigid': two-way coupling requires an elastic contact"
    if scene.numerics.contact == "filter":
        return "numerics.contact = 'filter': two-way coupling requires 'full'"
    return ""


def _undecided_reaction(scene: MotionScene, obstacle: str) -> TableReaction:
    """Return the reaction of a table whose modes are unknown."""
    if scene.surface.action == "sound":
        return TableReaction(False, 0.0, "surface.action = 'sound'")
    return TableReaction(False, 0.0, obstacle or "the modes of the table are unknown")
