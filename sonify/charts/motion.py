"""The chart of the motion: error of inclination and energy against seconds, for every way to solve a rolling disk."""

from functools import partial

from sonify.charts import event_driven, peers
from sonify.charts.moreau import moreau
from sonify.charts.motion_case import EASY, Case, conservative, published, sticking
from sonify.charts.naive import naive_sign
from sonify.charts.page import methods, number
from sonify.charts.records import REPEATS, Record, Work, ends, measured, nearest
from sonify.charts.regularised import tanh_regularised
from sonify.charts.slip_tolerance import slip_tolerance

PROBLEM = r"""
A disk of radius $R$ rolls and slides on a plane under the balance laws (4.1), (4.2), dimensionless with $m = R = 1$ and

$$\dot\omega = M(\beta)^{-1}\left(g(\beta, \omega) + r \times F - \sum_i k_i N \sigma_i a_i\right), \qquad
\sigma_i \in \mathrm{sign}(\omega \cdot a_i), \qquad
|F| \le \mu_s N \ \text{(rolling)}, \quad F = -\mu_d N u/|u| \ \text{(sliding)}.$$

Asked are inclination and energy at the end of a span: *conservative* without moments ($\tau = 10$, exact in
hypergeometric functions), *published* as in section 7 of the paper ($\tau = 50$, with slips), *sticking* with
$k_1 = 0.01$ ($\tau = 40$, the nutation stops and starts). References: quadruple precision and 80-bit arithmetic.
"""
TAYLOR, BASELINE = "Taylor (heyoka)", "solve_ivp DOP853"
EQUAL_ERRORS = (1e-6, 1e-9, 1e-11)
"""Errors at which our Taylor series is compared with the same model on scipy's solve_ivp."""
NAIVE = ("RK45", "DOP853", "LSODA", "Radau", "BDF")
PROOF = 2e-3
"""Largest relative error on the easy stretch at which a method is believed to compute the same motion."""
COMPILED = (TAYLOR, "our DOP853", "time-stepping")
"""Methods whose first run compiles, which is not timed."""
NONSENSE = 1.0
"""A relative error above this is a failure: the answer says nothing."""
AREAS = "Drake, contact by areas"
"""Another model of the contact than a point, with nothing to prove: it is charted for what it does."""


def works(case: Case, quick: bool) -> list[Work]:
    """Return every run of the chart on one case; `quick` leaves out settings, not methods."""

    def middle(settings):
        return settings[1:2] or settings if quick else settings

    def work(family, method, setting, function, *arguments):
        return Work(family, method, setting, case.name, partial(function, case, *arguments), case.error, NONSENSE)

    runs = []
    for tol in ends((1e-4, 1e-6, 1e-8, 1e-10, 1e-12, 1e-14, 1e-16), quick):
        runs.append(work("event-driven", TAYLOR, f"tol {tol:g}", event_driven.ours, "taylor", tol))
    for tol in ends((1e-7, 1e-9, 1e-10, 1e-11, 1e-12, 1e-13), quick):
        runs.append(work("event-driven", "our DOP853", f"tol {tol:g}", event_driven.ours, "dop853", tol))
    for method, tolerances in {
        "DOP853": (1e-6, 1e-9, 1e-10, 1e-11, 1e-12, 1e-13),
        "LSODA": (1e-9, 1e-10, 1e-11, 1e-12),
        "Radau": (1e-9, 1e-10),
    }.items():
        for tol in ends(tolerances, quick):
            name = f"solve_ivp {method}"
            runs.append(work("event-driven", name, f"tol {tol:g}", event_driven.with_solve_ivp, method, tol))
    for method in NAIVE:
        for tol in ends((1e-4, 1e-6, 1e-8, 1e-10), quick):
            runs.append(work("naive sign()", method, f"tol {tol:g}", naive_sign, method, tol))
    for start, stop, longest in middle(((1e-3, 1e-3, 0.1), (1e-4, 1e-4, 0.01), (1e-5, 1e-5, 3e-3), (1e-5, 1e-10, 0.1))):
        setting = f"start {start:g}, stop {stop:g}, steps <= {longest:g}"
        runs.append(work("slip tolerance", "DOP853", setting, slip_tolerance, start, stop, longest, 1e-9))
    for width in ends((1e-2, 1e-3, 1e-4, 1e-5, 1e-6), quick):
        runs.append(work("tanh", "LSODA", f"width {width:g}", tanh_regularised, "LSODA", width, 1e-3 * width))
    for width in ends((1e-2, 1e-3, 1e-4), quick):
        runs.append(work("tanh", "Radau", f"width {width:g}", tanh_regularised, "Radau", width, 1e-2 * width))
    for step in ends((1e-1, 3e-2, 1e-2, 3e-3, 1e-3, 3e-4, 1e-4), quick):
        runs.append(work("Moreau", "time-stepping", f"step {step:g}", moreau, step))
    if case.name != "sticking":
        for method, peer in peers.able(case).items():
            for setting, call in middle(peer.runs(case)):
                runs.append(Work("engine", method, setting, case.name, call, case.error, NONSENSE))
    return runs


