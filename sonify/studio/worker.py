"""Solve scenes and analyse recordings in the worker process of the studio."""

import json
import os
from collections.abc import Callable
from contextlib import contextmanager
from functools import cache
from math import inf
from pathlib import Path
from struct import pack
from threading import Lock
from time import perf_counter
from typing import TYPE_CHECKING, Any

from sonify.runtime.progress import StageProgress, Stages, background_threads
from sonify.runtime.workers import serve_calls

if TYPE_CHECKING:
    from sonify.pipeline import DiskModesCache

PROGRESS_FILE = "progress.json"
PREVIEW_FILE = "preview.wav"
STREAM_FILE = "stream.wav"
"""File with the sound while it is being rendered; its header states the final
length."""


class ProgressFile(Stages):
    """Stages that write notices, a line of progress and the state of the sound to a
    file."""

    def __init__(self, folder: Path):
        super().__init__()
        self._folder = folder
        self._running: dict[str, StageProgress] = {}
        self._lock = Lock()
        self._written = 0.0
        self.notices: list[str] = []
        self.heard = False
        self.streams = False
        self._gain = inf

    @contextmanager
    def stage(self, name: str):
        """Time the block as stage `name` and write its progress."""
        progress = StageProgress(name, perf_counter())
        with self._lock:
            self._running[name] = progress

        def watch(share, note=""):
            with self._lock:
                progress.report(perf_counter(), share, note)
            self.write()

        try:
            with super().stage(name):
                self.write()
                yield watch
        finally:
            with self._lock:
                del self._running[name]

    def notice(self, line: str):
        """Write a message for the user."""
        self.notices.append(line)
        self.write(at_once=True)

    def pressure(self, block, sample_rate: int, samples: int):
        """Append a block of the pressure [Pa] to the stream.

        The peak of the whole sound is not yet known, so the gain is lowered whenever a
        block is louder than all previous blocks.
        """
        import numpy as np

        peak_headroom = 0.5
        peak = float(np.max(np.abs(block), initial=1e-12))
        self._gain = min(self._gain, peak_headroom / peak)
        scaled = np.round(32767 * self._gain * block).astype("<i2")
        with open(self._folder / STREAM_FILE, "ab") as file:
            if not self.streams:
                file.write(_wav_header(sample_rate, samples))
            file.write(scaled.tobytes())
        self.streams = True
        self.write(at_once=True)

    def write(self, at_once: bool = False):
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
            content = {
                "line": line,
                "share": min(shares, default=None),
                "notices": self.notices,
                "heard": self.heard,
                "streams": self.streams,
            }
            temporary = self._folder / "progress.tmp"
            temporary.write_text(json.dumps(content), encoding="utf-8")
            os.replace(temporary, self._folder / PROGRESS_FILE)


def _wav_header(sample_rate, samples):
    """Return the header of a 16-bit mono WAV file."""
    size = 2 * samples
    form = (16, 1, 1, sample_rate, 2 * sample_rate, 2, 16)
    return pack(
        "<4sI8sIHHIIHH4sI", b"RIFF", 36 + size, b"WAVEfmt ", *form, b"data", size
    )


def warm_up() -> None:
    """Import all modules and compile the integrators by solving the default scene."""
    from sonify.report.render_worker import painter

    painter()
    from sonify import pipeline

    pipeline.solve("published", "draft", eigenmodes=known_disk_modes())


@cache
def known_disk_modes() -> "DiskModesCache":
    """Return the modes of the last disks, which this process keeps for further runs."""
    from sonify.pipeline import DiskModesCache

    return DiskModesCache()


def run_scene(document: dict, out: Path, session: Path) -> dict[str, Any]:
    """Solve a scene and write the files of `sonify run` to `out`.

    The sound is written to `session` before the other files.
    """
    from sonify import pipeline
    from sonify.hearing.recording import listen_to_known_disk
    from sonify.plan.unused import unused_keys_notice
    from sonify.report.pictures import Pictures
    from sonify.runtime.files import claimed_folder
    from sonify.scene import from_document

    stages = ProgressFile(session)
    scene, motion_plan = pipeline.solvable_scene(from_document(document), None)
    if notice := unused_keys_notice(scene, motion_plan):
        stages.notice(notice)
    with claimed_folder(out) as folder, background_threads() as threads:
        pictures = Pictures(threads)
        tools = pipeline.Tools(
            executor=threads,
            stages=stages,
            begin=_callback_with_preview(pictures.begin, stages, session),
            eigenmodes=known_disk_modes(),
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


def analyse_recording(
    path: Path, document: dict, folder: Path, span: tuple[float, float] = (0.0, inf)
) -> dict[str, Any]:
    """Return sentences on the analysis of a recording within a span [s] and its
    comparison with a scene.

    Pictures are written to `folder`, and the recording is deleted. The sentences contain
    its name without its folder.
    """
    from sonify.fitting.comparison import simulated_numbers
    from sonify.fitting.report import comparison_sentences, sentences, write_fits
    from sonify.fitting.result import fit
    from sonify.hearing.recording import RecordingError
    from sonify.report.recording import write_recording_report
    from sonify.scene import from_document
    from sonify.scene_errors import InputError

    stages = ProgressFile(folder)
    fitted: list[str] = []
    try:
        with stages.stage("spectral lines"):
            lines = write_recording_report(path, folder, span=span)
            heard = lines[:-1]  # without the last line, the folder
        try:
            with stages.stage("fit") as watch:
                fits = fit(path, from_document(document), watch, span)
            measured = fits.files[0].measured
            with stages.stage("simulation"):
                simulated = simulated_numbers(fits.scene, measured["seconds"])
            fitted = sentences(fits) + comparison_sentences(fits, simulated)
            write_fits(fits, folder, simulated)
        except RecordingError as error:
            fitted = [str(error)]
    except InputError as error:
        heard = [str(error)]
    finally:
        path.unlink(missing_ok=True)
    place = f"{path.parent}{os.sep}"
    return {
        "heard": [line.replace(place, "") for line in heard],
        "fit": [line.replace(place, "") for line in fitted],
        "pictures": sorted(picture.name for picture in folder.glob("*.png")),
    }


def _callback_with_preview(
    begin: Callable, stages: ProgressFile, session: Path
) -> Callable:
    """Return a callback that writes a listening copy of the sound as soon as it is
    rendered, and then calls `begin`."""
    import soundfile

    def begin_with_preview(solved):
        if solved.completed_stage == "sound":
            copy = solved.sound.playback_copy
            temporary = session / "preview.tmp"
            with soundfile.SoundFile(
                temporary, "w", copy.sample_rate, copy.channels, "PCM_16", format="WAV"
            ) as file:
                for block in copy.blocks():
                    file.write(block)
            os.replace(temporary, session / PREVIEW_FILE)
            stages.heard = True
            stages.write(at_once=True)
        begin(solved)

    return begin_with_preview


if __name__ == "__main__":
    serve_calls()
