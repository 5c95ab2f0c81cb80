"""NUMBERS -> TABLES: the tables of the pages and of the article, in Markdown."""

from collections.abc import Callable
from dataclasses import dataclass
from functools import cache
from typing import Any

from article_numbers import (
    ROOT,
    Numbers,
    percent,
    references,
    text_of,
    with_numbers,
    with_powers,
)

from sonify.runtime.toml_files import read_toml
from sonify.scene import shipped_scenes
from sonify.scene_errors import InputError
from sonify.sweeps.sweep import SHIPPED_SWEEPS_FOLDER
from sonify.sweeps.verdict import OUTCOME_WORDS, PAPER_CLAIM_NUMBERS, claim_head


@dataclass(frozen=True, kw_only=True)
class Table:
    """A table: its subject, its caption in the article, and the function that makes it."""

    subject: str
    caption: str
    markdown: Callable[[Numbers], str]


def rows_as_markdown(
    header: list[str], rows: list[list[str]], widths: list[int]
) -> str:
    """Return a Markdown table; the widths of the columns are relative."""
    lines = [f"| {' | '.join(cells)} |" for cells in (header, *rows)]
    lines.insert(1, "|" + "|".join("-" * width for width in widths) + "|")
    return "\n".join(lines)


LAWS = (
    (
        "k2",
        "Kessler & O'Reilly",
        "arms $k_2$, $k_3$ of the resisting moments",
        r"$\Omega\beta$",
        "$1$",
    ),
    ("contour", "Leine", "contour friction", r"$\Omega$", "$1/3$"),
    ("mcdonald", "McDonald & McDonald", "fitted power", r"$\Omega^{5/2}$", "$2/9$"),
    ("bildsten", "Bildsten", "boundary layers of the air", r"$\Omega^{5/2}$", "$2/9$"),
    ("moffatt", "Moffatt", "viscous film of air", r"$\Omega^4$", "$1/6$"),
    (
        "impacts_0",
        "this work",
        "impacts on unevenness, $H_s = 0$",
        r"$\Omega^0$",
        "$1/2$",
    ),
    ("impacts_0.5", "this work", "impacts, $H_s = 1/2$", "", "$3/7$"),
    ("impacts_1", "this work", "impacts, $H_s = 1$", "", "$1/3$"),
)
CITATION_OF_LAW = {
    "k2": "kessler2002",
    "contour": "leine2009",
    "mcdonald": "mcdonald2000",
    "bildsten": "bildsten2002",
    "moffatt": "moffatt2000",
}


def decay_laws(numbers: Numbers) -> str:
    """Return the exponents of the precession rate for each law."""
    rows = []
    for key, author, what, power, exponent in LAWS:
        number = numbers.number(f"laws.{key}")
        cited = f" [@{CITATION_OF_LAW[key]}]" if key in CITATION_OF_LAW else ""
        rows.append([author + cited, what, power, exponent, f"{number.value:.3f}"])
    for scene, what in (
        ("thorne", "scene `thorne` without air: contour friction and pivoting"),
        ("granite", "scene `granite` without air: the same causes"),
        ("published", "scene `published`: all resisting moments of the paper"),
    ):
        number = numbers.number(f"{scene}.friction_exponent")
        rows.append(["this work", what, "", "", f"{number.value:.3f}"])
    header = [
        "author",
        "cause that slows the disk",
        "$P \\sim$",
        "$n$, formula",
        "$n$, program",
    ]
    return rows_as_markdown(header, rows, [24, 40, 10, 12, 12])


SHARED_CLAIMS = (
    "contact_kept",
    "table_breaks_contact",
    "contact_is_lost",
    "disk_rattles",
    "vibration_opens_contact",
    "impacts_end_it",
    "halt_comes_earlier",
    "waves_make_the_halt",
    "carried_by_air",
    "what_ends",
    "no_singularity",
    "repeated_slips",
    "slip_is_the_loss",
    "impacts_are_not_the_loss",
    "pitch_rises",
    "table_tone_rises",
    "carrier_rises",
    "carrier_is_contact",
    "table_is_louder",
    "table_carries_the_tone",
    "free_modes_are_heard",
    "tone_is_precession",
    "force_peaks_sound",
    "deformation_makes_the_tone",
)
"""Claims of the table of shares, in its order."""


def sweep_names(numbers: Numbers) -> list[str]:
    """Return the sweeps in numbers.json, those of random draws first."""
    names = [
        name.removeprefix("sweep-") for name in numbers if name.startswith("sweep-")
    ]
    return sorted(names, key=lambda name: (not is_random(name), name))


def is_random(name: str) -> bool:
    """Return True if the points of a sweep are drawn, False if they form a grid."""
    return "samples" in sweep_document(name)


@cache
def sweep_document(name: str) -> dict[str, Any]:
    """Return the document of a shipped sweep."""
    return read_toml(SHIPPED_SWEEPS_FOLDER / f"{name}.toml", InputError)


