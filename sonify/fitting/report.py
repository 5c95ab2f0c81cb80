"""FITS -> FILES: fit.json, fit.csv, a picture and a short page."""

from dataclasses import asdict
from pathlib import Path
from typing import Any

import numpy as np

from sonify.fitting.decay_model import has_film, neglected_parts
from sonify.fitting.fu_berlin import PUBLISHED_EXPONENTS
from sonify.fitting.least_squares import UNUSED_END, values_in_words
from sonify.fitting.line_selection import shares_of_power
from sonify.fitting.result import Fits, Fitted
from sonify.report.figure import figure_at, legend_above, plain_decades
from sonify.report.recording import carrier_numbers
from sonify.report.write import finite, write_json
from sonify.runtime.files import atomic_write, claimed_folder, first_numbered

ABSENT_LAW = {"value": 0.0, "low": 0.0, "high": 0.0, "inner": [0.0, 0.0]}
"""Share of a law that was not fitted, such as the film in a vacuum."""
MAX_PANELS = 6
"""Largest number of recordings in the picture."""
BAND_DRAWS = 120
"""Approximate number of draws in a band of the picture."""


def write_fits(fits: Fits, out: str | Path | None = None) -> Path:
    """Write fit.json, fit.csv, fit.png and fit.md into `out` and return the folder.

    Raises OutputError if it cannot be written.
    """
    with claimed_folder(out or new_folder(fits.files[0].file)) as folder:
        write_json(finite(as_json(fits)), folder / "fit.json")
        with atomic_write(folder / "fit.png") as temporary:
            draw(fits, temporary)
        with atomic_write(folder / "fit.csv") as temporary:
            temporary.write_text("\n".join(table(fits, ",")) + "\n", encoding="utf-8")
        with atomic_write(folder / "fit.md") as temporary:
            temporary.write_text(page(fits), encoding="utf-8")
    return folder


def new_folder(file: str) -> Path:
    """Return a new folder outputs/fit/<name of the recording>, or <name>-2 and so on."""
    return first_numbered(
        Path("outputs") / "fit" / Path(file).stem, lambda folder: not (folder / "fit.json").exists()
    )


def as_json(fits: Fits) -> dict[str, Any]:
    """Return the content of fit.json."""
    end = asdict(fits.pool.value(0)) if len(fits.files) == 1 else None
    pool = {"t_end": end} | _values(fits.values()) | {"verdict": fits.verdict}
    shares = {
        name: list(share)
        for name, share in shares_of_power(fits.files[0].judged.decline, fits.pool).items()
    }
    files = [_one(f, fits.resonances) for f in fits.files]
    return {
        "scene": fits.scene.name,
        "left_out": neglected_parts(fits.scene),
        "files": files,
        "pooled": pool | {"power_shares": shares},
    }


def _one(fitted: Fitted, known) -> dict[str, Any]:
    judged = fitted.judged
    rates = fitted.judged.fit.heard[0].rates
    head = {"file": fitted.file, "t_end": asdict(judged.fit.value(0))} | _values(judged.values())
    return head | {
        "truncation": asdict(fitted.truncation) if fitted.truncation else None,
        "verdict": judged.verdict,
        "contour_friction_fits": judged.contour_fits,
        "explained": judged.explained,
        "signal": judged.signal,
        "line": judged.line,
        "model": judged.model,
        "spread": judged.fit.spread,
        "radius_10_percent_off_shows": fitted.radius_shows,
        "carriers": [carrier_numbers(carrier, known) for carrier in fitted.carriers],
        "published_way": {
            name: e._asdict()
            | ({"theirs": PUBLISHED_EXPONENTS[name]} if name in PUBLISHED_EXPONENTS else {})
            for name, e in (fitted.published_way or {}).items()
        },
        "residual": {
            "time": rates.time.tolist(),
            "heard_hz": rates.frequency.tolist(),
            "fitted_hz": (rates.frequency * np.exp(-judged.fit.residual)).tolist(),
            "error_hz": rates.error.tolist(),
        },
    }


def _values(values) -> dict[str, Any]:
    """Return the values by name, always with `rolling` and `air`."""
    return dict.fromkeys(("rolling", "air"), ABSENT_LAW) | {
        name: asdict(v) for name, v in values.items()
    }


def table(fits: Fits, separator: str = " | ") -> list[str]:
    """Return one row for each recording and one for all together."""
    lines = [
        separator.join(
            ("recording", "t_end [s]", "rolling", "low", "high", "air", "low", "high", "verdict")
        )
    ]
    rows = [
        (f.file, f.judged.fit.value(0).value, f.judged.values(), f.judged.verdict)
        for f in fits.files
    ]
    if len(rows) > 1:
        rows.append(("together", None, fits.values(), fits.verdict))
    for name, end, values, verdict in rows:
        numbers = [
            f"{x:.6g}"
            for v in (_values(values)[k] for k in ("rolling", "air"))
            for x in (v["value"], v["low"], v["high"])
        ]
        lines.append(
            separator.join(
                (Path(name).name, "" if end is None else f"{end:.4f}", *numbers, verdict)
            )
        )
    return lines


def sentences(fits: Fits) -> list[str]:
    """Return the results in words."""
    said = [line for fitted in fits.files for line in _of_one(fitted)]
    if len(fits.files) > 1:
        said.insert(0, f"{fits.verdict}: together; {values_in_words(fits.values())}")
    if not has_film(fits.scene):
        said.append("air was not considered: the scene has no air film")
    return said + neglected_parts(fits.scene)


