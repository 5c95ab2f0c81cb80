"""The command line: python -m sonify."""

import atexit
import errno
import gc
import os
import re
import sys
from collections.abc import Callable, Iterator
from io import TextIOWrapper
from math import inf
from shutil import get_terminal_size
from signal import SIGINT
from tempfile import gettempdir
from typing import TYPE_CHECKING, Any, NoReturn, TypeVar

import click

from sonify import __version__
from sonify.chart_command import CHART_NAMES, load_chart_files
from sonify.runtime.library_messages import hide_library_messages
from sonify.runtime.signals import AbortedError, orderly_exit

if TYPE_CHECKING:
    from sonify.sound.pressure import Dynamics

Command = TypeVar("Command", bound=Callable[..., Any])
"""Function of a command, or the command itself."""

os.environ.setdefault(
    "OPENBLAS_NUM_THREADS", "1"
)  # for small matrices more threads are slower

DISK_FULL_ERRORS = {errno.ENOSPC, errno.EDQUOT, errno.EFBIG}
ACCESS_ERRORS = {
    errno.EACCES,
    errno.EPERM,
    errno.EROFS,
    errno.EISDIR,
    errno.ENOTDIR,
    errno.ENAMETOOLONG,
    errno.ELOOP,
}
ASSIGNMENT = re.compile(r"[A-Za-z_][\w.]*\s*=")
EXPORT_FORMS: dict[str, tuple[str, ...]] = {
    "modes": ("faust", "uff", "vtu"),
    "motion": ("gltf", "parquet", "csv"),
    "sound": (),
}
"""File formats of each kind of export."""
EXPORT_OPTIONS = {
    "modes": ("--as", "--strike"),
    "motion": ("--as", "--rate"),
    "sound": ("--rate", "--takes", "--seed", "--last", "--audible"),
}
"""Options that are valid for each kind of export."""
REMOVED_OPTIONS = {
    "fit --like": "`sonify listen` determines the exponent with its interval",
    "run --animation": "report.html shows the motion; `sonify export motion --as gltf` exports it",
}
"""Replacement of each option that version 0.3 removed."""
ACCURACY_LEVELS = ("draft", "standard", "reference")


class OneLineErrorGroup(click.Group):
    """Command group that reports expected errors as one line on standard error.

    `invoke` defines the exit status.
    """

    def format_commands(
        self, context: click.Context, formatter: click.HelpFormatter
    ) -> None:
        """Write the commands with their full summaries, wrapped to the terminal."""
        summaries = [
            (name, " ".join((command.help or "").split("\n\n")[0].split()))
            for name, command in sorted(self.commands.items())
        ]
        with formatter.section("Commands"):
            formatter.write_dl(summaries)

    def main(self, *arguments: Any, **options: Any) -> Any:
        """Run the command line.

        If a process that reads the output, such as `head`, exits early, the files and
        the exit status remain the same. Bytes of file names that are not UTF-8 are
        printed as they are.
        """
        for stream in (sys.stdout, sys.stderr):
            if isinstance(stream, TextIOWrapper):
                stream.reconfigure(errors="surrogateescape")
        with orderly_exit():
            return super().main(*arguments, **options)

    def invoke(self, context: click.Context) -> Any:
        """Run the command and convert expected errors to an exit status.

        The status is 1 for a full disk or an aborted computation, 2 for invalid input
        or output, and 128 + n for signal n."""
        from sonify.runtime.files import OutputError
        from sonify.scene_errors import InputError

        try:
            return super().invoke(context)
        except (InputError, OutputError) as error:
            _exit_with_message(error, 2)
        except click.UsageError as error:
            _exit_with_message(_usage_message(error), error.exit_code)
        except AbortedError as error:
            _exit_with_message(error, 1)
        except KeyboardInterrupt as signal:
            _exit_with_message("interrupted", 128 + (signal.args or [SIGINT])[0])
        except OSError as error:
            if error.errno not in DISK_FULL_ERRORS | ACCESS_ERRORS:
                raise
            where = (
                error.filename or f"the output, or a temporary file in {gettempdir()}"
            )
            _exit_with_message(
                f"{where}: {error.strerror}",
                1 if error.errno in DISK_FULL_ERRORS else 2,
            )


