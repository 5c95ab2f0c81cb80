"""MAP: loss of contact and earlier halt of a disk on a table with one mode."""

from typing import NamedTuple

import numpy as np

from dynamics.compliant.law.tabulated import LawTable
from dynamics.compliant.model_inputs import contact_law
from dynamics.compliant.state_conversion import inclination, released_state
from dynamics.compliant.stepping.model import CompliantModel
from dynamics.compliant.stepping.time_loop import FLAT_INCLINATION
from dynamics.disk import Disk
from dynamics.quasi_steady import time_left
from dynamics.solver_settings import inclination_at
from dynamics.steady_motion import steady_precession
from dynamics.surface import ModesSurface, SurfaceMode
from modal.tabletop.solve import table_modes_from_numbers
from sonify.scene import Scene, load_scene

START_INCLINATION_RATIO = 0.7
"""Precession rate of the initial steady motion, over the rate w/n of resonance with the mode."""
DEFAULT_STEP_RATE = 2e5
"""Time steps per second."""


class Halt(NamedTuple):
    """End of a disk on a table with one mode.

    Attributes
    ----------
    contact_lost : bool
        True if contact was lost before the disk came to lie flat.
    advanced : float
        Time [s] by which the disk lies flat earlier than on a rigid table.
    """

    contact_lost: bool
    advanced: float


def steady_state(disk: Disk, beta: float) -> np.ndarray:
    """Return the state (11,) of steady motion with a fixed centre at inclination `beta` [rad]."""
    w3 = steady_precession(beta, disk.aspect, disk.gyration) / disk.time_unit * np.sin(beta)
    return np.array([0.0, beta, 0, 0, 0, 0, disk.aspect * w3, w3, 0, 0, 0])


def simulate_halt(
    modal_mass_ratio: float,
    damping: float,
    w_over_n: float,
    order: int,
    scene: Scene | None = None,
    rate: float = DEFAULT_STEP_RATE,
) -> Halt:
    """Return the loss of contact and the earlier halt of a disk on a table with one mode.

    The time of the halt on a rigid table follows from the quasi-steady decline.

    Parameters
    ----------
    modal_mass_ratio : float
        Modal mass over the mass of the disk.
    damping : float
        Damping ratio of the mode.
    w_over_n : float
        Angular frequency of the mode over its order [rad/s].
    order : int
        Order n of the mode.
    scene : Scene, optional
        Scene with the disk, its friction and its contact; `published` by default.
    rate : float
        Time steps per second.

    Raises
    ------
    ValueError
        If the mode is invalid, or if the initial inclination is outside 1e-4 to 0.3 rad.
    """
    scene = (scene or load_scene("published")).replace("contact.law=elastic")
    if not (modal_mass_ratio > 0 and w_over_n > 0 and 0 <= damping < 1 and order >= 1):
        raise ValueError("halt: mass and w/n must be positive, damping in [0, 1), order at least 1")
    disk = scene.disk
    beta = inclination_at(scene.disk, START_INCLINATION_RATIO * w_over_n / (2 * np.pi))
    if not 10 * FLAT_INCLINATION < beta < 0.3:
        raise ValueError(
            f"w_over_n = {w_over_n:g}: the disk passes these waves at {beta:.2g} rad, outside "
            f"1e-4 to 0.3"
        )
    mode = SurfaceMode(
        order=order,
        frequency=order * w_over_n / (2 * np.pi),
        damping_ratio=damping,
        modal_mass=modal_mass_ratio * disk.mass,
    )
    known = table_modes_from_numbers(ModesSurface(modes=(mode,)), disk, 1e6)
    model = CompliantModel(
        table=LawTable(law=contact_law(scene)), friction=scene.friction, modes=known, rate=rate
    )
    y = released_state(model, steady_state(disk, beta))
    rigid = time_left(beta, disk, scene.friction, None) - time_left(
        FLAT_INCLINATION, disk, scene.friction, None
    )
    first = np.inf
    flat = 0.0
    for piece in model.run(y, round(rate / 1e4), 2 * rigid):
        first = min([first, *(loss.t for loss in piece.losses)])
        above = piece.t[inclination(piece.state) > FLAT_INCLINATION]
        flat = float(above[-1]) if len(above) else flat
    return Halt(first < flat, rigid - flat)
