"""Claim: every table that phyphox exports gives the amplitudes in it, in whichever of its CSV forms,
alone or in a ZIP file; any other table has one sentence with its fault.

Source: the export formats of phyphox for Android and iOS: five pairs of separator and decimal sign,
names of columns in quotes, missing cells as NaN or as empty text. Oracle: the numbers that were
written, in the first form.
"""

import csv
import io
import re
import zipfile

import numpy as np
import pytest

from sonify.hearing.audio_source import Recording, source_of
from sonify.hearing.recording import RecordingError

FORMS = [(",", "."), ("\t", "."), (";", "."), ("\t", ","), (";", ",")]
"""Separator and decimal sign of the CSV formats of phyphox."""
RATE = 8000
COUNT = 600
AMPLITUDES = np.round(np.sin(np.arange(COUNT) / 5) * np.exp(-np.arange(COUNT) / 200), 9)


def android(number):
    """Return a number with ten digits, as Android writes it."""
    mantissa, exponent = f"{number:.9e}".split("e")
    return f"{mantissa}E{int(exponent)}"


def rows(names=("Time (ms)", "Recording (a.u.)"), per_second=1e3):
    """Return the cells of a table of the amplitudes."""
    times = np.arange(COUNT) / RATE * per_second
    pairs = zip(times, AMPLITUDES, strict=True)
    return [names, *((android(t), android(x)) for t, x in pairs)]


def text_of(cells, separator=",", decimal="."):
    """Return a table as phyphox writes it: names in quotes, numbers without."""
    names, *numbers = cells
    lines = [separator.join(f'"{name}"' for name in names)]
    lines += [separator.join(row).replace(".", decimal) for row in numbers]
    return "\n".join(lines) + "\n"


def read(folder, text, name="table"):
    path = folder / name
    path.write_bytes(text if isinstance(text, bytes) else text.encode())
    return source_of(path)


def assert_amplitudes(source):
    assert isinstance(source, Recording)
    assert source.sample_rate == RATE
    assert source.frames == COUNT
    assert source.samples == pytest.approx(AMPLITUDES, abs=1e-7)


