"""The chart of the motion: error of inclination and energy against seconds, for every way to solve a rolling disk."""

from functools import partial

from sonify.charts import event_driven
from sonify.charts.moreau import moreau
from sonify.charts.motion_case import EASY, Case, published, sticking
from sonify.charts.naive import naive_sign
from sonify.charts.records import REPEATS, Record, Work, measure
from sonify.charts.regularised import tanh_regularised
from sonify.charts.slip_tolerance import slip_tolerance

BASELINE = "solve_ivp DOP853"
EQUAL_ERRORS = (1e-6, 1e-9, 1e-11)
"""Errors at which our Taylor series is compared with the same model on scipy's solve_ivp."""
NAIVE = ("RK45", "DOP853", "LSODA", "Radau", "BDF")
PROOF = 1e-3
"""Largest relative error on the easy stretch at which a method is believed to compute the same motion."""


def works(case: Case, quick: bool) -> list[Work]:
    """Return every run of the chart on one case; `quick` leaves out settings, not methods."""

    def some(settings):
        return settings[:: max(1, len(settings) - 1)] if quick else settings

    def work(family, method, setting, function, *arguments):
        return Work(family, method, setting, case.name, partial(function, case, *arguments), case.error)

    runs = []
    for tol in some((1e-4, 1e-6, 1e-8, 1e-10, 1e-12, 1e-14, 1e-16)):
        runs.append(work("event-driven", "Taylor (heyoka)", f"tol {tol:g}", event_driven.ours, "taylor", tol))
    for tol in some((1e-7, 1e-9, 1e-10, 1e-11, 1e-12, 1e-13)):
        runs.append(work("event-driven", "our DOP853", f"tol {tol:g}", event_driven.ours, "dop853", tol))
    for method, tolerances in {
        "DOP853": (1e-6, 1e-9, 1e-10, 1e-11, 1e-12, 1e-13),
        "LSODA": (1e-9, 1e-10, 1e-11, 1e-12),
        "Radau": (1e-9, 1e-10),
    }.items():
        for tol in some(tolerances):
            name = f"solve_ivp {method}"
            runs.append(work("event-driven", name, f"tol {tol:g}", event_driven.with_solve_ivp, method, tol))
    for method in NAIVE:
        for tol in some((1e-4, 1e-6, 1e-8, 1e-10)):
            runs.append(work("naive sign()", method, f"tol {tol:g}", naive_sign, method, tol))
    for start, stop, longest in some(((1e-3, 1e-3, 0.1), (1e-4, 1e-4, 0.01), (1e-5, 1e-5, 3e-3), (1e-5, 1e-10, 0.1))):
        setting = f"start {start:g}, stop {stop:g}, steps <= {longest:g}"
        runs.append(work("slip tolerance", "DOP853", setting, slip_tolerance, start, stop, longest, 1e-9))
    for width in some((1e-2, 1e-3, 1e-4, 1e-5, 1e-6)):
        runs.append(work("tanh", "LSODA", f"width {width:g}", tanh_regularised, "LSODA", width, 1e-3 * width))
    for width in some((1e-2, 1e-3, 1e-4)):
        runs.append(work("tanh", "Radau", f"width {width:g}", tanh_regularised, "Radau", width, 1e-2 * width))
    for step in some((1e-1, 3e-2, 1e-2, 3e-3, 1e-3, 3e-4, 1e-4)):
        runs.append(work("Moreau", "time-stepping", f"step {step:g}", moreau, step))
    return runs


def proofs() -> list[Work]:
    """Return one run per method, finely set, on the easy stretch: each must show that it computes the same motion."""
    case = published(EASY)

    def work(family, method, function, *arguments):
        return Work(family, method, "proof", case.name, partial(function, case, *arguments), case.error)

    scipy = [work("event-driven", f"solve_ivp {m}", event_driven.with_solve_ivp, m, 1e-8) for m in ("DOP853", "LSODA")]
    scipy += [work("event-driven", f"solve_ivp {m}", event_driven.with_solve_ivp, m, 1e-6) for m in ("Radau", "BDF")]
    return [
        work("event-driven", "Taylor (heyoka)", event_driven.ours, "taylor", 1e-16),
        work("event-driven", "our DOP853", event_driven.ours, "dop853", 1e-12),
        *scipy,
        *(work("naive sign()", m, naive_sign, m, 1e-8) for m in ("RK45", "DOP853", "LSODA")),
        work("slip tolerance", "DOP853", slip_tolerance, 1e-5, 1e-5, 0.1, 1e-8),
        work("tanh", "LSODA", tanh_regularised, "LSODA", 1e-5, 1e-9),
        work("tanh", "Radau", tanh_regularised, "Radau", 1e-5, 1e-8),
        work("Moreau", "time-stepping", moreau, 1e-3),
    ]


def prove() -> list[Record]:
    """Run the proofs. Raises ArithmeticError where a method does not compute the same motion."""
    records = [measure(work) for work in proofs()]
    judged = [r for r in records if r.failure != event_driven.LEFT_OUT]
    wrong = [f"{r.family} {r.method}: {r.failure or f'{r.error:.2g}'}" for r in judged if not r.error <= PROOF]
    if wrong:
        raise ArithmeticError(f"not the same motion on the easy stretch: {'; '.join(wrong)}")
    return records


def run(quick: bool, watch=lambda share, note: None) -> list[Record]:
    """Return the records of the chart; `watch(share, note)` is called before every run."""
    prove()
    all_works = [w for case in (published(10.0 if quick else 50.0), sticking()) for w in works(case, quick)]
    records = []
    for i, work in enumerate(all_works):
        watch(i / len(all_works), f"{work.case}: {work.family}, {work.method}, {work.setting}")
        records.append(measure(work, warm=work.family in ("Moreau", "event-driven"), repeats=2 if quick else REPEATS))
    return records


def cheapest(records: list[Record], case: str, method: str, error: float) -> Record | None:
    """Return the fastest run of an event-driven method whose error is at most `error`, None if there is none."""
    good = [r for r in records if (r.family, r.case, r.method) == ("event-driven", case, method) and r.error <= error]
    return min((r for r in good if not r.failure), key=lambda r: r.seconds, default=None)


def speed_ratio(records: list[Record], case: str, error: float) -> float | None:
    """Return how many times faster our Taylor series reaches `error` than solve_ivp's DOP853 on the same model."""
    fast, slow = (cheapest(records, case, method, error) for method in ("Taylor (heyoka)", BASELINE))
    return slow.seconds / fast.seconds if fast and slow else None


def conclusion(records: list[Record]) -> list[str]:
    """Return what the records say, in sentences."""
    lines = []
    for case in dict.fromkeys(r.case for r in records):
        for error in EQUAL_ERRORS:
            ratio = speed_ratio(records, case, error)
            if ratio:
                lines.append(
                    f"{case}: at an error of at most {error:g} our Taylor series is {ratio:.0f} times faster than the "
                    "same event-driven model on scipy's solve_ivp with DOP853."
                )
        for family in dict.fromkeys(r.family for r in records):
            lines.append(_best(family, [r for r in records if (r.family, r.case) == (family, case)]))
    return lines


def _best(family, runs):
    failed = sum(bool(r.failure) for r in runs)
    about = f"{runs[0].case}, {family}: {failed} of {len(runs)} runs failed"
    good = [r for r in runs if not r.failure]
    if not good:
        return f"{about}."
    best = min(good, key=lambda r: r.error)
    return f"{about}; the best error is {best.error:.1e} in {best.seconds:.2g} s ({best.method}, {best.setting})."
