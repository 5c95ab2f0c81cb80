"""Summarise in one sentence what a run shows about the paper's conjecture."""

from collections.abc import Iterable

from sonify.claims.finding import Finding
from sonify.claims.finding_texts import HeadlineClauses, texts_by_question

HEADLINE_CLAUSES: dict[str, dict[str, HeadlineClauses]] = texts_by_question("headline")
"""Clauses for findings that hold and for those that do not, by question and key; the
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
