"""Output files of a fit: fit.json, fit.csv, a picture and a short page."""

import csv
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import asdict
from io import StringIO
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from sonify.fitting.decay_model import has_film, neglected_parts
from sonify.fitting.least_squares import Fit, Value, fitted_shares_in_words
from sonify.fitting.line_selection import Judged, shares_of_power
from sonify.fitting.result import Fits, Fitted
from sonify.fitting.settings import FIT
from sonify.report.figure import (
    file_label,
    label_plain_decades,
    place_legend_above,
    png_figure,
)
from sonify.report.recording import spectral_line_record
from sonify.runtime.files import (
    atomic_write,
    claimed_folder,
    first_matching_folder,
    write_text,
)
from sonify.runtime.json_values import json_safe, write_json
from sonify.runtime.markdown import markdown_table

if TYPE_CHECKING:
    from matplotlib.axes import Axes

MAX_PANELS = 6
"""Largest number of recordings that are drawn."""


def write_fits(
    fits: Fits, out: str | Path | None, simulated: dict[str, Any] | None
) -> Path:
    """Write fit.json, fit.csv, fit.png and fit.md into `out` and return the folder.

    With the numbers of a `simulated` sound, compare.json and compare.png are also
    written. Raises OutputError if the folder is not writable."""
    new_folder = Path("outputs") / "fit" / Path(fits.files[0].file).stem
    folder = out or first_matching_folder(
        new_folder, lambda folder: not (folder / "fit.json").exists()
    )
    record = as_json(fits)
    with claimed_folder(folder) as folder:
        write_json(json_safe(record), folder / "fit.json")
        with atomic_write(folder / "fit.png") as temporary:
            draw(fits, temporary)
        write_text(_as_csv(table(record)), folder / "fit.csv")
        write_text(page(fits, record), folder / "fit.md")
        if simulated:
            files = [{"file": one.file, "measured": one.measured} for one in fits.files]
            record = {"scene": fits.scene.name, "files": files, "simulated": simulated}
            write_json(json_safe(record), folder / "compare.json")
            with atomic_write(folder / "compare.png") as temporary:
                draw_comparison(fits, simulated, temporary)
    return folder


def as_json(fits: Fits) -> dict[str, Any]:
    """Return the content of fit.json."""
    limits = [one.judged.limits for one in fits.files]
    common = limits[0] if all(limits) else {}
    shares = shares_of_power(fits.files[0].judged.decay, fits.pool)
    return {
        "scene": fits.scene.name,
        "neglected": neglected_parts(fits.scene),
        "files": [_record_of_recording(one, fits.resonances) for one in fits.files],
        "not_fitted": [
            {"file": one.file, "reason": one.reason} for one in fits.not_fitted
        ],
        "skipped": fits.skipped,
        "pooled": {
            "t_end": asdict(fits.pool.parameter(0)) if len(fits.files) == 1 else None,
            **_values_of_laws(
                fits.values(),
                {name: min(one[name] for one in limits) for name in common},
            ),
            "verdict": fits.verdict,
            "power_shares": {name: list(share) for name, share in shares.items()},
        },
    }


def _record_of_recording(
    fitted: Fitted, known: list[tuple[str, float]]
) -> dict[str, Any]:
    judged = fitted.judged
    rates = judged.fit.heard[0].rates
    measured = slice(0 if judged.stream is None else None)
    return {
        "file": fitted.file,
        "t_end": asdict(judged.fit.parameter(0)),
        **_values_of_laws(judged.fitted_shares(), judged.limits),
        "truncation": asdict(fitted.truncation) if fitted.truncation else None,
        "verdict": judged.verdict,
        "contour_friction_fits": judged.contour_fits,
        "explained": judged.explained,
        "reason": judged.reason,
        "signal": judged.signal,
        "line": judged.line,
        "model": judged.model,
        "spread": judged.fit.spread,
        "radius_10_percent_off_shows": fitted.radius_shows,
        "carriers": [
            spectral_line_record(carrier, known) for carrier in fitted.carriers
        ],
        "residual": {
            "time": rates.time[measured].tolist(),
            "heard_hz": rates.frequency[measured].tolist(),
            "fitted_hz": _fitted_rates(judged.fit)[measured].tolist(),
            "error_hz": rates.error[measured].tolist(),
        },
    }


