"""Plot the pressure of a sound over time and its spectrogram."""

from typing import TYPE_CHECKING

import numpy as np

from sonify.hearing.spectrogram import REFERENCE_PRESSURE_PA, spectrogram

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from sonify.sound.pressure import Sound


def plot_sound(sound: "Sound") -> "Figure":
    """Plot the range of the pressure in each time interval, and the spectrogram.

    The spectrogram uses Hann windows. The colour scale ends well below its maximum.
    """
    window = 0.02  # s
    range_db = 65.0
    column_count = 2000
    from matplotlib.figure import Figure  # slow to import

    pressure = sound.pressure.read()
    size = -(-len(pressure) // column_count)
    starts = np.arange(0, len(pressure), size)
    time = starts / sound.sample_rate
    seen = spectrogram(sound.pressure, window, column_count)
    level = seen.level_db(REFERENCE_PRESSURE_PA)
    figure = Figure(figsize=(9.0, 6.0), layout="constrained")
    wave, image = figure.subplots(2, 1, sharex=True, height_ratios=[1, 2])
    lowest = np.minimum.reduceat(pressure, starts)
    highest = np.maximum.reduceat(pressure, starts)
    wave.fill_between(time, lowest, highest, color="black", linewidth=0)
    wave.set(ylabel="pressure [Pa]", xlim=(0.0, sound.duration))
    mesh = image.pcolormesh(
        seen.time,
        seen.frequency / 1e3,
        level,
        cmap="magma",
        vmin=level.max() - range_db,
    )
    image.set(xlabel="time at the listener [s]", ylabel="frequency [kHz]")
    figure.colorbar(mesh, ax=image, label="level of a sine [dB re 20 µPa]")
    return figure
