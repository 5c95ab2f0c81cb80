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


def film_switched_in_words(numbers: Mapping[str, float]) -> str:
    """Return a phrase with the band to which that in the sound is compared."""
    if "without_film" in numbers:
        return f"{numbers['without_film']:.0f} Hz without the film"
    return (
        f"{numbers['force_as_radiated']:.2f} times that of the force as radiated by film "
        "and air"
    )
