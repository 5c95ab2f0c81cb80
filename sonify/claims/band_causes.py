"""What sets the noise band of a rough contact on a table that yields.

The linear filter is evaluated again without the table, without the air film, and with
twice the moduli in the contact. The cause of the band is what moves it when it is switched
off."""

from dataclasses import replace
from typing import NamedTuple

import numpy as np

from dynamics import InfiniteSurface, Motion
from dynamics.compliant.law.linear_response import predicted_spectrum
from dynamics.compliant.law.table_receptance import (
    RIGID_TABLE,
    TableReceptance,
    shapes_on_circle,
)
from dynamics.compliant.law.tabulated import TabulatedLaw
from modal import SurfaceModes
from sonify.claims.finding import Measured, finding, median_with_margin
from sonify.hearing.noise_band import band_centroid
from sonify.scene import Scene
from sonify.sound.radiation import Listener, listener_of
from sonify.sound.sources.contact_vibration import VibratingDisk
from sonify.sound.sources.film import radiates_above_film
from sonify.sound.sources.infinite_plate import pressure_per_force
from sonify.sound.sources.tabletop import table_radiation

BAND_RANGE = (700.0, 20e3)
"""Frequencies [Hz] in which the noise band is searched, as in `noise_band`."""


class TableSound(NamedTuple):
    """Mean-square pressure of a table per squared force of a contact that runs round it.

    Attributes
    ----------
    orders : ndarray, (n,)
        Orders of the waves round the contact circle.
    square : ndarray, (n, f)
        Squared pressure per squared force [Pa^2/N^2] of the waves of each order; the
        table vibrates at the frequency of the force minus n times the precession rate.
    """

    orders: np.ndarray
    square: np.ndarray

    def power(
        self, frequency: np.ndarray, spectrum: np.ndarray, rate: float
    ) -> np.ndarray:
        """Return the power spectrum (f,) [Pa^2/Hz] under a force with `spectrum` (f,)
        [N^2/Hz], at a precession rate [rad/s]."""
        shift = rate / (2 * np.pi)
        return np.sum(
            [
                square * np.interp(frequency + order * shift, frequency, spectrum)
                for order, square in zip(self.orders, self.square, strict=True)
            ],
            axis=0,
        )


class BandCauses(NamedTuple):
    """Centre frequencies (s,) [Hz] of the noise band in selected time intervals.

    Attributes
    ----------
    heard
        Measured in the sound.
    complete
        Prediction of the filter with table and film.
    without_table
        With a rigid, silent table.
    without_film
        With the disk above the widest gap that is tabulated.
    stiffer
        With twice the moduli of disk and table in the contact.
    resonance_rise
        Ratio by which the contact resonance alone is then higher.
    """

    heard: np.ndarray
    complete: np.ndarray
    without_table: np.ndarray
    without_film: np.ndarray
    stiffer: np.ndarray
    resonance_rise: np.ndarray


class SteadyVibration(NamedTuple):
    """Inclination [rad], load [N], speed [m/s] and rolling of a contact at one time."""

    inclination: float
    load: float
    speed: float
    rolls: bool


class BandModel(NamedTuple):
    """The linear filter of a scene, with the radiation of disk and table.

    Attributes
    ----------
    law : TabulatedLaw
        Law of the contact.
    receptance : TableReceptance
        Receptance of the table in the force.
    table : TableSound or None
        Sound of the table; None for a silent one.
    disk : VibratingDisk or None
        Disk above its film; None without a film, where only the table is compared.
    has_film : bool
        False for the disk above the widest gap.
    """

    law: TabulatedLaw
    receptance: TableReceptance
    table: TableSound | None
    disk: VibratingDisk | None
    has_film: bool = True

    def power(
        self, scene: Scene, at: SteadyVibration, frequency: np.ndarray
    ) -> np.ndarray:
        """Return the power spectrum (f,) [Pa^2/Hz] of the pressure."""
        assert scene.roughness is not None
        force = predicted_spectrum(
            self.law, scene.roughness, *at[:3], frequency, at.rolls, self.receptance
        )
        if self.table is None and self.disk is None:
            return force
        total = np.zeros(len(frequency))
        if self.disk is not None:
            gap = None if self.has_film else np.inf
            total += force * self.disk.mean_square_pressure(
                at.inclination, frequency, gap
            )
        if self.table is not None:
            rate = at.speed / float(self.law.law.place(at.inclination).f)
            total += self.table.power(frequency, force, abs(rate))
        return total


