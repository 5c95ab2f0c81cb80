"""Tables in Markdown."""

from collections.abc import Iterable


def markdown_table(rows: Iterable[Iterable[object]]) -> str:
    """Return a table in Markdown whose first row is the head.

    Examples
    --------
    >>> print(markdown_table([["n", "is even"], [1, "no"], [2, "yes"]]))
    | n | is even |
    |---|---|
    | 1 | no |
    | 2 | yes |
    """
    head, *others = ([str(cell).replace("|", "\\|") for cell in row] for row in rows)
    lines = [f"| {' | '.join(row)} |" for row in (head, *others)]
    lines.insert(1, "|---" * len(head) + "|")
    return "\n".join(lines)
