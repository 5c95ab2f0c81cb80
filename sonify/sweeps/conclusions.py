"""Conclusions of the shipped sweeps, in sentences computed from their tables."""

from collections.abc import Callable

import numpy as np
import pyarrow as pa

from dynamics.air import STANDARD_PRESSURE


def friction_conclusion(rows: pa.Table) -> list[str]:
    """Return sentences on end time and number of slips, over Coulomb friction and
    rolling arm."""
    mu, arm, end, slips = numeric_columns(
        rows, "friction.mu_static", "friction.arm_rolling", "t_end", "repeated_slips"
    )
    settled = text_mask(rows, "outcome", "SETTLED")
    (by_arm, by_mu), deviation = fit_power_law(end[settled], arm[settled], mu[settled])
    often = settled & (slips > 0)
    (slips_by_arm, slips_by_mu), _ = fit_power_law(slips[often], arm[often], mu[often])
    others = mu[~settled]
    decides = abs(by_mu) < 0.1 < abs(slips_by_mu)
    so = (
        ": friction determines the number of slips but not the duration"
        if decides
        else ""
    )
    least = others.min(initial=np.inf)
    return [
        f"If the disk settles, it does so after {end[settled].min():.3g} to "
        f"{end[settled].max():.3g} s. This time is proportional to the power {by_arm:.2f} of the rolling "
        f"arm and to the power {by_mu:.2f} of the friction coefficients (within {deviation:.0%}).",
        f"The disk slips {slips[settled].min():.0f} to {slips[settled].max():.0f} times. This "
        f"number is proportional to the power {slips_by_arm:.2f} of the arm and to the power "
        f"{slips_by_mu:.2f} of the friction coefficients{so}.",
        f"The disk settles in all runs below mu_static = {least:.2f}; at or above it, {len(others)} of "
        f"{(mu >= least).sum()} runs have another outcome."
        if len(others)
        else "The disk settles in all runs.",
    ]


def halt_conclusion(rows: pa.Table) -> list[str]:
    """Return sentences on the final energy loss and the loss of contact of a steel disk
    on glass.

    Runs outside the verified range of the film law are reported separately.
    """
    # Largest compressibility number Lam for which the film law was verified
    # numerically
    max_verified_compressibility = 100.0
    pressure, moment, squeezed = numeric_columns(
        rows, "air.pressure", "dissipation.contour_moment", "film_squeezed"
    )
    unverified = ~(squeezed < max_verified_compressibility)
    known = pressure > pressure[unverified].max(initial=-np.inf)
    airborne = text_mask(rows, "outcome", "AIRBORNE")
    by_air = text_mask(rows, "ended_by", "the film of air")
    still = by_air & ~known
    outside = (
        f"At lower pressures {(~known).sum()} runs are inconclusive: the compressibility "
        f"number Lam, or 33 times the squeeze number, reaches {squeezed.max():.1g}, but the film "
        f"law was verified only up to {max_verified_compressibility:g}. According to this law, the film "
        f"dissipates the most energy in {still.sum()} of these runs, down to "
        f"{pressure[still].min(initial=np.inf) / STANDARD_PRESSURE:.2g} atmospheres."
    )
    inside = (
        f"The final compressibility number Lam is at most {squeezed.max():.2g}. The film law was "
        f"verified up to {max_verified_compressibility:g} and is therefore valid in all runs."
    )
    return [
        f"At {pressure[known].min() / STANDARD_PRESSURE:.2g} atmospheres and above, where the film law was "
        f"verified, the air lifts the disk in {(airborne & known).sum()} of {known.sum()} runs.",
        "In this range the film dissipates more of the last tenth of the energy than any other cause in "
        f"{(by_air & known).sum()} runs, up to a contour moment of "
        f"{moment[by_air & known].max(initial=0.0):.2g} N m.",
        inside if known.all() else outside,
    ]


