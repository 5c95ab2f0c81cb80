"""The map of where methods fail: for every hazard a path to its edge, and on it what each method still gets right.

A run fails that gives up or gives nonsense; it is degraded where it errs more than the hazard's `fine`. The setting of
a record is its place on the path.
"""

from sonify.charts import stability_modes, stability_motion, stability_sound
from sonify.charts.hazards import DEGRADED, FAILED, FINE, HAZARDS, rows, state
from sonify.charts.records import WRONG, Record, measure


def run(quick: bool, watch=lambda share, note: None) -> list[Record]:
    """Return the records of the map; `quick` keeps both ends of every path."""
    works = [*stability_motion.works(quick), *stability_modes.works(quick)]
    records = stability_sound.records()
    for i, work in enumerate(works):
        watch(i / len(works), f"{work.case}: {work.family}, {work.method}, {work.setting}")
        records.append(measure(work, repeats=1))
    order = list(HAZARDS)
    return sorted(records, key=lambda r: order.index(r.case))


def draw(records: list[Record], title: str, path):
    """Draw the map."""
    from sonify.charts.pictures import draw_map

    draw_map(records, title, path)


def conclusion(records: list[Record]) -> list[str]:
    """Return one sentence per hazard: what stays fine on the whole path, and from where on the others do not."""
    here = {case: [r for r in records if r.case == case and not r.left_out] for case in HAZARDS}
    return [_how_to_read(), *(_told(HAZARDS[case], runs) for case, runs in here.items() if runs)]


def _how_to_read():
    return (
        "Choose a method that is fine as far towards the edge as you have to go. It fails where it gives up, where a "
        f"motion is wrong by {100 * WRONG:g} %, a note by {stability_sound.ANOTHER_NOTE:g} cents, a frequency by "
        f"{100 * stability_modes.LOCKED:g} %; it is degraded where it errs by more than "
        + ", ".join(f"{hazard.fine:g} ({hazard.title})" for hazard in HAZARDS.values())
        + "."
    )


def _told(hazard, records):
    known = {f"{family} ({method})": runs for (family, method), runs in rows(records).items()}
    others = {name: _where(runs) for name, runs in known.items() if any(state(r) != FINE for r in runs)}
    fine = ", ".join(name for name in known if name not in others) or "nothing"
    rest = "; ".join(f"{name} {where}" for name, where in others.items())
    return f"{hazard.title} ({hazard.label}): {fine}: fine throughout." + (f" Not so: {rest}." if rest else "")


def _where(runs):
    """Say at which places of a path, in its order, a method is degraded and where it fails."""
    said = []
    for which in (DEGRADED, FAILED):
        places = [r.setting for r in runs if state(r) == which]
        if len(places) == len(runs):
            said.append(f"{which} everywhere")
        elif len(places) > 1 and places == [r.setting for r in runs][-len(places) :]:
            said.append(f"{which} from {places[0]} on")
        elif places:
            said.append(f"{which} at {', '.join(places)}")
    return " and ".join(said)
