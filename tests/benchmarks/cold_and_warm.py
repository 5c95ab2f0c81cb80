"""Time of `run published`: cold, in a process with empty caches, and warm, again in a process that has run it before.

Run as `python -m tests.benchmarks.cold_and_warm [PAIRS]`. A cold and a warm run take turns, so that what else the
machine does falls on both; printed are the medians by stage, some of which go on beside each other, and the processor
time of all threads: of a cold run with the process that draws, of a warm one without it, which then solves the modes,
too. A cold process starts as it does after `pip install -e .`: with the byte code of the libraries, which pip makes,
without that of this program, and without compiled functions, fonts, or what only the tests install, which heyoka loads
where it finds it.
"""

import json
import os
import subprocess
import sys
from pathlib import Path
from shutil import copytree, ignore_patterns
from statistics import median
from tempfile import TemporaryDirectory
from time import perf_counter, process_time

ONCE = """
import sys
from time import perf_counter
sys.modules["sympy"] = sys.modules["mpmath"] = None
began = perf_counter()
from sonify import load_scene, run
seconds = {"imports": perf_counter() - began} | run(load_scene("published"), out=OUT).seconds
import json
print(json.dumps(seconds))
"""


ROOT = Path(__file__).parents[2]
PACKAGES = ("dynamics", "modal", "sonify")
CACHES = ("NUMBA_CACHE_DIR", "MPLCONFIGDIR", "XDG_CACHE_HOME")


def cold(folder: str) -> tuple[dict, float, float]:
    """Return seconds by stage, in all, and of the processor, of a run in a process whose caches are in `folder`."""
    for package in PACKAGES:
        copytree(ROOT / package, f"{folder}/{package}", ignore=ignore_patterns("__pycache__", "node_modules"))
    environment = os.environ | {name: f"{folder}/{name}" for name in CACHES} | {"PYTHONPATH": folder}
    for name in ("PYTHONDONTWRITEBYTECODE", "PYTHONPYCACHEPREFIX"):
        environment.pop(name, None)
    code = ONCE.replace("OUT", repr(f"{folder}/out"))
    began, busy = perf_counter(), os.times()
    options = {"env": environment, "cwd": folder, "capture_output": True, "text": True, "check": True}
    done = subprocess.run([sys.executable, "-c", code], **options)
    total, spent = perf_counter() - began, os.times()
    processor = sum(spent[2:4]) - sum(busy[2:4])
    return json.loads(done.stdout.splitlines()[-1]), total, processor


def warm(folder: str) -> tuple[dict, float, float]:
    """Return the same of a run in this process."""
    from sonify import load_scene, run

    began, busy = perf_counter(), process_time()
    seconds = run(load_scene("published"), out=f"{folder}/out").seconds
    return {"imports": 0.0} | seconds, perf_counter() - began, process_time() - busy


def measured(way) -> tuple[dict, float, float]:
    """Return what `way` measures in a folder of its own."""
    with TemporaryDirectory() as folder:
        return way(folder)


def middle(runs) -> dict[str, float]:
    """Return the medians of some runs, by stage, of the whole and of the processor."""
    rows = [seconds | {"in all": total, "processor": busy} for seconds, total, busy in runs]
    return {stage: median(row[stage] for row in rows) for stage in rows[0]}


if __name__ == "__main__":
    pairs = int(sys.argv[1]) if len(sys.argv) > 1 else 3
    measured(warm)
    runs = [(measured(cold), measured(warm)) for _ in range(pairs)]
    first, again = (middle(way) for way in zip(*runs, strict=True))
    print(f"{'median of ' + str(pairs):16}{'cold [s]':>10}{'warm [s]':>10}")
    for stage in first:
        print(f"{stage:16}{first[stage]:10.2f}{again[stage]:10.2f}")
