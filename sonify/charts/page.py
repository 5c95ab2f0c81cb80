"""The page beside a chart: conclusion, failures and environment, all of them from the records."""

import os
import platform
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path

from sonify.charts.records import Record
from sonify.files import whole

PACKAGES = ("heyoka", "numba", "numpy", "scikit-fem", "scipy")


def write_page(name: str, title: str, conclusion: list[str], records: list[Record], path: Path):
    """Write the Markdown page of a chart."""
    lines = [f"# {title}", "", f"![{title}]({name}.png)", "", "## Conclusion", ""]
    lines += [f"- {line}" for line in conclusion]
    lines += ["", "## Failures", "", "| case | method | setting | how | seconds |", "|---|---|---|---|---|"]
    lines += [
        f"| {r.case} | {r.family}: {r.method} | {r.setting} | {r.failure} | {_seconds(r)} |"
        for r in records
        if r.failure
    ]
    lines += ["", "## Environment", "", *(f"- {line}" for line in environment())]
    lines += ["", f"Made by `python -m sonify chart {name}`; every run is a line of `{name}.csv`.", ""]
    with whole(path) as temporary:
        temporary.write_text("\n".join(lines), encoding="utf-8")


def environment() -> list[str]:
    """Return processor, system and versions, one a line."""
    packages = ", ".join(f"{package} {_version(package)}" for package in PACKAGES)
    cores = f"{os.cpu_count()} cores, one process"
    return [f"{platform.machine()}, {cores}, {platform.system()}, Python {platform.python_version()}", packages]


def _seconds(record):
    return f"{record.seconds:.2g}" if record.repeats else "-"


def _version(package):
    try:
        return version(package)
    except PackageNotFoundError:
        return "missing"
