"""RESULT -> FILES: run.json, motion.npz, the modes, the pictures and the page that shows them
all."""

import json
import shutil
import subprocess
from concurrent.futures import Future
from dataclasses import asdict
from functools import lru_cache
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path
from platform import platform, python_version
from typing import TYPE_CHECKING, Any

import numpy as np

from dynamics import Motion
from dynamics.motion import COLUMNS
from modal import as_json, write_vtu
from sonify.claims.air import air_scalars
from sonify.claims.checks import Check
from sonify.claims.finding import Finding
from sonify.hearing.loudness import MissingExtraError, roughness
from sonify.plan.supports import over_the_run
from sonify.plan.unused import unused_keys
from sonify.report.pictures import Pictures
from sonify.runtime.files import whole
from sonify.runtime.progress import Stages
from sonify.sound.audible_modes import RingDown
from sonify.sound.pressure import Sound

if TYPE_CHECKING:
    from sonify.result import Result

NAME = "eulers-disk-sonify"
LIBRARIES = ("numpy", "scipy", "numba", "heyoka", "scikit-fem", "soundfile", "matplotlib")


def told_by_the_page(result: "Result", pictures: Pictures) -> dict[str, Any]:
    """Return the numbers of the page of a result, as it holds them."""
    from sonify.report import page  # loads slowly

    return page.told(result, pictures.parts())


def write_record(
    result: "Result", stages: Stages, pictures: Pictures, record: Future, told: Future
) -> None:
    """Write everything but the sound into the folder of the result; the stages are timed. `record`
    and `told` have become what run.json and the page hold."""
    from sonify.report import page  # loads slowly

    with stages.stage("motion.npz, modes"):
        write_motion(result.motion, result.out / "motion.npz")
        rings = {"ring_down": finite(ring_down_record(result.sound.ringing))}
        write_json(as_json(result.modes) | moved(result) | rings, result.out / "modes.json")
        with whole(result.out / "modes.vtu") as temporary:
            write_vtu(result.modes, temporary)
    with stages.stage("pictures"):
        pictures.write(result)
    if result.scene.surface.kind == "mesh":
        keep_mesh(Path(result.scene.surface.file), result.out)
    write_json(record.result() | {"seconds": rounded(result.seconds)}, result.out / "run.json")
    page.write(result, result.out / "report.html", told.result())


def moved(result: "Result") -> dict:
    """Return what modes.json says of the modes of a disk on its contact as the inclination [rad]
    falls."""
    steps = over_the_run(result.scene, result.motion, result.plan.highest_mode)
    columns = ("frequency", "decay_rate")
    rows = [
        vars(s) | {name: getattr(s.modes, name, np.array(None)).tolist() for name in columns}
        for s in steps
    ]
    return (
        {"over_the_run": [{k: v for k, v in row.items() if k != "modes"} for row in rows]}
        if rows
        else {}
    )


def write_motion(motion: Motion, path: Path):
    """Write instants [s], states, forces [N] and regimes at the ends of the pieces, the jumps and
    the transitions."""
    jumps = motion.jumps
    events = motion.transitions
    with whole(path) as temporary:
        np.savez(
            temporary,
            t=motion.t,
            state=motion.state,
            columns=np.array(COLUMNS),
            force=motion.force(motion.t),
            regime=motion.regime(motion.t),
            jump_time=jumps.t,
            jump_before=jumps.before,
            jump_after=jumps.after,
            transition_time=np.array([e.t for e in events]),
            transition_before=np.array([e.before for e in events]),
            transition_after=np.array([e.after for e in events]),
            transition_guard=np.array([e.guard for e in events]),
        )


def keep_mesh(file: Path, out: Path):
    """Copy the mesh of a table beside run.json, which names it alone and so is a scene on any
    machine."""
    if (out / file.name).resolve() != file.resolve():
        with whole(out / file.name) as temporary:
            shutil.copyfile(file, temporary)


def scene_record(scene) -> dict:
    """Return every key of a scene; a mesh by the name that it has beside run.json."""
    record = finite(asdict(scene))
    if scene.surface.kind == "mesh":
        record["surface"]["file"] = Path(scene.surface.file).name
    return record


