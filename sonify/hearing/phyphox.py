"""Tables of amplitude against time, as the app phyphox exports them.

The columns are separated by commas, semicolons or tabulators, with a decimal point or a
decimal comma. Shorter columns are filled with NaN or with empty cells. The tables are in
a ZIP file together with those of other quantities, or alone."""

import codecs
import csv
import io
import re
import zipfile
import zlib
from collections.abc import Iterator
from contextlib import suppress
from pathlib import Path
from typing import BinaryIO, NamedTuple

import numpy as np

from sonify.hearing.recording_errors import unreadable

ZIP_SIGNATURE = b"PK\x03\x04"
OLD_WORKBOOK_SIGNATURE = b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1"
SPREADSHEET_MEMBERS = ("xl/", "content.xml", "Index/Document.iwa")
"""Starts of the names of files in the spreadsheets of Excel, OpenDocument and Numbers."""
SPREADSHEET_ADVICE = (
    "it is a spreadsheet; export the data as CSV, which phyphox offers too"
)
SEPARATORS = "\t;,"
TIME_COLUMN_PATTERN = re.compile(r".*[(\[](m?s)[)\]]", re.IGNORECASE)
"""Name of a column of times; a translated name has the same unit."""
ZIP_ERRORS = (zipfile.BadZipFile, zlib.error, RuntimeError, EOFError)
"""Errors of a damaged, encrypted or unusually compressed ZIP file."""


class SampledTable(NamedTuple):
    """Amplitudes (n,) at equal intervals and their sample rate [Hz]."""

    samples: np.ndarray
    sample_rate: int


class TableForm(NamedTuple):
    """Separator of a table, its number of columns, the columns of times and amplitudes,
    and the times per second."""

    separator: str
    columns: int
    time: int
    amplitude: int
    times_per_second: float


class TableError(ValueError):
    """Fault of a table; the message is a clause."""


def may_contain_table(head: bytes) -> bool:
    """Return True if the first bytes of a file are those of a text, a ZIP file or a
    workbook."""
    return (
        head.startswith((ZIP_SIGNATURE, OLD_WORKBOOK_SIGNATURE))
        or decoded_text(head) is not None
    )


def advice_on_table(file: BinaryIO) -> str | None:
    """Return None for a table of amplitude against time, whose cells are not read.

    The result is advice for a spreadsheet, and an empty text for other files."""
    with suppress(*ZIP_ERRORS):
        if is_spreadsheet(file):
            return SPREADSHEET_ADVICE
        if any(table_form(text) for text in _texts_of_export(file, 1 << 12)):
            return None
    return ""


def read_table(file: BinaryIO, path: str | Path) -> SampledTable:
    """Return the longest table of amplitude against time in an open file.

    `path` names the file in messages. Raises RecordingError if it contains no valid
    table."""
    tables = []
    faults = []
    try:
        if is_spreadsheet(file):
            raise unreadable(path, SPREADSHEET_ADVICE)
        for text in _texts_of_export(file):
            form = table_form(text)
            if form is None:
                continue
            try:
                tables.append(_sampled_table(text, form))
            except (TableError, csv.Error) as fault:
                faults.append(str(fault))
    except ZIP_ERRORS as error:
        raise unreadable(path, f"a damaged or encrypted ZIP file: {error}") from None
    if tables:
        return max(tables, key=lambda table: len(table.samples))
    if faults:
        raise unreadable(path, f"the table of amplitude against time: {faults[0]}")
    reason = (
        "neither sound nor a table with a column 'Time (s)' or 'Time (ms)' and a column of "
        "amplitudes"
    )
    if is_zip(file):
        reason = f"a ZIP file with {reason}; unpack sound files first"
    raise unreadable(path, reason)


def is_zip(file: BinaryIO) -> bool:
    """Return True if an open file begins as a ZIP file."""
    file.seek(0)
    return file.read(len(ZIP_SIGNATURE)) == ZIP_SIGNATURE