@pytest.mark.slow
@pytest.mark.parametrize(("separator", "decimal"), FORMS)
@pytest.mark.parametrize("end", ["\n", "\r\n"])
@pytest.mark.parametrize("encoding", ["utf-8", "utf-8-sig", "utf-16"])
def test_every_form_has_the_same_samples(tmp_path, separator, decimal, end, encoding):
    text = text_of(rows(), separator, decimal).replace("\n", end)
    first = read(tmp_path, text_of(rows()))
    assert_amplitudes(first)
    found = read(tmp_path, text.encode(encoding), "take.csv")
    assert np.array_equal(found.samples, first.samples)
    with zipfile.ZipFile(tmp_path / "take.zip", "w", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr("meta/device.csv", f'"property"{separator}"value"{end}')
        archive.writestr("meta/time.csv", '"event","experiment time","system time"\n')
        archive.writestr("Raw data.csv", text.encode(encoding))
    assert np.array_equal(source_of(tmp_path / "take.zip").samples, first.samples)


@pytest.mark.parametrize("missing", ["NaN", "nan", "", '""'])
@pytest.mark.parametrize(("separator", "decimal"), FORMS)
def test_cells_missing_at_the_end_are_left_out(tmp_path, missing, separator, decimal):
    """The column of times or that of amplitudes may be the shorter one, and both shorter than a
    third."""
    text = text_of(rows(), separator, decimal)
    for cells in ([missing, "1"], ["1", missing], [missing, missing]):
        tail = 3 * (separator.join(cells).replace(".", decimal) + "\n")
        assert_amplitudes(read(tmp_path, text + tail))
    third = [(*row, "1.5") for row in rows()] + [(missing, missing, "1.5")] * 4
    assert_amplitudes(read(tmp_path, text_of(third, separator, decimal)))


@pytest.mark.parametrize(
    "names",
    [
        ("Time (s)", "Recording (a.u.)"),
        ("Zeit (s)", "Aufnahme (w.E.)"),
        ("Temps (s)", "Enregistrement, brut (u.a.)"),
        ("時間 (s)", "録音 (a.u.)"),
        ("time [s]", "amplitude; left"),
        ("Time (S) ", " 'x"),
    ],
)
@pytest.mark.parametrize(("separator", "decimal"), FORMS)
def test_translated_names_have_the_unit_of_times(tmp_path, names, separator, decimal):
    text = text_of(rows(names, 1.0), separator, decimal)
    assert_amplitudes(read(tmp_path, text))
    swapped = [(row[1], row[0]) for row in rows(names, 1.0)]
    assert_amplitudes(read(tmp_path, text_of(swapped, separator, decimal)))


def test_tables_of_other_programs_are_read(tmp_path):
    """All cells in quotes, spaces, a minus sign of typography, blank lines, a comma in quotes."""
    stream = io.StringIO()
    csv.writer(stream, quoting=csv.QUOTE_ALL).writerows(rows())
    assert_amplitudes(read(tmp_path, stream.getvalue()))
    quoted = stream.getvalue().replace(".", ",").replace("a,u,", "a.u.")
    assert_amplitudes(read(tmp_path, quoted))
    assert_amplitudes(read(tmp_path, text_of(rows(), ";").replace(";", " ; ")))
    typographic = text_of(rows(), "\t", ",").replace("-", "\N{MINUS SIGN}")
    assert_amplitudes(read(tmp_path, typographic))
    assert_amplitudes(read(tmp_path, "\n" + text_of(rows()).replace("\n", "\n\n")))
    assert_amplitudes(
        read(tmp_path, text_of(rows()).replace("(a.u.)", "(m/s²)").encode("latin-1"))
    )


def test_the_longest_table_of_an_export_is_read(tmp_path):
    """Other sets of an export may be short, of other quantities, or no text."""
    short = text_of(rows()[:20])
    level = '"Time (s)","Level (dB)"\n' + "".join(f"{k},{-k}\n" for k in range(150))
    with zipfile.ZipFile(tmp_path / "take.zip", "w") as archive:
        archive.writestr("Peaks.csv", short)
        archive.writestr("Level.csv", level)
        archive.writestr("Raw data.csv", text_of(rows()))
        archive.writestr("Spectrum.csv", '"Frequency (Hz)","Level"\n1,2\n')
        archive.writestr("__MACOSX/._Raw data.csv", b"\0\5\x16\7\0\2\0\0Mac OS X")
        archive.writestr("screenshot.png", b"\x89PNG\r\n\x1a\n\0\0")
    assert_amplitudes(source_of(tmp_path / "take.zip"))


def changed(line, cells, separator=","):
    lines = text_of(rows(), separator).splitlines()
    lines[line - 1] = separator.join(cells)
    return "\n".join(lines)


@pytest.mark.parametrize(
    ("text", "fault"),
    [
        (changed(300, ["1", "x"]), "line 300: 'x' is not a number"),
        (changed(300, ["NaN", "1"]), "a cell before its last complete row"),
        (changed(300, ["1e3", "inf"]), "a cell before its last complete row"),
        (changed(300, ["0", "1"]), "do not increase from row to row"),
        (changed(300, ["1", "0", "2", "0"]), "line 300 has more cells than its header"),
        (text_of(rows()[:50]), "too few rows, 49; at least 100 are required"),
        (text_of(rows()[:1]), "too few rows, 0"),
        (text_of(rows(per_second=1e8)), "less than one row per second"),
        ('"Frequency (Hz)","Level"\n1,2\n', "a column 'Time (s)' or 'Time (ms)'"),
        ('"Time (s)"\n1\n2\n', "a column 'Time (s)' or 'Time (ms)'"),
        ('"Time (s)","x"\n1,' + "9" * 200_000 + "\n", "field larger than field limit"),
    ],
    ids=lambda value: value[-40:],
)
def test_the_fault_of_a_table_is_one_sentence(tmp_path, text, fault):
    with pytest.raises(RecordingError, match=re.escape(fault)) as refused:
        read(tmp_path, text)
    assert str(refused.value).startswith(f"{tmp_path / 'table'}: not a readable sound")
    assert "\n" not in str(refused.value)


def zip_of(folder, **members):
    path = folder / "made.zip"
    with zipfile.ZipFile(path, "w") as archive:
        for name, content in members.items():
            archive.writestr(name, content)
    return path.read_bytes()


def test_a_spreadsheet_has_one_sentence_that_names_csv(tmp_path):
    books = [
        zip_of(tmp_path, **{"[Content_Types].xml": "", "xl/workbook.xml": ""}),
        zip_of(tmp_path, **{"mimetype": "", "content.xml": ""}),
        b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1" + bytes(600),
    ]
    for book in books:
        with pytest.raises(RecordingError, match="spreadsheet; export the data as CSV"):
            read(tmp_path, book, "take.csv")


def test_a_faulty_zip_file_is_one_sentence(tmp_path):
    whole = zip_of(tmp_path, **{"Raw data.csv": text_of(rows())})
    start = whole.index(b"Raw data.csv") + 200
    damaged = whole[:start] + b"#" + whole[start + 1 :]
    encrypted = bytearray(whole)
    encrypted[6] |= 1
    encrypted[whole.index(b"PK\1\2") + 8] |= 1
    for content, reason in [
        (whole[:2000], "a damaged or encrypted ZIP file"),
        (damaged, "a damaged or encrypted ZIP file: Bad CRC-32"),
        (bytes(encrypted), "a damaged or encrypted ZIP file"),
        (
            zip_of(tmp_path, **{"take.wav": b"RIFF\0\0\0\0WAVE"}),
            "unpack sound files first",
        ),
    ]:
        with pytest.raises(RecordingError, match=reason) as refused:
            read(tmp_path, content)
        assert "\n" not in str(refused.value)
