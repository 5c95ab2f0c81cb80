"""FILES + SCENE -> FITTED: each recording by itself, all of them together, and what else could have
been heard."""

from collections.abc import Callable, Iterable
from dataclasses import dataclass, replace
from math import inf
from pathlib import Path

import soundfile

from modal.blas_threads import one_blas_thread
from sonify.fitting import least_squares
from sonify.fitting.apart import each
from sonify.fitting.decay_model import Decline
from sonify.fitting.fu_berlin import Exponent, exponents
from sonify.fitting.least_squares import FLOOR, Fit, Value, in_words, pooled
from sonify.fitting.line_selection import Judged, heard, judge, verdict_of, with_model_error
from sonify.fitting.recordings_io import recorded, source, takes
from sonify.hearing.audio_source import Truncation, excerpt, source_of, truncation_of
from sonify.hearing.recording import RecordingError
from sonify.hearing.spectral_lines import Carrier, carriers
from sonify.scene import Scene, from_document, load_scene

WRONG = (0.9, 1.1)
"""Factors on the radius with which every fit is tried again."""
BETTER = 2.0
"""A fit is far better than another where its spread is so many times smaller."""
WORKERS, MANY = 2, 3
"""So many processes share the recordings where there are at least so many."""


@dataclass(frozen=True, kw_only=True, eq=False)
class Fitted:
    """One recording: what was `judged` of it, whether a radius 10 % off would show,
    its carriers, and how much of it is there if its file was cut off."""

    file: str
    judged: Judged
    radius_shows: bool
    carriers: list[Carrier]
    published_way: dict[str, Exponent] | None = None
    truncation: Truncation | None = None

    def __repr__(self):
        return f"Fitted({self.file}: {self.judged.verdict}; {in_words(self.judged.values())})"


@dataclass(frozen=True, kw_only=True, eq=False)
class Fits:
    """Recordings of one disk: each in `files`, and all of them in the `pool`, with its `verdict`;
    `resonances` of the scene are of what, and their frequencies [Hz]."""

    scene: Scene
    files: list[Fitted]
    pool: Fit
    verdict: str
    resonances: list[tuple[str, float]]

    def values(self) -> dict[str, Value]:
        """Return `rolling`, `air` and whatever else was sought, of all recordings together."""
        return self.pool.values()

    def __repr__(self):
        return f"Fits({len(self.files)} recordings: {self.verdict}; {in_words(self.values())})"


@one_blas_thread
def fit(
    files: str | Path | Iterable[str | Path],
    scene: Scene | str | Path = "toy",
    like: str | None = None,
    watch: Callable[[float, str], None] = lambda share, doing: None,
    span: tuple[float, float] = (0.0, inf),
) -> Fits:
    """Return what slowed the disk of a scene in recordings: sound files, exports of phyphox,
    folders of takes.

    The scene gives radius, thickness and air. `like` "fu-berlin" adds the exponents of a published
    chain. Only the part of each recording within the `span` [s] is analysed. Raises RecordingError
    for a recording that cannot be fitted, in one line, and SceneError
    for a wrong scene."""
    from sonify.claims.resonance_matching import resonances  # modes load slowly

    scene = load_scene(scene) if isinstance(scene, (str, Path)) else scene
    paths = takes([files] if isinstance(files, (str, Path)) else files)
    known = resonances(scene)
    fitted = []
    tasks = [(path, scene.document, like, span) for path in paths]
    for one in (
        (fit_one(*task) for task in tasks) if len(tasks) < MANY else each(fit_one, tasks, WORKERS)
    ):
        fitted.append(one)
        watch(len(fitted) / len(paths), one.file)
    decline = fitted[0].judged.decline
    fits = [one.judged.fit for one in fitted]
    pool = fits[0] if len(fits) == 1 else pooled(fits)
    verdict = fitted[0].judged.verdict if len(fits) == 1 else verdict_of(decline, pool)
    return Fits(scene=scene, files=fitted, pool=pool, verdict=verdict, resonances=known)


@one_blas_thread
def fit_one(
    path: Path, document: dict, like: str | None, span: tuple[float, float] = (0.0, inf)
) -> Fitted:
    """Return the fit of one recording between two times [s]; the scene comes as its document.

    Raises RecordingError.
    """
    scene = from_document(document)
    recording = source(path)
    try:
        part = excerpt(source_of(recording), *span)
    except (soundfile.LibsndfileError, OSError):
        part = recording  # `heard` tells why
    sound = heard(part, str(path), recorded=recorded(path), begin=span[0])
    decline = Decline(scene)
    judged = judge(decline, [sound])
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
        radius_shows=radius_shows(judged),
        carriers=carriers(sound.samples, sound.rate, sound.start),
        published_way=published,
        truncation=truncation_of(recording),
    )


def radius_shows(judged: Judged) -> bool:
    """Return whether declines of disks whose radius is 10 % off fit far worse, however what slows
    them is chosen."""
    found = [_with_radius(judged, factor) for factor in WRONG]
    return all(
        spread is None or spread > BETTER * max(judged.fit.spread, FLOOR) for spread in found
    )


def _with_radius(judged, factor):
    """The spread of the fit of a disk of another radius; None if it cannot follow the tone."""
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
