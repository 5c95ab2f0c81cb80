"""Write the page of a result: a self-contained HTML file with sound, pictures, checks
and findings.
"""

from base64 import b64encode
from functools import cache
from importlib import resources
from pathlib import Path
from typing import TYPE_CHECKING, Any

from jinja2 import Environment, PackageLoader
from jinja2.utils import htmlsafe_json_dumps
from markupsafe import Markup
from tomli_w import dumps

from sonify.claims.details import expectation_and_unit, unit_and_details
from sonify.claims.finding_texts import texts_with
from sonify.claims.paper_figures import paper_rows
from sonify.claims.provenance import depends_on
from sonify.claims.reference_scenes import is_paper_scene
from sonify.claims.surface_summary import complete_answers
from sonify.report import captions
from sonify.report.headline import headline
from sonify.report.mode_names import shape_name
from sonify.report.page_data import flac_data_url, page_data
from sonify.report.plain_explanation import plain_explanation
from sonify.report.run_names import run_name
from sonify.result import output_folder
from sonify.runtime.files import atomic_write
from sonify.runtime.json_values import plain_value
from sonify.scene import scene_record

if TYPE_CHECKING:
    from sonify.result import Result


def write_page(result: "Result", path: Path, numbers: dict[str, Any]) -> None:
    """Write the page of a result with all pictures and sounds embedded.

    The page plays only the end of a long sound. `numbers` is the return value of
    `template_data`.
    """
    modes = result.modes
    held = result.scene.support.kind == "patch"
    shapes = [shape_name(modes, i, held) for i in range(len(modes))]
    text = (
        templates()
        .get_template("report.html")
        .render(
            result=result,
            name=run_name(scene_record(result.scene)).words,
            modes=[*zip(modes.frequency, modes.decay_time, shapes, strict=True)],
            headline=headline(result.findings),
            explanation=plain_explanation(result.motion, result.findings),
            answers=complete_answers(result.findings),
            paper=paper_rows(result.motion, result.findings)
            if is_paper_scene(result.scene)
            else [],
            not_from=captions.omitted_effects(result),
            scene=dumps(result.scene.document),
            command=f"python -m sonify run {result.scene.name}.toml",
            pictures=[
                (
                    data_url(output_folder(result) / name, "image/png"),
                    caption,
                    shown(result),
                )
                for name, (shown, caption) in captions.PICTURE_CAPTIONS.items()
                if (output_folder(result) / name).exists()
            ],
            **numbers,
            **page_assets(),
        )
    )
    with atomic_write(path) as temporary:
        temporary.write_bytes(text.encode("utf-8"))


def template_data(result: "Result", parts: dict[str, Any]) -> dict[str, Any]:
    """Return the `page_data` of a result as JSON, and the time [s] at which the played
    part starts."""
    data = page_data(result, parts)
    text = htmlsafe_json_dumps(data, default=plain_value)
    return {"data": text, "start": data["start"]}


def page_assets() -> dict[str, str]:
    """Return script, style and licences of the page, built from `web/`, for insertion
    in its HTML."""
    folder = resources.files("sonify.report") / "templates"
    script, style, licences = (
        (folder / file).read_text("utf-8")
        for file in ("page.js", "page.css", "page.licenses.txt")
    )
    return {
        "script": Markup(script.replace("</", "<\\/")),
        "style": Markup(style.replace("</", "<\\/")),
        "licences": licences,
    }


@cache
def templates() -> Environment:
    """Return the environment of all page templates."""
    environment = Environment(loader=PackageLoader("sonify.report"), autoescape=True)
    environment.globals.update(
        depends_on=depends_on,
        unit_and_details=unit_and_details,
        expectation_and_unit=expectation_and_unit,
        paper_sentences=texts_with("quotation"),
    )
    return environment


def summary_text(result: "Result") -> str:
    """Return a summary of a result in a few lines of text."""
    passed = sum(check.passed for check in result.checks)
    head = f"{result.scene.name}: {result.motion.outcome.sentence}"
    parts = map(repr, (result.plan, result.modes, result.motion, result.sound))
    count = f"{passed} of {len(result.checks)} self-checks passed. {headline(result.findings)}"
    return "\n".join([head, *parts, count])


def notebook_html(result: "Result") -> str:
    """Return a result as an HTML fragment: a sound player and the verdict on each
    claim."""
    # Largest sound embedded in the notebook view of a result [characters of base64]
    max_notebook_sound = 200_000
    template = templates().get_template("notebook.html")
    sound = result.sound
    seconds = sound.duration
    audible = flac_data_url(sound.audible)
    while len(audible) > max_notebook_sound:
        seconds *= 0.95 * max_notebook_sound / len(audible)
        audible = flac_data_url(sound.audible, sound.duration - seconds)
    return template.render(
        result=result,
        audible=audible,
        seconds=seconds,
        words=summary_text(result),
    )


def data_url(path: Path, kind: str) -> str:
    """Return a file as a data URL."""
    return f"data:{kind};base64,{b64encode(path.read_bytes()).decode()}"
