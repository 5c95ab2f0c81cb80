"""NUMBERS: what the article and the pages insert by name, as stored in numbers.json.

Values of the literature, of recordings and of tests are in quoted.toml, each with its source."""

import json
import re
import tomllib
from collections.abc import Callable
from dataclasses import asdict, dataclass, field
from functools import cache
from hashlib import sha256
from math import floor, isfinite, log10
from pathlib import Path
from typing import Any

from sonify.claims.finding import Finding
from sonify.runtime.files import write_text

HERE = Path(__file__).parent
ROOT = HERE.parents[1]
NUMBERS_FILE = HERE / "numbers.json"
TEXT_FOLDER = HERE / "text"
QUOTED = "quoted"
"""Name of the source of the values in quoted.toml."""
STORED_DIGITS = 6
"""Significant digits of a stored value."""
CURVE_DIGITS = 4
"""Significant digits of a stored point of a curve."""
SOLUTION_ERROR = 1e-10
"""Values are equal if they differ by this: errors of a solution depend on the processor."""

SUPERSCRIPTS = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")
NAME = re.compile(r"\[\[([a-z0-9][A-Za-z0-9_.+-]*)(?:\|([^\]]+))?\]\]")
"""Name of a number in a text, with its field or format."""
UNTYPED = re.compile(
    r"`[^`]*`|\$\$.*?\$\$|\$[^$]*\$"  # code and formulas
    r"|\[\[[^\]]*\]\]|\]\([^)]*\)|\[@[^\]]*\]|@(?:fig|tbl):\w+|<!--.*?-->"  # names and references
    r"|^\d+\. |\(\d+\.\d+\)|(?:section|footnote) \d+"  # places
    r"|\b(?:19|20)\d\d\b|\bRK45\b|\bDOP853\b|\b95 %",  # years, methods, and the level of every interval
    re.MULTILINE | re.DOTALL,
)
"""Parts of a text that may contain digits."""


class MissingNumberError(LookupError):
    """A text, table or figure names a number, reference or source that does not exist."""


class TypedNumberError(ValueError):
    """A text contains a number that is not inserted by name."""


@dataclass(frozen=True, kw_only=True)
class Number:
    """A value with its uncertainty; `low` and `high` are a 95 % interval where the method gives one.

    The other fields are those of a finding.
    """

    value: float
    unit: str = ""
    margin: float = 0.0
    low: float | None = None
    high: float | None = None
    at_least: float | None = None
    at_most: float | None = None
    tolerance: float = 0.0
    cause: str = ""
    undecided_because: str = ""

    def agrees(self, other: "Number", scatter: float) -> bool:
        """Return True if two values agree within both margins and a relative scatter."""
        allowed = (
            self.margin
            + other.margin
            + scatter * max(abs(self.value), abs(other.value))
        )
        return abs(self.value - other.value) <= allowed + SOLUTION_ERROR

    @property
    def verdict(self) -> str:
        """The verdict of the finding: yes, no or undecided."""
        return self.finding("").verdict

    def finding(self, key: str) -> Finding:
        """Return the finding without its words.

        Raises ValueError for a number without a range in which a claim holds.
        """
        if self.at_least is None and self.at_most is None:
            raise ValueError("this number has no range in which a claim holds")
        return Finding(
            key=key,
            claim="",
            value=self.value,
            unit=self.unit,
            margin=self.margin,
            at_least=-float("inf") if self.at_least is None else self.at_least,
            at_most=float("inf") if self.at_most is None else self.at_most,
            tolerance=self.tolerance,
            cause=self.cause,
            undecided_because=self.undecided_because,
            source="",
        )

    @property
    def measured(self) -> str:
        """The value and its uncertainty in words."""
        if self.low is not None:
            return (
                f"{rounded(self.value, 2):g} ({rounded(self.low, 2):g} to {self.upper})"
            )
        if self.margin > 0 and isfinite(self.value) and isfinite(self.margin):
            margin = float(f"{self.margin:.1g}")
            digits = -floor(log10(margin))
            if digits <= 6:
                shown = round(self.value, digits) + 0.0  # no negative zero
                return f"{shown:.{max(digits, 0)}f} ± {margin:g}"
        return f"{rounded(self.value, 4):g}"

    @property
    def upper(self) -> str:
        """The upper end of the interval in words."""
        return f"{rounded(self.high, 2):g}" if self.high is not None else ""


