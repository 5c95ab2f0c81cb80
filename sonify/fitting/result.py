"""Fits of single recordings and of all of them together, with a test of the radius."""

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, field, replace
from math import inf
from pathlib import Path
from typing import Any

from modal.blas_threads import one_blas_thread
from sonify.fitting import least_squares
from sonify.fitting.comparison import numbers_of_run
from sonify.fitting.decay_model import DecayModel
from sonify.fitting.impacts import judge_sound
from sonify.fitting.least_squares import Fit, Value, fitted_shares_in_words, pool_fits
from sonify.fitting.line_selection import (
    Judged,
    detect_run,
    verdict_of,
    with_film_error,
)
from sonify.fitting.parallel import in_worker_processes
from sonify.fitting.settings import FIT
from sonify.hearing.audio_source import (
    Truncation,
    excerpt,
    source_of_file,
    truncation_of,
)
from sonify.hearing.recording_errors import RecordingError
from sonify.hearing.recording_files import is_recording, recording_files
from sonify.hearing.spectral_lines import SpectralLine, find_spectral_lines
from sonify.runtime.progress import Watch, ignore_progress
from sonify.runtime.workers import core_count
from sonify.scene import Scene, from_document, load_scene
from sonify.scene_errors import InputError

DEFAULT_SCENE = "granite"
"""Scene of a fit without one: the toy on a plane slab that does not act on its motion."""


@dataclass(frozen=True, kw_only=True, eq=False)
class Fitted:
    """Result for one recording: `judged`, a test of the radius, and spectral lines.

    `radius_shows` is True if an error of 10 % in the radius would be detected.
    `truncation` describes a truncated file, and `measured` contains the numbers for
    comparison with a simulation."""

    file: str
    judged: Judged
    radius_shows: bool
    carriers: list[SpectralLine]
    truncation: Truncation | None
    measured: dict[str, Any]

    def __repr__(self) -> str:
        return f"Fitted({self.file}: {self.judged.verdict}; {fitted_shares_in_words(self.judged.fitted_shares())})"


@dataclass(frozen=True, kw_only=True)
class NotFitted:
    """Recording that could not be fitted, and the `reason`.

    `is_input_error` is False if the program failed."""

    file: str
    reason: str
    is_input_error: bool


@dataclass(frozen=True, kw_only=True, eq=False)
class Fits:
    """Fits of recordings of one disk.

    Attributes
    ----------
    scene : Scene
        Scene with the radius, the thickness and the air of the disk.
    files : list of Fitted
        Result for each recording.
    pool : Fit
        Fit of all recordings together.
    verdict : str
        "rolling", "air", "both", "impacts", "mixed", "not this scene" or "cannot tell",
        for all recordings.
    resonances : list of (str, float)
        Origin ("disk", "table" or "contact") and frequency [Hz] of each resonance of
        the scene.
    not_fitted : list of NotFitted
        Recordings that could not be fitted, with the reason.
    skipped : list of str
        Lines on the files of folders that are no recordings.

    Examples
    --------
    >>> from sonify import fit
    >>> fits = fit("recordings", scene="granite")  # doctest: +SKIP
    >>> fits.values()["rolling"].value  # contour friction  # doctest: +SKIP
    """

    scene: Scene
    files: list[Fitted]
    pool: Fit
    verdict: str
    resonances: list[tuple[str, float]]
    not_fitted: list[NotFitted] = field(default_factory=list)
    skipped: list[str] = field(default_factory=list)

    def values(self) -> dict[str, Value]:
        """Return the fitted shares of all recordings together.

        Returns
        -------
        dict of str to Value
            The dimensionless shares "rolling", "air" and "law", each with its 95 %
            interval.
        """
        return self.pool.fitted_shares()

    def __repr__(self) -> str:
        return f"Fits({len(self.files)} recordings: {self.verdict}; {fitted_shares_in_words(self.values())})"


@one_blas_thread
def fit(
    files: str | Path | Iterable[str | Path],
    scene: Scene | str | Path = DEFAULT_SCENE,
    watch: Watch = ignore_progress,
    span: tuple[float, float] = (0.0, inf),
    notice: Callable[[str], None] = lambda line: None,
) -> Fits:
    """Determine the causes that slowed the disk in recordings.

    A recording that cannot be fitted does not affect the others.

    Parameters
    ----------
    files : str, Path, or iterable of them
        Sound files, phyphox exports, or folders of them.
    scene : Scene, str or Path
        Scene with the radius, the thickness and the air of the disk; a name or a path
        as in `load_scene`.
    watch : callable
        Called as watch(share, file) after each recording, with the share of the
        recordings that are finished.
    span : pair of float
        Start and end [s] of the analysed part of each recording.
    notice : callable
        Called as notice(line) with a line on each skipped file of a folder.

    Returns
    -------
    Fits
        The fits and the verdicts.

    Raises
    ------
    RecordingError
        If none of the recordings can be fitted.
    SceneError
        If the scene is invalid.

    Examples
    --------
    >>> from sonify import fit
    >>> fit("coin.wav", scene="coin").verdict  # doctest: +SKIP
    'rolling'
    """
    from sonify.plan.preflight import known_resonances  # slow to import

    scene = load_scene(scene) if isinstance(scene, (str, Path)) else scene
    skipped: list[str] = []
    paths = recording_files(
        [files] if isinstance(files, (str, Path)) else files, skipped.append
    )
    for line in skipped:
        notice(line)
    known = known_resonances(scene)
    fitted = []
    errors = {}
    tasks = [(path, scene.document, span) for path in paths]
    for path, one in zip(paths, _fits_or_errors(tasks), strict=True):
        if isinstance(one, Fitted):
            fitted.append(one)
        else:
            errors[path] = one
        watch((len(fitted) + len(errors)) / len(paths), str(path))
    not_fitted = [_not_fitted(path, error) for path, error in errors.items()]
    if not fitted:
        raise _error_of_all(list(errors.values()), not_fitted)
    judged = [one.judged for one in fitted]
    decay, pool = pool_judged(judged)
    verdict = _common_verdict(judged, decay, pool)
    return Fits(
        scene=scene,
        files=fitted,
        pool=pool,
        verdict=verdict,
        resonances=known,
        not_fitted=not_fitted,
        skipped=skipped,
    )


