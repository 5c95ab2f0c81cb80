"""Claim: a misspelt name gets a question with the closest known one, and a missing package the
command that installs it.

Source: sonify/suggestions.py and sonify/extras.py. Oracle: the sentences written out.
"""

import pytest

from sonify.extras import require_extra
from sonify.scene_errors import InputError
from sonify.suggestions import did_you_mean, did_you_mean_question


@pytest.mark.parametrize(
    ("word", "question"),
    [
        ("tox", "; did you mean toy?"),
        ("GLASSPLATE", "; did you mean glass-plate?"),
        ("glass_plate", "; did you mean glass-plate?"),
        ("zzz", ""),
    ],
)
def test_the_closest_name_is_suggested(word, question):
    assert did_you_mean(word, ["toy", "glass-plate", "granite"]) == question


def test_a_question_names_all_candidates():
    assert did_you_mean_question(["a", "b"]) == "; did you mean a or b?"
    assert did_you_mean_question([]) == ""


def test_a_missing_package_is_one_line():
    require_extra("this", "numpy", "none")
    fault = r'--as uff requires pyufo; install it with: python -m pip install -e "\.\[uff\]"'
    with pytest.raises(InputError, match=fault):
        require_extra("--as uff", "pyufo", "uff")
