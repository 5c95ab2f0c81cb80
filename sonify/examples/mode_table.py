"""
A table of modes
================

Print the frequencies and decay times of the free published disk.
"""

from modal import Modes, eigenmodes
from sonify import load_scene


def main() -> Modes:
    """Solve the modes, print one line for each, and return them."""
    modes = eigenmodes(load_scene("published").replace("support.kind=free"))
    print("    Hz      T60 s   waves  family")
    for frequency, ring, order, family in zip(
        modes.frequency, modes.decay_time, modes.order, modes.family, strict=True
    ):
        print(f"{frequency:8.1f} {ring:8.2f} {order:5}    {family}")
    return modes


if __name__ == "__main__":
    main()
