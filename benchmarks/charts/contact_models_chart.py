"""Chart the errors of the contact models on smooth, rough, wavy and flexible tables, and
their processor times."""

from collections.abc import Callable
from math import inf, isnan
from statistics import median

from benchmarks.cases.contact_models_case import (
    CASES,
    SOLVERS,
    Errors,
    TableCase,
    errors,
    predicted_force_rms,
)
from benchmarks.charts import contact_models_picture
from benchmarks.charts.chart_page import number
from benchmarks.charts.contact_models_records import (
    LONG_WAVES,
    MAX_MOTION_ERROR,
    NO_SOLUTION,
    SHORT_WAVES,
    SPECTRUM,
    cases_of,
    finest,
    last_holding,
    motion_error,
    solved_steps,
)
from benchmarks.timed_runs import Failure, Record, processor_seconds, selected_values
from dynamics.compliant.model_selection import (
    LIFT_OFF_FORCE_RMS,
    MAX_FORCE_RMS_FOR_ONE_CONTACT,
    MAX_RELATIVE_CURVATURE_FOR_ROLLING,
)

draw = contact_models_picture.draw
PROBLEM = r"""
Which model of the contact is right on which table, and what does it cost? Table and edge have heights along the rim of
the disk, with amplitudes $a_n$ of order $n$. Their curvature, divided by that of the tilted rim, is the *curvature
number*

$$\kappa = \frac{1}{R \beta} \sqrt{\sum_{n < n_c} (n^2 - 1)^2 \, |a_n|^2 / 2},$$

where waves of orders above $n_c$ are shorter than the contact. Each case is named by the kind of its table and its
$\kappa$ at the start. All models have the same disk, the same heights and the same resistance to rolling; the loss
factor of the contact is 0.1. The contact is free of friction, since `many` has no tangential springs; the cases *with
friction* show their influence. The models are

- `filter`: the linear response of the contact along the motion of a rigid disk,
- `full`: time steps of one contact, which is below the lowest point of the disk,
- `full, tracked`: time steps of one contact at the smallest gap without these heights, which the program uses on wavy
  tables (`imperfection`) and on flexible tables with two-way coupling,
- `many`: time steps of springs along the whole rim.

The inclination decreases from 0.1 to 0.09 rad in about 0.24 s. The reference is `many` with 2.4 million steps per
second. The errors are those of the inclination, divided by its decrease; of the time at which 0.09 rad is reached
(`end`); of the energy lost until then; and of the amplitude spectrum of the normal force up to 5 kHz, divided by the
rms of its varying part. The motion error is the largest of the first three.
"""
STEP_RATES = {
    "filter": (4.8e4, 9.6e4, 1.92e5),
    "full": (2e5, 4e5, 8e5),
    "full, tracked": (2e5, 4e5, 8e5),
    "many": (3e5, 6e5, 1.2e6),
}
"""Force samples of the filter, and time steps of the other models, per second [1/s]."""

REFERENCE_RATE = 2.4e6
"""Time steps per second of the reference [1/s]."""

MAX_EQUIVALENT_ERROR = 0.01
"""Motion error below which one model could replace another."""

MAX_EQUIVALENT_TIME_RATIO = 2.0
"""Ratio of processor times up to which a model could replace a faster one."""

QUICK_CASES = ("smooth, 0", "rough, long waves, 0.1", "rough, short waves, 0.05")


def run(
    quick: bool, watch: Callable[[float, str], None] = lambda fraction, note: None
) -> list[Record]:
    """Return four records for each run, one for each of `Errors`; `quick` keeps three
    cases and the first and the last step rate."""
    records = []
    cases = [CASES[name] for name in QUICK_CASES] if quick else list(CASES.values())
    for i, case in enumerate(cases):
        watch(i / len(cases), f"{case.name}: reference")
        reference = case.solve("many", REFERENCE_RATE).values
        for model in case.models:
            for rate in selected_values(STEP_RATES[model], quick):
                watch(i / len(cases), f"{case.name}: {model}, {rate:g} 1/s")
                records += records_of(case, model, rate, reference)
    return records


def records_of(case: TableCase, model: str, rate: float, reference) -> list[Record]:
    """Return the records of a run; the first of its calls compiles and is not timed.

    A run that takes less than a quarter of a second is timed three times."""
    seconds: list[float] = []
    about = {"family": model, "setting": f"{rate:g} 1/s", "case": case.name}
    max_total_seconds = 0.75
    try:
        answer = case.solve(model, rate)
        while len(seconds) < 3 and sum(seconds) < max_total_seconds:
            begin = processor_seconds()
            case.solve(model, rate)
            seconds.append(processor_seconds() - begin)
    except Failure as failure:
        return [Record(method=NO_SOLUTION, failure=str(failure), error=inf, **about)]
    found = errors(answer.values, reference, case.scene.disk.weight)
    return [
        Record(
            method=quantity,
            error=error,
            steps=answer.steps,
            seconds=median(seconds),
            repeats=len(seconds),
            **about,
        )
        for quantity, error in zip(Errors._fields, found, strict=True)
    ]


def tables(records: list[Record]) -> dict[str, list[list]]:
    """Return the tables of the page by heading."""
    motion: list[list] = [["table", *SOLVERS]]
    spectra: list[list] = [["table", *SOLVERS]]
    all_errors: list[list] = [["table", "model", *Errors._fields]]
    steps: list[list] = [["table", "model", "step rates", "seconds", "motion errors"]]
    for name in dict.fromkeys(r.case for r in records):
        motion.append([name])
        spectra.append([name])
        for model in SOLVERS:
            found = finest(records, model, name)
            motion[-1].append(_motion_cell(motion_error(records, model, name)))
            if SPECTRUM not in found:
                spectra[-1].append("-")
                continue
            spectra[-1].append(_percent(found[SPECTRUM].error))
            values = [number(found[quantity].error) for quantity in Errors._fields]
            all_errors.append([name, model, *values])
            steps.append([name, model, *_steps_cells(records, model, name)])
    return {
        f"Motion error, smallest step (bold: more than {_percent(MAX_MOTION_ERROR)})": motion,
        "Error of the force spectrum, smallest step": spectra,
        "All errors, smallest step": all_errors,
        "Step sizes": steps,
    }


