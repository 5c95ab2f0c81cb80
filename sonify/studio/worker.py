"""Solve scenes and analyse recordings in the worker process of the studio."""

import json
import os
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from functools import cache
from math import inf
from pathlib import Path
from struct import pack
from threading import Lock
from time import perf_counter
from typing import TYPE_CHECKING, Any

from sonify.runtime.progress import (
    StageProgress,
    Stages,
    Watch,
    background_threads,
    duration_in_words,
)
from sonify.runtime.workers import serve_calls

if TYPE_CHECKING:
    import numpy as np

    from sonify.pipeline import DiskModesCache, TableModesCache
    from sonify.result import SolvedMotion

PROGRESS_FILE = "progress.json"
RECORDING_FILE = "recording.json"
"""File with the data of a recording in the form of the data of a run."""
STREAM_FILE = "stream.wav"
"""File with the sound while it is being rendered; its header states the final
length."""


class ProgressFile(Stages):
    """Stages that write notices, a line of progress and the state of the sound to a
    file."""

    def __init__(self, folder: Path) -> None:
        super().__init__()
        self._folder = folder
        self._running: dict[str, StageProgress] = {}
        self._lock = Lock()
        self._began = perf_counter()
        self._written = 0.0
        self.notices: list[str] = []
        self.expected_seconds: float | None = None
        self.found: dict[str, Any] | None = None
        self.heard = False
        self.streams = False
        self._gain = inf
        self._weighting: np.ndarray | None = None
        self._weighting_state: np.ndarray | None = None

    @contextmanager
    def stage(self, name: str) -> Iterator[Watch]:
        """Time the block as stage `name` and write its progress."""
        progress = StageProgress(name, perf_counter())
        with self._lock:
            self._running[name] = progress

        def watch(share: float, note: str = "") -> None:
            with self._lock:
                progress.report(perf_counter(), share, note)
            self.write()

        try:
            with super().stage(name):
                self.write(at_once=True)
                yield watch
        finally:
            with self._lock:
                del self._running[name]

    def notice(self, line: str) -> None:
        """Write a message for the user."""
        self.notices.append(line)
        self.write(at_once=True)

    def expect(self, seconds: float) -> None:
        """Write the predicted duration of the run."""
        self.expected_seconds = seconds
        self.write(at_once=True)

    def results_so_far(self, found: dict[str, Any]) -> None:
        """Write the results of a recording that are known before the last stage."""
        self.found = found
        self.write(at_once=True)

    def pressure(self, block: "np.ndarray", sample_rate: int, samples: int) -> None:
        """Append a block of the pressure [Pa] to the stream, A-weighted like
        audible.wav.

        The peak of the whole sound is not yet known, so the gain is lowered whenever a
        block is louder than all previous blocks.
        """
        import numpy as np
        from scipy.signal import sosfilt

        from sonify.sound.playback import a_weighting

        if self._weighting is None:
            self._weighting = a_weighting(sample_rate)
            self._weighting_state = np.zeros((len(self._weighting), 2))
        weighted, self._weighting_state = sosfilt(
            self._weighting, block, zi=self._weighting_state
        )
        peak_headroom = 0.5
        peak = float(np.max(np.abs(weighted), initial=1e-12))
        self._gain = min(self._gain, peak_headroom / peak)
        scaled = np.round(32767 * self._gain * weighted).astype("<i2")
        with open(self._folder / STREAM_FILE, "ab") as file:
            if not self.streams:
                file.write(_wav_header(sample_rate, samples))
            file.write(scaled.tobytes())
        self.streams = True
        self.write(at_once=True)

    def write(self, at_once: bool = False) -> None:
        """Write the progress, unless it was just written; `at_once`, in any case."""
        interval = 0.1  # s
        with self._lock:
            now = perf_counter()
            if now - self._written < interval and not at_once:
                return
            self._written = now
            line = "; ".join(stage.line(now) for stage in self._running.values())
            shares = [
                stage.share
                for stage in self._running.values()
                if stage.share is not None
            ]
            expected = self.expected_seconds
            content = {
                "line": line,
                "share": min(shares, default=None),
                "notices": self.notices,
                "expected": "" if expected is None else duration_in_words(expected),
                "exceeded": expected is not None and now - self._began > expected,
                "found": self.found,
                "heard": self.heard,
                "streams": self.streams,
            }
            temporary = self._folder / "progress.tmp"
            temporary.write_text(json.dumps(content), encoding="utf-8")
            os.replace(temporary, self._folder / PROGRESS_FILE)


