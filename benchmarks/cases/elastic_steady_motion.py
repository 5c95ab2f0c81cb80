"""The steady motion of a disk on an elastic contact, from its energy."""

import numpy as np
from numpy.typing import ArrayLike

from dynamics.compliant.law.hertz_mindlin import ContactLaw
from dynamics.disk import Friction
from dynamics.equations import disk_constants
from dynamics.steady_motion import steady_omega


def stiffness_slope(law: ContactLaw, beta: ArrayLike) -> np.ndarray:
    """Return dK/d(beta) = -K D/(6 F) d(ln A)/d(beta) at inclinations (k,) [rad]."""
    _, D, F = law.ellipse(beta)
    core = (law.disk.radius - law.rolling_fillet) / law.place(beta).radius
    return -law.stiffness(beta) * D / (6 * F) / np.tan(beta) * core


def steady_state(law: ContactLaw, beta: float) -> np.ndarray:
    """Return the state (11,) of steady motion with a fixed centre at inclination `beta`
    [rad].

    The contact energy U = 2/5 K d^2.5 at the approach d under the weight P exerts the
    torque dU/dbeta; added to P times the lever, it changes the square of the rates."""
    disk = law.disk
    place = law.place(beta)
    lever = place.radius * np.cos(beta) - place.depth * np.sin(beta)
    approach = law.approach(beta, disk.weight)
    torque = 0.4 * approach**2.5 * stiffness_slope(law, beta)
    sharp = disk_constants(disk, Friction(mu_static=1.0, mu_dynamic=1.0))
    rounded = sharp._replace(fillet=law.rolling_fillet / disk.radius)
    omega = np.divide(steady_omega(beta, rounded), disk.time_unit)
    omega *= np.sqrt(1 + torque / (disk.weight * lever))
    return np.array([0.0, beta, 0, 0, 0, *omega, 0, 0, 0])
