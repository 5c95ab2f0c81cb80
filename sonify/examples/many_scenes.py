"""
A loop over scenes
==================

Print the duration and the peak pressure for three arms of rolling friction.
"""

from typing import Any

from sonify import load_scene, solve, summary


def main() -> list[dict[str, Any]]:
    """Solve each arm at accuracy "draft", print one line for each, and return the
    rows."""
    scene = load_scene("published").replace(
        "release.inclination_deg=3", "release.omega=[0.0, 1.3, 7.4]"
    )
    rows = []
    for arm in (3e-4, 5e-4, 1e-3):
        row = summary(
            solve(scene.replace(f"friction.arm_rolling={arm}"), accuracy="draft")
        )
        print(
            f"arm {arm:.0e} m: {row['t_end']:6.2f} s, {row['peak_pascal']:.4f} Pa, {row['outcome']}"
        )
        rows.append(row)
    return rows


if __name__ == "__main__":
    main()
