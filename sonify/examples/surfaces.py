"""
Was the paper right?
====================

Print the table of the README from the findings of five scenes.
"""

from sonify import solve
from sonify.claims.surface_summary import SURFACES, answer_table


def main(accuracy: str = "standard") -> str:
    """Solve the scenes one after the other; return the table."""
    return answer_table({name: solve(name, accuracy).findings for name in SURFACES})


if __name__ == "__main__":
    print(main())
