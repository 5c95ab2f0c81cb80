"""Newton-Euler equations of the disk on the plane, solved for accelerations and loads.

All quantities are dimensionless as in the paper: m = R = 1, and the unit of time is
chi. The same formulas serve floats, numpy arrays, numba floats and heyoka expressions;
the given sine and cosine determine the type.
"""

import math
from collections.abc import Callable
from typing import TYPE_CHECKING, Any, NamedTuple

from dynamics.kinematics import (
    ContactPlace,
    centre_velocity,
    contact_arms,
    contact_place,
    precession_rate,
)

if TYPE_CHECKING:
    from dynamics.disk import Disk, Friction

NumberOrExpression = Any
"""Number, array or symbolic expression; the formulas hold for each of them."""


class DiskConstants(NamedTuple):
    """Dimensionless constants of a disk, its friction and its table.

    Attributes
    ----------
    h, K : float
        H/R of (4.4) and k^2 of (2.4).
    mu_static, mu_dynamic : float
        Coefficients of friction.
    k1, k2, k3 : float
        Arms of the resisting moments, divided by R.
    fillet : float
        Radius of the rounded edge, divided by R; 0 for a sharp edge.
    bowl : float
        R divided by the radius of curvature of a concave table; 0 for a plane.
    bowl_x, bowl_y : float
        Position of the origin relative to the middle of the table, divided by R.
    pivoting : tuple of float
        Coefficients of `pivoting.pivoting_arm`, which replaces k3; empty for a constant
        k3.
    """

    h: float
    K: float
    mu_static: float
    mu_dynamic: float
    k1: float
    k2: float
    k3: float
    fillet: float = 0.0
    bowl: float = 0.0
    bowl_x: float = 0.0
    bowl_y: float = 0.0
    pivoting: tuple[float, ...] = ()

    @property
    def arms(self) -> tuple[float, float, float]:
        """The arms of the resisting moments about a_1, a_2, a_3, divided by R."""
        return self.k1, self.k2, self.k3


def disk_constants(
    disk: "Disk", friction: "Friction", pivoting: tuple[float, ...] = ()
) -> DiskConstants:
    """Return the constants (4.4), (7.3) of a disk with a sharp edge."""
    return DiskConstants(
        h=disk.aspect,
        K=disk.gyration,
        mu_static=friction.mu_static,
        mu_dynamic=friction.mu_dynamic,
        k1=friction.arm_nutation / disk.radius,
        k2=friction.arm_rolling / disk.radius,
        # arm_pivoting is a number unless it is replaced by `pivoting`
        k3=0.0 if pivoting else friction.arm_pivoting / disk.radius,  # type: ignore[operator]
        pivoting=pivoting,
    )


class Loads(NamedTuple):
    """Dimensionless loads on the disk other than those of the contact.

    Parameters
    ----------
    G1, G2 : float
        Force on the centre along a_1, a_2.
    M1, M2, M3 : float
        Moment along e_1, e_2, e_3.
    G3 : float
        Force on the centre along a_3.

    Examples
    --------
    >>> from dynamics import Loads
    >>> Loads(M3=-0.1).G3
    0.0
    """

    G1: float = 0.0
    G2: float = 0.0
    M1: float = 0.0
    M2: float = 0.0
    M3: float = 0.0
    G3: float = 0.0


class ContactSolution(NamedTuple):
    """Dimensionless solution of the balance laws.

    It contains the time derivatives of omega and slip, the forces along a_1, a_2, a_3
    and the moments along -a_1, -a_2, -a_3. `inertia` is the effective inertia in the
    equation for the normal force Phi. If it is not positive, the contact problem has no
    solution or two.
    """

    domega1: float
    domega2: float
    domega3: float
    du1: float
    du2: float
    F1: float
    F2: float
    Phi: float
    m1: float
    m2: float
    m3: float
    inertia: float

    @property
    def moments(self) -> tuple[float, float, float]:
        """The resisting moments along -a_1, -a_2, -a_3."""
        return self.m1, self.m2, self.m3


