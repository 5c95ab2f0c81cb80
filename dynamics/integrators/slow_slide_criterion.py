"""Criterion for slow slides, whose direction is stiff; see slow_slides.py."""

import math

from dynamics.regime import V1, V2

MAX_SLOW_SPEED = 0.05
MAX_SLOW_ACCELERATION = 0.05
"""Limits below which a slide is stiff, as fractions of friction.

They apply to the slip speed divided by r and to its rate. Faster slides use explicit steps, which
are cheaper. The number of explicit steps would grow without bound as a slide comes to rest.
"""


def is_slow(speed, product, friction):
    """Return True if a slide is slow and its speed changes slowly.

    `speed` is the slip speed divided by r; `product` is this speed times its rate.
    """
    return (
        speed < MAX_SLOW_SPEED * friction
        and abs(product) < MAX_SLOW_ACCELERATION * friction * speed
    )


def is_stiff(y, contact, law) -> bool:
    """Return True if the slide at state y is slow and its speed changes slowly."""
    product = contact.du1 * y[V1] + contact.du2 * y[V2]
    return is_slow(math.hypot(y[V1], y[V2]), product, law.mu_dynamic * contact.Phi)
