"""SOUND -> PICTURES: spectrograms with the solved lines over them, and the causes of sound against
hearing."""

from itertools import cycle, pairwise

import numpy as np
from matplotlib import colormaps
from matplotlib.patheffects import withStroke

from sonify.hearing.spectrogram import RATES, REFERENCE_PRESSURE, Spectrogram
from sonify.report.figure import figure_at, legend_above, plain_decades

RANGE_DB = 65.0
"""From the darkest to the brightest; the brightest is the loudest of each band: the modes may be
far below the rest."""
STEM_STYLES = (
    ("#0072b2", "-"),
    ("#d55e00", "--"),
    ("#000000", "-."),
    ("#56b4e9", (0, (8, 1))),
    ("#009e73", (0, (1, 1))),
    ("#cc79a7", (0, (5, 1, 1, 1, 1, 1))),
    ("#e69f00", (0, (3, 2))),
)
"""Colours told apart by the colour-blind, with dashes told apart in grey print."""
LOWEST_MODE = 250.0
"""From here on [Hz] the band of the modes is drawn."""
ROWS = 400
"""Of an image: about the pixels of the height of a panel."""
EDGES = 0.04
"""The share of a panel over which the lines of a table go."""
LINE = 14
"""Height of a line of small text [px]."""
EDGE = [withStroke(linewidth=2.5, foreground="k")]
"""Makes a white line visible on white."""


def draw_spectrogram(
    path,
    low: Spectrogram,
    high: Spectrogram,
    spans,
    time,
    rates,
    frequencies,
    table=(),
    carrier=None,
):
    """Draw the pressure in the bands of the contact rates and of the modes, over both `spans` [s],
    with the precession and nutation `rates` [Hz] at the listener's `time` [s], and the frequencies
    [Hz] of the modes, over it, those of an elastic `table` at its right edge; where the contact is
    elastic, the times [s] and frequencies [Hz] of its resonance, the `carrier`."""
    floors = [loudest_db(part) - RANGE_DB for part in (low, high.band(LOWEST_MODE, np.inf))]
    with figure_at(path, 2, 2, (15, 9), width_ratios=[2.2, 1]) as (figure, axes):
        for (top, bottom), span in zip(axes.T, spans, strict=True):
            top.set(xlim=span)
            log_frequency(top, RATES)
            turning = level_image(top, low.during(*span), 1.0, floors[0])
            _rate_lines(top, time, rates, 1.0)
            bottom.set(xlim=span)
            log_frequency(bottom, (LOWEST_MODE / 1e3, high.frequency[-1] / 1e3))
            ringing = level_image(bottom, high.during(*span), 1e3, floors[1])
            modes = np.unique(np.round(frequencies)) / 1e3
            bottom.hlines(
                modes,
                *span,
                color="w",
                lw=0.8,
                ls=":",
                alpha=0.7,
                label="modes of the disk, solved",
            )
            if len(table):
                _table_lines((top, bottom), table, span)
            if carrier is not None:
                label = "resonance of the contact, solved"
                bottom.plot(
                    carrier[0], carrier[1] / 1e3, color="w", lw=0.7, label=label, path_effects=EDGE
                )
        _rate_lines(axes[1, 1], time, rates, 1e3)
        for panel in axes[:, 0]:
            _legend(panel)
        _labels(axes[1, 0], frequencies, 1e3)
        _labels(axes[0, 1], table, 1.0)
        _labels(axes[1, 1], table if len(table) else frequencies, 1e3)
        for row, unit, title in zip(axes, ("Hz", "kHz"), ("Contact rates", "Modes"), strict=True):
            for panel, part in zip(row, (title, f"{title}, the end"), strict=True):
                panel.set(xlabel="time at the listener [s]", ylabel=f"frequency [{unit}]")
                panel.set_title(part, loc="left")
        for image, row in ((turning, axes[0]), (ringing, axes[1])):
            figure.colorbar(
                image, ax=row, pad=0.05, fraction=0.04, label="level of a sine [dB re 20 µPa]"
            )


def draw_recording(path, low: Spectrogram, high: Spectrogram, duration: float, tone=None):
    """Draw a sound in two bands, relative to full scale, with the rising tone that was heard, if
    any, over it."""
    floors = [loudest_db(part, 1.0) - RANGE_DB for part in (low, high.band(LOWEST_MODE, np.inf))]
    with figure_at(path, 2, 1, (11, 9)) as (figure, axes):
        log_frequency(axes[0], RATES)
        log_frequency(axes[1], (LOWEST_MODE / 1e3, high.frequency[-1] / 1e3))
        axes[0].set(ylabel="frequency [Hz]", xlabel="time [s]")
        axes[0].set_title("Contact rates", loc="left")
        for panel, seen, unit, floor in zip(axes, (low, high), (1.0, 1e3), floors, strict=True):
            panel.set(xlim=(0, duration))
            image = level_image(panel, seen, unit, floor, 1.0)
            if tone is not None:
                left = np.geomspace(0.01, 8.0, 400)
                options = {
                    "color": "w",
                    "lw": 1.0,
                    "ls": "--",
                    "label": "rising tone, fitted",
                    "path_effects": EDGE,
                }
                panel.plot(tone.end - left, tone.at(tone.end - left) / unit, **options)
                _legend(panel)
            figure.colorbar(
                image,
                ax=panel,
                pad=0.02,
                fraction=0.05,
                label="level of a sine [dB re full scale, RMS]",
            )
        axes[1].set(ylabel="frequency [kHz]", xlabel="time [s]")
        axes[1].set_title("Modes", loc="left")


def log_frequency(axes, band):
    """Make the height of a panel the logarithm of frequency over `band` [Hz], with ticks at 1, 2,
    5, 10 ..."""
    axes.set(yscale="log", ylim=band)
    plain_decades(axes.yaxis)


