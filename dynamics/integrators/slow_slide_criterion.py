"""Criterion for a slide so slow that its direction is stiff, for slow_slides.py."""

import math

from dynamics.regime import V1, V2

MAX_SLOW_SPEED = 0.05
MAX_SLOW_ACCELERATION = 0.05
"""A slide is stiff while its speed over r, and the rate of this speed, are below these fractions of
friction.

Faster slides take explicit steps, which are cheaper. Their number grows without bound as a slide
comes to rest."""


def is_slow(speed, product, friction):
    """Return True if a slide of `speed` over r is slow and slow to change; `product` is the speed
    times its rate."""
    return (
        speed < MAX_SLOW_SPEED * friction
        and abs(product) < MAX_SLOW_ACCELERATION * friction * speed
    )


def is_stiff(y, contact, law) -> bool:
    """Return True if the slide at state y is slow and slow to change."""
    product = contact.du1 * y[V1] + contact.du2 * y[V2]
    return is_slow(math.hypot(y[V1], y[V2]), product, law.mu_dynamic * contact.Phi)
