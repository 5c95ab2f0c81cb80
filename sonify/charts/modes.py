"""The chart of the modes: the largest error of a frequency against seconds, on the patch and free."""

import math
import shutil
from functools import cache, partial
from importlib.util import find_spec

import numpy as np

from modal import FreeDisk, Support, eigenmodes
from modal.synthesis.patches import Richness
from sonify.charts.modes_case import ModesCase, modes_case
from sonify.charts.page import methods, number
from sonify.charts.peer_elements import calculix_modes, ngsolve_modes
from sonify.charts.plain_elements import ELEMENTS, plain_modes, strain_energy_error
from sonify.charts.records import LEFT_OUT, Answer, Failure, Record, Work, measured, nearest

PROBLEM = r"""
A steel disk, held on a patch of its lateral surface ($u = 0$ on an arc of 10 degrees over the full thickness, the clamp
of the paper) or free. Asked are the frequencies $\omega/2\pi$ below 20 kHz of

$$\int_\Omega \lambda \operatorname{tr}\varepsilon(u) \operatorname{tr}\varepsilon(v)
+ 2\mu\, \varepsilon(u) : \varepsilon(v) = \omega^2 \int_\Omega \rho\, u \cdot v \quad \text{for all } v, \qquad
2\varepsilon(u) = \nabla u + \nabla u^T.$$

At the edge of the patch $u \sim r^{1/2}$, which is why uniform elements converge slowly there.
"""
ACCURACIES = ("draft", "standard", "reference")
DEFAULT = "standard"
RICHNESSES = {
    "poor": Richness(size=(8, 4), direct=12, around=3, through=2, cutoff=1.8),
    "default": Richness(),
    "rich": Richness(size=(12, 8), around=6, through=5, cutoff=3.2),
}
PLAIN, CALCULIX, NGSOLVE = "uniform scikit-fem", "uniform CalculiX", "graded NGSolve"
MESHES = {
    ("patch", PLAIN, "P1 tetrahedra"): ((1, 1), (2, 2), (4, 4)),
    ("patch", PLAIN, "P2 tetrahedra"): ((1, 1), (2, 1), (4, 2)),
    ("patch", PLAIN, "Q2 hexahedra"): ((1, 1), (2, 1)),
    ("patch", CALCULIX, "P2 tetrahedra"): ((2, 1), (4, 2), (6, 3)),
    ("patch", CALCULIX, "Q2 hexahedra"): ((1, 1), (2, 1), (4, 2)),
    ("patch", NGSOLVE, "P2 tetrahedra"): ((2, 1), (4, 1), (6, 1)),
    ("patch", NGSOLVE, "P3 tetrahedra"): ((2, 1), (4, 1), (6, 1)),
    ("free", PLAIN, "P1 tetrahedra"): ((3, 2), (4, 4), (5, 4)),
    ("free", PLAIN, "P2 tetrahedra"): ((2, 1), (3, 1), (3, 2)),
    ("free", PLAIN, "Q2 hexahedra"): ((1, 1), (2, 1), (2, 2)),
    ("free", CALCULIX, "P2 tetrahedra"): ((2, 1), (3, 1), (3, 2)),
    ("free", CALCULIX, "Q2 hexahedra"): ((1, 1), (2, 1), (2, 2)),
    ("free", NGSOLVE, "P2 tetrahedra"): ((0, 1), (0, 2)),
    ("free", NGSOLVE, "P3 tetrahedra"): ((0, 1), (0, 2)),
}
"""Refinements (rows next to the rim, halvings at the edge of the patch) and layers of the thickness."""
LONG = [("patch", PLAIN, "Q2 hexahedra")]
"""Runs of ten seconds, which the quick chart leaves out."""
SOLVERS = {PLAIN: plain_modes, CALCULIX: calculix_modes, NGSOLVE: ngsolve_modes}
NEEDS = {CALCULIX: ("CalculiX", lambda: shutil.which("ccx")), NGSOLVE: ("NGSolve", lambda: find_spec("ngsolve"))}
"""Names of the programs that may not be there, and how to find them."""
WRONG = 0.3
"""A frequency further off than this, four semitones and a half, is another note."""
PROOF, NEAR = 1e-9, 0.1
"""Largest relative error of the energy of a uniform stretch, and of another program on a free disk."""


def ours(case: ModesCase, accuracy: str) -> Answer:
    """Return the frequencies [Hz] that `modal.eigenmodes` gives at an accuracy."""
    scene = case.scene.replace(f"numerics.accuracy={accuracy}")
    modes = eigenmodes(scene, below=1.1 * case.reference[-1])
    return Answer(tuple(modes.frequency[: len(case.reference)]), 0)


@cache
def known_disk(richness: str) -> FreeDisk:
    """Return the free disk, whose first patch has been paid for."""
    case = modes_case("patch")
    disk = FreeDisk(plate=case.plate, richness=RICHNESSES[richness])
    disk.frequencies(Support(), 1.1 * case.reference[-1])
    return disk


def synthesis(case: ModesCase, richness: str, known: bool) -> Answer:
    """Return the frequencies [Hz] by synthesis from a free disk, which is `known` from a patch before or is not."""
    disk = known_disk(richness) if known else FreeDisk(plate=case.plate, richness=RICHNESSES[richness])
    return Answer(tuple(disk.frequencies(Support(), 1.1 * case.reference[-1])[: len(case.reference)]), 0)