def _fitted_rates(one: Fit) -> np.ndarray:
    """Return the fitted rates (n,) [Hz] of the first sound of a fit."""
    rates = one.heard[0].rates
    return rates.frequency * np.exp(-one.residual[: len(rates.time)])


def _values_of_laws(
    values: Mapping[str, Value], limits: Mapping[str, float]
) -> dict[str, Any]:
    """Return the values by name, including `rolling` and `air` in any case.

    A law that was not fitted has no value, only an upper limit, or the value 0 without
    one."""
    absent = {"value": 0.0, "low": 0.0, "high": 0.0, "inner": [0.0, 0.0]}
    found = dict.fromkeys(("rolling", "air"), absent)
    for name, high in limits.items():
        found[name] = {"value": None, "low": 0.0, "high": high, "inner": [0.0, high]}
    return found | {name: asdict(v) for name, v in values.items()}


def table(record: dict[str, Any]) -> list[list[str]]:
    """Return the cells of a header, a row for each recording in the content of fit.json,
    and a row for all of them together."""
    laws = "rolling", "air", "impacts"
    limits = [head for law in laws for head in (law, "low", "high")]
    found = [["recording", "t_end [s]", *limits, "verdict"]]
    rows = [
        (Path(one["file"]).name, f"{one['t_end']['value']:.4f}", one)
        for one in record["files"]
    ]
    if len(rows) > 1:
        rows.append(("together", "", record["pooled"]))
    for name, end, values in rows:
        cells = [name, end]
        for law in laws:
            value = values.get(law, {})
            numbers = [value.get(key) for key in ("value", "low", "high")]
            cells += ["" if number is None else f"{number:.6g}" for number in numbers]
        found.append([*cells, values["verdict"]])
    return found


def sentences(fits: Fits) -> list[str]:
    """Return the results as sentences."""
    lines = [line for fitted in fits.files for line in _sentences_of_recording(fitted)]
    if len(fits.files) > 1:
        lines.insert(
            0, f"{fits.verdict}: together; {fitted_shares_in_words(fits.values())}"
        )
    if not has_film(fits.scene):
        lines.append("air was not considered because the scene has no air film")
    lines += [f"not fitted: {one.reason}" for one in fits.not_fitted]
    return lines + neglected_parts(fits.scene)


def _sentences_of_recording(fitted: Fitted) -> Iterator[str]:
    judged = fitted.judged
    end = fitted.judged.fit.parameter(0)
    method = f"{judged.line} in the {judged.signal}, {judged.model} motion"
    if judged.stream is not None:
        method += f", spread {judged.fit.spread:.2%}"
    yield f"{judged.verdict}: {fitted.file}; end at {end.value:.4f} s ({end.low:.4f} to {end.high:.4f}), {method}"
    yield f"  {fitted_shares_in_words(judged.fitted_shares())}"
    yield from _sentences_on_bursts(judged)
    if not judged.explained:
        yield (
            "  no motion explains the rates; the spectral line may be misidentified, and the "
            "intervals include the results of all lines"
        )
    if judged.reason:
        yield f"  {judged.reason}"
    elif not judged.contour_fits:
        yield (
            "  contour friction and film do not suffice; the other laws of the scene take more than a tenth "
            "of the power"
        )
    if judged.fitted_shares():
        detected = "be detected"
        if not fitted.radius_shows:
            detected = "not be detected; the shares would compensate for it"
        yield f"  an error of 10 % in the radius would {detected}"


def _sentences_on_bursts(judged: Judged) -> Iterator[str]:
    """Yield what depends on the number of bursts per turn, and limits of other laws."""
    impacts = judged.fitted_shares().get("impacts")
    if judged.stream is not None or impacts is None:
        return
    run = judged.run
    count = run.events_per_turn
    other = 3 - count
    words = {1: "one burst per turn", 2: "two bursts per turn"}
    # the inclination is proportional to rate^-2, nearly
    yield (
        f"  {run.rate_at_1s.value:.3g} bursts per second one second before the end, or at the start "
        f"if it is later; the sound suggests {words[count]}; with {words[other]}, impacts would be "
        f"{impacts.value * (other / count) ** 2:.3g}"
    )
    limits = " and ".join(
        f"{name} is at most {high:.2g}" for name, high in judged.limits.items()
    )
    yield f"  {limits}; at these values it would dissipate all of the power"


