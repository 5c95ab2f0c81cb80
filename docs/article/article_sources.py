"""SOURCES: the runs, sweeps, charts and closed forms whose numbers the article inserts."""

import inspect
import json
import re
import sys
from collections import Counter, defaultdict
from collections.abc import Callable
from dataclasses import dataclass, replace
from importlib import import_module
from math import isfinite, pi
from pathlib import Path
from time import perf_counter

import numpy as np
import pyarrow.parquet as pq
from article_numbers import ROOT, Number, Numbers, Record, digest, file_digest, points

from dynamics import Motion, plan_motion
from dynamics.compliant.model_inputs import contact_law
from dynamics.disk import GRAVITY
from sonify import load_scene, shipped_scenes, solve
from sonify.claims.contact import (
    contact_resonance_frequency,
    measured_noise_band,
    predicted_vibration,
    radiated_bands,
)
from sonify.claims.finding import Finding
from sonify.claims.rattling import rate_follows_unevenness
from sonify.claims.shares import share_of_count
from sonify.hearing.audio_source import source_of
from sonify.hearing.settling.detector import settling_runs
from sonify.plan.contact import STEEP_RADIATION_ERROR_RANGE_DB
from sonify.plan.preflight import solvable_scene, solve_motion
from sonify.result import Result
from sonify.sound.radiation import listener_of
from sonify.sound.sources.contact_vibration import VibratingDisk
from sonify.sweeps.store import read_table
from sonify.sweeps.sweep import load_sweep
from sonify.sweeps.verdict import (
    unit_of,
    verdict_in_words,
    verdicts_of_sweep,
)
from sonify.sweeps.version import version

sys.path += [str(ROOT), str(ROOT / "tests" / "helpers"), str(ROOT / "docs")]
import exact_motion
from last_seconds import last_seconds

from benchmarks.timed_runs import read_csv

SHOWN = ROOT / "outputs" / "shown"
SWEEPS = SHOWN / "sweeps"
CHARTS = SHOWN / "charts"
CHAOTIC = {
    "glass-plate",
    "wood-table",
    "light-plate",
    "wavy",
    "coin",
    "coin-wood",
    "coin-polished",
}
"""Scenes whose last milliseconds are chaotic."""
CHAOTIC_SCATTER = 0.1
"""Relative difference of their numbers on another processor."""
SINGLE_EVENTS = {"first_flight", "longest_flight", "highest_flight", "last_inclination"}
"""Numbers of one flight, or of the last one: in a chaotic motion another processor has others."""
MOTION_VARIANTS = {
    "contour": ("dissipation", ()),
    "boundary_layer": (
        "dissipation",
        (
            "dissipation.contour_moment=0",
            "dissipation.boundary_layer_viscosity=1.5e-5",
            "dissipation.air_density=1.2",
        ),
    ),
    "moffatt": (
        "dissipation",
        ("dissipation.contour_moment=0", "dissipation.air_viscosity=1.8e-5"),
    ),
    "published-in-air": ("published", ("air.film=acts",)),
    "granite-rough": (
        "granite",
        ("roughness.rms=1e-7", "roughness.rms_edge=1e-7", "air.film=none"),
    ),
    **{
        f"coin-seed-{seed}": ("coin", (f"roughness.seed={seed}",)) for seed in (2, 3, 4)
    },
}
"""Name of a motion solved without its sound -> scene and changes."""
CURVE_POINTS = 90
NOISE_BAND_SCENES = ("granite", "glass")
"""Scenes of the figure of the contact resonance."""
STEEP_AIR_FILE = ROOT / "tests" / "references" / "steep_air.json"
"""Levels [dB] of finite elements of the air around an inclined disk."""
ONE_MODE_FILE = ROOT / "tests" / "references" / "one_mode.json"
"""Times of another program for a table with one mode, by the number of steps per time unit."""
DISK_LAWS = {
    "k2": ("paper: arm k₂ on ω·a₂", ("friction.arm_rolling=3e-5",)),
    "contour": ("contour friction", ("dissipation.contour_moment=2e-6",)),
    "mcdonald": (
        "power 5/2",
        ("dissipation.power_coefficient=4e-9", "dissipation.power_exponent=2.5"),
    ),
    "bildsten": ("boundary layers", ("dissipation.boundary_layer_viscosity=1.5e-5",)),
    "moffatt": ("viscous film", ("dissipation.air_viscosity=1.8e-5",)),
}
"""Key of a law of dissipation -> its name, and the scene keys of this law alone."""
THIN_DISK = (
    "disk.thickness=3.755e-5",
    "friction.arm_nutation=0",
    "friction.arm_rolling=0",
    "friction.arm_pivoting=0",
)