def _fits_or_errors(tasks: list[tuple[Any, ...]]) -> Iterator[Fitted | Exception]:
    """Yield the fit of every recording, or the exception that ended it."""
    min_parallel_count = 3
    if len(tasks) < min_parallel_count:
        return (fit_or_error(*task) for task in tasks)
    return in_worker_processes(fit_or_error, tasks, min(core_count(), len(tasks)))


def fit_or_error(*task: Any) -> Fitted | Exception:
    """Return the fit of one recording, or the exception that ended it; the arguments
    are those of `fit_one`."""
    try:
        return fit_one(*task)
    except Exception as error:  # one recording must not end the fit of the others
        return error


def _not_fitted(path: str | Path, error: Exception) -> NotFitted:
    is_input_error = isinstance(error, InputError)
    reason = str(error) if is_input_error else f"{type(error).__name__}: {error}"
    if not reason.startswith(str(path)):
        reason = f"{path}: {reason}"
    return NotFitted(file=str(path), reason=reason, is_input_error=is_input_error)


def _error_of_all(errors: list[Exception], not_fitted: list[NotFitted]) -> Exception:
    """Return the error if no recording can be fitted: a failure of the program, if there
    is one."""
    failures = [error for error in errors if not isinstance(error, InputError)]
    if failures or len(errors) == 1:
        return (failures or errors)[0]
    reasons = "; ".join(one.reason for one in not_fitted)
    return RecordingError(
        f"none of the {len(errors)} recordings can be fitted: {reasons}"
    )


def pool_judged(judged: list[Judged]) -> tuple[DecayModel, Fit]:
    """Return the fit of all recordings together, and its decay.

    Recordings that no motion explains, or that determine other causes than the first
    explained one, are left out. The error of the film law, common to all recordings, is
    not reduced by their number."""
    explained = [
        one for one in judged if one.explained and one.verdict != "not this scene"
    ]
    first, *_ = explained or judged
    fits = [one.fit for one in explained or judged if one.fit.free == first.fit.free]
    if len(fits) == 1:
        return first.decay, fits[0]
    return first.decay, with_film_error(first.decay, pool_fits(fits))


def _common_verdict(judged: list[Judged], decay: DecayModel, pool: Fit) -> str:
    """Return the verdict on all recordings, which is "mixed" for impacts and other
    causes."""
    verdicts = {one.verdict for one in judged}
    by_exponent = [bool(one.reason) for one in judged]
    if len(verdicts) == 1:
        return verdicts.pop()
    if all(by_exponent):
        return "impacts" if verdicts == {"impacts", "cannot tell"} else "cannot tell"
    return "mixed" if any(by_exponent) else verdict_of(decay, pool)


@one_blas_thread
def fit_one(
    path: Path, document: dict[str, Any], span: tuple[float, float] = (0.0, inf)
) -> Fitted:
    """Return the fit of one recording within a span [s], for a scene given as its
    document.

    Raises RecordingError with a one-line message if the recording cannot be fitted.
    """
    scene = from_document(document)
    recording = source_of_file(path)
    part = excerpt(recording, *span)
    sound = detect_run(part, str(path), recorded=is_recording(recording), begin=span[0])
    decay = DecayModel(scene)
    judged = judge_sound(decay, sound)
    return Fitted(
        file=str(path),
        judged=judged.without_samples(),
        radius_shows=is_radius_determined(judged),
        carriers=find_spectral_lines(sound.samples, sound.rate, sound.start),
        truncation=truncation_of(recording),
        measured=numbers_of_run(part, sound.run.later(-span[0])),
    )


def is_radius_determined(judged: Judged) -> bool:
    """Return True if disks with a radius 10 % larger or smaller fit much worse."""
    if judged.stream is None:
        return False
    max_spread = FIT.equivalent_fit_ratio * max(judged.fit.spread, FIT.min_rate_error)
    spreads = [_spread_with_radius(judged, factor) for factor in (0.9, 1.1)]
    return all(spread is None or spread > max_spread for spread in spreads)


def _spread_with_radius(judged: Judged, factor: float) -> float | None:
    """Return the spread of the fit of a disk with another radius; None if the fit
    fails."""
    assert judged.stream is not None, "the fit is that of a tone"
    scene = judged.decay.scene
    one = judged.fit
    disk = replace(
        scene.disk, radius=factor * scene.disk.radius, density=None
    )  # the mass is unchanged
    decay = DecayModel(replace(scene, disk=disk)).line_models[judged.line]
    decay.excess_turns = judged.decay.excess_turns
    try:
        return least_squares.fit(
            decay, judged.stream, one.ends[0], one.shares, one.free
        ).spread
    except ValueError:
        return None
