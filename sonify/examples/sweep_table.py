"""
A sweep as a table
==================

Print the number of slips as a function of the arm of rolling friction and the static
friction coefficient."""

import pandas as pd

from sonify import sweep

SWEEP = {
    "name": "slips",
    "accuracy": "draft",
    "set": ["release.inclination_deg=3", "release.omega=[0.0, 1.3, 7.4]"],
    "find": ["repeated_slips"],
    "axes": {
        "friction.arm_rolling": {"from": 1e-3, "to": 3e-3, "n": 2},
        "friction.mu_static": [0.3, 0.5],
    },
}


def main(out: str = "outputs/sweeps/slips") -> pd.DataFrame:
    """Solve the missing runs, print a cross-table of the numbers of slips, and return
    all rows."""
    table = pd.read_parquet(sweep(SWEEP, out=out))
    print(
        table.pivot(
            index="friction.arm_rolling",
            columns="friction.mu_static",
            values="repeated_slips",
        )
    )
    return table


if __name__ == "__main__":
    main()
