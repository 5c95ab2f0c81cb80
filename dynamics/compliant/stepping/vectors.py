"""Vectors of three numbers in compiled code, as tuples."""

from dynamics.numba_kernels import kernel


@kernel
def vector(y, first):
    """Return three successive entries of an array."""
    return y[first], y[first + 1], y[first + 2]


@kernel
def dot(a, b):
    """Return the scalar product."""
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


@kernel
def cross(a, b):
    """Return the vector product."""
    return (
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    )


@kernel
def plus(a, b):
    """Return the sum."""
    return a[0] + b[0], a[1] + b[1], a[2] + b[2]


@kernel
def times(factor, a):
    """Return the product with a number."""
    return factor * a[0], factor * a[1], factor * a[2]
