"""Closed-form tests of the simulator: undamped rolling, steady motions, small inclinations.

The formulas are independent of the simulator. All quantities are dimensionless as in the paper; a
is the angle alpha of the paper, pi/2 minus the inclination; h = H/R; K = k^2. Sources: Appell
(1900), Korteweg (1900), O'Reilly (1996), Cushman, Hermans & Kemppainen (1996). The rolling friction
follows from (5.3) and the energy."""

from cmath import sqrt as complex_sqrt
from math import cos, pi, sin, sqrt, tan

from scipy.integrate import quad
from scipy.optimize import brentq


def appell(h, K):
    """Return p, b, c of Appell's linear equations dw2/da = -p w2 + b w3, dw3/da = c w2 + (p + tan
    a) w3."""
    D = 1 + 16 * h * h / (3 * K) - 8 * h * h / (K * (K + 2))
    return 4 * h / ((K + 2) * D), -2 * (1 + 4 * h * h / (3 * K)) / ((K + 2) * D), -2 / D


def rolling_velocities(a, a0, w2, w3, h, K):
    """Return w2, w3 at angle a of an undamped rolling disk that has (w2, w3) at a0, by
    hypergeometric functions.

    With z = -exp(2 i a), w2 = sum c_j z^s_j 2F1(s_j - r_1, s_j - r_2; 1 + s_j - s_k; z), where s
    and r are the roots of 4 s^2 - 2 s + q + i p = 0 and 4 r^2 + 2 r + q - i p = 0, and q = b c +
    p^2. For h = 0 these are Legendre's functions of sin a, n (n + 1) = -4/(K + 2)."""
    from mpmath import exp, hyp2f1, lu_solve, matrix, mpc

    p, b, c = appell(h, K)
    q = b * c + p * p
    s = [(1 + sign * complex_sqrt(1 - 4 * (q + 1j * p))) / 4 for sign in (1, -1)]
    r = [(-1 + sign * complex_sqrt(1 - 4 * (q - 1j * p))) / 4 for sign in (1, -1)]

    def basis(angle):
        """Return w2 and dw2/da of both solutions."""
        z = -exp(2j * mpc(angle))
        rows = []
        for j in (0, 1):
            A = s[j] - r[0]
            B = s[j] - r[1]
            C = 1 + s[j] - s[1 - j]
            power = exp(1j * s[j] * (2 * angle + pi))
            series = hyp2f1(A, B, C, z)
            slope = A * B / C * hyp2f1(A + 1, B + 1, C + 1, z) * z
            rows.append((power * series, 2j * power * (s[j] * series + slope)))
        return rows

    (y1, d1), (y2, d2) = basis(a0)
    weights = lu_solve(matrix([[y1, y2], [d1, d2]]), matrix([w2, -p * w2 + b * w3]))
    (y1, d1), (y2, d2) = basis(a)
    value = weights[0] * y1 + weights[1] * y2
    slope = weights[0] * d1 + weights[1] * d2
    return float(value.real), float(((slope + p * value) / b).real)


def nutation_rate_squared(a, a0, w2, w3, h, K):
    """Return w1^2 at angle a of an undamped disk with w1 = 0, w2 and w3 at a0, from its energy."""

    def rest(a, w2, w3):
        spin = (w2 - h * w3) ** 2 + (K / 4 + h * h / 3) * w3 * w3 + K / 2 * w2 * w2
        return spin / 2 + (K + 4) / 4 * (h * sin(a) + cos(a))

    difference = rest(a0, w2, w3) - rest(a, *rolling_velocities(a, a0, w2, w3, h, K))
    return 2 * difference / (K / 4 + h * h / 3 + 1 + h * h)


def nutation(a0, w2, w3, h, K, reach=0.5):
    """Return the other turning angle and the period of the nutation of an undamped rolling disk.

    The disk has w1 = 0 and (w2, w3) at a0. The search for the other angle proceeds in steps of
    reach/100 towards larger a. Raises ValueError if there is none within `reach`."""

    def speed_squared(a):
        return nutation_rate_squared(a, a0, w2, w3, h, K)

    step = reach / 100
    a = a0 + step
    while speed_squared(a) > 0:
        a += step
        if a > a0 + reach:
            raise ValueError(f"no turning angle within {reach} of {a0}")
    a1 = brentq(speed_squared, a - step, a, xtol=1e-15)
    middle = (a0 + a1) / 2
    half = (a1 - a0) / 2

    def integrand(
        phi,
    ):  # a = middle - half cos(phi) removes the inverse square roots at both ends
        return half * sin(phi) / sqrt(speed_squared(middle - half * cos(phi)))

    return a1, 2 * quad(integrand, 0, pi, epsabs=1e-13, epsrel=1e-13)[0]


