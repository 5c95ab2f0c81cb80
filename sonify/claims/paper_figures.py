"""Comparison of numbers in section 7 and in the figures of the paper with a run of the
same scene."""

import numpy as np

from dynamics import Motion
from dynamics.observables import nutations_per_turn, precession_rate
from sonify.claims.finding import Finding
from sonify.claims.finding_texts import FINDING_TEXTS
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
        _paper_number("unit_of_time", disk.time_unit, 0.0691712, 5e-8),
        _paper_number("half_height", disk.aspect, 1.28 / 7.51, 1e-9),
        _paper_number("density", disk.mass / disk.volume, 7737.27, 5e-3),
        _paper_number(
            "named_rate", PAPER_FORCING_FREQUENCY / disk.time_unit, 36.0, 0.5
        ),
        _paper_number("begins_at", alpha[0], 1.0, 1e-9),
        _paper_number("ends_at", alpha[1], np.pi / 2, 1e-6),
        *_rates_are_alike(motion),
        Finding(
            key="precession_grows",
            value=float(rate[2] / rate[0]),
            details=dict(
                zip(
                    ("release", "half_way", "late"),
                    (rate * disk.time_unit).tolist(),
                    strict=True,
                )
            ),
            at_least=2.0,
            **FINDING_TEXTS["precession_grows"].of_run(),
        ),
    ]
    return own + [shown[key] for key in PAPER_FIGURE_FINDINGS if key in shown]


def _rates_are_alike(motion: Motion) -> list[Finding]:
    """Return the finding on the ratio of nutation to precession; empty without
    nutation."""
    ratio = nutations_per_turn(motion)
    if not len(ratio):
        return []
    low, middle, high = np.percentile(ratio, [5, 50, 95])
    return [
        Finding(
            key="rates_are_alike",
            value=float((high - low) / middle / 2),
            details={"nutations_per_turn": float(middle)},
            at_most=0.1,
            **FINDING_TEXTS["rates_are_alike"].of_run(),
        )
    ]


def _paper_number(key: str, value: float, paper: float, digits: float) -> Finding:
    """Return the finding on a number printed in the paper; `digits` is the
    tolerance."""
    return Finding(
        key=key,
        value=float(value),
        at_least=paper,
        at_most=paper,
        tolerance=digits,
        **FINDING_TEXTS[key].of_run(),
    )
