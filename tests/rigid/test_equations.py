"""Claim: the balance laws are the Newton-Euler equations, and agree with (4.7) and (5.3) of the
paper after correction of the errata.

Source: Kessler & O'Reilly (2002), (2.1)-(2.8), (3.1)-(3.3), (4.1)-(4.9), (5.1)-(5.3), (6.1).
Oracle: a derivation in Cartesian vectors with a computer-algebra system; the printed equations.
"""

import math
from functools import cache

import numpy as np
import pytest
import sympy as sp

from dynamics.equations import ContactState, DiskConstants, Loads
from dynamics.regime import FLOAT_FORMULAS

MU, ARMS = 0.3, (0.01, 0.02, 0.03)


def random_states(n=6):
    """Yield parameters and states: h, K, beta, omega, slip, senses, loads."""
    rng = np.random.default_rng(7)
    for i in range(n):
        yield (
            rng.uniform(0.01, 2.0),
            float(1 + i % 2),
            rng.uniform(0.05, 1.5),
            rng.normal(size=3),
            rng.normal(size=2),
            rng.choice([-1.0, 1.0], size=3),
            rng.normal(size=5) * 0.1,
        )


def contact(shape, beta, w, u, senses, sliding, loads=(0.0,) * 5, fillet=0.0):
    law = DiskConstants(*shape, 1.0, MU, *ARMS, fillet=fillet)
    direction = u / np.hypot(*u)
    slip = u if sliding else np.zeros(2)
    state = ContactState(sliding, tuple(direction), (False,) * 3, tuple(senses))
    return FLOAT_FORMULAS.solve(beta, tuple(w), tuple(slip), state, law, Loads(*loads))


@cache
def newton_euler():
    """Derive the residuals of (4.1), (4.2) in Cartesian vectors with symbolic differentiation."""
    t = sp.symbols("t")
    h, K, g, fillet = sp.symbols("h K g fillet")
    names = "theta alpha psi x y"
    theta, alpha, psi, x, y = (sp.Function(n)(t) for n in names.split())
    F1, F2, N, m1, m2, m3, G1, G2, M1, M2, M3 = sp.symbols(
        "F1 F2 N m1 m2 m3 G1 G2 M1 M2 M3"
    )
    a = sp.Matrix(
        [
            [sp.cos(theta), sp.sin(theta), 0],
            [-sp.sin(theta), sp.cos(theta), 0],
            [0, 0, 1],
        ]
    )
    e = (
        sp.Matrix(
            [
                [1, 0, 0],
                [0, sp.cos(alpha), sp.sin(alpha)],
                [0, -sp.sin(alpha), sp.cos(alpha)],
            ]
        )
        * a
    )
    a1, a2, a3 = (a[i, :].T for i in range(3))
    e1, e2, e3 = (e[i, :].T for i in range(3))
    omega = theta.diff(t) * a3 + alpha.diff(t) * e1 + psi.diff(t) * e2
    arm = -(h - fillet) * e2 - (1 - fillet) * e3 - fillet * a3
    centre = sp.Matrix([x, y, -arm[2]])  # the contact point is on the plane
    velocity = centre.diff(t)
    slip = velocity + omega.cross(arm)
    J1 = K / 4 + h**2 / 3
    J2 = K / 2
    spin = J1 * (omega.dot(e1) * e1 + omega.dot(e3) * e3) + J2 * omega.dot(e2) * e2
    force = F1 * a1 + F2 * a2 + N * a3
    momentum = velocity.diff(t) - force - G1 * a1 - G2 * a2 + g * a3
    moment = (
        arm.cross(force) - m1 * a1 - m2 * a2 - m3 * a3 + M1 * e1 + M2 * e2 + M3 * e3
    )
    angular = spin.diff(t) - moment
    kinematics = {
        "omega": [omega.dot(b) for b in (e1, e2, e3)],
        "slip": [slip.dot(a1), slip.dot(a2)],
        "momentum": list(momentum),
        "angular": list(angular),
        "domega": [omega.dot(b).diff(t) for b in (e1, e2, e3)],
        "dslip": [slip.dot(a1).diff(t), slip.dot(a2).diff(t)],
    }
    loads = (F1, F2, N, m1, m2, m3, G1, G2, M1, M2, M3)
    return t, (theta, alpha, psi, x, y), (h, K, g, fillet), loads, kinematics


@cache
def compiled():
    """Return the derivation as named functions.

    Their arguments are accelerations, rates, coordinates, constants and loads.
    """
    t, q, constants, loads, laws = newton_euler()
    accelerations = sp.symbols("p1:6")
    rates = sp.symbols("r1:6")
    places = sp.symbols("q1:6")
    second = {f.diff(t, 2): p for f, p in zip(q, accelerations, strict=True)}
    first = {f.diff(t): r for f, r in zip(q, rates, strict=True)}
    at = dict(zip(q, places, strict=True))
    plain = {
        name: [x.subs(second).subs(first).subs(at) for x in rows]
        for name, rows in laws.items()
    }
    groups = (accelerations, rates, places, constants, loads)
    return {name: sp.lambdify(groups, rows, cse=True) for name, rows in plain.items()}


def root(affine, goal):
    """Return the argument at which an affine function of five variables equals `goal`."""
    start = np.array(affine(np.zeros(5)))
    matrix = np.column_stack([affine(unit) - start for unit in np.eye(5)])
    return np.linalg.solve(matrix, goal - start)