def _wav_header(sample_rate: int, samples: int) -> bytes:
    """Return the header of a 16-bit mono WAV file."""
    size = 2 * samples
    form = (16, 1, 1, sample_rate, 2 * sample_rate, 2, 16)
    return pack(
        "<4sI8sIHHIIHH4sI", b"RIFF", 36 + size, b"WAVEfmt ", *form, b"data", size
    )


def warm_up() -> None:
    """Import all modules, compile the integrators by solving the default scene, and
    compute the radiation of the toy, which several scenes share."""
    from sonify.report.render_worker import painter

    painter()
    from modal.blas_threads import one_blas_thread
    from sonify import pipeline
    from sonify.scene import load_scene
    from sonify.sound.film_radiation import radiated_multipoles

    pipeline.solve("published", "draft", eigenmodes=known_disk_modes())
    toy = load_scene("toy")
    one_blas_thread(radiated_multipoles)(toy.disk, toy.air)  # which keeps its results


@cache
def known_disk_modes() -> "DiskModesCache":
    """Return the modes of the last disks, which this process keeps for further runs."""
    from sonify.pipeline import DiskModesCache

    return DiskModesCache()


@cache
def known_table_modes() -> "TableModesCache":
    """Return the modes of the last tables, which this process keeps for further runs."""
    from sonify.pipeline import TableModesCache

    return TableModesCache()


def run_scene(document: dict[str, Any], out: Path, session: Path) -> dict[str, Any]:
    """Solve a scene and write the files of `sonify run` to `out`.

    The progress and the sound, while it is rendered, are written to `session`.
    """
    from sonify import pipeline
    from sonify.hearing.recording import listen_to_known_disk
    from sonify.plan.duration import predicted_run_seconds
    from sonify.plan.preflight import solvable_scene
    from sonify.plan.unused import unused_keys_notice
    from sonify.report.pictures import Pictures
    from sonify.runtime.files import claimed_folder
    from sonify.scene import from_document

    stages = ProgressFile(session)
    scene, motion_plan = solvable_scene(from_document(document), None)
    if notice := unused_keys_notice(scene, motion_plan):
        stages.notice(notice)
    stages.expect(predicted_run_seconds(scene, motion_plan))
    with claimed_folder(out) as folder, background_threads() as threads:
        pictures = Pictures(threads)
        tools = pipeline.Tools(
            executor=threads,
            stages=stages,
            begin=_callback_that_notes_sound(pictures.begin, stages),
            eigenmodes=known_disk_modes(),
            table_modes=known_table_modes(),
            listen=listen_to_known_disk,
            dynamics="compressed",
        )
        result = pipeline.solve_stages(scene, motion_plan, tools)
        pipeline.write(result, folder, stages, pictures, threads)
    return {
        "outcome": result.motion.outcome.sentence,
        "seconds": result.sound.duration,
        "passed": result.passed,
        "notices": stages.notices,
    }


def write_takes(
    document: dict[str, Any],
    out: Path,
    session: Path,
    takes: int,
    last: float | None,
    audible: bool,
) -> dict[str, Any]:
    """Write takes of a scene to `out` as `sonify export sound`, and return the names of
    the `files`."""
    from sonify.export.takes import TakeContent, export_takes
    from sonify.scene import from_document

    paths = export_takes(
        from_document(document),
        takes,
        out=out,
        stages=ProgressFile(session),
        content=TakeContent(last, audible),
    )
    return {"files": [path.name for path in paths]}


