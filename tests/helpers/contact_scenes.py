"""The toy on granite, for the tests of its contact."""

import json

import numpy as np
from paths import REFERENCES

from dynamics.compliant.law.hertz_mindlin import ContactLaw, ElasticConstants
from dynamics.compliant.law.linear_response import MotionBlock
from dynamics.compliant.law.linearised import inertias
from dynamics.disk import GRAVITY, Disk

STEEL, GRANITE = ElasticConstants(195e9, 0.28), ElasticConstants(60e9, 0.2)
REFERENCE = json.loads((REFERENCES / "elastic_contact.json").read_text("utf-8"))


def granite(fillet=1.6e-3, thickness=0.0128, **changes):
    """Return the law of the toy, of weight 4.30365 N, on granite."""
    disk = Disk(radius=0.03755, thickness=thickness, mass=4.30365 / GRAVITY)
    given = {"disk": disk, "fillet": fillet, "body": STEEL, "table": GRANITE}
    return ContactLaw(**given | {"loss_factor": 0.02} | changes)


def steady_precession_rate(law, beta):
    """Return the precession rate [rad/s] of the steady motion with a fixed centre at inclination
    beta.

    Euler's equation: the moment of the weight turns the angular momentum."""
    disk = law.disk
    core = disk.radius - law.rolling_fillet
    depth = disk.thickness / 2 - law.rolling_fillet
    distance = core * np.cos(beta) - depth * np.sin(beta)
    diametral, axial = inertias(disk)
    turning = diametral * np.cos(beta) - axial * slope_of_contact(law, beta) * np.sin(
        beta
    )
    return np.sqrt(disk.weight * distance / (turning * np.sin(beta)))


def slope_of_contact(law, beta):
    """Return the distance of the contact from the middle plane over that from the axis."""
    core = law.disk.radius - law.rolling_fillet
    depth = law.disk.thickness / 2 - law.rolling_fillet
    return (depth + law.rolling_fillet * np.cos(beta)) / (
        core + law.rolling_fillet * np.sin(beta)
    )


def steady_speed(law, beta):
    """Return the speed [m/s] of the contact, which circles below the fixed centre."""
    core = law.disk.radius - law.rolling_fillet
    depth = law.disk.thickness / 2 - law.rolling_fillet
    distance = core * np.cos(beta) - depth * np.sin(beta)
    return steady_precession_rate(law, beta) * distance


def prototype(law, beta):
    """Return the springs of the reference: Mindlin's ratio of a circle, one relaxation length 1.1
    a."""
    weight = law.disk.weight
    a = law.semi_axes(beta, weight)[0]
    springs = law.springs(beta, weight)
    return springs._replace(
        k1=0.87655 * springs.kn,
        k2=0.87655 * springs.kn,
        length1=1.1 * a,
        length2=1.1 * a,
    )


def on_springs(shapes, stiffness, residual=0.0):
    """Return frequencies (k, m) [Hz], ascending, of a body with rigid modes of unit mass held by
    springs at one point.

    `shapes` (k, 3, m) [kg^-1/2] are the modes at that point; `stiffness` (k, 3, 3) [N/m].
    What left-out modes yield, `residual` (3, 3) [m/N], lies in series with the springs."""
    held = np.linalg.solve(
        np.eye(3) + stiffness @ np.broadcast_to(residual, stiffness.shape), stiffness
    )
    matrix = shapes.swapaxes(1, 2) @ held @ shapes
    return np.sqrt(np.maximum(np.linalg.eigvalsh(matrix), 0.0)) / (2 * np.pi)


def middle(f, power):
    """Return the mean frequency [Hz] above 800 Hz, where the power exceeds 1/3 of its peak."""
    high = (f > 800) & (power > power[f > 800].max() / 3)
    return np.average(f[high], weights=power[high])


def steady_block(t, beta, load, path, edge=None):
    """Return a rolling MotionBlock of constant inclination and load, with the paths (k,) [m]."""
    one = np.ones(len(t))
    return MotionBlock(
        t,
        beta * one,
        load * one,
        one > 0,
        path,
        path if edge is None else edge,
        np.zeros((len(t), 2)),
        0 * t,
        np.zeros(2),
    )