def _of_one(fitted):
    judged = fitted.judged
    end = fitted.judged.fit.value(0)
    told = f"the {judged.line} in the {judged.signal}, along {judged.model} motion, within {judged.fit.spread:.2%}"
    yield f"{judged.verdict}: {fitted.file}; end at {end.value:.4f} s ({end.low:.4f} to {end.high:.4f}), {told}"
    yield f"  {values_in_words(judged.values())}"
    if not judged.explained:
        yield "  no motion explains it: it may be another line, and the intervals hold what every line would tell"
    if not judged.contour_fits:
        yield "  contour friction and film do not explain it; the scene's own law takes more than a tenth of the power"
    yield f"  a radius 10 % off {'would show' if fitted.radius_shows else 'cannot be told: the shares take it up'}"
    for name, e in (fitted.published_way or {}).items():
        theirs = (
            "; theirs on granite {:.3f}, one run ± {:.3f}".format(*PUBLISHED_EXPONENTS[name])
            if name in PUBLISHED_EXPONENTS
            else ""
        )
        yield f"  as published, {name}: exponent {e.value:.3f} ± {e.error:.3f}, {e.columns} columns{theirs}"


def _carriers(fits: Fits) -> list[str]:
    """Return one row for each spectral line in the first recordings, with its assignment."""
    head = (
        "recording",
        "carrier [Hz]",
        "level [dB]",
        "spread [cents]",
        "drift [cents/s]",
        "from, to [s]",
        "near",
    )
    rows = [
        (f.file, carrier_numbers(carrier, fits.resonances))
        for f in fits.files[:MAX_PANELS]
        for carrier in f.carriers
    ]
    return [" | ".join(head)] + [_carrier(Path(name).name, c) for name, c in rows]


def _carrier(name, c):
    near = (
        ["{of}, {cents:+.1f} cents from {frequency:.1f} Hz".format(**c["matched"])]
        if c["matched"]
        else []
    )
    drift = f"{c['drift']:.2f} ± {c['drift_error']:.2f}, {c['course']}"
    place = (
        f"{c['frequency']:.2f} ± {c['error']:.2f} | {c['level']:.0f} | {c['spread']:.1f} | {drift}"
    )
    near += [] if c["heard"] else ["heard by its sidebands alone"]
    near += [f"a band of noise that reaches {c['reach']:.0f} cents"] if c["reach"] else []
    return f"{name} | {place} | {c['begin']:.2f}, {c['end']:.2f} | {'; '.join(near)}"


def page(fits: Fits) -> str:
    """Return a short page in Markdown."""
    lines = [
        f"# What slowed the disk '{fits.scene.name}'",
        "",
        *(f"* {s.strip()}" for s in sentences(fits)),
        "",
    ]
    lines += ["![heard and fitted](fit.png)", "", *_as_markdown(table(fits))]
    if any(fitted.carriers for fitted in fits.files[:MAX_PANELS]):
        lines += ["", "Carriers, and the resonances of the scene that they are near:", ""]
        lines += _as_markdown(_carriers(fits))
    return "\n".join(lines) + "\n"


def _as_markdown(rows):
    """Return a Markdown table; the first row is the head."""
    return [
        f"| {rows[0]} |",
        "|---" * len(rows[0].split(" | ")) + "|",
        *(f"| {row} |" for row in rows[1:]),
    ]


def draw(fits: Fits, path: Path):
    """Draw measured and fitted rates against the time left, and their differences, for each
    recording."""
    shown = fits.files[:MAX_PANELS]
    with figure_at(
        path, 2, len(shown), (max(4.5 * len(shown), 7), 7), sharex="col", squeeze=False
    ) as (_, axes):
        for (above, below), fitted in zip(axes.T, shown, strict=True):
            _draw_one(above, below, fitted)


def _draw_one(above, below, fitted):
    one = fitted.judged.fit
    decline = fitted.judged.decline
    rates = one.heard[0].rates
    left = one.ends[0] - rates.time
    fitted_rate = rates.frequency / np.exp(one.residual[: len(left)])
    at = np.geomspace(left.min(), left.max(), 200)
    order = np.argsort(left)
    drawn = np.array(
        [
            _rate_of_draw(decline, one, d, at)
            for d in one.draws[:: max(len(one.draws) // BAND_DRAWS, 1)]
        ]
    )
    low, high = np.percentile(drawn / np.median(drawn, axis=0) - 1, [2.5, 97.5], axis=0)
    above.errorbar(
        left, rates.frequency, rates.error, fmt=".", color="#0072b2", label="heard, from the phase"
    )
    above.plot(
        left[order], fitted_rate[order], color="#d55e00", label=f"fitted: {fitted.judged.verdict}"
    )
    above.set(xscale="log", yscale="log", xlabel="time left [s]")
    above.set_ylabel(f"{fitted.judged.line}, periods a second [Hz]")
    above.set_title(f"{Path(fitted.file).name}\n", loc="left")  # its legend is below
    above.tick_params(labelbottom=True)
    above.yaxis.set_major_formatter("{x:g}")
    above.yaxis.set_minor_formatter("{x:g}")
    legend_above(above, frameon=False)
    below.fill_between(
        at, 100 * low, 100 * high, color="#d55e00", alpha=0.25, label="95 % of the fit"
    )
    below.errorbar(left, 100 * np.expm1(one.residual), 100 * one.sigma, fmt=".", color="#0072b2")
    below.axhline(0.0, color="#d55e00", lw=1)
    below.set(xlabel="time left [s]", ylabel="heard over fitted - 1 [%]")
    plain_decades(below.xaxis)
    below.invert_xaxis()
    legend_above(below, frameon=False)


def _rate_of_draw(decline, one, draw, at):
    """Return the rate of one draw of ends and shares at times `at` (k,) [s] before the fitted end."""
    left = np.maximum(at + draw[0] - one.ends[0], UNUSED_END)
    return decline.frequency(left, np.maximum(draw[len(one.ends) :], 0))
