"""Summarise in one sentence what a run shows about the paper's conjecture."""

from collections.abc import Iterable

from sonify.claims.finding import Finding

HEADLINE_CLAUSES: dict[str, dict[str, tuple[str, str]]] = {
    "sound": {
        "table_is_louder": (
            "you hear the table more than the disk",
            "you hear the disk more than the table",
        ),
        "carrier_is_contact": (
            "you hear the disk vibrate on its contact",
            "you hear a resonance other than that of the contact alone",
        ),
        "modes_carry_the_end": (
            "you hear the disk ring",
            "you hear the disk move rather than ring",
        ),
        "free_modes_are_heard": (
            "you hear the disk ring",
            "you hear more than the ringing of the disk",
        ),
        "heard_through_film": (
            "you hear the disk move",
            "the motion of the disk is inaudible",
        ),
    },
    "pitch": {
        "table_tone_rises": ("the pitch rises", "the pitch does not rise"),
        "carrier_rises": ("the pitch rises", "the pitch does not rise"),
        "pitch_rises": ("the pitch rises", "the pitch does not rise"),
    },
    "contact": {
        "table_breaks_contact": (
            "vibrations break the contact",
            "vibrations do not break the contact",
        ),
        "disk_rattles": (
            "the disk rattles on the table",
            "the disk hardly leaves the table",
        ),
        "contact_is_lost": (
            "the disk leaves the table",
            "the disk never leaves the table",
        ),
        "contact_kept": (
            "the disk never leaves the table",
            "the disk leaves the table",
        ),
    },
    "end": {
        "impacts_end_it": (
            "impacts dissipate most of its final energy",
            "impacts dissipate less than half of its final energy",
        ),
    },
}
"""Clauses for findings that hold and for those that do not, by subject and key; the
first available finding is used."""


def headline(findings: Iterable[Finding]) -> str:
    """Return one sentence on the sound, its pitch and the contact from the findings of
    a run.

    Undecided findings and subjects without a finding are omitted; the sentence is empty
    if none remains.
    """
    by_key = {finding.key: finding for finding in findings}
    clauses = []
    carried = by_key.get("carried_by_air")
    lost_to_air = carried is not None and carried.holds and carried.cause == "film"
    if lost_to_air:  # and not to vibrations
        by_key.pop("contact_kept", None)
    for words in HEADLINE_CLAUSES.values():
        key = next((key for key in words if key in by_key), None)
        if key is not None and by_key[key].holds is not None:
            yes, no = words[key]
            clauses.append(yes if by_key[key].holds else no)
    if lost_to_air:
        clauses.append("finally the air carries it")
    if not clauses:
        return ""
    *first, last = clauses
    sentence = f"{', '.join(first)}, and {last}" if first else last
    return f"{sentence[0].upper()}{sentence[1:]}."
