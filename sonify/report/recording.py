"""Report the analysis of a user's sound file in words, numbers and pictures."""

import json
from collections.abc import Callable, Iterable, Sequence
from dataclasses import asdict
from math import inf
from pathlib import Path
from typing import TYPE_CHECKING, Any

from sonify.hearing.audio_source import AudioSource, excerpt, source_of, truncation_of
from sonify.hearing.recording import Heard, listen, read
from sonify.hearing.recording_errors import RecordingError
from sonify.hearing.recording_files import recording_files
from sonify.hearing.ring_down import DecayingLine, decaying_lines, free_ringing
from sonify.hearing.spectral_lines import SpectralLine
from sonify.hearing.spectrogram import (
    CONTACT_RATE_BAND_HZ,
    CONTACT_RATE_WINDOW_S,
    MODE_WINDOW_S,
    spectrogram,
)
from sonify.report.settling import (
    false_alarm_sentence,
    region_sentence,
    run_sentences,
    settling_run_record,
)
from sonify.runtime.files import (
    OutputError,
    atomic_write,
    create_folder,
    first_matching_folder,
)
from sonify.runtime.json_values import json_safe, write_json
from sonify.runtime.progress import Stages
from sonify.scene_errors import InputError

if TYPE_CHECKING:
    from sonify.claims.resonance_matching import Match
    from sonify.hearing.settling.detector import SettlingRun


def write_recording_reports(
    recordings: Iterable[str | Path],
    out: str | Path | None,
    scene: str | Path | None,
    stages: Stages,
    span: tuple[float, float],
    echo: Callable[[str], None],
) -> int:
    """Analyse sound files, phyphox exports and folders of them, and pass the results as
    lines of text to `echo`.

    A recording that cannot be analysed does not affect the others. Each of several
    recordings has a folder in `out`. Returns the number of recordings for which the
    program failed. Raises RecordingError if none can be analysed, SceneError if the
    scene is invalid, and OutputError if `out` cannot be written."""
    given = [Path(recording) for recording in recordings]
    known = resonances_of_scene(scene)
    paths = recording_files(given, stages.notice)
    if len(given) == 1 and paths == given:
        for line in _write_report(given[0], out, known, stages, span):
            echo(line)
        return 0
    errors: list[Exception] = []
    for path in paths:
        folder = default_report_folder(path, out)
        try:
            lines = _write_report(path, folder, known, stages, span)
        except OutputError:
            raise
        except Exception as error:  # one recording must not end the analysis of others
            errors.append(error)
            stages.notice(_failure_sentence(path, error))
            continue
        echo(f"{path}:")
        for line in lines:
            echo(line)
    failures = [error for error in errors if not isinstance(error, InputError)]
    if len(errors) == len(paths):
        raise (failures or [RecordingError("none of the recordings can be analysed")])[
            0
        ]
    return len(failures)


def _failure_sentence(path: str | Path, error: Exception) -> str:
    """Return the reason why a recording could not be analysed."""
    if not isinstance(error, InputError):
        return f"{path}: {type(error).__name__}: {error}"
    return str(error) if str(error).startswith(str(path)) else f"{path}: {error}"


def _write_pictures(
    folder: Path,
    whole_sound: AudioSource,
    span: tuple[float, float],
    part: AudioSource,
    runs: "Sequence[SettlingRun]",
) -> None:
    """Write spectrogram.png of the `part` of a sound in a span [s], and settling.png of
    the runs in it, if there are any."""
    from sonify.report.sound import draw_recording, draw_settling

    low = spectrogram(whole_sound, CONTACT_RATE_WINDOW_S, span=span).band(
        *CONTACT_RATE_BAND_HZ
    )
    high = spectrogram(whole_sound, MODE_WINDOW_S, span=span)
    begin = max(span[0], 0.0)
    duration = part.frames / part.sample_rate
    with atomic_write(folder / "spectrogram.png") as temporary:
        draw_recording(temporary, low, high, (begin, begin + duration), runs)
    if runs:
        with atomic_write(folder / "settling.png") as temporary:
            draw_settling(temporary, part, begin, runs)


def write_recording_report(
    recording: str | Path,
    out: str | Path | None = None,
    scene: str | Path | None = None,
    stages: Stages | None = None,
    span: tuple[float, float] = (0.0, inf),
) -> list[str]:
    """Analyse a recording and return the results as lines of text.

    The files heard.json and spectrogram.png are written to `out`, and settling.png if a
    settling disk is detected. If a `scene` is given, spectral lines are matched to its
    resonances. `stages` shows the progress, and a notice if the file is truncated. Only
    the part within the `span` [s] is analysed.

    Raises RecordingError and SceneError before anything is written, and OutputError if
    `out` cannot be written.
    """
    known = resonances_of_scene(scene)
    return _write_report(recording, out, known, stages or Stages(), span)