def missing(family: str) -> Answer:
    """Raise the Failure of a program that is not installed."""
    raise Failure(f"{LEFT_OUT}: {NEEDS[family][0]} is not installed")


def works(case: ModesCase, quick: bool) -> list[Work]:
    """Return every run on one case; `quick` leaves out settings, and what takes long."""

    def work(family, method, setting, function, *arguments):
        return Work(family, method, setting, case.name, partial(function, *arguments), case.error, WRONG)

    held = case.half_angle is not None
    method = "Q2 shapes, frequencies by synthesis" if held else "Fourier x polynomials"
    runs = [work("ours", method, a, ours, case, a) for a in (ACCURACIES[:2] if quick else ACCURACIES)]
    for known, name in ((False, "first patch"), (True, "further patch")) if held else ():
        for richness in ["default"] if quick else RICHNESSES:
            runs.append(work("ours", f"synthesis, {name}", richness, synthesis, case, richness, known))
    for (kind, family, element), meshes in MESHES.items():
        if kind != case.name or (quick and (kind, family, element) in LONG):
            continue
        if family in NEEDS and not NEEDS[family][1]():
            runs.append(work(family, element, "", missing, family))
            continue
        some = meshes[1:2] if family == PLAIN else meshes[:1]
        for refinements, layers in some if quick else meshes:
            setting = f"{refinements} refinements, {layers} layers"
            runs.append(work(family, element, setting, SOLVERS[family], case, element, refinements, layers))
    return runs


def prove() -> None:
    """Raise ArithmeticError unless every competitor has the same elasticity.

    scikit-fem's elements must hold the energy of a uniform stretch, the other programs come near the free disk.
    """
    case = modes_case("free")
    errors = {element: strain_energy_error(case, element) for element in ELEMENTS}
    wrong = [f"{element}: {error:.1e}" for element, error in errors.items() if not error < PROOF]
    for family, (name, there) in NEEDS.items():
        if there():
            mesh = (3, 1) if family == CALCULIX else (0, 1)
            error = case.error(SOLVERS[family](case, "P2 tetrahedra", *mesh).values)
            wrong += [] if error < NEAR else [f"{name}: {error:.1e}"]
    if wrong:
        raise ArithmeticError(f"not the same elasticity: {'; '.join(wrong)}")


def run(quick: bool, watch=lambda share, note: None) -> list[Record]:
    """Return the records of the chart; `watch(share, note)` is called before every run."""
    prove()
    runs = [w for kind in ("patch", "free") for w in works(modes_case(kind), quick)]
    return measured(runs, watch, warm=lambda work: work.family == "ours", repeats=1 if quick else 3)


def front(records: list[Record]) -> list[Record]:
    """Return the runs than which none is both faster and nearer, by their seconds."""
    best: list[Record] = []
    for r in sorted((r for r in records if math.isfinite(r.error)), key=lambda r: r.seconds):
        if not best or r.error < best[-1].error:
            best.append(r)
    return best


def seconds_at(runs: list[Record], error: float) -> tuple[float, bool]:
    """Return the seconds at which a front reaches an error, and whether that is extrapolated.

    Along the straight line through the front in the logarithms of seconds and error.
    """
    x, y = np.log([r.seconds for r in runs]), np.log([r.error for r in runs])
    if error >= runs[-1].error:
        return float(np.exp(np.interp(math.log(error), y[::-1], x[::-1]))), False
    slope, start = np.polyfit(x, y, 1)
    return float(np.exp((math.log(error) - start) / slope)), True


def conclusion(records: list[Record]) -> list[str]:
    """Return how much faster the default is at equal error, and what is nearest of all, for every case."""
    lines = []
    for case in dict.fromkeys(r.case for r in records):
        lines += _ratio(case, [r for r in records if r.case == case and math.isfinite(r.error)])
        if best := nearest(records, case=case):
            name = f"{best.family}, {best.method}, {best.setting}"
            lines.append(f"{case}: {name} comes nearest, {number(best.error)} in {best.seconds:.2g} s.")
    return lines


def tables(records: list[Record]) -> dict[str, list[list]]:
    """Return every run of our own, and the methods of every case."""
    ours = [[r.case, r.method, r.setting, number(r.error), f"{r.seconds:.2g}"] for r in records if r.family == "ours"]
    return {"Our methods": [["case", "method", "setting", "error", "seconds"], *ours]} | methods(records)


def _ratio(case, records):
    """Return the sentence that compares the default with plain elements at its own error."""
    default = next((r for r in records if r.family == "ours" and r.setting == DEFAULT), None)
    plain = front([r for r in records if r.family == PLAIN])
    if default is None or len(plain) < 2:
        return []
    seconds, extrapolated = seconds_at(plain, default.error)
    times, last = seconds / default.seconds, plain[-1]
    told = f"{case}: the default has an error of {number(default.error)} in {default.seconds:.2g} s; plain scikit-fem "
    if not extrapolated:
        return [f"{told}reaches that in {times:.0f} times as long."]
    measured = f"{number(last.error)} in {last.seconds:.2g} s, {last.seconds / default.seconds:.1f} times as long"
    return [
        f"{told}has at its best {measured}, and extrapolated along its own line it would take {times:.1g} times as "
        "long, which is no measurement."
    ]
