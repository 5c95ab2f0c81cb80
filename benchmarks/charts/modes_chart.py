"""Chart the largest error of a frequency against processor time for the disk on its
patch and free."""

import math
import shutil
from functools import cache, partial
from importlib.util import find_spec

import numpy as np

from benchmarks.cases.modes_case import ModesCase, modes_case
from benchmarks.charts.chart_page import methods, number
from benchmarks.methods.plain_finite_elements import (
    ELEMENTS,
    plain_modes,
    strain_energy_error,
)
from benchmarks.peers.finite_element_programs import calculix_modes, ngsolve_modes
from benchmarks.timed_runs import (
    LEFT_OUT,
    Answer,
    Failure,
    Record,
    Work,
    measured,
    most_accurate,
)
from modal import FreeDisk, Support, eigenmodes
from modal.synthesis.free_disk import BasisSizes

PROBLEM = r"""
A steel disk is free, or held on a patch of its lateral surface ($u = 0$ on an arc of 10 degrees over the full
thickness, the clamp of the paper). The results are its frequencies $\omega/2\pi$ below 20 kHz:

$$\int_\Omega \lambda \operatorname{tr}\varepsilon(u) \operatorname{tr}\varepsilon(v)
+ 2\mu\, \varepsilon(u) : \varepsilon(v) = \omega^2 \int_\Omega \rho\, u \cdot v \quad \text{for all } v, \qquad
2\varepsilon(u) = \nabla u + \nabla u^T.$$

At the edge of the patch $u \sim r^{1/2}$; uniform elements therefore converge slowly there.
"""
ACCURACIES = ("draft", "standard", "reference")
DEFAULT_ACCURACY = "standard"
RICHNESSES = {
    "poor": BasisSizes(
        size=(8, 4),
        highest_direct_order=12,
        circumferential_tractions=3,
        thickness_tractions=2,
        cutoff=1.8,
    ),
    "default": BasisSizes(),
    "rich": BasisSizes(
        size=(12, 8), circumferential_tractions=6, thickness_tractions=5, cutoff=3.2
    ),
}
PLAIN = "uniform scikit-fem"
CALCULIX = "uniform CalculiX"
NGSOLVE = "graded NGSolve"
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
"""(Refinements, layers of the thickness) of each mesh.

The refinements are the rows next to the rim, or for NGSolve the halvings of the
elements at the edge of the patch. """

LONG_RUNS = [("patch", PLAIN, "Q2 hexahedra")]
"""Runs of ten seconds, omitted in the quick chart."""

SOLVERS = {PLAIN: plain_modes, CALCULIX: calculix_modes, NGSOLVE: ngsolve_modes}
OPTIONAL_PROGRAMS = {
    CALCULIX: ("CalculiX", lambda: shutil.which("ccx")),
    NGSOLVE: ("NGSolve", lambda: find_spec("ngsolve")),
}
"""Name and detection function of programs that may not be installed."""

MAX_FREQUENCY_ERROR = 0.3
"""Relative error of a frequency (four and a half semitones) above which a run counts as
failed."""

MAX_STRETCH_ERROR = 1e-9
"""Largest relative error of the energy of a uniform stretch in the proof."""

MAX_FREE_DISK_ERROR = 0.1
"""Largest relative error of another program on the free disk in the proof."""


def our_modes(case: ModesCase, accuracy: str) -> Answer:
    """Return the frequencies [Hz] of `modal.eigenmodes` at an accuracy."""
    scene = case.scene.replace(f"numerics.accuracy={accuracy}")
    modes = eigenmodes(scene, below=1.1 * case.reference[-1])
    return Answer(tuple(modes.frequency[: len(case.reference)]), 0)


@cache
def solved_disk(richness: str) -> FreeDisk:
    """Return a free disk with computed modes, after solving one patch."""
    case = modes_case("patch")
    disk = FreeDisk(plate=case.plate, richness=RICHNESSES[richness])
    disk.frequencies(Support(), 1.1 * case.reference[-1])
    return disk


def synthesis_modes(case: ModesCase, richness: str, known: bool) -> Answer:
    """Return the frequencies [Hz] by synthesis; with `known` the free disk has already
    solved another patch."""
    disk = (
        solved_disk(richness)
        if known
        else FreeDisk(plate=case.plate, richness=RICHNESSES[richness])
    )
    return Answer(
        tuple(
            disk.frequencies(Support(), 1.1 * case.reference[-1])[: len(case.reference)]
        ),
        0,
    )


def missing_program(family: str) -> Answer:
    """Raise the Failure of a program that is not installed."""
    raise Failure(f"{LEFT_OUT}: {OPTIONAL_PROGRAMS[family][0]} is not installed")


