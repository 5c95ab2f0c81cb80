"""Solve the motion of a scene: `simulate`."""

import math
from collections.abc import Callable
from dataclasses import replace
from functools import partial
from importlib import import_module
from typing import Any

import numpy as np

from dynamics import guards
from dynamics.dissipation import OwnLaw
from dynamics.face_contact import (
    face_outcome,
    outcome_when_flat,
    turn_in_last_decade,
)
from dynamics.hybrid import EVENT_CASCADE, STALLED, Arc, Path, StalledError, run_events
from dynamics.motion import Motion, Outcome, Transition, read_only
from dynamics.motion_plan import MotionPlan, plan_motion
from dynamics.piecewise_polynomial import PiecewisePolynomials
from dynamics.regime import (
    FLOAT_FORMULAS,
    R,
    Regime,
    angular_velocity,
    slip_velocity,
)
from dynamics.rigid_motion import RigidMotion
from dynamics.rolling import RollingDisk, initial_state, rolling_state
from dynamics.sections import MotionScene
from dynamics.solver_settings import resolved_integrator_name
from dynamics.switching import ImpossibleContactError, NoContactAtReleaseError

OUTCOMES = {
    guards.FLAT: Outcome.SETTLED,
    guards.FALLS_FLAT: Outcome.FELL,
    guards.UPRIGHT: Outcome.UPRIGHT,
    guards.LIFT_OFF: Outcome.LIFTED_OFF,
    guards.PRECESSION_STOPS: Outcome.PRECESSION_STOPPED,
    EVENT_CASCADE: Outcome.CASCADE,
    STALLED: Outcome.STALLED,
    None: Outcome.ROLLING_ON,
}
"""Outcome of a motion for the guard that ended it, or None at the time limit."""
Watch = Callable[[float, float, str], None]
"""Progress callback that receives time [s], inclination [rad] and the current task."""


def simulate(
    scene: MotionScene,
    watch: Watch = lambda t, inclination, doing: None,
    loads: OwnLaw | None = None,
    surface_modes: Any = None,
) -> Motion:
    """Solve the motion of a scene.

    A disk that loses its rolling contact moves on as a rigid body over a rigid table,
    until it is at rest or rolls again. The contact is rigid, unless the scene has an
    elastic contact that must be solved in full (`numerics.contact`). The coupling to the
    table depends on `surface.action`:

    * "sound": no coupling. The motion is the same as on a rigid table.
    * "motion": two-way coupling from the release on.
    * "auto": two-way coupling from the inclination at which the table modes store 1 % of the
      energy of the disk, or absorb 1 % of the dissipated power; from the release on if
      the disk rattles. It is not used for a wavy edge or table (`imperfection`) or an
      infinite plate. A rough contact on which the disk rolls is coupled if one-way
      coupling would change the A-weighted level of the table by more than 1 dB: its
      vibration by a linear filter with the receptance of the table, or the motion from
      the release on where contact is lost. The filter hands over to time steps below the
      inclination at which the table acts on the motion, unless the film lifts the disk.

    If `surface.kind` is "modes", the scene contains the modes; those below 24 kHz are
    used, and the motion equals that of `sonify.solve(scene)`. A plate or a mesh
    requires `surface_modes`. To reproduce the motion of `sonify.solve`, which uses
    the modes below 20 kHz, call `simulate(scene,
    surface_modes=sonify.solve(scene).table)`.

    Parameters
    ----------
    scene : MotionScene
        The scene, or any object with some of its attributes; missing sections have
        their defaults. It is not modified, so threads may share it.
    watch : callable, optional
        Progress callback `watch(t, inclination, doing)` [s, rad]. Before a compilation,
        it is called with a description in `doing`.
    loads : OwnLaw, optional
        A law of dissipation that replaces `scene.dissipation` while the disk rolls. It
        requires a rigid contact or `numerics.contact = "filter"`, and a table without two-way coupling.
    surface_modes : modal.SurfaceModes, optional
        Modes of the table, as returned by `modal.surface_modes(scene)`. They replace
        those of the scene and are ignored without two-way coupling.

    Returns
    -------
    Motion
        The solved motion, read-only; threads may share it.

    Raises
    ------
    ImpossibleContactError
        If no contact force satisfies the balance laws; the message gives time and
        state.
    ValueError
        If the `surface_modes` required for two-way coupling are missing or do not fit
        the contact, if a height profile cannot be read, or if the contact or the table
        does not support `loads`.

    References
    ----------
    .. [1] Equations (4.7) of the rolling disk, (5.3) of the sliding disk, and (3.2), (3.3)
       for the switching between them.

    Examples
    --------
    >>> from dynamics import simulate
    >>> from sonify import load_scene
    >>> motion = simulate(load_scene("published").replace("numerics.accuracy=draft"))
    >>> f"{motion.t_end:.2f} s"
    '19.38 s'
    """
    plan = plan_motion(scene, surface_modes)
    require_surface_modes(plan)
    if loads is not None:
        plan = plan.with_own_law(loads)
    return solve_planned_motion(plan, watch)