def _line_table(record: dict[str, Any]) -> list[list[str]]:
    """Return the cells of a header and a row for each spectral line in the first
    recordings."""
    rows = [
        [
            "recording",
            "spectral line [Hz]",
            "level [dB]",
            "spread [cents]",
            "drift [cents/s]",
            "from, to [s]",
            "near",
        ]
    ]
    for one in record["files"][:MAX_PANELS]:
        name = Path(one["file"]).name
        rows += [_line_row(name, carrier) for carrier in one["carriers"]]
    return rows


def _line_row(name: str, c: dict[str, Any]) -> list[str]:
    near = []
    if c["matched"]:
        near.append(
            "{of}, {cents:+.1f} cents from {frequency:.1f} Hz".format(**c["matched"])
        )
    if not c["heard"]:
        near.append("detected only by its sidebands")
    if c["reach"]:
        near.append(f"noise band with a half-width of {c['reach']:.0f} cents")
    return [
        name,
        f"{c['frequency']:.2f} ± {c['error']:.2f}",
        f"{c['level']:.0f}",
        f"{c['spread']:.1f}",
        f"{c['drift']:.2f} ± {c['drift_error']:.2f}, {c['course']}",
        f"{c['begin']:.2f}, {c['end']:.2f}",
        "; ".join(near),
    ]


def page(fits: Fits, record: dict[str, Any]) -> str:
    """Return a short report in Markdown."""
    lines = [
        f"# What slowed the disk '{fits.scene.name}'",
        "",
        *(f"* {s.strip()}" for s in [*sentences(fits), *fits.skipped]),
        "",
        "![measured and fitted rates](fit.png)",
        "",
        markdown_table(table(record)),
    ]
    line_table = _line_table(record)
    if len(line_table) > 1:
        lines += ["", "Spectral lines and the nearest resonances of the scene:", ""]
        lines.append(markdown_table(line_table))
    return "\n".join(lines) + "\n"


def _as_csv(rows: Sequence[Sequence[str]]) -> str:
    """Return the text of a CSV file; cells with a comma are in quotes."""
    text = StringIO()
    csv.writer(text, lineterminator="\n").writerows(rows)
    return text.getvalue()


def comparison_sentences(fits: Fits, simulated: dict[str, Any] | None) -> list[str]:
    """Return sentences on turns, bursts and exponent of recordings and simulation."""
    if simulated is None:
        return []
    rows = [(Path(one.file).name, one.measured) for one in fits.files]
    return [
        f"{name}: one second before the end, or at the start if it is later, turns per second "
        f"{_interval_text(numbers['turns_at_1s'])}, bursts {_interval_text(numbers['rate_at_1s'])}, "
        f"exponent {_interval_text(numbers['exponent'])}"
        for name, numbers in [*rows, ("simulated", simulated)]
    ]


def _interval_text(estimate: dict[str, Any]) -> str:
    value = (
        "not determined" if estimate["value"] is None else f"{estimate['value']:.3g}"
    )
    return f"{value} ({estimate['low']:.3g} to {estimate['high']:.3g})"


def _fitted_rate(numbers: dict[str, Any]) -> tuple[np.ndarray, np.ndarray]:
    """Return the remaining times (k,) [s] and the fitted turns per second (k,)."""
    remaining = np.array(numbers["loudness"]["time_left"])
    remaining = remaining[remaining > FIT.unused_end_duration]
    exponent = numbers["exponent"]
    steepness = exponent["value"] or (exponent["low"] + exponent["high"]) / 2
    reference = min(1.0, remaining.max())
    rate = numbers["turns_at_1s"]["value"] * (remaining / reference) ** -steepness
    return remaining, rate


