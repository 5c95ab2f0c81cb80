"""The springs of a contact under the weight of its disk, as what stands on them needs to know them."""

from typing import NamedTuple

import numpy as np

from ..steady import steady_precession
from .contact import ContactLaw
from .resonance import damping


class Suspension(NamedTuple):
    """Stiffness (3,) [N/m] along a_1, a_2, a_3, rates (3,) [1/s] at which the springs forget, damping (3,) [N s/m]:
    q' = u - forgets q, p = stiffness q + damping q'."""

    stiffness: np.ndarray
    forgets: np.ndarray
    damping: np.ndarray


def suspension(law: ContactLaw, inclination: float) -> Suspension:
    """Return the contact of a disk that rolls steadily, its centre fixed, at an inclination [rad].

    Raises ValueError where there is no such motion.
    """
    disk, beta = law.disk, np.array([inclination])
    springs, lost = law.springs(beta, disk.weight), damping(law, beta, disk.weight)[0]
    try:
        rate = steady_precession(inclination, disk.aspect, disk.gyration) / disk.time_unit
    except ValueError:
        raise ValueError(f"there is no steady motion at {np.degrees(inclination):g} degrees") from None
    speed = abs(disk.radius * rate * (np.cos(inclination) - disk.aspect * np.sin(inclination)))
    k1, k2, kn, length1, length2 = (float(value[0]) for value in springs)
    forgets = np.array([speed / length1, speed / length2, 0.0])
    return Suspension(np.array([k1, k2, kn]), forgets, np.array([0.0, 0.0, lost]))
