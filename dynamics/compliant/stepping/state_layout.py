"""Layout of the state array and of the array of model constants of the compliant motion."""

# First index of each entry of the state y, an array (STATE_SIZE,).
POSITION = 0
"""Centre of the disk (3) [m]; its height is measured from that of the disk lying flat."""
VELOCITY = 3
"""Velocity of the centre (3) [m/s]."""
AXIS = 6
"""Unit vector n along the axis of the disk (3)."""
ANGULAR_MOMENTUM = 9
"""Angular momentum about the centre (3) [kg m^2/s]."""
SPRING_STRETCH = 12
"""Stretch of the tangential springs (2) [m], along t (the path) and d (towards the contact)."""
TABLE_PATH = 14
"""Path length of the contact on the table [m]."""
EDGE_PATH = 15
"""Path length of the contact on the edge of the disk [m]."""
TABLE_RISE = 16
"""Rise of the table under the contact [m]."""
NORMAL_FORCE = 17
"""Normal force in the last step [N]."""
PREVIOUS_FORCES = 18
"""Normal forces in the two steps before the last (2) [N]."""
PATH_SPEED = 20
"""Speed of the contact along its path [m/s]."""
GAP = 21
"""Gap between edge and table [m]; negative while they are in contact."""
IS_SLIDING = 22
"""1 while the contact slides, else 0."""
ROUGHNESS_HEIGHTS = 23
"""Heights of table and edge under the contact (2) [m]."""
SPRING_STIFFNESS = 25
"""Stiffness of the tangential springs (2) [N/m]."""
TANGENTIAL_FORCE = 27
"""Force on the disk along t and d (2) [N]."""
ENERGY_LOSSES = 29
"""Energy lost to each of CAUSES since the start (7) [J]."""
SIN_INCLINATION = 36
"""Sine of the inclination."""
LAW_INTERVAL = 37
"""Interval of the tabulated law that contains the inclination."""
LAW_FRACTION = 38
"""Position within that interval, 0 to 1."""
FRICTION_EXCESS = 39
"""Largest excess of the friction over its cone so far [N]."""
TABLE_MODE_ENERGY = 40
"""Energy of the modes of the table [J]."""
RELIEVED_FRICTION_ENERGY = 41
"""Energy not taken by fitted friction, because contact and creep had already taken it [J]."""
FILM_LIFT = 42
"""Lift of the air film [N]."""
FLIGHT_DURATION = 43
"""Duration of the current loss of contact [s]."""
FLIGHT_LIFT_IMPULSE = 44
"""Impulse of the film's lift during the current loss of contact [N s]."""
SQUEEZED_AIR_ENERGY = 45
"""Energy of the compressed air in the film [J]."""
ENERGY_DEFICIT = 46
"""Energy required by a jump of the contact to another wave of the table and held by no moving part
[J].
"""
DISK_MODE_ENERGY = 47
"""Energy of the modes of the disk [J]."""
GAP_CHANGES = 48
"""Opening of the gap in each of the last three steps, without the change of the heights (3) [m]."""
STATE_SIZE = 51
"""Length of the state."""

# Index of each entry of the model constants, in SI units.
MASS = 0
J1 = 1
"""Moment of inertia about a diameter [kg m^2]."""
J2 = 2
"""Moment of inertia about the axis [kg m^2]."""
RADIUS = 3
HALF_THICKNESS = 4
WEIGHT = 5
MU_S = 6
"""Static coefficient of friction."""
MU_D = 7
"""Dynamic coefficient of friction."""
RESISTING_ARMS = 8
"""Arms k1, k2, k3 of the resisting moments (3) [m]."""
TABLE_IMPEDANCE = 11
"""Impedance of the table [N s/m]."""
VISCOUS_MOMENT = 12
"""Moment per angular velocity [N m s]."""
VISCOUS_FORCE = 13
"""Force per velocity [N s/m]."""
FILM_TURNING = 14
"""First constant of `film_parts`; the five others follow in its order."""
FILM_FALLING = 15
FILM_INERTIA = 16
FILM_NUMBER = 17
FILM_AMBIENT = 18
FILM_SLIP = 19
FRICTION_IS_FITTED = 20
"""1 if the friction was fitted to a rough disk and includes its losses, else 0."""

# Columns of the state of the modes.
MODE_AMPLITUDE = 0
MODE_VELOCITY = 1
SHAPE_BEFORE = 2
"""Mode shape at the contact at the begin of the step."""
SHAPE_AFTER = 3
"""Mode shape at the contact at the end of the step."""
FREE_CHANGE = 4
"""Change of the amplitude in the step without a contact force."""
