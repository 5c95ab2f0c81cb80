"""Phrases for the numbers that a finding reports in addition to its value."""

from collections.abc import Callable, Mapping

from sonify.claims.finding import Finding


def variations_in_words(numbers: Mapping[str, float]) -> str:
    """Return a phrase with the values for half the time step and twice the contact
    stiffness."""
    if "half_step" not in numbers:
        return ""
    return (
        f"{numbers['half_step']:.3g} with half the time step, "
        f"{numbers['twice_stiff']:.3g} with twice the contact stiffness"
    )


def shares_in_words(numbers: Mapping[str, float]) -> str:
    """Return a phrase that lists each cause with its share."""
    causes = {
        name: share
        for name, share in numbers.items()
        if name not in ("half_step", "twice_stiff")
    }
    return ", ".join(f"{cause} {share:.3f}" for cause, share in causes.items())


def nutation_in_words(numbers: Mapping[str, float]) -> str:
    """Return a phrase with the time at which the nutation ends."""
    return "the disk nutates until {nutates_until:.4g} s of {motion_ends:.4g} s".format(
        **numbers
    )


def contact_in_words(numbers: Mapping[str, float]) -> str:
    """Return a phrase with the method for losses of contact and the time of the first
    loss."""
    how = "solved" if numbers["solved"] else "predicted by the linear filter"
    first = (
        f"first {numbers['first']:.3g} s after the release"
        if "first" in numbers
        else "never"
    )
    return f"{how}; {first}"


DETAIL_SENTENCES: dict[str, Callable[[Mapping[str, float]], str]] = {
    "air_moves_carrier": "{force_as_radiated:.2f} times that of the force as radiated by film and air".format_map,
    "disk_rattles": (
        "{impacts_per_second:.0f} impacts per second; the curvature of the heights is "
        "{curvature_number:.2f} times that of the rim, and their rms is {rms_over_depth:.1f} times the "
        "indentation; restitution {effective_restitution:.2f} with the modes of the disk".format_map
    ),
    "air_carries_earlier": "two-way coupling lasts for the final {acts_before_end:.3g} s".format_map,
    "carried_by_air": (
        "contact lost at {time:.5g} s, {inclination:.3g} rad and {precession_frequency:.3g} turns per second".format_map
    ),
    "carrier_is_contact": "{force_alone:.2f} for the force alone".format_map,
    "carrier_passes_recorded_peaks": "from {from:.3g} s to {to:.3g} s".format_map,
    "carrier_rises": "from {from:.0f} Hz to {to:.0f} Hz".format_map,
    "contact_is_lost": contact_in_words,
    "halt_comes_earlier": "{advance_at_100_urad:.3g} s earlier at 1e-4 rad".format_map,
    "load_frequency_reached": nutation_in_words,
    "load_frequency_rises": nutation_in_words,
    "loss_at_resonance": (
        "{before_end:.2g} s before the end, at {precession_frequency:.3g} turns per second; "
        "{number:.0f} losses in all".format_map
    ),
    "micro_flights": "{number:.0f} in all; the highest reaches {height:.2g} m".format_map,
    "precession_grows": "{release:.3g}/χ at the release, {half_way:.3g}/χ at half the time and {late:.3g}/χ "
    "at 99 %".format_map,
    "rate_is_that_of_the_table": (
        "impacts alone would give {rate_at_1s:.3g} turns per second one second before the "
        "end".format_map
    ),
    "rates_are_alike": "{nutations_per_turn:.2f} nutations per turn".format_map,
    "sound_is_audible": "above the threshold for {audible_share:.0%} of the time".format_map,
    "table_rings_at_the_halt": "{before_end:.3g} s before the end".format_map,
    "contact_breaks_before_end": shares_in_words,
    "vibration_opens_contact": (
        "in the first {until:.2g} s the contact is open for {open_share:.1%} of the time, or "
        "{open_share_without_modes:.1%} without the modes and {open_share_without_roughness:.1%} "
        "without roughness".format_map
    ),
    "waves_make_the_halt": shares_in_words,
    "what_ends": shares_in_words,
}
"""Functions that describe the details of a finding, by its key.

`details_in_words` adds the values for half the time step and twice the contact
stiffness. """


def details_in_words(finding: Finding) -> str:
    """Return a phrase with the details of a finding, or "" if it has none."""
    if not finding.details:
        return ""
    own = (
        DETAIL_SENTENCES[finding.key](finding.details)
        if finding.key in DETAIL_SENTENCES
        else ""
    )
    return "; ".join(filter(None, (own, variations_in_words(finding.details))))


def unit_and_details(finding: Finding) -> str:
    """Return the unit of a finding and the phrase with its details."""
    return "; ".join(filter(None, (finding.unit, details_in_words(finding))))


def expectation_and_unit(finding: Finding) -> str:
    """Return the allowed range of a finding with its unit, without the description that
    follows the unit after a comma or in brackets."""
    unit = finding.unit.partition(" (")[0].partition(",")[0]
    return f"{finding.expectation} {unit}"
