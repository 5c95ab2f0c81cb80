"""Measure the CPU seconds, the time and the folder of `sonify run`, and check them.

Run as `python -m benchmarks.speed.run_seconds [--before FOLDER] [--runs N] [--check]`.

Without `--check`, the medians of N runs are written to run_seconds.json and to the table
in docs/speed_and_accuracy.md. `--before` names the checkout of another version, such as a
Git worktree; both versions are measured in turns, so that the load of the machine affects
them equally. A checkout that contains a virtual environment `.venv` runs in it. With
`--check`, the second run of the first scene is compared with the stated one; the exit
status is 1 if it takes more than 1.5 times the CPU seconds. The unit of the comparison is
a calibration loop of the same process, so that the machine does not matter.

CPU seconds are user plus system time of all processes. Before a second run, the caches are
filled by a first one; "empty caches" is the state after the installation, with the byte
code of the libraries but no compiled functions and no fonts."""

import json
import os
import subprocess
import sys
from argparse import ArgumentParser
from pathlib import Path
from shutil import copytree, ignore_patterns
from statistics import median
from tempfile import TemporaryDirectory
from time import perf_counter, process_time
from typing import NamedTuple

import numpy as np
import psutil
import soundfile

ROOT = Path(__file__).parents[2]
RECORD = Path(__file__).with_suffix(".json")
PAGE = ROOT / "docs" / "speed_and_accuracy.md"
TABLE_MARKS = (
    "<!-- table of run seconds -->\n",
    "<!-- end of table of run seconds -->\n",
)
PACKAGES = ("dynamics", "modal", "sonify")
CACHE_VARIABLES = ("NUMBA_CACHE_DIR", "MPLCONFIGDIR", "XDG_CACHE_HOME")
SCENES = ("published", "coin", "toy", "glass-plate", "wood-table", "granite")
MAX_RATIO = 1.5
"""Largest ratio of the CPU seconds to the stated ones, both in calibration loops."""


class Usage(NamedTuple):
    """CPU seconds of a command and its children, elapsed seconds, and its output."""

    cpu: float
    wall: float
    output: str


def interpreter(source: Path) -> str:
    """Return the Python of the environment in a checkout, or else of this process."""
    own = source / ".venv" / ("Scripts" if os.name == "nt" else "bin") / "python"
    return str(own) if own.exists() else sys.executable


def usage(
    arguments: list[str], source: Path, python: str | None = None, **variables: str
) -> Usage:
    """Run Python with the arguments on the sources in a folder; it stores byte code.

    `python` is the `interpreter` of the folder by default."""
    environment = os.environ | {"PYTHONPATH": str(source), "OPENBLAS_NUM_THREADS": "1"}
    environment.pop("PYTHONDONTWRITEBYTECODE", None)
    before = sum(os.times()[2:4])
    began = perf_counter()
    done = subprocess.run(
        [python or interpreter(source), *arguments],
        env=environment | variables,
        cwd=source,
        capture_output=True,
        text=True,
        check=True,
    )
    wall = perf_counter() - began
    return Usage(sum(os.times()[2:4]) - before, wall, done.stdout)


def calibration_seconds() -> float:
    """Return the CPU seconds of a fixed loop: half interpreter, half NumPy."""
    began = process_time()
    total = 0
    for i in range(4_000_000):
        total += i % 7
    samples = np.random.default_rng(1).normal(size=1 << 16)
    for _ in range(250):
        samples = np.abs(np.fft.irfft(np.fft.rfft(samples))) + 1.0
    return process_time() - began


def second_run(source: Path, scene: str, folder: str) -> Usage:
    """Run a scene in a new process with the caches of this machine."""
    return usage(["-m", "sonify", "run", scene, "--out", f"{folder}/{scene}"], source)


def run_from_empty_caches(source: Path, folder: str) -> Usage:
    """Run the first scene as after the installation."""
    copy = Path(folder) / "source"
    ignored = ignore_patterns("__pycache__", "node_modules")
    for package in PACKAGES:
        copytree(source / package, copy / package, ignore=ignored)
    caches = {name: f"{folder}/{name}" for name in CACHE_VARIABLES}
    arguments = ["-m", "sonify", "run", "--out", f"{folder}/out"]
    return usage(arguments, copy, interpreter(source), **caches)


def listening(source: Path, folder: str) -> Usage:
    """Analyse the last 5 s of the sound of the first scene."""
    file = Path(folder) / "five_seconds.wav"
    samples, rate = soundfile.read(f"{folder}/{SCENES[0]}/sound.wav")
    soundfile.write(file, samples[-5 * rate :], rate)
    return usage(["-m", "sonify", "listen", str(file), "--out", folder], source)


def megabytes(folder: Path) -> float:
    """Return the size of all files in a folder [MB]."""
    return (
        sum(file.stat().st_size for file in folder.rglob("*") if file.is_file()) / 1e6
    )


