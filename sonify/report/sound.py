"""Draw spectrograms with the computed frequencies, and stem levels above the threshold
of hearing.
"""

from collections.abc import Mapping, Sequence
from itertools import cycle, pairwise
from typing import TYPE_CHECKING, Any, BinaryIO

import numpy as np
from matplotlib import colormaps
from matplotlib.patheffects import withStroke

from sonify.hearing.spectrogram import (
    CONTACT_RATE_BAND_HZ,
    REFERENCE_PRESSURE_PA,
    Spectrogram,
    spectrogram,
)
from sonify.report.figure import (
    PicturePath,
    label_plain_decades,
    place_legend_above,
    png_figure,
)

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.image import AxesImage

    from sonify.hearing.audio_source import AudioSource
    from sonify.hearing.settling.detector import SettlingRun

STEM_STYLES = (
    ("#0072b2", "-"),
    ("#d55e00", "--"),
    ("#000000", "-."),
    ("#56b4e9", (0, (8, 1))),
    ("#009e73", (0, (1, 1))),
    ("#cc79a7", (0, (5, 1, 1, 1, 1, 1))),
    ("#e69f00", (0, (3, 2))),
)
"""Colours that colour-blind readers can distinguish; the dashes differ in greyscale
print."""
DARK_OUTLINE = [withStroke(linewidth=2.5, foreground="k")]
"""Dark outline that keeps a white line visible on a white background."""


def draw_spectrogram(
    path: PicturePath,
    bands: tuple[Spectrogram, Spectrogram],
    spans: Sequence[tuple[float, float]],
    time: np.ndarray,
    rates: Sequence[np.ndarray],
    frequencies: np.ndarray,
    table: Sequence[float] | np.ndarray = (),
    carrier: tuple[np.ndarray, np.ndarray] | None = None,
) -> None:
    """Draw spectrograms of the pressure with the computed frequencies.

    Parameters
    ----------
    path : path or file
        Destination of the PNG.
    bands : tuple of two Spectrograms
        Bands of the contact rates and of the modes.
    spans : sequence of two tuples
        Time spans of the two columns of panels [s].
    time : ndarray, shape (k,)
        Time at the listener [s].
    rates : sequence of two ndarrays, shape (k,)
        Precession and nutation [Hz].
    frequencies : ndarray, shape (m,)
        Frequencies of the modes of the disk [Hz].
    table : ndarray, shape (n,)
        Frequencies of the modes of an elastic table [Hz], drawn at the right edge.
    carrier : tuple of two ndarrays or None
        Times [s] and frequencies [Hz] of the resonance of an elastic contact.
    """
    with png_figure(path, 2, 2, (15, 9), width_ratios=[2.2, 1]) as (figure, axes):
        for (top, bottom), span in zip(axes.T, spans, strict=True):
            images = draw_bands((top, bottom), *bands, span)
            draw_rate_lines(top, time, rates, 1.0)
            bottom.hlines(
                np.unique(np.round(frequencies)) / 1e3,
                *span,
                color="w",
                lw=0.8,
                ls=":",
                alpha=0.7,
                label="modes of the disk, solved",
            )
            if len(table):
                draw_table_mode_lines((top, bottom), table, span)
            if carrier is not None:
                bottom.plot(
                    carrier[0],
                    carrier[1] / 1e3,
                    color="w",
                    lw=0.7,
                    label="resonance of the contact, solved",
                    path_effects=DARK_OUTLINE,
                )
        draw_rate_lines(axes[1, 1], time, rates, 1e3)
        for panel in axes[:, 0]:
            draw_legend(panel)
        label_frequencies(axes[1, 0], frequencies, 1e3)
        label_frequencies(axes[0, 1], table, 1.0)
        label_frequencies(axes[1, 1], table if len(table) else frequencies, 1e3)
        for row, image, unit, title in zip(
            axes, images, ("Hz", "kHz"), ("Contact rates", "Modes"), strict=True
        ):
            for panel, part in zip(row, (title, f"{title}, the end"), strict=True):
                panel.set(
                    xlabel="time at the listener [s]", ylabel=f"frequency [{unit}]"
                )
                panel.set_title(part, loc="left")
            label = "level of a sine [dB re 20 µPa]"
            figure.colorbar(image, ax=row, pad=0.05, fraction=0.04, label=label)


