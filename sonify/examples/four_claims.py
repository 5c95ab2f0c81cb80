"""
Four claims, five cases
=======================

Print the sentence and the table of the README from the findings of five runs."""

from collections.abc import Iterable, Mapping

from sonify import load_scene, solve
from sonify.claims.finding import Finding
from sonify.claims.four_claims import CASES, Answer, claim_sentence, claim_table


def main(
    accuracy: str = "standard", known: Mapping[str, Iterable[Finding]] | None = None
) -> str:
    """Return the sentence and the table in Markdown.

    The cases are solved one after another if their findings are not `known`."""
    runs = known or {
        name: solve(load_scene(case.scene).replace(*case.values), accuracy).findings
        for name, case in CASES.items()
    }
    answers = {
        name: {
            found.key: Answer(found.verdict, found.value, found.details)
            for found in findings
        }
        for name, findings in runs.items()
    }
    return f"{claim_sentence(answers)}\n\n{claim_table(answers)}"


if __name__ == "__main__":
    print(main())
