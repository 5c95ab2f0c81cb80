"""Write run.json, motion.npz, the modes, the pictures and the page of a result."""

import shutil
import subprocess
from concurrent.futures import Future
from dataclasses import asdict
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path
from platform import platform, python_version
from typing import TYPE_CHECKING, Any

import numpy as np

from dynamics import Motion
from dynamics.motion import COLUMNS
from modal import as_json, write_vtu
from sonify.claims.air import end_cause_scalars
from sonify.claims.checks import Check
from sonify.claims.ensemble import Ensemble, repeat_final_part
from sonify.claims.finding import Finding
from sonify.plan.supports import modes_over_run
from sonify.plan.unused import unused_keys
from sonify.report.headline import headline
from sonify.report.pictures import Pictures
from sonify.result import output_folder
from sonify.runtime.files import atomic_write
from sonify.runtime.json_values import json_safe, write_json
from sonify.runtime.progress import Stages, Watch
from sonify.scene import scene_record
from sonify.sound.audible_modes import RingDown
from sonify.sound.mastering import mastering_record, true_peak_dbtp

if TYPE_CHECKING:
    from sonify.result import Result

DISTRIBUTION_NAME = "eulers-disk-sonify"
RECORDED_LIBRARIES = (
    "numpy",
    "scipy",
    "numba",
    "heyoka",
    "scikit-fem",
    "soundfile",
    "matplotlib",
)


def page_content(result: "Result", pictures: Pictures) -> dict[str, Any]:
    """Return the data of the page of a result in the form embedded in the page."""
    from sonify.report import page  # slow import

    return page.template_data(result, pictures.page_parts())


def write_record(
    result: "Result",
    stages: Stages,
    pictures: Pictures,
    record: Future[Any],
    content: Future[Any],
) -> None:
    """Write all files of a result except its sound, and time the stages.

    `record` and `content` are Futures of the content of run.json and of the data of the
    page.
    """
    from sonify.report import page  # slow import

    with stages.stage("motion.npz, modes"):
        write_motion(result.motion, output_folder(result) / "motion.npz")
        rings = {"ring_down": ring_down_record(result.sound.ringing)}
        write_json(
            as_json(result.modes) | mode_changes_record(result) | rings,
            output_folder(result) / "modes.json",
        )
        with atomic_write(output_folder(result) / "modes.vtu") as temporary:
            write_vtu(result.modes, temporary)
    with stages.stage("pictures"):
        pictures.write(result)
    if result.scene.surface.kind == "mesh":
        copy_table_mesh(Path(result.scene.surface.file), output_folder(result))
    write_json(
        record.result() | {"seconds": rounded_seconds(result.seconds)},
        output_folder(result) / "run.json",
    )
    page.write_page(result, output_folder(result) / "report.html", content.result())


def mode_changes_record(result: "Result") -> dict[str, Any]:
    """Return the entry of modes.json for a disk on its contact.

    It contains the modes at several inclinations [rad] of the run.
    """
    rows = []
    for step in modes_over_run(result.scene, result.motion, result.plan.highest_mode):
        modes = step.modes
        rows.append(
            {
                "name": step.name,
                "t": step.t,
                "inclination": step.inclination,
                "frequency": None if modes is None else modes.frequency.tolist(),
                "decay_rate": None if modes is None else modes.decay_rate.tolist(),
            }
        )
    return {"over_the_run": rows} if rows else {}


MAX_MOTION_ROWS = 25_000
"""Largest number of times in motion.npz."""


def write_motion(motion: Motion, path: Path) -> None:
    """Write the motion to a NumPy archive.

    The archive contains times [s], states, forces [N] and regimes at the ends of the
    pieces, or at every k-th end if there are more than MAX_MOTION_ROWS, and at the last
    one; also the jumps, and the transitions between regimes.
    """
    jumps = motion.jumps
    events = motion.transitions
    last = len(motion.t) - 1
    every = last // MAX_MOTION_ROWS + 1
    rows = np.append(np.arange(0, last, every), last)
    t = motion.t[rows]
    with atomic_write(path) as temporary:
        np.savez(
            temporary,
            t=t,
            state=motion.state[rows],
            columns=np.array(COLUMNS),
            force=motion.force(t),
            regime=motion.regime(t),
            jump_time=jumps.t,
            jump_before=jumps.before,
            jump_after=jumps.after,
            transition_time=np.array([e.t for e in events]),
            transition_before=np.array([e.before for e in events]),
            transition_after=np.array([e.after for e in events]),
            transition_guard=np.array([e.guard for e in events]),
        )


def copy_table_mesh(file: Path, out: Path) -> None:
    """Copy the mesh of a table into the folder `out` of run.json.

    The record contains the file name without the folder, so it is a valid scene on any
    machine.
    """
    if (out / file.name).resolve() != file.resolve():
        with atomic_write(out / file.name) as temporary:
            shutil.copyfile(file, temporary)