def table_sound(
    scene: Scene, modes: SurfaceModes | None, listener: Listener, frequency: np.ndarray
) -> TableSound | None:
    """Return the `TableSound` at frequencies (f,) [Hz] of a table with modes or of an
    infinite plate; None for a table that does not radiate."""
    if isinstance(scene.surface, InfiniteSurface):
        square = pressure_per_force(scene.surface, listener) ** 2
        return TableSound(np.zeros(1), np.full((1, len(frequency)), square))
    if (
        modes is None or scene.surface.kind == "modes"
    ):  # these have no face that radiates
        return None
    azimuth_count = 64
    frequency_count = 256  # at which the radiation of a mode is evaluated
    disk = scene.disk
    radius = disk.radius - scene.contact.rolling_fillet(disk)
    shapes = shapes_on_circle(modes, modes.place, radius, azimuth_count)
    waves = np.fft.fft(shapes, axis=0) / azimuth_count
    orders = np.fft.fftfreq(azimuth_count, 1 / azimuth_count)
    relevant = np.abs(waves).max(axis=1) > 1e-4 * np.abs(waves).max()
    few = np.linspace(0.0, frequency[-1], frequency_count)
    radiation = table_radiation(modes, listener, few, scene.surface.baffle)
    omega = 2 * np.pi * frequency
    pressure = np.zeros((relevant.sum(), len(frequency)), complex)
    for m in range(len(modes)):
        stiff = (2 * np.pi * modes.frequency[m]) ** 2
        response = -(omega**2) / (stiff - omega**2 + 2j * modes.decay_rate[m] * omega)
        response = response * np.interp(frequency, few, radiation[:, m])
        pressure += np.multiply.outer(waves[relevant, m], response)
    return TableSound(orders[relevant], np.abs(pressure) ** 2)


def with_double_stiffness(law: TabulatedLaw) -> TabulatedLaw:
    """Return a tabulated law with twice the moduli of contact and table."""
    body, table = (
        side._replace(young=2 * side.young) for side in (law.law.body, law.law.table)
    )
    return replace(law, law=replace(law.law, body=body, table=table))


def band_causes(
    scene: Scene,
    motion: Motion,
    law: TabulatedLaw,
    receptance: TableReceptance,
    intervals: list[list[SteadyVibration]],
    heard: np.ndarray,
) -> BandCauses:
    """Return the noise band with and without its possible causes.

    Parameters
    ----------
    scene : Scene
        Scene with a rough contact.
    motion : Motion
        Its motion.
    law : TabulatedLaw
        Law of the contact.
    receptance : TableReceptance
        Receptance of the table in the contact force.
    intervals : list of list of SteadyVibration
        Contact vibration at several times of each interval.
    heard : ndarray, (s,)
        Frequency [Hz] of the measured noise band in each interval.

    Returns
    -------
    BandCauses
        The frequencies.
    """
    frequency = np.arange(BAND_RANGE[0], BAND_RANGE[1], 10.0)
    listener = listener_of(scene)
    table = table_sound(scene, motion.plan.surface_modes, listener, frequency)
    disk = VibratingDisk(scene, listener) if radiates_above_film(motion) else None
    complete = BandModel(law, receptance, table, disk)
    models = [
        complete,
        complete._replace(receptance=RIGID_TABLE, table=None),
        complete._replace(has_film=False),
        complete._replace(law=with_double_stiffness(law)),
    ]
    found = []
    for steady in intervals:
        middle = steady[len(steady) // 2][:3]
        soft, stiff = (
            float(model.law.contact_resonance(*np.reshape(middle, (3, 1))).frequency[0])
            for model in (complete, models[-1])
        )
        powers = [
            np.mean([model.power(scene, at, frequency) for at in steady], axis=0)
            for model in models
        ]
        bands = [band_centroid(frequency, p, frequency[p.argmax()]) for p in powers]
        found.append([*bands, stiff / soft])
    return BandCauses(heard, *np.array(found).T)


def moved_by(with_cause: np.ndarray, without: np.ndarray) -> Measured:
    """Return the median ratio by which a cause moves the band, in either direction."""
    ratio = median_with_margin(with_cause / without)
    inverse = max(ratio.value, 1 / ratio.value) / ratio.value
    return ratio._replace(value=ratio.value * inverse, margin=ratio.margin * inverse)


@finding(needs=("motion", "contact law", "sound"), at_least=1.1)
def table_moves_carrier(found: BandCauses) -> Measured:
    """The ratio by which the table moves the predicted noise band.

    The table is switched off in the force and in the radiation. The claim is undecided
    if the complete prediction differs from the sound by more than 10 %."""
    max_misfit = 0.1
    fits = float(np.median(found.heard / found.complete))
    details = {
        "with_table": float(np.median(found.complete)),
        "on_rigid_table": float(np.median(found.without_table)),
        "heard": fits,
    }
    doubt = "the prediction does not fit the sound"
    return moved_by(found.complete, found.without_table)._replace(
        details=details,
        undecided_because=doubt if abs(fits - 1) > max_misfit else "",
    )


@finding(needs=("motion", "contact law"), at_least=0.5)
def stiffness_moves_carrier(found: BandCauses) -> Measured:
    """The exponent of the band with the frequency of the contact resonance, if the moduli
    in the contact are doubled."""
    moved = np.log(found.stiffer / found.complete)
    return median_with_margin(moved / np.log(found.resonance_rise))


def film_switched_off(found: BandCauses) -> Measured:
    """The ratio by which the film moves the predicted noise band."""
    moved = moved_by(found.complete, found.without_film)
    without = float(np.median(found.without_film))
    return moved._replace(variant="switched off", details={"without_film": without})
