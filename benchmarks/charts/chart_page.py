"""Write the Markdown page of a chart from its records: problem, conclusion, tables,
failures, environment."""

import os
import platform
from pathlib import Path

from benchmarks.timed_runs import Record, most_accurate
from sonify.report.write import run_git, version_of
from sonify.runtime.files import write_text
from sonify.runtime.markdown import markdown_table

PACKAGES = (
    "heyoka",
    "numba",
    "numpy",
    "scikit-fem",
    "scipy",
    "mujoco",
    "drake",
    "pybullet",
    "ngsolve",
)
ROUND_OFF = 1e-15
"""Bound stated on the page for smaller errors, which are round-off."""
ENVIRONMENT_HEADING = "## Environment"


def write_page(
    name: str,
    title: str,
    module,
    records: list[Record],
    environment: list[str],
    path: Path,
):
    """Write the page of the chart whose `module` defines PROBLEM, conclusion(records)
    and perhaps tables(records)."""
    tables = getattr(module, "tables", methods)
    failed = [
        [r.case, f"{r.family}: {r.method}", r.setting, r.failure, _seconds(r)]
        for r in records
        if r.failure
    ]
    command = f"python -m sonify chart {name.replace('_', '-')}"
    sections = [
        f"# {title}",
        module.PROBLEM.strip(),
        f"![{title}]({name}.png)",
        "## Conclusion",
        "\n".join(f"- {line}" for line in module.conclusion(records)),
        *(
            part
            for heading, rows in tables(records).items()
            for part in (f"## {heading}", markdown_table(rows))
        ),
        "## Failures",
        markdown_table([["case", "method", "setting", "how", "seconds"], *failed])
        if failed
        else "None.",
        ENVIRONMENT_HEADING,
        "\n".join(f"- {line}" for line in environment),
        f"Made by `{command}` in a checkout; with `--redraw` it makes picture and page from "
        f"`{name}.csv` again.",
    ]
    write_text("\n\n".join(sections) + "\n", path)


def methods(records: list[Record]) -> dict[str, list[list]]:
    """Return one table per case by heading, with failures and the run of the smallest
    error of each method."""
    tables = {}
    for case in dict.fromkeys(r.case for r in records):
        case_records = [r for r in records if r.case == case and not r.left_out]
        rows = [["method", "failed", "smallest error", "setting", "seconds"]]
        for key in dict.fromkeys((r.family, r.method) for r in case_records):
            runs = [r for r in case_records if (r.family, r.method) == key]
            failures = sum(bool(r.failure) for r in runs)
            best = most_accurate(runs)
            best_columns = (
                [number(best.error), best.setting, _seconds(best)]
                if best
                else ["-"] * 3
            )
            rows.append([": ".join(key), f"{failures} of {len(runs)}", *best_columns])
        tables[f"Methods, {case}"] = rows
    return tables


def number(error: float) -> str:
    """Return an error with two digits, or the bound ROUND_OFF if it is smaller."""
    return f"< {ROUND_OFF:g}" if error < ROUND_OFF else f"{error:.1e}"


def milliseconds(record: Record) -> str:
    """Return the time of a run in milliseconds, with two digits."""
    return f"{1e3 * record.seconds:.2g} ms"


def environment() -> list[str]:
    """Return three lines: processor and system, versions of the packages, commit."""
    packages = ", ".join(f"{package} {version_of(package)}" for package in PACKAGES)
    cores = f"{os.cpu_count()} cores, one process"
    machine = f"{_processor()}, {cores}, {platform.system()}, Python {platform.python_version()}"
    return [machine, packages, f"commit {run_git('describe', '--always', '--dirty')}"]


def known_environment(path: Path) -> list[str]:
    """Return the environment stated on an existing page, in which its records were
    measured."""
    lines = path.read_text("utf-8").partition(ENVIRONMENT_HEADING)[2].splitlines()
    return [line.removeprefix("- ") for line in lines if line.startswith("- ")]


def _processor():
    """Return the model name of the processor if the system reports it, else the
    architecture."""
    cpuinfo = Path("/proc/cpuinfo")
    lines = cpuinfo.read_text("utf-8").splitlines() if cpuinfo.is_file() else []
    names = [
        line.partition(":")[2].strip()
        for line in lines
        if line.startswith("model name")
    ]
    return names[0] if names else platform.processor() or platform.machine()


def _seconds(record):
    return f"{record.seconds:.2g}" if record.repeats else "-"
