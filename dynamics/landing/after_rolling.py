"""What follows the loss of the rolling contact, or a release without it: a landing, or
another rolling motion."""

from collections.abc import Callable

import numpy as np

from dynamics.dissipation import power_laws
from dynamics.film.tilted_film import film_below
from dynamics.landing.continued_motion import LandedMotion, ResumedMotion
from dynamics.landing.equations import LandingModel
from dynamics.landing.landing_motion import LandingMotion, solve_landing_motion
from dynamics.landing.rim_friction import RimFriction
from dynamics.landing.solution import MAX_STEPS
from dynamics.landing.stop import stop_below
from dynamics.motion import Motion, Outcome, release_columns
from dynamics.motion_plan import MotionPlan

DEFAULT_ASPERITY_RESTITUTION = 0.79
"""Coefficient of restitution of a level disk on the asperities."""
LANDING_CAUSES = {
    Outcome.AIRBORNE: "lifted by the film",
    Outcome.FELL: "falls about its contact",
    Outcome.LIFTED_OFF: "loses contact",
    Outcome.UPRIGHT: "stands upright",
}
"""Kind of the event that begins a landing, by the outcome of the rolling motion."""
MAX_RESUMPTIONS = 200
"""Number of times that a disk may roll again; after that, its contacts are solved to the end."""
NO_SLIP_FRICTION_COEFFICIENT = 10.0
"""Coefficient of friction of a rim that never slips as it rolls."""
RollingSolver = Callable[[np.ndarray, float, float], Motion]
"""Function that solves a rolling motion from COLUMNS (11,) at a time [s] for a duration [s]."""


def landed(rolling: Motion, plan: MotionPlan, roll: RollingSolver | None) -> Motion:
    """Return a rolling motion with all that follows the loss of its contact.

    Parameters
    ----------
    rolling : Motion
        The rolling motion.
    plan : MotionPlan
        The decisions of the whole motion.
    roll : RollingSolver or None
        Solves the motion of a disk that rolls again, or None if the contact that ended is
        not rigid; such a disk is solved with the contacts of the landing to the end.

    Returns
    -------
    Motion
        The rolling motion itself if it does not end in the loss of its contact, or else a
        `LandedMotion`; its `rolling` motion may be a `ResumedMotion`.

    Raises
    ------
    ArithmeticError
        If the integrator fails.
    """
    return _landed(rolling, plan, roll, MAX_STEPS)


def landed_from_release(plan: MotionPlan, roll: RollingSolver | None) -> Motion:
    """Return the motion of a disk that does not roll at its release.

    It leaves the table at once, or is too steep for the contacts anywhere on its rim.

    Parameters
    ----------
    plan : MotionPlan
        The decisions of the whole motion.
    roll : RollingSolver or None
        As for `landed`.

    Returns
    -------
    Motion
        A `LandingMotion`, or a `ResumedMotion` with all that follows it.

    Raises
    ------
    ArithmeticError
        If the integrator fails.
    """
    start = release_columns(plan.scene.release)
    fillet = plan.scene.contact.rolling_fillet(plan.scene.disk)
    limit = plan.scene.numerics.time_limit
    landing = solve_landing_motion(
        _landing_model(plan, fillet),
        start,
        fillet,
        "released",
        limit,
        plan=plan,
        max_rolling_inclination=plan.max_rolling_inclination,
        may_roll=roll is not None,
    )
    if not landing.rolls_on:
        return landing
    assert roll is not None
    return _landed(
        _rolling_again(plan, landing, landing, roll),
        plan,
        roll,
        MAX_STEPS - landing.solution.steps,
    )


def _rolling_again(
    plan: MotionPlan,
    motion: LandedMotion | LandingMotion,
    landing: LandingMotion,
    roll: RollingSolver,
) -> ResumedMotion:
    """Return a motion that ends with a landing, and the rolling motion that follows."""
    t = float(motion.t[-1])
    left = plan.scene.numerics.time_limit - t
    return ResumedMotion(plan, motion, roll(landing.rolling_columns(), t, left))


