"""Phrases for the details of a finding that depend on which details there are."""

from collections.abc import Mapping


def shares_in_words(numbers: Mapping[str, float]) -> str:
    """Return a phrase that lists each cause with its share."""
    causes = {
        name: share
        for name, share in numbers.items()
        if name not in ("half_step", "twice_stiff")
    }
    return ", ".join(f"{cause} {share:.3f}" for cause, share in causes.items())


def restitutions_in_words(numbers: Mapping[str, float]) -> str:
    """Return a phrase with the share for each restitution, whose name is at_<percent>."""
    return ", ".join(
        f"{share:.0%} at a restitution of 0.{name.removeprefix('at_')}"
        for name, share in numbers.items()
    )


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


def open_contact_shares_in_words(numbers: Mapping[str, float]) -> str:
    """Return a phrase with the open shares of a rattling disk with and without its
    modes; it is empty for other motions."""
    if "open_share" not in numbers:
        return ""
    return (
        "in the first {until:.2g} s the contact is open for {open_share:.1%} of the time, or "
        "{open_share_without_modes:.1%} without the modes and {open_share_without_roughness:.1%} "
        "without roughness"
    ).format_map(numbers)


def lift_off_in_words(numbers: Mapping[str, float]) -> str:
    """Return a phrase with the place of the lift-off; it is empty without one."""
    if "time" not in numbers:
        return ""
    return (
        "contact lost at {time:.5g} s, {inclination:.3g} rad and {precession_frequency:.3g} turns "
        "per second"
    ).format_map(numbers)


def film_switched_in_words(numbers: Mapping[str, float]) -> str:
    """Return a phrase with the band to which that in the sound is compared."""
    if "without_film" in numbers:
        return f"{numbers['without_film']:.0f} Hz without the film"
    return (
        f"{numbers['force_as_radiated']:.2f} times that of the force as radiated by film "
        "and air"
    )


PART_WORDS = {"tone": "the tone", "beats": "the beats", "band": "the noise band"}
"""Words for the parts of a sound that may rise."""


def rises_in_words(numbers: Mapping[str, float]) -> str:
    """Return a phrase with the course of each part of the sound and the least rise that
    counts."""
    if numbers.get("audible") == 0:
        return "nothing is audible"
    names = [name for name in PART_WORDS if f"{name}_from" in numbers]
    names.sort(key=lambda name: list(numbers).index(f"{name}_from"))
    clauses = [rise_in_words(name, numbers) for name in names]
    return "; ".join(clauses)


def rise_in_words(name: str, numbers: Mapping[str, float]) -> str:
    """Return a clause with the course of one part of the sound."""
    unit = "per second" if name == "beats" else "Hz"
    first = numbers[f"{name}_from"]
    last = numbers[f"{name}_to"]
    limit = numbers[f"{name}_at_least"]
    what = PART_WORDS[name]
    plural = name == "beats"
    if plural and "beats_per_turn" in numbers:
        what += f", {numbers['beats_per_turn']:.0f} per turn,"
    verbs = ("rise", "stay", "change") if plural else ("rises", "stays", "changes")
    rise, stay, change = verbs
    factor = last / first
    course = f"from {first:.0f} to {last:.0f} {unit}"
    if factor >= limit:
        told = f"{what} {rise} {course}"
    elif abs(factor - 1) < 0.1:
        told = f"{what} {stay} at {last:.0f} {unit}"
    else:
        told = f"{what} {change} {course}"
    return f"{told} ({factor:.2f}-fold, limit {limit:g})"


def percentage(share: float) -> str:
    """Return a share as a percentage with two digits, or as a whole percentage from 1 on."""
    return f"{100 * share:.0f}%" if share >= 1 else f"{100 * share:.2g}%"


def vibration_in_words(
    value: float, limit: float, numbers: Mapping[str, float], part: str
) -> str:
    """Return the number that decides whether vibration of a part breaks the contact, and
    its limit."""
    if "force_rms" in numbers:
        measure = f"it varies the force by {percentage(value)} of the weight"
    elif "open_by_vibration" in numbers:
        measure = f"it opens the contact for {percentage(value)} of the time"
    elif part == "disk":
        measure = f"it causes {percentage(value)} of the time without contact"
    else:
        return f"{value:.0f} losses of contact, limit {limit:.0f}"
    return f"{measure}, limit {percentage(limit)}"


def breaks_in_words(
    key: str, value: float, limit: float, numbers: Mapping[str, float]
) -> str:
    """Return a cause of a loss of contact, with its value and the limit from which on it
    breaks the contact."""
    if key == "carried_by_air" and "airborne" in numbers:
        return f"the air (which {'lifts' if value else 'does not lift'} the disk)"
    if key == "carried_by_air":
        return f"the air (lift {value:.3g} times the vertical force, limit {limit:g})"
    if key == "unevenness_breaks_contact":
        told = f"{value:.2g}" if value < 10 else f"{value:.0f}"
        return f"unevenness ({told} times the critical curvature, limit {limit:g})"
    part = "disk" if key == "vibration_opens_contact" else "table"
    return (
        f"vibration of the {part} ({vibration_in_words(value, limit, numbers, part)})"
    )