def analyse_recording(
    path: Path,
    document: dict[str, Any],
    folder: Path,
    span: tuple[float, float] = (0.0, inf),
) -> dict[str, Any]:
    """Analyse a recording within a span [s] and compare it with a scene.

    Returns `summary`, one to three sentences; `runs` with the `start` and the `end` [s]
    of each run in the file; `details`, the sentences of `sonify listen` and `sonify
    fit`; and the names of `pictures`. The pictures and, if a disk was heard,
    RECORDING_FILE are written to `folder`, and the recording is deleted. The sentences
    contain its name without its folder.
    """
    from sonify.hearing.audio_source import source_of_file
    from sonify.hearing.recording_errors import RecordingError
    from sonify.scene_errors import InputError

    stages = ProgressFile(folder)
    try:
        source = source_of_file(path)
        fault = span_fault(span, source.frames / source.sample_rate)
        found = (
            {"summary": [fault]}
            if fault
            else _analysis(path, document, folder, span, stages)
        )
    except RecordingError:
        found = {"summary": [f"{path.name}: this file is not a readable sound."]}
    except InputError as error:
        found = {"summary": [str(error)]}
    finally:
        path.unlink(missing_ok=True)
    return _with_pictures({"runs": [], "details": []} | found, path, folder)


def _with_pictures(found: dict[str, Any], path: Path, folder: Path) -> dict[str, Any]:
    """Return results with the names of the pictures, and sentences that name the
    recording without its folder."""
    place = f"{path.parent}{os.sep}"
    sentences = {
        name: [line.replace(place, "") for line in found[name]]
        for name in ("summary", "details")
    }
    pictures = sorted(picture.name for picture in folder.glob("*.png"))
    return found | sentences | {"pictures": pictures}


def span_fault(span: tuple[float, float], duration: float) -> str:
    """Return why a span [s] selects nothing of a sound of a duration [s], or ""."""
    begin, end = span
    if begin >= duration:
        return f"from = {begin:g}: must be less than the duration of the sound, {duration:.3g} s"
    if end <= begin:
        return f"to = {end:g}: must be greater than from = {begin:g}"
    return ""


def _analysis(
    path: Path,
    document: dict[str, Any],
    folder: Path,
    span: tuple[float, float],
    stages: ProgressFile,
) -> dict[str, Any]:
    from sonify.fitting.comparison import simulated_numbers
    from sonify.fitting.decay_model import neglected_parts
    from sonify.fitting.report import comparison_sentences, sentences, write_fits
    from sonify.fitting.result import fit
    from sonify.hearing.recording_errors import RecordingError
    from sonify.report.recording import write_recording_report
    from sonify.scene import from_document
    from sonify.studio.recording_summary import (
        runs_in_file,
        summary_of_fit,
        summary_of_runs,
        write_recording,
    )

    with stages.stage("spectral lines"):
        lines = write_recording_report(path, folder, span=span)
    runs = runs_in_file(folder)
    found: dict[str, Any] = {
        "summary": summary_of_runs(runs),
        "runs": runs,
        "details": lines[:-1],  # without the last line, the folder
    }
    if not runs:
        return found
    write_recording(path, folder / RECORDING_FILE, runs[0]["end"], span)
    if len(runs) > 1:
        return found
    stages.results_so_far(_with_pictures(found, path, folder))
    scene = from_document(document)
    try:
        with stages.stage(f"fit to the scene {scene.name}") as watch:
            fits = fit(path, scene, watch, span)
        judged = fits.files[0].judged
        found["summary"] = summary_of_fit(judged, neglected_parts(scene))
        if judged.explained:
            end = judged.fit.parameter(0).value
            write_recording(path, folder / RECORDING_FILE, end, span)
        stages.results_so_far(_with_pictures(found, path, folder))
        measured = fits.files[0].measured
        with stages.stage("simulation of the scene"):
            simulated = simulated_numbers(fits.scene, measured["seconds"])
        fitted = sentences(fits) + comparison_sentences(fits, simulated)
        found["details"] = fitted + found["details"]
        write_fits(fits, folder, simulated)
    except RecordingError as error:
        reason = str(error).removeprefix(f"{path}: ")
        found["summary"][1] += f" How much each cause took is not shown: {reason}."
        found["details"] = [str(error), *found["details"]]
    return found


def _callback_that_notes_sound(
    begin: Callable[..., Any], stages: ProgressFile
) -> Callable[..., Any]:
    """Return a callback that notes that the sound is complete, and then calls
    `begin`."""

    def noting_begin(solved: "SolvedMotion") -> None:
        if solved.completed_stage == "sound":
            stages.heard = True
            stages.write(at_once=True)
        begin(solved)

    return noting_begin


if __name__ == "__main__":
    serve_calls()
