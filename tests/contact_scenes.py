"""The toy on granite, for the tests of its contact."""

import json
from pathlib import Path

import numpy as np

from dynamics.coupled.contact import ContactLaw, Elastic
from dynamics.disk import GRAVITY, Disk
from dynamics.theory import steady_precession

STEEL, GRANITE = Elastic(195e9, 0.28), Elastic(60e9, 0.2)
REFERENCE = json.loads((Path(__file__).parent / "references" / "elastic_contact.json").read_text("utf-8"))


def granite(fillet=1.6e-3, thickness=0.0128, **changes):
    """Return the law of the toy, of weight 4.30365 N, on granite."""
    disk = Disk(radius=0.03755, thickness=thickness, mass=4.30365 / GRAVITY)
    return ContactLaw(**{"disk": disk, "fillet": fillet, "body": STEEL, "table": GRANITE} | changes)


def steady_rate(disk, beta):
    """Return the precession rate [rad/s] of the steady motion with a fixed centre at inclination beta."""
    return steady_precession(beta, disk.aspect, disk.gyration) / disk.time_unit


def steady_speed(disk, beta):
    """Return the speed [m/s] of its contact along the table: omega_2 = h omega_3 and omega_3 = Omega sin(beta)."""
    return disk.radius * steady_rate(disk, beta) * (np.cos(beta) - disk.aspect * np.sin(beta))


def prototype(law, beta):
    """Return the springs of the reference: Mindlin's ratio of a circle, one relaxation length 1.1 a."""
    weight = law.disk.weight
    a, springs = law.semi_axes(beta, weight)[0], law.springs(beta, weight)
    return springs._replace(k1=0.87655 * springs.kn, k2=0.87655 * springs.kn, length1=1.1 * a, length2=1.1 * a)
