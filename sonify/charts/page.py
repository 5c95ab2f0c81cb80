"""The page beside a chart: problem, conclusion, tables of methods and failures, and environment, from the records."""

import os
import platform
from pathlib import Path

from sonify.charts.records import Record, nearest
from sonify.files import whole
from sonify.report.write import commit, version_of

PACKAGES = ("heyoka", "numba", "numpy", "scikit-fem", "scipy", "mujoco", "drake", "pybullet", "ngsolve")
LEAST = 1e-15
"""Errors below this are round-off, which is not told apart."""
ENVIRONMENT = "## Environment"


def write_page(name: str, title: str, module, records: list[Record], environment: list[str], path: Path):
    """Write the Markdown page of a chart, whose `module` has PROBLEM, conclusion() and perhaps tables()."""
    tables = getattr(module, "tables", methods)
    failed = [[r.case, f"{r.family}: {r.method}", r.setting, r.failure, _seconds(r)] for r in records if r.failure]
    command = f"python -m sonify chart {name.replace('_', '-')}"
    sections = [
        f"# {title}",
        module.PROBLEM.strip(),
        f"![{title}]({name}.png)",
        "## Conclusion",
        "\n".join(f"- {line}" for line in module.conclusion(records)),
        *(part for heading, rows in tables(records).items() for part in (f"## {heading}", table(rows))),
        "## Failures",
        table([["case", "method", "setting", "how", "seconds"], *failed]) if failed else "None.",
        ENVIRONMENT,
        "\n".join(f"- {line}" for line in environment),
        f"Made by `{command}`, which makes it from the runs in `{name}.csv` again where `--redraw` is added.",
    ]
    with whole(path) as temporary:
        temporary.write_text("\n\n".join(sections) + "\n", encoding="utf-8")


def table(rows: list[list]) -> str:
    """Return a Markdown table; the first row is its head."""
    head, *rest = (f"| {' | '.join(map(str, row))} |" for row in rows)
    return "\n".join([head, "|---" * len(rows[0]) + "|", *rest])


def methods(records: list[Record]) -> dict[str, list[list]]:
    """Return a table for each case: how often each method failed, and its run of the least error."""
    tables = {}
    for case in dict.fromkeys(r.case for r in records):
        here = [r for r in records if r.case == case and not r.left_out]
        tables[f"Methods, {case}"] = [["method", "failed", "least error", "setting", "seconds"]]
        for key in dict.fromkeys((r.family, r.method) for r in here):
            runs = [r for r in here if (r.family, r.method) == key]
            best, failed = nearest(runs), sum(bool(r.failure) for r in runs)
            told = [number(best.error), best.setting, _seconds(best)] if best else ["-"] * 3
            tables[f"Methods, {case}"].append([": ".join(key), f"{failed} of {len(runs)}", *told])
    return tables


def number(error: float) -> str:
    """Return an error in two digits, or as below `LEAST`."""
    return f"< {LEAST:g}" if error < LEAST else f"{error:.1e}"


def milliseconds(record: Record) -> str:
    """Return the time of a run in two digits."""
    return f"{1e3 * record.seconds:.2g} ms"


def environment() -> list[str]:
    """Return processor and system, versions, and the commit that was run, one a line."""
    packages = ", ".join(f"{package} {version_of(package)}" for package in PACKAGES)
    cores = f"{os.cpu_count()} cores, one process"
    machine = f"{_processor()}, {cores}, {platform.system()}, Python {platform.python_version()}"
    return [machine, packages, f"commit {commit('describe', '--always', '--dirty')}"]


def known_environment(path: Path) -> list[str]:
    """Return the environment that an earlier page names: the one in which its records were measured."""
    lines = path.read_text("utf-8").partition(ENVIRONMENT)[2].splitlines()
    return [line.removeprefix("- ") for line in lines if line.startswith("- ")]


def _processor():
    """Return the name of the processor where the system tells it, else its kind."""
    cpuinfo = Path("/proc/cpuinfo")
    lines = cpuinfo.read_text("utf-8").splitlines() if cpuinfo.is_file() else []
    names = [line.partition(":")[2].strip() for line in lines if line.startswith("model name")]
    return names[0] if names else platform.processor() or platform.machine()


def _seconds(record):
    return f"{record.seconds:.2g}" if record.repeats else "-"
