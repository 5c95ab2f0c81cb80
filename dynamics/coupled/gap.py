"""The energy of the contact as a function of the gap, its mean slope over a step, and the law by table (compiled)."""

import numpy as np

from .compiled import kernel
from .state import AXIS, CELL, PART, SINE


@kernel
def place(sine, start, per_unit, size):
    """Return the interval of ln sin(beta) in the table of the law, and how far into it, as a part of it."""
    x = (np.log(sine) - start) * per_unit
    i = min(max(int(x), 0), size - 1)
    return i, x - i


@kernel
def locate(y, start, per_unit, spline):
    """Note in the state where its axis stands in the table of the law."""
    y[SINE] = np.sqrt(y[AXIS] * y[AXIS] + y[AXIS + 1] * y[AXIS + 1])
    y[CELL], y[PART] = place(y[SINE], start, per_unit, len(spline))


@kernel
def column(spline, i, u, which):
    """Return a column of the law from the cubics `spline` (n, columns, 4)."""
    return spline[i, which, 3] + u * (spline[i, which, 2] + u * (spline[i, which, 1] + u * spline[i, which, 0]))


@kernel
def slope(spline, i, u, which):
    """Return its derivative by ln sin(beta), over the intervals per unit."""
    return spline[i, which, 2] + u * (2 * spline[i, which, 1] + u * 3 * spline[i, which, 0])


@kernel
def root(gap):
    """Return r = sqrt(-G) [m^0.5] at a gap G [m], 0 where it is open: U = 2/5 K r^5."""
    return np.sqrt(-gap) if gap < 0 else 0.0


@kernel
def mean_force(r0, r1, gap0, gap1):
    """Return -(U1 - U0)/K/(G1 - G0) [m^1.5]; both gaps closed, 2/5 (r1^5 - r0^5)/(r1^2 - r0^2) is divided out."""
    if r0 > 0 and r1 > 0:
        q0, q1, both = r0 * r0, r1 * r1, r0 * r1
        return 0.4 * (q0 * q0 + q1 * q1 + both * (both + q0 + q1)) / (r0 + r1)
    if r0 == r1:
        return 0.0
    return 0.4 * (r0**5 - r1**5) / (gap1 - gap0)