LAW_NAMES = {"flat": "steady", "exponential": "expon."}


def draw_recording(
    path: PicturePath,
    low: Spectrogram,
    high: Spectrogram,
    span: tuple[float, float],
    runs: "Sequence[SettlingRun]" = (),
) -> None:
    """Draw the spectrogram of a recording in two bands, relative to full scale, over a
    `span` [s].

    The rates of the settling `runs` are overlaid.
    """
    with png_figure(path, 2, 1, (11, 9)) as (figure, axes):
        images = draw_bands(axes, low, high, span, 1.0)
        for panel, image, unit, title in zip(
            axes, images, ("Hz", "kHz"), ("Low", "High"), strict=True
        ):
            panel.set(ylabel=f"frequency [{unit}]", xlabel="time [s]")
            panel.set_title(f"{title} frequencies", loc="left")
            label = "level of a sine [dB re full scale, RMS]"
            figure.colorbar(image, ax=panel, pad=0.02, fraction=0.05, label=label)
        for run in runs:
            end = run.region.best_end
            before_stop = end - run.heard_until
            left = before_stop + np.geomspace(0.01, run.heard_until - run.start, 400)
            time = end - left
            axes[0].plot(
                time,
                run.rate(time),
                "w--",
                lw=1.0,
                label="rate of a settling disk, fitted",
                path_effects=DARK_OUTLINE,
            )
        if runs:
            draw_legend(axes[0])


def levels_by_turn(
    source: "AudioSource", begin: float, run: "SettlingRun"
) -> tuple[np.ndarray, np.ndarray]:
    """Return the turns left (k,) of a settling run and the levels (k, 129) [dB] during
    two turns each, relative to their median.

    The source starts at the time `begin` [s].
    """
    from scipy.ndimage import uniform_filter  # slow to import

    burst_window = 0.004  # s, separates the bursts
    span = (run.start - begin - 1.0, run.heard_until - begin + 0.1)
    seen = spectrogram(source, burst_window, 1 << 20, (max(span[0], 0.0), span[1]))
    level = 10 * np.log10(seen.band(*run.bands[0]).power.sum(axis=0) + 1e-14)
    first, last = run.turns_left(np.array([run.start, run.heard_until - 0.02]))
    turns = np.arange(int(first), max(int(last), 0), -1)
    wanted = turns[:, None] - np.linspace(0, 2, 129)
    rows = np.interp(-wanted, -run.turns_left(begin + seen.time), level)
    rows -= np.median(rows, axis=1, keepdims=True)
    return turns, uniform_filter(rows, (3, 7))


def draw_settling(
    path: PicturePath,
    source: "AudioSource",
    begin: float,
    runs: "Sequence[SettlingRun]",
) -> None:
    """Draw the settling runs in a source turn by turn, with the scores of rival laws.

    The source starts at the time `begin` [s]. In the upper panels each row is one turn
    of the fitted law, drawn twice side by side: bursts that follow the law form
    vertical lines; bright parts are loud. The lower panels show the scores of the laws.
    """
    shown = sorted(runs, key=lambda run: -run.score)[:3]
    size = (max(5.5 * len(shown), 7), 9)
    with png_figure(path, 2, len(shown), size, squeeze=False) as (_, axes):
        for (above, below), run in zip(axes.T, shown, strict=True):
            low, high = run.bands[0]
            turns, rows = levels_by_turn(source, begin, run)
            above.imshow(
                np.clip(rows[::-1], -4, 6),
                aspect="auto",
                origin="lower",
                extent=(0, 2, turns[-1], turns[0]),
                cmap="magma",
            )
            above.set(
                xlabel="fraction of a turn (bright: loud), drawn twice",
                ylabel="turns left until the end",
            )
            above.set_title(
                f"{run.kind} in {low:.0f} to {high:.0f} Hz, turn by turn", loc="left"
            )
            below.barh(
                [LAW_NAMES.get(name, name) for name in run.law_scores],
                list(run.law_scores.values()),
                color=[
                    "#d55e00" if name == "disk" else "#999999"
                    for name in run.law_scores
                ],
            )
            below.invert_yaxis()
            below.set(xlabel="log likelihood of held-out parts, gain over a constant")
            certainty = "certain" if run.certain else "probable"
            below.set_title(
                f"law of the rate; Q = {run.score:.0f}, {certainty}", loc="left"
            )


