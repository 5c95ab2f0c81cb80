"""The chart of the modes: the largest error of a frequency against seconds, on the patch and free."""

from functools import partial

from modal import eigenmodes
from sonify.charts.modes_case import ModesCase, modes_case
from sonify.charts.plain_elements import ELEMENTS, plain_modes, strain_energy_error
from sonify.charts.records import Answer, Record, Work, measure

ACCURACIES = ("draft", "standard", "reference")
MESHES = {
    "P1 tetrahedra": ((3, 2), (4, 4), (5, 4)),
    "P2 tetrahedra": ((2, 1), (3, 1), (3, 2)),
    "Q2 hexahedra": ((1, 1), (2, 1), (2, 2)),
}
"""Refinements of the circle and layers of the thickness."""
WRONG = 0.3
"""A frequency further off than this, four semitones and a half, is another note."""
PROOF = 1e-9
"""Largest relative error of the energy of a uniform stretch."""


def ours(case: ModesCase, accuracy: str) -> Answer:
    """Return the frequencies [Hz] that `modal.eigenmodes` gives at an accuracy."""
    scene = case.scene.replace(f"numerics.accuracy={accuracy}")
    modes = eigenmodes(scene, below=1.1 * case.reference[-1])
    return Answer(tuple(modes.frequency[: len(case.reference)]), 0)


def works(case: ModesCase, quick: bool) -> list[Work]:
    """Return every run on one case."""
    method = "graded Q2, symmetry classes" if case.half_angle is not None else "Fourier x polynomials"
    runs = [
        Work("ours", method, accuracy, case.name, partial(ours, case, accuracy), case.error, WRONG)
        for accuracy in (ACCURACIES[:2] if quick else ACCURACIES)
    ]
    for element, meshes in MESHES.items():
        for refinements, layers in meshes[:2] if quick else meshes:
            setting = f"{refinements} refinements, {layers} layers"
            call = partial(plain_modes, case, element, refinements, layers)
            runs.append(Work("uniform scikit-fem", element, setting, case.name, call, case.error, WRONG))
    return runs


def prove() -> None:
    """Raise ArithmeticError unless every competitor has the same elasticity: the energy of a uniform stretch."""
    case = modes_case("free")
    errors = {element: strain_energy_error(case, element) for element in ELEMENTS}
    wrong = [f"{element}: {error:.1e}" for element, error in errors.items() if not error < PROOF]
    if wrong:
        raise ArithmeticError(f"not the same elasticity: {'; '.join(wrong)}")


def run(quick: bool, watch=lambda share, note: None) -> list[Record]:
    """Return the records of the chart; `watch(share, note)` is called before every run."""
    prove()
    all_works, records = [w for kind in ("patch", "free") for w in works(modes_case(kind), quick)], []
    for i, work in enumerate(all_works):
        watch(i / len(all_works), f"{work.case}: {work.method}, {work.setting}")
        records.append(measure(work, warm=work.family == "ours", repeats=1 if quick else 3))
    return records


def conclusion(records: list[Record]) -> list[str]:
    """Return the errors and seconds of our settings, and the best that the others reach."""
    lines = [
        f"{r.case}: {r.method}, {r.setting}: largest error of a frequency {r.error:.1e} in {r.seconds:.2g} s."
        for r in records
        if r.family == "ours"
    ]
    for case, method in dict.fromkeys((r.case, r.method) for r in records if r.family != "ours"):
        good = [r for r in records if (r.case, r.method) == (case, method) and r.error == r.error]
        best = min(good, key=lambda r: r.error, default=None)
        if best:
            lines.append(f"{case}: uniform {method} come to {best.error:.1e} in {best.seconds:.2g} s at best.")
    lines.append("A uniform mesh knows where the patch ends to a node only; that is part of its error on the patch.")
    return lines
