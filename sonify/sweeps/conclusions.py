"""TABLE -> SENTENCES: compute the conclusions of the shipped sweeps from their tables."""

from collections.abc import Callable

import numpy as np
import pyarrow as pa

from dynamics.air import STANDARD_PRESSURE

MAX_VERIFIED_COMPRESSIBILITY = 100.0
"""Largest compressibility number Lam at which the film law was compared with solutions."""


def friction_conclusion(table: pa.Table) -> list[str]:
    """Describe how end time and number of slips depend on Coulomb friction and rolling arm."""
    mu, arm, end, slips = columns(
        table, "friction.mu_static", "friction.arm_rolling", "t_end", "repeated_slips"
    )
    settled = np.array([outcome == "SETTLED" for outcome in table["outcome"].to_pylist()])
    (by_arm, by_mu), off = fit_power_law(end[settled], arm[settled], mu[settled])
    often = settled & (slips > 0)
    (slips_by_arm, slips_by_mu), _ = fit_power_law(slips[often], arm[often], mu[often])
    others = mu[~settled]
    so = (
        ": friction decides how often, not for how long"
        if abs(by_mu) < 0.1 < abs(slips_by_mu)
        else ""
    )
    least = others.min(initial=np.inf)
    return [
        f"Where the disk settles, the end comes after {end[settled].min():.3g} to "
        f"{end[settled].max():.3g} s, about as "
        f"the power {by_arm:.2f} of the rolling arm and {by_mu:.2f} of Coulomb friction (within "
        f"{off:.0%}).",
        f"On its way it slips {slips[settled].min():.0f} to {slips[settled].max():.0f} times, "
        f"about as the power "
        f"{slips_by_arm:.2f} of the arm and {slips_by_mu:.2f} of friction{so}.",
        f"It settles in all runs below mu_static = {least:.2f}; from there on {len(others)} of "
        f"{(mu >= least).sum()} "
        "end otherwise."
        if len(others)
        else "It settles in all runs.",
    ]


def halt_conclusion(table: pa.Table) -> list[str]:
    """Describe where the last energy of a steel disk on glass goes and whether contact is lost.

    Runs outside the validated range of the film law are reported separately.
    """
    pressure, moment, squeezed = columns(
        table, "air.pressure", "dissipation.contour_moment", "film_squeezed"
    )
    held = [
        p
        for p in np.unique(pressure)
        if (squeezed[pressure >= p] < MAX_VERIFIED_COMPRESSIBILITY).all()
    ]
    known = pressure >= min(held, default=np.inf)
    airborne = contains_text(table, "outcome", "AIRBORNE")
    by_air = contains_text(table, "ended_by", "the film of air")
    still = by_air & ~known
    return [
        f"From {pressure[known].min() / STANDARD_PRESSURE:.2g} atmospheres on, where the law of "
        f"the film has been held "
        f"against solutions, contact is lost to the air in {(airborne & known).sum()} of "
        f"{known.sum()} runs.",
        f"There the film takes more of the last tenth of the energy than anything else in "
        f"{(by_air & known).sum()} "
        f"runs, up to a contour moment of {moment[by_air & known].max(initial=0.0):.2g} N m.",
        f"At lower pressures {(~known).sum()} runs tell nothing certain, as Lam, or 33 times how "
        f"much faster "
        f"the disk falls than its air leaves, is up to {squeezed.max():.1g} there, and the law "
        f"has been held against "
        f"solutions up to {MAX_VERIFIED_COMPRESSIBILITY:g}: by it the film takes most in "
        f"{still.sum()} "
        f"of them, down to {pressure[still].min(initial=np.inf) / STANDARD_PRESSURE:.2g} "
        f"atmospheres."
        if not known.all()
        else f"At the end Lam, how far the film squeezes its air, is up to {squeezed.max():.2g}, "
        f"below the {MAX_VERIFIED_COMPRESSIBILITY:g} "
        "up to which solutions have been held against it: the law of the film holds in all runs.",
    ]