CLAIM_WORDS = {
    "what_ends": "One cause takes most of the last tenth of the energy",
    "carried_by_air": "The air lifts the disk at the end, or would lift it if it were included",
}
"""Claims whose words depend on the run -> general words."""


def claim_in_words(numbers: Numbers, key: str) -> str:
    """Return the claim of a finding."""
    if key in CLAIM_WORDS:
        return CLAIM_WORDS[key]
    for record in numbers.values():
        if f"claim.{key}" in record.words:
            return record.words[f"claim.{key}"]
    return key.replace("_", " ")


VERDICT_PREFIX = "verdict-"


def subject_of_sweep(name: str) -> str:
    """Return disk and surface of a sweep, from the first line of its file."""
    first = (
        (SHIPPED_SWEEPS_FOLDER / f"{name}.toml").read_text("utf-8").partition("\n")[0]
    )
    subject = first.removeprefix("# Claims of the paper on ").partition(":")[0]
    return subject.replace("its disk", "the disk of the paper")


def verdicts(numbers: Numbers) -> str:
    """Return the verdict on each surface and each claim of the paper that is judged on one
    of them; docs/verdict.md has the others."""
    words = {
        name: numbers[f"sweep-{name}"].words
        for name in sweep_names(numbers)
        if name.startswith(VERDICT_PREFIX)
    }
    if not words:
        return ""
    keys = [
        key
        for key, number in PAPER_CLAIM_NUMBERS.items()
        if (number or key == "contact_breaks_before_end")
        and any(f"verdict.{key}" in found for found in words.values())
    ]
    rows = []
    for name, found in words.items():
        cells = [with_powers(found.get(f"verdict.{key}", "")) or "-" for key in keys]
        rows.append([f"{subject_of_sweep(name)} (`{name}`)", *cells])
    header = ["disk and surface", *map(claim_head, keys)]
    return rows_as_markdown(header, rows, [20, *(14 for _ in keys)])


def shares(numbers: Numbers) -> str:
    """Return the share of the runs of each other sweep in which a claim holds."""
    rows = []
    for key in SHARED_CLAIMS:
        cells = []
        for name in sweep_names(numbers):
            record = numbers[f"sweep-{name}"]
            number = record.numbers.get(f"holds.{key}")
            if number is None or name.startswith(VERDICT_PREFIX):
                continue
            undecided = record.numbers[f"undecided.{key}"].value
            share = f"{percent(number.value)} % {number.unit}"
            cells.append(
                f"`{name}` {share}"
                + (f", {undecided:.0f} undecided" if undecided else "")
            )
        if cells:
            rows.append([claim_in_words(numbers, key), "; ".join(cells)])
    return rows_as_markdown(
        ["claim", "share of the runs in which it holds"], rows, [44, 56]
    )


def short_number(value: float) -> str:
    """Return a number with at most four digits, with an exponent below 0.001."""
    if value == 0 or abs(value) >= 1e-3:
        return f"{value:.4g}"
    mantissa, exponent = f"{value:.3e}".split("e")
    return f"{float(mantissa):g}e{exponent}"


def range_in_words(given: Any) -> str:
    """Return the range of an axis of a sweep file."""
    if isinstance(given, list):
        return (
            ", ".join(map(str, given))
            if len(given) <= 4
            else f"{given[0]} to {given[-1]}, {len(given)} values"
        )
    first, last = given["from"], given["to"]
    if isinstance(first, list):
        return "; ".join(
            f"{short_number(low)} to {short_number(high)}"
            for low, high in zip(first, last, strict=True)
        )
    return f"{short_number(first)} to {short_number(last)}" + (
        ", log" if given.get("scale") == "log" else ""
    )


def ranges(numbers: Numbers) -> str:
    """Return the range of each varied quantity, once for all sweeps that share it."""
    merged: dict[tuple[str, str, str], list[str]] = {}
    for name in sweep_names(numbers):
        document = sweep_document(name)
        given = document.get("sources", {})
        for key, axis in document["axes"].items():
            row = (key, range_in_words(axis), given.get(key, "chosen for this sweep"))
            merged.setdefault(row, []).append(name.removeprefix(VERDICT_PREFIX))
    rows = [
        [
            f"`{key}`",
            with_powers(words),
            basis,
            ", ".join(f"`{name}`" for name in names),
        ]
        for (key, words, basis), names in sorted(merged.items())
    ]
    return rows_as_markdown(
        ["quantity", "range", "basis", "sweeps"], rows, [23, 22, 36, 23]
    )


def reference_list(numbers: Numbers) -> str:
    """Return all references as a list."""
    return "\n".join(
        f"{k}. {full_reference(key)}" for k, key in enumerate(references(), 1)
    )


