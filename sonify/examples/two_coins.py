"""
Two coins on one board
======================

Print how much a coin that rattles on a wooden board shakes a second, smooth coin that rolls
on the same board, and how much more two rattling coins shake the board than one. The
intervals are from runs in which one assumed value at a time takes the ends of its range."""

from itertools import combinations
from typing import NamedTuple

import numpy as np
from scipy.fft import next_fast_len

from dynamics import Motion, simulate
from dynamics.a_weighting import a_weighting_db
from dynamics.compliant.law.linear_response import force_per_height
from dynamics.compliant.law.unevenness import damping_ratio
from dynamics.compliant.model_inputs import tabulated_contact_law
from modal import SurfaceModes, surface_modes
from sonify import Scene, load_scene
from sonify.examples.contact_circuit import cell, rows_of_fields, varied
from sonify.runtime.markdown import markdown_table

COIN_DISTANCES = (0.1, 0.2)
"""Distances [m] between the coins."""
SECOND_COIN_INCLINATION = 0.1
"""Inclination [rad] at which the second coin rolls."""
FORCE_SAMPLE_RATE = 48000
"""Samples of the force per second."""
ASSUMED_RANGES: dict[str, tuple[float, ...]] = {
    "roughness.seed": (1, 2),
    "roughness.rms": (8e-6, 32e-6),
    "surface.loss_factor": (0.01, 0.04),
    "surface.young": (9e9, 14e9),
}
"""Assumed value -> both ends of its range."""
BOARD_RING_DOWN_DURATION = 0.5
"""Time [s] after the end of a motion in which the board comes to rest."""


class Shaking(NamedTuple):
    """What the first coin does to the board under the second one in its last second.

    Attributes
    ----------
    rms, peak : float
        Root mean square and greatest value of the displacement of the board there [nm].
    deflection : float
        Deflection of the contact of the second coin under its weight [nm].
    force_percent : float
        Root mean square of the change of its contact force, over its weight [%].
    open_percent : float
        Share of the time in which this change exceeds the weight [%].
    """

    rms: float
    peak: float
    deflection: float
    force_percent: float
    open_percent: float


ROW_NAMES_BY_FIELD = {
    "rms": "vibration of the board at the second coin, rms [nm]",
    "peak": "greatest deviation [nm]",
    "deflection": "deflection of the contact under the weight of the coin [nm]",
    "force_percent": "change of its contact force, rms [% of the weight]",
    "open_percent": "time in which this change opens the contact [%]",
}
"""Field of `Shaking` -> its row in the table."""
LEVEL_ROW = "two rattling coins above one, A-weighted acceleration of the board [dB]"


def receptance(
    modes: SurfaceModes, one: np.ndarray, two: np.ndarray, omega: np.ndarray
) -> np.ndarray:
    """Return the displacement (f,) of a table per harmonic force [m/N].

    `one` and `two` (m,) are the shapes of the modes at the force and at the displacement,
    in either order, and `omega` (f,) the angular frequencies [rad/s].
    """
    total = np.zeros(len(omega), complex)
    stiff = (2 * np.pi * modes.frequency) ** 2
    for square, decay, shape in zip(stiff, modes.decay_rate, one * two, strict=True):
        total += shape / (square - omega**2 + 2j * decay * omega)
    return total


def shapes_at_distance(modes: SurfaceModes, distance: float) -> np.ndarray:
    """Return the shapes (2, m) at the first coin and at a distance [m] from it along the
    board, across its middle."""
    places = modes.place + np.outer([0.0, distance], [-1.0, 0.0])
    return modes.at(*places.T)


def smooth_coin(scene: Scene) -> Scene:
    """Return the scene of a smooth coin on its elastic contact, with the same damping."""
    assert scene.contact.restitution is not None  # the coin rattles
    loss_factor = 2 * damping_ratio(scene.contact.restitution)
    return scene.replace(
        {
            "numerics.contact": "full",
            "contact.restitution": None,
            "contact.loss_factor": float(f"{loss_factor:.4g}"),
            "roughness": None,
        }
    )


class ForceSpectrum(NamedTuple):
    """Spectrum of the force of a motion; BOARD_RING_DOWN_DURATION without force follows.

    Attributes
    ----------
    omega : ndarray, (f,)
        Angular frequencies [rad/s].
    force : ndarray, (f,)
        Discrete Fourier transform of the force [N].
    end, size : int
        Number of samples of the motion, and of all samples.
    """

    omega: np.ndarray
    force: np.ndarray
    end: int
    size: int

    def last_second(self, spectrum: np.ndarray) -> np.ndarray:
        """Return the samples of a spectrum (f,) in the last second of the motion."""
        samples = np.fft.irfft(spectrum, self.size)
        return samples[max(self.end - FORCE_SAMPLE_RATE, 0) : self.end]


