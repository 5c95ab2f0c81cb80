"""Where the state of the disk on its compliant contact and the constants of its law stand in their arrays."""

POSITION, VELOCITY, AXIS, MOMENTUM, SPRING = 0, 3, 6, 9, 12
"""Centre [m] (its height above that of the disk lying flat), velocity, axis n, angular momentum, springs along t, d."""
PATH, EDGE, TABLE = 14, 15, 16
"""Path lengths on the table and on the edge, rise of the table under the contact [m]."""
FORCE, LAST, SPEED, GAP, SLIDES = 17, 18, 20, 21, 22
"""Normal force of the last step and of the two before [N], path speed [m/s], gap [m], 1 where it slides."""
HEIGHTS, STIFFNESS, TANGENTIAL = 23, 25, 27
"""Heights read on table and edge [m]; stiffness of the springs [N/m] and force on the disk [N] along t, d."""
LOSSES, CAUSES = 29, ("contact", "creep", "slip", "moments", "table", "film", "body")
"""Energy [J] lost to each cause since the start."""
SINE, CELL, PART = 36, 37, 38
"""sin(beta), and where it stands in the table of the law: the interval, and the part of it."""
EXCESS = 39
"""By how much [N] the friction ever exceeded what its cone holds."""
SURFACE = 40
"""Energy [J] of the modes of the table."""
SPARED = 41
"""Energy [J] that fitted friction was spared, since contact and creep had taken it."""
LIFT, ALOFT, BORNE = 42, 43, 44
"""Lift of the film [N]; of a flight that goes on, its duration [s] and the impulse of that lift [N s]."""
SQUEEZED = 45
"""Energy [J] of the squeezed air of the film."""
OWED = 46
"""Energy [J] that a change to another wave of the table took, and that nothing had which moved."""
BODY = 47
"""Energy [J] of the modes of the disk."""
RISES = 48
"""By how much [m] the gap opened in each of the last three steps, but for what the heights under it did."""
SIZE = 51
MASS, J1, J2, RADIUS, HALF, WEIGHT, MU_S, MU_D, ARMS, IMPEDANCE, VISCOUS_MOMENT, VISCOUS_FORCE = *range(9), 11, 12, 13
"""Constants: mass, moments of inertia, R, H, m g, friction, arms k1 to k3, impedance of the table, viscous loads."""
TURNING, FALLING, INERTIA, NUMBER, AMBIENT, SLIP, FITTED = range(14, 21)
"""The constants of the film, as film/forces.py names them, in SI units; 1 where friction holds what roughness takes."""
Q, V, NOW, NEXT, FREE = range(5)
"""Columns of the state of the modes: q, q', shapes at both ends of the step, what q would change by without a force."""