def recordings(numbers: Numbers) -> str:
    """Return what the detector measured in recordings."""
    record = numbers["recordings"]
    rows = []
    for key in sorted({name.partition(".")[0] for name in record.numbers}):
        exponent = record.numbers[f"{key}.exponent"]
        shown = f"{exponent.low:.2f} to {exponent.high:.2f}"
        if (
            exponent.value == exponent.value
            and f"{key}.undetermined" not in record.words
        ):
            shown = f"{exponent.value:.2f} ({shown})"
        else:
            shown = f"not determined ({shown})"
        rate = record.numbers[f"{key}.rate"]
        score = record.numbers[f"{key}.score"]
        rows.append(
            [
                record.words[key],
                shown,
                f"{rate.value:.1f} ({rate.low:.1f} to {rate.high:.1f})",
                f"{score.value:.0f}",
            ]
        )
    header = [
        "take",
        "$n$ (95 %)",
        "bursts per second, 1 s before the end (or at the start)",
        "score",
    ]
    return rows_as_markdown(header, rows, [40, 26, 26, 8])


def gallery(numbers: Numbers) -> str:
    """Return what every scene is, how it ends, and its sound."""
    rows = []
    for name, sentence in shipped_scenes().items():
        record = numbers[name]
        outcome = record.words["outcome"]
        words = OUTCOME_WORDS.get(outcome, outcome)
        end = f"{words} after {record.numbers['t_end'].value:.2f} s"
        file = f"outputs/shown/{name}/last_seconds.flac"
        sound = f"[listen](../{file})" if (ROOT / file).is_file() else "-"
        rows.append([f"`{name}`", sentence, end, sound])
    return rows_as_markdown(
        ["scene", "description", "end", "sound"], rows, [16, 60, 20, 10]
    )


def radiation(numbers: Numbers) -> str:
    """Return the excess of the radiation model [dB] by inclination and wavenumber."""
    inclinations, wavenumbers, excess = numbers.curve("radiation.excess")
    shown = sorted(set(wavenumbers))
    at = dict(zip(zip(inclinations, wavenumbers, strict=True), excess, strict=True))
    rows = [
        [f"{beta:g}", *(with_powers(f"{at[beta, k]:.1f}") for k in shown)]
        for beta in sorted(set(inclinations))
    ]
    header = ["inclination [rad]", *(f"$kR = {k:g}$" for k in shown)]
    return rows_as_markdown(header, rows, [20] + len(shown) * [8])


TABLES = {
    "decay_laws": Table(
        subject="decay laws",
        caption="Exponent of the precession rate as a power of the remaining time.",
        markdown=decay_laws,
    ),
    "verdicts": Table(
        subject="verdicts",
        caption="Verdict on each claim over stated ranges: the same in all draws, or the value at which "
        "it changes, with its 95 % interval.",
        markdown=verdicts,
    ),
    "shares": Table(
        subject="shares",
        caption="Share of the runs of the other sweeps in which each claim holds.",
        markdown=shares,
    ),
    "ranges": Table(subject="ranges", caption="Ranges of the sweeps.", markdown=ranges),
    "recordings": Table(
        subject="recordings",
        caption="Coins that `sonify listen` detects in recordings.",
        markdown=recordings,
    ),
    "references": Table(
        subject="references", caption="References.", markdown=reference_list
    ),
    "limits": Table(
        subject="limits",
        caption="Limits of the models.",
        markdown=lambda numbers: with_numbers(text_of("limits"), numbers),
    ),
    "radiation": Table(
        subject="radiation",
        caption="Excess of the radiation model over finite elements [dB].",
        markdown=radiation,
    ),
    "gallery": Table(subject="scenes", caption="The scenes.", markdown=gallery),
}
"""Tables by name."""


def full_reference(key: str) -> str:
    """Return a reference in Markdown."""
    entry = references()[key]
    where = [entry.get(field) for field in ("journal", "volume", "pages", "publisher")]
    doi = (
        f"[doi:{entry['doi']}](https://doi.org/{entry['doi']})"
        if "doi" in entry
        else None
    )
    shown = ", ".join(str(value) for value in (*where, doi) if value)
    return (
        f"{'; '.join(entry['author'])} ({entry['year']}). *{entry['title']}*. {shown}."
    )


def curved_quotes(text: str) -> str:
    """Return a text with the apostrophes of printed English."""
    return text.replace("'", "\N{RIGHT SINGLE QUOTATION MARK}")


def hayagriva() -> dict[str, dict[str, Any]]:
    """Return the references in the format of the bibliography of Typst."""
    found = {}
    for key, entry in references().items():
        found[key] = {
            "type": entry["type"],
            "title": {"value": curved_quotes(entry["title"]), "verbatim": True},
            "author": [curved_quotes(name) for name in entry["author"]],
            "date": entry["year"],
        }
        if "pages" in entry:
            found[key]["page-range"] = entry["pages"]
        if "publisher" in entry:
            found[key]["publisher"] = entry["publisher"]
        if "doi" in entry:
            found[key]["serial-number"] = {"doi": entry["doi"]}
        if "journal" in entry:
            found[key]["parent"] = {
                "type": "periodical",
                "title": f"{{{entry['journal']}}}",
            }
            found[key]["parent"] |= (
                {"volume": entry["volume"]} if "volume" in entry else {}
            )
    return found
