"""Chart the error of inclination and energy of the rolling disk against processor time
for all methods."""

from functools import partial

from benchmarks.cases.motion_case import (
    EASY_SPAN,
    Case,
    conservative,
    published,
    sticking,
)
from benchmarks.charts.chart_page import methods, number
from benchmarks.methods import event_driven
from benchmarks.methods.moreau_time_stepping import moreau
from benchmarks.methods.sign_friction import naive_sign
from benchmarks.methods.slip_tolerance import slip_tolerance
from benchmarks.methods.tanh_friction import tanh_regularised
from benchmarks.peers import engines
from benchmarks.timed_runs import (
    MAX_TIMINGS,
    Record,
    Work,
    measured,
    most_accurate,
    selected_values,
)

PROBLEM = r"""
A disk of radius $R$ rolls and slides on a plane under the balance laws (4.1), (4.2), dimensionless with $m = R = 1$ and

$$\dot\omega = M(\beta)^{-1}\left(g(\beta, \omega) + r \times F - \sum_i k_i N \sigma_i a_i\right), \qquad
\sigma_i \in \mathrm{sign}(\omega \cdot a_i), \qquad
|F| \le \mu_s N \ \text{(rolling)}, \quad F = -\mu_d N u/|u| \ \text{(sliding)}.$$

The results are inclination and energy at the end of a time span, in three cases: *conservative* without moments
($\tau = 10$, exact in hypergeometric functions); *published* as in section 7 of the paper ($\tau = 50$, with slips);
*sticking* with $k_1 = 0.01$ ($\tau = 40$, the nutation stops and starts). The references were computed in quadruple
precision and in 80-bit arithmetic.
"""
SIGN_FRICTION_INTEGRATORS = ("RK45", "DOP853", "LSODA", "Radau", "BDF")
TAYLOR_METHOD = "Taylor (heyoka)"
DOP853_METHOD = "our DOP853"
BASELINE_METHOD = "solve_ivp DOP853"

COMPARED_ERRORS = (1e-6, 1e-9, 1e-11)
"""Relative errors at which our methods are compared with the same model on scipy's
solve_ivp."""

MAX_PROOF_ERROR = 2e-3
"""Largest relative error on the easy time span at which a method counts as computing
the same motion."""

COMPILED_METHODS = (TAYLOR_METHOD, DOP853_METHOD, "time-stepping")
"""Methods with compilation during their first run, which is therefore not timed."""

MAX_MOTION_ERROR = 1.0
"""Relative error above which a run counts as failed."""

AREA_CONTACT_METHOD = "Drake, contact by areas"
"""Method with a contact over an area, a different model, which is therefore excluded
from the proofs."""


