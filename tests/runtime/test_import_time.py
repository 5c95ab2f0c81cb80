"""Claim: a run imports neither scipy.stats nor SymPy, and both work afterwards. SciPy changes
its docstrings again afterwards. The analysis of a recording imports no model of the disk, no
finite elements and no checks of scenes.

Oracle: the modules of a fresh process, and the results of the functions that need them.
"""

import subprocess
import sys

import pytest

SCRIPT = """
import sys
from sonify.entry_points import begin_run
from sonify.runtime.imports import import_signal_without_stats
begin_run("published", None)
import_signal_without_stats()
import sonify.pipeline
print([name for name in ("scipy.stats", "sympy", "matplotlib") if name in sys.modules])
from scipy.signal import find_peaks_cwt
import numpy as np
peaks = find_peaks_cwt(np.sin(np.arange(100) / 5), [3, 5])
print(peaks.tolist(), "scipy.stats" in sys.modules)
import scipy.stats, sympy
print(scipy.stats.norm.cdf(0.0), sympy.Integer(2))
"""
DOCSTRING_SCRIPT = """
from sonify.runtime.imports import import_signal_without_stats
import_signal_without_stats()
import scipy.signal, scipy.stats
note = "Array API Standard Support"
print(note in scipy.signal.butter.__doc__, note in scipy.stats.variation.__doc__)
"""
OTHER_NAME = """
import sys
from sonify.runtime.imports import _StatsPlaceholder
sys.modules["scipy.stats"] = placeholder = _StatsPlaceholder("scipy.stats")
from scipy.stats import norm
print(norm.cdf(0.0), sys.modules["scipy.stats"] is placeholder)
"""
LISTEN_SCRIPT = """
import sys
import sonify.report.recording, sonify.report.sound
unused = ("dynamics.motion", "modal", "sonify.scene", "sonify.claims", "skfem", "pydantic", "heyoka")
print([name for name in unused if name in sys.modules])
"""


def printed(script):
    """Return the output of a script in a fresh process."""
    command = [sys.executable, "-c", script]
    done = subprocess.run(command, capture_output=True, text=True, check=True)
    return done.stdout.splitlines()


def test_a_run_imports_neither_and_both_work_afterwards():
    assert printed(SCRIPT) == ["[]", "[9, 40, 71, 98] True", "0.5 2"]


def test_only_the_docstrings_of_this_import_lack_the_notes_of_scipy():
    pytest.importorskip("scipy", "1.17", reason="older versions of SciPy differ")
    assert printed(DOCSTRING_SCRIPT) == ["False True"]


def test_another_name_of_scipy_stats_loads_the_real_package():
    assert printed(OTHER_NAME) == ["0.5 False"]


def test_listening_imports_no_model_of_the_disk():
    assert printed(LISTEN_SCRIPT) == ["[]"]
