"""Resistance of the contact ellipse to pivoting: full slip and spin creep."""

import numpy as np
from scipy.special import ellipe

from dynamics.compliant.law.hertz_mindlin import MIN_CONTACT_INCLINATION, ContactLaw
from dynamics.pivoting import PIVOTING_COEFFICIENT_COUNT, SINE_ROOT_INDEX


def slip_arm(law: ContactLaw, inclination: np.ndarray, load: float) -> np.ndarray:
    """Return the moment of full slip divided by mu and the normal force, in m.

    It is the mean distance from the centre weighted by Hertz's pressure, 3/8 a E(e),
    which varies from 3 pi/16 a for a circle to 3/8 a for a long ellipse.
    """
    a, b = law.semi_axes(inclination, load)
    return 3 / 8 * a * ellipe(1 - (b / a) ** 2)


def spin_creep_moment_coefficient(
    law: ContactLaw, inclination: np.ndarray, load: float
) -> np.ndarray:
    """Return the moment of spin creep divided by normal force and creepage, in m^2.

    The normal force is `load` [N]. The creepage is the rotation rate about the normal
    divided by the rolling speed [1/m]. Without lateral creep the moment is G (a b)^2
    C33 times the creepage, where C33 is Kalker's asymptote (1967) for an ellipse
    elongated along the rolling direction.
    """
    a, b = law.semi_axes(inclination, load)
    return (
        law.equivalent_material.shear
        * (a * b) ** 2
        * spin_coefficient(b / a, law.equivalent_material.poisson)
        / load
    )


def spin_coefficient(ratio: np.ndarray, poisson: float) -> np.ndarray:
    """Return the asymptote of Kalker's C33 for small ratios b/a."""
    log = np.log(16 / ratio**2)
    return (
        np.pi / 4 * (1 - poisson * (log - 2) / ((1 - poisson) * log - 2 + 4 * poisson))
    )


def pivoting_polynomials(law: ContactLaw) -> tuple[float, ...]:
    """Return the coefficients of `pivoting_arm` for a contact under the weight.

    The least-squares fit is accurate to 1e-4 from MIN_CONTACT_INCLINATION to an upright
    disk.
    """
    sine = np.geomspace(MIN_CONTACT_INCLINATION, 1.0, 20 * PIVOTING_COEFFICIENT_COUNT)
    beta = np.arcsin(sine)
    weight = law.disk.weight
    radius = law.disk.radius
    scaled = (
        slip_arm(law, beta, weight) / radius * np.cbrt(sine),
        spin_creep_moment_coefficient(law, beta, weight) / radius**2 * np.cbrt(sine),
    )
    powers = sine[:, None] ** (np.arange(PIVOTING_COEFFICIENT_COUNT) / SINE_ROOT_INDEX)
    fits = [
        np.linalg.lstsq(powers / value[:, None], np.ones(len(sine)), rcond=None)[0]
        for value in scaled
    ]
    return tuple(float(value) for value in np.concatenate(fits))
