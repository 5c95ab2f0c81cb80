"""Find in the records of the chart of contact models where each model holds."""

from math import inf

from benchmarks.cases.contact_models_case import CASES, TableCase
from benchmarks.timed_runs import Record

MAX_MOTION_ERROR = 0.02
"""Motion error up to which a model holds. It is the scatter of the duration of a
rattling disk that `rattling_end_error` predicts."""

MOTION_QUANTITIES = ("inclination", "end", "energy")
SPECTRUM = "spectrum"
NO_SOLUTION = "solution"
"""Quantity of the only record of a run without a solution."""

LONG_WAVES = "rough, long waves"
SHORT_WAVES = "rough, short waves"


def finest(records: list[Record], model: str, case: str) -> dict[str, Record]:
    """Return the records of the finest run of a model, by quantity; empty if there is
    none."""
    found = [r for r in records if (r.family, r.case) == (model, case)]
    last = found[-1].setting if found else ""
    return {r.method: r for r in found if r.setting == last}


def motion_error(records: list[Record], model: str, case: str) -> float:
    """Return the motion error of the finest run of a model; infinite without a
    solution, and NaN without a run."""
    run_records = finest(records, model, case)
    if not run_records:
        return float("nan")
    if NO_SOLUTION in run_records:
        return inf
    return max(run_records[quantity].error for quantity in MOTION_QUANTITIES)


def cases_of(records: list[Record], kind: str) -> list[TableCase]:
    """Return the cases of a kind of table, by increasing curvature number."""
    names = dict.fromkeys(r.case for r in records)
    found = [CASES[name] for name in names if CASES[name].kind == kind]
    return sorted(found, key=lambda case: case.curvature_number)


def last_holding(
    records: list[Record], model: str, kind: str
) -> tuple[TableCase | None, TableCase | None]:
    """Return the last case of a kind up to which a model holds, and the first one in
    which it does not; None where there is none."""
    last = None
    for case in cases_of(records, kind):
        if motion_error(records, model, case.name) > MAX_MOTION_ERROR:
            return last, case
        last = case
    return last, None


def solved_steps(
    records: list[Record], model: str, case: str
) -> list[tuple[str, float, float]]:
    """Return setting, processor time [s] and motion error of the solved runs of a
    model, coarsest first."""
    runs = [r for r in records if (r.family, r.case) == (model, case)]
    return [
        (
            solved.setting,
            solved.seconds,
            max(
                r.error
                for r in runs
                if r.setting == solved.setting and r.method in MOTION_QUANTITIES
            ),
        )
        for solved in runs
        if solved.method == "end"
    ]
