"""FILM + EXTERIOR FIELD -> PRESSURE: radiation of a rigid disk that vibrates over its film, by face
and rim.

In the wedge the pressure is constant across the gap, and viscosity and heat conduction act on the
air (Tijdeman 1975): div(m(h) grad p) + k^2 s(h) p = a, in the units of exterior_field.py. The flow
of the film meets the exterior field at the rim. There the pressure varies as -2/pi ln of the
distance from a line source in the corner, so the coupling is known for the local gap. Film and
exterior field together have resonances, which move little with the gap. See
tests/sound/test_open_film_sound.py."""

from dataclasses import dataclass
from functools import lru_cache
from math import log, pi, sqrt

import numpy as np
from scipy.interpolate import CubicSpline

from dynamics.air import HEAT_RATIO, PRANDTL

RIM_ORDERS = 4
"""Highest harmonic of the flow round the rim."""
WAVENUMBERS = np.concatenate(
    [
        [0.1],
        np.arange(0.5, 1.6, 0.25),
        np.arange(1.69, 2.4, 0.06),
        np.arange(2.5, 3.8, 0.15),
        np.arange(4, 6.1, 0.4),
    ]
)
"""Tabulated k R, densest near the resonances; the radiation is constant outside this range."""
EXTERIOR_WAVENUMBERS = np.linspace(WAVENUMBERS[0], WAVENUMBERS[-1], 16)
"""Values of k R at which the exterior field is solved; it has no resonance."""
MEAN_GAPS = np.append(np.geomspace(1e-4, 0.08, 8), [0.13, 0.2, 0.3, 0.43, 0.6])
"""Tabulated mean gaps over the radius, dense from 0.1 on, where resonances move; gaps outside the
range act as its nearest end."""
EXTERIOR_GAPS = (0.02, 0.2)
"""Mean gaps over the radius at which the exterior field is solved; it is linear in the gap up to
the larger one."""
MESH_CELLS = 8
"""Number of elements of the film's mesh along the radius."""
MESH_GRADING = 5.0
"""Grading of the film's mesh, the argument `nearest` of FilmMesh."""


@dataclass(frozen=True, kw_only=True, eq=False)
class RadiatedMultipoles:
    """Outgoing multipoles of a vibrating disk over its film, on a hemisphere.

    Attributes
    ----------
    far : float
        Radius of the hemisphere over that of the disk.
    multipoles : ndarray, shape (a, k, 2 RIM_ORDERS + 1, m, 3)
        Amplitudes over density and radius, at MEAN_GAPS (a,) and WAVENUMBERS (k,), of cos n theta
        and then of sin n theta, with the contact at x = -1. The last axis is the acceleration of
        the face: 1, x, and y.
    """

    far: float
    multipoles: np.ndarray

    def pressure_at(self, distance: float, elevation: float) -> np.ndarray:
        """Return the pressures (a, k, 2 RIM_ORDERS + 1, 3) over density and radius at a listener.

        The distance is in units of the radius, and theta is the listener's azimuth. The pressures
        are retarded to the centre of the disk."""
        from sonify.sound.exterior_field import listener_pressure  # scikit-fem loads slowly

        orders = [
            listener_pressure(n, WAVENUMBERS, self.far, distance, elevation)
            for n in range(RIM_ORDERS + 1)
        ]
        return np.einsum("akwml,wkm->akwl", self.multipoles, np.array(orders + orders[1:]))


@lru_cache(8)
def radiated_multipoles(disk, air) -> RadiatedMultipoles:
    """Return the multipoles that a solid disk radiates over a film of this air."""
    from dynamics.film.reynolds import FilmMesh

    thickness = disk.thickness / disk.radius
    mesh = FilmMesh(MESH_CELLS, nearest=MESH_GRADING)
    far = 1.5 * np.hypot(1.0, thickness + EXTERIOR_GAPS[-1])
    low, high = (_exterior_at_gap(thickness, gap, far) for gap in EXTERIOR_GAPS)
    multipoles = []
    for gap in MEAN_GAPS:
        part = (min(gap, EXTERIOR_GAPS[1]) - EXTERIOR_GAPS[0]) / (
            EXTERIOR_GAPS[1] - EXTERIOR_GAPS[0]
        )
        rim, exterior = (a + part * (b - a) for a, b in zip(low, high, strict=True))
        films = [film_at(mesh, gap, k, disk.radius, air) for k in WAVENUMBERS]
        multipoles.append(
            [couple_at_rim(gap, *fields) for fields in zip(films, rim, exterior, strict=True)]
        )
    return RadiatedMultipoles(far=far, multipoles=np.array(multipoles))


