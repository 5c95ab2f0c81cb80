"""Was the paper right? It depends on the surface: five scenes, and what their findings say, as the README shows it."""

from sonify import solve
from sonify.claims.answers import SURFACES, answer_table


def main(accuracy: str = "standard") -> str:
    """Solve the scenes one after the other; return the table."""
    return answer_table({name: solve(name, accuracy).findings for name in SURFACES})


if __name__ == "__main__":
    print(main())
