"""Constants, records and rows of the arrays of a rattling disk."""

from typing import NamedTuple

import numpy as np

from dynamics.film.wedge import Film
from dynamics.stepping_core.layout import Pair, Vector, first_indices
from dynamics.stepping_core.ledger import losses_of
from dynamics.stepping_core.oscillators import ExactModes

CENTRE, VELOCITY, AXIS, RIM_REFERENCE_VECTOR, MOMENTUM = range(5)
"""Rows of the state (5, 3) of the disk: position [m] and velocity [m/s] of the centre, unit
vectors along the upward axis and towards the point of the rim at angle zero, and angular
momentum about the centre [kg m^2/s]."""


class RecordLayout(NamedTuple):
    """First index of each quantity in the record, an array (RECORD_SIZE,)."""

    impulse: Vector
    """Impulse of the contact force since the start along x, y, z [N s]."""
    contact_loss: int
    """Energy lost to the dashpots since the start [J]. The fields to `body_loss` are in
    the order of CAUSES."""
    creep_loss: int
    """Zero, because creep is a part of the slip."""
    slip_loss: int
    """Energy lost to friction [J]."""
    moment_loss: int
    """Energy lost to the resisting moment [J]."""
    table_loss: int
    """Energy lost by the damping of the table modes [J]."""
    film_loss: int
    """Energy lost to the air film [J]."""
    body_loss: int
    """Energy lost by the damping of the disk modes [J]."""
    spring_energy: int
    """Elastic energy of the springs [J]."""
    compressed_air_energy: int
    """Energy of the compressed air in the film [J]."""
    film_impulse: int
    """Vertical impulse of the film pressure since the start [N s]."""
    friction_impulse: Pair
    """Horizontal impulse of the friction since the start [N s]."""
    open_time: int
    """Time without contact since the start [s]."""
    flight_start: int
    """Time at which the contact was last lost [s]; negative while there is contact."""
    max_flight_height: int
    """Largest height of the lowest rim point above the table since the loss of contact [m]."""


RECORD, RECORD_SIZE = first_indices(RecordLayout)

ENERGY_LOSSES = losses_of(RECORD)
"""Energies lost to each of CAUSES in the record [J]."""

ELASTIC, DASHPOT, FRICTION, RESISTANCE, FILM = range(5)
"""Rows of the forces and torques of springs, dashpots, friction, resisting moment and air film."""

RIM_BLOCK_POINTS = 32
"""Number of adjacent points of the rim that share an upper bound of their heights."""


class RattlingDisk(NamedTuple):
    """Constants of the disk and of its contact in SI units.

    Attributes
    ----------
    mass, ..., bowl
        See `body_constants`.
    half_thickness : float
        Half the thickness [m].
    modulus, shear_modulus : float
        Modulus E* of the contact and shear modulus of its creep [Pa].
    damping_ratio : float
        Damping ratio of a rigid disk on a patch; see `restitution_of_patch`.
    friction : float
        Coefficient of sliding friction.
    contour_moment : float
        Moment that resists the rolling of the contact under the weight [N m].
    spin_friction : tuple of float, length 15
        First 1 if slip and creep in the contact resist pivoting, else 0; then the
        coefficients of `pivoting_arm` in units of the radius.
    arms : tuple of float, length 3
        Moments that resist the rotations about a_1, a_2 and the vertical, divided by
        the normal force [m].
    film : Film
        The air film under the disk in SI units; its constants are 0 without a film.
    """

    mass: float
    diametral_inertia: float
    axial_inertia: float
    inverse_inertia_excess: float
    radius: float
    core_radius: float
    core_depth: float
    fillet: float
    bowl: tuple[float, float, float]
    half_thickness: float
    modulus: float
    shear_modulus: float
    damping_ratio: float
    friction: float
    contour_moment: float
    spin_friction: tuple[float, ...]
    arms: tuple[float, float, float]
    film: Film


class LowerEdge(NamedTuple):
    """Lower edge of the disk, with p points and d modes.

    Attributes
    ----------
    heights : ndarray, shape (p,)
        Heights [m] of table minus edge.
    block_heights : ndarray, shape (ceil(p/RIM_BLOCK_POINTS),)
        Greatest height [m] of each block of points.
    angles : ndarray, shape (2, p)
        Cosine and sine of the angles of the points.
    axial, radial : ndarray, shape (d, p)
        Displacement along the axis and the radius by modes of unit modal mass
        [kg^-1/2], times their `mean_factor`.
    modes : ExactModes
        Frequencies and decay rates of the modes.
    highest : ndarray, shape (1 + d,)
        Greatest height [m], and greatest displacement by each mode [kg^-1/2].
    """

    heights: np.ndarray
    block_heights: np.ndarray
    angles: np.ndarray
    axial: np.ndarray
    radial: np.ndarray
    modes: ExactModes
    highest: np.ndarray


class Contacts(NamedTuple):
    """Forces and positions of all contacts.

    Attributes
    ----------
    load : ndarray, shape (5, 6)
        Force and torque by cause, in the order of the following views.
    force, torque : ndarray, shape (5, 3)
        Force [N] and torque about the centre [N m] by cause.
    pull : ndarray, shape (2, m)
        Force of springs and dashpots on each mode.
    depth, speed, change : ndarray, shape (p,)
        Mean depth [m], approach speed [m/s] and its change in the step of the points that were
        examined.
    rise, radius, below : ndarray, shape (RIM_BLOCK_POINTS,)
        Height of the points of a block above the middle plane divided by their distance from
        the axis, that distance [m], and their distance below the middle plane [m].
    """

    load: np.ndarray
    force: np.ndarray
    torque: np.ndarray
    pull: np.ndarray
    depth: np.ndarray
    speed: np.ndarray
    change: np.ndarray
    rise: np.ndarray
    radius: np.ndarray
    below: np.ndarray
