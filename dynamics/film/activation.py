"""Decide from a scene alone whether the air film acts, so that every scene has a unique motion."""

from functools import lru_cache
from math import asin, inf, isfinite, radians, sin
from typing import NamedTuple

import numpy as np

from dynamics.air import Air
from dynamics.disk import Disk, Release
from dynamics.dissipation import OwnLaw, combined_loads, resistance_of
from dynamics.equations import disk_constants
from dynamics.film.wedge import Film, film_under
from dynamics.kinematics import energy
from dynamics.quasi_steady import steady_power
from dynamics.steady_motion import steady_precession, steepest_steady

MIN_FILM_SHARE = 0.01
"""Share of the power above which the film is part of the motion."""
MAX_KNUDSEN = 100.0
"""Knudsen number (mean free path divided by mean gap) at which a motion with a film ends.

At this number, a model with wall slip alone underestimates the air flow by a factor of 3.4 compared
with the kinetic theory of Fukui & Kaneko (1990), whose table ends there.
"""
INCLINATION_COUNT = 200
"""Number of inclinations in the predicted motion."""


class FilmDecision(NamedTuple):
    """Decision whether the air film acts on a motion.

    Attributes
    ----------
    film : Film or None
        The film, if it acts.
    reason : str
        Reason of the decision.
    time : float
        Predicted time [s] from which the film dissipates MIN_FILM_SHARE of the power.
    inclination : float
        Inclination [rad] at this time.
    """

    film: Film | None
    reason: str
    time: float = inf
    inclination: float = 0.0


def decide_film(scene) -> FilmDecision:
    """Decide whether the air film acts in a scene.

    Raises ValueError if the film is requested but impossible.
    """
    air = scene.air
    if air.film == "none":
        return FilmDecision(None, "air.film = 'none'")
    disk = scene.disk
    dissipation = scene.dissipation
    numerics = scene.numerics
    if air.film == "auto" and (why := _film_free_reason(disk, air, dissipation)):
        return FilmDecision(None, why)
    if rarefied := _rarefaction_warning(disk, air, scene.release):
        if air.film == "acts":
            raise ValueError(
                f"{rarefied}; take air.film = 'none', or a greater pressure or inclination"
            )
        return FilmDecision(None, rarefied)
    time, inclination = _film_onset(
        disk, air, scene.friction, dissipation, scene.release, numerics.stopping_inclination(disk)
    )
    if air.film == "acts":
        return FilmDecision(film_under(disk, air), "air.film = 'acts'", time, inclination)
    forecast = (
        f"it is predicted to take {MIN_FILM_SHARE:.0%} of the power from {time:.3g} s on, "
        f"below {inclination:.2g} rad"
    )
    if not isfinite(time):
        return FilmDecision(None, "its share stays smaller", time)
    # Impacts bring a rattling disk to rest earlier than predicted.
    if time >= numerics.time_limit and numerics.contact != "many":
        return FilmDecision(None, f"{forecast}, after the time limit", time)
    return FilmDecision(film_under(disk, air), forecast, time, inclination)


def _rarefaction_warning(disk: Disk, air: Air, release: Release) -> str:
    """Return a warning if the air under the disk is too rarefied for a film at the release.

    The warning is empty if a film is possible.
    """
    gap = disk.radius * sin(radians(release.inclination_deg))
    if not air.pressure or air.mean_free_path <= gap:
        return ""
    least = air.pressure * air.mean_free_path / gap
    return (
        f"air.pressure = {air.pressure:g}: must be at least {least:.3g} for a film, since the "
        f"mean free path, "
        f"{air.mean_free_path:.2g} m, exceeds the mean gap at the release, {gap:.2g} m"
    )


def final_inclination(scene) -> float:
    """Return the inclination [rad] at which the motion of a scene counts as settled.

    It follows from the numerics of the scene. With an acting film it is at least the inclination at
    which the Knudsen number reaches MAX_KNUDSEN.
    """
    settled = scene.numerics.stopping_inclination(scene.disk)
    if decide_film(scene).film is None:
        return settled
    return max(settled, rarefied_inclination(scene.disk, scene.air, MAX_KNUDSEN))