def film_at(mesh, gap: float, k: float, radius: float, air):
    """Return `FilmMesh.rim_flow_matrices` of the film for the face velocities 1, x, y.

    `gap` is the mean gap over the radius, `k` the wavenumber times the radius, `radius` in m.
    """
    from dynamics.film.reynolds import film_mobility

    x = mesh.points.real
    y = mesh.points.imag
    h = mesh.height
    layers = gap * radius * (1j * k * air.sound_speed / radius * air.density / air.viscosity) ** 0.5
    viscous, thermal = (film_mobility(h, c) * c * c / 12 for c in (layers, layers * sqrt(PRANDTL)))
    storage = -k * k * gap * (HEAT_RATIO * h - (HEAT_RATIO - 1) * thermal)
    return mesh.rim_flow_matrices(gap * viscous, storage, [np.ones_like(x), x, y], RIM_ORDERS)


def couple_at_rim(gap: float, film, rim, exterior, wedge: bool = True) -> np.ndarray:
    """Return the multipoles (2 RIM_ORDERS + 1, m, 3) of a film coupled to the exterior field.

    Parameters
    ----------
    gap : float
        Mean gap over the radius.
    film : tuple
        Result of `film_at`.
    rim : ndarray, shape (RIM_ORDERS + 1, 3)
        Exterior pressure at the rim by heave, tilt and flow, the flow of a line source over a gap
        of 1.
    exterior : ndarray, shape (RIM_ORDERS + 1, m, 3)
        Exterior multipoles of the same three.
    wedge : bool
        False for a uniform gap.
    """
    order = np.append(np.arange(RIM_ORDERS + 1), np.arange(1, RIM_ORDERS + 1))
    norm = pi * np.where(order == 0, 2.0, 1.0)
    # Rows of the waves that heave, tilt about y and tilt about x excite, their velocities, and the
    # exterior solutions.
    waves = (0, 1, RIM_ORDERS + 1)
    velocities = (0, 1, 2)
    solutions = (0, 1, 1)
    blocked = np.zeros((len(order), 3), complex)
    blocked[waves, velocities] = rim[order[[*waves]], solutions]
    out = np.zeros((len(order), exterior.shape[1], 3), complex)
    out[waves, :, velocities] = exterior[order[[*waves]], :, solutions]
    impedance = (
        np.diag(rim[order, 2] - 2 / pi * log(gap)) - 2 / pi * wedge * WEDGE_COUPLING / norm[:, None]
    )
    flow = np.linalg.solve(np.diag(norm) + film[1] @ impedance, film[0] - film[1] @ blocked)
    return out + exterior[order, :, 2][:, :, None] * flow[:, None]


def _wedge_coupling():
    """Return int ln(1 + cos t) W V dt over the waves W and V, (2 RIM_ORDERS + 1, 2 RIM_ORDERS + 1).

    The integral with cos j t is -2 pi ln 2 for j = 0, and 2 pi (-1)^(j + 1)/j otherwise.
    """
    n = np.append(
        np.arange(RIM_ORDERS + 1), -np.arange(1, RIM_ORDERS + 1)
    )  # negative orders are the sines
    difference = np.abs(np.subtract.outer(np.abs(n), np.abs(n)))
    total = np.add.outer(np.abs(n), np.abs(n))
    by_difference, by_total = (
        np.where(j == 0, -2 * pi * log(2), -2 * pi * (-1.0) ** j / np.maximum(j, 1))
        for j in (difference, total)
    )
    same_kind = (n[:, None] < 0) == (n < 0)
    return same_kind * (by_difference + np.where(n < 0, -1, 1) * by_total) / 2


WEDGE_COUPLING = _wedge_coupling()
"""Coupling of the harmonics of the rim flow by the gap's variation along the rim."""


def _exterior_at_gap(thickness, gap, far):
    """Return the exterior field at WAVENUMBERS (k,) of a disk over one gap.

    Pressures at the rim (k, RIM_ORDERS + 1, 3) and multipoles (k, RIM_ORDERS + 1, m, 3).
    """
    from sonify.sound.exterior_field import ExteriorField

    field = ExteriorField(thickness, gap, far)
    solutions = [field.solve(n, EXTERIOR_WAVENUMBERS) for n in range(RIM_ORDERS + 1)]
    rim, exterior = (np.stack(part, axis=1) for part in zip(*solutions, strict=True))
    rim[..., 2] += 2 / pi * log(gap)
    return [CubicSpline(EXTERIOR_WAVENUMBERS, part)(WAVENUMBERS) for part in (rim, exterior)]
