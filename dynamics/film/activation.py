"""Decide from a scene whether its motion includes the air film."""

from math import asin, inf, isfinite, radians, sin
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from dynamics.air import Air
from dynamics.disk import Disk, Release
from dynamics.dissipation import resistance_of
from dynamics.equations import DiskConstants
from dynamics.film.wedge import NO_FLAT_FACE_MESSAGE, Film, film_of_scene, hole_share
from dynamics.kinematics import energy
from dynamics.quasi_steady import steady_power
from dynamics.solver_settings import MIN_RELEVANT_SHARE
from dynamics.steady_motion import max_steady_inclination, steady_omega

if TYPE_CHECKING:
    from dynamics.sections import MotionScene

END_KNUDSEN_NUMBER = 100.0
"""Knudsen number (mean free path divided by mean gap) at which a motion with a film
ends.

It is the upper limit of the tables of the kinetic theory of Fukui & Kaneko (1990).
There, a model with wall slip alone underestimates the air flow by a factor of 3.4.
"""


RATTLING_RING = (
    "the film of a ring is that of a rolling disk, without contacts anywhere on the rim"
)
"""Reason against a film under a ring that rattles."""


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
    airborne_inclination : float
        Predicted inclination [rad] below which the film supports the disk; 0 if it never
        does.
    """

    film: Film | None
    reason: str
    time: float = inf
    inclination: float = 0.0
    airborne_inclination: float = 0.0


def decide_film(scene: "MotionScene", constants: DiskConstants) -> FilmDecision:
    """Decide whether the motion of a scene with these constants includes the air film.

    Raises ValueError if the film is requested but impossible.
    """
    air = scene.air
    if air.film == "none":
        return FilmDecision(None, "air.film = 'none'")
    acts = air.film == "acts"
    disk = scene.disk
    if acts and is_rattling_ring(scene):
        raise ValueError(f"air.film = 'acts': {RATTLING_RING}")
    why = "" if acts else reason_against_film(scene)
    why = why or _rarefaction_warning(disk, air, scene.release)
    if why and acts:
        raise ValueError(
            f"{why}; set air.film = 'none', or increase the pressure or the inclination"
        )
    if why:
        return FilmDecision(None, why)
    film = film_of_scene(scene)
    descent = _quasi_steady_descent(scene, film, constants)
    time, inclination = _film_onset(descent, disk, scene.release, constants)
    onset = time, inclination, _airborne_inclination(descent, film, constants)
    if acts:
        return FilmDecision(film, "air.film = 'acts'", *onset)
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
    return FilmDecision(film, forecast, *onset)


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


def final_inclination(scene: "MotionScene", film: Film | None) -> float:
    """Return the inclination [rad] at which the motion of a scene counts as settled.

    It is determined by the numerics of the scene. With an air film, it is at least the
    inclination at which the Knudsen number equals END_KNUDSEN_NUMBER.
    """
    settled = scene.numerics.stopping_inclination(scene.disk)
    if film is None:
        return settled
    return max(settled, rarefied_inclination(scene.disk, scene.air, END_KNUDSEN_NUMBER))


def rarefied_inclination(disk: Disk, air: Air, knudsen: float) -> float:
    """Return the inclination [rad] at which the Knudsen number is `knudsen`."""
    return asin(min(1.0, air.mean_free_path / (knudsen * disk.radius)))


def reason_against_film(scene: "MotionScene") -> str:
    """Return the reason why air.film = 'auto' excludes the film, or "" if it does not."""
    dissipation = scene.dissipation
    if not scene.air.pressure:
        return "there is no film in a vacuum"
    if hole_share(scene) >= 1:
        return NO_FLAT_FACE_MESSAGE
    if is_rattling_ring(scene):
        return RATTLING_RING
    if dissipation.air_viscosity or dissipation.boundary_layer_viscosity:
        return "the scene already includes a dissipation law for the air"
    return ""


def is_rattling_ring(scene: "MotionScene") -> bool:
    """Return True if a ring is to have contacts anywhere on its rim."""
    return scene.disk.inner_radius > 0 and scene.numerics.contact == "many"


class _Descent(NamedTuple):
    """Quasi-steady motion at decreasing inclinations (k,) [rad], dimensionless.

    The powers (k,) are those dissipated by the film and in total.
    """

    inclination: np.ndarray
    omega_3: np.ndarray
    energy: np.ndarray
    film_power: np.ndarray
    power: np.ndarray


def _quasi_steady_descent(
    scene: "MotionScene", film: Film, constants: DiskConstants
) -> _Descent:
    """Return quasi-steady motion at 200 decreasing inclinations."""
    inclination_count = 200
    disk = scene.disk
    end = scene.numerics.stopping_inclination(disk)
    others = resistance_of(scene.dissipation, disk)
    steepest = 0.9 * max_steady_inclination(constants.h, constants.K, constants.fillet)
    beta = np.geomspace(steepest, min(end, steepest / 2), inclination_count)
    omega = np.array([steady_omega(b, constants) for b in beta]).T
    film_power = film.rotation_and_fall_powers(beta, omega)[0]
    other_power = np.array([steady_power(b, constants, others) for b in beta])
    return _Descent(
        beta,
        omega[2],
        energy(beta, omega, (0.0, 0.0), constants),
        film_power,
        film_power + other_power,
    )


def _film_onset(
    descent: _Descent, disk: Disk, release: Release, constants: DiskConstants
) -> tuple[float, float]:
    """Return the time [s] and inclination [rad] at which MIN_RELEVANT_SHARE is reached.

    They are predicted by quasi-steady motion that starts with the energy of the
    release, or from the steepest steady motion if that energy is larger.
    """
    beta, _, energies, film_power, power = descent
    release_energy = energy(
        radians(release.inclination_deg),
        np.array(release.omega) * disk.time_unit,
        (0.0, 0.0),
        constants,
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


def _airborne_inclination(
    descent: _Descent, film: Film, constants: DiskConstants
) -> float:
    """Return the greatest inclination [rad] at which the film supports the weight, or 0."""
    beta = descent.inclination
    falling = descent.power / np.gradient(descent.energy, beta)
    lift = film.moments_at(beta, (falling, None, descent.omega_3))[2]
    return float(beta[lift > (constants.K + 4) / 4].max(initial=0.0))