NO_LOADS = Loads()


class ContactState(NamedTuple):
    """Friction and resistance of a contact.

    Attributes
    ----------
    sliding : bool
        True if the contact slides; otherwise it rolls.
    direction : tuple of float, length 2
        Slip direction (c, s) of (2.7), if the contact slides.
    stuck : tuple of bool, length 3
        True for each axis a_i about which an unknown moment keeps omega.a_i = 0.
    senses : tuple of float, length 3
        Signs of omega.a_i about the other axes.
    """

    sliding: bool
    direction: tuple[float, float]
    stuck: tuple[bool, bool, bool]
    senses: tuple[float, float, float]


class DiskMotion(NamedTuple):
    """Geometry and velocities of a disk with an angular velocity w.

    Attributes
    ----------
    sin_a, cos_a : float
        Sine and cosine of alpha = pi/2 - beta.
    place : ContactPlace
        Position of the contact.
    J1, J2 : float
        Moments of inertia about a diameter and about the axis.
    w : tuple of float, length 3
        Components of the angular velocity along e_i.
    v : tuple of float, length 2
        Velocity of the centre along a_1, a_2.
    rate : float
        Precession rate. The frame turns by (w1, rate sin a, w3).
    gyro : float
        Part of the angular momentum about e_2 that does not turn with the frame.
    """

    sin_a: float
    cos_a: float
    place: ContactPlace
    J1: float
    J2: float
    w: tuple[float, float, float]
    v: tuple[float, float]
    rate: float
    gyro: float


def disk_motion(
    sin_a: NumberOrExpression,
    cos_a: NumberOrExpression,
    w: tuple[NumberOrExpression, NumberOrExpression, NumberOrExpression],
    slip: tuple[NumberOrExpression, NumberOrExpression],
    constants: DiskConstants,
) -> DiskMotion:
    """Return the motion of a disk with an angular velocity w and a slip velocity."""
    place = contact_place(sin_a, cos_a, constants.h, constants.fillet)
    J1 = constants.K / 4 + constants.h * constants.h / 3
    J2 = constants.K / 2
    rate = precession_rate(w[2], cos_a)
    v = centre_velocity(slip, w, place)
    return DiskMotion(
        sin_a, cos_a, place, J1, J2, w, v, rate, J2 * w[1] - J1 * (rate * sin_a)
    )


class Nutation(NamedTuple):
    """Angular acceleration about e_1, with the forces and the moment that determine it.

    The names are those of `ContactSolution`.
    """

    domega1: float
    Phi: float
    F2: float
    m1: float
    inertia: float


def solve_nutation(
    motion: DiskMotion, contact: ContactState, constants: DiskConstants, loads: Loads
) -> Nutation:
    """Solve the balance of moments about e_1 together with the balance of forces.

    J1 w1' = b1 + e F2 - f Phi - m1, with Phi = weight - e w1^2 + f w1' (4.6) less the
    load G3.
    """
    w1, _, w3 = motion.w
    _, _, e, f = motion.place
    J1 = motion.J1
    weight = (constants.K + 4) / 4
    b1 = loads.M1 + motion.gyro * w3
    Phi0 = weight - (e - constants.fillet) * (w1 * w1) - loads.G3
    if contact.sliding:  # F2 = -mu s Phi
        drag = constants.mu_dynamic * contact.direction[1]
        F20 = 0.0
        F21 = 0.0
    else:  # F2 = F20 + F21 w1' keeps u2 at rest
        drag = 0.0
        F20 = motion.rate * motion.v[0] - f * (w1 * w1) - loads.G2
        F21 = -e
    resistance = contact.senses[0] * constants.k1
    if contact.stuck[0]:
        domega1 = 0.0 * Phi0
        inertia = J1
    else:
        lever = f + e * drag + resistance
        if contact.sliding:
            inertia = J1 + lever * f
        elif constants.fillet == 0:
            inertia = (
                J1 + 1 + constants.h * constants.h + resistance * f
            )  # e^2 + f^2 = 1 + h^2
        else:
            inertia = J1 + e * e + f * f + resistance * f
        domega1 = (b1 + e * F20 - lever * Phi0) / inertia
    Phi = Phi0 + f * domega1
    F2 = F20 + F21 * domega1 - drag * Phi
    m1 = b1 + e * F2 - f * Phi if contact.stuck[0] else resistance * Phi
    return Nutation(domega1, Phi, F2, m1, inertia)


