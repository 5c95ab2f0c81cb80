"""Decide from a scene whether its motion includes the air film."""

from functools import lru_cache
from math import asin, inf, isfinite, radians, sin
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from dynamics.air import Air
from dynamics.disk import Disk, Release
from dynamics.dissipation import Dissipation, OwnLaw, combined_loads, resistance_of
from dynamics.equations import DiskConstants
from dynamics.film.wedge import Film, film_under
from dynamics.kinematics import energy
from dynamics.quasi_steady import steady_power
from dynamics.scene_constants import scene_constants
from dynamics.solver_settings import MIN_RELEVANT_SHARE
from dynamics.steady_motion import max_steady_inclination, steady_omega

if TYPE_CHECKING:
    from dynamics.sections import MotionScene

MAX_KNUDSEN_NUMBER = 100.0
"""Knudsen number (mean free path divided by mean gap) at which a motion with a film
ends.

It is the upper limit of the tables of the kinetic theory of Fukui & Kaneko (1990).
There, a model with wall slip alone underestimates the air flow by a factor of 3.4.
"""


class FilmDecision(NamedTuple):
    """Whether a motion includes the air film, with the reason.

    Attributes
    ----------
    film : Film or None
        The film, or None if it is not included.
    reason : str
        Reason for the decision.
    time : float
        Predicted time [s] at which the film starts to dissipate MIN_RELEVANT_SHARE of the
        power.
    inclination : float
        Inclination [rad] at this time.
    """

    film: Film | None
    reason: str
    time: float = inf
    inclination: float = 0.0


def decide_film(scene: "MotionScene") -> FilmDecision:
    """Decide whether the motion of a scene includes the air film.

    Raises ValueError if the film is requested but impossible.
    """
    air = scene.air
    if air.film == "none":
        return FilmDecision(None, "air.film = 'none'")
    acts = air.film == "acts"
    disk = scene.disk
    dissipation = scene.dissipation
    why = "" if acts else _film_free_reason(disk, air, dissipation)
    why = why or _rarefaction_warning(disk, air, scene.release)
    if why and acts:
        raise ValueError(
            f"{why}; set air.film = 'none', or increase the pressure or the inclination"
        )
    if why:
        return FilmDecision(None, why)
    law = scene_constants(scene)
    end = scene.numerics.stopping_inclination(disk)
    time, inclination = _film_onset(law, disk, air, dissipation, scene.release, end)
    film = film_under(disk, air, scene.surface.curvature)
    if acts:
        return FilmDecision(film, "air.film = 'acts'", time, inclination)
    forecast = (
        f"it is predicted to dissipate {MIN_RELEVANT_SHARE:.0%} of the power from {time:.3g} s on, "
        f"below {inclination:.2g} rad"
    )
    if not isfinite(time):
        reason = (
            f"its predicted share of the power remains below {MIN_RELEVANT_SHARE:.0%}"
        )
        return FilmDecision(None, reason, time)
    # Impacts bring a rattling disk to rest earlier than predicted
    if time >= scene.numerics.time_limit and scene.numerics.contact != "many":
        return FilmDecision(None, f"{forecast}, after the time limit", time)
    return FilmDecision(film, forecast, time, inclination)


def _rarefaction_warning(disk: Disk, air: Air, release: Release) -> str:
    """Return a warning if the air at the release is too rarefied for a film, else ""."""
    gap = disk.radius * sin(radians(release.inclination_deg))
    if not air.pressure or air.mean_free_path <= gap:
        return ""
    min_pressure = air.pressure * air.mean_free_path / gap
    return (
        f"air.pressure = {air.pressure:g}: must be at least {min_pressure:.3g} for a film, since the "
        f"mean free path, "
        f"{air.mean_free_path:.2g} m, exceeds the mean gap at the release, {gap:.2g} m"
    )


def final_inclination(scene: "MotionScene") -> float:
    """Return the inclination [rad] at which the motion of a scene counts as settled.

    It is determined by the numerics of the scene. With an air film, it is at least the
    inclination at which the Knudsen number equals MAX_KNUDSEN_NUMBER.
    """
    settled = scene.numerics.stopping_inclination(scene.disk)
    if decide_film(scene).film is None:
        return settled
    return max(settled, rarefied_inclination(scene.disk, scene.air, MAX_KNUDSEN_NUMBER))