def run_record(result: "Result") -> dict:
    """Return what run.json holds: plain values, none of them infinite or not a number."""
    sound = result.sound
    return {
        "scene": scene_record(result.scene),
        "unused": list(unused_keys(result.scene)),
        "plan": asdict(result.plan),
        "outcome": {"name": result.motion.outcome.name, "sentence": result.motion.outcome.sentence},
        "motion": {"end": float(result.motion.t[-1]), "integrator": result.motion.integrator},
        "sound": {
            "sample_rate": sound.sample_rate,
            "duration": sound.duration,
            "peak_pascal": sound.peak,
            "full_scale_pascal": sound.full_scale,
            "gain_db": float(sound.gain_db),
            "loudness_lufs": finite(sound.loudness[0]),
            "roughness": "not in a draft"
            if result.plan.accuracy == "draft"
            else roughness_before(sound),
            "stem_peak_pascal": sound.stem_peak,
            "energy_below_100_hz_300_hz": sound.low_share,
            "ring_down": finite(ring_down_record(sound.ringing)),
            "audible_full_scale_pascal": sound.audible.full_scale,
            "audible_loudness_lufs": finite(sound.loudness[1]),
        },
        "checks": [finite(asdict(check)) | {"passed": check.passed} for check in result.checks],
        "findings": [
            finite(asdict(f)) | {"verdict": f.verdict, "holds": f.holds} for f in result.findings
        ],
        "seconds": rounded(result.seconds),
        "versions": versions(),
    }


def ring_down_record(ringing: RingDown) -> dict:
    """Return frequency [Hz], decay rate and T60 of the modes after the motion, and the mean gap [m]
    of the film."""
    columns = {
        "frequency": ringing.frequency,
        "decay_rate": ringing.decay_rate,
        "decay_time": ringing.decay_time,
        "decay_rate_without_film": ringing.without_film,
    }
    return {name: column.tolist() for name, column in columns.items()} | {"mean_gap": ringing.gap}


def rounded(seconds: dict[str, float]) -> dict[str, float]:
    """Return the seconds of the stages to the millisecond."""
    return {name: round(spent, 3) for name, spent in dict(seconds).items()}


def summary(result: "Result") -> dict[str, Any]:
    """Return the plain scalars of a result, one row of a table: of each finding and check, by its
    key, the value and whether it holds or passed; the seconds of each stage."""
    row = {
        "outcome": result.motion.outcome.name,
        "t_end": float(result.motion.t[-1]),
        "passed": result.passed,
    }
    row |= {"sound_seconds": result.sound.duration, "peak_pascal": result.sound.peak}
    row |= air_scalars(result.scene, result.motion)
    row |= dict(
        zip(("energy_below_100_hz", "energy_below_300_hz"), result.sound.low_share, strict=True)
    )
    return row | judged(result.findings, result.checks) | timed(result.seconds)


def judged(findings: list[Finding], checks: list[Check]) -> dict[str, Any]:
    """Return of each finding and check, by its key, the value and whether it holds or passed."""
    row: dict[str, Any] = {}
    for finding in findings:
        row |= {finding.key: finding.value, f"{finding.key}_holds": finding.holds}
    for check in checks:
        row |= {check.key: check.value, f"{check.key}_passed": check.passed}
    return row


def timed(seconds: dict[str, float]) -> dict[str, float]:
    """Return the seconds of each stage as scalars of a row."""
    return {f"seconds_{name.replace(' ', '_')}": spent for name, spent in seconds.items()}


def roughness_before(sound: Sound) -> dict | str:
    """Return the roughness of the last seconds of the motion, or why there is none."""
    try:
        time, asper = roughness(sound.pressure, sound.source_end)
        return {"time": time.tolist(), "asper": asper.tolist()}
    except (ValueError, MissingExtraError) as error:
        return str(error)


def finite(value):
    """Return nested values with every infinity as a string: JSON has none."""
    if isinstance(value, dict):
        return {key: finite(item) for key, item in value.items()}
    if isinstance(value, (list, tuple)):
        return [finite(item) for item in value]
    return value if not isinstance(value, float) or np.isfinite(value) else str(value)


def write_json(value, path: Path):
    """Write strict JSON. Raises ValueError for a value that is not finite."""
    with whole(path) as temporary:
        temporary.write_text(json.dumps(value, indent=1, allow_nan=False) + "\n", encoding="utf-8")


def versions() -> dict[str, str]:
    """Return the versions of this program, its commit where it runs from a checkout, and what it
    stands on."""
    found = {"python": python_version(), "platform": platform(), "commit": commit()}
    return found | {name: version_of(name) for name in (NAME, *LIBRARIES)}


@lru_cache
def version_of(package: str) -> str:
    """Return the version of a package, or that it is not installed."""
    try:
        return version(package)
    except PackageNotFoundError:
        return "not installed"


def commit(*asked: str) -> str:
    """Return what git tells of the checkout that this file is in, its commit unless `asked` else;
    or 'unknown'."""
    command = ["git", "-C", str(Path(__file__).parent), *(asked or ("rev-parse", "HEAD"))]
    try:
        return (
            subprocess.run(command, capture_output=True, text=True, check=False).stdout.strip()
            or "unknown"
        )
    except OSError:
        return "unknown"
