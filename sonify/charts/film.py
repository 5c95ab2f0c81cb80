"""The chart of the film: error of its drag against seconds, for closed form, elements and the papers' estimates."""

from functools import cache, partial

import numpy as np

from dynamics import Air
from dynamics.disk import Disk
from dynamics.dissipation import Dissipation, power_laws
from dynamics.film.law import compressibility, film_under, thickness
from dynamics.film.reynolds import FilmMesh, compressible
from dynamics.steady import flat_square
from sonify.charts.page import number
from sonify.charts.records import Answer, Failure, Record, along, measured, relative
from sonify.scene import load_scene

PROBLEM = r"""
The air under a disk of radius $R$ that turns steadily at the inclination $\beta$, contact at $x = -R$, gap
$h = \sin\beta\,(R + x)$: Reynolds' equation

$$\nabla \cdot (p\, h^3 \nabla p) = 12 \mu\, \partial_t (p\, h), \qquad p = p_a \text{ at the rim},$$

incompressible where $\Lambda = 12 \mu \Omega / p_a \beta^2$ is small; $h^3$ is that of unsteady flow where
$S = h \sqrt{\Omega \rho / 2 \mu}$ is not. Asked is the power that it takes of the published disk. The reference is a
fine mesh, of unsteady flow, times the share that compressible air takes on another.
"""
CASES = {"0.1 rad": 0.1, "0.01 rad": 0.01, "0.001 rad": 0.001}
WRONG = 0.3
"""A drag that is further off moves the end of a motion by a tenth of a second and more."""
FINE, COMPRESSED = 32, 16
"""Cells of the meshes of the reference."""


@cache
def disk_and_air() -> tuple[Disk, Air]:
    """Return the published disk and its air."""
    scene = load_scene("published")
    return scene.disk, scene.air


def rate(beta: float) -> float:
    """Return the precession rate [rad/s] of a steady disk at a small inclination."""
    disk, _ = disk_and_air()
    return (flat_square(disk.aspect, disk.gyration) / beta) ** 0.5 / disk.time_unit


def scale(beta: float) -> float:
    """Return what stands before I in the power [W]."""
    disk, air = disk_and_air()
    return 12 * air.viscosity * disk.radius**3 * rate(beta) ** 2 / np.sin(beta)


def elements(unsteady: bool, beta: float, cells: int) -> Answer:
    """Return the power [W] of incompressible air, by elements, of steady or of unsteady flow."""
    disk, air = disk_and_air()
    mesh = FilmMesh(cells)
    y = mesh.points.imag
    inertia = (1 + 1j) * thickness(beta, rate(beta), disk.radius, air) * unsteady
    return Answer((-mesh.linear([y], [y], inertia=inertia)[0].works[0].real * scale(beta),), mesh.basis.N)


def squeezed(beta: float, cells: int) -> Answer:
    """Return the power [W] of compressible air of steady flow, by elements; they fail where they find no solution."""
    mesh = FilmMesh(cells, nearest=5.0)
    try:
        share = compressible([compressibility(beta, rate(beta), disk_and_air()[1])], mesh)[1][0]
    except ArithmeticError:
        raise Failure("Newton's method does not converge") from None
    return Answer((share * elements(False, beta, cells).values[0],), mesh.basis.N)


def closed(beta: float) -> Answer:
    """Return the power [W] by the law of the motion."""
    disk, air = disk_and_air()
    w3 = rate(beta) * np.sin(beta) * disk.time_unit
    unit = disk.mass * disk.radius**2 / disk.time_unit**3
    return Answer((film_under(disk, air).powers(beta, (0.0, 0.0, w3))[0] * unit,), 0)


def estimate(beta: float, **law) -> Answer:
    """Return the power [W] by a paper's law."""
    ((c, b),) = power_laws(Dissipation(**law), disk_and_air()[0])
    return Answer((c * rate(beta) ** b,), 0)


@cache
def reference(beta: float) -> float:
    """Return the power [W] that is taken as true."""
    share = squeezed(beta, COMPRESSED).values[0] / elements(False, beta, COMPRESSED).values[0]
    return share * elements(True, beta, FINE).values[0]


def run(quick: bool, watch=lambda share, note: None) -> list[Record]:
    """Return the records of every method on every case."""
    air = disk_and_air()[1]
    layer = {"boundary_layer_viscosity": air.viscosity / air.density, "air_density": air.density}
    moffatt, bildsten = partial(estimate, air_viscosity=air.viscosity), partial(estimate, **layer)
    works = []
    for name, beta in CASES.items():
        judged, cells = (name, relative((reference(beta),)), WRONG), (4, 8) if quick else (4, 8, 16)
        works += along("closed form", "I and the fit of inertia", "", [beta], closed, *judged)
        works += along("estimate", "Moffatt", "", [beta], moffatt, *judged)
        works += along("estimate", "Bildsten", "", [beta], bildsten, *judged)
        for flow, solve in (
            ("incompressible, steady", partial(elements, False, beta)),
            ("incompressible, unsteady", partial(elements, True, beta)),
            ("compressible, steady", partial(squeezed, beta)),
        ):
            works += along("elements", flow, "{} cells", cells, solve, *judged)
    return measured(works, watch, warm=lambda work: True)


def conclusion(records: list[Record]) -> list[str]:
    """Return for every case how far the closed form is, and how far the papers' estimates are, in a sentence each."""
    lines = []
    for case in dict.fromkeys(r.case for r in records):
        own, moffatt, bildsten = (
            next(r for r in records if r.case == case and r.method.startswith(name)) for name in ("I ", "Moff", "Bild")
        )
        lines.append(
            f"{case}: the closed form is within {number(own.error)} in {1e6 * own.seconds:.2g} us; Moffatt's estimate "
            f"is off by {number(moffatt.error)}, Bildsten's by {number(bildsten.error)}."
        )
    return lines
