"""FILES + SCENE -> FITS: each recording alone, all of them together, and a test of the radius."""

from collections.abc import Callable, Iterable
from dataclasses import dataclass, replace
from math import inf
from pathlib import Path

import soundfile

from modal.blas_threads import one_blas_thread
from sonify.fitting import least_squares
from sonify.fitting.decay_model import Decline
from sonify.fitting.fu_berlin import Exponent, exponents
from sonify.fitting.least_squares import MIN_RATE_ERROR, Fit, Value, pool_fits, values_in_words
from sonify.fitting.line_selection import (
    Judged,
    detect_run,
    judge_sounds,
    verdict_of,
    with_model_error,
)
from sonify.fitting.parallel import in_worker_processes
from sonify.fitting.recordings_io import is_recorded, recording_files, source_of_file
from sonify.hearing.audio_source import Truncation, excerpt, source_of, truncation_of
from sonify.hearing.recording import RecordingError
from sonify.hearing.spectral_lines import Carrier, carriers
from sonify.scene import Scene, from_document, load_scene

WRONG_RADIUS_FACTORS = (0.9, 1.1)
"""Factors on the radius for which every fit is repeated."""
FAR_BETTER_RATIO = 2.0
"""A fit is far better than another if its spread is smaller by this factor."""
WORKER_COUNT = 2
"""Number of worker processes."""
MIN_PARALLEL_RECORDINGS = 3
"""Least number of recordings for which they are used."""


@dataclass(frozen=True, kw_only=True, eq=False)
class Fitted:
    """Result for one recording: `judged`, a test of a radius that is 10 % off, and spectral lines.

    It also holds the share of the recording that a truncated file contains.
    """

    file: str
    judged: Judged
    radius_shows: bool
    carriers: list[Carrier]
    published_way: dict[str, Exponent] | None = None
    truncation: Truncation | None = None

    def __repr__(self):
        return (
            f"Fitted({self.file}: {self.judged.verdict}; {values_in_words(self.judged.values())})"
        )


@dataclass(frozen=True, kw_only=True, eq=False)
class Fits:
    """Results for recordings of one disk: each in `files`, all together in `pool`, with the
    `verdict`.

    `resonances` holds the origin and the frequency [Hz] of resonances of the scene.
    """

    scene: Scene
    files: list[Fitted]
    pool: Fit
    verdict: str
    resonances: list[tuple[str, float]]

    def values(self) -> dict[str, Value]:
        """Return `rolling`, `air` and the other fitted shares of all recordings together."""
        return self.pool.values()

    def __repr__(self):
        return (
            f"Fits({len(self.files)} recordings: {self.verdict}; {values_in_words(self.values())})"
        )


@one_blas_thread
def fit(
    files: str | Path | Iterable[str | Path],
    scene: Scene | str | Path = "toy",
    like: str | None = None,
    watch: Callable[[float, str], None] = lambda share, doing: None,
    span: tuple[float, float] = (0.0, inf),
) -> Fits:
    """Return the cause of the decline of a disk in recordings.

    The recordings are sound files, phyphox exports, or folders of them. The scene gives radius,
    thickness and air. With `like` = "fu-berlin" the exponents of a published analysis are added.
    Only the part of each recording within `span` [s] is analysed. Raises RecordingError with one
    line for a recording that cannot be fitted, and SceneError for an invalid scene.
    """
    from sonify.claims.resonance_matching import resonances  # modes load slowly

    scene = load_scene(scene) if isinstance(scene, (str, Path)) else scene
    paths = recording_files([files] if isinstance(files, (str, Path)) else files)
    known = resonances(scene)
    fitted = []
    tasks = [(path, scene.document, like, span) for path in paths]
    for one in (
        (fit_one(*task) for task in tasks)
        if len(tasks) < MIN_PARALLEL_RECORDINGS
        else in_worker_processes(fit_one, tasks, WORKER_COUNT)
    ):
        fitted.append(one)
        watch(len(fitted) / len(paths), one.file)
    decline = fitted[0].judged.decline
    fits = [one.judged.fit for one in fitted]
    pool = fits[0] if len(fits) == 1 else pool_fits(fits)
    verdict = fitted[0].judged.verdict if len(fits) == 1 else verdict_of(decline, pool)
    return Fits(scene=scene, files=fitted, pool=pool, verdict=verdict, resonances=known)


@one_blas_thread
def fit_one(
    path: Path, document: dict, like: str | None, span: tuple[float, float] = (0.0, inf)
) -> Fitted:
    """Return the fit of one recording within a span [s]; the scene is given as its document.

    Raises RecordingError with one line if it cannot be fitted.
    """
    scene = from_document(document)
    recording = source_of_file(path)
    try:
        part = excerpt(source_of(recording), *span)
    except (soundfile.LibsndfileError, OSError):
        part = recording  # `heard` tells why
    sound = detect_run(part, str(path), recorded=is_recorded(path), begin=span[0])
    decline = Decline(scene)
    judged = judge_sounds(decline, [sound])
    published = None
    if like == "fu-berlin":
        end = float(judged.fit.ends[0]) - sound.start
        try:
            published = exponents(sound.samples, sound.rate, end)
        except ValueError as error:
            raise RecordingError(f"{path}: {error}") from None
    return Fitted(
        file=str(path),
        judged=with_model_error(judged).without_samples(),
        radius_shows=is_radius_determined(judged),
        carriers=carriers(sound.samples, sound.rate, sound.start),
        published_way=published,
        truncation=truncation_of(recording),
    )


def is_radius_determined(judged: Judged) -> bool:
    """Return True if disks with a radius 10 % off fit far worse, for any law of dissipation."""
    found = [_spread_with_radius(judged, factor) for factor in WRONG_RADIUS_FACTORS]
    return all(
        spread is None or spread > FAR_BETTER_RATIO * max(judged.fit.spread, MIN_RATE_ERROR)
        for spread in found
    )


def _spread_with_radius(judged, factor):
    """Return the spread of the fit of a disk with another radius; None if the fit fails."""
    scene = judged.decline.scene
    disk = replace(scene.disk, radius=factor * scene.disk.radius, density=None)  # it keeps its mass
    decline = Decline(replace(scene, disk=disk)).lines[judged.line]
    decline.ahead = judged.decline.ahead
    try:
        return least_squares.fit(
            decline, judged.streams, judged.fit.ends, judged.fit.shares, judged.fit.free
        ).spread
    except ValueError:
        return None
