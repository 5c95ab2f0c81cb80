"""The map of where methods fail: for every hazard a path to its edge, and on it what each method still gets right.

A run fails that gives up or gives nonsense; it is degraded where it errs more than the hazard's `fine`. The setting of
a record is its place on the path.
"""

from sonify.charts import stability_modes, stability_motion, stability_sound
from sonify.charts.hazards import DEGRADED, FAILED, FINE, HAZARDS, rows, state
from sonify.charts.hazards import draw as draw
from sonify.charts.records import WRONG, Record, measured

PROBLEM = r"""
Every hazard is a path: a parameter goes to its edge, and each method solves the same small problem at every place of
it. Motions obey $\dot y = f(y)$ with the set-valued laws (3.2), (3.3); oscillators
$\ddot q + 2 d \dot q + \omega^2 q = g$; elastic disks $K u = \omega^2 M u$, sought from a shift $\sigma$ on. References
are closed forms, quadruple precision, and converged solutions by another method.
"""


def run(quick: bool, watch=lambda share, note: None) -> list[Record]:
    """Return the records of the map; `quick` keeps both ends of every path."""
    works = [*stability_motion.works(quick), *stability_modes.works(quick)]
    records = stability_sound.records() + measured(works, watch, repeats=1)
    return sorted(records, key=lambda r: list(HAZARDS).index(r.case))


def conclusion(records: list[Record]) -> list[str]:
    """Return how to read the map, and on how many paths our methods and the others stay fine."""
    shown = [r for r in records if not r.left_out]
    paths = {"our": [], "other": []}
    for case in dict.fromkeys(r.case for r in shown):
        for (family, _), runs in rows([r for r in shown if r.case == case]).items():
            paths["our" if family == "ours" else "other"].append(all(state(r) == FINE for r in runs))
    return [
        "Choose a method that is fine as far towards the edge as you have to go: it fails where it gives up or gives "
        f"nonsense (a motion wrong by {100 * WRONG:g} %, a note by {stability_sound.ANOTHER_NOTE:g} cents, a frequency "
        f"by {100 * stability_modes.LOCKED:g} %), and is degraded where it errs by more than the table says.",
        *(f"Of {len(fine)} paths of {whose} methods {sum(fine)} are fine throughout." for whose, fine in paths.items()),
    ]


def tables(records: list[Record]) -> dict[str, list[list]]:
    """Return a table for every hazard: where on its path each method is degraded, and where it fails."""
    found = {}
    for case, hazard in HAZARDS.items():
        known = rows([r for r in records if r.case == case and not r.left_out])
        head = ["method", f"degraded (error above {hazard.fine:g})", "failed"]
        body = [
            [f"{family}: {method}", *(_where(runs, which) for which in (DEGRADED, FAILED))]
            for (family, method), runs in known.items()
        ]
        found |= {f"{hazard.title}: {hazard.label}": [head, *body]} if body else {}
    return found


def _where(runs, which):
    """Say at which places of a path, in its order, a method is degraded or fails."""
    places = [r.setting for r in runs if state(r) == which]
    if places and len(places) == len(runs):
        return "everywhere"
    if len(places) > 1 and places == [r.setting for r in runs][-len(places) :]:
        return f"from {places[0]} on"
    return ", ".join(places) or "-"