def _write_report(
    recording: str | Path,
    out: str | Path | None,
    known: list[tuple[str, float]],
    stages: Stages,
    span: tuple[float, float],
) -> list[str]:
    """Write the files of `write_recording_report` and return its lines of text.

    `known` are the resonances of the scene."""
    whole_sound = source_of(recording)
    read(whole_sound)  # raises RecordingError if it cannot be analysed
    begin = max(span[0], 0.0)
    part = excerpt(whole_sound, *span)
    with stages.stage("detection") as watch:
        heard = listen(part, begin=begin, watch=watch)
    runs = heard.runs
    truncation = truncation_of(whole_sound)
    if truncation:
        stages.notice(f"{recording}: {truncation}")
    samples, rate, _, _ = read(part)
    ringing = decaying_lines(samples[free_ringing(samples, rate)], rate)
    folder = create_folder(out or default_report_folder(recording))
    _write_pictures(folder, whole_sound, span, part, runs)
    content = {
        "recording": absolute_path_text(recording),
        **analysis_record(heard, known),
        "decaying_lines": [asdict(line) for line in ringing],
        "runs": [settling_run_record(run) for run in runs],
    }
    write_json(json_safe(content), folder / "heard.json")
    settled = [line for run in runs for line in run_sentences(run)]
    settled += [region_sentence(run) for run in runs]
    first, *lines = analysis_sentences(heard, known)
    max_ringing_sentences = 4  # heard.json contains all decaying lines
    return [
        first,
        *(settled or ["no disk or coin that comes to rest was detected"]),
        false_alarm_sentence(),
        *lines,
        *(ringing_sentence(line) for line in ringing[:max_ringing_sentences]),
        str(folder),
    ]


def default_report_folder(
    recording: str | Path, root: str | Path | None = None
) -> Path:
    """Return the folder <name of the recording> in `root`, outputs/listen by default.

    If it belongs to another recording, <name>-2, <name>-3, ... are tried.
    """
    first = Path(root or Path("outputs") / "listen") / Path(recording).stem
    return first_matching_folder(
        first,
        lambda folder: (
            recording_named_in_folder(folder) in (None, absolute_path_text(recording))
        ),
    )


def recording_named_in_folder(folder: Path) -> str | None:
    """Return the path of the recording stored in the heard.json of a folder.

    The result is None if there is no such file, and "" if another program wrote it.
    """
    content = folder / "heard.json"
    try:
        return json.loads(content.read_text(encoding="utf-8"))["recording"]
    except (FileNotFoundError, NotADirectoryError):
        return None
    except (OSError, ValueError, LookupError, TypeError, RecursionError):
        return ""


def absolute_path_text(recording: str | Path) -> str:
    return str(Path(recording).resolve())


def resonances_of_scene(scene: str | Path | None) -> list[tuple[str, float]]:
    """Return the resonances of a scene, and none without a scene.

    Raises SceneError if the scene is invalid or cannot be solved."""
    if not scene:
        return []
    from sonify.plan.preflight import known_resonances  # slow import of modes
    from sonify.scene import load_scene

    return known_resonances(load_scene(scene))


def matching_resonance(
    carrier: SpectralLine, known: list[tuple[str, float]]
) -> "Match | None":
    if not known:
        return None
    from sonify.claims.resonance_matching import nearest_resonance

    return nearest_resonance(carrier, known)


def analysis_record(heard: Heard, known: list[tuple[str, float]]) -> dict[str, Any]:
    """Return the analysis as plain values: duration and start of the sound, and its
    spectral lines."""
    values = asdict(heard)
    del values["tone"], values["runs"]
    values["carriers"] = [spectral_line_record(line, known) for line in heard.carriers]
    return values


def spectral_line_record(
    carrier: SpectralLine, known: list[tuple[str, float]]
) -> dict[str, Any]:
    """Return a spectral line as plain values, with its trend (`course`) and the
    matching known resonance.
    """
    match = matching_resonance(carrier, known)
    return asdict(carrier) | {
        "course": carrier.course,
        "matched": match and match._asdict(),
    }


def analysis_sentences(heard: Heard, known: list[tuple[str, float]]) -> list[str]:
    """Return the analysis as lines of text."""
    return [
        f"{heard.duration:.3f} s at {heard.sample_rate} Hz, sound from {heard.start:.3f} s on",
        *(
            f"spectral line: {spectral_line_description(c)}"
            f"{match_clause(matching_resonance(c, known))}"
            for c in heard.carriers
        ),
    ]


def ringing_sentence(line: DecayingLine) -> str:
    """Return a description of a decaying spectral line."""
    return (
        f"free ringing: {line.frequency:.1f} Hz, amplitude decay {line.decay_rate:.1f} ± "
        f"{line.decay_error:.1f} 1/s"
    )


def match_clause(match: "Match | None") -> str:
    if not match:
        return ""
    return f"; a resonance of the {match.of}, {match.cents:+.1f} cents from {match.frequency:.1f} Hz"


def spectral_line_description(c: SpectralLine) -> str:
    course = c.course
    if course != "steady":
        course += f" by {abs(c.drift):.3g} ± {c.drift_error:.2g} cents/s"
    extras = ", sidebands ± {:.3g} to {:.3g} Hz".format(*c.rates) if c.rates else ""
    extras += "" if c.heard else ", inferred from its sidebands"
    extras += f", in a noise band {c.reach:.0f} cents wide" if c.reach else ""
    place = f"{c.frequency:.2f} ± {c.error:.3g} Hz from {c.begin:.2f} to {c.end:.2f} s, {course}"
    return f"{place}, spread {c.spread:.2f} cents, {c.level:.0f} dB above its surroundings{extras}"
