"""What an accuracy buys, in numbers."""

from math import inf
from typing import NamedTuple


class Level(NamedTuple):
    """One of draft, standard, reference.

    taylor, dop853 -- tolerances of the two integrators.
    beyond         -- the motion may stop where the contact turns at so many times the highest rate that is heard.
    calm           -- by how much [rad] the contact turns at most between two readings of a calm force; 0: every sample.
    range_db       -- modes further below the loudest do not sound.
    patch, free    -- how much of the estimated errors of the modes of a held, a free disk is true.
    """

    taylor: float
    dop853: float
    beyond: float
    calm: float
    range_db: float
    patch: float
    free: float


LEVELS = {
    "draft": Level(1e-16, 1e-12, 1.0, 0.8, 40.0, 0.12, 0.35),
    "standard": Level(1e-16, 1e-15, 10.0, 0.2, 60.0, 0.12, 0.55),
    "reference": Level(1e-16, 1e-15, inf, 0.0, inf, 0.0, 0.0),
}
"""By name; what the reference lacks is not known from within. The shares are measured, tests/test_plan.py."""
