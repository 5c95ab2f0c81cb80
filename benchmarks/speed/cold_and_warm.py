"""Time `run published` cold, in a process with empty caches, and warm, in a process
that has run it before.

Run as `python -m benchmarks.speed.cold_and_warm [PAIRS]`. Cold and warm runs alternate,
so that the load of the machine affects both. The script prints the medians by stage;
some stages run in parallel. It also prints the processor time of all threads. For a
cold run this includes the process that draws the pictures.

A cold process is in the state after `pip install -e .`: it has the byte code of the
libraries but not that of this program, no compiled functions, no fonts, and none of the
packages that only the tests install (heyoka would import sympy and mpmath)."""

import json
import os
import subprocess
import sys
from pathlib import Path
from shutil import copytree, ignore_patterns
from statistics import median
from tempfile import TemporaryDirectory
from time import perf_counter, process_time

COLD_RUN = """
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
CACHE_VARIABLES = ("NUMBA_CACHE_DIR", "MPLCONFIGDIR", "XDG_CACHE_HOME")


def cold(folder: str) -> tuple[dict, float, float]:
    """Run the scene in a new process with its caches in `folder`.

    Returns the seconds by stage, the total seconds, and the processor time [s].
    """
    for package in PACKAGES:
        copytree(
            ROOT / package,
            f"{folder}/{package}",
            ignore=ignore_patterns("__pycache__", "node_modules"),
        )
    environment = (
        os.environ
        | {name: f"{folder}/{name}" for name in CACHE_VARIABLES}
        | {"PYTHONPATH": folder}
    )
    for name in ("PYTHONDONTWRITEBYTECODE", "PYTHONPYCACHEPREFIX"):
        environment.pop(name, None)
    code = COLD_RUN.replace("OUT", repr(f"{folder}/out"))
    began = perf_counter()
    times_before = os.times()
    options = {
        "env": environment,
        "cwd": folder,
        "capture_output": True,
        "text": True,
        "check": True,
    }
    done = subprocess.run([sys.executable, "-c", code], **options)
    total = perf_counter() - began
    processor = sum(os.times()[2:4]) - sum(times_before[2:4])
    return json.loads(done.stdout.splitlines()[-1]), total, processor


def warm(folder: str) -> tuple[dict, float, float]:
    """Run the scene in this process and return the same times as `cold`."""
    from sonify import load_scene, run

    began = perf_counter()
    processor_before = process_time()
    seconds = run(load_scene("published"), out=f"{folder}/out").seconds
    return (
        {"imports": 0.0} | seconds,
        perf_counter() - began,
        process_time() - processor_before,
    )


def measured(run_in) -> tuple[dict, float, float]:
    """Return the times of `run_in` in a temporary folder."""
    with TemporaryDirectory() as folder:
        return run_in(folder)


def medians(runs) -> dict[str, float]:
    """Return the median seconds of several runs by stage, in total, and of the
    processor."""
    rows = [
        seconds | {"total": total, "processor": processor}
        for seconds, total, processor in runs
    ]
    return {stage: median(row[stage] for row in rows) for stage in rows[0]}


if __name__ == "__main__":
    pairs = int(sys.argv[1]) if len(sys.argv) > 1 else 3
    measured(warm)
    runs = [(measured(cold), measured(warm)) for _ in range(pairs)]
    cold_seconds, warm_seconds = (medians(kind) for kind in zip(*runs, strict=True))
    print(f"{'median of ' + str(pairs):16}{'cold [s]':>10}{'warm [s]':>10}")
    for stage in cold_seconds:
        print(f"{stage:16}{cold_seconds[stage]:10.2f}{warm_seconds[stage]:10.2f}")