class RotationBalance(NamedTuple):
    """Balance A (w2', w3') = b - m2 n2 - m3 n3 with n2 = (cos a, -sin a), n3 = (sin a, cos a).

    `roll2` and `pivot3` are the contributions of the rotation of a_2, a_3 to
    d(omega.a_i)/dtau, in addition to n2.(w2', w3') and n3.(w2', w3').
    """

    A22: float
    A23: float
    A33: float
    b2: float
    b3: float
    roll2: float
    pivot3: float


def slip_drift(
    motion: DiskMotion, constants: DiskConstants, loads: Loads
) -> NumberOrExpression:
    """Return the acceleration of the contact along a_1 less that by w2' and w3'.

    On a fillet the contact moves over the edge as the disk nutates.
    """
    w1, w2, w3 = motion.w
    drift = motion.rate * motion.v[1] + loads.G1
    if constants.fillet != 0:
        drift = drift + constants.fillet * w1 * (w2 * motion.sin_a + w3 * motion.cos_a)
    return drift


def rotation_balance(
    motion: DiskMotion,
    sliding: bool,
    F1: NumberOrExpression,
    drift: NumberOrExpression,
    loads: Loads,
) -> RotationBalance:
    """Return the balance of moments about e_2 and e_3.

    F1 is the friction along a_1 if the contact slides; otherwise F1 = radius w2' - depth
    w3' - drift keeps u1 at rest.
    """
    w1, w2, w3 = motion.w
    sin_a = motion.sin_a
    cos_a = motion.cos_a
    radius, depth, _, _ = motion.place
    b2 = loads.M2
    b3 = loads.M3 - motion.gyro * w1
    if sliding:
        A22 = motion.J2
        A23 = 0.0
        A33 = motion.J1
        b2 = b2 - radius * F1
        b3 = b3 + depth * F1
    else:
        A22 = motion.J2 + radius * radius
        A23 = -(radius * depth)
        A33 = motion.J1 + depth * depth
        b2 = b2 + radius * drift
        b3 = b3 - depth * drift
    roll2 = -w1 * (w2 * sin_a + w3 * cos_a)
    pivot3 = w1 * (w2 * cos_a - w3 * sin_a)
    return RotationBalance(A22, A23, A33, b2, b3, roll2, pivot3)


def solve_rotation(
    balance: RotationBalance,
    motion: DiskMotion,
    stuck: tuple[bool, bool, bool],
    m2: NumberOrExpression,
    m3: NumberOrExpression,
) -> tuple[
    NumberOrExpression, NumberOrExpression, NumberOrExpression, NumberOrExpression
]:
    """Return w2', w3', m2 and m3 of a balance of moments.

    The given moments m2, m3 act about the axes a_2, a_3 that are not stuck.
    """
    A22, A23, A33, b2, b3, roll2, pivot3 = balance
    sin_a = motion.sin_a
    cos_a = motion.cos_a
    _, stuck2, stuck3 = stuck
    if stuck2 and stuck3:
        domega2 = -roll2 * cos_a - pivot3 * sin_a
        domega3 = roll2 * sin_a - pivot3 * cos_a
        r2 = b2 - A22 * domega2 - A23 * domega3
        r3 = b3 - A23 * domega2 - A33 * domega3
        return (
            domega2,
            domega3,
            r2 * cos_a - r3 * sin_a,
            r2 * sin_a + r3 * cos_a,
        )
    det = A22 * A33 - A23 * A23
    if stuck2:
        q2 = (A33 * cos_a + A23 * sin_a) / det
        q3 = (-A23 * cos_a - A22 * sin_a) / det
        m2 = (q2 * (b2 - m3 * sin_a) + q3 * (b3 - m3 * cos_a) + roll2) / (
            q2 * cos_a - q3 * sin_a
        )
    if stuck3:
        q2 = (A33 * sin_a - A23 * cos_a) / det
        q3 = (A22 * cos_a - A23 * sin_a) / det
        m3 = (q2 * (b2 - m2 * cos_a) + q3 * (b3 + m2 * sin_a) + pivot3) / (
            q2 * sin_a + q3 * cos_a
        )
    r2 = b2 - m2 * cos_a - m3 * sin_a
    r3 = b3 + m2 * sin_a - m3 * cos_a
    return (A33 * r2 - A23 * r3) / det, (A22 * r3 - A23 * r2) / det, m2, m3


