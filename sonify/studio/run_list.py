"""List the finished runs in a folder, with names in words."""

import json
import re
from collections.abc import Iterable, Mapping
from datetime import datetime
from math import log10
from pathlib import Path
from typing import Any

from starlette.exceptions import HTTPException

from sonify.claims.checks import Check
from sonify.hearing.spectrogram import REFERENCE_PRESSURE_PA
from sonify.report.run_names import run_name
from sonify.runtime.files import readable_text


def finished_runs(root: Path) -> list[dict[str, Any]]:
    """Return the list entry of every finished run in `root`, newest first."""
    records = [
        path for depth in range(4) for path in root.glob("*/" * depth + "run.json")
    ]
    records.sort(key=lambda path: path.stat().st_mtime, reverse=True)
    return [run for path in records if (run := _run_entry(root, path))]


def _run_entry(root: Path, path: Path) -> dict[str, Any] | None:
    """Return the list entry of a run.json, or None if the file is not a readable record
    of a run.

    A folder whose name is not UTF-8 has no address, so that its page is not offered.
    """
    folder = path.parent.relative_to(root).as_posix()
    place = readable_text(folder)
    has_address = place == folder
    has_page = has_address and (path.parent / "report.html").is_file()
    picture = path.parent / "spectrogram.png"
    try:
        return _entry_of_record(json.loads(path.read_text(encoding="utf-8"))) | {
            "place": place,
            "date": datetime.fromtimestamp(path.stat().st_mtime),
            "is_shown": has_page,
            "page": has_page,
            "picture": has_address and picture.is_file(),
        }
    except (OSError, ValueError, LookupError, TypeError, RecursionError):
        return None


def shipped_run_entry(record: Mapping[str, Any], place: str) -> dict[str, Any]:
    """Return the list entry of a run that the studio contains, which has neither page nor
    date, from its run.json."""
    without_files = {"date": None, "is_shown": True, "page": False, "picture": False}
    return _entry_of_record(record) | without_files | {"place": place}


def _entry_of_record(record: Mapping[str, Any]) -> dict[str, Any]:
    """Return the part of a list entry that follows from the run.json of a run."""
    name = run_name(record["scene"])
    return {
        "name": name.words,
        "changes": name.changes,
        "end": record.get("motion", {}).get("end"),
        "level": level_at_listener(record.get("sound", {})),
        "outcome": record["outcome"]["sentence"],
        "headline": record.get("headline", ""),
        "excessive": _takes_too_much(record.get("findings", [])),
        "failed": _failed_check_lines(record["checks"]),
        "checks": len(record["checks"]),
    }


def _takes_too_much(findings: Iterable[Mapping[str, Any]]) -> bool:
    """Return True if the table of a run takes more power than the disk loses."""
    return any(
        found["key"] == "disk_supplies_table" and found["verdict"] == "no"
        for found in findings
    )


def level_at_listener(sound: dict[str, Any]) -> float | None:
    """Return the K-weighted level [dB re 20 µPa] of a sound from its record in run.json.

    It is the loudness by BS.1770, in which 0 dB is the scale of sound.wav, at the true
    scale; None if the sound is too short or silent.
    """
    loudness = sound.get("loudness_lufs")
    if not isinstance(loudness, int | float):
        return None
    return loudness + 20 * log10(sound["full_scale_pascal"] / REFERENCE_PRESSURE_PA)


def _failed_check_lines(checks: Iterable[Mapping[str, Any]]) -> list[str]:
    """Return one line for each failed self-check of a run."""
    failed = []
    for record in checks:
        if not record["passed"]:
            numbers = {
                name: float(record[name]) for name in ("value", "expected", "tolerance")
            }
            check = Check(
                key="",
                name=record["name"],
                source="",
                one_sided=record["one_sided"],
                **numbers,
            )
            failed.append(
                f"{check.name}: {check.value:.4g}, expected {check.expectation}"
            )
    return failed


def embedded_run_data(page: Path) -> str:
    """Return the JSON data embedded in the page of a run.

    Raises HTTPException 404 if the page does not exist or contains no data.
    """
    text = page.read_text(encoding="utf-8") if page.is_file() else ""
    embedded = '<script type="application/json" class="run">(.*?)</script>'
    if data := re.search(embedded, text, re.DOTALL):
        return data[1]
    raise HTTPException(404, "no such run")
