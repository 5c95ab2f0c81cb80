"""Chart the error of the power of the air film against processor time for all
methods."""

from functools import cache, partial

import numpy as np

from benchmarks.charts.chart_page import number
from benchmarks.methods.rotating_film import (
    RotatingFilmMesh,
    compressible_wedge_response,
)
from benchmarks.timed_runs import (
    Answer,
    Failure,
    Record,
    measured,
    relative_error,
    works_over,
)
from dynamics import Air
from dynamics.disk import Disk
from dynamics.dissipation import Dissipation, power_laws
from dynamics.film.reynolds import FilmMesh
from dynamics.film.wedge import boundary_layer_ratio, compressibility_number, film_under
from dynamics.steady_motion import squared_rate_times_inclination
from sonify.scene import load_scene

PROBLEM = r"""
A disk of radius $R$ precesses steadily at the inclination $\beta$, with the contact at $x = -R$. The air in the gap
$h = \sin\beta\,(R + x)$ obeys Reynolds' equation

$$\nabla \cdot (p\, h^3 \nabla p) = 12 \mu\, \partial_t (p\, h), \qquad p = p_a \text{ at the rim},$$

It is incompressible if $\Lambda = 12 \mu \Omega / p_a \beta^2$ is small. If $S = h \sqrt{\Omega \rho / 2 \mu}$ is not
small, the factor of unsteady flow replaces $h^3$. The result is the power that the film of the published disk
dissipates. The reference is the power of unsteady flow on a fine mesh, times the ratio of compressible to
incompressible power on a coarser one.
"""
CASES = {"0.1 rad": 0.1, "0.01 rad": 0.01, "0.001 rad": 0.001}
"""Inclinations [rad] by the name of the case."""

MAX_POWER_ERROR = 0.3
"""Relative error of the power above which a run counts as failed; it shifts the end of
a motion by 0.1 s or more."""

UNSTEADY_REFERENCE_CELLS = 32
COMPRESSIBLE_REFERENCE_CELLS = 16
"""Mesh sizes of the reference."""


@cache
def disk_and_air() -> tuple[Disk, Air]:
    """Return the published disk and its air."""
    scene = load_scene("published")
    return scene.disk, scene.air


def precession_rate(beta: float) -> float:
    """Return the precession rate [rad/s] of a steady disk at a small inclination."""
    disk, _ = disk_and_air()
    return (
        squared_rate_times_inclination(disk.aspect, disk.gyration) / beta
    ) ** 0.5 / disk.time_unit


def power_factor(beta: float) -> float:
    """Return the factor of the dimensionless power I in the power [W]."""
    disk, air = disk_and_air()
    return (
        12 * air.viscosity * disk.radius**3 * precession_rate(beta) ** 2 / np.sin(beta)
    )


def incompressible_power(unsteady: bool, beta: float, cells: int) -> Answer:
    """Return the power [W] of incompressible air by finite elements, for steady or
    unsteady flow."""
    disk, air = disk_and_air()
    mesh = FilmMesh(cells, nearest=7.0)
    y = mesh.points.imag
    inertia = (
        (1 + 1j)
        * boundary_layer_ratio(beta, precession_rate(beta), disk.radius, air)
        * unsteady
    )
    return Answer(
        (
            -mesh.linear_responses([y], [y], inertia=inertia)[0].works[0].real
            * power_factor(beta),
        ),
        mesh.basis.N,
    )


def compressible_power(beta: float, cells: int) -> Answer:
    """Return the power [W] of compressible air in steady flow by finite elements.

    Raises Failure if Newton's method does not converge.
    """
    mesh = RotatingFilmMesh(cells, nearest=5.0)
    try:
        share = compressible_wedge_response(
            [compressibility_number(beta, precession_rate(beta), disk_and_air()[1])],
            mesh,
        )[1][0]
    except ArithmeticError:
        raise Failure("Newton's method does not converge") from None
    return Answer(
        (share * incompressible_power(False, beta, cells).values[0],), mesh.basis.N
    )


def closed_form_power(beta: float) -> Answer:
    """Return the power [W] by the closed form used in the motion."""
    disk, air = disk_and_air()
    w3 = precession_rate(beta) * np.sin(beta) * disk.time_unit
    unit = disk.mass * disk.radius**2 / disk.time_unit**3
    return Answer(
        (
            film_under(disk, air).rotation_and_fall_powers(beta, (0.0, 0.0, w3))[0]
            * unit,
        ),
        0,
    )


def power_law_estimate(beta: float, **law) -> Answer:
    """Return the power [W] by a published power law."""
    ((c, b),) = power_laws(Dissipation(**law), disk_and_air()[0])
    return Answer((c * precession_rate(beta) ** b,), 0)


@cache
def reference_power(beta: float) -> float:
    """Return the reference of the power [W]."""
    cells = COMPRESSIBLE_REFERENCE_CELLS
    ratio = (
        compressible_power(beta, cells).values[0]
        / incompressible_power(False, beta, cells).values[0]
    )
    return ratio * incompressible_power(True, beta, UNSTEADY_REFERENCE_CELLS).values[0]


def run(quick: bool, watch=lambda fraction, note: None) -> list[Record]:
    """Return the records of all methods in all cases; `watch(fraction, note)` is called
    before every run."""
    air = disk_and_air()[1]
    layer = {
        "boundary_layer_viscosity": air.viscosity / air.density,
        "air_density": air.density,
    }
    moffatt = partial(power_law_estimate, air_viscosity=air.viscosity)
    bildsten = partial(power_law_estimate, **layer)
    cells = (4, 8) if quick else (4, 8, 16)
    works = []
    for name, beta in CASES.items():
        measure = (name, relative_error((reference_power(beta),)), MAX_POWER_ERROR)
        works += works_over(
            "closed form",
            "I and the fit of inertia",
            "",
            [beta],
            closed_form_power,
            *measure,
        )
        works += works_over("estimate", "Moffatt", "", [beta], moffatt, *measure)
        works += works_over("estimate", "Bildsten", "", [beta], bildsten, *measure)
        for flow, solve in (
            ("incompressible, steady", partial(incompressible_power, False, beta)),
            ("incompressible, unsteady", partial(incompressible_power, True, beta)),
            ("compressible, steady", partial(compressible_power, beta)),
        ):
            works += works_over("elements", flow, "{} cells", cells, solve, *measure)
    return measured(works, watch, warm=lambda work: True)


def conclusion(records: list[Record]) -> list[str]:
    """Return one sentence per case: the errors of the closed form and of the published
    estimates."""
    lines = []
    for case in dict.fromkeys(r.case for r in records):
        own, moffatt, bildsten = (
            next(r for r in records if r.case == case and r.method.startswith(name))
            for name in ("I ", "Moff", "Bild")
        )
        lines.append(
            f"{case}: the relative error of the closed form is {number(own.error)}, in "
            f"{1e6 * own.seconds:.2g} us; "
            f"that of Moffatt's estimate is {number(moffatt.error)}, that of Bildsten's "
            f"{number(bildsten.error)}."
        )
    return lines