def halt_table_conclusion(table: pa.Table) -> list[str]:
    """Describe what ends the motion on a table with one mode, over modal mass and air pressure."""
    mass, pressure, kept, end = columns(
        table, "surface.modes.0.modal_mass", "air.pressure", "contact_kept", "t_end"
    )
    (back,) = columns(table, "dissipation_never_falls")
    air = contains_text(table, "ended_by", "the film of air")
    solved = ~np.isnan(kept)
    waves = contains_text(table, "ended_by", "the table")
    failed = table["passed"].to_pylist().count(False)
    light, heavy = (np.nanmedian(end[mass == m]) for m in (mass.min(), mass.max()))
    over_air = max(np.ptp(end[solved & (mass == m)]) for m in np.unique(mass[solved]))
    gives = f"; in {failed} the film gives back up to {np.nanmax(back):.1g} of the energy, which a self-check refuses"
    return [
        f"A lighter table ends the motion earlier: with a mode of {mass.min():.2g} kg after "
        f"{light:.2g} s, with one of "
        f"{mass.max():.2g} kg after {heavy:.2g} s (medians); from "
        f"{pressure.min() / STANDARD_PRESSURE:.1g} to "
        f"{pressure.max() / STANDARD_PRESSURE:.1g} atmospheres the air changes that by "
        f"{over_air:.2g} s at most.",
        f"Vibration breaks the contact in {(kept == 0).sum()} of {solved.sum()} runs before the "
        f"end, at which the air "
        f"carries the disk in "
        f"{contains_text(table, 'outcome', 'AIRBORNE').sum()}{gives if failed else ''}.",
        f"Most of the last tenth of the energy goes into the film of air in {air.sum()} runs, from "
        f"{pressure[air].min(initial=np.inf) / STANDARD_PRESSURE:.2g} atmospheres on, into the "
        f"table in {waves.sum()}, "
        f"with modes up to {mass[waves].max(initial=0.0):.2g} kg, and into friction and impacts "
        f"in the others.",
    ]


def pitch_conclusion(table: pa.Table) -> list[str]:
    """Describe whether plate or disk emits the rising tone, over plate thickness and distance."""
    thickness, distance = columns(table, "surface.thickness", "audio.distance")
    over, late = columns(table, "table_carries_the_tone", "table_takes_little")
    (by_thickness,), _ = fit_power_law(late, thickness)
    heard = ~np.isnan(over)
    plate = heard & (over > 0)
    steps = [np.ptp(over[heard & (thickness == t)]) for t in np.unique(thickness[heard])]
    return [
        f"The glass plate carries the rising tone of the last second in {plate.sum()} of "
        f"{heard.sum()} runs, those up "
        f"to {1e3 * thickness[plate].max(initial=0.0):.2g} mm, by "
        f"{over[plate].min(initial=np.inf):.0f} to "
        f"{over[plate].max(initial=0.0):.0f} dB over the disk; in the others the disk does.",
        f"From {distance.min():.2g} to {distance.max():.2g} m, distance changes that by "
        f"{max(steps):.1f} dB at most.",
        f"The modes of the plate would hold as much energy as the disk {late.min():.2g} to "
        f"{late.max():.2g} s before "
        f"the end, about as the power {by_thickness:.2f} of its thickness: then it acts back, "
        f"which is left out.",
    ]


def contains_text(table: pa.Table, name: str, text: str) -> np.ndarray:
    """Return a mask (n,) of the rows in which column `name` equals `text`."""
    return np.array([value == text for value in table[name].to_pylist()])


def columns(table: pa.Table, *names: str) -> list[np.ndarray]:
    """Return numeric columns as arrays (n,), with NaN for missing values."""
    return [
        np.array([np.nan if v is None else v for v in table[name].to_pylist()]) for name in names
    ]


def fit_power_law(value: np.ndarray, *over: np.ndarray) -> tuple[np.ndarray, float]:
    """Fit `value` (n,) by a product of powers of k positive quantities (n,) each.

    The fit is a least-squares fit of the logarithms. Returns the exponents (k,), rounded to two
    decimals, and the relative root-mean-square residual.
    """
    matrix = np.column_stack([*map(np.log, over), np.ones(len(value))])
    found = np.linalg.lstsq(matrix, np.log(value))[0]
    return found[:-1].round(2) + 0.0, float(np.sqrt(np.mean((matrix @ found - np.log(value)) ** 2)))


CONCLUSIONS: dict[str, Callable[[pa.Table], list[str]]] = {
    "friction": friction_conclusion,
    "halt": halt_conclusion,
    "halt-table": halt_table_conclusion,
    "pitch": pitch_conclusion,
}
"""Shipped sweep -> function that returns the conclusions from its table."""
