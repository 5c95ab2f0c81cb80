"""The four claims of the paper in five cases: a table and one sentence from the findings."""

from collections.abc import Callable, Mapping
from math import isclose
from typing import NamedTuple

from sonify.claims.finding import Verdict
from sonify.claims.phrases import PART_WORDS, percentage

NO_DETAILS: Mapping[str, float] = {}


class Answer(NamedTuple):
    """Verdict, value and details of a finding."""

    verdict: Verdict
    value: float
    details: Mapping[str, float] = NO_DETAILS


Answers = Mapping[str, Answer]
"""Answers of one run by the key of the finding."""


class Case(NamedTuple):
    """A column of the table: what lies on what, and the scene with changed values."""

    words: str
    scene: str
    values: tuple[str, ...] = ()


class Claim(NamedTuple):
    """A row of the table: the claim, and the number of each finding on it in words.

    The claim holds if one of its findings holds."""

    words: str
    numbers: Mapping[str, Callable[[Answer], str]]


CASES = {
    "published": Case("the paper's disk on a rigid table in a vacuum", "published"),
    "toy": Case("the toy on its mirror", "toy"),
    "granite": Case("the toy on stone", "granite"),
    "coin": Case("a coin on stone", "coin"),
    "wood-table-in-air": Case(
        "the paper's disk on a wooden table", "wood-table", ("air.film=acts",)
    ),
}
"""Cases by name; all but the first are in air."""


def vibration_number(found: Answer) -> str:
    """Return the number that decides whether vibrations break the contact, in words."""
    if "force_rms" in found.details:
        return f"the force varies by {percentage(found.value)} of the weight"
    if "open_by_vibration" in found.details:
        return f"open for {percentage(found.value)} of the time"
    if "open_share" in found.details:
        return f"they cause {percentage(found.value)} of the time without contact"
    return f"{found.value:.0f} losses of contact"


def pitch_number(found: Answer) -> str:
    """Return the factor by which the pitch rises and the part of the sound that rises by it."""
    factor = f"{found.value:.2g}-fold"
    numbers = found.details
    for part, words in PART_WORDS.items():
        first, last = numbers.get(f"{part}_from"), numbers.get(f"{part}_to")
        if first and last and isclose(last / first, found.value):
            return f"{words.removeprefix('the ')} {factor}"
    return factor


CONTACT_CLAIM = Claim(
    "vibrations break the contact",
    {
        "vibration_opens_contact": vibration_number,
        "table_breaks_contact": vibration_number,
    },
)
NUMBER_WORDS = ("none", "one", "two", "three", "four", "five")
OPPOSITE_VERDICT: dict[Verdict, Verdict] = {
    "yes": "no",
    "no": "yes",
    "undecided": "undecided",
}
CLAIMS = (
    Claim(
        "vibrations make the sound",
        {
            "vibrations_make_sound": lambda found: (
                f"{found.details['louder']:+.0f} dB(A)"
            )
        },
    ),
    Claim(
        "the pitch rises with the frequency of the contact force",
        {"pitch_rises": pitch_number},
    ),
    CONTACT_CLAIM,
    Claim(
        "an impact stops the disk",
        {"one_impact_ends_it": lambda found: f"{found.value:.0%} of the energy"},
    ),
)


def claim_table(answers: Mapping[str, Answers]) -> str:
    """Return a Markdown table, one row per claim and one column per case, from the answers of
    each case."""
    rows = [
        ["the paper's claim", *(CASES[name].words for name in answers)],
        ["---"] * (1 + len(answers)),
        *(
            [claim.words, *(cell(claim, own) for own in answers.values())]
            for claim in CLAIMS
        ),
    ]
    return "\n".join(f"|{'|'.join(row)}|" for row in rows)


def cell(claim: Claim, answers: Answers) -> str:
    """Return the verdict on a claim in one case and the number that decides it."""
    found = deciding_answer(claim, answers)
    return "not evaluated" if found is None else ", ".join(found)


def deciding_answer(claim: Claim, answers: Answers) -> tuple[Verdict, str] | None:
    """Return the verdict on a claim in one case and its number in words, or None.

    On a rigid contact no vibration is judged; it is kept if the normal force stays positive."""
    key = deciding_key(claim, answers)
    if key is not None:
        return answers[key].verdict, claim.numbers[key](answers[key])
    if claim is CONTACT_CLAIM and "contact_kept" in answers:
        kept = answers["contact_kept"]
        number = f"least force {kept.value:.1f} of the weight"
        return OPPOSITE_VERDICT[kept.verdict], number
    return None


def deciding_key(claim: Claim, answers: Answers) -> str | None:
    """Return the finding that decides a claim: one that holds, else one that is undecided, else
    the first; None if there is none."""
    found = [key for key in claim.numbers if key in answers]
    for verdict in ("yes", "undecided"):
        for key in found:
            if answers[key].verdict == verdict:
                return key
    return found[0] if found else None


def claim_sentence(answers: Mapping[str, Answers]) -> str:
    """Return one sentence with the number of cases in which each claim holds."""
    parts = [f"{claim.words} in {_cases_in_words(claim, answers)}" for claim in CLAIMS]
    text = f"{', '.join(parts[:-1])}, and {parts[-1]}."
    return f"In the {NUMBER_WORDS[len(answers)]} cases below, {text}"


def _cases_in_words(claim: Claim, answers: Mapping[str, Answers]) -> str:
    """Return the number of cases in which a claim holds, in words, with a single exception."""
    found = {name: deciding_answer(claim, own) for name, own in answers.items()}
    verdicts = {name: answer[0] if answer else "" for name, answer in found.items()}
    others = [name for name, verdict in verdicts.items() if verdict != "yes"]
    if not others:
        return "all"
    undecided = list(verdicts.values()).count("undecided")
    if len(others) == 1:
        exception = "undecided for" if undecided else "not for"
        return (
            f"{NUMBER_WORDS[len(answers) - 1]} ({exception} {CASES[others[0]].words})"
        )
    count = NUMBER_WORDS[len(answers) - len(others)]
    return f"{count} ({NUMBER_WORDS[undecided]} undecided)" if undecided else count