class AssignmentCommand(click.Command):
    """Command that accepts several assignments after one --set: `--set a=1 b=2`."""

    def parse_args(self, context: click.Context, arguments: list[str]) -> list[str]:
        """Parse the arguments after inserting --set before each further assignment."""
        return super().parse_args(context, list(_repeat_set_option(arguments)))


def _repeat_set_option(arguments: list[str]) -> Iterator[str]:
    """Yield the arguments, with --set before each assignment that follows another
    assignment."""
    role = "other"
    for argument in arguments:
        if role == "option":
            role = "assignment"
        elif argument == "--set":
            role = "option"
        elif argument.startswith("--set="):
            role = "assignment"
        elif role == "assignment" and ASSIGNMENT.match(argument):
            yield "--set"
        else:
            role = "other"
        yield argument


class NonEmptyText(click.ParamType):  # type: ignore[type-arg]  # generic in newer versions of click alone
    """Parameter type for nonempty text.

    An empty value, e.g. from an unset shell variable, is an error and does not select
    the default."""

    def __init__(self, name: str) -> None:
        self.name = name

    def convert(
        self,
        value: Any,
        parameter: click.Parameter | None,
        context: click.Context | None,
    ) -> str:
        """Return the text. Raises InputError if it is empty."""
        from sonify.scene_errors import InputError

        if not value:
            name = parameter.opts[0] if parameter else self.name
            raise InputError(f"{name} = '': must not be empty")
        return value


PATH = NonEmptyText("path")
TEXT = NonEmptyText("text")
NUMBER = click.types.FloatParamType()
NUMBER.name = "number"
SECONDS = click.FloatRange(min=0.0)
SECONDS.name = "number"
FROM_OPTION = click.option(
    "--from",
    "begin",
    type=SECONDS,
    default=0.0,
    help="Start of the analysed part of the sound [s].",
)
TO_OPTION = click.option(
    "--to",
    "end",
    type=SECONDS,
    default=inf,
    help="End of the analysed part of the sound [s].",
)
ACCURACY_OPTION = click.option(
    "--accuracy",
    type=click.Choice(ACCURACY_LEVELS),
    help="Accuracy level; overrides the scene.",
)
SET_OPTION = click.option(
    "--set",
    "assignments",
    multiple=True,
    metavar="KEY=VALUE ...",
    help="Override values of the scene, e.g. friction.mu_static=0.3 audio.distance=1.0.",
)


def out_option(help_text: str, **attributes: Any) -> Callable[[Command], Command]:
    """Return the option --out of a command."""
    return click.option("--out", type=PATH, help=help_text, **attributes)


def _exit_with_message(message: object, status: int) -> NoReturn:
    lines = str(message).splitlines()
    line = " ".join(part.strip() for part in lines)  # names may have double spaces
    click.echo(f"sonify: {line}", err=True)
    sys.exit(status)


def _usage_message(error: click.UsageError) -> str:
    """Return the message of a usage error, with the replacement of a removed option."""
    if isinstance(error, click.NoSuchOption) and error.ctx:
        option = f"{error.ctx.info_name} {error.option_name}"
        if option in REMOVED_OPTIONS:
            return f"{option}: removed in 0.3; {REMOVED_OPTIONS[option]}"
    return error.format_message()


@click.group(
    cls=OneLineErrorGroup, context_settings={"help_option_names": ["-h", "--help"]}
)
@click.version_option(__version__, message="%(version)s")
def main() -> None:
    """Compute the motion and the sound of Euler's disk from a scene."""


