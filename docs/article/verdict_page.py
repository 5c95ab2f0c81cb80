"""Write the verdicts into docs/verdict.md from the tables of the sweeps:
`python docs/article/verdict_page.py`.

The page has the generated parts between comments, so that it is complete wherever Markdown
is displayed:

<!-- verdicts: table -->
The verdict on each claim and surface.
<!-- end of verdicts -->
"""

import re
from collections import Counter
from typing import NamedTuple

import pyarrow as pa
from article_numbers import ROOT, with_powers

from sonify.runtime.markdown import markdown_table
from sonify.sweeps.store import read_table
from sonify.sweeps.sweep import (
    SHIPPED_SWEEPS_FOLDER,
    Sweep,
    load_sweep,
    shipped_sweeps,
)
from sonify.sweeps.thresholds import ClaimVerdict
from sonify.sweeps.verdict import (
    PAPER_CLAIM_NUMBERS,
    claim_head,
    verdict_conclusion,
    verdict_in_words,
    verdicts_of_sweep,
)

VERDICT_PAGE = ROOT / "docs" / "verdict.md"
SHOWN_SWEEPS = ROOT / "outputs" / "shown" / "sweeps"
VERDICT_PREFIX = "verdict-"
GENERATED_PART = re.compile(
    r"^(<!-- verdicts: (\w+) -->\n)(.*?)^(<!-- end of verdicts -->)$",
    re.DOTALL | re.MULTILINE,
)


class ShownSweep(NamedTuple):
    """A verdict sweep with its table and its verdicts."""

    sweep: Sweep
    rows: pa.Table
    verdicts: dict[str, ClaimVerdict]

    @property
    def subject(self) -> str:
        """Disk and surface, from the first line of the sweep file."""
        path = SHIPPED_SWEEPS_FOLDER / f"{self.sweep.name}.toml"
        first = path.read_text("utf-8").partition("\n")[0]
        words = first.removeprefix("# Claims of the paper on ").partition(":")[0]
        return words.replace("its disk", "the paper's disk")


def shown_sweeps() -> list[ShownSweep]:
    """Return the verdict sweeps whose tables are shown."""
    found = []
    for name in shipped_sweeps():
        path = SHOWN_SWEEPS / name / "runs.parquet"
        if name.startswith(VERDICT_PREFIX) and path.is_file():
            sweep = load_sweep(name)
            rows, _ = read_table(path)
            found.append(ShownSweep(sweep, rows, verdicts_of_sweep(rows, sweep)))
    return found


def verdict_table(shown: list[ShownSweep]) -> str:
    """Return the Markdown table of the verdicts on all surfaces, with a column for each claim
    that at least one of them judges."""
    keys = [
        key for key in PAPER_CLAIM_NUMBERS if any(key in one.verdicts for one in shown)
    ]
    heads = [claim_head(key) for key in keys]
    rows = [["disk and surface", *heads]]
    for one in shown:
        cells = [
            with_powers(verdict_in_words(one.verdicts[key], one.sweep))
            if key in one.verdicts
            else "-"
            for key in keys
        ]
        rows.append([one.subject, *cells])
    return markdown_table(rows) + "\n"


def folded_sentences(shown: list[ShownSweep]) -> str:
    """Return the sentences of each sweep, folded below its name."""
    parts = []
    for one in shown:
        items = "\n".join(
            f"* {with_powers(sentence)}"
            for sentence in (*verdict_conclusion(one.rows, one.sweep), versions(one))
        )
        name = f"<code>{one.sweep.name}</code>"
        head = f"<summary>{name}: {one.subject}</summary>"
        parts.append(f"<details>\n{head}\n\n{items}\n\n</details>\n")
    return "\n".join(parts)


def versions(one: ShownSweep) -> str:
    """Return a sentence with the number of draws by version of the program."""
    counts = Counter(one.rows["version"].to_pylist()).most_common()
    words = ", ".join(f"{count} by version {version}" for version, count in counts)
    return f"The rows of the table were computed as follows: {words}."


PART_GENERATORS = {"table": verdict_table, "sentences": folded_sentences}
"""Functions that write the generated parts of the page, by name."""


def with_verdicts(text: str) -> str:
    """Return the text of the page with its generated parts from the tables."""
    shown = shown_sweeps()

    def made(match: re.Match) -> str:
        begin, name, _, end = match.groups()
        return begin + PART_GENERATORS[name](shown) + end

    return GENERATED_PART.sub(made, text)


def main() -> None:
    """Write the page."""
    VERDICT_PAGE.write_text(with_verdicts(VERDICT_PAGE.read_text("utf-8")), "utf-8")


if __name__ == "__main__":
    main()
