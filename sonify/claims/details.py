"""Phrases for the numbers that a finding reports in addition to its value."""

from collections.abc import Mapping

from sonify.claims.finding import Finding
from sonify.claims.finding_texts import FINDING_TEXTS


def variations_in_words(numbers: Mapping[str, float]) -> str:
    """Return a phrase with the values for half the time step and twice the contact
    stiffness."""
    if "half_step" not in numbers:
        return ""
    return (
        f"{numbers['half_step']:.3g} with half the time step, "
        f"{numbers['twice_stiff']:.3g} with twice the contact stiffness"
    )


def details_in_words(finding: Finding) -> str:
    """Return a phrase with the details of a finding, or "" if it has none."""
    if not finding.details:
        return ""
    own = FINDING_TEXTS[finding.key].phrase(finding.details)
    return "; ".join(filter(None, (own, variations_in_words(finding.details))))


def unit_and_details(finding: Finding) -> str:
    """Return the unit of a finding and the phrase with its details."""
    return "; ".join(filter(None, (finding.unit, details_in_words(finding))))


def expectation_and_unit(finding: Finding) -> str:
    """Return the allowed range of a finding with its unit, without the description that
    follows the unit after a comma or in brackets."""
    unit = finding.unit.partition(" (")[0].partition(",")[0]
    return f"{finding.expectation} {unit}"