def works(case: Case, quick: bool) -> list[Work]:
    """Return all runs of the chart on one case; `quick` keeps all methods but fewer
    settings."""

    def middle(settings):
        return settings[1:2] or settings if quick else settings

    def work(family, method, setting, function, *arguments):
        return Work(
            family,
            method,
            setting,
            case.name,
            partial(function, case, *arguments),
            case.error,
            MAX_MOTION_ERROR,
        )

    runs = []
    for tol in selected_values((1e-4, 1e-6, 1e-8, 1e-10, 1e-12, 1e-14, 1e-16), quick):
        runs.append(
            work(
                "event-driven",
                TAYLOR_METHOD,
                f"tol {tol:g}",
                event_driven.ours,
                "taylor",
                tol,
            )
        )
    for tol in selected_values((1e-7, 1e-9, 1e-10, 1e-11, 1e-12, 1e-13), quick):
        runs.append(
            work(
                "event-driven",
                "our DOP853",
                f"tol {tol:g}",
                event_driven.ours,
                "dop853",
                tol,
            )
        )
    for method, tolerances in {
        "DOP853": (1e-6, 1e-9, 1e-10, 1e-11, 1e-12, 1e-13),
        "LSODA": (1e-9, 1e-10, 1e-11, 1e-12),
        "Radau": (1e-9, 1e-10),
    }.items():
        for tol in selected_values(tolerances, quick):
            name = f"solve_ivp {method}"
            runs.append(
                work(
                    "event-driven",
                    name,
                    f"tol {tol:g}",
                    event_driven.with_solve_ivp,
                    method,
                    tol,
                )
            )
    for method in SIGN_FRICTION_INTEGRATORS:
        for tol in selected_values((1e-4, 1e-6, 1e-8, 1e-10), quick):
            runs.append(
                work("naive sign()", method, f"tol {tol:g}", naive_sign, method, tol)
            )
    for start, stop, longest in middle(
        ((1e-3, 1e-3, 0.1), (1e-4, 1e-4, 0.01), (1e-5, 1e-5, 3e-3), (1e-5, 1e-10, 0.1))
    ):
        setting = f"start {start:g}, stop {stop:g}, steps <= {longest:g}"
        runs.append(
            work(
                "slip tolerance",
                "DOP853",
                setting,
                slip_tolerance,
                start,
                stop,
                longest,
                1e-9,
            )
        )
    for width in selected_values((1e-2, 1e-3, 1e-4, 1e-5, 1e-6), quick):
        runs.append(
            work(
                "tanh",
                "LSODA",
                f"width {width:g}",
                tanh_regularised,
                "LSODA",
                width,
                1e-3 * width,
            )
        )
    for width in selected_values((1e-2, 1e-3, 1e-4), quick):
        runs.append(
            work(
                "tanh",
                "Radau",
                f"width {width:g}",
                tanh_regularised,
                "Radau",
                width,
                1e-2 * width,
            )
        )
    for step in selected_values((1e-1, 3e-2, 1e-2, 3e-3, 1e-3, 3e-4, 1e-4), quick):
        runs.append(work("Moreau", "time-stepping", f"step {step:g}", moreau, step))
    if case.name != "sticking":
        for method, peer in engines.methods_for(case).items():
            for setting, call in middle(peer.runs(case)):
                runs.append(
                    Work(
                        "engine",
                        method,
                        setting,
                        case.name,
                        call,
                        case.error,
                        MAX_MOTION_ERROR,
                    )
                )
    return runs


def proofs() -> list[Work]:
    """Return one accurate run per method on the easy time span, to show that all
    methods compute the same motion."""
    case = published(EASY_SPAN)

    def work(family, method, function, *arguments):
        return Work(
            family,
            method,
            "proof",
            case.name,
            partial(function, case, *arguments),
            case.error,
        )

    scipy = [
        work("event-driven", f"solve_ivp {m}", event_driven.with_solve_ivp, m, 1e-8)
        for m in ("DOP853", "LSODA")
    ]
    scipy += [
        work("event-driven", f"solve_ivp {m}", event_driven.with_solve_ivp, m, 1e-6)
        for m in ("Radau", "BDF")
    ]
    return [
        work("event-driven", TAYLOR_METHOD, event_driven.ours, "taylor", 1e-16),
        work("event-driven", "our DOP853", event_driven.ours, "dop853", 1e-12),
        *scipy,
        *(
            work("naive sign()", m, naive_sign, m, 1e-8)
            for m in ("RK45", "DOP853", "LSODA")
        ),
        work("slip tolerance", "DOP853", slip_tolerance, 1e-5, 1e-5, 0.1, 1e-8),
        work("tanh", "LSODA", tanh_regularised, "LSODA", 1e-5, 1e-9),
        work("tanh", "Radau", tanh_regularised, "Radau", 1e-5, 1e-8),
        work("Moreau", "time-stepping", moreau, 1e-3),
        *(
            Work(
                "engine", method, "proof", case.name, peer.runs(case)[-1][1], case.error
            )
            for case in (conservative(EASY_SPAN), case)
            for method, peer in engines.methods_for(case).items()
            if method != AREA_CONTACT_METHOD
        ),
    ]


def prove() -> list[Record]:
    """Run the proofs and return their records. Raises ArithmeticError if a method
    computes another motion."""
    records = measured(proofs(), repeats=1)
    judged = [r for r in records if not r.left_out]
    wrong = [r for r in judged if not r.error <= MAX_PROOF_ERROR]
    if wrong:
        reasons = [
            f"{r.family} {r.method}: {r.failure or format(r.error, '.2g')}"
            for r in wrong
        ]
        raise ArithmeticError(
            f"not the same motion on the easy time span: {'; '.join(reasons)}"
        )
    return records


