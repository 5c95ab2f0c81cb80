"""Chart error against processor time of filter, full model and rigid contact for the
elastic contact."""

from functools import cache, partial
from math import degrees

from benchmarks.cases import contact_case as case
from benchmarks.cases.contact_case import explicit_euler, leap_frog
from benchmarks.cases.elastic_steady_motion import steady_state
from benchmarks.charts import error_time_picture
from benchmarks.charts.chart_page import milliseconds, number
from benchmarks.timed_runs import (
    Answer,
    Record,
    Work,
    distance_from_one,
    measured,
    most_accurate,
    selected_values,
    works_over,
)
from dynamics import simulate
from sonify.scene import load_scene

PROBLEM = r"""
A disk touches an elastic table: the normal force is $N = K(\beta)\,(-G)^{3/2}(1 - c\,\dot G)$ at a gap $G$, which
contains the heights of table and edge; the tangential springs creep. *A lossless impact* conserves the energy and has
the closed form $\delta = (5 m v^2/4K)^{2/5}$. The result of *rolling on roughness* of 0.01 um is the rms of $N$ above
200 Hz; its reference is the full model at 3.2 million steps per second. Further rows, which the picture leaves out: a
contact without loss, heights that make several contacts (rms $z'' R/\beta$), and decreasing inclination.
"""
IMPACT = "a lossless impact"
ROLLING = "rolling on roughness"
NO_LOSS = "loss factor of the contact to 0"
SEVERAL_CONTACTS = "rms(z'') R/beta beyond 1"
SMALL_INCLINATION = "inclination to 0"

FULL_METHOD = "discrete gradient"
FILTER_METHOD = "exact along the rigid motion"
RATE_SETTING = "{:g} 1/s"

REFERENCE_RATE = 3.2e6
"""Steps per second of the reference of the rolling disk [1/s]."""


def works(quick: bool) -> list[Work]:
    """Return all runs; `quick` keeps the first and the last value of every setting."""
    return [*impact_works(quick), *rolling_works(quick), *hazard_works(quick)]


def impact_works(quick: bool) -> list[Work]:
    """Return the runs of the lossless impact."""
    rates = selected_values((1e5, 2e5, 4e5, 8e5, 1.6e6), quick)
    runs = works_over(
        "full",
        FULL_METHOD,
        RATE_SETTING,
        rates,
        case.full_model_impact,
        IMPACT,
        distance_from_one,
        0.1,
    )
    for name, step in (("leap-frog", leap_frog), ("explicit Euler", explicit_euler)):
        explicit_rates = selected_values((2.5e4, *rates), quick)
        solve = partial(case.explicit_impact, step)
        runs += works_over(
            "explicit",
            name,
            RATE_SETTING,
            explicit_rates,
            solve,
            IMPACT,
            distance_from_one,
            0.1,
        )
    return runs


def rolling_works(quick: bool) -> list[Work]:
    """Return the runs of the disk that rolls on a rough table."""
    error = partial(_force_error, case.ROUGHNESS_RMS, REFERENCE_RATE)
    full_rates = selected_values((1e5, 2e5, 4e5), quick)
    filter_rates = selected_values((6e3, 1.2e4, 2.4e4, 4.8e4, 9.6e4, 1.92e5), quick)
    return [
        Work("rigid", "event-driven", "-", ROLLING, _rigid, error),
        *works_over(
            "full",
            FULL_METHOD,
            RATE_SETTING,
            full_rates,
            case.full_model_rms,
            ROLLING,
            error,
        ),
        *works_over(
            "filter",
            FILTER_METHOD,
            RATE_SETTING,
            filter_rates,
            case.filter_rms,
            ROLLING,
            error,
            0.1,
        ),
    ]


