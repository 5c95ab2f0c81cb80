"""Claim: a run imports neither scipy.stats nor SymPy, and both work afterwards.

Oracle: the modules of a fresh process, and the results of the functions that need them.
"""

import subprocess
import sys

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
OTHER_NAME = """
import sys
from sonify.runtime.imports import _StatsPlaceholder
sys.modules["scipy.stats"] = placeholder = _StatsPlaceholder("scipy.stats")
from scipy.stats import norm
print(norm.cdf(0.0), sys.modules["scipy.stats"] is placeholder)
"""


def printed(script):
    """Return the output of a script in a fresh process."""
    command = [sys.executable, "-c", script]
    done = subprocess.run(command, capture_output=True, text=True, check=True)
    return done.stdout.splitlines()


def test_a_run_imports_neither_and_both_work_afterwards():
    assert printed(SCRIPT) == ["[]", "[9, 40, 71, 98] True", "0.5 2"]


def test_another_name_of_scipy_stats_loads_the_real_package():
    assert printed(OTHER_NAME) == ["0.5 False"]