def run_record(result: "Result") -> dict[str, Any]:
    """Return the content of run.json as plain, finite values."""
    sound = result.sound
    return {
        "scene": scene_record(result.scene),
        "unused": list(unused_keys(result.scene, result.motion.plan)),
        "plan": result.plan.record(),
        "outcome": {
            "name": result.motion.outcome.name,
            "sentence": result.motion.outcome.sentence,
        },
        "hand_over": hand_over_record(result.motion),
        "events": [event._asdict() for event in result.motion.events],
        "motion": {
            "end": float(result.motion.t[-1]),
            "integrator": result.motion.integrator,
        },
        "sound": {
            "sample_rate": sound.sample_rate,
            "duration": sound.duration,
            "peak_pascal": sound.peak,
            "full_scale_pascal": sound.full_scale,
            "gain_db": float(sound.gain_db),
            "loudness_lufs": json_safe(sound.loudness[0]),
            "stem_peak_pascal": sound.stem_peaks,
            "stems_in_rest": list(sound.inaudible_stems),
            "energy_below_100_hz_300_hz": sound.low_frequency_shares,
            "ring_down": ring_down_record(sound.ringing),
            "audible_full_scale_pascal": sound.audible.full_scale,
            "audible_loudness_lufs": json_safe(sound.loudness[1]),
            "audible_true_peak_dbtp": true_peak_dbtp(sound.audible),
            "audible_chain": mastering_record(sound.audible),
        },
        "headline": headline(result.findings),
        "checks": [
            json_safe(asdict(check)) | {"passed": check.passed}
            for check in result.checks
        ],
        "findings": [
            json_safe(asdict(f)) | {"verdict": f.verdict, "holds": f.holds}
            for f in result.findings
        ],
        "seconds": rounded_seconds(result.seconds),
        "versions": versions(),
    }


def hand_over_record(motion: Motion) -> dict[str, Any] | None:
    """Return the end of the rolling motion [s] and its reason; None if it never ended."""
    reason = motion.rolling_outcome
    if motion.landing is None and reason is motion.outcome:
        return None
    return {
        "t": float(motion.rolling.t[-1]),
        "reason": reason.name,
        "sentence": reason.sentence,
    }


def write_ensemble(result: "Result", count: int, watch: Watch) -> Ensemble:
    """Repeat the final part of the motion of a result and write ensemble.json to its
    folder."""
    repeated = repeat_final_part(
        result.scene, result.motion.rolling, count, watch=watch
    )
    write_json(json_safe(repeated.record()), output_folder(result) / "ensemble.json")
    return repeated


def ring_down_record(ringing: RingDown) -> dict[str, Any]:
    """Return frequency [Hz], decay rates [1/s] and T60 [s] of the modes after the
    motion.

    The record also contains the mean gap [m] of the air film.
    """
    return json_safe(
        {
            "frequency": ringing.frequency.tolist(),
            "decay_rate": ringing.decay_rate.tolist(),
            "decay_time": ringing.decay_time.tolist(),
            "decay_rate_without_film": ringing.decay_rate_without_film.tolist(),
            "mean_gap": ringing.gap,
        }
    )


def rounded_seconds(seconds: dict[str, float]) -> dict[str, float]:
    """Return the durations of the stages [s], rounded to milliseconds."""
    copied = dict(seconds)  # other threads may add stages
    return {name: round(spent, 3) for name, spent in copied.items()}


def summary(result: "Result") -> dict[str, Any]:
    """Return the scalars of a result as one row of a table.

    Parameters
    ----------
    result : Result
        Result of a run.

    Returns
    -------
    dict
        Scalars by column name: outcome and end [s] of the rolling motion, the duration [s]
        and peak [Pa] of the sound, the causes of the end, the value and verdict of each
        finding and check, and the duration of each stage [s].

    Examples
    --------
    >>> from sonify import solve, summary
    >>> summary(solve("published"))["t_end"]  # s  # doctest: +SKIP
    """
    below_100_hz, below_300_hz = result.sound.low_frequency_shares
    return {
        "outcome": result.motion.rolling_outcome.name,
        "t_end": float(result.motion.rolling.t[-1]),
        "passed": result.passed,
        "sound_seconds": result.sound.duration,
        "peak_pascal": result.sound.peak,
        **end_cause_scalars(result.scene, result.motion.rolling),
        "energy_below_100_hz": below_100_hz,
        "energy_below_300_hz": below_300_hz,
        **verdict_columns(result.findings, result.checks),
        **duration_columns(result.seconds),
    }


def verdict_columns(findings: list[Finding], checks: list[Check]) -> dict[str, Any]:
    """Return the value and the verdict of each finding and check, by key."""
    row: dict[str, Any] = {}
    for finding in findings:
        row |= {finding.key: finding.value, f"{finding.key}_holds": finding.holds}
    for check in checks:
        row |= {check.key: check.value, f"{check.key}_passed": check.passed}
    return row


def duration_columns(seconds: dict[str, float]) -> dict[str, float]:
    """Return the duration of each stage [s] as scalars of a row."""
    return {
        f"seconds_{name.replace(' ', '_')}": spent for name, spent in seconds.items()
    }


def versions() -> dict[str, str]:
    """Return the versions of Python, the platform, this program and its libraries.

    The entry `commit` identifies the checkout, if there is one.
    """
    found = {"python": python_version(), "platform": platform(), "commit": run_git()}
    return found | {
        name: version_of(name) for name in (DISTRIBUTION_NAME, *RECORDED_LIBRARIES)
    }


def version_of(package: str) -> str:
    """Return the version of a package, or "not installed"."""
    try:
        return version(package)
    except PackageNotFoundError:
        return "not installed"


def run_git(*arguments: str) -> str:
    """Return the output of a git command in the checkout of this file.

    The default command returns the hash of the commit. The result is "unknown" if there
    is no output.
    """
    folder = str(Path(__file__).parent)
    command = ["git", "-C", folder, *(arguments or ("rev-parse", "HEAD"))]
    try:
        done = subprocess.run(command, capture_output=True, text=True, check=False)
    except OSError:
        return "unknown"
    return done.stdout.strip() or "unknown"
