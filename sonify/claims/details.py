"""DETAILS OF A FINDING -> DETAIL_SENTENCES: one table of phrases for the numbers in addition to the value."""

from collections.abc import Callable, Mapping

from sonify.claims.finding import Finding


def changed_values(numbers: Mapping[str, float]) -> str:
    """Return the values with half the time step and with twice the contact stiffness."""
    if "half_step" not in numbers:
        return ""
    return (
        f"{numbers['half_step']:.3g} with half the time step, "
        f"{numbers['twice_stiff']:.3g} with twice the contact stiffness"
    )


def shares_in_words(numbers: Mapping[str, float]) -> str:
    """Return each cause with its share."""
    causes = {
        name: share for name, share in numbers.items() if name not in ("half_step", "twice_stiff")
    }
    return ", ".join(f"{cause} {share:.3f}" for cause, share in causes.items())


def nutation_in_words(numbers: Mapping[str, float]) -> str:
    """Return the time at which the nutation ends."""
    return "the disk nutates until {nutates_until:.4g} s of {motion_ends:.4g} s".format(**numbers)


def contact_in_words(numbers: Mapping[str, float]) -> str:
    """Return the origin of the losses of contact, solved or predicted, and the first time."""
    how = "solved" if numbers["solved"] else "predicted by the linear filter"
    first = f"first {numbers['first']:.3g} s after the release" if "first" in numbers else "never"
    return f"{how}; {first}"


DETAIL_SENTENCES: dict[str, Callable[[Mapping[str, float]], str]] = {
    "air_moves_carrier": "{force_as_radiated:.2f} of the force as film and air radiate it".format_map,
    "disk_rattles": (
        "{impacts_per_second:.0f} impacts per second; curvature of the heights {curvature_number:.2f} "
        "times that of the rim, heights {rms_over_depth:.1f} times the depth of the "
        "contact".format_map
    ),
    "carried_by_air": (
        "lost at {time:.5g} s, {inclination:.3g} rad, {precession_frequency:.3g} turns per second".format_map
    ),
    "carrier_is_contact": "{force_alone:.2f} of the force alone".format_map,
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
    "micro_flights": "the longest of {number:.0f}; the highest is {height:.2g} m".format_map,
    "precession_grows": "{release:.3g}/χ at the release, {half_way:.3g}/χ half-way, {late:.3g}/χ "
    "at 99 %".format_map,
    "rate_is_that_of_the_table": (
        "impacts alone would give {rate_at_1s:.3g} turns per second one second before the "
        "end".format_map
    ),
    "rates_are_alike": "{nutations_per_turn:.2f} nutations per turn".format_map,
    "table_rings_at_the_halt": "{before_end:.3g} s before the end".format_map,
    "vibration_opens_contact": (
        "in the first {until:.2g} s the contact is open for {open_share:.1%} of the time, without "
        "the modes for {open_share_without_modes:.1%}, without roughness for "
        "{open_share_without_roughness:.1%}".format_map
    ),
    "waves_make_the_halt": shares_in_words,
    "what_ends": shares_in_words,
}
"""Key of a finding -> function that puts its details into words.

`details_in_words` adds the values with half the time step and twice the contact stiffness to each.
"""


def details_in_words(finding: Finding) -> str:
    """Return the details of a finding as a phrase, empty if it has none."""
    if not finding.details:
        return ""
    own = DETAIL_SENTENCES[finding.key](finding.details) if finding.key in DETAIL_SENTENCES else ""
    return "; ".join(filter(None, (own, changed_values(finding.details))))


def unit_and_details(finding: Finding) -> str:
    """Return the unit of a finding, followed by its details."""
    return "; ".join(filter(None, (finding.unit, details_in_words(finding))))
