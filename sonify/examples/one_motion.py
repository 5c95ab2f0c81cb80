"""
One motion
==========

Print the end of the published motion, its number of slides, and the state one second
before the end."""

from dynamics import Motion, simulate
from sonify import load_scene


def main() -> Motion:
    """Solve the motion, print its results and return it."""
    motion = simulate(load_scene("published"))
    end = motion.t[-1]
    print(f"{motion.outcome.sentence}: at {end:.3f} s")
    print(
        f"slides: {sum(change.after.startswith('slide') for change in motion.transitions)}"
    )
    state = motion.at([end - 1.0])[0]
    force = motion.force([end - 1.0])[0]
    print(
        f"a second before: inclination {state[1]:.4f} rad, normal force {force[2]:.3f} N"
    )
    return motion


if __name__ == "__main__":
    main()
