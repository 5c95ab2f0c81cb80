"""TABLE -> SENTENCES: what the shipped sweeps say, computed from their tables."""

from collections.abc import Callable

import numpy as np
import pyarrow as pa


def friction(table: pa.Table) -> list[str]:
    """When the published disk comes to its end, and how often it slips, over Coulomb friction and rolling arm."""
    mu, arm, end, slips = columns(table, "friction.mu_static", "friction.arm_rolling", "t_end", "repeated_slips")
    settled = np.array([outcome == "SETTLED" for outcome in table["outcome"].to_pylist()])
    (by_arm, by_mu), off = powers(end[settled], arm[settled], mu[settled])
    often = settled & (slips > 0)
    (slips_by_arm, slips_by_mu), _ = powers(slips[often], arm[often], mu[often])
    others = mu[~settled]
    so = ": friction decides how often, not for how long" if abs(by_mu) < 0.1 < abs(slips_by_mu) else ""
    least = others.min(initial=np.inf)
    return [
        f"Where the disk settles, the end comes after {end[settled].min():.3g} to {end[settled].max():.3g} s, about as "
        f"the power {by_arm:.2f} of the rolling arm and {by_mu:.2f} of Coulomb friction (within {off:.0%}).",
        f"On its way it slips {slips[settled].min():.0f} to {slips[settled].max():.0f} times, about as the power "
        f"{slips_by_arm:.2f} of the arm and {slips_by_mu:.2f} of friction{so}.",
        f"It settles in all runs below mu_static = {least:.2f}; from there on {len(others)} of {(mu >= least).sum()} "
        "end otherwise."
        if len(others)
        else "It settles in all runs.",
    ]


def columns(table: pa.Table, *names: str) -> list[np.ndarray]:
    """Return columns of numbers as arrays (n,), not a number where there is none."""
    return [np.array([np.nan if v is None else v for v in table[name].to_pylist()]) for name in names]


def powers(value: np.ndarray, *over: np.ndarray) -> tuple[np.ndarray, float]:
    """Return the powers (k,) of the k positive quantities `over` (n,) whose product follows `value` (n,) best, in
    logarithms, and by how much that is off, in quadratic mean, relative; the
    powers to two digits."""
    matrix = np.column_stack([*map(np.log, over), np.ones(len(value))])
    found = np.linalg.lstsq(matrix, np.log(value))[0]
    return found[:-1].round(2) + 0.0, float(np.sqrt(np.mean((matrix @ found - np.log(value)) ** 2)))


CONCLUSIONS: dict[str, Callable[[pa.Table], list[str]]] = {"friction": friction}
"""Shipped sweep -> what its table says."""