def is_spreadsheet(file: BinaryIO) -> bool:
    """Return True if an open file is a spreadsheet.

    Raises one of ZIP_ERRORS for a damaged ZIP file."""
    if not is_zip(file):
        file.seek(0)
        return file.read(len(OLD_WORKBOOK_SIGNATURE)) == OLD_WORKBOOK_SIGNATURE
    with zipfile.ZipFile(file) as archive:
        names = archive.namelist()
    return any(name.startswith(SPREADSHEET_MEMBERS) for name in names)


def _texts_of_export(file: BinaryIO, length: int = -1) -> Iterator[str]:
    """Yield the text of an open file or of each text in a ZIP file, up to a `length`
    [bytes]."""
    if not is_zip(file):
        file.seek(0)
        text = decoded_text(file.read(length))
        if text is not None:
            yield text
        return
    with zipfile.ZipFile(file) as archive:
        for member in archive.infolist():
            with archive.open(member) as opened:
                head = opened.read(1 << 12)
                if decoded_text(head) is None:
                    continue
                text = decoded_text(head if length >= 0 else head + opened.read())
                if text is not None:
                    yield text


def decoded_text(data: bytes) -> str | None:
    """Return the text that bytes encode, or None if they are no text."""
    if data.startswith((codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE)):
        return data.decode("utf-16", "replace")
    controls = set(range(32)) - set(b"\t\n\f\r") | {127}
    if not data or controls.intersection(data[: 1 << 12]):
        return None
    try:
        return data.decode("utf-8-sig")
    except UnicodeDecodeError:  # text of old programs, or cut within a character
        return data.decode("latin-1")


def table_form(text: str) -> TableForm | None:
    """Return the form of a table with a header, or None if it has no column of times
    and no other column."""
    header_line = text.lstrip().partition("\n")[0].rstrip("\r")
    for separator in SEPARATORS:
        header = next(csv.reader([header_line], delimiter=separator), [])
        units = [TIME_COLUMN_PATTERN.fullmatch(name.strip()) for name in header]
        found = [(index, unit) for index, unit in enumerate(units) if unit]
        if found and len(header) > 1:
            time, unit = found[0]
            is_in_ms = unit[1].lower() == "ms"
            amplitude = 0 if time else 1
            return TableForm(
                separator, len(header), time, amplitude, 1e3 if is_in_ms else 1.0
            )
    return None


def _sampled_table(text: str, form: TableForm) -> SampledTable:
    """Return the amplitudes of a table, resampled at equal intervals.

    Rows at its end without a number are left out. Raises TableError for an invalid
    table."""
    min_row_count = 100
    rows = csv.reader(io.StringIO(text.lstrip(), newline=""), delimiter=form.separator)
    next(rows)
    cells = [_pair_of_numbers(row, form, rows.line_num) for row in rows if any(row)]
    t, x = np.reshape(cells, (-1, 2)).T
    complete = np.flatnonzero(~np.isnan(t + x))
    end = complete[-1] + 1 if len(complete) else 0
    t, x = t[:end], x[:end]
    if len(t) < min_row_count:
        raise TableError(
            f"too few rows, {len(t)}; at least {min_row_count} are required"
        )
    if not np.isfinite([t, x]).all():
        raise TableError("a cell before its last complete row is not a finite number")
    if not (np.diff(t) > 0).all():
        raise TableError("its times do not increase from row to row")
    rate = round((len(t) - 1) / (t[-1] - t[0]) * form.times_per_second)
    if rate < 1:
        raise TableError("it has less than one row per second")
    even = np.linspace(t[0], t[-1], len(t))
    return SampledTable(np.interp(even, t, x), rate)


def _pair_of_numbers(row: list[str], form: TableForm, line: int) -> list[float]:
    """Return time and amplitude in a row; a missing number is NaN."""
    if any(row[form.columns :]):
        raise TableError(f"line {line} has more cells than its header")
    return [
        _number(row[column], line) if column < len(row) else np.nan
        for column in (form.time, form.amplitude)
    ]


def _number(cell: str, line: int) -> float:
    """Return the number in a cell, NaN if it is empty."""
    text = cell.strip().replace(",", ".").replace("\N{MINUS SIGN}", "-")
    try:
        return float(text) if text else np.nan
    except ValueError:
        raise TableError(f"line {line}: {cell!r} is not a number") from None
