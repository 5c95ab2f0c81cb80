"""Limits that findings apply and their texts state."""

from dynamics.compliant.stepping.time_loop import FLAT_INCLINATION

FINAL_ENERGY_SHARE = 0.1
"""Final share of the energy loss for which the cause of the end is determined."""
ALMOST_FLAT_INCLINATION = 2 * FLAT_INCLINATION
"""Smallest inclination [rad] at which losses of contact count; below it they depend on the
time step."""
MODE_BAND_HALF_WIDTH = 0.03
"""Half-width of the band around a mode, relative to its frequency."""
CERTAIN_LOSS_FORCE_RMS = 0.4
"""Rms of N'/weight above which a Gaussian vibration breaks the contact in every motion."""