@dataclass(frozen=True, kw_only=True)
class Record:
    """The numbers of one source, with all that identifies their origin.

    Parameters
    ----------
    command : str
        Command that measures them.
    inputs : str
        Digest of the scene or of the table from which they follow.
    version : str
        Version of the program that measured them.
    seconds : float
        Computing time.
    scatter : float
        Relative difference that another processor may cause, because the motion is chaotic.
    numbers : dict of str to Number
        The numbers by name.
    curves : dict of str to list of list of float
        Points of the figures: lists of equal length.
    words : dict of str to str
        Names such as the outcome of a motion.
    sound : bytes
        FLAC file of the last seconds; not stored in numbers.json.
    """

    command: str
    inputs: str
    version: str
    seconds: float = 0.0
    scatter: float = 1e-3
    numbers: dict[str, Number] = field(default_factory=dict)
    curves: dict[str, list[list[float]]] = field(default_factory=dict)
    words: dict[str, str] = field(default_factory=dict)
    sound: bytes = b""


class Numbers(dict[str, Record]):
    """Records by the name of their source."""

    def number(self, name: str) -> Number:
        """Return the number `source.key`. Raises MissingNumberError."""
        source, _, key = name.partition(".")
        numbers = quoted_numbers() if source == QUOTED else self._of(source, "numbers")
        if key not in numbers:
            raise MissingNumberError(
                f"{name}: not in {NUMBERS_FILE.name}; run docs/article/measure.py"
            )
        return numbers[key]

    def curve(self, name: str) -> list[list[float]]:
        """Return the points of the curve `source.key`. Raises MissingNumberError."""
        source, _, key = name.partition(".")
        curves = self._of(source, "curves")
        if key not in curves:
            raise MissingNumberError(f"{name}: no such curve in {NUMBERS_FILE.name}")
        return curves[key]

    def _of(self, source: str, kind: str) -> dict[str, Any]:
        """Return the numbers or curves of a source; none if there is no such source."""
        return vars(self[source])[kind] if source in self else {}


@cache
def references() -> dict[str, dict[str, Any]]:
    """Return the fields of each reference by key."""
    return tomllib.loads((HERE / "references.toml").read_text("utf-8"))


def _without_spaces(text: str) -> str:
    """Return the text without white space, as the breaking of lines does not matter."""
    return "".join(text.split())


@cache
def quoted_numbers(path: Path = HERE / "quoted.toml") -> dict[str, Number]:
    """Return the quoted values by name.

    Raises MissingNumberError if a source does not exist or does not contain its text.
    """
    found = {}
    for name, entry in tomllib.loads(path.read_text("utf-8")).items():
        if "file" in entry:
            file = ROOT / entry["file"]
            known = file.is_file() and _without_spaces(
                entry["text"]
            ) in _without_spaces(file.read_text("utf-8"))
        else:
            known = "recording" in entry or entry.get("reference") in references()
        if not known:
            raise MissingNumberError(
                f"{QUOTED}.{name}: its source does not contain it: {entry}"
            )
        found[name] = Number(
            value=entry["value"],
            margin=entry.get("margin", 0.0),
            unit=entry.get("unit", ""),
        )
    return found


def rounded(value: float, digits: int = STORED_DIGITS) -> float:
    """Return a value with so many significant digits."""
    return float(f"{value:.{digits}g}")


def with_powers(text: str) -> str:
    """Return a number with a power of ten in place of its exponent."""

    def power(match: re.Match) -> str:
        mantissa, exponent = match.groups()
        ten = f"10{str(int(exponent)).translate(SUPERSCRIPTS)}"
        return ten if mantissa == "1" else f"{mantissa} × {ten}"

    return re.sub(r"(\d+(?:\.\d+)?)e([+-]\d+)", power, text).replace("-", "−")


def percent(share: float, digits: int = 2) -> str:
    """Return a share in percent, without its sign."""
    return f"{rounded(100 * share, digits):g}"