def draw_bands(
    panels: "Sequence[Axes]",
    low: Spectrogram,
    high: Spectrogram,
    span: tuple[float, float],
    reference: float = REFERENCE_PRESSURE_PA,
) -> "tuple[AxesImage, AxesImage]":
    """Draw the bands of the contact rates and of the modes over a span [s] in two
    panels; return the images."""
    min_mode_frequency = 250.0  # Hz
    for axes in panels:
        axes.set(xlim=span)
    rates, modes = panels
    set_log_frequency_axis(rates, CONTACT_RATE_BAND_HZ)
    set_log_frequency_axis(modes, (min_mode_frequency / 1e3, high.frequency[-1] / 1e3))
    loudest = loudest_db(high.band(min_mode_frequency, np.inf), reference)
    return (
        draw_level_image(
            rates, low.during(*span), 1.0, loudest_db(low, reference), reference
        ),
        draw_level_image(modes, high.during(*span), 1e3, loudest, reference),
    )


def set_log_frequency_axis(axes: "Axes", band: tuple[float, float]) -> None:
    """Set a logarithmic frequency axis over `band` with ticks at 1, 2, 5, 10, ..."""
    axes.set(yscale="log", ylim=band)
    label_plain_decades(axes.yaxis)


def loudest_db(seen: Spectrogram, reference: float = REFERENCE_PRESSURE_PA) -> float:
    """Return the highest spectrogram level [dB re `reference`], rounded up to a
    multiple of 5.

    Each band has its own, because the modes may be much quieter than the contact
    rates."""
    return float(5 * np.ceil(seen.level_db(reference).max(initial=-200.0) / 5))


def draw_level_image(
    axes: "Axes",
    seen: Spectrogram,
    unit: float,
    loudest: float,
    reference: float = REFERENCE_PRESSURE_PA,
) -> "AxesImage":
    """Draw a spectrogram level [dB re `reference`] over time and frequency; return the
    image.

    The time is in s and the frequency in Hz divided by `unit`. The brightest colour is
    `loudest` [dB]; times without a window have the darkest colour.
    """
    colour_range = 65.0  # dB
    axes.set_facecolor(colormaps["magma"](0))
    time = seen.time
    half = np.diff(time[:2], append=time[0] + 1)[0] / 2
    begin, end = axes.get_xlim()
    left, right = (time[[0, -1]] + [-half, half] - begin) / (end - begin)
    return axes.imshow(
        resample_to_rows(seen.level_db(reference), seen.frequency / unit, axes),
        extent=(left, right, 0, 1),
        cmap="magma",
        vmin=loudest - colour_range,
        vmax=loudest,
        origin="lower",
        aspect="auto",
        interpolation="nearest",
        transform=axes.transAxes,
    )


def resample_to_rows(
    level: np.ndarray, frequency: np.ndarray, axes: "Axes"
) -> np.ndarray:
    """Resample levels (f, t) to evenly spaced rows of a panel.

    A row that contains several frequencies shows the highest level.
    """
    row_count = 400  # close to the height of a panel in pixels
    scale = axes.yaxis.get_transform()
    low, high = scale.transform(np.array(axes.get_ylim()))
    edges = np.linspace(low, high, row_count + 1)
    edges = scale.inverted().transform(edges)
    between = np.searchsorted((frequency[1:] + frequency[:-1]) / 2, edges)
    return np.stack(
        [level[a : max(a, b) + 1].max(axis=0) for a, b in pairwise(between)]
    )


def write_colour_table(path: BinaryIO) -> None:
    """Write the colours of a `draw_level_image` to a file as (256, 3) bytes, from dark
    to bright."""
    colours = 255 * colormaps["magma"](np.arange(256))[:, :3]
    path.write(colours.round().astype(np.uint8).tobytes())