def proofs() -> list[Work]:
    """Return one run per method, finely set, on the easy stretch: each must show that it computes the same motion."""
    case = published(EASY)

    def work(family, method, function, *arguments):
        return Work(family, method, "proof", case.name, partial(function, case, *arguments), case.error)

    scipy = [work("event-driven", f"solve_ivp {m}", event_driven.with_solve_ivp, m, 1e-8) for m in ("DOP853", "LSODA")]
    scipy += [work("event-driven", f"solve_ivp {m}", event_driven.with_solve_ivp, m, 1e-6) for m in ("Radau", "BDF")]
    return [
        work("event-driven", TAYLOR, event_driven.ours, "taylor", 1e-16),
        work("event-driven", "our DOP853", event_driven.ours, "dop853", 1e-12),
        *scipy,
        *(work("naive sign()", m, naive_sign, m, 1e-8) for m in ("RK45", "DOP853", "LSODA")),
        work("slip tolerance", "DOP853", slip_tolerance, 1e-5, 1e-5, 0.1, 1e-8),
        work("tanh", "LSODA", tanh_regularised, "LSODA", 1e-5, 1e-9),
        work("tanh", "Radau", tanh_regularised, "Radau", 1e-5, 1e-8),
        work("Moreau", "time-stepping", moreau, 1e-3),
        *(
            Work("engine", method, "proof", case.name, peer.runs(case)[-1][1], case.error)
            for case in (conservative(EASY), case)
            for method, peer in peers.able(case).items()
            if method != AREAS
        ),
    ]


def prove() -> list[Record]:
    """Run the proofs. Raises ArithmeticError where a method does not compute the same motion."""
    records = measured(proofs(), repeats=1)
    judged = [r for r in records if not r.left_out]
    wrong = [f"{r.family} {r.method}: {r.failure or f'{r.error:.2g}'}" for r in judged if not r.error <= PROOF]
    if wrong:
        raise ArithmeticError(f"not the same motion on the easy stretch: {'; '.join(wrong)}")
    return records


def run(quick: bool, watch=lambda share, note: None) -> list[Record]:
    """Return the records of the chart; `watch(share, note)` is called before every run."""
    prove()
    cases = (conservative(), published(10.0 if quick else 50.0), sticking())
    runs = [work for case in cases for work in works(case, quick)]
    return measured(runs, watch, lambda work: work.method in COMPILED, 1 if quick else REPEATS)


def cheapest(records: list[Record], case: str, method: str, error: float) -> Record | None:
    """Return the fastest run of an event-driven method whose error is at most `error`, None if there is none."""
    good = [r for r in records if (r.family, r.case, r.method) == ("event-driven", case, method) and r.error <= error]
    return min((r for r in good if not r.failure), key=lambda r: r.seconds, default=None)


def speed_ratio(records: list[Record], case: str, error: float) -> float | None:
    """Return how many times faster our Taylor series reaches `error` than solve_ivp's DOP853 on the same model."""
    fast, slow = (cheapest(records, case, method, error) for method in (TAYLOR, BASELINE))
    return slow.seconds / fast.seconds if fast and slow else None


def conclusion(records: list[Record]) -> list[str]:
    """Return what the records say, in at most five sentences."""
    cases, lines = dict.fromkeys(r.case for r in records), []
    known = [speed_ratio(records, case, error) for case in cases for error in EQUAL_ERRORS]
    if ratios := [ratio for ratio in known if ratio]:
        lines.append(
            f"Take the event-driven Taylor series: {min(ratios):.0f} to {max(ratios):.0f} times faster than the same "
            f"model on scipy's solve_ivp at equal errors{_nearest(records, cases)}."
        )
    lines.append(
        f"Every method but the contact by areas had first to come within {PROOF:g} of the reference at tau = {EASY:g}; "
        "only then was it timed."
    )
    simple = [r for r in records if r.family not in ("event-driven", "engine")]
    if hard := [r for r in simple if r.case != "conservative"]:
        lines.append(
            f"Without events {sum(bool(r.failure) for r in hard)} of {len(hard)} runs failed where the disk slides or "
            "sticks; the others stay above an error of "
            f"{number(min((r.error for r in hard if not r.failure), default=NONSENSE))}."
        )
    if any(r.family == "engine" and not r.left_out and r.case == "published" for r in records):
        lines.append(
            "Take no engine for a disk that slides: they know one coefficient of friction, here the static one, where "
            "a slide has another, so that finer steps lead them to another motion."
        )
    return lines


def tables(records: list[Record]) -> dict[str, list[list]]:
    """Return the ratios of speed at equal errors, and the methods of every case."""
    ratios = [["case", *(f"at an error of {error:g}" for error in EQUAL_ERRORS)]]
    for case in dict.fromkeys(r.case for r in records):
        known = [speed_ratio(records, case, error) for error in EQUAL_ERRORS]
        ratios.append([case, *(f"{ratio:.0f}" if ratio else "-" for ratio in known)])
    return {f"Times that {TAYLOR} is faster than {BASELINE}": ratios} | methods(records)


def _nearest(records, cases):
    """Say that the Taylor series comes nearest of all, if it does so in every case."""
    best = {nearest(records, case=case).method for case in cases}
    return ", and nearer than everything else here" if best == {TAYLOR} else ""