@main.command(cls=AssignmentCommand)
@click.argument("scene", default="published", type=TEXT)
@out_option("Output folder; default outputs/<scene name>.")
@ACCURACY_OPTION
@SET_OPTION
@click.option(
    "--dynamics",
    type=click.Choice(["compressed", "natural"]),
    default="compressed",
    show_default=True,
    help="Dynamics of audible.wav: compressed at -18 LUFS, or natural at -23 LUFS.",
)
@click.option(
    "--findings",
    is_flag=True,
    help="Print all checks and findings instead of the answers only.",
)
@click.option(
    "--ensemble",
    type=click.IntRange(2, 10_000),
    metavar="N",
    help="Also repeat the chaotic final part of the motion N times from perturbed states.",
)
def run(
    scene: str,
    out: str | None,
    accuracy: str | None,
    assignments: tuple[str, ...],
    dynamics: "Dynamics",
    findings: bool,
    ensemble: int | None,
) -> None:
    """Simulate SCENE and write its sound, pictures and report.

    SCENE is the name of a shipped scene, a TOML file or the run.json of an earlier run;
    the default is published.
    """
    from sonify.scene import load_scene

    if ASSIGNMENT.match(scene) and not os.path.exists(scene):
        raise click.UsageError(
            f"scene = {scene!r}: not a scene; did you mean --set {scene}?"
        )
    changed = load_scene(scene).replace(*assignments)
    from sonify.console import Console

    with Console() as stages:
        from sonify.entry_points import run as solve_and_write

        result = solve_and_write(changed, out, accuracy, stages, dynamics)
        if ensemble:
            from sonify.report.write import write_ensemble

            with stages.stage("ensemble") as watch:
                repeated = write_ensemble(result, ensemble, watch)
    from sonify.report.closing_lines import closing_lines, finding_lines

    for line in repeated.lines() if ensemble else []:
        click.echo(line)
    for line in finding_lines(result) if findings else []:
        click.echo(line)
    for line in closing_lines(result):
        click.echo(line)
    sys.exit(0 if result.passed else 1)


@main.command()
@click.argument("recordings", nargs=-1, required=True, type=PATH)
@out_option(
    "Output folder, with a folder in it for each of several recordings; default "
    "outputs/listen/<name of the file>."
)
@click.option(
    "--scene",
    type=TEXT,
    help="Scene whose resonances are compared with the spectral lines (a name or a file).",
)
@FROM_OPTION
@TO_OPTION
def listen(
    recordings: tuple[str, ...],
    out: str | None,
    scene: str | None,
    begin: float,
    end: float,
) -> None:
    """Detect settling disks or coins and spectral lines in RECORDINGS.

    RECORDINGS are sound files, phyphox exports, or folders of recordings.
    """
    from sonify.console import Console

    with Console(interval=30.0, times=False) as stages:
        from sonify.runtime.imports import import_signal_without_stats

        import_signal_without_stats()
        from sonify.report.recording import write_recording_reports

        span = (begin, end)
        failures = write_recording_reports(
            recordings, out, scene, stages, span, click.echo
        )
    sys.exit(1 if failures else 0)


@main.command()
@click.argument("recordings", nargs=-1, required=True, type=PATH)
@click.option(
    "--scene",
    type=TEXT,
    help="Scene that provides radius, thickness and air (a name or a file; default granite, the toy "
    "on a slab). The sound of a given scene is simulated and compared with the recordings.",
)
@out_option("Output folder; default outputs/fit/<name of the first file>.")
@FROM_OPTION
@TO_OPTION
def fit(
    recordings: tuple[str, ...],
    scene: str | None,
    out: str | None,
    begin: float,
    end: float,
) -> None:
    """Estimate what slowed the disk in RECORDINGS.

    RECORDINGS are sound files, phyphox exports, or folders of recordings.
    """
    from sonify.console import Console

    with Console() as stages:
        from sonify.fitting.comparison import simulated_numbers
        from sonify.fitting.report import comparison_sentences, sentences, write_fits
        from sonify.fitting.result import DEFAULT_SCENE, fit

        with stages.stage("recordings") as watch:
            span = (begin, end)
            fits = fit(recordings, scene or DEFAULT_SCENE, watch, span, stages.notice)
        for one in fits.files:
            if one.truncation:
                stages.notice(f"{one.file}: {one.truncation}")
        for line in sentences(fits):
            click.echo(line)
        simulated = None
        if scene:
            with stages.stage("simulation"):
                simulated = simulated_numbers(
                    fits.scene, fits.files[0].measured["seconds"]
                )
            for line in comparison_sentences(fits, simulated):
                click.echo(line)
        click.echo(write_fits(fits, out, simulated))
    sys.exit(0 if all(one.is_input_error for one in fits.not_fitted) else 1)


