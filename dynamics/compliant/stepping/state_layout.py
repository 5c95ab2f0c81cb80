"""Layout of the state array and the model constants of the compliant motion."""

from itertools import accumulate
from typing import Annotated, NamedTuple, get_type_hints

from dynamics.film.wedge import Film

Pair = Annotated[int, 2]
"""Index of the first of two successive entries."""
Vector = Annotated[int, 3]
"""Index of the first of three successive entries."""


def first_indices(layout):
    """Return a `layout` (NamedTuple class) of first indices, and the number of entries."""
    hints = get_type_hints(layout, include_extras=True).values()
    sizes = [getattr(hint, "__metadata__", (1,))[0] for hint in hints]
    return layout(*accumulate(sizes[:-1], initial=0)), sum(sizes)


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
    film_lift: int
    """Lift of the air film [N]."""
    flight_duration: int
    """Duration of the current loss of contact [s]."""
    flight_lift_impulse: int
    """Impulse of the lift of the film during the current loss of contact [N s]."""
    squeezed_air_energy: int
    """Energy of the compressed air in the film [J]."""
    energy_deficit: int
    """Energy that is missing after the contact jumped to another wave of the table [J]."""
    disk_mode_energy: int
    """Energy of the modes of the disk [J]."""
    gap_changes: Vector
    """Change of the gap in each of the last three steps, without that of the heights
    [m]."""


STATE, STATE_SIZE = first_indices(StateLayout)
STATE_SLICES = StateLayout._make(map(slice, STATE, (*STATE[1:], STATE_SIZE)))
"""Indices of all entries of each quantity in the state."""
ENERGY_LOSSES = slice(STATE.contact_loss, STATE.body_loss + 1)
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
    bowl_stiffness: float
    """Restoring force of a concave table [N/m]."""
    bowl_x: float
    bowl_y: float
    """Position of the origin relative to the middle of a concave table [m]."""
    has_spin_friction: float
    """1 if slip and creep in the contact replace arm_pivoting, else 0."""
    friction_is_fitted: float
    """1 if the friction was fitted to a rough disk and includes its losses, else 0."""
    film: Film
    """Constants of the air film; zeros without a film."""
