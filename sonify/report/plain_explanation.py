"""Explain in five sentences, for readers without a background in physics, why the disk
buzzes."""

from collections.abc import Sequence
from math import pi

from dynamics import Motion, Outcome
from sonify.claims.energy_causes import CAUSE_IN_WORDS
from sonify.claims.finding import Finding
from sonify.claims.finding_texts import PITCH_QUESTION, texts_with
from sonify.claims.surface_summary import ANSWERS

END_CLAUSES = {
    Outcome.AT_REST: "the disk is at rest",
    Outcome.SETTLED: "the disk lies flat",
    Outcome.ROLLING_ON: "the computation stops before the disk is at rest",
    Outcome.LIFTED_OFF: "the disk jumps off the table",
    Outcome.AIRBORNE: "the disk floats on the air under it",
    Outcome.LEFT_TABLE: "the disk falls off the table",
    Outcome.UPRIGHT: "the disk stands upright",
    Outcome.FELL: "the disk drops onto its face",
    Outcome.SANK: "the disk sinks onto its face",
}
"""Clause for each outcome; other outcomes are described by their own sentence."""
LOUDEST_PARTS: dict[str, str] = texts_with("loudest")
"""Description of the loudest part if a finding holds, by its key; the first one that
holds is used."""
PITCH_KEYS = tuple(ANSWERS[PITCH_QUESTION])


def plain_explanation(motion: Motion, findings: Sequence[Finding]) -> list[str]:
    """Return five sentences on the movement, the pitch, the source, the contact and the
    end.

    They contain numbers of the run and state which findings are undecided or missing.
    """
    by_key = {finding.key: finding for finding in findings}
    return [
        movement_sentence(motion.rolling),
        pitch_sentence(by_key),
        source_sentence(by_key),
        contact_sentence(by_key),
        end_sentence(motion, by_key),
    ]


def movement_sentence(motion: Motion) -> str:
    """State the number of turns of the contact in the first and in the last second, or that
    the motion begins without one."""
    end = float(motion.t[-1])
    window = min(1.0, end / 2)
    angles = motion.precession([0.0, window, end - window, end])
    first, last = (abs(float(angles[i + 1] - angles[i])) / (2 * pi) for i in (0, 2))
    span = "second" if window == 1 else f"{window:.2g} s"
    turns = [
        f"{count:.3g}" if count < 1000 else f"{count:.0f}" for count in (first, last)
    ]
    if not motion.finding_groups:
        return (
            "The disk does not roll from the start: it flies or stands on both edges of its rim, "
            "and meets the table again."
        )
    return (
        f"The disk rolls on its edge, and the point where it touches the table runs round "
        f"{turns[0]} times in the first {span} and {turns[1]} times in the last."
    )


def pitch_sentence(by_key: dict[str, Finding]) -> str:
    law = "The flatter a rolling disk lies, the faster this point has to run"
    found = next((by_key[key] for key in PITCH_KEYS if key in by_key), None)
    if found is None or found.holds is None:
        return f"{law}; whether the pitch rises was not decided in this run."
    if not found.holds:
        return f"{law}, but the pitch of this sound does not rise."
    if found.cause == "beats":
        return f"{law}; the sound beats with it, faster and faster."
    tone = by_key.get("tone_is_precession")
    if found.cause != "band" and tone is not None and tone.holds:
        return f"{law}; this is the tone that you hear, and therefore its pitch rises."
    return f"{law}, and the pitch rises towards the end."


def source_sentence(by_key: dict[str, Finding]) -> str:
    decided = [
        key for key in LOUDEST_PARTS if key in by_key and by_key[key].holds is not None
    ]
    sounding = next((key for key in decided if by_key[key].holds), None)
    if sounding is not None:
        return f"What you hear most is this: {LOUDEST_PARTS[sounding]}."
    if "modes_carry_the_end" in decided:
        return (
            "What you hear most is the disk as a whole, which pushes the air as it rocks; it rings "
            "less loudly."
        )
    moving = by_key.get("heard_through_film")
    if moving is not None and moving.holds is False:
        return "The air under the disk makes its movement too faint to hear."
    return "Which part is loudest was not decided in this run."


def contact_sentence(by_key: dict[str, Finding]) -> str:
    rattles = by_key.get("disk_rattles")
    if rattles is not None and rattles.holds:
        knocks = rattles.details["impacts_per_second"]
        return (
            f"The disk flies from crest to crest of the uneven table, and every landing is a small "
            f"knock, {knocks:.0f} a second."
        )
    carried = by_key.get("carried_by_air")
    lost = by_key.get("contact_is_lost")
    kept = by_key.get("contact_kept")
    floats = carried is not None and carried.holds and carried.cause == "film"
    if lost is not None and lost.holds is not None:
        leaves = lost.holds
    elif floats:
        leaves = False
    elif kept is not None and kept.holds is not None:
        leaves = not kept.holds
    else:
        return "Whether the disk leaves the table was not decided in this run."
    if leaves:
        return (
            "The disk leaves the table for brief moments, and every landing is a small "
            "knock."
        )
    if floats:
        return "The disk rolls on the table until the air under it carries its weight."
    return "The disk never leaves the table: the sound comes from a rolling edge, not from knocks."


def end_sentence(motion: Motion, by_key: dict[str, Finding]) -> str:
    end = motion.outcome if motion.landing else motion.rolling_outcome
    clause = END_CLAUSES.get(end, end.sentence)
    time = f"after {float(motion.t[-1]):.3g} s {clause}"
    found = by_key.get("what_ends")
    if found is None or found.cause not in CAUSE_IN_WORDS:
        return f"{time[0].upper()}{time[1:]}."
    cause = CAUSE_IN_WORDS[found.cause]
    share = f"{100 * found.value:.0f} % of the last tenth of the energy"
    return f"{cause[0].upper()}{cause[1:]} takes {share}, and {time}."
