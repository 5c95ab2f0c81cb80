"""PICTURES: what was solved and what is heard, each readable without colour."""

from contextlib import contextmanager

import numpy as np
from matplotlib.figure import Figure
from matplotlib.patheffects import withStroke
from scipy.ndimage import median_filter

from sonify.files import whole
from sonify.findings import load_frequency, mean_precession, precession_rate
from sonify.spectrogram import REFERENCE_PRESSURE, spectrogram

DPI = 110
RATES, WINDOW_RATES = (5.0, 1000.0), 0.2
"""The band of the contact rates [Hz], and the window it is seen through [s]."""
WINDOW_MODES = 0.02
"""The window for the band of the modes [s]."""
RANGE_DB = 70.0
"""From the loudest to the darkest."""


def draw_all(result):
    """Draw every picture of a run into its folder."""
    draw_spectrogram(result.motion, result.modes, result.sound, result.out / "spectrogram.png")
    draw_motion(result.motion, result.out / "motion.png")
    draw_modes(result.modes, result.out / "modes.png")


def draw_spectrogram(motion, modes, sound, path):
    """Draw pressure.wav in two bands, with the solved nutation, precession and modes over it."""
    with _figure(path, 2, 1, (11, 9)) as (_, (low, high)):
        file, end = sound.folder / "pressure.wav", sound.duration
        _image(low, spectrogram(file, WINDOW_RATES).band(*RATES), 1.0)
        low.set(yscale="log", ylim=RATES, ylabel="frequency [Hz]", title="Contact rates")
        _rate_lines(low, motion, sound.source_end - motion.t[-1])
        _image(high, spectrogram(file, WINDOW_MODES), 1e3)
        high.set(
            ylabel="frequency [kHz]",
            xlabel="time at the listener [s]",
            title="Modes",
            ylim=(0, sound.sample_rate / 2e3),
        )
        for frequency in modes.frequency:
            high.annotate(
                f"{frequency:.0f} Hz",
                (end, frequency / 1e3),
                (end * 0.995, frequency / 1e3),
                color="w",
                ha="right",
                fontsize=7,
            )
            high.axhline(frequency / 1e3, xmin=0.9, color="w", lw=0.7, ls=":")
        for axes in (low, high):
            axes.set_xlim(0, end)


def _image(axes, seen, unit):
    level = seen.level_db(REFERENCE_PRESSURE)
    top = np.ceil(level.max() / 5) * 5
    image = axes.pcolormesh(
        seen.time,
        seen.frequency / unit,
        level,
        vmin=top - RANGE_DB,
        vmax=top,
        cmap="magma",
        shading="nearest",
        rasterized=True,
    )
    axes.figure.colorbar(image, ax=axes, pad=0.01, label="level in the window [dB re 20 µPa]")


def _rate_lines(axes, motion, delay):
    peaks, nutation = load_frequency(motion)
    edge = [withStroke(linewidth=2.5, foreground="k")]
    for rate, style, name in ((mean_precession(motion), "-", "precession"), (nutation, "--", "nutation")):
        smooth = median_filter(rate, 5)
        axes.plot(peaks + delay, smooth, color="w", lw=1.0, ls=style, label=f"{name}, solved", path_effects=edge)
    axes.legend(loc="lower right", fontsize=8, facecolor="0.2", labelcolor="w")


def draw_motion(motion, path):
    """Draw the paper's figures 3 to 6."""
    chi, weight = motion.disk.time_unit, motion.disk.weight
    t = np.linspace(0, motion.t[-1], 12000)
    state, tau = motion.at(t), t / chi
    peaks, frequency = load_frequency(motion)
    energy = motion.energy(t) * chi**2 / (motion.disk.mass * motion.disk.radius**2)
    with _figure(path, 3, 2, (11, 11)) as (_, axes):
        curves = [
            (tau, np.pi / 2 - state[:, 1], "angle α [rad]", "Figure 3 (a)"),
            (tau, energy, "energy Ê", "Figure 3 (b)"),
            (tau, motion.normal_load(t), "normal force Φ", "Figure 4 (a)"),
            (peaks / chi, frequency * chi, "frequency f̂ of the normal force", "Figure 4 (b)"),
            (state[:, 3] / motion.disk.radius, state[:, 4] / motion.disk.radius, "y/R", "Figure 5: path of the centre"),
            (tau, precession_rate(state) * chi, "dθ/dτ", "Figure 6"),
        ]
        for panel, (x, y, label, title) in zip(axes.flat, curves, strict=True):
            panel.plot(x, y, color="k", lw=0.6)
            panel.set(xlabel="time τ = t/χ", ylabel=label, title=title)
            panel.grid(alpha=0.3)
        axes[0, 0].axhline(np.pi / 2, color="0.5", lw=0.8, ls="--")
        axes[1, 0].axhline(
            motion.normal_load([0.0])[0] * weight / motion.force([0.0])[0, 2], color="0.5", lw=0.8, ls="--"
        )
        axes[1, 1].set(ylim=(0, 4))
        axes[2, 0].set(xlabel="x/R", aspect="equal")
        axes[2, 1].set(ylim=(1.1 * np.percentile(precession_rate(state) * chi, 1), 0))


def draw_modes(modes, path):
    """Draw the normal displacement of the top face of every mode, with the patch to the right where there is one."""
    count = max(len(modes.frequency), 1)
    columns = min(count, 5)
    rows = -(-count // columns)
    angle = np.append(modes.face_angle, modes.face_angle[0] + 2 * np.pi)
    with _figure(
        path, rows, columns, (2.3 * columns, 2.6 * rows), subplot_kw={"projection": "polar"}, squeeze=False
    ) as (_, axes):
        for panel in axes.flat:
            panel.set_axis_off()
        for panel, frequency, shape, family, order in zip(
            axes.flat, modes.frequency, modes.face_shape[:, 1], modes.family, modes.order, strict=False
        ):
            closed = np.concatenate([shape, shape[:, :1]], axis=1)
            size = np.abs(closed).max() or 1.0
            panel.contourf(angle, modes.face_radius, closed / size, np.linspace(-1, 1, 17), cmap="RdGy")
            panel.contour(angle, modes.face_radius, closed / size, [0.0], colors="k", linewidths=0.8)
            panel.set_title(f"{frequency:.0f} Hz\n{family}, order {order}", fontsize=8)


@contextmanager
def _figure(path, rows, columns, size, **options):
    figure = Figure(figsize=size, dpi=DPI, layout="constrained")
    axes = figure.subplots(rows, columns, **options)
    yield figure, axes
    with whole(path) as temporary:
        figure.savefig(temporary, metadata={"Software": None})
