"""The landing that follows a rolling motion on a rigid table."""

from dynamics.film.tilted_film import film_below
from dynamics.landing.equations import LandingModel
from dynamics.landing.landed_motion import LandedMotion
from dynamics.landing.landing_motion import (
    MAX_LANDING_INCLINATION,
    LandingMotion,
    solve_landing_motion,
)
from dynamics.landing.stop import stop_below
from dynamics.motion import Motion, Outcome
from dynamics.motion_plan import MotionPlan

DEFAULT_STOP_RESTITUTION = 0.79
"""Coefficient of restitution of a level disk on the asperities."""
LANDING_CAUSES = {
    Outcome.AIRBORNE: "lifted by the film",
    Outcome.FELL: "falls about its contact",
    Outcome.LIFTED_OFF: "loses contact",
}
"""Kind of the event that begins a landing, by the outcome of the rolling motion."""
MAX_LANDING_TIME = 2.0
"""Longest duration of a landing [s]."""


def landed(rolling: Motion, plan: MotionPlan) -> Motion:
    """Return a rolling motion with its landing on the film of air, if there is one.

    Parameters
    ----------
    rolling : Motion
        The rolling motion.
    plan : MotionPlan
        The decisions of the whole motion.

    Returns
    -------
    Motion
        A `LandedMotion`, or the rolling motion itself; see `landing_after`.

    Raises
    ------
    ArithmeticError
        If the integrator fails.
    """
    landing = landing_after(rolling, plan) if rolling.film else None
    return rolling if landing is None else LandedMotion(plan, rolling, landing)


def landing_after(
    motion: Motion, plan: MotionPlan, restitution: float | None = None
) -> LandingMotion | None:
    """Solve the landing of a disk that has lost its rolling contact.

    The table is rigid below it. The disk leaves the table with its low point at rest.

    Parameters
    ----------
    motion : Motion
        The rolling motion.
    plan : MotionPlan
        Its decisions.
    restitution : float, optional
        Coefficient of restitution of a level disk on the asperities, in (0, 1]; by
        default that of the contact, or DEFAULT_STOP_RESTITUTION.

    Returns
    -------
    LandingMotion or None
        The landing, or None if the motion does not end in one: the disk still rolls or
        rattles, or it is too steep, or it is a shell, or the time limit is reached.

    Raises
    ------
    ArithmeticError
        If the integrator fails.
    """
    scene = plan.scene
    cause = LANDING_CAUSES.get(motion.outcome)
    start = motion.state[-1]
    left = min(MAX_LANDING_TIME, scene.numerics.time_limit - float(motion.t[-1]))
    disk = motion.disk
    is_nearly_flat = 0 < start[1] <= MAX_LANDING_INCLINATION
    rolls_on_edge = disk.shape == "solid" and motion.rim_modes is None
    if cause is None or not (is_nearly_flat and rolls_on_edge and left > 0):
        return None
    fillet = motion.rolling_fillet
    film = None
    if motion.film:
        film = film_below(disk.radius, fillet, scene.air, scene.surface.curvature)
    restitution = restitution or scene.contact.restitution or DEFAULT_STOP_RESTITUTION
    stop = stop_below(disk.radius - fillet, disk.mass, restitution)
    model = LandingModel(disk, film, stop)
    return solve_landing_motion(model, start, fillet, cause, left, plan=plan)
