"""Chart the errors of the contact models on smooth, rough, wavy and flexible tables, and
their processor times."""

from collections.abc import Callable
from math import inf
from statistics import median

from matplotlib.figure import Figure

from benchmarks.cases.contact_models_case import (
    CASES,
    SOLVERS,
    Errors,
    TableCase,
    errors,
)
from benchmarks.charts.chart_page import number
from benchmarks.charts.error_time_picture import DPI, family_colours, save
from benchmarks.timed_runs import Failure, Record, processor_seconds, selected_values
from dynamics.compliant.model_selection import (
    LIFT_OFF_FORCE_RMS,
    MAX_RELATIVE_CURVATURE_FOR_ROLLING,
)

PROBLEM = r"""
Which model of the contact is right on which table, and what does it cost? Table and edge have heights along the rim of
the disk, with amplitudes $a_n$ of order $n$. The disk leaves its rolling contact as the *curvature number*

$$\kappa = \frac{1}{R \beta} \sqrt{\sum_{n < n_c} (n^2 - 1)^2 \, |a_n|^2 / 2}$$

increases; the waves of orders above $n_c$ are shorter than the contact. The case of each row is the kind of its table and
the value of $\kappa$ at the start. All models have the same disk, heights and resistance to rolling, and the loss factor
of the contact is 0.1. Without friction no model has tangential forces, which `many` does not solve as springs; the
cases *with friction* show what it lacks. The models are

- `filter`: the linear response of the contact along the motion of a rigid disk,
- `full`: time steps of one contact, which is below the lowest point of the disk,
- `full, tracked`: the same with the contact at the smallest gap. The program uses these steps on wavy tables
  (`imperfection`) and for two-way coupling with flexible tables,
- `many`: time steps of springs along the whole rim.

The inclination decreases from 0.1 to 0.09 rad in about 0.24 s. The reference is `many` with 2.4 million steps per
second. The errors are those of the inclination, divided by its decrease; of the time at which 0.09 rad is reached
(`end`); of the energy lost until then; and of the amplitude spectrum of the normal force up to 5 kHz, divided by the rms
of its varying part. The motion error is the largest of the first three.
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

MAX_MOTION_ERROR = 0.02
"""Motion error up to which a model holds. It is the scatter of the duration of a
rattling disk that `rattling_end_error` predicts."""

MAX_EQUIVALENT_ERROR = 0.01
"""Motion error below which one model could replace another."""

MOTION_QUANTITIES = ("inclination", "end", "energy")
SPECTRUM = "spectrum"
NO_SOLUTION = "solution"
"""Quantity of the only record of a run without a solution."""

LONG_WAVES = "rough, long waves"
SHORT_WAVES = "rough, short waves"
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


def predicted_force_rms(case: TableCase) -> float:
    """Return the rms of the varying force by the filter, divided by the weight."""
    stretch = case.solve("filter", STEP_RATES["filter"][-1]).values
    return stretch.force_rms() / case.scene.disk.weight


def seconds_of(records: list[Record], model: str, case: str) -> list[float]:
    """Return the processor times [s] of the runs of a model, coarsest first."""
    return [
        r.seconds
        for r in records
        if (r.family, r.case) == (model, case) and r.method in (NO_SOLUTION, "end")
    ]


def draw(records: list[Record], title: str, path):
    """Draw the errors of all models by case, and their processor times."""
    figure = Figure(figsize=(17, 10.5), dpi=DPI, layout="constrained")
    panels = figure.subplots(2, 3)
    colours = family_colours(SOLVERS)
    styles = {
        model: {"color": colours[model], "marker": marker, "label": model}
        for model, marker in zip(SOLVERS, "o^sD", strict=True)
    }
    _draw_waves(panels[0, 0], records, styles)
    _draw_spectra(panels[0, 1], records, styles)
    _draw_short_waves(panels[0, 2], records, styles)
    _draw_other_tables(panels[1, 0], records, styles)
    _draw_steps(panels[1, 1], records, styles)
    _draw_seconds(panels[1, 2], records, styles)
    for axes in panels.flat:
        axes.grid(alpha=0.3)
        axes.legend(fontsize=8)
    figure.suptitle(title)
    save(figure, path)


NO_SOLUTION_HEIGHT = 1.5
"""Error at which a run without a solution is drawn."""


def _drawn(error: float) -> float:
    return min(error, NO_SOLUTION_HEIGHT)


def _draw_waves(axes, records, styles):
    """Draw the motion error against the curvature number of long and of single waves."""
    for kind, line in ((LONG_WAVES, "-"), ("wavy", ":")):
        for model, style in styles.items():
            found = cases_of(records, kind)
            axes.plot(
                [case.curvature_number for case in found],
                [_drawn(motion_error(records, model, case.name)) for case in found],
                line,
                **style | {"label": model if kind == LONG_WAVES else None},
            )
    axes.axhline(MAX_MOTION_ERROR, color="k", lw=1, ls="--")
    axes.axvline(
        MAX_RELATIVE_CURVATURE_FOR_ROLLING, color="k", lw=1, ls="--", label="limits"
    )
    axes.set(
        yscale="log",
        xlabel="curvature number",
        ylabel="motion error",
        title=f"Long waves (solid), one wave (dotted); {NO_SOLUTION_HEIGHT}: no solution",
    )


def _draw_spectra(axes, records, styles):
    """Draw the error of the spectrum against the curvature number."""
    for kind, line in ((LONG_WAVES, "-"), ("wavy", ":")):
        for model, style in styles.items():
            pairs = [
                (case.curvature_number, found[SPECTRUM].error)
                for case in cases_of(records, kind)
                if SPECTRUM in (found := finest(records, model, case.name))
            ]
            axes.plot(
                [x for x, _ in pairs],
                [y for _, y in pairs],
                line,
                **style | {"label": model if kind == LONG_WAVES else None},
            )
    axes.set(
        yscale="log",
        xlabel="curvature number",
        ylabel="error of the force spectrum",
        title="Force spectrum: long waves (solid), one wave (dotted)",
    )


def _draw_short_waves(axes, records, styles):
    """Draw the motion error against the predicted force on short waves."""
    found = cases_of(records, SHORT_WAVES)
    force = [predicted_force_rms(case) for case in found]
    for model, style in styles.items():
        values = [_drawn(motion_error(records, model, case.name)) for case in found]
        axes.plot(force, values, **style)
    axes.axhline(MAX_MOTION_ERROR, color="k", lw=1, ls="--")
    axes.axvline(LIFT_OFF_FORCE_RMS, color="k", lw=1, ls="--", label="limits")
    axes.set(
        xscale="log",
        yscale="log",
        xlabel="rms of the varying force by the filter, divided by the weight",
        ylabel="motion error",
        title="Short waves, which excite the contact resonance",
    )


def _draw_other_tables(axes, records, styles):
    """Draw the motion error on smooth and flexible tables, and with friction."""
    kinds = ("smooth", "flexible", "with friction")
    names = [case.name for kind in kinds for case in cases_of(records, kind)]
    for model, style in styles.items():
        values = [_drawn(motion_error(records, model, name)) for name in names]
        axes.plot(range(len(names)), values, ls="", ms=9, **style)
    axes.axhline(MAX_MOTION_ERROR, color="k", lw=1, ls="--")
    axes.set_xticks(range(len(names)), [name.replace(", ", ",\n") for name in names])
    axes.set(yscale="log", ylabel="motion error", title="Other tables")


def _draw_steps(axes, records, styles):
    """Draw the motion error against the processor time for all step rates."""
    for name, line in (("smooth, 0", "-"), ("rough, long waves, 0.1", ":")):
        for model, style in styles.items():
            runs = [r for r in records if (r.family, r.case) == (model, name)]
            settings = list(dict.fromkeys(r.setting for r in runs))
            error = [
                max(
                    r.error
                    for r in runs
                    if r.setting == setting and r.method in MOTION_QUANTITIES
                )
                for setting in settings
            ]
            axes.plot(
                seconds_of(records, model, name),
                error,
                line,
                **style | {"label": model if line == "-" else None},
            )
    axes.set(
        xscale="log",
        yscale="log",
        xlabel="processor time [s]",
        ylabel="motion error",
        title="All steps: smooth (solid), long waves of 0.1 (dotted)",
    )


def _draw_seconds(axes, records, styles):
    """Draw the processor time of the finest step against the curvature number."""
    for model, style in styles.items():
        pairs = [
            (case.curvature_number, seconds_of(records, model, case.name)[-1])
            for case in cases_of(records, LONG_WAVES)
        ]
        axes.plot([x for x, _ in pairs], [y for _, y in pairs], **style)
    axes.set(
        yscale="log",
        xlabel="curvature number",
        ylabel="processor time [s], smallest step",
        title="Time for 0.24 s of motion on long waves",
    )


def tables(records: list[Record]) -> dict[str, list[list]]:
    """Return the tables of the page by heading."""
    names = list(dict.fromkeys(r.case for r in records))
    motion: list[list] = [["table", *SOLVERS]]
    spectra: list[list] = [["table", *SOLVERS]]
    errors_of_all: list[list] = [["table", "model", *Errors._fields, "seconds"]]
    steps: list[list] = [["table", "model", "step rates", "seconds", "motion errors"]]
    for name in names:
        motion.append([name])
        spectra.append([name])
        for model in SOLVERS:
            found = finest(records, model, name)
            solved = SPECTRUM in found
            motion[-1].append(_motion_cell(motion_error(records, model, name)))
            spectra[-1].append(_percent(found[SPECTRUM].error) if solved else "-")
            if not solved:
                continue
            values = [number(found[quantity].error) for quantity in Errors._fields]
            seconds = f"{found['end'].seconds:.2g}"
            errors_of_all.append([name, model, *values, seconds])
            steps.append([name, model, *_steps_cells(records, model, name)])
    return {
        f"Motion error, smallest step (bold: more than {MAX_MOTION_ERROR:.0%})": motion,
        "Error of the force spectrum, smallest step": spectra,
        "All errors, smallest step": errors_of_all,
        "Step sizes": steps,
    }


def _steps_cells(records, model, name):
    """Return step rates, seconds and motion errors of all runs of a model."""
    runs = [r for r in records if (r.family, r.case) == (model, name)]
    solved = [r for r in runs if r.method == "end"]
    motion = [
        max(
            r.error
            for r in runs
            if r.setting == each.setting and r.method in MOTION_QUANTITIES
        )
        for each in solved
    ]
    return (
        ", ".join(r.setting.removesuffix(" 1/s") for r in solved),
        ", ".join(f"{r.seconds:.2g}" for r in solved),
        ", ".join(number(error) for error in motion),
    )


def _motion_cell(error: float) -> str:
    if error != error:
        return "-"
    if error == inf:
        return "**no solution**"
    return f"**{_percent(error)}**" if error > MAX_MOTION_ERROR else _percent(error)


def _percent(error: float) -> str:
    return f"{100 * error:.2g} %"


def conclusion(records: list[Record]) -> list[str]:
    """Return five sentences: where each model holds, what it costs and what it lacks."""
    return [
        _limit_of_curvature(records),
        _limit_of_force(records),
        _tracked_sentence(records),
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
        parts.append(f"`{model}` {' but '.join(bounds)}")
    return ", ".join(parts)


def _limit_of_curvature(records):
    """Return a sentence on the curvature numbers up to which one contact holds."""
    spectrum = finest(records, "full", "rough, long waves, 0.1")[SPECTRUM].error
    limits = _limits_in_words(records, LONG_WAVES, lambda case: case.curvature_number)
    return (
        f"On waves longer than the contact the motion of one contact holds within "
        f"{MAX_MOTION_ERROR:.0%} below a curvature number, {limits}; the program uses `many` "
        f"above {MAX_RELATIVE_CURVATURE_FOR_ROLLING:g}, and the force spectrum of `full` is "
        f"already wrong by {spectrum:.0%} at 0.1, because its contact stays below the lowest "
        f"point of the disk."
    )


def _limit_of_force(records):
    """Return a sentence on the forces up to which one contact holds on short waves."""
    limits = _limits_in_words(records, SHORT_WAVES, predicted_force_rms)
    return (
        f"On short waves, which excite the contact resonance, the limit is the rms of the "
        f"varying force by the filter, divided by the weight: {limits}; the program uses the "
        f"filter up to {LIFT_OFF_FORCE_RMS:g} and one contact beyond, also where `full` no "
        f'longer holds, so set `numerics.contact = "many"` there.'
    )


def _tracked_sentence(records):
    """Return a sentence on the contact at the smallest gap."""
    one_wave = finest(records, "full, tracked", "wavy, 0.25")
    waves = [case.name for case in cases_of(records, LONG_WAVES)]
    wrong = next(
        (n for n in waves if motion_error(records, "full, tracked", n) > 0.1), None
    )
    sentence = "`full, tracked` "
    if one_wave:
        sentence += (
            f"has the right force on one wave, with an error of its spectrum of "
            f"{number(one_wave[SPECTRUM].error)} at a curvature number of 0.25, "
        )
    if wrong:
        error = motion_error(records, "full, tracked", wrong)
        size = "without bound" if error == inf else f"by {error:.0%}"
        sentence += (
            f"but where the contact jumps between crests, it gains or loses the energy of "
            f"each jump, and its motion is wrong {size} on long waves of "
            f"{CASES[wrong].curvature_number:g}."
        )
    return sentence.rstrip(", ") + "." * (not wrong)


def _equivalence_sentence(records):
    """Return a sentence on `many` in place of `full` as the curvature number tends to 0."""
    name = "smooth, 0"
    error = motion_error(records, "full", name)
    cheapest = seconds_of(records, "many", name)[0]
    ratio = cheapest / seconds_of(records, "full", name)[0]
    tracked_ratio = cheapest / seconds_of(records, "full, tracked", name)[0]
    same = "reproduces" if error < MAX_EQUIVALENT_ERROR else "does not reproduce"
    decision = "replaces" if ratio <= 2 and same == "reproduces" else "does not replace"
    return (
        f"As the curvature number tends to 0, `many` {same} `full`, with a motion error of "
        f"{number(error)}, at {ratio:.2g} times its processor time ({tracked_ratio:.2g} times "
        f"that of `full, tracked`), each with its largest step, so it {decision} `full`."
    )


def _lacks_sentence(records):
    """Return a sentence on what `many` lacks, and on flexible tables."""
    parts = []
    for kind, what in (
        ("with friction", "with friction"),
        ("flexible", "on a flexible table"),
    ):
        found = cases_of(records, kind)
        if found:
            smooth = found[0].name
            parts.append(
                f"{what} {number(motion_error(records, 'full, tracked', smooth))}"
            )
    between = f" (`full, tracked` differs by {' and '.join(parts)})" * bool(parts)
    return (
        f"`many` lacks the tangential springs of `full` with their resonance, its viscous "
        f"laws of dissipation and its speed{between}, and the filter lacks the reaction of a "
        f"flexible table."
    )
