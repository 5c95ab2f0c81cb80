"""What follows the loss of the rolling contact: a landing, or another rolling motion."""

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
from dynamics.motion import Motion, Outcome
from dynamics.motion_plan import MotionPlan

DEFAULT_STOP_RESTITUTION = 0.79
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
MAX_RIM_FRICTION = 10.0
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
    motion = rolling
    steps_left = MAX_STEPS
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
        t = float(motion.t[-1])
        left = plan.scene.numerics.time_limit - t
        motion = ResumedMotion(plan, motion, roll(landing.rolling_columns(), t, left))
    return motion


def landing_after(
    motion: Motion,
    plan: MotionPlan,
    restitution: float | None = None,
    may_roll: bool = False,
    max_steps: int = MAX_STEPS,
) -> LandingMotion | None:
    """Solve the motion of a disk that has lost its rolling contact, over a rigid table.

    The low point of the rim is at rest vertically when the disk leaves the table.

    Parameters
    ----------
    motion : Motion
        The rolling motion.
    plan : MotionPlan
        Its decisions.
    restitution : float, optional
        Coefficient of restitution of a level disk on the asperities, in (0, 1]; by
        default that of the contact, or DEFAULT_STOP_RESTITUTION.
    may_roll : bool, optional
        True if the motion ends where the disk rolls steadily on one rim again.
    max_steps : int, optional
        Largest number of time steps.

    Returns
    -------
    LandingMotion or None
        The motion, or None if the rolling motion does not end in the loss of contact: the
        disk is at rest, or the time limit is reached, or it is a shell.

    Raises
    ------
    ArithmeticError
        If the integrator fails.
    """
    scene = plan.scene
    cause = LANDING_CAUSES.get(motion.rolling_outcome)
    left = scene.numerics.time_limit - float(motion.t[-1])
    disk = motion.disk
    if cause is None or disk.shape != "solid" or left <= 0:
        return None
    fillet = motion.rolling_fillet
    film = None
    if motion.film:
        film = film_below(disk.radius, fillet, scene.air, scene.surface.curvature)
    restitution = restitution or scene.contact.restitution or DEFAULT_STOP_RESTITUTION
    stop = stop_below(disk.radius - fillet, disk.mass, restitution)
    model = LandingModel(disk, film, stop, rim_friction(plan))
    start = motion.at(motion.t[-1])[0]
    return solve_landing_motion(
        model,
        start,
        fillet,
        cause,
        left,
        plan=plan,
        may_roll=may_roll,
        max_steps=max_steps,
    )


def rim_friction(plan: MotionPlan) -> RimFriction:
    """Return the friction of a plan: its dynamic coefficient, constant arms and power laws."""
    friction = plan.scene.friction
    arm = friction.arm_pivoting
    return RimFriction(
        min(friction.mu_dynamic, MAX_RIM_FRICTION),
        (
            friction.arm_nutation,
            friction.arm_rolling,
            0.0 if isinstance(arm, str) else arm,
        ),
        tuple(power_laws(plan.scene.dissipation, plan.scene.disk)),
    )
