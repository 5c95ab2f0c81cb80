"""The landing that follows a rolling motion on a rigid table."""

from typing import TYPE_CHECKING

from dynamics.film.tilted_film import film_below
from dynamics.landing.equations import LandingModel
from dynamics.landing.landing_motion import (
    MAX_LANDING_INCLINATION,
    LandingMotion,
    solve_landing_motion,
)
from dynamics.landing.stop import stop_below
from dynamics.motion import Motion, Outcome

if TYPE_CHECKING:
    from dynamics.sections import MotionScene

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


def landing_after(
    motion: Motion, scene: "MotionScene", restitution: float = DEFAULT_STOP_RESTITUTION
) -> LandingMotion | None:
    """Solve the landing of a disk that has lost its rolling contact.

    The table is rigid below it. The disk leaves the table with its low point at rest.

    Parameters
    ----------
    motion : Motion
        The rolling motion.
    scene : MotionScene
        Its scene.
    restitution : float, optional
        Coefficient of restitution of a level disk on the asperities, in (0, 1].

    Returns
    -------
    LandingMotion or None
        The landing, or None if the motion does not end in one: the disk still rolls, or it
        is too steep, or it is a shell.

    Raises
    ------
    ArithmeticError
        If the integrator fails.
    """
    cause = LANDING_CAUSES.get(motion.outcome)
    start = motion.state[-1]
    is_solid = motion.disk.shape == "solid"
    if cause is None or not is_solid or not 0 < start[1] <= MAX_LANDING_INCLINATION:
        return None
    disk = motion.disk
    fillet = motion.rolling_fillet
    film = None
    if motion.film:
        film = film_below(disk.radius, fillet, scene.air, scene.surface.curvature)
    stop = stop_below(disk.radius - fillet, disk.mass, restitution)
    model = LandingModel(disk, film, stop)
    return solve_landing_motion(model, start, fillet, cause, MAX_LANDING_TIME)
