"""Reasons for the end of time steps, and the outcome of the motion for each."""

from enum import IntEnum, auto

from dynamics.motion import Outcome


class EndReason(IntEnum):
    """Reason why the compiled time steps returned."""

    CONTINUES = auto()
    """All rows are filled; the motion continues."""
    LIES_FLAT = auto()
    """The inclination reached its final value."""
    IS_AT_REST = auto()
    """The disk lies flat, without heave and tilt."""
    STANDS_UPRIGHT = auto()
    LIFTS_OFF = auto()
    """The disk is higher above the table than it is tilted."""
    UNSOLVED = auto()
    """The equation for the normal force has no solution."""
    IS_AIRBORNE = auto()
    """The disk is higher above its film of air than it is tilted."""


OUTCOME_OF_END = {
    EndReason.CONTINUES: Outcome.ROLLING_ON,
    EndReason.LIES_FLAT: Outcome.SETTLED,
    EndReason.IS_AT_REST: Outcome.AT_REST,
    EndReason.STANDS_UPRIGHT: Outcome.UPRIGHT,
    EndReason.LIFTS_OFF: Outcome.LIFTED_OFF,
    EndReason.UNSOLVED: Outcome.STALLED,
    EndReason.IS_AIRBORNE: Outcome.AIRBORNE,
}
"""Outcome of a motion for each reason for its end."""