def force_spectrum(motion: Motion) -> ForceSpectrum:
    """Return the spectrum of the normal force of a motion."""
    times = np.arange(0.0, float(motion.rolling.t[-1]), 1 / FORCE_SAMPLE_RATE)
    count = next_fast_len(
        len(times) + round(BOARD_RING_DOWN_DURATION * FORCE_SAMPLE_RATE), real=True
    )
    force = np.fft.rfft(motion.rolling.force(times)[:, 2], count)
    omega = 2 * np.pi * np.fft.rfftfreq(count, 1 / FORCE_SAMPLE_RATE)
    return ForceSpectrum(omega, force, len(times), count)


def shaking(
    scene: Scene, motion: Motion, modes: SurfaceModes, distance: float
) -> Shaking:
    """Return what the coin of a motion does to a second one at a distance [m].

    The second coin rolls on a smooth edge. Its contact is linear, and its own force
    moves the board, too; it does not change the motion of the first one.
    """
    spectrum = force_spectrum(motion)
    omega = spectrum.omega
    one, two = shapes_at_distance(modes, distance)
    board = -receptance(modes, one, two, omega) * spectrum.force
    own = receptance(modes, two, two, omega)
    weight = scene.disk.weight
    law = tabulated_contact_law(smooth_coin(scene))
    beta = np.array([SECOND_COIN_INCLINATION])
    stiff = force_per_height(law.linear_contact(beta, np.array([weight])), omega)
    change = board * stiff / (1 + stiff * own)
    moved, pressed = map(spectrum.last_second, (board, change))
    moved -= moved.mean()
    spring = float(law.springs(beta, weight)[0].kn[0])
    return Shaking(
        rms=1e9 * float(moved.std()),
        peak=1e9 * float(abs(moved).max()),
        deflection=1e9 * 1.5 * weight / spring,
        force_percent=100 * float(pressed.std()) / weight,
        open_percent=100 * float(np.mean(pressed < -weight)),
    )


def board_acceleration(motion: Motion, modes: SurfaceModes) -> np.ndarray:
    """Return the A-weighted acceleration [m/s^2] of the board in the last second of a
    motion, at the larger of the COIN_DISTANCES from the coin."""
    spectrum = force_spectrum(motion)
    one, two = shapes_at_distance(modes, max(COIN_DISTANCES))
    per_force = receptance(modes, one, two, spectrum.omega) * spectrum.omega**2
    weight = 10 ** (a_weighting_db(spectrum.omega / (2 * np.pi)) / 20)
    return spectrum.last_second(weight * per_force * spectrum.force)


def level_differences(signals: list[np.ndarray]) -> list[float]:
    """Return the levels of two signals together above that of a third one [dB].

    The first one is the difference of the mean powers, the others are those of all
    choices of three signals.
    """
    length = min(map(len, signals))
    signals = [signal[-length:] for signal in signals]
    alone = [float(np.mean(signal**2)) for signal in signals]
    both = {
        (i, j): float(np.mean((signals[i] + signals[j]) ** 2))
        for i, j in combinations(range(len(signals)), 2)
    }
    ratios = [float(np.mean(list(both.values())) / np.mean(alone))]
    for pair, power in both.items():
        ratios += [power / one for k, one in enumerate(alone) if k not in pair]
    return [10 * float(np.log10(ratio)) for ratio in ratios]


def table(columns: dict[float, list[Shaking]], levels: list[float]) -> str:
    """Return the table in Markdown; each column has the runs at one distance [m]."""
    by_words = {
        f"{1e3 * distance:.0f} mm apart": runs for distance, runs in columns.items()
    }
    digits = dict.fromkeys(ROW_NAMES_BY_FIELD, 0) | {"open_percent": 2}
    rows = rows_of_fields(ROW_NAMES_BY_FIELD, by_words, digits)
    same = [cell(levels, 1)] * len(columns)
    return markdown_table([*rows, [LEVEL_ROW, *same]])


def board() -> Scene:
    """Return the scene of a coin that rattles on a round board of beech on a ring of felt."""
    plate = {
        "kind": "plate",
        "radius": 0.2,
        "thickness": 0.02,
        "young": 11e9,
        "poisson": 0.3,
        "density": 700.0,
        "loss_factor": 0.02,
        "edge": "free",
        "ring_radius": 0.18,
        "ring_stiffness": 1e6,
        "place": [0.08, 0.03],
        "action": "sound",
    }
    coin = load_scene("coin-wood").replace("numerics.accuracy=draft")
    return coin.replace({"surface": plate})


def main() -> str:
    """Return the third table of docs/predictions.md."""
    first = board()
    columns: dict[float, list[Shaking]] = {distance: [] for distance in COIN_DISTANCES}
    accelerations = []
    for scene in varied(first, ASSUMED_RANGES):
        modes = surface_modes(scene)
        motion = simulate(scene, surface_modes=modes)
        accelerations.append(board_acceleration(motion, modes))
        for distance, runs in columns.items():
            runs.append(shaking(scene, motion, modes, distance))
    different_heights = accelerations[: 1 + len(ASSUMED_RANGES["roughness.seed"])]
    return table(columns, level_differences(different_heights))


if __name__ == "__main__":
    print(main())
