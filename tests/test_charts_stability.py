"""Claim: the map of failures is as drawn: each failure is there, and our default methods show none of them.

Source: Filippov's reading of (3.3); the stability limits of the textbook integrators. Oracle: 80-bit arithmetic.
"""

import pytest

from sonify.charts import stability
from sonify.charts.records import Work, measure

STICKS = ("nutation sticks", "sticks early", "pivoting sticks")
NEVER = [("event-driven", "solve_ivp DOP853", "tol 1e-12"), ("event-driven", "our DOP853", "tol 1e-12")]
FAILS = {
    ("event-driven", "solve_ivp DOP853", "tol 1e-6"): ("never grips again", ("slips begin, end", *STICKS)),
    ("naive sign()", "RK45", "tol 1e-8"): ("chatters", STICKS),
    ("naive sign()", "LSODA", "tol 1e-8"): ("chatters", STICKS),
    ("naive sign()", "Radau", "tol 1e-8"): ("wrong", ("easy: rolls", "sticks early")),
    ("naive sign()", "BDF", "tol 1e-8"): ("wrong", ("easy: rolls", "sticks early")),
    ("slip tolerance", "DOP853", "1e-12"): ("chatters", ("sticks early",)),
    ("tanh", "LSODA", "width 1e-3"): ("wrong", ("slips begin, end", "nutation sticks")),
    ("Moreau", "time-stepping", "step 1e-2"): ("left the table", ("pivoting sticks",)),
}


def record_of(about, hazard):
    function, *arguments = stability.METHODS[about]
    case = stability.HAZARDS[hazard]
    return measure(Work(*about, hazard, lambda: function(case, *arguments), case.error), repeats=1)


@pytest.mark.parametrize("about", [a for a in stability.METHODS if a[1:] == ("Taylor (heyoka)", "tol 1e-16")] + NEVER)
@pytest.mark.parametrize("hazard", stability.HAZARDS)
def test_ours_fails_nowhere(about, hazard):
    if "heyoka" in about[1]:
        pytest.importorskip("heyoka")
    record = record_of(about, hazard)
    assert not record.failure
    assert record.error < 1e-6


@pytest.mark.parametrize(
    ("about", "hazard"), [(about, hazard) for about, (_, hazards) in FAILS.items() for hazard in hazards]
)
def test_simpler_methods_fail_as_drawn(about, hazard):
    assert record_of(about, hazard).failure.startswith(FAILS[about][0])


def test_oscillators_fail_as_drawn():
    failed = {(r.method, r.case): r.failure.split(" ")[0] for r in stability.oscillators()}
    for pitch in stability.PITCHES:
        assert failed["exact, first-order hold", pitch] == ""
        assert failed["explicit Euler", pitch] == "grows"
    for method in ("Verlet", "semi-implicit Euler"):
        assert [failed[method, p] for p in ("0.1 fs", "0.25 fs", "0.4 fs")] == ["out", "out", "grows"]
    assert [failed["bilinear", p] for p in ("0.1 fs", "0.25 fs", "0.4 fs", "0.49 fs")] == ["out"] * 4
    assert failed["Runge-Kutta 4", "0.25 fs"] == "out"
    assert failed["Runge-Kutta 4", "0.49 fs"] == "grows"
