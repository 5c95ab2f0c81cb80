"""FINDINGS -> ANSWER: what is heard on each surface, whether it rises, whether contact is lost, what makes the halt."""

import re
from collections.abc import Iterable, Mapping

from sonify.claims.air import LOST_TO_AIR
from sonify.claims.motion import Finding

SURFACES = {
    "published": "rigid",
    "granite": "granite slab, rough",
    "glass-plate": "glass plate, 300 mm across, 6 mm",
    "wood-table": "wooden table on four feet",
    "light-plate": "light plate, glass of 3 mm, acting back",
}
"""Scene -> what its disk stands on."""
OF_THE_LAST = "{:.0%} of the last tenth of the energy"
CELLS = {
    "what is heard": {
        "table_is_louder": (
            "the table, {:+.0f} dB(A) against the disk",
            "the disk, the table {:+.0f} dB(A) against it",
        ),
        "carrier_is_contact": ("the contact's resonance, {:.2f} of the expected one", "no resonance of the contact"),
        "modes_carry_the_end": (
            "the modes of the disk, {:+.0f} dB(A) against its motion in the last second",
            "the motion of the disk, its modes {:+.0f} dB(A) against it in the last second",
        ),
    },
    "does its pitch rise": {
        "table_tone_rises": ("yes", "no"),  # by how much hangs on the last milliseconds, which are chaotic
        "carrier_rises": ("yes, {:.1f} times", "no, {:.1f} times"),
        "pitch_rises": ("yes, {:.1f} times", "no, {:.1f} times"),
    },
    "is contact lost": {
        "table_breaks_contact": ("yes", "no"),
        "contact_is_lost": ("yes, {:.1%} of the time", "no, {:.1%} of the time"),
        "contact_kept": ("no, the least force is {:.1f} of the weight", "yes"),
    },
    "what makes the halt": {
        "halt_comes_earlier": (
            "the table, {:.1f} s earlier than if it did not act back",
            "what makes it on a table that does not act back, {:.1f} s later",
        ),
        "table_takes_little": (
            "as on a rigid table",
            "the table, not solved: from {:.1f} s before the end on it would hold as much energy as the disk",
        ),
        "what_ends": (f"{{cause}}: {OF_THE_LAST}", f"several causes, most of it {{cause}}: {OF_THE_LAST}"),
    },
}
"""Question -> key of a finding, the first that a run has -> answer where its claim holds, and where not; a yes or no
that is near its bar is uncertain."""
CAUSE = "What ends the motion is "
LOST, CARRIED = "is contact lost", "carried_by_air"


def answers(findings: Iterable[Finding]) -> dict[str, str]:
    """Return the answer to each question from the findings of a run. Raises LookupError where none of them answers."""
    told = in_short(findings)
    for question in CELLS.keys() - told.keys():
        raise LookupError(f"none of the findings {', '.join(CELLS[question])}")
    return told


def in_short(findings: Iterable[Finding]) -> dict[str, str]:
    """Return the answer to each question that findings of this run do answer; a disk that the air carries has lost its
    contact at the end, whatever vibrations do."""
    by_key = {finding.key: finding for finding in findings}
    told = {question: _told(by_key, cells) for question, cells in CELLS.items() if by_key.keys() & cells}
    if LOST in told and CARRIED in by_key and by_key[CARRIED].holds and by_key[CARRIED].claim == LOST_TO_AIR:
        told[LOST] += ", to the air" if told[LOST] == "yes" else "; at last the air carries the disk"
    return told


def _told(by_key, cells):
    key = next(key for key in cells if key in by_key)
    finding = by_key[key]
    words = cells[key][0 if finding.holds else 1]
    words = re.sub("^(yes|no)", "uncertain", words) if finding.near else words
    return words.format(finding.value, cause=finding.claim.removeprefix(CAUSE))


def answer_table(runs: Mapping[str, Iterable[Finding]]) -> str:
    """Return the table of surfaces in Markdown, of the findings by the name of the scene."""
    rows = [["scene", "the disk is on", *CELLS], ["---"] * (2 + len(CELLS))]
    rows += [[f"`{name}`", SURFACES[name], *answers(findings).values()] for name, findings in runs.items()]
    return "\n".join(f"| {' | '.join(row)} |" for row in rows)
