"""Guards: functions of the state that fall through zero where a regime ends."""

from collections.abc import Callable
from enum import Enum
from typing import TYPE_CHECKING, Any, NamedTuple, Self

if TYPE_CHECKING:
    from dynamics.equations import NumberOrExpression

AXES = ("nutation", "rolling", "pivoting")
"""Names of the rotations about a_1, a_2, a_3, which are resisted by the moments (3.3)."""
STOP_SLIP_SPEED = 1e-9
"""Slip speed divided by r at which one linear step ends a slide, with a second-order
error."""
FALL_RATE_THRESHOLD = 10.0
"""Value of omega_1/sqrt(inclination) above which the disk falls flat with energy left.

The ratio is at most one for a disk that comes to rest. The guard is omitted if an air
film cushions the fall."""


class GuardKind(Enum):
    """What happens when a guard crosses zero."""

    END = "the motion ends"
    JAM = "no normal force solves the balance laws"
    GRIP = "a slide comes to rest"
    SLIP = "friction no longer holds the contact"
    REVERSES = "a rotation comes to rest"
    UNSTICKS = "a moment no longer holds a rotation"


class GuardArguments(NamedTuple):
    """Arguments of the guards.

    They are r, omega_1/r, omega_3/r, the value of GRIP (`slip`), omega.a_i/r (`turns`),
    the contact loads, the signs of omega.a_i, the constants of the disk, the value of r at which the motion ends,
    and the square root and cosine for the scalar type of the flow.
    """

    r: Any
    w1: Any
    w3: Any
    slip: Any
    turns: Any
    contact: Any
    senses: Any
    constants: Any
    r_end: Any
    root: Callable[..., Any]
    cos: Callable[..., Any]


class Guard(str):
    """A guard, identified by its name.

    `kind` is its consequence, and `axis` is the index of its rotation, if any.
    `value(where)` evaluates it at `GuardArguments`. `applies_to(branch)` is True if a
    branch requires it.
    """

    kind: GuardKind
    axis: Any
    value: Callable[[GuardArguments], Any]
    applies_to: Callable[[Any], bool]

    def __new__(
        cls,
        name: str,
        kind: GuardKind,
        value: Callable[[GuardArguments], Any],
        applies_to: Callable[[Any], bool] = lambda branch: True,
        axis: int | None = None,
    ) -> Self:
        """Create the guard `name`."""
        guard = super().__new__(cls, name)
        guard.kind = kind
        guard.value = value
        guard.applies_to = applies_to
        guard.axis = axis
        return guard

    def __reduce__(self) -> "tuple[Callable[[str], Guard], tuple[str]]":
        """Pickle the guard as its name."""
        return guard_named, (str(self),)


def _sticking_moment_margin(i: int, where: GuardArguments) -> "NumberOrExpression":
    """Return (arm^2 Phi^2 - moment^2)/arm^2, positive while (3.3) can hold rotation i."""
    arm = where.constants[4 + i]
    moment = where.contact[8 + i]
    limit = arm * where.contact.Phi
    return (limit * limit - moment * moment) / (arm * arm)


def _friction_cone_margin(where: GuardArguments) -> "NumberOrExpression":
    """Return the squared static friction limit minus the squared friction; see (3.2)."""
    cone = where.constants.mu_static * where.contact.Phi
    contact = where.contact
    return cone * cone - contact.F1 * contact.F1 - contact.F2 * contact.F2


def _rotation_guards(i: int) -> tuple[Guard, Guard]:
    """Return the guards of rotation i, first that of sticking, then that of turning."""
    return (
        Guard(
            f"{AXES[i]} unsticks",
            GuardKind.UNSTICKS,
            lambda at: _sticking_moment_margin(i, at),
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
UPRIGHT = Guard(
    "upright",
    GuardKind.END,
    lambda at: FALL_RATE_THRESHOLD * at.cos(at.r * at.r),
)
"""Guard that ends the motion of an upright disk.

The factor FALL_RATE_THRESHOLD gives it the same magnitude as FALLS_FLAT. Since the Taylor
integrator measures its error relative to the guards, the step lengths in air and in a
vacuum are then equal."""
FALLS_FLAT = Guard(
    "falls",
    GuardKind.END,
    lambda at: FALL_RATE_THRESHOLD - at.w1,
    lambda b: not (b.loads and b.loads.keeps_disk_off_table),
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
    lambda at: at.root(at.w3 * at.w3) - STOP_SLIP_SPEED,  # has a Taylor series at zero
    lambda b: b.loads and b.loads.nonsmooth_at_zero_precession,
)
GRIP = Guard(
    "grip", GuardKind.GRIP, lambda at: at.slip, lambda b: b.sliding and b.can_grip
)
SLIP = Guard(
    "slip",
    GuardKind.SLIP,
    _friction_cone_margin,
    lambda b: not b.sliding and b.can_slip,
)
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