def solve_planned_motion(
    plan: MotionPlan, watch: Watch = lambda t, inclination, doing: None
) -> Motion:
    """Solve the motion of a plan; see `simulate`, which makes the plan from a scene."""
    from dynamics.landing.after_rolling import landed, landed_from_release

    require_surface_modes(plan)
    roll = None
    if plan.contact.kind != "full":
        roll = partial(_solve_rolling_again, plan, watch)
    try:
        rolling = solve_rolling_motion(plan, watch)
    except NoContactAtReleaseError:
        if plan.scene.disk.shape != "solid":
            raise
        return landed_from_release(plan, roll)
    return landed(rolling, plan, roll)


def solve_rolling_motion(
    plan: MotionPlan, watch: Watch = lambda t, inclination, doing: None
) -> Motion:
    """Solve the motion of a plan up to the loss of the rolling contact."""
    if plan.switches_to_two_way:
        from dynamics.compliant.switched_motion import solve_switched

        return solve_switched(plan, _solve_one_model, watch)
    return _solve_one_model(plan, watch)


def _solve_rolling_again(
    plan: MotionPlan, watch: Watch, columns: np.ndarray, begin: float, limit: float
) -> Motion:
    """Solve the motion of a disk that rolls in a state of COLUMNS (11,), up to a time limit [s].

    The motion starts at the time `begin` [s] of the whole motion.
    """
    numerics = replace(plan.scene.numerics, time_limit=limit)
    part = plan.part(numerics=numerics)

    def watch_whole(t: float, inclination: float, doing: str) -> None:
        watch(begin + t, inclination, doing)

    if plan.contact.kind == "many":
        from dynamics.rattling.rattling_motion import solve_rattling_motion

        return solve_rattling_motion(part, watch_whole, columns)
    start = rolling_state(plan.scene.disk, columns)
    return _solve_rigid_motion(part, watch_whole, start)


def require_surface_modes(plan: MotionPlan) -> None:
    """Raise ValueError if the motion may depend on modes of the table that are unknown."""
    surface = plan.scene.surface
    if plan.lacks_surface_modes:
        raise ValueError(
            f"surface.kind = '{surface.kind}' with surface.action = '{surface.action}': "
            f"the table may affect the motion; give "
            f"surface_modes=modal.surface_modes(scene), or set surface.action = 'sound'"
        )


def _solve_one_model(plan: MotionPlan, watch: Watch) -> Motion:
    """Solve the motion of a plan with its contact model up to the end."""
    if plan.contact.kind == "many":
        from dynamics.rattling.rattling_motion import solve_rattling_motion

        return solve_rattling_motion(plan, watch)
    if plan.contact.kind == "full":
        from dynamics.compliant.compliant_motion import solve_compliant_motion

        return solve_compliant_motion(plan, watch)
    return _solve_rigid_motion(plan, watch)


def _solve_rigid_motion(
    plan: MotionPlan, watch: Watch, start: list[float] | None = None
) -> RigidMotion:
    """Solve the motion of a plan on a rigid contact, from its release or a state (11,)."""
    compile_in_background(plan)
    scene = plan.scene
    progress = _Progress(scene, watch)
    system = replace(
        rigid_contact_system(plan),
        announce_compilation=progress.announce_compilation,
    )
    start = start or initial_state(scene.disk, scene.release)
    time_limit = scene.numerics.time_limit / scene.disk.time_unit
    try:
        path, guard = run_events(system, start, time_limit, progress.record)
    except NoContactAtReleaseError as error:
        raise NoContactAtReleaseError(f"at t = {progress.t:.9g} s: {error}") from None
    except (ImpossibleContactError, StalledError) as error:
        raise ImpossibleContactError(f"at t = {progress.t:.9g} s: {error}") from None
    outcome = outcome_after_guard(guard, progress.state, system)
    motion = _rigid_motion_from_path(plan, path, outcome)
    contact_loss_load = 1e-9  # normal force divided by the weight
    if guard == EVENT_CASCADE:
        load = motion.normal_load(motion.t[-1])[0]
        if load < contact_loss_load:
            # Without it, friction cannot hold the contact and the regimes alternate.
            outcome = outcome_after_guard(guards.LIFT_OFF, progress.state, system)
            return replace(motion, rolling_outcome=outcome)
    if outcome is Outcome.FELL:
        return replace(motion, rolling_outcome=face_outcome(motion))
    if outcome is Outcome.SETTLED and motion.film is not None:
        outcome = outcome_when_flat(motion, turn_in_last_decade(motion))
        return replace(motion, rolling_outcome=outcome)
    return motion


