"""Whether a rough contact is coupled to the table below it, and where that is valid.

The criterion and the limits of the linear filter are evaluated in steady motion at the
inclinations that the selection of the contact model samples anyway.
"""

from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from dynamics.compliant.law.table_receptance import (
    RIGID_TABLE,
    InfinitePlateReceptance,
    ModalReceptance,
    TableReceptance,
    infinite_plate_mobility,
    modal_receptance,
)
from dynamics.compliant.law.two_way_criterion import (
    MAX_ONE_WAY_LEVEL_ERROR,
    CouplingError,
    coupling_error,
)
from dynamics.compliant.model_selection import steady_motions, steady_precession_rate
from dynamics.surface import InfiniteSurface

if TYPE_CHECKING:
    from dynamics.motion_plan import MotionBasis, MotionPlan
    from dynamics.sections import MotionScene

MAX_BENT_TABLE_RATIO = 0.1
"""Curvature of the table deflected by the weight, divided by that of the tilted rim, up to
which the contact stays at the lowest point of the rim."""


class RoughTable(NamedTuple):
    """Predicted effect of the receptance of a table on a rough contact.

    Attributes
    ----------
    inclination : ndarray, (k,)
        Decreasing inclinations [rad].
    errors : tuple of CouplingError, (k,)
        Errors of one-way coupling at these inclinations.
    linear_until : float
        Inclination [rad] below which the linear filter is not valid, or 0.
    limit : str
        The limit that fails there, or "".
    """

    inclination: np.ndarray
    errors: tuple[CouplingError, ...]
    linear_until: float
    limit: str

    @property
    def level_error(self) -> float:
        """Level error [dB] of largest magnitude of one-way coupling."""
        return max((error.level for error in self.errors), key=abs)

    @property
    def two_way_rms(self) -> float:
        """Largest rms of N' over the load with two-way coupling."""
        return max(error.two_way_rms for error in self.errors)

    @property
    def needs_two_way(self) -> bool:
        """True if one-way coupling is wrong by more than MAX_ONE_WAY_LEVEL_ERROR."""
        return any(error.needs_two_way for error in self.errors)

    @property
    def reason(self) -> str:
        """The reason for the kind of coupling."""
        extent = "more" if self.needs_two_way else "less"
        return (
            f"one-way coupling would change the A-weighted level of the table by "
            f"{self.level_error:+.2g} dB, {extent} than {MAX_ONE_WAY_LEVEL_ERROR:g} dB"
        )


def scene_receptance(scene: "MotionScene", surface_modes: Any) -> TableReceptance:
    """Return the receptance of the table of a scene at its contact.

    `surface_modes` are those of a table that is neither rigid nor infinite. A table
    without modes is rigid.
    """
    surface = scene.surface
    if isinstance(surface, InfiniteSurface):
        return InfinitePlateReceptance(infinite_plate_mobility(surface))
    if surface_modes is None or not len(surface_modes.frequency):
        return RIGID_TABLE
    disk = scene.disk
    radius = disk.radius - scene.contact.rolling_fillet(disk)
    return modal_receptance(surface_modes, radius)


def predict_rough_table(plan: "MotionPlan", receptance: TableReceptance) -> RoughTable:
    """Return the effect of a receptance on the rough contact of a plan."""
    law = plan.tabulated_law
    roughness = plan.scene.roughness
    assert law is not None  # the contact is elastic
    assert roughness is not None
    weight = plan.scene.disk.weight
    inclination, speed = steady_motions(plan)
    errors = tuple(
        coupling_error(law, roughness, beta, weight, velocity, receptance)
        for beta, velocity in zip(inclination, speed, strict=True)
    )
    until, limit = linear_range(plan, receptance, inclination)
    return RoughTable(inclination, errors, until, limit)


def linear_range(
    plan: "MotionBasis", receptance: TableReceptance, inclination: np.ndarray
) -> tuple[float, str]:
    """Return the greatest inclination at which the linear filter is not valid, and why.

    The contact must pass the modes of order n at less than half their frequency, and
    the table deflected by the weight must be much flatter than the tilted rim.

    Parameters
    ----------
    plan : MotionBasis
        Scene and constants.
    receptance : TableReceptance
        Receptance of the table.
    inclination : ndarray, (k,)
        Decreasing inclinations [rad].

    Returns
    -------
    inclination : float
        The inclination [rad]; 0 if the filter is valid at all of them.
    limit : str
        The limit that fails, or "".
    """
    if not isinstance(receptance, ModalReceptance):
        return 0.0, ""
    lowest = receptance.lowest_frequency_by_order
    for beta in inclination:
        rate = steady_precession_rate(plan.scene, float(beta))
        for order, frequency in lowest.items():
            if order * rate > np.pi * frequency:
                return float(beta), (
                    f"the contact passes the waves of order {order:g} at more than half "
                    f"their frequency of {frequency:.0f} Hz"
                )
        bent = bent_table_ratio(plan, receptance, float(beta), rate)
        if bent > MAX_BENT_TABLE_RATIO:
            return float(beta), (
                f"the weight bends the table to {bent:.2g} times the curvature of the rim"
            )
    return 0.0, ""


def bent_table_ratio(
    plan: "MotionBasis", receptance: ModalReceptance, inclination: float, rate: float
) -> float:
    """Return the largest n^2 N_0 |A_p,n|/(R beta) of the orders n of the table.

    A_p,n is the receptance of order n for a constant force that runs round the circle at
    `rate` [rad/s].
    """
    disk = plan.scene.disk
    still = np.zeros(1)
    ratios = [
        order**2 * abs(receptance.of_order(order, still, rate)[0])
        for order in receptance.orders_and_squares[0]
    ]
    # orders n and -n are the two directions of the same waves
    return 2 * disk.weight * max(ratios, default=0.0) / (disk.radius * inclination)