def _steps_cells(records, model, name):
    """Return step rates, seconds and motion errors of all runs of a model."""
    settings, seconds, found = zip(*solved_steps(records, model, name), strict=True)
    return (
        ", ".join(setting.removesuffix(" 1/s") for setting in settings),
        ", ".join(f"{each:.2g}" for each in seconds),
        ", ".join(number(error) for error in found),
    )


def _motion_cell(error: float) -> str:
    if isnan(error):
        return "-"
    if error == inf:
        return "**no solution**"
    return f"**{_percent(error)}**" if error > MAX_MOTION_ERROR else _percent(error)


def _percent(error: float) -> str:
    smallest = 1e-4
    if error < smallest:
        return "< 0.01 %"
    return f"{100 * error:.0f} %" if error >= 1 else f"{100 * error:.2g} %"


def conclusion(records: list[Record]) -> list[str]:
    """Return five sentences: where each model holds, what it costs and what it lacks."""
    return [
        _limit_of_curvature(records),
        _limit_of_force(records),
        _spectrum_sentence(records),
        _equivalence_sentence(records),
        _lacks_sentence(records),
    ]


def _limits_in_words(records, kind: str, quantity: Callable[[TableCase], float]) -> str:
    """Return up to which value of a quantity the filter and one contact hold."""
    parts = []
    for model in ("filter", "full"):
        last, first = last_holding(records, model, kind)
        bounds = [f"up to {quantity(last):.2g}"] if last else []
        bounds += [f"not at {quantity(first):.2g}"] if first else []
        parts.append(f"`{model}` {', '.join(bounds)}")
    return "; ".join(parts)


def _limit_of_curvature(records):
    """Return a sentence on the curvature numbers up to which one contact holds."""
    limits = _limits_in_words(records, LONG_WAVES, lambda case: case.curvature_number)
    return (
        f"On waves longer than the contact, one contact gives the motion within "
        f"{_percent(MAX_MOTION_ERROR)} at small curvature numbers ({limits}); the program changes "
        f"to `many` above {MAX_RELATIVE_CURVATURE_FOR_ROLLING:g}."
    )


def _limit_of_force(records):
    """Return a sentence on the forces up to which one contact holds on short waves."""
    limits = _limits_in_words(records, SHORT_WAVES, predicted_force_rms)
    return (
        f"On short waves, which excite the contact resonance, the limit is the rms of the "
        f"varying force by the filter, divided by the weight ({limits}); the program changes "
        f"from `filter` to `full` above {LIFT_OFF_FORCE_RMS:g} and warns above "
        f'{MAX_FORCE_RMS_FOR_ONE_CONTACT:g}, where `numerics.contact = "many"` is needed.'
    )


def _spectrum_sentence(records):
    """Return a sentence on the force spectra of one contact."""
    name = "rough, long waves, 0.1"
    lowest, tracked = (
        _percent(finest(records, model, name)[SPECTRUM].error)
        for model in ("full", "full, tracked")
    )
    return (
        f"The force spectrum of `full` is wrong by {lowest}, and that of `full, tracked` by "
        f"{tracked}, at a curvature number of 0.1: the contact does not move to the crests, "
        f"so that the harmonics are missing."
    )


def _equivalence_sentence(records):
    """Return a sentence on `many` in place of `full` as the curvature number tends to 0."""
    name = "smooth, 0"
    error = motion_error(records, "full", name)
    seconds = {model: solved_steps(records, model, name)[0][1] for model in SOLVERS}
    ratio = seconds["many"] / seconds["full"]
    tracked_ratio = seconds["many"] / seconds["full, tracked"]
    is_equal = error < MAX_EQUIVALENT_ERROR
    replaces = is_equal and ratio <= MAX_EQUIVALENT_TIME_RATIO
    return (
        f"As the curvature number tends to 0, `many` {'agrees' if is_equal else 'disagrees'} "
        f"with `full` (motion error {number(error)}), but takes {ratio:.2g} times its "
        f"processor time and {tracked_ratio:.2g} times that of `full, tracked`, each with its "
        f"largest step: it {'can' if replaces else 'cannot'} replace `full`."
    )


def _lacks_sentence(records):
    """Return a sentence on what `many` lacks, and on flexible tables."""
    sentence = (
        "`many` lacks the speed of `full`, its tangential springs with their resonance and "
        "its laws of dissipation other than a rolling moment"
    )
    friction = cases_of(records, "with friction")
    flexible = cases_of(records, "flexible")
    if not (friction and flexible):
        return sentence + "."
    uneven = friction[-1]
    differs = _percent(motion_error(records, "full", uneven.name))
    sentence += f" (with friction the motions differ by {differs} at {uneven.curvature_number:g})"
    name = flexible[0].name
    one_way = _percent(motion_error(records, "filter", name))
    two_way = _percent(motion_error(records, "full, tracked", name))
    sentence += (
        f"; on a smooth flexible table the filter is wrong by {one_way}, and `full, tracked` "
        f"agrees with `many`: the motion within {two_way}"
    )
    spectrum = _percent(finest(records, "full, tracked", name)[SPECTRUM].error)
    return f"{sentence}, the force spectrum within {spectrum}."
