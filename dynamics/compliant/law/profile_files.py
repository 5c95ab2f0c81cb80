"""Read CSV files with heights measured along a path."""

from math import isfinite
from pathlib import Path

import numpy as np


def profile_columns(file: Path) -> tuple[np.ndarray, np.ndarray]:
    """Return the lengths (n,) and heights (n,) [m] in a CSV file.

    Raises ValueError if they are invalid.
    """
    rows = file.read_text("utf-8-sig").replace(";", ",").splitlines()
    first = next(
        (i for i, row in enumerate(rows) if _is_number(row.split(",")[0])), len(rows)
    )
    try:
        if first == len(rows):
            raise ValueError("no numbers")
        length, height = np.loadtxt(
            rows[first:], delimiter=",", ndmin=2, usecols=(0, 1)
        ).T
    except ValueError as error:
        raise ValueError(
            f"{file}: must have rows of length, height in metres ({error})"
        ) from None
    if (
        len(length) < 8
        or not np.isfinite(height).all()
        or not (np.diff(length) > 0).all()
    ):
        raise ValueError(
            f"{file}: must have at least 8 rows with increasing lengths and finite heights"
        )
    return length, height


def _is_number(text: str) -> bool:
    """Return True if the text is a finite number."""
    try:
        return isfinite(float(text))
    except ValueError:
        return False
