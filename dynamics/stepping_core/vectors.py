"""Vectors of three numbers in compiled code, as tuples."""

import numpy as np

from dynamics.numba_kernels import kernel

Triple = tuple[float, float, float]
"""Three numbers."""
AnyVector = Triple | np.ndarray
"""Three numbers in a tuple or an array."""


@kernel
def vector(y: np.ndarray, first: int) -> Triple:
    """Return three successive entries of an array."""
    return y[first], y[first + 1], y[first + 2]


@kernel
def dot(a: AnyVector, b: AnyVector) -> float:
    """Return the scalar product."""
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


@kernel
def cross(a: AnyVector, b: AnyVector) -> Triple:
    """Return the vector product."""
    return (
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    )


@kernel
def plus(a: AnyVector, b: AnyVector) -> Triple:
    """Return the sum."""
    return a[0] + b[0], a[1] + b[1], a[2] + b[2]


@kernel
def times(factor: float, a: AnyVector) -> Triple:
    """Return the product with a number."""
    return factor * a[0], factor * a[1], factor * a[2]
