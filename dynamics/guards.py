"""The guards: functions of a state that are positive while a regime is valid, and fall through zero
where it ends."""

from collections.abc import Callable
from enum import Enum
from typing import Any, NamedTuple

AXES = ("nutation", "rolling", "pivoting")
"""Names of the turnings omega.a_1, omega.a_2, omega.a_3 that the moments of (3.3) resist."""
STOP_SPEED = 1e-9
"""Slip speed over r at which the rest of a slide is taken in one tangent step; its effect is of the
second order."""
FALLING = 10.0
"""omega_1 over sqrt(inclination), at most one on the way to rest, above which the disk falls flat
with energy left; a film of air would stop it."""


class Kind(Enum):
    """What follows when a guard has fallen."""

    END = "the motion ends"
    JAM = "no normal force solves the balance laws"
    GRIP = "a slide comes to rest"
    SLIP = "friction holds the contact no longer"
    REVERSES = "a turning comes to rest"
    UNSTICKS = "a moment holds a turning no longer"


class Where(NamedTuple):
    """What the equations of the guards read: r, omega_1/r, omega_3/r, what is left of a slip,
    omega.a_i/r, the contact.

    `root` and `cos` are functions of the scalars of the flow.
    """

    r: Any
    w1: Any
    w3: Any
    slip: Any
    turns: Any
    contact: Any
    senses: Any
    law: Any
    r_end: Any
    root: Callable
    cos: Callable


class Guard(str):
    """A guard by its name, which users read: its kind, the turning it is about, its equation, and
    where it acts.

    `value(where)` is the equation at `Where`; `acts(branch)` tells whether a branch has it.
    """

    kind: Kind
    axis: int | None
    value: Callable[[Where], Any]
    acts: Callable[[Any], bool]

    def __new__(
        cls, name: str, kind: Kind, value, acts=lambda branch: True, axis: int | None = None
    ):
        """Name a guard."""
        guard = super().__new__(cls, name)
        guard.kind = kind
        guard.value = value
        guard.acts = acts
        guard.axis = axis
        return guard

    def __reduce__(self):
        """Travel between processes by name."""
        return guard_of, (str(self),)


def _reserve(i: int, where: Where):
    """How far the moment that holds turning i is from what it can hold, the square of arm times
    normal force (3.3)."""
    arm = where.law[4 + i]
    moment = where.contact[8 + i]
    limit = arm * where.contact.Phi
    return (limit * limit - moment * moment) / (arm * arm)


def _cone(where: Where):
    """How far friction is from the cone of static friction (3.2)."""
    cone = where.law.mu_static * where.contact.Phi
    contact = where.contact
    return cone * cone - contact.F1 * contact.F1 - contact.F2 * contact.F2


def _turnings(i: int) -> tuple[Guard, Guard]:
    """Return the guards of turning i, stuck or not."""
    return (
        Guard(
            f"{AXES[i]} unsticks",
            Kind.UNSTICKS,
            lambda at: _reserve(i, at),
            lambda b: b.stuck[i],
            i,
        ),
        Guard(
            f"{AXES[i]} reverses",
            Kind.REVERSES,
            lambda at: at.senses[i] * at.turns[i],
            lambda b: b.resisted[i] and not b.stuck[i],
            i,
        ),
    )


FLAT = Guard("flat", Kind.END, lambda at: at.r - at.r_end)
UPRIGHT = Guard("upright", Kind.END, lambda at: FALLING * at.cos(at.r * at.r))
"""As large as FALLS, against which Taylor's steps measure their error: so they are as long in air
as in a vacuum."""
FALLS = Guard(
    "falls", Kind.END, lambda at: FALLING - at.w1, lambda b: not (b.loads and b.loads.carries)
)
LIFT_OFF = Guard("lift-off", Kind.END, lambda at: at.contact.Phi)
JAMS = Guard(
    "jams",
    Kind.JAM,
    lambda at: at.contact.inertia,
    lambda b: b.sliding and b.can_grip and not b.stuck[0],
)
PRECESSION_STOPS = Guard(
    "precession stops",
    Kind.END,
    lambda at: at.root(at.w3 * at.w3) - STOP_SPEED,  # whose series falls on through zero
    lambda b: b.loads and b.loads.is_singular,
)
GRIP = Guard("grip", Kind.GRIP, lambda at: at.slip, lambda b: b.sliding and b.can_grip)
SLIP = Guard("slip", Kind.SLIP, _cone, lambda b: not b.sliding and b.can_slip)
ALL = (
    FLAT,
    UPRIGHT,
    FALLS,
    LIFT_OFF,
    JAMS,
    PRECESSION_STOPS,
    *sum(map(_turnings, range(3)), ()),
    GRIP,
    SLIP,
)
_NAMED = {str(guard): guard for guard in ALL}


def guard_of(name: str) -> Guard:
    """Return the guard of a name."""
    return _NAMED[name]