FIELDS: dict[str, Callable[[Number], str]] = {
    "": lambda number: number.measured,
    "verdict": lambda number: number.verdict,
    "cause": lambda number: number.cause,
    "margin": lambda number: f"{number.margin:.1g}",
    "percent": lambda number: (
        f"{percent(number.value)} % ({percent(number.low)} to {percent(number.high)})"
    ),
    "interval": lambda number: f"{number.low:.2g} to {number.high:.2g}",
    "total": lambda number: number.unit.removeprefix("of "),
    "count": lambda number: (
        f"{number.value * float(number.unit.removeprefix('of ')):.0f}"
    ),
}
"""Field of a number that a text may name -> function that returns it in words."""


def number_text(numbers: Numbers, name: str, form: str | None) -> str:
    """Return a number in words. Raises MissingNumberError."""
    number = numbers.number(name)
    form = form or ""
    if form in FIELDS:
        return (
            FIELDS[form](number)
            if form == "verdict"
            else with_powers(FIELDS[form](number))
        )
    form, _, factor = form.partition("*")
    return with_powers(
        format(number.value * float(factor or 1), form).replace("%", " %")
    )


def with_numbers(text: str, numbers: Numbers) -> str:
    """Return a text with its numbers. Raises MissingNumberError."""
    return NAME.sub(lambda match: number_text(numbers, match[1], match[2]), text)


def without_typed_numbers(text: str, name: str) -> str:
    """Return a text. Raises TypedNumberError if it contains a number that has no name."""
    if typed := re.search(r".{0,40}\d.{0,20}", UNTYPED.sub("", text)):
        raise TypedNumberError(f"{name}: a number without a name in: {typed[0]}")
    return text


def text_of(name: str) -> str:
    """Return a text of text/. Raises TypedNumberError."""
    return without_typed_numbers(
        (TEXT_FOLDER / f"{name}.md").read_text("utf-8"), name
    ).rstrip()


def points(*columns) -> list[list[float]]:
    """Return columns of a curve with CURVE_DIGITS significant digits."""
    return [
        [rounded(float(value), CURVE_DIGITS) for value in column] for column in columns
    ]


def digest(document: Any) -> str:
    """Return the digest of a document of plain values, the same on every platform."""
    text = json.dumps(document, sort_keys=True, default=str)
    return sha256(text.encode()).hexdigest()[:16]


def file_digest(path: Path) -> str:
    """Return the digest of a file."""
    return sha256(path.read_bytes()).hexdigest()[:16]


def load_numbers(path: Path = NUMBERS_FILE) -> Numbers:
    """Return the stored numbers; none if there is no file yet."""
    if not path.exists():
        return Numbers()
    stored = json.loads(path.read_text("utf-8"))
    return Numbers(
        (
            name,
            Record(
                **record
                | {
                    "numbers": {
                        key: Number(**number)
                        for key, number in record["numbers"].items()
                    }
                }
            ),
        )
        for name, record in stored.items()
    )


def save_numbers(numbers: Numbers, path: Path = NUMBERS_FILE) -> None:
    """Write the numbers, without the fields that have their default."""
    stored = {name: asdict(record) for name, record in sorted(numbers.items())}
    defaults = asdict(Number(value=0.0))
    for record in stored.values():
        record.pop("sound")
        record["numbers"] = {
            key: {
                name: rounded(value) if isinstance(value, float) else value
                for name, value in number.items()
                if name == "value" or value != defaults[name]
            }
            for key, number in sorted(record["numbers"].items())
        }
        for name in ("numbers", "curves", "words"):
            if not record[name]:
                record.pop(name) if name != "numbers" else None
    write_text(one_line_each(stored), path)


def one_line_each(stored: dict[str, dict]) -> str:
    """Return JSON with one number or curve on each line, so that a change is easy to see."""
    lines = []
    for name, record in stored.items():
        entries = []
        for key, value in record.items():
            if isinstance(value, dict):
                inner = [
                    f"   {json.dumps(k)}: {json.dumps(v)}" for k, v in value.items()
                ]
                entries.append(
                    f"  {json.dumps(key)}: {{\n" + ",\n".join(inner) + "\n  }"
                )
            else:
                entries.append(f"  {json.dumps(key)}: {json.dumps(value)}")
        lines.append(f" {json.dumps(name)}: {{\n" + ",\n".join(entries) + "\n }")
    return "{\n" + ",\n".join(lines) + "\n}\n"
