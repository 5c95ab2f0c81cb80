"""When a slide is so slow that its direction is stiff, and collocation.py has to follow it."""

import math

from dynamics.regime import V1, V2

SLOW, LAZY = 0.05, 0.05
"""A slide is stiff while its speed over r, and what it gains or loses, are less than these parts of
friction.

Explicit steps are cheaper, but the slower a slide the more it takes, without bound as it comes to
rest. """


def is_slow(speed, product, friction):
    """Tell whether a slide of `speed` over r is slow and lazy; `product` is that speed times the
    rate of the slip."""
    return speed < SLOW * friction and abs(product) < LAZY * friction * speed


def is_stiff(y, contact, law) -> bool:
    """Tell whether the slide at state y is slow, and slow to change."""
    product = contact.du1 * y[V1] + contact.du2 * y[V2]
    return is_slow(math.hypot(y[V1], y[V2]), product, law.mu_dynamic * contact.Phi)