def draw_comparison(fits: Fits, simulated: dict[str, Any], path: Path) -> None:
    """Draw measured and simulated turns, band levels, decays of lines, and levels over
    time."""
    shown = [(file_label(one.file), one.measured) for one in fits.files[:MAX_PANELS]]
    with png_figure(path, 2, 2, (11, 8)) as (_, axes):
        (rates, bands), (lines, levels) = axes
        for offset, (name, numbers) in enumerate([*shown, ("simulated", simulated)]):
            style = {
                "label": name,
                "color": "k" if name == "simulated" else f"C{offset}",
            }
            rates.plot(*_fitted_rate(numbers), **style)
            # frequencies of lines are compared, so only the bands are set apart
            places = [(1 + 0.03 * offset) * row["from"] for row in numbers["bands"]]
            _draw_intervals(bands, places, numbers["bands"], style)
            places = [row["frequency"]["value"] for row in numbers["lines"]]
            decay_rates = [row["decay_rate"] for row in numbers["lines"]]
            _draw_intervals(lines, places, decay_rates, style)
            levels.plot(
                numbers["loudness"]["time_left"], numbers["loudness"]["level"], **style
            )
        rates.set(
            xlabel="time left [s]",
            ylabel="turns per second",
            xscale="log",
            yscale="log",
        )
        bands.set(
            xlabel="band from [Hz]", ylabel="level [dB re strongest band]", xscale="log"
        )
        lines.set(xlabel="line [Hz]", ylabel="decay of the amplitude [1/s]")
        levels.set(xlabel="time left [s]", ylabel="level [dB(A) re loudest]")
        for axis in (rates.xaxis, rates.yaxis, bands.xaxis):
            label_plain_decades(axis)
        for panel in (rates, levels):
            panel.invert_xaxis()
        place_legend_above(rates, frameon=False)


def _draw_intervals(
    panel: "Axes",
    places: Sequence[float],
    estimates: Sequence[dict[str, Any]],
    style: dict[str, Any],
) -> None:
    """Draw the determined values of estimates with their intervals."""
    determined = [
        (place, *(estimate[key] for key in ("value", "low", "high")))
        for place, estimate in zip(places, estimates, strict=True)
        if estimate["value"] is not None
    ]
    at, middle, low, high = np.reshape(determined, (-1, 4)).T
    panel.errorbar(at, middle, (middle - low, high - middle), fmt="o", **style)


def draw(fits: Fits, path: Path) -> None:
    """Draw measured and fitted rates over the remaining time, and their differences."""
    shown = fits.files[:MAX_PANELS]
    with png_figure(
        path, 2, len(shown), (max(4.5 * len(shown), 7), 7), sharex="col", squeeze=False
    ) as (_, axes):
        for (above, below), fitted in zip(axes.T, shown, strict=True):
            _draw_fitted_run(above, below, fitted)


def _draw_fitted_run(above: "Axes", below: "Axes", fitted: Fitted) -> None:
    one = fitted.judged.fit
    decay = fitted.judged.decay
    rates = one.heard[0].rates
    is_measured = fitted.judged.stream is not None
    remaining = one.ends[0] - rates.time
    at = np.geomspace(remaining.min(), remaining.max(), 200)
    order = np.argsort(remaining)
    drawn = []
    for draw in one.draws[:: max(len(one.draws) // 120, 1)]:  # about 120 suffice
        left = np.maximum(at + draw[0] - one.ends[0], FIT.unused_end_duration)
        drawn.append(decay.frequency(left, np.maximum(draw[-3:], 0)))
    low, high = np.percentile(drawn / np.median(drawn, axis=0) - 1, [2.5, 97.5], axis=0)
    if is_measured:
        above.errorbar(
            remaining,
            rates.frequency,
            rates.error,
            fmt=".",
            color="#0072b2",
            label="measured from the phase",
        )
    else:
        above.fill_between(
            at, *np.percentile(drawn, [2.5, 97.5], axis=0), color="#d55e00", alpha=0.25
        )
    above.plot(
        remaining[order],
        _fitted_rates(one)[order],
        color="#d55e00",
        label=f"fitted: {fitted.judged.verdict}",
    )
    above.set(xscale="log", yscale="log", xlabel="time left [s]")
    above.set_ylabel(f"{fitted.judged.line}, periods per second [Hz]")
    name = file_label(fitted.file)
    above.set_title(f"{name}\n", loc="left")  # its legend is below
    above.tick_params(labelbottom=True)
    above.yaxis.set_major_formatter("{x:g}")
    above.yaxis.set_minor_formatter("{x:g}")
    place_legend_above(above, frameon=False)
    below.fill_between(
        at, 100 * low, 100 * high, color="#d55e00", alpha=0.25, label="95 % of the fit"
    )
    if is_measured:
        below.errorbar(
            remaining,
            100 * np.expm1(one.residual),
            100 * one.sigma,
            fmt=".",
            color="#0072b2",
        )
    below.axhline(0.0, color="#d55e00", lw=1)
    below.set(xlabel="time left [s]", ylabel="rate / fitted rate - 1 [%]")
    label_plain_decades(below.xaxis)
    below.invert_xaxis()
    place_legend_above(below, frameon=False)