def equations_of_motion(
    sin: Callable[[NumberOrExpression], NumberOrExpression],
    cos: Callable[[NumberOrExpression], NumberOrExpression],
) -> Callable[..., ContactSolution]:
    """Return a solver of (4.1), (4.2) for the scalar type of `sin` and `cos`."""

    def solve(
        beta: NumberOrExpression,
        omega: tuple[NumberOrExpression, NumberOrExpression, NumberOrExpression],
        slip: tuple[NumberOrExpression, NumberOrExpression],
        contact: ContactState,
        constants: DiskConstants,
        loads: Loads = NO_LOADS,
    ) -> ContactSolution:
        """Return the `ContactSolution` at inclination beta, angular velocity and slip velocity.

        The result equals (4.7) and (5.3) with the errata corrected; see
        tests/rigid/test_equations.py.
        """
        motion = disk_motion(cos(beta), sin(beta), omega, slip, constants)
        nutation = solve_nutation(motion, contact, constants, loads)
        Phi = nutation.Phi
        drift = slip_drift(motion, constants, loads)
        F1 = (
            -constants.mu_dynamic * contact.direction[0] * Phi
            if contact.sliding
            else 0.0
        )
        balance = rotation_balance(motion, contact.sliding, F1, drift, loads)
        domega2, domega3, m2, m3 = solve_rotation(
            balance,
            motion,
            contact.stuck,
            contact.senses[1] * constants.k2 * Phi,
            contact.senses[2] * constants.k3 * Phi,
        )
        radius, depth, e, f = motion.place
        spin = radius * domega2 - depth * domega3
        if contact.sliding:
            w1 = omega[0]
            du1 = F1 - spin + drift  # (2.8)
            du2 = nutation.F2 + loads.G2 + e * nutation.domega1 + f * (w1 * w1)
            du2 = du2 - motion.rate * motion.v[0]
        else:
            F1 = spin - drift
            du1 = 0.0 * Phi
            du2 = 0.0 * Phi
        return ContactSolution(
            domega1=nutation.domega1,
            domega2=domega2,
            domega3=domega3,
            du1=du1,
            du2=du2,
            F1=F1,
            F2=nutation.F2,
            Phi=Phi,
            m1=nutation.m1,
            m2=m2,
            m3=m3,
            inertia=nutation.inertia,
        )

    return solve


def separation_acceleration(
    beta: float,
    w1: float,
    w2: float,
    w3: float,
    constants: DiskConstants,
    loads: Loads = NO_LOADS,
) -> float:
    """Return the upward acceleration of the lowest point without a contact force."""
    sin_a = math.cos(beta)
    cos_a = math.sin(beta)
    e, f = contact_arms(sin_a, cos_a, constants.h, constants.fillet)
    J1 = constants.K / 4 + constants.h**2 / 3
    J2 = constants.K / 2
    free = (J2 * w2 * w3 - J1 * w3 * w3 * sin_a / cos_a + loads.M1) / J1
    return (
        (e - constants.fillet) * w1 * w1 - f * free - (constants.K + 4) / 4 + loads.G3
    )