def _landed(
    rolling: Motion, plan: MotionPlan, roll: RollingSolver | None, steps_left: int
) -> Motion:
    """Return a rolling motion with what follows; see `landed`."""
    motion = rolling
    for resumptions in range(MAX_RESUMPTIONS + 1):
        may_roll = roll is not None and resumptions < MAX_RESUMPTIONS
        landing = landing_after(motion, plan, may_roll=may_roll, max_steps=steps_left)
        if landing is None:
            return motion
        steps_left -= landing.solution.steps
        motion = LandedMotion(plan, motion, landing)
        if not landing.rolls_on:
            return motion
        assert roll is not None
        motion = _rolling_again(plan, motion, landing, roll)
    return motion


def landing_after(
    motion: Motion,
    plan: MotionPlan,
    restitution: float | None = None,
    may_roll: bool = False,
    max_steps: int = MAX_STEPS,
) -> LandingMotion | None:
    """Solve the motion of a disk that has lost its rolling contact, over a rigid table.

    The low point of the rim is on the table when the disk leaves it, with the
    `lift_off_speed` of the rolling motion.

    Parameters
    ----------
    motion : Motion
        The rolling motion.
    plan : MotionPlan
        Its decisions.
    restitution : float, optional
        Coefficient of restitution of a level disk on the asperities, in (0, 1]; by
        default that of the contact, or DEFAULT_ASPERITY_RESTITUTION.
    may_roll : bool, optional
        True if the motion ends where the disk rolls steadily on one rim again.
    max_steps : int, optional
        Largest number of time steps.

    Returns
    -------
    LandingMotion or None
        The motion, or None if the rolling motion does not end in the loss of contact: the
        disk is at rest, or the time limit is reached, or it is a shell in a vacuum.

    Raises
    ------
    ArithmeticError
        If the integrator fails.
    """
    scene = plan.scene
    cause = LANDING_CAUSES.get(motion.rolling_outcome)
    if motion.film and motion.rolling_outcome is Outcome.PRECESSION_STOPPED:
        cause = "stops precessing"
    left = scene.numerics.time_limit - float(motion.t[-1])
    is_solved = motion.disk.shape == "solid" or bool(motion.film)
    if cause is None or not is_solved or left <= 0:
        return None
    fillet = motion.rolling_fillet
    model = _landing_model(plan, fillet, restitution, has_film=bool(motion.film))
    start = motion.at(motion.t[-1])[0]
    return solve_landing_motion(
        model,
        start,
        fillet,
        cause,
        left,
        rise=motion.lift_off_speed,
        plan=plan,
        max_rolling_inclination=plan.max_rolling_inclination,
        may_roll=may_roll,
        max_steps=max_steps,
    )


def _landing_model(
    plan: MotionPlan,
    fillet: float,
    restitution: float | None = None,
    has_film: bool | None = None,
) -> LandingModel:
    """Return the model of a disk whose edge has a radius [m]; see `landing_after`."""
    scene = plan.scene
    disk = scene.disk
    film = None
    if plan.film is not None if has_film is None else has_film:
        table = scene.surface
        hole = max(table.hole, 2 * disk.inner_radius)
        film = film_below(disk.radius, fillet, scene.air, table.curvature, hole)
    restitution = (
        restitution or scene.contact.restitution or DEFAULT_ASPERITY_RESTITUTION
    )
    stop = stop_below(disk.radius - fillet, disk.mass, restitution)
    return LandingModel(disk, film, stop, rim_friction(plan))


def rim_friction(plan: MotionPlan) -> RimFriction:
    """Return the friction of a plan: its dynamic coefficient, arms and power laws."""
    friction = plan.scene.friction
    arm = friction.arm_pivoting
    return RimFriction(
        min(friction.mu_dynamic, NO_SLIP_FRICTION_COEFFICIENT),
        (
            friction.arm_nutation,
            friction.arm_rolling,
            0.0 if isinstance(arm, str) else arm,
        ),
        tuple(power_laws(plan.scene.dissipation, plan.scene.disk)),
        pivoting=tuple(plan.constants.pivoting),
    )
