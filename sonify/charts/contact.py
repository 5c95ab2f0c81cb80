"""The chart of the elastic contact: error against seconds for the filter, the full model and the rigid contact."""

from functools import cache, partial
from math import degrees

from dynamics import simulate
from sonify.charts import chart
from sonify.charts import contact_case as case
from sonify.charts.contact_case import explicit_euler, leap_frog
from sonify.charts.page import milliseconds, number
from sonify.charts.records import Answer, Record, Work, along, ends, from_one, measured, nearest
from sonify.claims.halt import steady
from sonify.scene import load_scene

PROBLEM = r"""
A disk touches a table that yields: $N = K(\beta)\,(-G)^{3/2}(1 - c\,\dot G)$ at a gap $G$, which heights of table and
edge move, and tangential springs that creep. *A lossless impact* keeps its energy and has a closed form,
$\delta = (5 m v^2/4K)^{2/5}$. *Rolling on roughness* of 0.01 um is judged by the rms of $N$ above 200 Hz, against the
full model at 3.2 million steps a second. Further rows, without a picture: no loss in the contact, heights that make
several contacts (rms $z'' R/\beta$), and ever smaller inclination.
"""
IMPACT, ROLLING = "a lossless impact", "rolling on roughness"
UNDAMPED, SEVERAL, FLAT = "loss factor of the contact to 0", "rms(z'') R/beta beyond 1", "inclination to 0"
FINEST = 3.2e6
FULL, FILTER, RATE = "discrete gradient", "exact along the rigid motion", "{:g} 1/s"


def works(quick: bool) -> list[Work]:
    """Return every run; `quick` keeps both ends of every path."""
    rates, off = ends((1e5, 2e5, 4e5, 8e5, 1.6e6), quick), partial(_off, case.RMS, FINEST)
    runs = along("full", FULL, RATE, rates, case.impact, IMPACT, from_one, 0.1)
    for name, step in (("leap-frog", leap_frog), ("explicit Euler", explicit_euler)):
        slow, solve = ends((2.5e4, *rates), quick), partial(case.explicit_impact, step)
        runs += along("explicit", name, RATE, slow, solve, IMPACT, from_one, 0.1)
    runs.append(Work("rigid", "event-driven", "-", ROLLING, _rigid, off))
    runs += along("full", FULL, RATE, ends((1e5, 2e5, 4e5), quick), case.full, ROLLING, off)
    rates = ends((6e3, 1.2e4, 2.4e4, 4.8e4, 9.6e4, 1.92e5), quick)
    return [*runs, *along("filter", FILTER, RATE, rates, case.filtered, ROLLING, off, 0.1), *hazards(quick)]


def hazards(quick: bool) -> list[Work]:
    """Return the runs towards an edge; the setting is the place on the way."""
    runs = []
    for loss in ends((0.02, 0.002, 0.0), quick):
        for name, creeps in (("with creep", True), ("without creep", False)):
            runs.append(Work("full", name, f"{loss:g}", UNDAMPED, partial(case.undamped, loss, creeps), from_one))
    for rms in ends((1e-8, 3e-8, 1e-7, 3e-7, 1e-6), quick):
        call, off = partial(case.filtered, 9.6e4, rms=rms), partial(_off, rms, 4e5)
        runs.append(Work("filter", FILTER, f"{case.shift(rms):.2g}", SEVERAL, call, off, 0.1))
    return runs + along("full", FULL, "{:g}", ends((1e-2, 1e-4, 1e-6, 1e-7, 3e-8), quick), case.flat, FLAT, from_one)


def _rigid() -> Answer:
    """The event-driven motion of the same disk, whose force has nothing above AUDIBLE."""
    start = steady(case.table().law.disk, case.FLAT)
    release = f"release.inclination_deg={degrees(start[1])}", f"release.omega={start[5:8].tolist()}"
    changes = "contact.law=rigid", *release, f"numerics.time_limit={case.SECONDS}"
    return Answer((0.0,), len(simulate(load_scene("granite").replace(*changes)).t))


@cache
def _reference(rms: float, rate: float) -> float:
    return case.full(rate, rms=rms).values[0]


def _off(rms, rate, values) -> float:
    """Return how far off a force is from that of the full model in steps of 1/rate."""
    return abs(values[0] / _reference(rms, rate) - 1)


def run(quick: bool, watch=lambda share, note: None) -> list[Record]:
    """Return the records of the chart; `watch(share, note)` is called before every run."""
    return measured(works(quick), watch, warm=lambda work: work.case in (IMPACT, ROLLING))


def draw(records: list[Record], title: str, path):
    """Draw error against seconds of the two cases that have a reference."""
    chart.draw([r for r in records if r.case in (IMPACT, ROLLING)], title, "relative error", path)


def conclusion(records: list[Record]) -> list[str]:
    """Return what to take, and where each ends, in a sentence each."""
    full, light = (nearest(records, family=kind, case=ROLLING) for kind in ("full", "filter"))
    kept, gained = nearest(records, family="full", case=IMPACT), nearest(records, family="explicit")
    lines = [
        f"While contact is kept take the filter: {number(light.error)} of the rms in {milliseconds(light)} for "
        f"{case.SECONDS:g} s of motion at {light.setting}; the full model needs {milliseconds(full)} for "
        f"{number(full.error)}.",
        "The rigid contact has no force at these frequencies.",
        f"Of the impact the discrete gradient keeps the energy to round-off at any step, and its depth errs by "
        f"{number(kept.error)} at {kept.setting}; explicit steps, timed in one dimension, gain {number(gained.error)} "
        f"at {gained.setting}.",
    ]
    torn = [r for r in records if r.case == SEVERAL and r.failure]
    stuck = [r for r in records if r.case == UNDAMPED and r.failure]
    lines += [f"The filter fails from rms(z'') R/beta = {torn[0].setting} on: contact is lost."] if torn else []
    lines += [f"Without creep slips do not converge from a loss factor of {stuck[0].setting} on."] if stuck else []
    return lines