@dataclass(frozen=True, kw_only=True)
class Source:
    """A source of numbers.

    Parameters
    ----------
    measure : callable
        Function without arguments that returns a Record, whose time it does not contain.
    inputs : str
        Digest of its inputs.
    follows_program : bool
        True if the numbers follow from the program itself, so that they can be measured again;
        False for tables of sweeps and charts.
    """

    measure: Callable[[], Record]
    inputs: str
    follows_program: bool = True

    def record(self) -> Record:
        """Return the record with its computing time."""
        began = perf_counter()
        return replace(self.measure(), seconds=round(perf_counter() - began, 2))


def sources() -> dict[str, Source]:
    """Return all sources by name."""
    found = {}
    for name in shipped_scenes():
        scene = load_scene(name)
        found[name] = Source(
            measure=lambda name=name: run_record(name),
            inputs=scene_digest(scene.document),
        )
    for name, (base, changes) in MOTION_VARIANTS.items():
        document = load_scene(base).replace(*changes).document
        found[name] = Source(
            measure=lambda name=name: motion_record(name), inputs=scene_digest(document)
        )
    found["scene"] = Source(
        measure=scene_record,
        inputs=digest(
            {name: scene_digest(load_scene(name).document) for name in shipped_scenes()}
        ),
    )
    found["theory"] = Source(measure=theory_record, inputs=source_digest(theory_record))
    found["laws"] = Source(measure=laws_record, inputs=source_digest(laws_record))
    found["limits"] = Source(measure=limits_record, inputs=source_digest(limits_record))
    found["radiation"] = Source(
        measure=radiation_record, inputs=source_digest(radiation_record)
    )
    found["one-mode"] = Source(
        measure=one_mode_record,
        inputs=file_digest(ONE_MODE_FILE),
        follows_program=False,
    )
    for table in sorted(SWEEPS.glob("*/runs.parquet")):
        found[f"sweep-{table.parent.name}"] = Source(
            measure=lambda table=table: sweep_record(table.parent),
            inputs=file_digest(table),
            follows_program=False,
        )
    for table in sorted(CHARTS.glob("*.csv")):
        found[f"chart-{table.stem}"] = Source(
            measure=lambda table=table: chart_record(table),
            inputs=file_digest(table),
            follows_program=False,
        )
    found["detector"] = Source(
        measure=detector_record,
        inputs=file_digest(ROOT / "docs" / "detector.md"),
        follows_program=False,
    )
    return found


def scene_digest(document: dict) -> str:
    """Return the digest of a scene, in which a mesh counts with its content instead of its path."""
    surface = document.get("surface", {})
    if "file" not in surface:
        return digest(document)
    content = file_digest(Path(surface["file"]))
    return digest(document | {"surface": surface | {"file": content}})


def source_digest(function: Callable) -> str:
    """Return the digest of the text of a function, for numbers without other inputs."""
    return digest(inspect.getsource(function))


def number_of_finding(finding: Finding) -> Number:
    """Return the number of a finding."""
    return Number(
        value=finding.value,
        unit=finding.unit,
        margin=finding.margin if isfinite(finding.margin) else 0.0,
        at_least=finding.at_least if isfinite(finding.at_least) else None,
        at_most=finding.at_most if isfinite(finding.at_most) else None,
        tolerance=finding.tolerance,
        cause=finding.cause,
        undecided_because=finding.undecided_because,
    )


