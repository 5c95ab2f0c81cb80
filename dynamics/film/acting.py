"""Does the film act on a motion? Decided from its scene alone, so that the same scene has one motion."""

from functools import lru_cache
from math import atan, inf, isfinite, radians, sin
from typing import NamedTuple

import numpy as np

from ..air import Air
from ..disk import Disk, Release
from ..dissipation import OwnLaw, resistance, together
from ..equations import law_of
from ..kinematics import energy
from ..steady import steady_precession
from ..time_left import steady_power
from .law import Film, film_under

MATTERS = 0.01
"""Share of the power that the film must take to be taken along."""
POINTS = 200
"""Inclinations at which a predicted motion is read."""


class Decision(NamedTuple):
    """The film that acts or None, why, and the predicted time [s] and inclination [rad] from which it takes MATTERS."""

    film: Film | None
    reason: str
    time: float = inf
    inclination: float = 0.0


def film_of(scene) -> Decision:
    """Return whether the film acts in a scene, which may have no air. Raises ValueError where it cannot but shall."""
    air = getattr(scene, "air", None)
    if air is None or air.film == "none":
        return Decision(None, "air.film = 'none'")
    disk, dissipation, numerics = scene.disk, getattr(scene, "dissipation", None), scene.numerics
    if air.film == "auto" and (why := _known_without(disk, air, dissipation)):
        return Decision(None, why)
    time, inclination = _from_when(
        disk, air, scene.friction, dissipation, scene.release, numerics.stopping_inclination(disk)
    )
    if air.film == "acts":
        return Decision(film_under(disk, air), "air.film = 'acts'", time, inclination)
    told = f"it is predicted to take {MATTERS:.0%} of the power from {time:.3g} s on, below {inclination:.2g} rad"
    if time >= numerics.time_limit:
        return Decision(None, f"{told}, after the time limit" if isfinite(time) else "it never takes as much", time)
    return Decision(film_under(disk, air), told, time, inclination)


def loads_of(scene, own: OwnLaw | None = None):
    """Return what acts on the disk of a scene beside its contact, None for nothing: its film, and its dissipation, or
    in place of that an `own` law."""
    return together(own or resistance(getattr(scene, "dissipation", None), scene.disk), film_of(scene).film)


def _known_without(disk: Disk, air: Air, dissipation) -> str:
    if not air.pressure:
        return "a vacuum has no film"
    if disk.shape != "solid":
        return "only the film under a solid disk is known"
    if dissipation and (dissipation.air_viscosity or dissipation.boundary_layer_viscosity):
        return "the scene has another law of the air, and they do not add"
    return ""


@lru_cache(64)
def _from_when(disk: Disk, air: Air, friction, dissipation, release: Release, end: float) -> tuple[float, float]:
    """The time [s] and inclination [rad] at which the film takes MATTERS of the power of a disk in steady decline.

    It starts from the steady motion that has the energy of the release, or from the steepest one.
    """
    law, _, beta, _, held, own, power = _decline(disk, air, friction, dissipation, end)
    given = energy(radians(release.inclination_deg), np.array(release.omega) * disk.time_unit, (0.0, 0.0), law)
    time = np.concatenate([[0.0], np.cumsum(np.diff(-held) * (1 / power[1:] + 1 / power[:-1]) / 2)])
    first = np.argmax((own >= MATTERS * power) & (held <= given))
    if own[first] < MATTERS * power[first]:
        return inf, 0.0
    since = time[first] - np.interp(-given, -held, time)
    return float(max(since, 0.0) * disk.time_unit), float(beta[first])


def carried_below(scene) -> float:
    """Return the inclination [rad] at which the film under a falling disk is predicted to bear its weight, 0 without a
    film or where it never does."""
    if film_of(scene).film is None:
        return 0.0
    end = scene.numerics.stopping_inclination(scene.disk)
    law, film, beta, turning, held, _, power = _decline(scene.disk, scene.air, scene.friction, scene.dissipation, end)
    lift = film.at(beta, (power / np.gradient(held, beta), None, turning))[2]
    return float(beta[lift > (law.K + 4) / 4].max(initial=0.0))


def _decline(disk, air, friction, dissipation, end):
    """The law, the film and, at falling inclinations (POINTS,) of a steady disk, these, omega_3, its energy, the film's
    power and the whole."""
    law, film, others = law_of(disk, friction), film_under(disk, air), resistance(dissipation, disk)
    steepest = 0.9 * atan((1 + 4 * law.h**2 / (3 * law.K)) / (2 * law.h))
    beta = np.geomspace(steepest, min(end, steepest / 2), POINTS)
    rate = np.array([steady_precession(b, law.h, law.K) * sin(b) for b in beta])
    held = energy(beta, (0.0, law.h * rate, rate), (0.0, 0.0), law)
    own = film.powers(beta, (0.0, law.h * rate, rate))[0]
    return law, film, beta, rate, held, own, own + np.array([steady_power(b, law, others) for b in beta])
