"""Contact energy as a function of the gap, and evaluation of the tabulated law."""

import numpy as np

from dynamics.compliant.law.tabulated import LAW_COLUMNS
from dynamics.compliant.stepping.state_layout import STATE, LawCubics
from dynamics.numba_kernels import kernel


@kernel
def law_interval(law: LawCubics, sine: float) -> tuple[int, float]:
    """Return the table interval that contains ln(sine), and the position in it."""
    x = (np.log(sine) - law.grid_start) * law.intervals_per_unit
    i = min(max(int(x), 0), len(law.cubics) - 1)
    return i, x - i


@kernel
def update_law_interval(y: np.ndarray, law: LawCubics) -> None:
    """Update the sine of the inclination in the state, and its table interval."""
    y[STATE.sin_inclination] = np.sqrt(
        y[STATE.axis] * y[STATE.axis] + y[STATE.axis + 1] * y[STATE.axis + 1]
    )
    y[STATE.law_interval], y[STATE.law_fraction] = law_interval(
        law, y[STATE.sin_inclination]
    )


@kernel
def law_column(law: LawCubics, i: int, u: float, column: int) -> float:
    """Return the value of a column of the law at the fraction u of interval i."""
    cubics = law.cubics
    return cubics[i, column, 3] + u * (
        cubics[i, column, 2] + u * (cubics[i, column, 1] + u * cubics[i, column, 0])
    )


@kernel
def current_law(y: np.ndarray, law: LawCubics, column: int) -> float:
    """Return the value of a column of the law at the inclination of the state."""
    return law_column(law, int(y[STATE.law_interval]), y[STATE.law_fraction], column)


@kernel
def hertz_stiffness_slope(law: LawCubics, i: int, u: float, sine: float) -> float:
    """Return the derivative dK/ds of the stiffness by s = sine at position u in interval i."""
    column = LAW_COLUMNS.hertz_stiffness
    cubics = law.cubics
    slope = cubics[i, column, 2] + u * (
        2 * cubics[i, column, 1] + u * 3 * cubics[i, column, 0]
    )
    return slope * law.intervals_per_unit / sine


@kernel
def square_root_of_approach(gap: float) -> float:
    """Return r = sqrt(-G) [m^0.5] of a gap G [m], or 0 for an open gap.

    The contact energy is U = 2/5 K r^5.
    """
    return np.sqrt(-gap) if gap < 0 else 0.0


@kernel
def mean_force(r0: float, r1: float, gap0: float, gap1: float) -> float:
    """Return the mean force divided by the stiffness, -(U1 - U0)/K/(G1 - G0) [m^1.5].

    If both gaps are closed, the common factor r1 - r0 is cancelled analytically.
    """
    if r0 > 0 and r1 > 0:
        q0 = r0 * r0
        q1 = r1 * r1
        both = r0 * r1
        return 0.4 * (q0 * q0 + q1 * q1 + both * (both + q0 + q1)) / (r0 + r1)
    if r0 == r1:
        return 0.0
    return 0.4 * (r0**5 - r1**5) / (gap1 - gap0)
