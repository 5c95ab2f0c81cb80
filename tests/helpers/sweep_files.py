"""What several files of tests on sweeps share: a sweep whose runs take a few hundredths of a
second, and its truth."""

import pyarrow as pa

from sonify.sweeps.store import read_table

QUICK = {
    "name": "quick",
    "accuracy": "draft",
    "set": [
        "release.inclination_deg=3",
        "release.omega=[0.0, 1.3, 7.4]",
        "friction.arm_nutation=0",
    ],
    "find": ["motion"],
    "axes": {
        "friction.mu_static": [0.2, 0.5],
        "friction.mu_dynamic": [0.1, 0.3],
        "friction.arm_rolling": {"from": 1e-3, "to": 3e-3, "n": 2},
    },
}
"""The disk falls within a second; where mu_static = 0.2 is below mu_dynamic = 0.3, a run is
refused. A range stands last, as it does in the file that `tomli_w` writes."""


def found(path) -> pa.Table:
    """Return what a table holds but for the times that the runs took."""
    table, _ = read_table(path)
    return table.select(
        [name for name in table.column_names if not name.startswith("seconds")]
    )