def rarefied_inclination(disk: Disk, air: Air, knudsen: float) -> float:
    """Return the inclination [rad] at which the Knudsen number is `knudsen`."""
    return asin(min(1.0, air.mean_free_path / (knudsen * disk.radius)))


def non_contact_loads(scene: "MotionScene", own: OwnLaw | None = None) -> Any:
    """Return the loads on the disk other than those of the contact, or None.

    They are those of the air film and of the dissipation of the scene, which an `own`
    law replaces.
    """
    return combined_loads(
        own or resistance_of(scene.dissipation, scene.disk),
        decide_film(scene).film,
    )


def _film_free_reason(disk: Disk, air: Air, dissipation: Dissipation) -> str:
    """Return the reason why air.film = 'auto' excludes the film, or "" if it does not."""
    if not air.pressure:
        return "there is no film in a vacuum"
    if disk.shape != "solid":
        return "the model of the film is limited to solid disks"
    if dissipation.air_viscosity or dissipation.boundary_layer_viscosity:
        return "the scene already includes a dissipation law for the air"
    return ""


@lru_cache(64)
def _film_onset(
    law: DiskConstants,
    disk: Disk,
    air: Air,
    dissipation: Dissipation,
    release: Release,
    end: float,
) -> tuple[float, float]:
    """Return the time [s] and inclination [rad] at which MIN_RELEVANT_SHARE is reached.

    They are predicted by quasi-steady motion that starts with the energy of the
    release, or from the steepest steady motion if that energy is larger.
    """
    _, beta, _, energies, film_power, power = _quasi_steady_descent(
        law, disk, air, dissipation, end
    )
    release_energy = energy(
        radians(release.inclination_deg),
        np.array(release.omega) * disk.time_unit,
        (0.0, 0.0),
        law,
    )
    time = np.concatenate(
        [[0.0], np.cumsum(np.diff(-energies) * (1 / power[1:] + 1 / power[:-1]) / 2)]
    )
    index = np.argmax(
        (film_power >= MIN_RELEVANT_SHARE * power) & (energies <= release_energy)
    )
    if film_power[index] < MIN_RELEVANT_SHARE * power[index]:
        return inf, 0.0
    delay = time[index] - np.interp(-release_energy, -energies, time)
    return float(max(delay, 0.0) * disk.time_unit), float(beta[index])


def airborne_inclination(scene: "MotionScene") -> float:
    """Return the predicted inclination [rad] below which the film supports the disk.

    It is 0 if the film never supports the weight.
    """
    if decide_film(scene).film is None:
        return 0.0
    end = scene.numerics.stopping_inclination(scene.disk)
    law = scene_constants(scene)
    film, beta, turning, held, _, power = _quasi_steady_descent(
        law, scene.disk, scene.air, scene.dissipation, end
    )
    lift = film.moments_at(beta, (power / np.gradient(held, beta), None, turning))[2]
    return float(beta[lift > (law.K + 4) / 4].max(initial=0.0))


def _quasi_steady_descent(
    law: DiskConstants, disk: Disk, air: Air, dissipation: Dissipation, end: float
) -> tuple[Any, ...]:
    """Return quasi-steady motion at 200 decreasing inclinations.

    The results are the film, the inclinations [rad], and the dimensionless omega_3,
    energy, power dissipated by the film, and total power.
    """
    inclination_count = 200
    film = film_under(disk, air, law.bowl / disk.radius)
    others = resistance_of(dissipation, disk)
    steepest = 0.9 * max_steady_inclination(law.h, law.K, law.fillet)
    beta = np.geomspace(steepest, min(end, steepest / 2), inclination_count)
    omega = np.array([steady_omega(b, law) for b in beta]).T
    energies = energy(beta, omega, (0.0, 0.0), law)
    film_power = film.rotation_and_fall_powers(beta, omega)[0]
    return (
        film,
        beta,
        omega[2],
        energies,
        film_power,
        film_power + np.array([steady_power(b, law, others) for b in beta]),
    )
