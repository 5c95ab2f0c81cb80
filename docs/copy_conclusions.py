"""Copy the conclusions of the sweeps into the pages that show them: `python docs/copy_conclusions.py`.

A page names the file in a comment before the copy, so that the page is complete wherever Markdown
is displayed:

<!-- copy of ../outputs/shown/sweeps/friction/conclusion.md -->
* The sentences of the file, one per item.
<!-- end of copy -->
"""

import re
from pathlib import Path

DOCS = Path(__file__).parent
COPY = re.compile(
    r"^(<!-- copy of (\S+) -->\n)(.*?)^(<!-- end of copy -->)$",
    re.DOTALL | re.MULTILINE,
)


def with_copies(text: str, folder: Path = DOCS) -> str:
    """Return the text of a page in `folder` with every copy as in its file."""

    def copied(match: re.Match) -> str:
        begin, source, _, end = match.groups()
        sentences = (folder / source).read_text("utf-8").splitlines()
        return begin + "".join(f"* {line}\n" for line in sentences) + end

    return COPY.sub(copied, text)


def main() -> None:
    """Write the pages with changed conclusions."""
    for page in sorted(DOCS.glob("*.md")):
        text = page.read_text("utf-8")
        if (new := with_copies(text)) != text:
            page.write_text(new, "utf-8")
            print(page)


if __name__ == "__main__":
    main()
