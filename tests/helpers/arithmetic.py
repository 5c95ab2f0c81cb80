"""Bars at round-off that follow from the arithmetic, so that they hold on every processor.

Source: Higham, Accuracy and Stability of Numerical Algorithms (2002), sections 3.1 (gamma_n) and
3.3 (running error analysis). A fused multiply-add, another order of a sum or wider vectors make
other roundings, but none beyond these."""

import math
import operator

import numpy as np

UNIT = np.finfo(float).eps / 2
"""The unit round-off u: one operation is right to this, relatively."""
LIBRARY = 4 * UNIT
"""To what sine, cosine and power of any C library are right: within two units in the last place."""


def gamma(operations: int) -> float:
    """Return n u/(1 - n u): n operations on terms whose absolute values add up to 1 are right to
    this, (3.1)."""
    return operations * UNIT / (1 - operations * UNIT)


def walk(operations: int) -> float:
    """Return 8 sqrt(n) u: n independent roundings add up to more once in 10^13 cases (Higham & Mary
    2019, theorem 2.4).

    For what a long run of steps adds up, where `gamma` would be the worst case of all (Brouwer
    1937)."""
    return 8 * math.sqrt(operations) * UNIT


class Rounded:
    """A float with a bound on all that rounding may have done to it, whoever computes the same
    formula (3.3)."""

    def __init__(self, value, error=0.0):
        self.value = float(value)
        self.error = float(error)

    def map(self, function, slope, rounding):
        """Return a function of it, whose derivative is at most `slope` in size, right to
        `rounding`."""
        value = function(self.value)
        return Rounded(value, slope * self.error + rounding * abs(value))

    def __neg__(self):
        return Rounded(-self.value, self.error)

    def __pow__(self, power):
        value = self.value**power
        return self.map(lambda x: x**power, abs(power * value / self.value), LIBRARY)


def _operation(name, partials):
    """Give `Rounded` an operator: the errors of both sides by their partial derivatives, and its
    own rounding."""
    apply = getattr(operator, name)

    def forward(self, other):
        other = other if isinstance(other, Rounded) else Rounded(other)
        a = abs(self.value)
        b = abs(other.value)
        by_self, by_other = partials(a, b)
        value = apply(self.value, other.value)
        return Rounded(
            value, by_self * self.error + by_other * other.error + UNIT * abs(value)
        )

    setattr(Rounded, f"__{name}__", forward)
    setattr(Rounded, f"__r{name}__", lambda self, other: forward(Rounded(other), self))


_operation("add", lambda a, b: (1, 1))
_operation("sub", lambda a, b: (1, 1))
_operation("mul", lambda a, b: (b, a))
_operation("truediv", lambda a, b: (1 / b, a / b**2))


def sin(x):
    """Return the sine of a `Rounded`."""
    return x.map(math.sin, 1, LIBRARY)


def cos(x):
    """Return the cosine of a `Rounded`."""
    return x.map(math.cos, 1, LIBRARY)


def sqrt(x):
    """Return the root of a `Rounded` above 0."""
    return x.map(math.sqrt, 0.5 / math.sqrt(x.value), UNIT)


def rounded(values):
    """Return exact floats, one or an array, as `Rounded`; what is that already stays as it is."""
    exact = np.vectorize(
        lambda x: x if isinstance(x, Rounded) else Rounded(x), otypes=[object]
    )(values)
    return exact if exact.ndim else exact.item()


def errors(values):
    """Return the bounds of an array of `Rounded`."""
    return np.array([x.error for x in np.ravel(values)]).reshape(np.shape(values))
