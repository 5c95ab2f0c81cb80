"""The hazards of the map of failures, and what a run on the path to one is called."""

from typing import NamedTuple

from sonify.charts.records import Record
from sonify.charts.stability_sound import HEARD

FINE, DEGRADED, FAILED = "fine", "degraded", "failed"


class Hazard(NamedTuple):
    """What a path is about, the parameter along it, the error up to which a run is fine, whether its edge is low."""

    title: str
    label: str
    fine: float
    falls: bool


HAZARDS = {
    "small inclination": Hazard("Inclination to 0", "inclination at the start [rad]", 1e-6, True),
    "small slip": Hazard("Slip to 0", "slip speed that counts [R/chi], or the tolerance", 1e-6, True),
    "nutation sticks": Hazard("The nutation sticks", "arm k1/R (the published one is 1e-4)", 1e-6, False),
    "pivoting sticks": Hazard("The pivoting sticks", "arm k3/R (the published one is 8e-3)", 1e-6, False),
    "long steps": Hazard("Long steps", "step x angular frequency (cents out of tune)", HEARD, False),
    "near half the sample rate": Hazard("Around half the sample rate", "frequency over sample rate", 1e-2, False),
    "thin disk": Hazard("Thin disk", "thickness over radius", 0.05, True),
    "incompressible": Hazard("Poisson's ratio to 1/2", "1/2 - Poisson's ratio", 0.05, True),
    "shift": Hazard("Shift of the eigenproblem", "-shift over the first elastic eigenvalue", 1e-6, False),
    "point support": Hazard("Support to a point", "half angle of patch, or elements at its edge [degrees]", 0.02, True),
}
"""By the case of the records."""


def state(record: Record) -> str:
    """Return FINE, DEGRADED or FAILED."""
    if record.failure:
        return FAILED
    return FINE if record.error <= HAZARDS[record.case].fine else DEGRADED


def rows(records: list[Record]) -> dict[tuple[str, str], list[Record]]:
    """Return the records by (family, method), ours first."""
    keys = sorted(dict.fromkeys((r.family, r.method) for r in records), key=lambda key: key[0] != "ours")
    return {key: [r for r in records if (r.family, r.method) == key] for key in keys}
