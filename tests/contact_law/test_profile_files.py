"""Claim: a file of measured heights is read with any separator and header, or refused in one line.

Source: dynamics/compliant/law/profile_files.py. Oracle: the numbers that were written.
"""

import numpy as np
import pytest

from dynamics.compliant.law.profile_files import profile_columns

LENGTH = np.arange(9) * 1e-4
HEIGHT = 1e-6 * np.sin(LENGTH / 1e-4)


@pytest.mark.parametrize("separator", [",", ";"])
@pytest.mark.parametrize(
    "header", ["", "\ufefflength,height\n", "# a\n\nx [m];z [m]\n"]
)
def test_the_written_heights_are_read(tmp_path, separator, header):
    file = tmp_path / "profile.csv"
    rows = zip(LENGTH.tolist(), HEIGHT.tolist(), strict=True)
    text = "\n".join(f"{x!r}{separator}{z!r}" for x, z in rows)
    file.write_text(header + text, "utf-8")
    assert np.array_equal(profile_columns(file), [LENGTH, HEIGHT])


@pytest.mark.parametrize(
    ("rows", "fault"),
    [
        ("length,height\n", "no numbers"),
        ("0\n1\n", "rows of length, height in metres"),
        ("0,1\n1,1\n", "at least 8 rows"),
        ("\n".join(f"{9 - k},0" for k in range(9)), "increasing lengths"),
        ("\n".join(f"{k},nan" for k in range(9)), "finite heights"),
    ],
)
def test_a_file_without_a_profile_is_one_line(tmp_path, rows, fault):
    file = tmp_path / "profile.csv"
    file.write_text(rows, "utf-8")
    with pytest.raises(ValueError, match=fault) as refused:
        profile_columns(file)
    assert str(refused.value).startswith(f"{file}: must have")
