"""Layout of the state array, and the model of the compliant motion in compiled code."""

from typing import NamedTuple

import numpy as np

from dynamics.compliant.law.height_profile import Profile
from dynamics.film.wedge import Film
from dynamics.stepping_core.layout import Pair, Vector, first_indices
from dynamics.stepping_core.ledger import losses_of


class StateLayout(NamedTuple):
    """First index of each quantity in the state y, an array (STATE_SIZE,)."""

    position: Vector
    """Position of the centre [m]; its height is relative to that of a flat disk."""
    velocity: Vector
    """Velocity of the centre [m/s]."""
    axis: Vector
    """Unit vector n along the axis of the disk."""
    angular_momentum: Vector
    """Angular momentum about the centre [kg m^2/s]."""
    spring_stretch: Pair
    """Stretch of the tangential springs [m] along t (the path) and d (towards the
    contact)."""
    table_path: int
    """Path length of the contact on the table [m]."""
    edge_path: int
    """Path length of the contact on the edge of the disk [m]."""
    normal_force: int
    """Normal force in the last step [N]."""
    previous_forces: Pair
    """Normal forces in the two steps before the last [N]."""
    path_speed: int
    """Speed of the contact along its path [m/s]."""
    gap: int
    """Gap between edge and table [m]; negative while they are in contact."""
    is_sliding: int
    """1 while the contact slides, else 0."""
    roughness_heights: Pair
    """Heights of table and edge under the contact [m]."""
    spring_stiffness: Pair
    """Stiffness of the tangential springs [N/m]."""
    tangential_force: Pair
    """Force on the disk along t and d [N]."""
    contact_loss: int
    """Energy lost in the compression of the contact since the start [J]. The fields to
    `body_loss` are in the order of CAUSES."""
    creep_loss: int
    slip_loss: int
    moment_loss: int
    table_loss: int
    film_loss: int
    body_loss: int
    sin_inclination: int
    """Sine of the inclination."""
    law_interval: int
    """Interval of the tabulated law that contains the inclination."""
    law_fraction: int
    """Position within that interval, 0 to 1."""
    friction_excess: int
    """Largest excess of friction over its limit so far [N]."""
    table_mode_energy: int
    """Energy of the modes of the table [J]."""
    relieved_friction_energy: int
    """Energy by which fitted friction was reduced, because contact and creep had
    dissipated it [J]."""
    table_rise: int
    """Upward velocity of the modes of the table below the contact [m/s]."""
    squeezed_air_energy: int
    """Energy of the compressed air in the film [J]."""
    energy_deficit: int
    """Energy that is missing after the contact jumped to another wave of the table [J]."""
    disk_mode_energy: int
    """Energy of the modes of the disk [J]."""
    gap_change_and_part: Vector
    """Change of the gap in each of the last three steps, without that of the heights
    [m]."""


STATE, STATE_SIZE = first_indices(StateLayout)
STATE_SLICES = StateLayout._make(map(slice, STATE, (*STATE[1:], STATE_SIZE)))
"""Indices of all entries of each quantity in the state."""
ENERGY_LOSSES = losses_of(STATE)
"""Energies lost to each of CAUSES in the state [J]."""


class ModelConstants(NamedTuple):
    """Constants of a compliant model, in SI units."""

    mass: float
    diametral_inertia: float
    axial_inertia: float
    inverse_inertia_excess: float
    """Difference of the inverse moments of inertia about the axis and about a diameter."""
    radius: float
    core_radius: float
    """Distance [m] of the centre of the fillet from the axis."""
    core_depth: float
    """Distance [m] of the centre of the fillet from the middle plane."""
    fillet: float
    """Radius of the edge [m]."""
    bowl: tuple[float, float, float]
    """Restoring acceleration of a concave table divided by the distance from its middle
    [1/s^2], and position of the origin relative to its middle [m]."""
    weight: float
    mu_static: float
    mu_dynamic: float
    arm_nutation: float
    arm_rolling: float
    arm_pivoting: float
    viscous_moment: float
    """Moment divided by angular velocity [N m s]."""
    viscous_force: float
    """Force divided by velocity [N s/m]."""
    has_spin_friction: float
    """1 if slip and creep in the contact replace arm_pivoting, else 0."""
    friction_is_fitted: float
    """1 if the friction was fitted to a rough disk and includes its losses, else 0."""
    film: Film
    """Constants of the air film; zeros without a film."""


class LawCubics(NamedTuple):
    """Tabulated contact law as cubic polynomials of ln(sin(beta)).

    Attributes
    ----------
    grid_start : float
        First node.
    intervals_per_unit : float
        Reciprocal distance between nodes.
    cubics : (intervals, columns, 4) array
        Coefficients for the position within each interval (0 to 1), highest power
        first.
    """

    grid_start: float
    intervals_per_unit: float
    cubics: np.ndarray


class CompiledModel(NamedTuple):
    """Constants and tabulated functions of a model for the compiled time steps."""

    constants: ModelConstants
    powers: np.ndarray
    """Power laws (n, 2) of the precession rate: c [W s^b] and b."""
    law: LawCubics
    """Tabulated contact law."""
    table: Profile
    """Height profiles of table and edge."""
    rim: Profile