def loudest_db(seen, reference=REFERENCE_PRESSURE) -> float:
    """Return the greatest level of a spectrogram [dB re `reference`], rounded up to the next 5
    dB."""
    return float(5 * np.ceil(seen.level_db(reference).max(initial=-200.0) / 5))


def level_image(axes, seen, unit, floor, reference=REFERENCE_PRESSURE):
    """Draw the level [dB re `reference`], from `floor` on, of a spectrogram over time [s] and
    frequency [Hz, over `unit`]; where there is no window it is as dark as the floor."""
    axes.set_facecolor(colormaps["magma"](0))
    level = seen.level_db(reference)
    options = {"cmap": "magma", "vmin": floor, "vmax": floor + RANGE_DB}
    time = seen.time
    frequency = seen.frequency / unit
    half = np.diff(time[:2], append=time[0] + 1)[0] / 2
    (begin, end) = axes.get_xlim()
    left, right = (time[[0, -1]] + [-half, half] - begin) / (end - begin)
    options |= {
        "origin": "lower",
        "aspect": "auto",
        "interpolation": "nearest",
        "transform": axes.transAxes,
    }
    return axes.imshow(_rows(level, frequency, axes), extent=(left, right, 0, 1), **options)


def _rows(level, frequency, axes):
    """The levels (f, t) on even heights of a panel: the loudest where a row holds several
    frequencies."""
    heights = axes.yaxis.get_transform().transform(axes.get_ylim())
    edges = np.linspace(*heights, ROWS + 1)
    edges = axes.yaxis.get_transform().inverted().transform(edges)
    between = np.searchsorted((frequency[1:] + frequency[:-1]) / 2, edges)
    return np.stack([level[a : max(a, b) + 1].max(axis=0) for a, b in pairwise(between)])


def draw_colours(path):
    """Write the colours of a `level_image` from dark to bright into a file, (256, 3) bytes."""
    path.write((255 * colormaps["magma"](np.arange(256))[:, :3]).round().astype(np.uint8).tobytes())


def _rate_lines(axes, time, rates, unit):
    for rate, color, style, name in zip(
        rates, ("w", "#56b4e9"), ("-", "--"), ("precession", "nutation"), strict=True
    ):
        axes.plot(
            time,
            rate / unit,
            color=color,
            lw=1.2,
            ls=style,
            label=f"{name}, solved",
            path_effects=EDGE,
        )


def _legend(axes):
    legend_above(axes, facecolor="0.2", labelcolor="w")


def _table_lines(panels, table, span):
    """Short lines at the right edge: a table has many modes, and what they sound is seen on its way
    through them."""
    begin = span[1] - EDGES * (span[1] - span[0])
    for axes, unit in zip(panels, (1.0, 1e3), strict=True):
        axes.hlines(
            np.round(table) / unit,
            begin,
            span[1],
            color="#e69f00",
            lw=1.2,
            label="modes of the table, solved",
        )


def _labels(axes, frequencies, unit):
    """Write frequencies [Hz] beside the right edge, none over another: where there is no room, not
    all of them."""
    scaled = axes.yaxis.get_transform().transform
    (low, high) = axes.get_ylim()
    heights = np.unique(np.round(frequencies)) / unit  # the two of a pair are one line
    shares = (scaled(heights) - scaled(low)) / (scaled(high) - scaled(low))
    apart = LINE / axes.get_window_extent().height
    last = -1.0
    leader = {
        "arrowstyle": "-",
        "lw": 0.5,
        "shrinkA": 0,
        "shrinkB": 0,
        "relpos": (-0.08, 0.5),
        "patchA": None,
    }
    for height, share in zip(heights, shares, strict=True):
        place = max(share, last + apart)
        if share < 0 or place > 1 or place - share > 2 * apart:
            continue
        options = {
            "xycoords": axes.get_yaxis_transform(),
            "textcoords": "axes fraction",
            "va": "center",
        }
        axes.annotate(
            f"{unit * height:.0f} Hz",
            (1, height),
            (1.02, place),
            fontsize=7,
            arrowprops=leader,
            **options,
        )
        last = place


def draw_stems(path, stems, end: float, duration: float):
    """Draw over time the A-weighted level of each cause of sound, and how far it is above the
    threshold of hearing.

    `stems` are times (t,) [s] and both levels (t,) [dB] by name, `end` and `duration` [s] are those
    of motion and sound."""
    with figure_at(path, 2, 1, (11, 8.6)) as (_, (weighted, above)):
        for (name, (time, a_weighted, above_threshold)), (color, style) in zip(
            stems.items(), cycle(STEM_STYLES)
        ):
            options = {"color": color, "ls": style, "lw": 1.4, "label": name.replace("_", " ")}
            weighted.plot(time, a_weighted, **options)
            above.plot(time, above_threshold, **options)
        weighted.set(ylabel="A-weighted level [dB re 20 µPa]", ylim=(-20, None))
        weighted.set_title("Causes of sound", loc="left")
        above.axhspan(-30, 0, color="0.9", label="not heard")
        above.set(ylabel="above the threshold [dB]", ylim=(-30, None))
        above.set_title("Best third octave over the threshold of hearing (ISO 226)", loc="left")
        for axes in (weighted, above):
            axes.grid(alpha=0.3)
            axes.axvline(end, color="k", lw=0.6, ls=":", label="end of the motion")
            axes.set(xlabel="time at the listener [s]", xlim=(0, duration))
        legend_above(weighted, columns=len(stems) + 1, frameon=False)
        unheard, ended = above.get_legend_handles_labels()[0][-2:]
        legend_above(above, handles=[unheard, ended], frameon=False)
