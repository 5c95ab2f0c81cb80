"""The command line: python -m sonify."""

import errno
import os
import re
import sys
from math import inf
from shutil import get_terminal_size
from signal import SIGINT
from tempfile import gettempdir

import click

from sonify import __version__
from sonify.chart_command import CHART_NAMES, load_chart_files
from sonify.runtime.signals import BrokenOffError, well_behaved

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # for small matrices more threads are slower

FULL = {errno.ENOSPC, errno.EDQUOT, errno.EFBIG}
REFUSED = {
    errno.EACCES,
    errno.EPERM,
    errno.EROFS,
    errno.EISDIR,
    errno.ENOTDIR,
    errno.ENAMETOOLONG,
    errno.ELOOP,
}
ASSIGNMENT = re.compile(r"[A-Za-z_][\w.]*\s*=")
ACCURACIES = ("draft", "standard", "reference")


class FullHelp(click.Group):
    """Command group that lists every command with its full summary, wrapped to the terminal."""

    def format_commands(self, context, formatter):
        """Write the commands with their full summaries."""
        commands = {name: self.get_command(context, name) for name in self.list_commands(context)}
        summaries = [(name, " ".join(one.help.split())) for name, one in commands.items()]
        with formatter.section("Commands"):
            formatter.write_dl(summaries)


class OneLine(FullHelp):
    """Command group that reports expected errors as one line on standard error.

    `invoke` defines the exit status.
    """

    def main(self, *arguments, **options):
        """Run the command line.

        A reader that exits early, such as `head`, changes neither the files nor the exit status.
        """
        with well_behaved():
            return super().main(*arguments, **options)

    def invoke(self, context):
        """Run the command and convert expected errors to an exit status.

        1: full disk, or work broken off; 2: invalid input or output; 128 + n: signal n.
        """
        from sonify.runtime.files import OutputError
        from sonify.scene_errors import InputError

        try:
            return super().invoke(context)
        except (InputError, OutputError) as error:
            _stop(error, 2)
        except click.UsageError as error:
            _stop(error.format_message(), error.exit_code)
        except BrokenOffError as error:
            _stop(error, 1)
        except KeyboardInterrupt as signal:
            _stop("interrupted", 128 + (signal.args or [SIGINT])[0])
        except OSError as error:
            if error.errno not in FULL | REFUSED:
                raise
            where = error.filename or f"the output, or a temporary file in {gettempdir()}"
            _stop(f"{where}: {error.strerror}", 1 if error.errno in FULL else 2)


class WithAssignments(click.Command):
    """Command that accepts several assignments after one --set, as in `--set a=1 b=2`."""

    def parse_args(self, context, arguments):
        """Parse the arguments after inserting --set before each further assignment."""
        return super().parse_args(context, list(_set_before_each(arguments)))


def _set_before_each(arguments):
    """Yield the arguments, with --set before each assignment that follows another assignment."""
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


class Given(click.ParamType):
    """Parameter type for text that must not be empty.

    An empty value, e.g. from an unset shell variable, does not select the default.
    """

    def __init__(self, name):
        self.name = name

    def convert(self, value, parameter, context):
        """Return the text. Raises InputError if it is empty."""
        from sonify.scene_errors import InputError

        if not value:
            raise InputError(f"{parameter.opts[0]} = '': must not be empty")
        return value


PATH, TEXT = Given("path"), Given("text")
SECONDS = click.FloatRange(min=0.0)
FROM_OPTION = click.option(
    "--from", "begin", type=SECONDS, default=0.0, help="Analyse the sound from this time on [s]."
)
TO_OPTION = click.option(
    "--to", "end", type=SECONDS, default=inf, help="Analyse the sound up to this time [s]."
)


def _stop(message, status):
    click.echo(f"sonify: {' '.join(str(message).split())}", err=True)
    sys.exit(status)


@click.group(cls=OneLine, context_settings={"help_option_names": ["-h", "--help"]})
@click.version_option(__version__, message="%(version)s")
def main():
    """Euler's disk, heard: from a scene to its sound."""


