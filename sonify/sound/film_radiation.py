"""Compute the radiation of a rigid disk that vibrates above its air film.

The pressure in the wedge is constant across the gap, and losses by viscosity and heat
conduction are included (Tijdeman 1975): div(m(h) grad p) + k^2 s(h) p = a, in units of
the radius R, and of density times R times acceleration. At the rim the flow of the film drives the exterior field. The
pressure near a line source in the corner varies as -2/pi times the logarithm of the
distance; this determines the coupling at the local gap. The resonances of the coupled
film and exterior field depend only weakly on the gap. See
tests/sound/test_open_film_sound.py."""

from dataclasses import dataclass
from functools import lru_cache
from math import log, pi, sqrt
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from scipy.interpolate import CubicSpline

from dynamics.air import HEAT_CAPACITY_RATIO, PRANDTL_NUMBER, Air
from sonify.sound.multipoles import listener_pressure

if TYPE_CHECKING:
    from dynamics.disk import Disk
    from dynamics.film.reynolds import FilmMesh
    from sonify.sound.radiation import Listener

FilmMatrices = tuple[np.ndarray, np.ndarray]
"""Result of `FilmMesh.rim_flow_matrices`."""

MAX_RIM_ORDER = 4
"""Highest azimuthal harmonic of the flow out of the rim."""
TABULATED_WAVENUMBERS = np.concatenate(
    [
        [0.1],
        np.arange(0.5, 1.6, 0.25),
        np.arange(1.69, 2.4, 0.06),
        np.arange(2.5, 3.8, 0.15),
        np.arange(4, 6.1, 0.4),
    ]
)
"""Values of k R at which the radiation is tabulated, densest near the resonances;
outside the range the nearest value applies."""
RIM_ORDERS = np.append(np.arange(MAX_RIM_ORDER + 1), np.arange(1, MAX_RIM_ORDER + 1))
"""Azimuthal orders of the cosine waves, followed by those of the sine waves."""
FACE_WAVE_INDICES = [0, 1, MAX_RIM_ORDER + 1]
"""Indices of the waves excited by the face velocities 1, x and y: heave, tilt about y
and tilt about x. The exterior solution of a wave of order 0 is that of heave, and that
of a wave of order 1 is that of tilt."""
EXTERIOR_WAVENUMBERS = np.linspace(
    TABULATED_WAVENUMBERS[0], TABULATED_WAVENUMBERS[-1], 16
)
"""Values of k R at which the exterior field is tabulated; they may be sparse because it
has no resonances."""
EXTERIOR_TABLE_FILE = Path(__file__).with_name("exterior_field.npz")
"""Exterior field by finite elements, over thickness, gap and wavenumber; written by
benchmarks/references/exterior_field.py."""
TABULATED_MEAN_GAPS = np.append(
    np.geomspace(1e-4, 0.08, 8), [0.13, 0.2, 0.3, 0.43, 0.6]
)
"""Ratios of mean gap to radius at which the radiation is tabulated, densest above 0.1,
where the resonance frequencies vary; outside the range the nearest value applies."""
EXTERIOR_MEAN_GAPS = (0.02, 0.2)
"""Ratios of mean gap to radius at which the exterior field is tabulated. It is linear in
the gap up to the larger ratio and constant above."""


