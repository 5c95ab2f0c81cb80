"""Guards: functions of the state, positive while a regime is valid and zero where it ends."""

from collections.abc import Callable
from enum import Enum
from typing import Any, NamedTuple

AXES = ("nutation", "rolling", "pivoting")
"""Names of the rotations about a_1, a_2, a_3, which the moments (3.3) resist."""
STOP_SPEED = 1e-9
"""Slip speed divided by r at which one step along the tangent ends a slide (second-order error)."""
MAX_FALL_RATE = 10.0
"""Value of omega_1/sqrt(inclination) above which the disk falls flat with energy left.

The ratio is at most one for a disk that comes to rest. An air film would stop the fall.
"""


class GuardKind(Enum):
    """Consequence of a guard that has crossed zero."""

    END = "the motion ends"
    JAM = "no normal force solves the balance laws"
    GRIP = "a slide comes to rest"
    SLIP = "friction holds the contact no longer"
    REVERSES = "a turning comes to rest"
    UNSTICKS = "a moment holds a turning no longer"


class GuardArguments(NamedTuple):
    """Arguments of the guards: r, omega_1/r, omega_3/r, slip, omega.a_i/r, contact and constants.

    `root` and `cos` are the square root and the cosine for the scalar type of the flow.
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
    """A guard, identified by its name: its kind, its rotation, its equation, and its branches.

    `value(where)` evaluates the equation at `GuardArguments`; `acts(branch)` is True if the branch has the
    guard."""

    kind: GuardKind
    axis: int | None
    value: Callable[[GuardArguments], Any]
    acts: Callable[[Any], bool]

    def __new__(
        cls, name: str, kind: GuardKind, value, acts=lambda branch: True, axis: int | None = None
    ):
        """Create the guard `name`."""
        guard = super().__new__(cls, name)
        guard.kind = kind
        guard.value = value
        guard.acts = acts
        guard.axis = axis
        return guard

    def __reduce__(self):
        """Pickle the guard by its name."""
        return guard_named, (str(self),)


def _moment_reserve(i: int, where: GuardArguments):
    """Return (arm^2 Phi^2 - moment^2)/arm^2, positive while (3.3) can hold rotation i."""
    arm = where.law[4 + i]
    moment = where.contact[8 + i]
    limit = arm * where.contact.Phi
    return (limit * limit - moment * moment) / (arm * arm)


def _friction_cone_reserve(where: GuardArguments):
    """Return the squared limit of static friction minus the squared friction force (3.2)."""
    cone = where.law.mu_static * where.contact.Phi
    contact = where.contact
    return cone * cone - contact.F1 * contact.F1 - contact.F2 * contact.F2


def _rotation_guards(i: int) -> tuple[Guard, Guard]:
    """Return the two guards of rotation i: one while it sticks, one while it turns."""
    return (
        Guard(
            f"{AXES[i]} unsticks",
            GuardKind.UNSTICKS,
            lambda at: _moment_reserve(i, at),
            lambda b: b.stuck[i],
            i,
        ),
        Guard(
            f"{AXES[i]} reverses",
            GuardKind.REVERSES,
            lambda at: at.senses[i] * at.turns[i],
            lambda b: b.resisted[i] and not b.stuck[i],
            i,
        ),
    )


FLAT = Guard("flat", GuardKind.END, lambda at: at.r - at.r_end)
UPRIGHT = Guard("upright", GuardKind.END, lambda at: MAX_FALL_RATE * at.cos(at.r * at.r))
"""Guard of an upright disk.

The factor MAX_FALL_RATE gives it the same magnitude as FALLS_FLAT. The Taylor integrator measures
its error relative to the guards, so the steps have equal lengths in air and in a vacuum.
"""
FALLS_FLAT = Guard(
    "falls",
    GuardKind.END,
    lambda at: MAX_FALL_RATE - at.w1,
    lambda b: not (b.loads and b.loads.carries),
)
LIFT_OFF = Guard("lift-off", GuardKind.END, lambda at: at.contact.Phi)
CONTACT_JAMS = Guard(
    "jams",
    GuardKind.JAM,
    lambda at: at.contact.inertia,
    lambda b: b.sliding and b.can_grip and not b.stuck[0],
)
PRECESSION_STOPS = Guard(
    "precession stops",
    GuardKind.END,
    lambda at: at.root(at.w3 * at.w3) - STOP_SPEED,  # its Taylor series continues through zero
    lambda b: b.loads and b.loads.is_singular,
)
GRIP = Guard("grip", GuardKind.GRIP, lambda at: at.slip, lambda b: b.sliding and b.can_grip)
SLIP = Guard("slip", GuardKind.SLIP, _friction_cone_reserve, lambda b: not b.sliding and b.can_slip)
ALL_GUARDS = (
    FLAT,
    UPRIGHT,
    FALLS_FLAT,
    LIFT_OFF,
    CONTACT_JAMS,
    PRECESSION_STOPS,
    *sum(map(_rotation_guards, range(3)), ()),
    GRIP,
    SLIP,
)
_GUARD_BY_NAME = {str(guard): guard for guard in ALL_GUARDS}


def guard_named(name: str) -> Guard:
    """Return the guard with this name."""
    return _GUARD_BY_NAME[name]
