"""Determine the loss of contact and the earlier halt of a disk on a table with one
mode."""

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from dynamics.compliant.law.hertz_mindlin import ContactLaw
from dynamics.compliant.law.tabulated import TabulatedLaw
from dynamics.compliant.model_inputs import contact_law
from dynamics.compliant.state_conversion import inclination, preloaded_compliant_state
from dynamics.compliant.stepping.model import CompliantModel
from dynamics.compliant.stepping.time_loop import FLAT_INCLINATION
from dynamics.disk import Friction
from dynamics.equations import disk_constants
from dynamics.quasi_steady import time_to_flat
from dynamics.scene_constants import scene_constants
from dynamics.solver_settings import inclination_at_rate
from dynamics.steady_motion import steady_omega
from dynamics.surface import ModesSurface, SurfaceMode
from modal.tabletop.solve import table_modes_listed_in_scene
from sonify.scene import Scene, load_scene

START_INCLINATION_RATIO = 0.7
"""Ratio of the precession rate of the initial steady motion to the resonance rate w/n
of the mode."""
DEFAULT_STEP_RATE = 2e5
"""Time steps per second."""


class Halt(NamedTuple):
    """End of a disk on a table with one mode.

    Attributes
    ----------
    contact_lost : bool
        True if contact was lost before the disk came to lie flat.
    advanced : float
        Time [s] by which the halt precedes that on a rigid table.
    """

    contact_lost: bool
    advanced: float


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


def simulate_halt(
    modal_mass_ratio: float,
    damping: float,
    w_over_n: float,
    order: int,
    scene: Scene | None = None,
    rate: float = DEFAULT_STEP_RATE,
) -> Halt:
    """Return the loss of contact and the earlier halt of a disk on a table with one
    mode.

    The time of the halt on a rigid table follows from quasi-steady motion.

    Parameters
    ----------
    modal_mass_ratio : float
        Ratio of the modal mass to the mass of the disk.
    damping : float
        Damping ratio of the mode.
    w_over_n : float
        Angular frequency of the mode divided by its order [rad/s].
    order : int
        Order n of the mode.
    scene : Scene, optional
        Scene with the disk, its friction and its contact; `published` by default.
    rate : float
        Time steps per second.

    Raises
    ------
    ValueError
        If the mode is invalid, or if the initial inclination is outside 1e-4 to 0.3
        rad.
    """
    scene = (scene or load_scene("published")).replace("contact.law=elastic")
    if not (modal_mass_ratio > 0 and w_over_n > 0 and 0 <= damping < 1 and order >= 1):
        raise ValueError(
            "halt: mass and w/n must be positive, damping in [0, 1), order at least 1"
        )
    disk = scene.disk
    beta = inclination_at_rate(
        scene.disk, START_INCLINATION_RATIO * w_over_n / (2 * np.pi)
    )
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
    known = table_modes_listed_in_scene(ModesSurface(modes=(mode,)), disk, 1e6)
    model = CompliantModel(
        tabulated_law=TabulatedLaw(law=contact_law(scene)),
        friction=scene.friction,
        modes=known,
        rate=rate,
    )
    y = preloaded_compliant_state(model, steady_state(model.tabulated_law.law, beta))
    friction = scene_constants(scene)
    rigid = time_to_flat(beta, disk, friction, None) - time_to_flat(
        FLAT_INCLINATION, disk, friction, None
    )
    first = np.inf
    flat = 0.0
    for piece in model.run(y, round(rate / 1e4), 2 * rigid):
        first = min([first, *(loss.t for loss in piece.losses)])
        above = piece.t[inclination(piece.state) > FLAT_INCLINATION]
        flat = float(above[-1]) if len(above) else flat
    return Halt(first < flat, rigid - flat)
