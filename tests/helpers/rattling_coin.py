"""A coin of two euros that rattles, with the contact modulus and the heights of a test."""

from math import pi, radians, sin, sqrt

import numpy as np
from scipy.ndimage import uniform_filter1d
from scipy.signal import butter, find_peaks, firwin, oaconvolve, sosfiltfilt

from dynamics import plan_motion
from dynamics.disk import GRAVITY
from dynamics.rattling.rattling_motion import (
    rattling_model,
    rolling_state_at_release,
    simulate_rattling,
)
from dynamics.steady_motion import contact_height_to_radius_ratio, steady_precession
from sonify import load_scene

RADIUS = 12.875e-3
CIRCUMFERENCE = 2 * pi * RADIUS
CLICK_BANDS = (1e3, 5e3), (5e3, 9.5e3), (1e3, 20e3)
"""Bands [Hz] in which clicks are compared: below the lines of the coin, and all."""


def coin(rms=1e-6, exponent=1.0, restitution=0.5, seed=0, inclination=0.1, *changes):
    """Return the scene of a coin that rolls steadily at an inclination [rad], orders 2 to 300."""
    aspect = 2.2e-3 / (2 * RADIUS)
    time_unit = sqrt(5 / 4 * RADIUS / GRAVITY)
    fillet = 5e-4 / RADIUS
    turning = (
        steady_precession(inclination, aspect, 1.0, fillet)
        / time_unit
        * sin(inclination)
    )
    spin = [
        0.0,
        contact_height_to_radius_ratio(inclination, aspect, fillet) * turning,
        turning,
    ]
    return load_scene("coin-polished").replace(
        "disk.radius=0.012875",
        "disk.thickness=0.0022",
        "disk.mass=0.0085",
        "numerics.contact=many",
        f"contact.restitution={restitution}",
        "contact.body=rigid",
        "friction.mu_dynamic=0",
        "friction.arm_nutation=0",
        "friction.arm_pivoting=0",
        "air.film=none",
        "dissipation.contour_moment=0",
        f"roughness.rms={rms}",
        "roughness.rms_edge=0",
        f"roughness.longest={CIRCUMFERENCE / 1.99}",
        f"roughness.shortest={CIRCUMFERENCE / 300.5}",
        f"roughness.exponent={exponent}",
        f"roughness.seed={seed}",
        f"release.inclination_deg={np.degrees(inclination)}",
        f"release.omega={spin}",
        *changes,
    )


def model_of(scene, heights=None, modes=None):
    """Return the model of a scene with E* = 40 GPa, and with other heights if given, on a table with
    modes or at rest.
    """
    model = rattling_model(plan_motion(scene))
    constants = model.constants._replace(modulus=40e9)
    model = model._replace(constants=constants, modes=modes)
    return model if heights is None else model._replace(heights=heights)


def settle(model, scene, last, time_limit=5.0):
    state = rolling_state_at_release(
        model, radians(scene.release.inclination_deg), scene.release.omega
    )
    return simulate_rattling(model, state, time_limit, last * RADIUS)


def wave(order, amplitude, points=8192):
    return amplitude * np.cos(order * 2 * pi * np.arange(points) / points)


def decay_after_bursts(samples, rate, line):
    """Return the median rate [1/s] at which the amplitude of a line [Hz] falls after its maxima."""
    half_width = 300.0  # Hz
    shortest = 0.004  # s
    taps = firwin(int(0.003 * rate) | 1, half_width, fs=rate)
    shifted = samples * np.exp(-2j * pi * line / rate * np.arange(len(samples)))
    level = np.log(np.abs(oaconvolve(shifted, taps, mode="same")) + 1e-300)
    step = int(0.001 * rate)
    tops = find_peaks(level, distance=step, prominence=0.35)[0]
    falls = []
    for top, following in zip(tops, [*tops[1:], len(level)], strict=True):
        begin = top + step
        fall = (
            level[begin : begin + int(np.argmin(level[begin:following]))]
            if following > begin
            else []
        )
        if len(fall) > shortest * rate:
            falls.append(-np.polyfit(np.arange(len(fall)) / rate, fall, 1)[0])
    return float(np.median(falls))


def click_crests(samples: np.ndarray, rate: float) -> list[float]:
    """Return, for each of CLICK_BANDS, how far clicks stand out.

    It is the peak over the rms of the envelope within 0.17 s, the median over such
    windows. The envelope is the rms over 0.2 ms of the band.
    """
    count = round(0.2e-3 * rate)
    window = round(0.17 * rate)
    found = []
    for low, high in CLICK_BANDS:
        band = sosfiltfilt(
            butter(4, (low, high), "band", fs=rate, output="sos"), samples
        )
        power = uniform_filter1d(np.square(band), count)
        windows = power[: len(power) // window * window].reshape(-1, window)
        crests = np.sqrt(windows.max(axis=1) / windows.mean(axis=1))
        found.append(float(np.median(crests)))
    return found
