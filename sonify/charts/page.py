"""The page beside a chart: conclusion, failures and environment, all of them from the records."""

import os
import platform
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path

from sonify.charts.records import Record
from sonify.files import whole

PACKAGES = ("heyoka", "numba", "numpy", "scikit-fem", "scipy", "mujoco", "drake", "pybullet", "ngsolve")


def write_page(name: str, title: str, conclusion: list[str], records: list[Record], path: Path):
    """Write the Markdown page of a chart."""
    lines = [f"# {title}", "", f"![{title}]({name}.png)", "", "## Conclusion", ""]
    lines += [f"- {line}" for line in conclusion]
    lines += [
        "",
        "## Failures",
        "",
        *_failures([r for r in records if r.failure]),
        "",
        "## Environment",
        "",
        *(f"- {line}" for line in environment()),
    ]
    command = f"python -m sonify chart {name.replace('_', '-')}"
    lines += ["", f"Made by `{command}`; every run is a line of `{name}.csv`.", ""]
    with whole(path) as temporary:
        temporary.write_text("\n".join(lines), encoding="utf-8")


def _failures(records):
    if not records:
        return ["None."]
    head = ["| case | method | setting | how | seconds |", "|---|---|---|---|---|"]
    return head + [
        f"| {r.case} | {r.family}: {r.method} | {r.setting} | {r.failure} | {_seconds(r)} |" for r in records
    ]


def environment() -> list[str]:
    """Return processor, system and versions, one a line."""
    packages = ", ".join(f"{package} {_version(package)}" for package in PACKAGES)
    cores = f"{os.cpu_count()} cores, one process"
    return [f"{_processor()}, {cores}, {platform.system()}, Python {platform.python_version()}", packages]


def _processor():
    """Return the name of the processor where the system tells it, else its kind."""
    cpuinfo = Path("/proc/cpuinfo")
    lines = cpuinfo.read_text("utf-8").splitlines() if cpuinfo.is_file() else []
    names = [line.partition(":")[2].strip() for line in lines if line.startswith("model name")]
    return names[0] if names else platform.processor() or platform.machine()


def _seconds(record):
    return f"{record.seconds:.2g}" if record.repeats else "-"


def _version(package):
    try:
        return version(package)
    except PackageNotFoundError:
        return "not installed"