def numbers_of_findings(findings: list[Finding]) -> dict[str, Number]:
    """Return the finite values of findings by key, and their details by key.detail."""
    found = {}
    for finding in findings:
        if isfinite(finding.value):
            found[finding.key] = number_of_finding(finding)
        for name, value in finding.details.items():
            if isfinite(value):
                found[f"{finding.key}.{name}"] = Number(value=value)
    return found


def numbers_of_motion(motion: Motion) -> dict[str, Number]:
    """Return numbers that every motion has."""
    t = motion.t[-1]
    end = motion.at(t[None])[0]
    found = {
        "t_end": Number(value=float(motion.t_end), unit="s"),
        "last_inclination": Number(value=float(end[1]), unit="rad"),
        "energy_lost": Number(value=float(end[10]), unit="J"),
    }
    losses = motion.contact_losses
    if len(losses):
        lasts = np.array([loss.duration for loss in losses])
        heights = np.array([loss.height for loss in losses])
        found |= {
            "flights": Number(value=float(len(lasts))),
            "first_flight": Number(value=float(losses[0].t), unit="s"),
            "longest_flight": Number(value=float(lasts.max()), unit="s"),
            "highest_flight": Number(value=float(heights.max()), unit="m"),
            "open_share": Number(
                value=float(lasts.sum() / t),
                margin=float(2 * np.sqrt(np.sum(lasts**2)) / t),
            ),
        }
    return found


def rate_curve(motion: Motion) -> list[list[float]]:
    """Return the time left [s], the mean precession rate [Hz] and the inclination [rad]."""
    end = float(motion.t[-1])
    left = np.geomspace(end, max(1e-4 * end, 1e-3), CURVE_POINTS + 1)
    state = motion.at(np.clip(end - left, 0.0, end))
    rate = np.abs(np.diff(state[:, 0])) / (2 * pi * -np.diff(left))
    return points(
        np.sqrt(left[1:] * left[:-1]), rate, np.sqrt(state[1:, 1] * state[:-1, 1])
    )


def load_curve(motion: Motion, windows: int = 200) -> list[list[float]]:
    """Return the time [s], and the least and the greatest normal force over the weight."""
    end = float(motion.t[-1])
    t = np.linspace(0.0, end, 60 * windows + 1)[:-1]
    load = (motion.force(t)[:, 2] / motion.disk.weight).reshape(windows, -1)
    return points(
        t.reshape(windows, -1).mean(axis=1), load.min(axis=1), load.max(axis=1)
    )