def draw_rate_lines(
    axes: "Axes", time: np.ndarray, rates: Sequence[np.ndarray], unit: float
) -> None:
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
            path_effects=DARK_OUTLINE,
        )


def draw_legend(axes: "Axes") -> None:
    place_legend_above(axes, facecolor="0.2", labelcolor="w")


def draw_table_mode_lines(
    panels: "Sequence[Axes]",
    table: Sequence[float] | np.ndarray,
    span: tuple[float, float],
) -> None:
    """Draw the modes of a table as short lines at the right edge.

    A table has many modes; longer lines would hide their sound.
    """
    relative_line_length = 0.04  # of the width of a panel
    begin = span[1] - relative_line_length * (span[1] - span[0])
    for axes, unit in zip(panels, (1.0, 1e3), strict=True):
        axes.hlines(
            np.round(table) / unit,
            begin,
            span[1],
            color="#e69f00",
            lw=1.2,
            label="modes of the table, solved",
        )


def label_frequencies(
    axes: "Axes", frequencies: Sequence[float] | np.ndarray, unit: float
) -> None:
    """Write frequencies [Hz] to the right of a panel.

    Labels that would overlap or move too far from their lines are omitted.
    """
    scaled = axes.yaxis.get_transform().transform
    low, high = axes.get_ylim()
    heights = np.unique(np.round(frequencies)) / unit  # a degenerate pair is one line
    shares = (scaled(heights) - scaled(low)) / (scaled(high) - scaled(low))
    text_height = 14  # px
    min_distance = text_height / axes.get_window_extent().height
    leader = {
        "arrowstyle": "-",
        "lw": 0.5,
        "shrinkA": 0,
        "shrinkB": 0,
        "relpos": (-0.08, 0.5),
        "patchA": None,
    }
    last = -1.0
    for height, share in zip(heights, shares, strict=True):
        place = max(share, last + min_distance)
        if share < 0 or place > 1 or place - share > 2 * min_distance:
            continue
        axes.annotate(
            f"{unit * height:.0f} Hz",
            (1, height),
            (1.02, place),
            fontsize=7,
            arrowprops=leader,
            xycoords=axes.get_yaxis_transform(),
            textcoords="axes fraction",
            va="center",
        )
        last = place


def draw_stems(
    path: PicturePath,
    stems: Mapping[str, tuple[np.ndarray, np.ndarray, np.ndarray]],
    end: float,
    duration: float,
) -> None:
    """Draw the A-weighted level of each stem and its level above the threshold of
    hearing.

    `stems` contains times (t,) [s] and both levels (t,) [dB] by name. `end` is the end
    of the motion [s], and `duration` that of the sound [s].
    """
    faintest = -20.0  # dB, lower limit of the panel
    with png_figure(path, 2, 1, (11, 8.6)) as (_, (weighted, above)):
        for (name, (time, a_weighted, above_threshold)), (color, style) in zip(
            stems.items(), cycle(STEM_STYLES)
        ):
            label = name.replace("_", " ")
            if np.max(a_weighted, initial=-np.inf) < faintest:
                label += " (fainter)"
            options: dict[str, Any] = {
                "color": color,
                "ls": style,
                "lw": 1.4,
                "label": label,
            }
            weighted.plot(time, a_weighted, **options)
            above.plot(time, above_threshold, **options)
        weighted.set(ylabel="A-weighted level [dB re 20 µPa]", ylim=(faintest, None))
        weighted.set_title("Causes of sound", loc="left")
        above.axhspan(-30, 0, color="0.9", label="inaudible")
        above.set(ylabel="above the threshold [dB]", ylim=(-30, None))
        above.set_title(
            "Most audible third octave, above the threshold of hearing (ISO 226)",
            loc="left",
        )
        for axes in (weighted, above):
            axes.grid(alpha=0.3)
            axes.axvline(end, color="k", lw=0.6, ls=":", label="end of the motion")
            axes.set(xlabel="time at the listener [s]", xlim=(0, duration))
        place_legend_above(weighted, columns=len(stems) + 1, frameon=False)
        unheard, ended = above.get_legend_handles_labels()[0][-2:]
        place_legend_above(above, handles=[unheard, ended], frameon=False)