@dataclass(frozen=True, kw_only=True, eq=False)
class RadiatedMultipoles:
    """Multipoles radiated by a disk above its air film.

    Attributes
    ----------
    far : float
        Radius of the hemisphere, divided by that of the disk.
    multipoles : ndarray, shape (a, k, 2 MAX_RIM_ORDER + 1, m, 3)
        Amplitudes on a hemisphere, divided by density and radius, at TABULATED_MEAN_GAPS (a,) and
        TABULATED_WAVENUMBERS (k,). The cosine waves precede the sine waves; the contact is at x =
        -1. The last axis contains the responses to the face accelerations 1, x and y.
    rim_flow : ndarray, shape (a, k, 2 MAX_RIM_ORDER + 1, 3)
        Harmonics of the outflow per length of the rim, divided by the radius.
    """

    far: float
    multipoles: np.ndarray
    rim_flow: np.ndarray

    def pressure_at(self, distance: float, elevation: float) -> np.ndarray:
        """Return the pressures (a, k, 2 MAX_RIM_ORDER + 1, 3) at a listener, divided by
        density and radius.

        The distance is in units of the radius, and theta is the listener's azimuth. The
        propagation phase from the centre of the disk is removed."""
        orders = [
            listener_pressure(n, TABULATED_WAVENUMBERS, self.far, distance, elevation)
            for n in range(MAX_RIM_ORDER + 1)
        ]
        return np.einsum(
            "akwml,wkm->akwl", self.multipoles, np.array(orders + orders[1:])
        )

    def near_pressure_at(self, listener: "Listener", disk: "Disk") -> np.ndarray:
        """Return the result of `pressure_at` for a listener near the disk.

        The multipole series diverges there, so the sources are integrated directly.
        Scattering by the disk is neglected; see near_field.py."""
        from sonify.sound.near_field import rayleigh_waves

        face, rim = rayleigh_waves(
            listener, disk, TABULATED_WAVENUMBERS, MAX_RIM_ORDER + 1
        )
        pressure = self.rim_flow * np.hstack([rim, rim[:, 1:]])[:, :, None]
        pressure[:, :, FACE_WAVE_INDICES, range(len(FACE_WAVE_INDICES))] += face[
            :, RIM_ORDERS[FACE_WAVE_INDICES]
        ]
        return pressure


def film_mesh() -> "FilmMesh":
    """Return the mesh of the film."""
    from dynamics.film.reynolds import FilmMesh  # scikit-fem loads slowly

    radial_cells = 8
    return FilmMesh(radial_cells, nearest=5.0)


@lru_cache(8)
def radiated_multipoles(disk: "Disk", air: Air) -> RadiatedMultipoles:
    """Return the multipoles radiated by a solid disk above an air film."""
    thickness = disk.thickness / disk.radius
    mesh = film_mesh()
    low_gap, high_gap = EXTERIOR_MEAN_GAPS
    far = exterior_domain_radius(thickness)
    low, high = exterior_field(thickness)
    multipoles = []
    flows = []
    for gap in TABULATED_MEAN_GAPS:
        part = (min(gap, high_gap) - low_gap) / (high_gap - low_gap)
        rim, exterior = (a + part * (b - a) for a, b in zip(low, high, strict=True))
        films = [
            film_outflow_matrices(mesh, gap, k, disk.radius, air)
            for k in TABULATED_WAVENUMBERS
        ]
        flows.append(
            [flow_at_rim(gap, *fields) for fields in zip(films, rim, strict=True)]
        )
        multipoles.append(
            [multipoles_of(*fields) for fields in zip(flows[-1], exterior, strict=True)]
        )
    return RadiatedMultipoles(
        far=far, multipoles=np.array(multipoles), rim_flow=np.array(flows)
    )


def film_outflow_matrices(
    mesh: "FilmMesh", gap: float, k: float, radius: float, air: Air
) -> FilmMatrices:
    """Return `FilmMesh.rim_flow_matrices` of the film for the face velocities 1, x, y.

    `gap` is the mean gap divided by the radius, `k` the wavenumber times the radius;
    `radius` is in m.
    """
    from dynamics.film.reynolds import film_mobility

    x = mesh.points.real
    y = mesh.points.imag
    h = mesh.height
    layers = (
        gap
        * radius
        * (1j * k * air.sound_speed / radius * air.density / air.viscosity) ** 0.5
    )
    viscous, thermal = (
        film_mobility(h, c) * c * c / 12
        for c in (layers, layers * sqrt(PRANDTL_NUMBER))
    )
    storage = (
        -k * k * gap * (HEAT_CAPACITY_RATIO * h - (HEAT_CAPACITY_RATIO - 1) * thermal)
    )
    return mesh.rim_flow_matrices(
        np.asarray(gap * viscous), storage, [np.ones_like(x), x, y], MAX_RIM_ORDER
    )