@main.command()
@click.option(
    "--keys",
    is_flag=True,
    help="List every scene key with unit, range, default and meaning.",
)
@click.option(
    "--schema",
    is_flag=True,
    help="Print the JSON schema of a scene, for completion in editors.",
)
def scenes(keys: bool, schema: bool) -> None:
    """List the shipped scenes."""
    from sonify.scene import shipped_scenes
    from sonify.scene_keys import as_json, as_lines, as_table

    if schema:
        click.echo(as_json())
        return
    if keys:
        in_terminal = sys.stdout.isatty()
        click.echo(as_lines(get_terminal_size().columns) if in_terminal else as_table())
        return
    for name, summary in shipped_scenes().items():
        click.echo(f"{name:16} {summary}")


@main.command()
@click.argument("name", type=click.Choice([*CHART_NAMES, "all"]), default="all")
@click.option(
    "--quick",
    is_flag=True,
    help="Fewer settings per method; takes less than two minutes.",
)
@out_option("Output folder.", default="outputs/charts", show_default=True)
@click.option(
    "--redraw",
    is_flag=True,
    help="Redraw pictures and pages from existing tables without measuring.",
)
def chart(name: str, quick: bool, out: str | None, redraw: bool) -> None:
    """Measure the speed and accuracy of methods, and when they fail.

    A table, a picture and a page are written for each chart.
    """
    chart_files = load_chart_files()
    from sonify.console import Console

    with Console() as stages:
        for one in CHART_NAMES if name == "all" else [name]:
            page = chart_files.write_chart(
                one.replace("-", "_"), quick, out, stages, redraw
            )
            click.echo(page)


@main.command()
@click.argument("what", type=click.Choice([*EXPORT_FORMS]))
@click.argument("scene", default="published", type=TEXT)
@click.option(
    "--as",
    "form",
    type=click.Choice([form for forms in EXPORT_FORMS.values() for form in forms]),
    help="File format: faust, uff or vtu for modes; gltf, parquet or csv for motion.",
)
@click.option(
    "--strike",
    type=NUMBER,
    metavar="ANGLE",
    help="Angle of the strike in the Faust program [degrees]; default 180, opposite the patch.",
)
@click.option(
    "--rate",
    type=NUMBER,
    metavar="HZ",
    help="For a motion, frames or rows per second; default 60 for gltf, and one row per solver "
    "step for parquet and csv. For a sound, the sample rate, 48000 or 96000; default that of the "
    "scene.",
)
@click.option(
    "--takes",
    type=click.IntRange(1, 9999),
    metavar="N",
    help="Number of variations of the sound; default 1.",
)
@click.option(
    "--seed",
    type=click.IntRange(0, 10**9),
    metavar="S",
    help="Seed of the variations; default 1.",
)
@click.option(
    "--last",
    type=NUMBER,
    metavar="SECONDS",
    help="Write only the final part of each sound; default the whole sound.",
)
@click.option(
    "--audible",
    is_flag=True,
    default=None,
    help="Write the sound of audible.wav, A-weighted at -18 LUFS, instead of the pressure.",
)
@out_option(
    "Output file; default <scene name> with the suffix of the format. For sound, the output "
    "folder; default the current folder."
)
def export(
    what: str,
    scene: str,
    form: str | None,
    strike: float | None,
    rate: float | None,
    takes: int | None,
    seed: int | None,
    last: float | None,
    audible: bool | None,
    out: str | None,
) -> None:
    """Export modes, motion or sound of SCENE (default published) for other programs.

    Modes are written as a Faust program, a universal file (extra `uff`) or a ParaView
    file, a motion as an animated glTF model or as a table in Parquet or CSV format, and
    sounds as WAV files SCENE-01.wav, ... for samplers, trimmed and with loop points;
    the release and the roughness vary from file to file. SCENE is a shipped name, a
    TOML file, or the folder or run.json of an earlier run."""
    given = {"--as": form, "--strike": strike, "--rate": rate, "--takes": takes}
    given |= {"--seed": seed, "--last": last, "--audible": audible}
    _check_export_options(what, given)
    from sonify.console import Console

    with Console() as stages:
        if what == "modes":
            from sonify.export.modes import export_modes

            assert form is not None, "checked above"
            click.echo(export_modes(scene, form, out, strike))
        elif what == "motion":
            from sonify.export.motion import export_motion

            assert form is not None, "checked above"
            click.echo(export_motion(scene, form, out, rate, stages))
        else:
            from sonify.export.takes import TakeContent, export_takes

            seed = 1 if seed is None else seed
            export_takes(
                scene,
                takes or 1,
                seed,
                rate,
                out,
                stages,
                click.echo,
                TakeContent(last, bool(audible)),
            )