def hazard_works(quick: bool) -> list[Work]:
    """Return the runs of the hazards; their setting is the value of the parameter."""
    runs = []
    for loss in selected_values((0.02, 0.002, 0.0), quick):
        for name, creeps in (("with creep", True), ("without creep", False)):
            call = partial(case.relative_inclination, loss, creeps)
            runs.append(
                Work("full", name, f"{loss:g}", NO_LOSS, call, distance_from_one)
            )
    for rms in selected_values((1e-8, 3e-8, 1e-7, 3e-7, 1e-6), quick):
        call = partial(case.filter_rms, 9.6e4, rms=rms)
        error = partial(_force_error, rms, 4e5)
        setting = f"{case.contact_shift(rms):.2g}"
        runs.append(
            Work("filter", FILTER_METHOD, setting, SEVERAL_CONTACTS, call, error, 0.1)
        )
    inclinations = selected_values((1e-2, 1e-4, 1e-6, 1e-7, 3e-8), quick)
    return runs + works_over(
        "full",
        FULL_METHOD,
        "{:g}",
        inclinations,
        case.relative_energy,
        SMALL_INCLINATION,
        distance_from_one,
    )


def _rigid() -> Answer:
    """Solve the event-driven motion of the same disk, whose force has no component
    above AUDIBLE."""
    start = steady_state(case.contact_table().law, case.ROLLING_INCLINATION)
    scene = load_scene("granite").replace(
        "contact.law=rigid",
        f"contact.fillet={case.contact_table().law.fillet}",
        f"release.inclination_deg={degrees(start[1])}",
        f"release.omega={start[5:8].tolist()}",
        f"numerics.time_limit={case.ROLLING_DURATION}",
    )
    return Answer((0.0,), len(simulate(scene).t))


@cache
def _reference(rms: float, rate: float) -> float:
    return case.full_model_rms(rate, rms=rms).values[0]


def _force_error(rms, rate, values) -> float:
    """Return the relative error of the rms force against the full model with `rate`
    steps per second."""
    return abs(values[0] / _reference(rms, rate) - 1)


def run(quick: bool, watch=lambda fraction, note: None) -> list[Record]:
    """Return the records of the chart; `watch(fraction, note)` is called before every
    run."""
    return measured(
        works(quick), watch, warm=lambda work: work.case in (IMPACT, ROLLING)
    )


def draw(records: list[Record], title: str, path):
    """Draw error against processor time for the two cases with a reference."""
    error_time_picture.draw(
        [r for r in records if r.case in (IMPACT, ROLLING)],
        title,
        "relative error",
        path,
    )


def conclusion(records: list[Record]) -> list[str]:
    """Return at most five sentences: which method to use, and where each method
    fails."""
    full = most_accurate(records, family="full", case=ROLLING)
    linear = most_accurate(records, family="filter", case=ROLLING)
    gradient = most_accurate(records, family="full", case=IMPACT)
    explicit = most_accurate(records, family="explicit")
    lines = [
        f"If the contact is never lost, use the filter: its error of the rms force is "
        f"{number(linear.error)}, in "
        f"{milliseconds(linear)} for {case.ROLLING_DURATION:g} s of motion at {linear.setting}. "
        f"The full model takes "
        f"{milliseconds(full)} for an error of {number(full.error)}.",
        "The rigid contact has no force at these frequencies.",
        "In the impact the discrete gradient conserves the energy to round-off at any step, and "
        "the error of its "
        f"approach is {number(gradient.error)} at {gradient.setting}; the error of the explicit "
        f"steps, timed in one "
        f"dimension, is {number(explicit.error)} at {explicit.setting}.",
    ]
    lost = [r for r in records if r.case == SEVERAL_CONTACTS and r.failure]
    if lost:
        lines.append(
            f"The filter fails from rms(z'') R/beta = {lost[0].setting} on: contact is lost."
        )
    not_converged = [r for r in records if r.case == NO_LOSS and r.failure]
    if not_converged:
        lines.append(
            f"Without creep, slips do not converge from a loss factor of "
            f"{not_converged[0].setting} on."
        )
    return lines