def flow_at_rim(
    gap: float, film: FilmMatrices, rim: np.ndarray, wedge: bool = True
) -> np.ndarray:
    """Return the harmonics (2 MAX_RIM_ORDER + 1, 3) of the flow out of the rim of a
    film that is coupled to the exterior field.

    Parameters
    ----------
    gap : float
        Mean gap divided by the radius.
    film : tuple
        Result of `film_outflow_matrices`.
    rim : ndarray, shape (MAX_RIM_ORDER + 1, 3)
        Exterior pressure at the rim due to heave, tilt and flow; the flow is that of a
        line source above a gap of 1.
    wedge : bool
        False for a uniform gap.
    """
    order = RIM_ORDERS
    norm = pi * np.where(order == 0, 2.0, 1.0)
    blocked = np.zeros((len(order), 3), complex)
    face_order = order[FACE_WAVE_INDICES]
    blocked[FACE_WAVE_INDICES, range(len(FACE_WAVE_INDICES))] = rim[
        face_order, face_order
    ]
    impedance = (
        np.diag(rim[order, 2] - 2 / pi * log(gap))
        - 2 / pi * wedge * WEDGE_COUPLING / norm[:, None]
    )
    return np.linalg.solve(
        np.diag(norm) + film[1] @ impedance, film[0] - film[1] @ blocked
    )


def multipoles_of(flow: np.ndarray, exterior: np.ndarray) -> np.ndarray:
    """Return the multipoles (2 MAX_RIM_ORDER + 1, m, 3) of the face and of the flow out
    of the rim.

    `flow` is the result of `flow_at_rim`, and `exterior` (MAX_RIM_ORDER + 1, m, 3) are
    the multipoles due to heave, tilt and flow."""
    order = RIM_ORDERS
    out = np.zeros((len(order), exterior.shape[1], 3), complex)
    face_order = order[FACE_WAVE_INDICES]
    out[FACE_WAVE_INDICES, :, range(len(FACE_WAVE_INDICES))] = exterior[
        face_order, :, face_order
    ]
    return out + exterior[order, :, 2][:, :, None] * flow[:, None]


def _wedge_coupling_integrals() -> np.ndarray:
    """Return the integrals of ln(1 + cos t) W V for all pairs of waves W and V.

    The integral of ln(1 + cos t) cos j t is -2 pi ln 2 for j = 0, and 2 pi (-1)^(j +
    1)/j otherwise.
    """
    order = RIM_ORDERS
    is_sine = np.arange(len(order)) > MAX_RIM_ORDER
    difference = np.abs(np.subtract.outer(order, order))
    total = np.add.outer(order, order)
    by_difference, by_total = (
        np.where(j == 0, -2 * pi * log(2), -2 * pi * (-1.0) ** j / np.maximum(j, 1))
        for j in (difference, total)
    )
    same_kind = is_sine[:, None] == is_sine
    return same_kind * (by_difference + np.where(is_sine, -1, 1) * by_total) / 2


WEDGE_COUPLING = _wedge_coupling_integrals()
"""Coupling between harmonics of the rim flow, caused by the variation of the gap along
the rim."""


def exterior_domain_radius(thickness: float) -> float:
    """Return the radius of the hemisphere around a disk; both are divided by that of the
    disk."""
    return 1.5 * float(np.hypot(1.0, thickness + EXTERIOR_MEAN_GAPS[1]))


def exterior_field(thickness: float) -> list[list[np.ndarray]]:
    """Return the exterior field for both EXTERIOR_MEAN_GAPS at TABULATED_WAVENUMBERS (k,).

    `thickness` is divided by the radius; outside the range of the table the nearest value
    applies. The field consists of the pressures at the rim (k, MAX_RIM_ORDER + 1, 3) and
    of the multipoles (k, MAX_RIM_ORDER + 1, m, 3) of heave, tilt and flow.
    """
    with np.load(EXTERIOR_TABLE_FILE) as table:
        ratios = table["thickness"]
        inside = np.log(np.clip(thickness, ratios[0], ratios[-1]))
        rims, multipoles = (
            CubicSpline(np.log(ratios), table[name])(inside)
            for name in ("rim", "multipoles")
        )
    rims[..., 2] += 2 / pi * np.log(EXTERIOR_MEAN_GAPS)[:, None, None]
    return [
        [
            CubicSpline(EXTERIOR_WAVENUMBERS, part)(TABULATED_WAVENUMBERS)
            for part in (rim, amplitudes)
        ]
        for rim, amplitudes in zip(rims, multipoles, strict=True)
    ]
