"""Comparison of numbers in section 7 and in the figures of the paper with a run of the
same scene."""

import numpy as np

from dynamics import Motion
from dynamics.observables import nutations_per_turn, precession_rate
from sonify.claims.finding import Finding
from sonify.claims.rigid_motion import PAPER_FORCING_FREQUENCY

PAPER_FIGURE_FINDINGS = (
    "energy_falls",
    "sliding_costs_more",
    "contact_kept",
    "load_frequency_rises",
    "load_frequency_reached",
    "centre_comes_to_rest",
    "audible_modes",
)
"""Keys of the findings on figures of the paper and on numbers in its text."""


def paper_rows(motion: Motion, findings: list[Finding]) -> list[Finding]:
    """Return findings on the numbers of section 7 and of the figures.

    They are followed by those of the given findings that are in PAPER_FIGURE_FINDINGS.
    """
    disk = motion.disk
    rate = np.abs(precession_rate(motion.at(motion.t[-1] * np.array([0.0, 0.5, 0.99]))))
    alpha = np.pi / 2 - motion.at(motion.t[[0, -1]])[:, 1]
    shown = {finding.key: finding for finding in findings}
    own = [
        _paper_number(
            "unit_of_time",
            "The unit of time is χ = 0.0691712 s",
            disk.time_unit,
            "s",
            0.0691712,
            5e-8,
            "(7.2)",
        ),
        _paper_number(
            "half_height",
            "H/R = 1.28/7.51 (the paper prints the reciprocal)",
            disk.aspect,
            "H/R",
            1.28 / 7.51,
            1e-9,
            "(7.2)",
        ),
        _paper_number(
            "density",
            "The density is 7737.27",
            disk.mass / disk.volume,
            "kg/m³",
            7737.27,
            5e-3,
            "footnote 4",
        ),
        _paper_number(
            "named_rate",
            "f = 2.5 is 36 Hz",
            PAPER_FORCING_FREQUENCY / disk.time_unit,
            "Hz",
            36.0,
            0.5,
            "figure 4, caption",
        ),
        _paper_number(
            "begins_at",
            "α begins at 1.0",
            alpha[0],
            "rad",
            1.0,
            1e-9,
            "figure 3 (a), (7.4)",
        ),
        _paper_number(
            "ends_at",
            "α tends to π/2",
            alpha[1],
            "rad",
            np.pi / 2,
            1e-6,
            "figure 3 (a)",
        ),
        *_rates_are_alike(motion),
        Finding(
            key="precession_grows",
            claim="dθ/dτ increases considerably",
            value=float(rate[2] / rate[0]),
            unit="times, from the release to 99 % of the time",
            details=dict(
                zip(
                    ("release", "half_way", "late"),
                    (rate * disk.time_unit).tolist(),
                    strict=True,
                )
            ),
            at_least=2.0,
            source="figure 6",
        ),
    ]
    return own + [shown[key] for key in PAPER_FIGURE_FINDINGS if key in shown]


def _rates_are_alike(motion):
    """Return the finding on the ratio of nutation to precession; empty without
    nutation."""
    ratio = nutations_per_turn(motion)
    if not len(ratio):
        return []
    low, middle, high = np.percentile(ratio, [5, 50, 95])
    return [
        Finding(
            key="rates_are_alike",
            claim="The curve of dθ/dτ mostly resembles that of the frequency of the normal force",
            value=float((high - low) / middle / 2),
            unit="half the 5-95 % range of their ratio, relative to its median",
            details={"nutations_per_turn": float(middle)},
            at_most=0.1,
            source="section 7, on figures 4 (b) and 6",
        )
    ]


def _paper_number(
    key: str,
    claim: str,
    value: float,
    unit: str,
    paper: float,
    digits: float,
    source: str,
) -> Finding:
    """Return the finding on a number printed in the paper; `digits` is the
    tolerance."""
    return Finding(
        key=key,
        claim=claim,
        value=float(value),
        unit=unit,
        at_least=paper,
        at_most=paper,
        tolerance=digits,
        source=source,
    )