@main.command(cls=WithAssignments)
@click.argument("scene", default="published", type=TEXT)
@click.option("--out", type=PATH, help="Folder for the files; default outputs/<scene name>.")
@click.option("--accuracy", type=click.Choice(ACCURACIES), help="Instead of the scene's.")
@click.option(
    "--set",
    "assignments",
    multiple=True,
    metavar="KEY=VALUE ...",
    help="Replace values, as friction.mu_static=0.3 audio.distance=1.0.",
)
@click.option(
    "--animation", is_flag=True, help="Film the last seconds, too (needs the extra `animation`)."
)
def run(scene, out, accuracy, assignments, animation):
    """Solve SCENE, a shipped name, a TOML file or the run.json of a run; write sound, pictures and
    report."""
    from sonify.scene import load_scene

    if ASSIGNMENT.match(scene) and not os.path.exists(scene):
        raise click.UsageError(f"scene = {scene!r}: no scene; write --set {scene}")
    scene = load_scene(scene).replace(*assignments)
    if animation:
        from sonify.report.animation import animate, require_encoder

        require_encoder()
    from sonify.console import Console

    with Console() as stages:
        from sonify.entry_points import run as solve

        result = solve(scene, out, accuracy, stages)
        if animation:
            with stages.stage("animation") as watch:
                animate(result, watch)
    from sonify.claims.surface_summary import ANSWERS, in_short

    for name in ("sound.wav", "spectrogram.png", "report.html"):
        click.echo(str(result.out / name))
    answers = in_short(result.findings)
    for question in ANSWERS:
        click.echo(f"{question}: {answers.get(question, 'not judged in this run')}")
    sys.exit(0 if result.passed else 1)


@main.command()
@click.argument("recording", type=PATH)
@click.option(
    "--out",
    type=PATH,
    help="Folder for picture and numbers; default outputs/listen/<name of the file>.",
)
@click.option(
    "--scene", type=TEXT, help="Whose resonances the carriers are matched to: a name or a file."
)
@FROM_OPTION
@TO_OPTION
def listen(recording, out, scene, begin, end):
    """Find disks and coins that come to rest, and the spectral lines, in RECORDING, a sound file of
    your own."""
    from sonify.report.recording import tell

    def warn(line):
        click.echo(line, err=True)

    for line in tell(recording, out, scene, warn, (begin, end)):
        click.echo(line)


@main.command()
@click.argument("recordings", nargs=-1, required=True, type=PATH)
@click.option(
    "--scene",
    type=TEXT,
    default="toy",
    show_default=True,
    help="Whose radius, thickness and air: a name or a file.",
)
@click.option(
    "--out", type=PATH, help="Folder for the files; default outputs/fit/<name of the first file>."
)
@click.option(
    "--like", type=click.Choice(["fu-berlin"]), help="Also the exponents of a published chain."
)
@FROM_OPTION
@TO_OPTION
def fit(recordings, scene, out, like, begin, end):
    """Find what slowed the disk in RECORDINGS: sound files, exports of phyphox, or folders of
    takes."""
    from sonify.console import Console

    with Console() as stages:
        from sonify.fitting.report import sentences, write_fits
        from sonify.fitting.result import fit

        with stages.stage("recordings") as watch:
            fits = fit(recordings, scene, like, watch, (begin, end))
        for one in fits.files:
            if one.truncation:
                stages.notice(f"{one.file}: {one.truncation}")
        for line in sentences(fits):
            click.echo(line)
        click.echo(str(write_fits(fits, out)))


@main.command()
@click.option(
    "--keys", is_flag=True, help="List every key of a scene instead: unit, range, default, meaning."
)
@click.option(
    "--schema",
    is_flag=True,
    help="Print the JSON schema of a scene instead, for editors that complete.",
)
def scenes(keys, schema):
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
@click.option("--quick", is_flag=True, help="Fewer settings of every method, in under two minutes.")
@click.option(
    "--out", type=PATH, default="outputs/charts", show_default=True, help="Folder for the files."
)
@click.option(
    "--redraw",
    is_flag=True,
    help="Measure nothing: make pictures and pages from the tables in the folder.",
)
def chart(name, quick, out, redraw):
    """Measure speed against accuracy, and where methods fail; write a table, a picture and a
    page."""
    chart_files = load_chart_files()
    from sonify.console import Console

    with Console() as stages:
        for one in CHART_NAMES if name == "all" else [name]:
            page = chart_files.write_chart(one.replace("-", "_"), quick, out, stages, redraw)
            click.echo(page)


