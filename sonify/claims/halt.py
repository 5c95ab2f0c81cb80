"""MAP: does one mode of a table break the contact, and by how much does it bring the halt
forward?"""

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

BEFORE = 0.7
"""A run begins in the steady motion whose contact passes the waves at this part of their
resonance."""
RATE = 2e5


class Halt(NamedTuple):
    """Whether contact was lost before the disk lay flat for good, and how much [s] earlier that was
    than on a rigid table."""

    contact_lost: bool
    advanced: float


def steady(disk: Disk, beta: float) -> np.ndarray:
    """Return the columns (11,) of the steady motion with a fixed centre at an inclination [rad]."""
    w3 = steady_precession(beta, disk.aspect, disk.gyration) / disk.time_unit * np.sin(beta)
    return np.array([0.0, beta, 0, 0, 0, 0, disk.aspect * w3, w3, 0, 0, 0])


def halt(
    modal_mass_ratio: float,
    damping: float,
    w_over_n: float,
    order: int,
    scene: Scene | None = None,
    rate: float = RATE,
) -> Halt:
    """Return how a disk ends on a table of one mode: its mass over the disk's, damping ratio, w/n
    [rad/s], order n.

    The disk, its friction and contact are those of a scene, of `published` unless given; the rigid
    halt is that of the quasi-steady decline. Raises ValueError where the mode is none, or where a
    disk that passes its waves lies flat."""
    scene = (scene or load_scene("published")).replace("contact.law=elastic")
    if not (modal_mass_ratio > 0 and w_over_n > 0 and 0 <= damping < 1 and order >= 1):
        raise ValueError("halt: mass and w/n must be positive, damping in [0, 1), order at least 1")
    disk = scene.disk
    beta = inclination_at(scene.disk, BEFORE * w_over_n / (2 * np.pi))
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
    y = released_state(model, steady(disk, beta))
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