def works(case: ModesCase, quick: bool) -> list[Work]:
    """Return all runs on one case; with `quick`, some settings and long runs are
    omitted."""

    def work(family, method, setting, function, *arguments):
        return Work(
            family,
            method,
            setting,
            case.name,
            partial(function, *arguments),
            case.error,
            MAX_FREQUENCY_ERROR,
        )

    held = case.half_angle is not None
    method = "Q2 shapes, frequencies by synthesis" if held else "Fourier x polynomials"
    runs = [
        work("ours", method, a, our_modes, case, a)
        for a in (ACCURACIES[:2] if quick else ACCURACIES)
    ]
    for known, name in (
        ((False, "first patch"), (True, "further patch")) if held else ()
    ):
        for richness in ["default"] if quick else RICHNESSES:
            runs.append(
                work(
                    "ours",
                    f"synthesis, {name}",
                    richness,
                    synthesis_modes,
                    case,
                    richness,
                    known,
                )
            )
    for (kind, family, element), meshes in MESHES.items():
        if kind != case.name or (quick and (kind, family, element) in LONG_RUNS):
            continue
        if family in OPTIONAL_PROGRAMS and not OPTIONAL_PROGRAMS[family][1]():
            runs.append(work(family, element, "", missing_program, family))
            continue
        quick_meshes = meshes[1:2] if family == PLAIN else meshes[:1]
        for refinements, layers in quick_meshes if quick else meshes:
            setting = f"{refinements} refinements, {layers} layers"
            runs.append(
                work(
                    family,
                    element,
                    setting,
                    SOLVERS[family],
                    case,
                    element,
                    refinements,
                    layers,
                )
            )
    return runs


def prove() -> None:
    """Raise ArithmeticError if a method does not solve the same equations of
    elasticity.

    The elements of scikit-fem must reproduce the energy of a uniform stretch, the other
    programs the modes of the free disk."""
    case = modes_case("free")
    errors = {element: strain_energy_error(case, element) for element in ELEMENTS}
    wrong = [
        f"{element}: {error:.1e}"
        for element, error in errors.items()
        if not error < MAX_STRETCH_ERROR
    ]
    for family, (name, find) in OPTIONAL_PROGRAMS.items():
        if find():
            mesh = (3, 1) if family == CALCULIX else (0, 1)
            error = case.error(SOLVERS[family](case, "P2 tetrahedra", *mesh).values)
            if not error < MAX_FREE_DISK_ERROR:
                wrong.append(f"{name}: {error:.1e}")
    if wrong:
        raise ArithmeticError(f"not the same elasticity: {'; '.join(wrong)}")


def run(quick: bool, watch=lambda fraction, note: None) -> list[Record]:
    """Return the records of the chart; `watch(fraction, note)` is called before every
    run."""
    prove()
    runs = [w for kind in ("patch", "free") for w in works(modes_case(kind), quick)]
    return measured(
        runs, watch, warm=lambda work: work.family == "ours", repeats=1 if quick else 3
    )


def pareto_front(records: list[Record]) -> list[Record]:
    """Return the runs for which no other run is both faster and more accurate, in order
    of their time."""
    best: list[Record] = []
    for r in sorted(
        (r for r in records if math.isfinite(r.error)), key=lambda r: r.seconds
    ):
        if not best or r.error < best[-1].error:
            best.append(r)
    return best


def seconds_at(runs: list[Record], error: float) -> tuple[float, bool]:
    """Return the time [s] at which a Pareto front reaches an error, and whether it is
    extrapolated.

    The extrapolation follows the regression line of the front in the logarithms of
    seconds and error."""
    x = np.log([r.seconds for r in runs])
    y = np.log([r.error for r in runs])
    if error >= runs[-1].error:
        return float(np.exp(np.interp(math.log(error), y[::-1], x[::-1]))), False
    slope, start = np.polyfit(x, y, 1)
    return float(np.exp((math.log(error) - start) / slope)), True


def conclusion(records: list[Record]) -> list[str]:
    """Return sentences that compare the default with plain scikit-fem and name the most
    accurate run of each case."""
    lines = []
    for case in dict.fromkeys(r.case for r in records):
        lines += _comparison(
            case, [r for r in records if r.case == case and math.isfinite(r.error)]
        )
        if best := most_accurate(records, case=case):
            name = f"{best.family}, {best.method}, {best.setting}"
            lines.append(
                f"{case}: the most accurate run is {name}: {number(best.error)} in "
                f"{best.seconds:.2g} s."
            )
    return lines


def tables(records: list[Record]) -> dict[str, list[list]]:
    """Return the table of our runs and those of the methods of every case, by
    heading."""
    rows = [["case", "method", "setting", "error", "seconds"]]
    for r in records:
        if r.family == "ours":
            rows.append(
                [r.case, r.method, r.setting, number(r.error), f"{r.seconds:.2g}"]
            )
    return {"Our methods": rows} | methods(records)


def _comparison(case, records):
    """Return the sentence that compares the default with plain scikit-fem at the error
    of the default."""
    default = next(
        (r for r in records if r.family == "ours" and r.setting == DEFAULT_ACCURACY),
        None,
    )
    plain = pareto_front([r for r in records if r.family == PLAIN])
    if default is None or len(plain) < 2:
        return []
    seconds, extrapolated = seconds_at(plain, default.error)
    ratio = seconds / default.seconds
    subject = (
        f"{case}: the default has an error of {number(default.error)} in {default.seconds:.2g} s; "
        "plain scikit-fem"
    )
    if not extrapolated:
        return [f"{subject} takes {ratio:.0f} times as long for this error."]
    best = plain[-1]
    return [
        f"{subject} has at best {number(best.error)} in {best.seconds:.2g} s, "
        f"{best.seconds / default.seconds:.1f} times as long; extrapolated, not measured, it "
        f"would take {ratio:.1g} "
        "times as long for this error."
    ]
