"""TABLE -> SENTENCES: what the shipped sweeps say, computed from their tables."""

from collections import Counter
from collections.abc import Callable

import numpy as np
import pyarrow as pa


def friction(table: pa.Table) -> list[str]:
    """When the published disk comes to its end, and how often it slips, over Coulomb friction and rolling arm."""
    rows = [row for row in table.to_pylist() if row["outcome"] == "SETTLED"]
    mu, arm, end, slips = (
        np.array([row[key] for row in rows])
        for key in ("friction.mu_static", "friction.arm_rolling", "t_end", "repeated_slips")
    )
    by_arm, by_mu = exponents(end, arm, mu)
    never = arm[slips == 0]
    ends = Counter(row["outcome"] or "an error" for row in table.to_pylist())
    others = ", ".join(f"{n} with {name}" for name, n in sorted(ends.items()) if name != "SETTLED")
    return [
        f"The end comes after {end.min():.3g} to {end.max():.3g} s and goes as the power {by_arm:.2f} of the rolling "
        f"arm and {by_mu:.2f} of the friction.",
        f"The disk slips up to {slips.max():.0f} times, most at mu_static = {mu[slips.argmax()]:.2g}, and "
        + (f"never in {len(never)} of {len(rows)} runs." if len(never) else "in every run."),
        f"{len(rows)} of {len(table)} runs settle" + (f", {others}." if others else "."),
    ]


def exponents(value: np.ndarray, *over: np.ndarray) -> np.ndarray:
    """Return the powers (k,) of the k positive quantities `over` (n,) whose product follows `value` (n,) best, in
    logarithms."""
    matrix = np.column_stack([*map(np.log, over), np.ones(len(value))])
    return np.linalg.lstsq(matrix, np.log(value))[0][:-1]


CONCLUSIONS: dict[str, Callable[[pa.Table], list[str]]] = {"friction": friction}
"""Shipped sweep -> what its table says."""