def nutation_acceleration(a, w2, w3, h, K):
    """Return dw1/dtau of a rolling disk with w1 = 0 and no moment, from the second of (5.3)."""
    e = h * sin(a) + cos(a)
    f = h * cos(a) - sin(a)
    turn = w3 * (
        2 * w2 - (1 + 4 * h * h / (3 * K)) * w3 * tan(a)
    ) + 4 * e / K * w3 / cos(a) * (w2 - h * w3)
    return (turn - f * (1 + 4 / K)) / (1 + 4 / K + 16 * h * h / (3 * K))


def steady_axial_rate(a, w3, h, K):
    """Return w2 of the steady motion at angle a with in-plane rate w3 (not zero).

    In this motion nutation_acceleration vanishes.
    """
    at0 = nutation_acceleration(a, 0.0, w3, h, K)
    at1 = nutation_acceleration(a, 1.0, w3, h, K)
    return at0 / (at0 - at1)


def steady_nutation_squared(a, w3, h, K, step=1e-5):
    """Return the squared angular frequency of small nutations about the steady motion; negative if
    unstable.

    w2 and w3 depend on a by Appell's equations, so the result is minus the total derivative of
    nutation_acceleration with respect to a."""
    w2 = steady_axial_rate(a, w3, h, K)
    p, b, c = appell(h, K)
    slopes = -p * w2 + b * w3, c * w2 + (p + tan(a)) * w3

    def along(d):
        second = (
            (b * slopes[1] - p * slopes[0]) / 2,
            (c * slopes[0] + (p + tan(a)) * slopes[1] + w3 / cos(a) ** 2) / 2,
        )
        return nutation_acceleration(
            a + d,
            w2 + d * slopes[0] + d * d * second[0],
            w3 + d * slopes[1] + d * d * second[1],
            h,
            K,
        )

    return -(
        8 * (along(step) - along(-step)) - (along(2 * step) - along(-2 * step))
    ) / (12 * step)


def flat_limit(h, K):
    """Return the limits of `steady_precession` as beta -> 0.

    They are Omega^2 beta and the ratio of nutation to precession frequency.
    """
    beta = 1e-6
    rate = steady_precession(beta, h, K)
    square = steady_nutation_squared(
        pi / 2 - beta, rate * sin(beta), h, K, step=1e-3 * beta
    )
    return rate**2 * beta, sqrt(square) / rate


def steady_precession(beta, h, K):
    """Return the steady precession rate with a fixed centre (w2 = h w3) at inclination beta.

    In this motion nutation_acceleration equals at0 + (at1 - at0) w3^2."""
    at0, at1 = (
        nutation_acceleration(pi / 2 - beta, h * w3, w3, h, K) for w3 in (0.0, 1.0)
    )
    return sqrt(at0 / (at0 - at1)) / sin(beta)


def rolling_friction_slope(k2, beta, h, K):
    """Return -d sqrt(beta)/dtau of quasi-steady motion with a fixed centre, under the moment k2
    (over R) alone.

    The moment changes w2 and w3 by (5.3), the decrease of beta changes them by Appell's equations,
    and the motion stays steady. The result is less than `centred_slope`, because the loss of energy
    also sets the centre in motion."""
    rate = steady_precession(beta, h, K)
    a = pi / 2 - beta
    w3 = rate * sin(beta)
    w2 = h * w3
    A22 = K / 2 + 1
    A23 = -h
    A33 = K / 4 + h * h / 3 + h * h
    weight = (K + 4) / 4
    sense = 1 if w2 * cos(a) > w3 * sin(a) else -1
    r2 = -sense * k2 * weight * cos(a)
    r3 = sense * k2 * weight * sin(a)
    det = A22 * A33 - A23 * A23
    d2 = (A33 * r2 - A23 * r3) / det
    d3 = (A22 * r3 - A23 * r2) / det
    step = 1e-6 * abs(w3)
    g2, g3 = (
        (
            nutation_acceleration(a, w2 + x, w3 + y, h, K)
            - nutation_acceleration(a, w2 - x, w3 - y, h, K)
        )
        / (2 * step)
        for x, y in ((step, 0), (0, step))
    )
    return (
        (g2 * d2 + g3 * d3)
        / steady_nutation_squared(a, w3, h, K, step=1e-3 * beta)
        / (2 * sqrt(beta))
    )


def centred_slope(k2, h, K):
    """Return -d sqrt(beta)/dtau for small beta by the energy, as if the centre stayed fixed under
    the moment k2.

    The energy (K + 4)/4 (3/2) beta decreases at the rate k2 Phi Omega beta, with Phi = (K + 4)/4
    and Omega^2 beta as in `flat_limit`."""
    return k2 * sqrt(flat_limit(h, K)[0]) / 3
