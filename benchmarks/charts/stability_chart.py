"""Map the failures of methods as a parameter of each hazard approaches its limit.

All methods solve the same problem. A run fails if its method stops or its result is
useless. It is degraded if its error exceeds the `max_fine_error` of the hazard. The
setting of a record is the value of the parameter."""

from benchmarks.charts import stability_modes, stability_motion, stability_sound
from benchmarks.charts.stability_picture import (
    DEGRADED,
    FAILED,
    FINE,
    HAZARDS,
    rows,
    state,
)
from benchmarks.charts.stability_picture import draw as draw
from benchmarks.timed_runs import MAX_ERROR, Record, measured

PROBLEM = r"""
In every hazard a parameter goes to its limit, and each method solves the same small problem at every value. Motions
obey $\dot y = f(y)$ with the set-valued laws (3.2), (3.3); oscillators $\ddot q + 2 d \dot q + \omega^2 q = g$; elastic
disks $K u = \omega^2 M u$, solved by shift-invert at a shift $\sigma$. The references are closed forms, solutions in
quadruple precision, and converged solutions by another method.
"""


def run(quick: bool, watch=lambda fraction, note: None) -> list[Record]:
    """Return the records of the map; `quick` keeps the first and the last value of
    every parameter."""
    works = [*stability_motion.works(quick), *stability_modes.works(quick)]
    records = stability_sound.records() + measured(works, watch, repeats=1)
    return sorted(records, key=lambda r: list(HAZARDS).index(r.case))


def conclusion(records: list[Record]) -> list[str]:
    """Return sentences on how to read the map and on the methods that are fine at all
    parameter values."""
    shown = [r for r in records if not r.left_out]
    is_fine = {"ours": [], "other methods": []}
    for case in dict.fromkeys(r.case for r in shown):
        for (family, _), runs in rows([r for r in shown if r.case == case]).items():
            group = "ours" if family == "ours" else "other methods"
            is_fine[group].append(all(state(r) == FINE for r in runs))
    return [
        "Choose a method that is fine at the parameter values that you need. A method fails if it "
        "stops or its result "
        f"is useless (a motion wrong by {100 * MAX_ERROR:g} %, a pitch by "
        f"{stability_sound.MAX_MISTUNING:g} cents, a "
        f"frequency by {100 * stability_modes.MAX_FREQUENCY_ERROR:g} %); it is degraded if its "
        f"error exceeds the limit "
        "in the table.",
        *(
            f"Fine at all values of a parameter, {group}: {sum(fine)} of {len(fine)} rows."
            for group, fine in is_fine.items()
        ),
    ]


def tables(records: list[Record]) -> dict[str, list[list]]:
    """Return one table per hazard with the parameter values at which each method is
    degraded or fails."""
    found = {}
    for case, hazard in HAZARDS.items():
        runs_by_method = rows([r for r in records if r.case == case and not r.left_out])
        lines = [
            ["method", f"degraded (error above {hazard.max_fine_error:g})", "failed"]
        ]
        for (family, method), runs in runs_by_method.items():
            lines.append(
                [
                    f"{family}: {method}",
                    _values_in_state(runs, DEGRADED),
                    _values_in_state(runs, FAILED),
                ]
            )
        if runs_by_method:
            found[f"{hazard.title}: {hazard.label}"] = lines
    return found


def _values_in_state(runs, wanted):
    """Return a text with the parameter values, in order, at which a method is in the
    state `wanted`."""
    values = [r.setting for r in runs if state(r) == wanted]
    if values and len(values) == len(runs):
        return "everywhere"
    if len(values) > 1 and values == [r.setting for r in runs][-len(values) :]:
        return f"from {values[0]} on"
    return ", ".join(values) or "-"