class _Progress:
    """Report the progress to a callback and store the last state."""

    def __init__(self, scene: MotionScene, watch: Watch) -> None:
        self.t = 0.0
        self.inclination = math.radians(scene.release.inclination_deg)
        self.state: Any = None
        self._time_unit = scene.disk.time_unit
        self._watch = watch
        self._announced: set[str] = set()

    def record(self, tau: float, y: list[float]) -> None:
        """Report the state y at dimensionless time tau."""
        self.t = tau * self._time_unit
        self.inclination = y[R] ** 2
        self.state = y
        self._watch(self.t, self.inclination, "")

    def announce_compilation(self, flow: str) -> None:
        """Report once that the code of a flow may have to be compiled."""
        if flow not in self._announced:
            self._announced.add(flow)
            self._watch(self.t, self.inclination, f"compiling the flow of '{flow}'")


def outcome_after_guard(guard: str | None, y: Any, system: RollingDisk) -> Outcome:
    """Return the outcome of a motion that ended with `guard` at state y.

    A disk that lifts off is airborne if the lift of the loads is not negligible
    compared with its weight.
    """
    min_film_share = 0.01  # of the weight
    if guard == guards.LIFT_OFF and system.loads:
        beta = y[R] * y[R]
        motion = angular_velocity(y), slip_velocity(y)
        film_lift = system.loads(beta, *motion, system.constants, FLOAT_FORMULAS).G3
        weight = (system.constants.K + 4) / 4
        if film_lift > min_film_share * weight:
            return Outcome.AIRBORNE
    return OUTCOMES[guard]


def compile_in_background(plan: MotionPlan) -> None:
    """Compile the flows that most motions of a plan need, in background threads."""
    integrator = resolved_integrator_name(plan.scene.numerics.integrator)
    if integrator != "taylor" or plan.contact.kind in ("full", "many"):
        return
    from dynamics.integrators import taylor

    system = rigid_contact_system(plan)
    can_slide = system.constants.mu_static != math.inf
    for sliding in (False, True) if can_slide else (False,):
        regime = Regime(sliding, (False,) * 3, (1.0,) * 3)
        taylor.compile_in_background(
            regime, system.constants, system.loads, system.tolerance
        )


def rigid_contact_system(plan: MotionPlan) -> RollingDisk:
    """Return the hybrid system of a plan with a rigid contact."""
    numerics = plan.scene.numerics
    return RollingDisk(
        constants=plan.constants,
        loads=plan.loads,
        r_end=math.sqrt(plan.final_inclination),
        integrate=chosen_integrator(numerics.integrator)[1],
        tolerance=numerics.chosen_tolerance,
    )


def chosen_integrator(name: str) -> tuple[str, Callable[..., Arc]]:
    """Return the resolved name of an integrator, and its function `advance`."""
    name = resolved_integrator_name(name)
    return name, import_module(f"dynamics.integrators.{name}").advance


def _rigid_motion_from_path(
    plan: MotionPlan, path: Path, outcome: Outcome
) -> RigidMotion:
    """Convert a path to a RigidMotion, without the pieces of zero duration."""
    disk = plan.scene.disk
    times = np.concatenate(path.times)
    has_duration = np.diff(times) > 0
    regimes = tuple(dict.fromkeys(regime for regime, _ in path.regimes))
    counts = [count for _, count in path.regimes]
    regime_of_piece = np.repeat(
        [regimes.index(regime) for regime, _ in path.regimes], counts
    )
    transitions = [
        Transition(t * disk.time_unit, str(before), str(after), guard)
        for t, before, after, guard in path.crossings
    ]
    return RigidMotion(
        plan=plan,
        path=PiecewisePolynomials(
            read_only(_concatenated_pieces(path.coefficients, has_duration)),
            read_only(np.append(times[0], times[1:][has_duration])),
        ),
        regimes=regimes,
        regime_of_piece=read_only(regime_of_piece[has_duration]),
        transitions=tuple(transitions),
        contact_losses=(),
        rolling_outcome=outcome,
        integrator=resolved_integrator_name(plan.scene.numerics.integrator),
    )


def _concatenated_pieces(blocks: list[np.ndarray], keep: np.ndarray) -> np.ndarray:
    """Concatenate the pieces of blocks (n, order + 1, k) selected by the mask `keep`.

    The result (highest order + 1, number of pieces, k) starts with the highest power.
    """
    order = max(block.shape[1] for block in blocks)
    terms = np.zeros((np.count_nonzero(keep), blocks[0].shape[2], order))
    ends = np.cumsum([len(block) for block in blocks])
    start = 0
    for block, keep_of_block in zip(blocks, np.split(keep, ends[:-1]), strict=True):
        kept = block if keep_of_block.all() else block[keep_of_block]
        terms[start : start + len(kept), :, : kept.shape[1]] = kept.swapaxes(1, 2)
        start += len(kept)
    return terms.transpose(2, 0, 1)[::-1]