def run(quick: bool, watch=lambda fraction, note: None) -> list[Record]:
    """Return the records of the chart; `watch(fraction, note)` is called before every
    run."""
    prove()
    cases = (conservative(), published(10.0 if quick else 50.0), sticking())
    runs = [work for case in cases for work in works(case, quick)]
    return measured(
        runs,
        watch,
        lambda work: work.method in COMPILED_METHODS,
        1 if quick else MAX_TIMINGS,
    )


def cheapest(
    records: list[Record], case: str, method: str, error: float
) -> Record | None:
    """Return the fastest run of an event-driven method with at most this error, or None
    if there is none."""
    good = [
        r
        for r in records
        if (r.family, r.case, r.method) == ("event-driven", case, method)
        and r.error <= error
    ]
    return min(
        (r for r in good if not r.failure), key=lambda r: r.seconds, default=None
    )


def speed_ratio(
    records: list[Record], case: str, method: str, error: float
) -> float | None:
    """Return the ratio of the times of solve_ivp's DOP853 and of one of our methods at
    this error; None if one of them does not reach it."""
    fast = cheapest(records, case, method, error)
    slow = cheapest(records, case, BASELINE_METHOD, error)
    return slow.seconds / fast.seconds if fast and slow else None


def conclusion(records: list[Record]) -> list[str]:
    """Return at most five sentences that recommend a method and state how the others
    fail."""
    cases = list(dict.fromkeys(r.case for r in records))
    lines = []
    ranges = {
        name: range_of_speed_ratios(records, method)
        for name, method in (
            ("DOP853", DOP853_METHOD),
            ("Taylor series", TAYLOR_METHOD),
        )
    }
    measured_ranges = [
        f"{span} times ({name})" for name, span in ranges.items() if span
    ]
    if measured_ranges:
        lines.append(
            "Use an event-driven method of high order: at equal errors it is faster than the "
            f"same model on scipy's solve_ivp, {' and '.join(measured_ranges)}"
            f"{_accuracy_clause(records, cases)}."
        )
    lines.append(
        f"Before the timing, every method except the contact by areas had to agree with the "
        f"reference within "
        f"{MAX_PROOF_ERROR:g} at tau = {EASY_SPAN:g}."
    )
    simple = [r for r in records if r.family not in ("event-driven", "engine")]
    if hard := [r for r in simple if r.case != "conservative"]:
        lines.append(
            f"Of the methods without events, {sum(bool(r.failure) for r in hard)} of {len(hard)} "
            f"runs failed in the "
            "cases with sliding or sticking; the smallest error of the others is "
            f"{number(min((r.error for r in hard if not r.failure), default=MAX_MOTION_ERROR))}."
        )
    if any(
        r.family == "engine" and not r.left_out and r.case == "published"
        for r in records
    ):
        lines.append(
            "Do not use a physics engine for a sliding disk: the engines have one coefficient of "
            "friction, here the "
            "static one, so that they converge to another motion as the step decreases."
        )
    return lines


def tables(records: list[Record]) -> dict[str, list[list]]:
    """Return tables of the speed ratios at equal errors and of the methods of every
    case, by heading."""
    errors = [f"at an error of {error:g}" for error in COMPARED_ERRORS]
    ratios = [["case", "method", *errors]]
    for case in dict.fromkeys(r.case for r in records):
        for method in (DOP853_METHOD, TAYLOR_METHOD):
            known = [speed_ratio(records, case, method, e) for e in COMPARED_ERRORS]
            cells = [f"{ratio:.0f}" if ratio else "-" for ratio in known]
            ratios.append([case, method, *cells])
    return {f"Time of {BASELINE_METHOD} over time of our methods": ratios} | methods(
        records
    )


def range_of_speed_ratios(records: list[Record], method: str) -> str:
    """Return the range of the speed ratios of one of our methods over cases and errors,
    such as "34 to 56", or "" if none is known."""
    known = [
        speed_ratio(records, case, method, error)
        for case in dict.fromkeys(r.case for r in records)
        for error in COMPARED_ERRORS
    ]
    ratios = [ratio for ratio in known if ratio]
    return f"{min(ratios):.0f} to {max(ratios):.0f}" if ratios else ""


def _accuracy_clause(records, cases):
    """Return the clause that the Taylor series has the smallest error, or "" if this is
    not true in all cases."""
    best = {most_accurate(records, case=case).method for case in cases}
    return (
        "; the smallest error of the Taylor series is below that of every other method"
        if best == {TAYLOR_METHOD}
        else ""
    )
