"""Summarise in one sentence what a run shows about the paper's conjecture."""

from collections.abc import Iterable

from sonify.claims.finding import Finding
from sonify.claims.finding_texts import HeadlineClauses, texts_by_question

HEADLINE_CLAUSES: dict[str, dict[str, HeadlineClauses]] = texts_by_question("headline")
"""Clauses for findings that hold and for those that do not, by question and key; the
first available finding is used."""


VIOLATED_BALANCE = (
    "The balance of power is violated: with one-way coupling the table would take {value:.0%} of "
    "the power that the disk loses ({heat:.0%} as heat, {radiated:.0%} as sound), but the motion "
    "does not lose it."
)
"""Sentence on a run in which a table with one-way coupling takes too much power."""


def violated_balance(findings: Iterable[Finding]) -> str:
    """Return a sentence on the balance that a run violates, or "" if it violates none."""
    for found in findings:
        if found.key == "disk_supplies_table" and found.verdict == "no":
            return VIOLATED_BALANCE.format(value=found.value, **found.details)
    return ""


def headline(findings: Iterable[Finding]) -> str:
    """Return one sentence on the sound, its pitch and the contact from the findings of
    a run.

    Undecided findings and subjects without a finding are omitted; the sentence is empty
    if none remains. It follows a sentence on a violated balance, if there is one.
    """
    findings = list(findings)
    sentences = violated_balance(findings), answered_in_one_sentence(findings)
    return " ".join(filter(None, sentences))


def answered_in_one_sentence(findings: Iterable[Finding]) -> str:
    """Return the sentence of `headline` without that on a violated balance."""
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
        clauses.append("finally the air lifts it")
    if not clauses:
        return ""
    *first, last = clauses
    sentence = f"{', '.join(first)}, and {last}" if first else last
    return f"{sentence[0].upper()}{sentence[1:]}."
