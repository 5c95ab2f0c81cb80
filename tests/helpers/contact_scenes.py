"""The toy on granite, for the tests of its contact."""

import json

import numpy as np
from paths import REFERENCES

from dynamics.compliant.law.hertz_mindlin import ContactLaw, ElasticConstants
from dynamics.disk import GRAVITY, Disk
from dynamics.theory.exact import steady_precession

STEEL, GRANITE = ElasticConstants(195e9, 0.28), ElasticConstants(60e9, 0.2)
REFERENCE = json.loads((REFERENCES / "elastic_contact.json").read_text("utf-8"))


def granite(fillet=1.6e-3, thickness=0.0128, **changes):
    """Return the law of the toy, of weight 4.30365 N, on granite."""
    disk = Disk(radius=0.03755, thickness=thickness, mass=4.30365 / GRAVITY)
    return ContactLaw(**{"disk": disk, "fillet": fillet, "body": STEEL, "table": GRANITE} | changes)


def steady_rate(disk, beta):
    """Return the precession rate [rad/s] of the steady motion with a fixed centre at inclination
    beta."""
    return steady_precession(beta, disk.aspect, disk.gyration) / disk.time_unit


def steady_speed(disk, beta):
    """Return the speed [m/s] of its contact along the table: omega_2 = h omega_3 and omega_3 =
    Omega sin(beta)."""
    return disk.radius * steady_rate(disk, beta) * (np.cos(beta) - disk.aspect * np.sin(beta))


def prototype(law, beta):
    """Return the springs of the reference: Mindlin's ratio of a circle, one relaxation length 1.1
    a."""
    weight = law.disk.weight
    a = law.semi_axes(beta, weight)[0]
    springs = law.springs(beta, weight)
    return springs._replace(
        k1=0.87655 * springs.kn, k2=0.87655 * springs.kn, length1=1.1 * a, length2=1.1 * a
    )


def on_springs(shapes, stiffness, squared=0.0, residual=0.0):
    """Return frequencies (k, m) [Hz], ascending, of a body with modes of unit mass held by springs
    at one point.

    `shapes` (k, 3, m) [kg^-1/2] are the modes at that point and `squared` (m,) [1/s^2] their own
    w^2, 0 if rigid; `stiffness` (k, 3, 3) [N/m]. What left-out modes yield, `residual` (3, 3)
    [m/N], lies in series with the springs."""
    held = np.linalg.solve(
        np.eye(3) + stiffness @ np.broadcast_to(residual, stiffness.shape), stiffness
    )
    matrix = shapes.swapaxes(1, 2) @ held @ shapes + np.broadcast_to(
        squared, shapes.shape[-1:]
    ) * np.eye(shapes.shape[-1])
    return np.sqrt(np.maximum(np.linalg.eigvalsh(matrix), 0.0)) / (2 * np.pi)