@main.command()
@click.argument("what", type=click.Choice(["modes"]))
@click.argument("scene", default="published", type=TEXT)
@click.option(
    "--as", "form", type=click.Choice(["faust", "uff", "vtu"]), required=True, help="Kind of file."
)
@click.option(
    "--strike",
    type=float,
    metavar="ANGLE",
    help="Where Faust strikes [degrees]; default: opposite, 180.",
)
@click.option(
    "--out", type=PATH, help="The file; default <scene name> with the suffix of its kind."
)
def export(what, scene, form, strike, out):
    """Write the modes of SCENE for Faust, for modal analysis (universal file, extra `uff`) or for
    ParaView."""
    from sonify.export import export_modes

    click.echo(str(export_modes(scene, form, out, strike)))


@main.command()
@click.argument("folder", default="outputs", type=PATH)
@click.option("--port", default=8000, show_default=True, help="Port; 0 is any that is free.")
@click.option(
    "--host",
    default="127.0.0.1",
    show_default=True,
    help="Address to listen on; by default this machine alone.",
)
def serve(folder, port, host):
    """Show the finished runs in FOLDER in a browser: a list, the page of each, two of them side by
    side."""
    from sonify.serve import serve

    serve(folder, host, port, lambda address: click.echo(f"{address} (Ctrl-C ends it)"))


@main.command()
@click.argument("sweep", type=TEXT)
@click.option(
    "--scheduler",
    type=TEXT,
    metavar="ADDRESS",
    help="Of Dask, as tcp://10.0.0.1:8786, or local (extra `cluster`).",
)
@click.option(
    "--processes", type=click.IntRange(1), help="Processes of this machine; default: its cores."
)
@click.option("--out", type=PATH, help="Folder for the table; default outputs/sweeps/<name>.")
@click.option(
    "--plan",
    "planned",
    is_flag=True,
    help="Only tell how many runs there are and how long they would take.",
)
@click.option("--yes", is_flag=True, help="Begin even more than a million runs.")
@click.option("--retry", is_flag=True, help="Solve runs with an error again.")
def sweep(sweep, scheduler, processes, out, planned, yes, retry):
    """Run the scenes of SWEEP, a shipped name or a TOML file, of which a table has no row yet; draw
    the table."""
    from sonify.console import Console
    from sonify.sweeps.command import plan, says
    from sonify.sweeps.command import sweep as run_all

    if planned:
        with Console() as stages:
            lines = plan(sweep, processes, stages)
        click.echo("\n".join(lines))
        return
    with Console() as stages:
        table = run_all(sweep, scheduler, out, processes, yes, retry, stages)
    click.echo(str(table))
    lines, passed = says(table)
    for line in lines:
        click.echo(line)
    sys.exit(0 if passed else 1)


@main.command("map")
@click.argument("table", type=PATH)
@click.option("--x", type=TEXT, help="Column; default: the first axis.")
@click.option("--y", type=TEXT, help="Column; default: the second axis, if --x is not given.")
@click.option(
    "--of",
    type=TEXT,
    required=True,
    help="Column of which a picture is drawn, as t_end or outcome.",
)
@click.option("--out", type=PATH, help="The picture; default <of>.png beside the table.")
def draw(table, x, y, of, out):
    """Draw a column of TABLE, the runs.parquet of a sweep, over one or two of its axes."""
    from sonify.sweeps.maps import make_map

    click.echo(str(make_map(table, of, x, y, out)))


def start(name="sonify"):
    """Run the command line as a program.

    If the exit status exceeds 1, exit without waiting for threads that still compile.
    """
    try:
        main(prog_name=name)
    except SystemExit as end:
        if isinstance(end.code, int) and end.code > 1:
            sys.stdout.flush()
            sys.stderr.flush()
            os._exit(end.code)
        raise


if __name__ == "__main__":
    start("python -m sonify")