def contact_curves(result: Result) -> tuple[dict[str, list[list[float]]], Number]:
    """Return the contact resonance, the noise band predicted and the band heard along a motion.

    The number is the ratio of the band heard to that predicted at the steep beginning.
    """
    expected = predicted_vibration(result.scene, result.motion.rolling)
    heard = measured_noise_band(result.sound, result.motion.rolling, expected)
    seen = np.isfinite(heard.frequency)
    bands = radiated_bands(result.scene, result.motion.rolling, expected, heard)
    shown = heard.time[seen][np.isin(heard.frequency[seen], bands.heard)]
    step = max(len(expected.t) // CURVE_POINTS, 1)
    curves = {
        "resonance": points(
            expected.t[::step],
            expected.inclination[::step],
            contact_resonance_frequency(expected)[::step],
        ),
        "expected": points(shown, bands.expected),
        "heard": points(heard.time[seen], heard.frequency[seen]),
    }
    tenth = max(len(bands.heard) // 10, 1)
    return curves, Number(
        value=float(np.median(bands.heard[:tenth] / bands.expected[:tenth]))
    )


def run_record(name: str) -> Record:
    """Solve a shipped scene with its sound."""
    result = solve(name)
    curves = {"rate": rate_curve(result.motion.rolling)}
    numbers = numbers_of_motion(result.motion.rolling) | numbers_of_findings(
        result.findings
    )
    if name == "published":
        curves["load"] = load_curve(result.motion.rolling)
    if name in NOISE_BAND_SCENES:
        of_contact, numbers["carrier_is_contact.at_first"] = contact_curves(result)
        curves |= of_contact
    modes = {
        f"mode_{k + 1}": Number(value=float(f), unit="Hz")
        for k, f in enumerate(result.modes.frequency[:9])
    }
    checks = {
        f"check.{check.key}": Number(value=check.value)
        for check in result.checks
        if isfinite(check.value) and check.key == "energy_balance"
    }
    return Record(
        command=f"python -m sonify run {name}",
        inputs=scene_digest(load_scene(name).document),
        version=version(),
        scatter=CHAOTIC_SCATTER if name in CHAOTIC else 1e-3,
        numbers=numbers | modes | checks,
        curves=curves,
        words={"outcome": result.motion.rolling_outcome.name}
        | {f"claim.{finding.key}": finding.claim for finding in result.findings},
        sound=last_seconds(
            np.concatenate(list(result.sound.audible.blocks())),
            result.sound.audible.sample_rate,
        ),
    )


def motion_record(name: str) -> Record:
    """Solve the motion of a variant."""
    base, changes = MOTION_VARIANTS[name]
    scene, plan = solvable_scene(load_scene(base).replace(*changes), None)
    motion = solve_motion(plan).rolling
    numbers = numbers_of_motion(motion)
    if "rattling" in motion.finding_groups:
        exponent = rate_follows_unevenness(scene.roughness.exponent, motion)
        numbers |= numbers_of_findings([exponent])
        numbers = {
            key: number for key, number in numbers.items() if key not in SINGLE_EVENTS
        }
    heights = (
        {"rms": Number(value=float(scene.roughness.rms), unit="m")}
        if scene.roughness
        else {}
    )
    options = "".join(f" --set {change}" for change in changes)
    return Record(
        command=f"python -m sonify run {base}{options}",
        inputs=scene_digest(scene.document),
        version=version(),
        scatter=CHAOTIC_SCATTER,
        numbers=numbers | heights,
        curves={"rate": rate_curve(motion)},
        words={"outcome": motion.rolling_outcome.name},
    )


def flat_numbers(document: dict, prefix: str) -> dict[str, Number]:
    """Return the numbers of a scene document by their keys, joined by dots."""
    found = {}
    for key, value in document.items():
        if isinstance(value, dict):
            found |= flat_numbers(value, f"{prefix}{key}.")
        elif isinstance(value, (int, float)) and not isinstance(value, bool):
            found[f"{prefix}{key}"] = Number(value=float(value))
    return found


def scene_record() -> Record:
    """Return the parameters of all shipped scenes, including defaults."""
    numbers = {}
    for name in shipped_scenes():
        numbers |= flat_numbers(load_scene(name).document, f"{name}.")
    return Record(
        command="python -m sonify scenes",
        inputs=digest(
            {name: scene_digest(load_scene(name).document) for name in shipped_scenes()}
        ),
        version=version(),
        numbers={
            key: number for key, number in numbers.items() if isfinite(number.value)
        },
    )


def theory_record() -> Record:
    """Evaluate closed forms of steady motion and of the elastic contact."""
    scene = load_scene("published")
    disk = scene.disk
    h = disk.aspect
    numbers = {
        "aspect": Number(value=h),
        "time_unit": Number(value=disk.time_unit, unit="s"),
        "flat_square": Number(value=exact_motion.flat_limit(h, 1.0)[0]),
        "flat_square_thin": Number(value=exact_motion.flat_limit(0.0, 1.0)[0]),
        "nutation_ratio": Number(value=float(exact_motion.flat_limit(h, 1.0)[1])),
        "nutation_ratio_thin": Number(
            value=float(exact_motion.flat_limit(0.0, 1.0)[1])
        ),
    }
    granite = load_scene("granite")
    law = contact_law(granite)
    for name, beta in (("steep", 0.1), ("flat", 0.001)):
        at = np.array([beta])
        a, b = law.semi_axes(at, granite.disk.weight)
        springs = law.springs(at, granite.disk.weight)
        numbers |= {
            f"granite_{name}": Number(value=beta, unit="rad"),
            f"granite_{name}.a": Number(value=float(a[0]), unit="m"),
            f"granite_{name}.b": Number(value=float(b[0]), unit="m"),
            f"granite_{name}.stiffness": Number(value=float(springs.kn[0]), unit="N/m"),
            f"granite_{name}.depth": Number(
                value=float(law.approach(at, granite.disk.weight)[0]), unit="m"
            ),
        }
    coin = load_scene("coin")
    steep = np.array([0.1])
    depth = contact_law(coin).approach(steep, coin.disk.weight)
    numbers["coin_depth"] = Number(value=float(depth[0]), unit="m")
    numbers["coin_depth.inclination"] = Number(value=float(steep[0]), unit="rad")
    numbers["coin_slowest_rate"] = Number(
        value=float(
            np.sqrt(GRAVITY / ((0.25 + coin.disk.aspect**2 / 3) * coin.disk.radius))
            / (2 * pi)
        ),
        unit="Hz",
    )
    return Record(
        command="python docs/article/measure.py --only theory",
        inputs=source_digest(theory_record),
        version=version(),
        numbers=numbers,
    )


def laws_record() -> Record:
    """Evaluate the exponent of each law of dissipation for a thin disk, alone and with its scene."""
    friction_exponent = import_module("sonify.claims.air").friction_exponent
    numbers = {}
    for key, (_, changes) in DISK_LAWS.items():
        scene = load_scene("published").replace(*THIN_DISK, *changes)
        numbers[key] = number_of_finding(friction_exponent(scene))
    precession_rate_exponent = import_module(
        "dynamics.compliant.law.unevenness"
    ).precession_rate_exponent
    for slope in (0.0, 0.5, 1.0):
        numbers[f"impacts_{slope:g}"] = Number(
            value=precession_rate_exponent(1 + 2 * slope)
        )
    return Record(
        command="python docs/article/measure.py --only laws",
        inputs=source_digest(laws_record),
        version=version(),
        numbers=numbers,
    )


def derived_records(numbers: Numbers) -> Numbers:
    """Return the records that summarise others: the mean over the seeds of the rattling coin."""
    seeds = [
        name for name in numbers if name == "coin" or name.startswith("coin-seed-")
    ]
    found = [numbers[name].numbers["rate_follows_unevenness"].value for name in seeds]
    if len(found) < 2:
        return Numbers()
    exponent = Number(
        value=float(np.mean(found)),
        margin=float(2 * np.std(found, ddof=1) / len(found) ** 0.5),
    )
    return Numbers(
        coins=Record(
            command=f"python docs/article/measure.py {' '.join(f'--only {name}' for name in seeds)}",
            inputs=digest([numbers[name].inputs for name in seeds]),
            version=numbers["coin"].version,
            numbers={"exponent": exponent, "seeds": Number(value=float(len(found)))},
        )
    )


def radiation_record() -> Record:
    """Compare the radiation of an inclined disk with finite elements of the air around it."""
    reference = json.loads(STEEP_AIR_FILE.read_text("utf-8"))
    scene = load_scene("granite")
    wavenumbers = np.array(reference["number"])
    excess = {}
    for found in reference["disks"]:
        changed = scene.replace(
            f"air.viscosity={1e-4 * scene.air.viscosity}",
            f"disk.thickness={found['height'] * scene.disk.radius}",
        )
        disk = changed.disk
        source = VibratingDisk(changed, listener_of(changed))
        hertz = wavenumbers * changed.air.sound_speed / (2 * pi * disk.radius)
        scale = (disk.mass / (changed.air.density * disk.radius)) ** 2
        for beta, level in zip(found["inclination"], found["level_db"], strict=True):
            loudness = scale * source.mean_square_pressure(beta, hertz)
            excess[found["height"], beta] = 10 * np.log10(loudness) - level
    own = reference["disks"][0]["height"]
    rows = [
        (beta, k, value)
        for (height, beta), values in excess.items()
        if height == own
        for k, value in zip(wavenumbers, values, strict=True)
    ]
    others = {beta: [] for beta in reference["disks"][1]["inclination"]}
    for (height, beta), values in excess.items():
        if height != own:
            others[beta].append(values[wavenumbers <= 4])
    numbers = {
        "thinnest": Number(value=float(min(d["height"] for d in reference["disks"]))),
        "thickest": Number(value=float(max(d["height"] for d in reference["disks"]))),
    }
    for name, beta in zip(("low", "middle", "steep"), sorted(others), strict=True):
        numbers |= {
            f"{name}.inclination": Number(value=beta, unit="rad"),
            f"{name}.least": Number(value=float(np.min(others[beta])), unit="dB"),
            f"{name}.greatest": Number(value=float(np.max(others[beta])), unit="dB"),
        }
    return Record(
        command="python docs/article/measure.py --only radiation",
        inputs=source_digest(radiation_record),
        version=version(),
        scatter=0.05,
        numbers=numbers,
        curves={"excess": points(*zip(*rows, strict=True))},
    )


def one_mode_record() -> Record:
    """Read the times of another program for the published disk on one mode of a table."""
    times = json.loads(ONE_MODE_FILE.read_text("utf-8"))
    numbers = {
        "start": Number(value=250 * load_scene("published").disk.time_unit, unit="s")
    }
    for name in ("lost", "flat"):
        found = times[name]["4e+06"]
        numbers[name] = Number(
            value=float(np.mean(found)), margin=float(2 * np.std(found)), unit="s"
        )
    return Record(
        command="python tests/references/one_mode.py",
        inputs=file_digest(ONE_MODE_FILE),
        version=version(),
        numbers=numbers,
    )


LIMITS = {
    "solved_inclination": ("dynamics.solver_settings", "MIN_SOLVED_INCLINATION", "rad"),
    "contact_inclination": (
        "dynamics.compliant.law.hertz_mindlin",
        "MIN_CONTACT_INCLINATION",
        "rad",
    ),
    "flat_inclination": (
        "dynamics.compliant.stepping.time_loop",
        "FLAT_INCLINATION",
        "rad",
    ),
    "film_knudsen": ("dynamics.film.activation", "END_KNUDSEN_NUMBER", ""),
    "tilted_film_slope": ("dynamics.landing.equations", "MAX_FILM_SLOPE", ""),
    "film_share": ("dynamics.solver_settings", "MIN_RELEVANT_SHARE", ""),
    "rolling_curvature": (
        "dynamics.compliant.model_selection",
        "MAX_RELATIVE_CURVATURE_FOR_ROLLING",
        "",
    ),
    "table_frequency": (
        "dynamics.compliant.modes_from_scene",
        "MAX_TABLE_FREQUENCY",
        "Hz",
    ),
    "audible_frequency": ("dynamics.solver_settings", "MAX_AUDIBLE_FREQUENCY", "Hz"),
    "radiation_error": ("sonify.plan.contact", "RADIATION_ERROR_BOUND_DB", "dB"),
    "short_wave_error": (
        "sonify.plan.contact",
        "MAX_SHORT_WAVE_UNDERESTIMATE_DB",
        "dB",
    ),
    "deflection_ratio": ("sonify.plan.table", "MAX_DEFLECTION_RATIO", ""),
    "turning_power": ("dynamics.film.wedge", "ROTATION_POWER_COEFFICIENT", ""),
    "moving_modes": (
        "dynamics.stepping_core.rim_modes",
        "MAX_MOVING_MODE_FREQUENCY",
        "Hz",
    ),
    "contact_loss_rms": (
        "dynamics.compliant.model_selection",
        "LIFT_OFF_FORCE_RMS",
        "",
    ),
    "vibration_frequency": (
        "dynamics.compliant.law.linear_response",
        "MIN_VIBRATION_FREQUENCY",
        "Hz",
    ),
    "mode_band": ("sonify.claims.rattling", "MODE_BAND_HALF_WIDTH", ""),
    "halt_at": ("sonify.claims.two_way", "ALMOST_FLAT_INCLINATION", "rad"),
}
"""Name of a limit -> module, constant and unit."""


def limits_record() -> Record:
    """Read the limits of the models from the constants of the program."""
    numbers = {
        name: Number(value=float(vars(import_module(module))[constant]), unit=unit)
        for name, (module, constant, unit) in LIMITS.items()
    }
    numbers["steep_radiation_low"], numbers["steep_radiation_high"] = (
        Number(value=end, unit="dB") for end in STEEP_RADIATION_ERROR_RANGE_DB
    )
    for name in ("toy", "thorne"):
        decision = plan_motion(load_scene(name)).film_decision
        numbers[f"{name}_film_from"] = Number(value=decision.inclination, unit="rad")
    return Record(
        command="python docs/article/measure.py --only limits",
        inputs=source_digest(limits_record),
        version=version(),
        numbers=numbers,
    )


def share_number(count: int, total: int) -> Number:
    """Return a share of draws with its 95 % Wilson interval."""
    share = share_of_count(count, total)
    return Number(
        value=count / total, low=share.low, high=share.high, unit=f"of {total}"
    )


def sweep_record(folder: Path) -> Record:
    """Read the shares and medians of the table of a sweep."""
    table = pq.read_table(folder / "runs.parquet").to_pydict()
    total = len(table["run"])
    numbers = {"runs": Number(value=float(total))}
    for outcome, count in Counter(filter(None, table["outcome"])).items():
        numbers[f"outcome.{outcome}"] = share_number(count, total)
    numbers["errors"] = Number(
        value=float(sum(error is not None for error in table["error"]))
    )
    for column, values in table.items():
        decided = [value for value in values if value is not None]
        if column.endswith("_holds"):
            key = column.removesuffix("_holds")
            if decided:
                numbers[f"holds.{key}"] = share_number(sum(decided), len(decided))
            judged = sum(value is not None for value in table.get(key, values))
            numbers[f"undecided.{key}"] = Number(
                value=float(max(judged - len(decided), 0))
            )
        elif decided and column == "t_end":
            low, middle, high = np.percentile(decided, [2.5, 50, 97.5])
            numbers[column] = Number(
                value=float(middle), low=float(low), high=float(high), unit="s"
            )
    versions = sorted({str(found) for found in table["version"] if found})
    words = {}
    if folder.name.startswith("verdict-"):
        words, thresholds = verdict_words(folder)
        numbers |= thresholds
    return Record(
        command=f"python -m sonify sweep {folder.name}",
        inputs=file_digest(folder / "runs.parquet"),
        version=", ".join(versions),
        seconds=0.0,
        numbers=numbers,
        curves=sweep_curves(folder.name, table),
        words=words,
    )


def verdict_words(folder: Path) -> tuple[dict[str, str], dict[str, Number]]:
    """Return the verdicts of a sweep in words, and the values at which answers change."""
    sweep = load_sweep(folder.name)
    rows, _ = read_table(folder / "runs.parquet")
    words = {}
    thresholds = {}
    for key, verdict in verdicts_of_sweep(rows, sweep).items():
        words[f"verdict.{key}"] = verdict_in_words(verdict, sweep)
        if (found := verdict.threshold) is not None:
            assert verdict.dependence is not None
            thresholds[f"threshold.{key}"] = Number(
                value=found.value,
                low=found.low,
                high=found.high,
                unit=unit_of(verdict.dependence.axis).strip(),
            )
    return words, thresholds


DRAWN_COLUMNS = {
    "halt-table": (
        "halt",
        "surface.modes.0.modal_mass",
        "air.pressure",
        "t_end",
        "contact_kept_holds",
    ),
    "pitch": ("louder", "surface.thickness", "audio.distance", "table_is_louder"),
}
"""Sweep -> name of the curve in a figure, and its columns."""


def sweep_curves(name: str, table: dict[str, list]) -> dict[str, list[list[float]]]:
    """Return the points that a figure draws from a sweep, without runs that have no value."""
    if name not in DRAWN_COLUMNS:
        return {}
    curve, *columns = DRAWN_COLUMNS[name]
    rows = zip(*(table[column] for column in columns), strict=True)
    return {curve: points(*zip(*(row for row in rows if None not in row), strict=True))}


def chart_record(table: Path) -> Record:
    """Read the smallest error and the time of each method from the table of a chart."""
    records = [record for record in read_csv(table) if not record.left_out]
    groups = defaultdict(list)
    for record in records:
        groups[record.case, record.family, record.method].append(record)
    numbers = {
        "runs": Number(value=float(len(records))),
        "failed": Number(value=float(sum(bool(record.failure) for record in records))),
    }
    for (case, family, method), found in groups.items():
        good = [record for record in found if not record.failure]
        key = slug(f"{case} {family} {method}")
        if good:
            best = min(good, key=lambda record: record.error)
            numbers[f"{key}.error"] = Number(value=best.error)
            numbers[f"{key}.seconds"] = Number(value=best.seconds, unit="s")
    commit = re.search(r"commit (\w+)", table.with_suffix(".md").read_text("utf-8"))
    return Record(
        command=f"python -m sonify chart {table.stem.replace('_', '-')}",
        inputs=file_digest(table),
        version=f"commit {commit[1]}" if commit else version(),
        numbers=numbers,
    )


def slug(words: str) -> str:
    """Return words as one name of lower-case letters, digits and hyphens."""
    return re.sub(r"[^a-z0-9.]+", "-", words.lower()).strip("-.")


def detector_record() -> Record:
    """Read misses and false alarms from the table that benchmarks/ear.py printed."""
    text = (ROOT / "docs" / "detector.md").read_text("utf-8")
    row = r"^\| ([^|]+) \| (\d+) \| (\d+) of (\d+) \|"
    numbers = {}
    for kind, runs, count, total in re.findall(row, text, re.MULTILINE):
        numbers[slug(kind)] = share_number(int(count), int(total))
        numbers[f"{slug(kind)}.runs"] = Number(value=float(runs))
    for key, start in (
        ("recorded", ""),
        ("imitations", "imitation"),
        ("takes", "simulated"),
    ):
        rows = [
            (int(count), int(total))
            for kind, _, count, total in re.findall(row, text, re.MULTILINE)
            if (
                kind.startswith(start)
                if start
                else not re.match("imit|simul|coins", kind)
            )
        ]
        if rows:
            numbers[key] = share_number(
                sum(c for c, _ in rows), sum(t for _, t in rows)
            )
    return Record(
        command="python benchmarks/ear.py FOLDER",
        inputs=file_digest(ROOT / "docs" / "detector.md"),
        version=version(),
        numbers=numbers,
    )


def recordings_record(folder: Path) -> Record:
    """Listen to the recordings of coins in a folder; only numbers are kept."""
    numbers = {}
    words = {}
    for file in sorted(folder.glob("*.flac")):
        for k, run in enumerate(settling_runs(source_of(file)), 1):
            key = f"{slug(file.stem)}-{k}"
            exponent = run.exponent
            numbers |= {
                f"{key}.exponent": Number(
                    value=exponent.value or 0.0, low=exponent.low, high=exponent.high
                ),
                f"{key}.rate": interval(run.rate_at_1s),
                f"{key}.end": interval(run.t_end),
                f"{key}.score": Number(value=run.score),
            }
            words[key] = f"{file.stem}, run {k}"
            if exponent.value is None:
                words[f"{key}.undetermined"] = "yes"
    if not words:
        raise FileNotFoundError(f"{folder}: no recording with a disk or coin")
    return Record(
        command="python -m sonify listen FILE",
        inputs=digest(sorted(words)),
        version=version(),
        numbers=numbers,
        words=words,
    )


def interval(measured) -> Number:
    """Return a measured value of the detector with its 95 % interval."""
    return Number(value=measured.value, low=measured.low, high=measured.high)
