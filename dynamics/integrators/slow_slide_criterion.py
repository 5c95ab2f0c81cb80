"""Criterion for slow slides, in which the equation for the slip direction is stiff."""

import math
from typing import TYPE_CHECKING

from dynamics.regime import V1, V2, StateVector

if TYPE_CHECKING:
    from dynamics.equations import ContactSolution, DiskConstants


def is_slow_slide(speed: float, product: float, friction: float) -> bool:
    """Return True if a slide is slow and its speed changes slowly.

    `speed` is the slip speed divided by r; `product` is this speed times its time
    derivative.
    """
    # Limits of the slip speed divided by r, and of its time derivative, as fractions of the
    # friction. Below them, the number of explicit steps would grow without bound as a slide
    # comes to rest. Above them, explicit steps are cheaper.
    max_slow_acceleration = 0.05
    max_slow_speed = 0.05
    return (
        speed < max_slow_speed * friction
        and abs(product) < max_slow_acceleration * friction * speed
    )


def is_stiff(
    y: StateVector,
    contact: "ContactSolution",
    constants: "DiskConstants",
) -> bool:
    """Return True if the slide at state y is slow and its speed changes slowly."""
    product = contact.du1 * y[V1] + contact.du2 * y[V2]
    return is_slow_slide(
        math.hypot(y[V1], y[V2]), product, constants.mu_dynamic * contact.Phi
    )