def measured(
    sources: dict[str, Path], scenes: tuple[str, ...], runs: int
) -> tuple[dict, float]:
    """Return the medians of each version by row of the table, and that of the calibration loops,
    which run in turns with them."""
    rows: dict[str, dict[str, dict[str, float]]] = {}
    loops = []

    def add(row, version, found):
        row = rows.setdefault(row, {}).setdefault(version, {})
        for name, value in found.items():
            row.setdefault(name, []).append(value)

    for turn in range(runs + 1):  # the first turn fills the caches
        for version, source in sources.items():
            with TemporaryDirectory() as folder:
                found = {scene: second_run(source, scene, folder) for scene in scenes}
                sizes = {scene: megabytes(Path(folder) / scene) for scene in scenes}
                found["listen, 5 s"] = listening(source, folder)
            if turn == 0:
                continue
            loops.append(calibration_seconds())
            with TemporaryDirectory() as folder:
                found["published, empty caches"] = run_from_empty_caches(source, folder)
            for row, (cpu, wall, _) in found.items():
                add(row, version, {"cpu": cpu, "wall": wall})
            for scene, size in sizes.items():
                add(scene, version, {"megabytes": size})
            script = [str(Path(__file__).with_name("stage_seconds.py"))]
            stages = json.loads(usage(script, source).output)
            stages["pictures and other processes"] = found[SCENES[0]].cpu - sum(
                stages.values()
            )
            for stage, cpu in stages.items():
                add(f"published: {stage}", version, {"cpu": cpu})
    medians = {
        row: {
            version: {name: round(median(values), 3) for name, values in found.items()}
            for version, found in versions.items()
        }
        for row, versions in rows.items()
    }
    return medians, median(loops)


def commit_of(source: Path) -> str:
    """Return words for the commit of a checkout."""
    command = ["git", "-C", str(source), "rev-parse", "--short=8", "HEAD"]
    done = subprocess.run(command, capture_output=True, text=True, check=True)
    return f"at commit {done.stdout.strip()}"


def table(record: dict) -> str:
    """Return the Markdown table of a record, whose head names the measured commits."""
    versions = record["versions"]
    cpu_heads = [f"CPU seconds {record['commits'][v]}" for v in versions]
    head = ["run", *cpu_heads, "seconds", "folder [MB]"]
    lines = [head, ["---"] * len(head)]
    for row, found in record["rows"].items():
        own = found[versions[-1]]
        cpu = [f"{found[v]['cpu']:.2f}" for v in versions]
        rest = [
            f"{own[name]:.1f}" if name in own else "" for name in ("wall", "megabytes")
        ]
        lines.append([row, *cpu, *rest])
    return "\n".join(f"|{'|'.join(line)}|" for line in lines) + "\n"


def write_record(record: dict) -> None:
    """Write a record as JSON and as the table of the page."""
    RECORD.write_text(json.dumps(record, indent=1) + "\n", "utf-8")
    first, last = TABLE_MARKS
    text = PAGE.read_text("utf-8")
    head, _, rest = text.partition(first)
    _, _, tail = rest.partition(last)
    loads = (
        f"Medians of {record['runs']} runs, load of the machine {record['load']}.\n\n"
    )
    PAGE.write_text(f"{head}{first}{loads}{table(record)}{last}{tail}", "utf-8")


def check(runs: int) -> bool:
    """Return True if a second run takes at most MAX_RATIO times the stated CPU seconds."""
    stated = json.loads(RECORD.read_text("utf-8"))
    expected = stated["rows"][SCENES[0]][stated["versions"][-1]]["cpu"]
    with TemporaryDirectory() as folder:
        second_run(ROOT, SCENES[0], folder)  # fills the caches
        pairs = [
            (second_run(ROOT, SCENES[0], folder).cpu, calibration_seconds())
            for _ in range(runs)
        ]
    cpu, loop = (median(values) for values in zip(*pairs, strict=True))
    ratio = (cpu / loop) / (expected / stated["calibration"])
    print(
        f"{cpu:.2f} CPU seconds, {cpu / loop:.2f} calibration loops: "
        f"{ratio:.2f} of the stated number (at most {MAX_RATIO})"
    )
    return ratio <= MAX_RATIO


def main() -> int:
    """Measure and write, or check; return the exit status."""
    parser = ArgumentParser(description=__doc__)
    parser.add_argument("--before", type=Path)
    parser.add_argument("--runs", type=int, default=5)
    parser.add_argument("--scenes", nargs="+", default=SCENES)
    parser.add_argument("--check", action="store_true")
    options = parser.parse_args()
    if options.check:
        return 0 if check(options.runs) else 1
    before = {"before": options.before.resolve()} if options.before else {}
    sources = before | {"now": ROOT}
    rows, calibration = measured(sources, tuple(options.scenes), options.runs)
    load = f"{psutil.getloadavg()[0]:.1f}"
    write_record(
        {
            "versions": list(sources),
            "commits": {name: commit_of(source) for name, source in sources.items()},
            "runs": options.runs,
            "load": load,
            "calibration": round(calibration, 3),
            "rows": rows,
        }
    )
    return 0


if __name__ == "__main__":
    sys.exit(main())
