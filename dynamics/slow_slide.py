"""When a slide is so slow that its direction is stiff, and collocation.py has to follow it."""

import math

from .regime import V1, V2

SLOW, LAZY_GAIN, LAZY_LOSS = 0.05, 0.002, 0.05
"""A slide is stiff while its speed over r, and what it gains or loses, are less than these parts of friction.

Explicit steps are many times cheaper, but as a slide comes to rest their number has no bound.
"""


def is_slow(speed, product, friction):
    """Tell whether a slide of `speed` over r is slow and lazy; `product` is that speed times the rate of the slip."""
    return speed < SLOW * friction and -LAZY_LOSS * friction * speed < product < LAZY_GAIN * friction * speed


def is_stiff(y, contact, law) -> bool:
    """Tell whether the slide at state y is slow, and slow to change."""
    product = contact.du1 * y[V1] + contact.du2 * y[V2]
    return is_slow(math.hypot(y[V1], y[V2]), product, law.mu_dynamic * contact.Phi)
