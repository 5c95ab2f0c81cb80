"""Contact energy as a function of the gap, its difference quotient over a step, and the tabulated
law.
"""

import numpy as np

from dynamics.compliant.stepping.state_layout import (
    AXIS,
    LAW_FRACTION,
    LAW_INTERVAL,
    SIN_INCLINATION,
)
from dynamics.numba_kernels import kernel


@kernel
def law_interval(sine, grid_start, intervals_per_unit, size):
    """Return the interval of the tabulated law that contains ln(sine), and the position within it
    (0 to 1).
    """
    x = (np.log(sine) - grid_start) * intervals_per_unit
    i = min(max(int(x), 0), size - 1)
    return i, x - i


@kernel
def locate_in_law(y, grid_start, intervals_per_unit, cubics):
    """Store the position of the present inclination in the tabulated law in the state."""
    y[SIN_INCLINATION] = np.sqrt(y[AXIS] * y[AXIS] + y[AXIS + 1] * y[AXIS + 1])
    y[LAW_INTERVAL], y[LAW_FRACTION] = law_interval(
        y[SIN_INCLINATION],
        grid_start,
        intervals_per_unit,
        len(cubics),
    )


@kernel
def law_column(cubics, i, u, column):
    """Return a column of the law from its cubics (n, columns, 4)."""
    return cubics[i, column, 3] + u * (
        cubics[i, column, 2] + u * (cubics[i, column, 1] + u * cubics[i, column, 0])
    )


@kernel
def law_slope(cubics, i, u, column):
    """Return the derivative of a column by ln sin(beta), divided by the intervals per unit."""
    return cubics[i, column, 2] + u * (2 * cubics[i, column, 1] + u * 3 * cubics[i, column, 0])


@kernel
def approach_root(gap):
    """Return r = sqrt(-G) [m^0.5] for a gap G [m], or 0 for an open gap; the contact energy is U =
    2/5 K r^5.
    """
    return np.sqrt(-gap) if gap < 0 else 0.0


@kernel
def mean_force(r0, r1, gap0, gap1):
    """Return -(U1 - U0)/K/(G1 - G0) [m^1.5]; if both gaps are closed, with r1^2 - r0^2
    cancelled."""
    if r0 > 0 and r1 > 0:
        q0 = r0 * r0
        q1 = r1 * r1
        both = r0 * r1
        return 0.4 * (q0 * q0 + q1 * q1 + both * (both + q0 + q1)) / (r0 + r1)
    if r0 == r1:
        return 0.0
    return 0.4 * (r0**5 - r1**5) / (gap1 - gap0)