def _check_export_options(what: str, options: dict[str, Any]) -> None:
    """Raise UsageError for an inapplicable option, or a missing or unsuitable
    format."""
    for option, value in options.items():
        if value is not None and option not in EXPORT_OPTIONS[what]:
            raise click.UsageError(f"{option} = {value!r}: does not apply to {what}")
    form = options["--as"]
    allowed = ", ".join(EXPORT_FORMS[what])
    if allowed and form is None:
        raise click.UsageError(
            f"--as is missing: give the format of the {what}, one of {allowed}"
        )
    if form and form not in EXPORT_FORMS[what]:
        raise click.UsageError(f"--as = {form!r}: {what} can be exported as {allowed}")


@main.command()
@click.argument("folder", default="outputs", type=PATH)
@click.option(
    "--port", default=8000, show_default=True, help="Port; 0 selects a free one."
)
@click.option(
    "--host",
    type=TEXT,
    default="127.0.0.1",
    show_default=True,
    help="Address to listen on; the default accepts connections from this machine only; "
    "0.0.0.0 accepts them from other machines.",
)
def serve(folder: str, port: int, host: str) -> None:
    """Serve the finished runs in FOLDER (default outputs) to a browser, with a list and
    a comparison of two runs."""
    from sonify.studio.application import serve

    serve(
        folder,
        host,
        port,
        lambda address: click.echo(f"{address} (Ctrl-C stops the server)"),
    )


@main.command()
@click.argument("folder", default="outputs", type=PATH)
@click.option(
    "--port", default=8001, show_default=True, help="Port; 0 selects a free one."
)
def studio(folder: str, port: int) -> None:
    """Edit, run and hear scenes in a browser; runs are written into FOLDER
    (default outputs)."""
    from sonify.studio.application import studio

    studio(
        folder, port, lambda address: click.echo(f"{address} (Ctrl-C stops the studio)")
    )


@main.command()
@click.argument("sweep", type=TEXT)
@click.option(
    "--scheduler",
    type=TEXT,
    metavar="ADDRESS",
    help="Dask scheduler, e.g. tcp://10.0.0.1:8786 (extra `cluster`).",
)
@click.option(
    "--processes",
    type=click.IntRange(1),
    help="Number of local processes; default: one per core.",
)
@out_option("Output folder; default outputs/sweeps/<name>.")
@click.option(
    "--plan",
    "planned",
    is_flag=True,
    help="Print the number of runs and the estimated time, then exit.",
)
@click.option(
    "--yes", is_flag=True, help="Start even if there are more than a million runs."
)
@click.option("--retry", is_flag=True, help="Repeat runs that ended with an error.")
def sweep(
    sweep: str,
    scheduler: str | None,
    processes: int | None,
    out: str | None,
    planned: bool,
    yes: bool,
    retry: bool,
) -> None:
    """Run the scenes of SWEEP that its table lacks, and draw the table.

    SWEEP is the name of a shipped sweep or a TOML file.
    """
    from sonify.console import Console
    from sonify.sweeps.command import plan, summarize
    from sonify.sweeps.command import sweep as run_all

    with Console() as stages:
        if planned:
            click.echo("\n".join(plan(sweep, processes, stages)))
            return
        table = run_all(sweep, scheduler, out, processes, yes, retry, stages)
    line, passed = summarize(table)
    click.echo(table)
    click.echo(line)
    sys.exit(0 if passed else 1)


