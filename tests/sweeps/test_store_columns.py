"""Claim: a column of the table of a sweep has one type, whatever type of number its values have.

Source: the docstring of `column_array`. Oracle: the types of pyarrow.
"""

import numpy as np
import pyarrow as pa

from sonify.sweeps.store import column_array


def test_drawn_values_are_numbers_as_given_ones_are():
    """Points that are drawn have the numbers of NumPy; those of a file have Python's."""
    empty = pa.schema([])
    drawn = column_array("disk.radius", [np.float64(0.04), 0.05], empty, axis=True)
    assert (drawn.type, drawn.to_pylist()) == (pa.float64(), [0.04, 0.05])
    judged = column_array("passed", [np.bool_(True), False], empty, axis=False)
    assert judged.type == pa.bool_()