def evaluate(h, K, beta, w, u, c, loads, fillet):
    """Insert a state and our solution into the derivation; return the residuals of all laws."""
    laws = compiled()
    coordinates = (0.7, math.pi / 2 - beta, 0.0, 0.0, 0.0)
    numbers = (
        coordinates,
        (h, K, (K + 4) / 4, fillet),
        (c.F1, c.F2, c.Phi, c.m1, c.m2, c.m3, *loads),
    )

    def of(names, accelerations, rates):
        return np.concatenate(
            [laws[name](accelerations, rates, *numbers) for name in names]
        )

    still = np.zeros(5)
    rates = root(lambda r: of(("omega", "slip"), still, r), [*w, *u])
    goal = [c.domega1, c.domega2, c.domega3, c.du1, c.du2]
    accelerations = root(lambda p: of(("domega", "dslip"), p, rates), goal)
    return of(("momentum", "angular"), accelerations, rates)


@pytest.mark.parametrize("roundness", [0.0, 0.3, 1.0])
@pytest.mark.parametrize("sliding", [True, False])
@pytest.mark.parametrize("case", range(6))
def test_the_solution_satisfies_newton_and_euler(case, sliding, roundness):
    h, K, beta, w, u, senses, loads = list(random_states())[case]
    fillet = roundness * min(h, 1.0)
    c = contact((h, K), beta, w, u, senses, sliding, loads, fillet)
    residuals = evaluate(h, K, beta, w, u if sliding else np.zeros(2), c, loads, fillet)
    np.testing.assert_allclose(residuals, 0, atol=1e-10 * max(1.0, abs(c.Phi)))


def barred(alpha, senses):
    """Return k2-bar and k3-bar of (4.8), divided by R."""
    _, k2, k3 = ARMS
    sin_a = math.sin(alpha)
    cos_a = math.cos(alpha)
    return k2 * cos_a * senses[1] + k3 * sin_a * senses[2], k3 * cos_a * senses[
        2
    ] - k2 * sin_a * senses[1]


def terms_of(case, slides):
    """Return the contact of a random state, the state, and the terms that both equations share."""
    h, K, beta, (w1, w2, w3), u, senses, _ = list(random_states())[case]
    c = contact((h, K), beta, np.array([w1, w2, w3]), u, senses, slides)
    alpha = math.pi / 2 - beta
    e = h * math.sin(alpha) + math.cos(alpha)
    f = h * math.cos(alpha) - math.sin(alpha)
    gyro = 2 * w2 - (1 + 4 * h * h / (3 * K)) * w3 * math.tan(alpha)
    sec = 1 / math.cos(alpha)
    return c, h, K, (w1, w2, w3), u, senses, sec, e, f, *barred(alpha, senses), gyro


@pytest.mark.parametrize("case", range(6))
def test_sliding_is_the_papers_4_7(case):
    c, h, K, (w1, w2, w3), u, senses, sec, e, f, k2, k3, gyro = terms_of(case, True)
    nu = math.atan2(u[1], u[0])
    pairs = [
        (
            c.du1 + c.domega2 - h * c.domega3,
            w3 * sec * (u[1] - w1 * e) - MU * c.Phi * math.cos(nu),
        ),
        (
            c.du2 - e * c.domega1,
            -w3 * sec * (u[0] + w2 - h * w3) + f * w1**2 - MU * c.Phi * math.sin(nu),
        ),
        (
            (1 + 4 * h * h / (3 * K) + 4 * f * f / K) * c.domega1,
            w3 * gyro
            - f * (1 + 4 / K)
            + 4 * e * f / K * w1**2
            - 4 * MU * e / K * c.Phi * math.sin(nu)
            - 4 * ARMS[0] / K * c.Phi * senses[0],
        ),
        (c.domega2, 2 * MU / K * c.Phi * math.cos(nu) - 2 * k2 / K * c.Phi),
        (
            (1 + 4 * h * h / (3 * K)) * c.domega3,
            -w1 * gyro - 4 * MU * h / K * c.Phi * math.cos(nu) - 4 * k3 / K * c.Phi,
        ),
        (c.Phi, (K + 4) / 4 + f * c.domega1 - e * w1**2),
    ]
    np.testing.assert_allclose(*zip(*pairs, strict=True), rtol=1e-11, atol=1e-11)


@pytest.mark.parametrize("case", range(6))
def test_rolling_is_the_papers_5_3_with_the_sign_of_omega_1(case):
    c, h, K, (w1, w2, w3), _, senses, sec, e, f, k2, k3, gyro = terms_of(case, False)
    pairs = [
        (
            (1 + 4 / K + 16 * h * h / (3 * K)) * c.domega1,
            w3 * gyro
            + 4 * e / K * w3 * sec * (w2 - h * w3)
            - f * (1 + 4 / K)
            - 4 * ARMS[0] / K * c.Phi * senses[0],
        ),
        (
            c.domega2 - 2 * h / (K + 2) * c.domega3,
            -2 * e / (K + 2) * w1 * w3 * sec - 2 * k2 / (K + 2) * c.Phi,
        ),
        (
            (1 + 16 * h * h / (3 * K)) * c.domega3 - 4 * h / K * c.domega2,
            -w1 * gyro + 4 * h * e / K * w1 * w3 * sec - 4 * k3 / K * c.Phi,
        ),
        (c.F1, c.domega2 - h * c.domega3 + e * w1 * w3 * sec),
        (c.F2, -e * c.domega1 - f * w1**2 + (w2 - h * w3) * w3 * sec),
    ]
    np.testing.assert_allclose(*zip(*pairs, strict=True), rtol=1e-11, atol=1e-11)