@main.command(cls=AssignmentCommand)
@click.argument("scene", type=TEXT)
@out_option("Output folder; default outputs/ladders/<scene name>.")
@ACCURACY_OPTION
@SET_OPTION
@click.option(
    "--plan",
    "planned",
    is_flag=True,
    help="Print the rungs and their predicted times, then exit.",
)
@click.option("--retry", is_flag=True, help="Repeat rungs that ended with an error.")
def ladder(
    scene: str,
    out: str | None,
    accuracy: str | None,
    assignments: tuple[str, ...],
    planned: bool,
    retry: bool,
) -> None:
    """Solve SCENE with every applicable model; compare answers and CPU times.

    Rungs that an earlier call has solved are not solved again. The cheapest rung with
    the answers of the most complete one is marked.
    """
    from sonify.scene import load_scene, scene_with_accuracy

    chosen = scene_with_accuracy(load_scene(scene).replace(*assignments), accuracy)
    if planned:
        from sonify.ladder.stretches import plan_lines

        click.echo("\n".join(plan_lines(chosen)))
        return
    from sonify.console import Console
    from sonify.extras import require_extra

    require_extra("a ladder", "pyarrow", "sweep")
    from sonify.ladder.command import ladder as solve_rungs

    with Console() as stages:
        solved = solve_rungs(chosen, out, retry, stages)
        from sonify.ladder.conclusions import screen_lines
        from sonify.ladder.files import write_ladder

        with stages.stage("files"):
            write_ladder(solved)
    for line in screen_lines(solved):
        click.echo(line)
    click.echo(solved.folder / "ladder.md")
    sys.exit(0 if solved.passed else 1)


@main.command("map")
@click.argument("table", type=PATH)
@click.option("--x", type=TEXT, help="Column; default: the first axis.")
@click.option(
    "--y", type=TEXT, help="Column; default: the second axis, if --x is not given."
)
@click.option(
    "--of",
    type=TEXT,
    required=True,
    help="Column to draw, e.g. t_end or outcome.",
)
@out_option("Output picture; default <of>.png in the folder of the table.")
def draw(table: str, x: str | None, y: str | None, of: str, out: str | None) -> None:
    """Draw a column of TABLE, the runs.parquet of a sweep, over one or two axes."""
    from sonify.sweeps.maps import make_map

    click.echo(make_map(table, of, x, y, out))


def start(name: str = "sonify") -> None:
    """Run the command line as a program.

    The exit skips the destruction of all objects, which takes 0.3 s. If the status
    exceeds 1, it does not wait for compiling threads either."""
    hide_library_messages()
    gc.set_threshold(50_000)  # the default collects during every import and picture
    statuses: list[int] = []
    atexit.register(_exit_with_status, statuses)  # registered first, called last
    try:
        main(prog_name=name)
    except SystemExit as end:
        if isinstance(end.code, int):
            statuses.append(end.code)
            if end.code > 1:
                _exit_with_status(statuses)
        raise


def _exit_with_status(statuses: list[int]) -> None:
    """Exit at once with the status in the list; do nothing if it is empty."""
    for status in statuses:
        sys.stdout.flush()
        sys.stderr.flush()
        os._exit(status)


if __name__ == "__main__":
    start("python -m sonify")