def one_mode_table_conclusion(rows: pa.Table) -> list[str]:
    """Return sentences on the end of the motion on a table with one mode, over mass and
    pressure."""
    mass, pressure, kept, end, returned = numeric_columns(
        rows,
        "surface.modes.0.modal_mass",
        "air.pressure",
        "contact_kept",
        "t_end",
        "dissipation_never_falls",
    )
    air = text_mask(rows, "ended_by", "the film of air")
    solved = ~np.isnan(kept)
    by_table = text_mask(rows, "ended_by", "the table")
    failed = rows["passed"].to_pylist().count(False)
    light, heavy = (np.nanmedian(end[mass == m]) for m in (mass.min(), mass.max()))
    over_air = max(np.ptp(end[solved & (mass == m)]) for m in np.unique(mass[solved]))
    gains = (
        f"; in {failed} runs the film returns up to {np.nanmax(returned):.1g} of the energy, and a "
        "self-check fails"
    )
    return [
        f"The lighter the table, the earlier the motion ends: after {light:.2g} s with a mode of "
        f"{mass.min():.2g} kg, and after {heavy:.2g} s with a mode of {mass.max():.2g} kg (medians). From "
        f"{pressure.min() / STANDARD_PRESSURE:.1g} to {pressure.max() / STANDARD_PRESSURE:.1g} "
        f"atmospheres, the air changes this time by {over_air:.2g} s at most.",
        f"Vibration breaks the contact before the end in {(kept == 0).sum()} of {solved.sum()} "
        "runs. Finally the air lifts the disk in "
        f"{text_mask(rows, 'outcome', 'AIRBORNE').sum()}{gains if failed else ''}.",
        f"Most of the last tenth of the energy goes into the air film in {air.sum()} runs, at "
        f"{pressure[air].min(initial=np.inf) / STANDARD_PRESSURE:.2g} atmospheres and above; into the "
        f"table in {by_table.sum()} runs, with modes up to {mass[by_table].max(initial=0.0):.2g} kg; and "
        "into friction and impacts in the other runs.",
    ]


def pitch_conclusion(rows: pa.Table) -> list[str]:
    """Return sentences on the source of the rising tone, over plate thickness and
    distance."""
    thickness, distance, table_level = numeric_columns(
        rows, "surface.thickness", "audio.distance", "table_carries_the_tone"
    )
    heard = ~np.isnan(table_level)
    plate = heard & (table_level > 0)
    steps = [
        np.ptp(table_level[heard & (thickness == t)])
        for t in np.unique(thickness[heard])
    ]
    return [
        f"The glass plate emits the rising tone of the last second in {plate.sum()} of "
        f"{heard.sum()} runs, up to a thickness of {1e3 * thickness[plate].max(initial=0.0):.2g} "
        f"mm. In these runs the plate is {table_level[plate].min(initial=np.inf):.0f} to "
        f"{table_level[plate].max(initial=0.0):.0f} dB louder than the disk; in the others the disk is "
        "louder.",
        f"From {distance.min():.2g} to {distance.max():.2g} m, the distance changes this level by "
        f"{max(steps):.1f} dB at most.",
    ]


def text_mask(rows: pa.Table, name: str, text: str) -> np.ndarray:
    """Return a mask (n,) of the rows in which column `name` equals `text`."""
    return rows[name].to_numpy() == text


def numeric_columns(rows: pa.Table, *names: str) -> list[np.ndarray]:
    """Return numeric columns as arrays (n,), with NaN for missing values."""
    return [rows[name].cast("float64").to_numpy() for name in names]


def fit_power_law(
    value: np.ndarray, *quantities: np.ndarray
) -> tuple[np.ndarray, float]:
    """Fit `value` (n,) by a product of powers of k positive quantities, each (n,).

    The logarithms are fitted by least squares. Returns the exponents (k,), rounded to
    two decimals, and the relative root-mean-square residual."""
    matrix = np.column_stack([*map(np.log, quantities), np.ones(len(value))])
    found = np.linalg.lstsq(matrix, np.log(value))[0]
    return found[:-1].round(2) + 0.0, float(
        np.sqrt(np.mean((matrix @ found - np.log(value)) ** 2))
    )


CONCLUSIONS: dict[str, Callable[[pa.Table], list[str]]] = {
    "friction": friction_conclusion,
    "halt": halt_conclusion,
    "halt-table": one_mode_table_conclusion,
    "pitch": pitch_conclusion,
}
"""Functions that return the conclusions from the table of a shipped sweep, by name."""