def rarefied_inclination(disk: Disk, air: Air, knudsen: float) -> float:
    """Return the inclination [rad] at which the air has the Knudsen number `knudsen`."""
    return asin(min(1.0, air.mean_free_path / (knudsen * disk.radius)))


def non_contact_loads(scene, own: OwnLaw | None = None):
    """Return the loads on the disk of a scene other than those of the contact, or None.

    They are the air film and the dissipation of the scene, or an `own` law in place of the
    dissipation.
    """
    return combined_loads(
        own or resistance_of(scene.dissipation, scene.disk),
        decide_film(scene).film,
    )


def _film_free_reason(disk: Disk, air: Air, dissipation) -> str:
    """Return the reason for which a scene has no film in the mode 'auto'; "" if it may have one."""
    if not air.pressure:
        return "a vacuum has no film"
    if disk.shape != "solid":
        return "only the film under a solid disk is known"
    if dissipation and (dissipation.air_viscosity or dissipation.boundary_layer_viscosity):
        return "the scene has another law of the air, and they do not add"
    return ""


@lru_cache(64)
def _film_onset(
    disk: Disk,
    air: Air,
    friction,
    dissipation,
    release: Release,
    end: float,
) -> tuple[float, float]:
    """Return time [s] and inclination [rad] at which the film takes MIN_FILM_SHARE of the power in
    a steady decline.

    The decline starts from the steady motion with the energy of the release, or from the steepest
    one.
    """
    law, _, beta, _, energies, film_power, power = _decline(disk, air, friction, dissipation, end)
    release_energy = energy(
        radians(release.inclination_deg),
        np.array(release.omega) * disk.time_unit,
        (0.0, 0.0),
        law,
    )
    time = np.concatenate(
        [[0.0], np.cumsum(np.diff(-energies) * (1 / power[1:] + 1 / power[:-1]) / 2)]
    )
    index = np.argmax((film_power >= MIN_FILM_SHARE * power) & (energies <= release_energy))
    if film_power[index] < MIN_FILM_SHARE * power[index]:
        return inf, 0.0
    delay = time[index] - np.interp(-release_energy, -energies, time)
    return float(max(delay, 0.0) * disk.time_unit), float(beta[index])


def airborne_inclination(scene) -> float:
    """Return the inclination [rad] below which the film of a falling disk supports its weight.

    The value is a prediction; it is 0 if the film never supports the weight.
    """
    if decide_film(scene).film is None:
        return 0.0
    end = scene.numerics.stopping_inclination(scene.disk)
    law, film, beta, turning, held, _, power = _decline(
        scene.disk,
        scene.air,
        scene.friction,
        scene.dissipation,
        end,
    )
    lift = film.at(beta, (power / np.gradient(held, beta), None, turning))[2]
    return float(beta[lift > (law.K + 4) / 4].max(initial=0.0))


def _decline(disk, air, friction, dissipation, end):
    """Return a steady decline at decreasing inclinations (INCLINATION_COUNT,).

    The result contains the law, the film, the inclinations, omega_3, the energy, the power of the
    film
    and the total power.
    """
    law = disk_constants(disk, friction)
    film = film_under(disk, air)
    others = resistance_of(dissipation, disk)
    steepest = 0.9 * steepest_steady(law.h, law.K)
    beta = np.geomspace(steepest, min(end, steepest / 2), INCLINATION_COUNT)
    rate = np.array([steady_precession(b, law.h, law.K) * sin(b) for b in beta])
    energies = energy(beta, (0.0, law.h * rate, rate), (0.0, 0.0), law)
    film_power = film.powers(beta, (0.0, law.h * rate, rate))[0]
    return (
        law,
        film,
        beta,
        rate,
        energies,
        film_power,
        film_power + np.array([steady_power(b, law, others) for b in beta]),
    )
