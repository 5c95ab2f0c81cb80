"""FILM + AIR OUTSIDE -> what is heard of a disk that vibrates as a whole, whose face and whose rim both radiate.

In the wedge the pressure is even across the gap, and viscosity and heat hold the air there (Tijdeman 1975):
div(m(h) grad p) + k^2 s(h) p = a, in the units of outside.py. Its flow meets the air outside at the rim, where the
pressure goes as -2/pi ln of the distance from a line in the corner: so it is known for the gap at each place. Film and
air outside together have resonances, which stay where they are while the gap changes. tests/test_sound_open_film.py.
"""

from dataclasses import dataclass
from functools import lru_cache
from math import log, pi, sqrt

import numpy as np
from scipy.interpolate import CubicSpline

ORDERS = 4
"""Waves of the flow round the rim."""
NUMBERS = np.concatenate(
    [[0.1], np.arange(0.5, 1.6, 0.25), np.arange(1.69, 2.4, 0.06), np.arange(2.5, 3.8, 0.15), np.arange(4, 6.1, 0.4)]
)
"""Numbers k R at which it is solved: near the resonances closely. Below and above, what is heard stays."""
SMOOTH = np.linspace(NUMBERS[0], NUMBERS[-1], 16)
"""Numbers k R at which the air outside is solved, which has no resonance."""
GAPS = np.append(np.geomspace(1e-4, 0.08, 8), [0.13, 0.2, 0.3, 0.43, 0.6])
"""Mean gaps over the radius; a wider one acts as the last, a closer one as the first. From 0.1 on resonances move."""
STANDS = 0.02, 0.2
"""Mean gaps on which the disk stands outside; below and between them the air there changes in proportion."""
CELLS, NEAREST = 8, 5.0
"""Of the film's mesh."""
NEAR = 1.5
"""Radius of the hemisphere outside over the distance of the edge from the centre."""
HEATS, PRANDTL = 1.4, 0.71
"""Ratio of the specific heats of air, and viscosity over the diffusivity of heat."""


@dataclass(frozen=True, kw_only=True, eq=False)
class Radiated:
    """Multipoles (a, k, 2 ORDERS + 1, m, 3) on the hemisphere `far`, over density and radius, of a disk whose face has
    the acceleration 1, x, and y: over mean gaps GAPS (a,), at NUMBERS (k,), of cos n theta and then sin n theta, where
    the contact is at x = -1."""

    far: float
    multipoles: np.ndarray

    def at(self, distance: float, elevation: float) -> np.ndarray:
        """Return the pressures (a, k, 2 ORDERS + 1, 3) over density and radius at a listener; the distance is over the
        radius, theta his azimuth; retarded to the centre."""
        from sonify.sound.outside import heard  # scikit-fem loads slowly

        orders = [heard(n, NUMBERS, self.far, distance, elevation) for n in range(ORDERS + 1)]
        return np.einsum("akwml,wkm->akwl", self.multipoles, np.array(orders + orders[1:]))


@lru_cache(8)
def radiated(disk, air) -> Radiated:
    """Return what a solid disk radiates over the film of this air."""
    from dynamics.film.reynolds import FilmMesh

    thickness, mesh = disk.thickness / disk.radius, FilmMesh(CELLS, nearest=NEAREST)
    far = NEAR * np.hypot(1.0, thickness + STANDS[-1])
    low, high = (_outside(thickness, gap, far) for gap in STANDS)
    multipoles = []
    for gap in GAPS:
        part = (min(gap, STANDS[1]) - STANDS[0]) / (STANDS[1] - STANDS[0])
        rim, beyond = (a + part * (b - a) for a, b in zip(low, high, strict=True))
        films = [film_at(mesh, gap, k, disk.radius, air) for k in NUMBERS]
        multipoles.append([coupled(gap, *one) for one in zip(films, rim, beyond, strict=True)])
    return Radiated(far=far, multipoles=np.array(multipoles))


def film_at(mesh, gap: float, k: float, radius: float, air):
    """Return `FilmMesh.at_rim` of a film of a mean `gap` over the radius, the number k, for the velocities 1, x, y."""
    from dynamics.film.reynolds import mobility_of

    x, y, h = mesh.points.real, mesh.points.imag, mesh.height
    layers = gap * radius * (1j * k * air.sound_speed / radius * air.density / air.viscosity) ** 0.5
    moves, warms = (mobility_of(h, c) * c * c / 12 for c in (layers, layers * sqrt(PRANDTL)))
    storage = -k * k * gap * (HEATS * h - (HEATS - 1) * warms)
    return mesh.at_rim(gap * moves, storage, [np.ones_like(x), x, y], ORDERS)


def coupled(gap: float, film, rim, beyond, wedge: bool = True) -> np.ndarray:
    """Return the multipoles (2 ORDERS + 1, m, 3) of a `film` at its rim that meets the air outside.

    `rim` (ORDERS + 1, 3) are the pressures there of heave, tilt and flow, of a line over a gap 1, and `beyond` (ORDERS
    + 1, m, 3) the multipoles; without a `wedge` the gap is even.
    """
    order = np.append(np.arange(ORDERS + 1), np.arange(1, ORDERS + 1))
    size = pi * np.where(order == 0, 2.0, 1.0)
    turned, own, face = (0, 1, ORDERS + 1), (0, 1, 2), (0, 1, 1)
    held, out = np.zeros((len(order), 3), complex), np.zeros((len(order), beyond.shape[1], 3), complex)
    held[turned, own] = rim[order[[*turned]], face]
    out[turned, :, own] = beyond[order[[*turned]], :, face]
    meets = np.diag(rim[order, 2] - 2 / pi * log(gap)) - 2 / pi * wedge * CORNER / size[:, None]
    flow = np.linalg.solve(np.diag(size) + film[1] @ meets, film[0] - film[1] @ held)
    return out + beyond[order, :, 2][:, :, None] * flow[:, None]


def _corner():
    """int ln(1 + cos t) W V dt over the waves W, V: of cos j t it is -2 pi ln 2 for j = 0, 2 pi (-1)^(j + 1)/j."""
    n = np.append(np.arange(ORDERS + 1), -np.arange(1, ORDERS + 1))  # the sines below 0
    apart, both = np.abs(np.subtract.outer(np.abs(n), np.abs(n))), np.add.outer(np.abs(n), np.abs(n))
    wave = [np.where(j == 0, -2 * pi * log(2), -2 * pi * (-1.0) ** j / np.maximum(j, 1)) for j in (apart, both)]
    alike = (n[:, None] < 0) == (n < 0)
    return alike * (wave[0] + np.where(n < 0, -1, 1) * wave[1]) / 2


CORNER = _corner()


def _outside(thickness, gap, far):
    """Pressures at the rim (k, ORDERS + 1, 3) and multipoles (k, ORDERS + 1, m, 3) at NUMBERS of a disk on one gap."""
    from sonify.sound.outside import Outside

    air = Outside(thickness, gap, far)
    rim, beyond = (
        np.stack(part, axis=1) for part in zip(*(air.answers(n, SMOOTH) for n in range(ORDERS + 1)), strict=True)
    )
    rim[..., 2] += 2 / pi * log(gap)
    return [CubicSpline(SMOOTH, part)(NUMBERS) for part in (rim, beyond)]
