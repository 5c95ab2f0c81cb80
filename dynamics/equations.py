"""Newton-Euler equations of the disk on the plane, solved for accelerations and loads.

All quantities are dimensionless as in the paper: m = R = 1, and the unit of time is
chi. The same formulas serve floats, numpy arrays, numba floats and heyoka expressions;
the given sine and cosine determine the type.
"""

import math
from typing import NamedTuple

from dynamics.kinematics import (
    centre_velocity,
    contact_arms,
    contact_place,
    precession_rate,
)


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


def disk_constants(disk, friction, pivoting: tuple[float, ...] = ()) -> DiskConstants:
    """Return the constants (4.4), (7.3) of a disk with a sharp edge."""
    return DiskConstants(
        h=disk.aspect,
        K=disk.gyration,
        mu_static=friction.mu_static,
        mu_dynamic=friction.mu_dynamic,
        k1=friction.arm_nutation / disk.radius,
        k2=friction.arm_rolling / disk.radius,
        k3=0.0 if pivoting else friction.arm_pivoting / disk.radius,
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


class Contact(NamedTuple):
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


def equations_of_motion(sin, cos):
    """Return a solver of (4.1), (4.2) for the scalar type of `sin` and `cos`."""

    def solve(
        beta,
        w1,
        w2,
        w3,
        u1,
        u2,
        c,
        s,
        sliding,
        stuck1,
        stuck2,
        stuck3,
        s1,
        s2,
        s3,
        law,
        loads=NO_LOADS,
    ):
        """Return the `Contact` at inclination beta, angular velocity w and slip u.

        If `sliding`, (c, s) is the slip direction (2.7); otherwise the contact rolls.
        s1, s2 and s3 are the signs of omega.a_i; where omega.a_i = 0 is `stuck`, an
        unknown moment replaces them. The result equals (4.7) and (5.3) with the errata
        corrected; see tests/rigid/test_equations.py.
        """
        h = law.h
        K = law.K
        sin_a = cos(beta)
        cos_a = sin(beta)
        place = contact_place(sin_a, cos_a, law.h, law.fillet)
        radius, depth, e, f = place
        J1 = K / 4 + h * h / 3
        J2 = K / 2
        weight = (K + 4) / 4
        rate = precession_rate(w3, cos_a)
        v1, v2 = centre_velocity((u1, u2), (w1, w2, w3), place)

        # About e_1: J1 w1' = b1 + e F2 - f Phi - m1, with Phi = weight - e w1^2 + f w1' (4.6) less
        # the load G3. The frame turns by (w1, rate sin a, w3); `gyro` is the part of the angular
        # momentum about e_2 that does not turn with the frame.
        gyro = J2 * w2 - J1 * (rate * sin_a)
        b1 = loads.M1 + gyro * w3
        b2 = loads.M2
        b3 = loads.M3 - gyro * w1
        Phi0 = weight - (e - law.fillet) * (w1 * w1) - loads.G3
        if sliding:  # F2 = -mu s Phi
            drag = law.mu_dynamic * s
            F20 = 0.0
            F21 = 0.0
        else:  # F2 = F20 + F21 w1' keeps u2 at rest
            drag = 0.0
            F20 = rate * v1 - f * (w1 * w1) - loads.G2
            F21 = -e
        if stuck1:
            domega1 = 0.0 * Phi0
            inertia = J1
        else:
            lever = f + e * drag + s1 * law.k1
            if sliding:
                inertia = J1 + lever * f
            elif law.fillet == 0:
                inertia = J1 + 1 + h * h + s1 * law.k1 * f  # e^2 + f^2 = 1 + h^2
            else:
                inertia = J1 + e * e + f * f + s1 * law.k1 * f
            domega1 = (b1 + e * F20 - lever * Phi0) / inertia
        Phi = Phi0 + f * domega1
        F2 = F20 + F21 * domega1 - drag * Phi
        m1 = b1 + e * F2 - f * Phi if stuck1 else s1 * law.k1 * Phi

        # About e_2, e_3: A (w2', w3') = b - m2 n2 - m3 n3, with n2 = (cos a, -sin a), n3 = (sin a,
        # cos a). On a fillet r the contact moves over the edge as the disk nutates.
        drift = rate * v2 + loads.G1
        if law.fillet != 0:
            drift = drift + law.fillet * w1 * (w2 * sin_a + w3 * cos_a)
        if sliding:
            F1 = -law.mu_dynamic * c * Phi
            A22 = J2
            A23 = 0.0
            A33 = J1
            b2 = b2 - radius * F1
            b3 = b3 + depth * F1
        else:  # F1 = radius w2' - depth w3' - drift keeps u1 at rest
            A22 = J2 + radius * radius
            A23 = -(radius * depth)
            A33 = J1 + depth * depth
            b2 = b2 + radius * drift
            b3 = b3 - depth * drift
        det = A22 * A33 - A23 * A23
        roll2 = -w1 * (w2 * sin_a + w3 * cos_a)
        pivot3 = w1 * (w2 * cos_a - w3 * sin_a)
        # roll2, pivot3: contribution of the rotation of a_2, a_3 to d(omega.a_i)/dtau, in addition
        # to n2.(w2', w3') and n3.(w2', w3')
        if stuck2 and stuck3:
            domega2 = -roll2 * cos_a - pivot3 * sin_a
            domega3 = roll2 * sin_a - pivot3 * cos_a
            r2 = b2 - A22 * domega2 - A23 * domega3
            r3 = b3 - A23 * domega2 - A33 * domega3
            m2 = r2 * cos_a - r3 * sin_a
            m3 = r2 * sin_a + r3 * cos_a
        else:
            m2 = s2 * law.k2 * Phi
            m3 = s3 * law.k3 * Phi
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
            domega2 = (A33 * r2 - A23 * r3) / det
            domega3 = (A22 * r3 - A23 * r2) / det

        spin = radius * domega2 - depth * domega3
        if sliding:
            du1 = F1 - spin + drift  # (2.8)
            du2 = F2 + loads.G2 + e * domega1 + f * (w1 * w1) - rate * v1
        else:
            F1 = spin - drift
            du1 = 0.0 * Phi
            du2 = 0.0 * Phi
        return Contact(
            domega1, domega2, domega3, du1, du2, F1, F2, Phi, m1, m2, m3, inertia
        )

    return solve


def separation_acceleration(beta, w1, w2, w3, law, loads=NO_LOADS) -> float:
    """Return the upward acceleration of the lowest point without a contact force."""
    sin_a = math.cos(beta)
    cos_a = math.sin(beta)
    e, f = contact_arms(sin_a, cos_a, law.h, law.fillet)
    J1 = law.K / 4 + law.h**2 / 3
    J2 = law.K / 2
    free = (J2 * w2 * w3 - J1 * w3 * w3 * sin_a / cos_a + loads.M1) / J1
    return (e - law.fillet) * w1 * w1 - f * free - (law.K + 4) / 4 + loads.G3
