"""Reaction of the air between the faces on the vibration of disk and table.

The filter of a rough contact neglects it; the plan states the change of level that it
would cause. Lever and inertia are those of the rigid disk.
"""

from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from scipy.integrate import trapezoid
from scipy.special import jve

from dynamics.air import Air
from dynamics.compliant.law.linear_response import force_per_height
from dynamics.compliant.law.roughness import ellipse_window, spectral_density
from dynamics.compliant.law.two_way_criterion import (
    level_weight,
    table_acceleration,
)
from dynamics.compliant.model_selection import steady_precession_rate
from dynamics.disk import Disk, inertias

if TYPE_CHECKING:
    from dynamics.motion_plan import MotionPlan


class FilmInertia(NamedTuple):
    """Complex inertia of the air between the faces; its negative imaginary part is a loss.

    Attributes
    ----------
    mass : ndarray, (f,)
        Force of the air in heave, divided by -w^2 z [kg].
    moment : ndarray, (f,)
        Moment in tilt about a diameter, divided by -w^2 theta [kg m^2].
    """

    mass: np.ndarray
    moment: np.ndarray


def film_inertia(radius: float, gap: float, air: Air, omega: np.ndarray) -> FilmInertia:
    """Return the inertia of a layer of air under a vibrating disk.

    The linear layer has a uniform gap and ambient pressure at the rim. It is viscous
    and compressible, p'' + p'/r + ... + kappa^2 p = -rho w^2 z/(h C), with C = 1 - tanh(q)/q,
    q = (h/2) sqrt(i w rho/mu) and kappa = w/(c sqrt(C)).

    Parameters
    ----------
    radius, gap : float
        Radius of the disk and gap [m].
    air : Air
        The air.
    omega : ndarray, (f,)
        Angular frequencies [rad/s].

    Returns
    -------
    FilmInertia
        The inertia; pi rho R^4/(8 h) and pi rho R^6/(96 h) in slow, inviscid flow.
    """
    if not air.density:
        none = np.zeros(len(omega), complex)
        return FilmInertia(none, none)
    q = gap / 2 * np.sqrt(1j * omega * air.density / air.viscosity)
    flow = 1 - np.tanh(q) / q
    x = omega / (air.sound_speed * np.sqrt(flow)) * radius
    stiffness = air.density * air.sound_speed**2 * np.pi / gap
    heave = radius**2 * (2 * jve(1, x) / (x * jve(0, x)) - 1)
    tilt = radius**4 * (jve(2, x) / (x * jve(1, x)) - 1 / 4)
    return FilmInertia(stiffness * heave / omega**2, stiffness * tilt / omega**2)


def disk_receptance(
    disk: Disk, lever: float, omega: np.ndarray, film: FilmInertia
) -> np.ndarray:
    """Return the receptance (f,) [m/N] of a rigid disk at a horizontal lever [m]."""
    mass = disk.mass + film.mass
    moment = inertias(disk)[0] + film.moment
    return -(1 / mass + lever**2 / moment) / omega**2


class _ContactInSteadyMotion(NamedTuple):
    """Spectrum of the heights in the contact at one inclination.

    Attributes
    ----------
    omega : ndarray, (f,)
        Angular frequencies [rad/s] of the waves with wave numbers `k` [1/m].
    heights : ndarray, (f,)
        Spectral density [m^3] of the heights, averaged over the contact ellipse.
    compliance : ndarray, (f,)
        Compliance [m/N] of the contact with the disk above it.
    """

    k: np.ndarray
    omega: np.ndarray
    heights: np.ndarray
    compliance: np.ndarray


def _contact_at(
    plan: "MotionPlan", inclination: float, lever: float, rate: float
) -> _ContactInSteadyMotion:
    """Return the contact at an inclination [rad], a lever [m] and a precession rate [rad/s]."""
    law = plan.tabulated_law
    roughness = plan.scene.roughness
    assert law is not None  # the contact is elastic
    assert roughness is not None
    disk = plan.scene.disk
    k, heights = spectral_density(roughness, disk.radius)
    omega = k * rate * lever
    beta = np.array([inclination])
    half_length = law.springs(beta, disk.weight)[1]
    system = law.linear_contact(beta, disk.weight, rate * lever)
    return _ContactInSteadyMotion(
        k,
        omega,
        heights * ellipse_window(k * half_length) ** 2,
        1 / force_per_height(system, omega),
    )


def film_level_change(plan: "MotionPlan", inclination: float) -> float:
    """Return the change [dB] of the A-weighted level of the table by the reaction of
    the air, at an inclination [rad] in steady motion.

    The air changes the receptance of the disk, and its force acts on the table below.
    """
    assert plan.tabulated_law is not None  # the contact is elastic
    disk = plan.scene.disk
    lever = abs(float(plan.tabulated_law.law.place(inclination).f))
    rate = steady_precession_rate(plan.scene, inclination)
    contact = _contact_at(plan, inclination, lever, rate)
    omega = contact.omega
    gap = disk.radius * np.sin(inclination)
    film = film_inertia(disk.radius, gap, plan.scene.air, omega)
    nothing = FilmInertia(0 * film.mass, 0 * film.moment)
    changed = disk_receptance(disk, lever, omega, film)
    changed = changed - disk_receptance(disk, lever, omega, nothing)
    without = contact.compliance + plan.contact_receptance(omega, rate)
    pressed = 1 - film.mass / (disk.mass + film.mass)
    weight = level_weight(omega / (2 * np.pi))
    weight *= contact.heights
    weight *= table_acceleration(plan.contact_receptance, omega)
    shares = (
        np.mean(np.abs(pressed / (without + changed)) ** 2, axis=0),
        np.mean(1 / np.abs(without) ** 2, axis=0),
    )
    with_air, without_air = (trapezoid(weight * part, contact.k) for part in shares)
    return float(10 * np.log10(with_air / without_air))
