"""Whether a rough contact needs the receptance of the table below it.

On a table that only radiates, the force is that on a rigid table. The error is the
change of the A-weighted level of the table when its receptance is included.
"""

from typing import Any, NamedTuple

import numpy as np
from scipy.integrate import trapezoid

from dynamics.a_weighting import a_weighting_db
from dynamics.compliant.law.linear_response import (
    MIN_VIBRATION_FREQUENCY,
    force_per_height,
)
from dynamics.compliant.law.roughness import (
    ellipse_window,
    spectral_density,
)
from dynamics.compliant.law.sections import Roughness
from dynamics.compliant.law.table_receptance import (
    InfinitePlateReceptance,
    ModalReceptance,
    RigidTable,
)
from dynamics.compliant.law.tabulated import TabulatedLaw

MAX_ONE_WAY_LEVEL_ERROR = 1.0
"""Change of the A-weighted level [dB] up to which the table only radiates."""
MAX_WEIGHTED_FREQUENCY = 1e4
"""Upper limit [Hz] of the A-weighted level."""


class CouplingError(NamedTuple):
    """Error of a force that neglects the receptance of the table.

    Attributes
    ----------
    level : float
        A-weighted level of the table in one-way coupling minus that in two-way coupling
        [dB].
    receptance_ratio : float
        Rms of |A_p/(A_c + A_d)|, weighted by the A-weighted one-way force.
    one_way_rms, two_way_rms : float
        Rms of the varying force over the load above MIN_VIBRATION_FREQUENCY.
    """

    level: float
    receptance_ratio: float
    one_way_rms: float
    two_way_rms: float

    @property
    def needs_two_way(self) -> bool:
        """True if the level changes by more than MAX_ONE_WAY_LEVEL_ERROR."""
        return abs(self.level) > MAX_ONE_WAY_LEVEL_ERROR


def coupling_error(
    tabulated: TabulatedLaw,
    roughness: Roughness,
    inclination: float,
    load: float,
    speed: float,
    receptance: Any,
) -> CouplingError:
    """Return the error of one-way coupling in steady motion.

    Parameters
    ----------
    tabulated : TabulatedLaw
        Tabulated law of the contact.
    roughness : Roughness
        Heights of table and edge.
    inclination, load, speed : float
        Inclination [rad], normal force [N], and speed of the contact [m/s].
    receptance : ModalReceptance or InfinitePlateReceptance
        Receptance of the table.

    Returns
    -------
    CouplingError
        The error.
    """
    k, heights = spectral_density(roughness, tabulated.law.disk.radius)
    omega = k * abs(speed)
    frequency = omega / (2 * np.pi)
    beta = np.array([inclination])
    half_length = tabulated.springs(beta, load)[1]
    rate = abs(speed / float(tabulated.law.place(inclination).f))
    own = force_per_height(tabulated.linear_contact(beta, load, speed), omega)
    yielding = receptance(omega, rate)
    driven = heights * ellipse_window(k * half_length) ** 2
    one_way = driven * np.abs(own) ** 2
    two_way = driven * np.mean(np.abs(own / (1 + own * yielding)) ** 2, axis=0)
    ratio = np.mean(np.abs(own * yielding) ** 2, axis=0)
    vibrates = frequency > MIN_VIBRATION_FREQUENCY
    weight = level_weight(frequency)
    radiated = weight * table_acceleration(receptance, omega)
    heard = trapezoid(radiated * one_way, k), trapezoid(radiated * two_way, k)
    if not min(heard) > 0:
        return CouplingError(0.0, 0.0, 0.0, 0.0)
    mean_ratio = trapezoid(weight * one_way * ratio, k)
    mean_ratio /= trapezoid(weight * one_way, k)
    return CouplingError(
        level=float(10 * np.log10(heard[0] / heard[1])),
        receptance_ratio=float(np.sqrt(mean_ratio)),
        one_way_rms=float(np.sqrt(trapezoid(one_way * vibrates, k)) / load),
        two_way_rms=float(np.sqrt(trapezoid(two_way * vibrates, k)) / load),
    )


def level_weight(frequency: np.ndarray) -> np.ndarray:
    """Return the A-weights (f,) of the power at frequencies (f,) [Hz].

    They are 0 outside the range from MIN_VIBRATION_FREQUENCY to MAX_WEIGHTED_FREQUENCY.
    """
    counts = frequency > MIN_VIBRATION_FREQUENCY
    counts &= frequency < MAX_WEIGHTED_FREQUENCY
    weight = np.zeros(len(frequency))
    weight[counts] = 10 ** (a_weighting_db(frequency[counts]) / 10)
    return weight


def table_acceleration(receptance: Any, omega: np.ndarray) -> np.ndarray:
    """Return the mean square of the acceleration of the table per squared force (f,).

    It is the sum over the modal accelerations; an infinite plate radiates like its force.
    """
    if isinstance(receptance, RigidTable):
        return np.zeros(len(omega))
    if isinstance(receptance, InfinitePlateReceptance):
        return np.ones(len(omega))
    return _modal_acceleration(receptance, omega)


def _modal_acceleration(receptance: ModalReceptance, omega: np.ndarray) -> np.ndarray:
    square = (receptance.shapes**2).mean(axis=0)
    stiff = (2 * np.pi * receptance.frequency) ** 2
    total = np.zeros(len(omega))
    for shape, spring, decay in zip(square, stiff, receptance.decay_rate, strict=True):
        total += (
            shape * omega**4 / ((spring - omega**2) ** 2 + (2 * decay * omega) ** 2)
        )
    return total
