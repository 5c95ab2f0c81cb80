"""Claim: the packages keep their order of imports, the oracles are independent of the code that
they test, and start-up loads nothing heavy.

Source: the source tree: scene -> motion -> modes -> force -> sound -> findings. Oracle: the import
statements of every file; the modules loaded by a fresh interpreter.
"""

import ast
import re
import subprocess
import sys
import zipfile
from importlib.util import find_spec

import pytest
from importlinter.cli import lint_imports
from paths import ROOT

import dynamics
import modal
import sonify

PACKAGES = ("dynamics", "modal", "sonify")
"""The packages of the wheel."""
FILES = sorted(
    f for package in (*PACKAGES, "benchmarks") for f in (ROOT / package).rglob("*.py")
)


def is_for_types(node):
    """Return True for `if TYPE_CHECKING:`, whose imports only type checkers see."""
    return isinstance(node, ast.If) and ast.unparse(node.test) == "TYPE_CHECKING"


def imported(file):
    """Return the names of the modules that a file imports, with relative imports made absolute."""
    package = file.relative_to(ROOT).parts[0]
    names = set()
    tree = ast.parse(file.read_text("utf-8"))
    tree.body = [node for node in tree.body if not is_for_types(node)]
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            names |= {alias.name for alias in node.names}
        elif isinstance(node, ast.ImportFrom):
            base = (
                f"{package}.{node.module or ''}".rstrip(".")
                if node.level
                else node.module
            )
            names |= {base} | {f"{base}.{alias.name}" for alias in node.names}
    return names


@pytest.mark.parametrize("file", FILES, ids=lambda f: str(f.relative_to(ROOT)))
def test_only_pictures_import_matplotlib(file):
    if any(name.split(".")[0] == "matplotlib" for name in imported(file)):
        drawing = {("sonify", "report"), ("benchmarks", "charts")}
        assert file.stem == "plotting" or file.relative_to(ROOT).parts[:2] in drawing


@pytest.mark.parametrize("name", ["exact_motion", "plate_theory"])
def test_closed_forms_do_not_use_what_they_judge(name):
    tops = {
        used.split(".")[0] for used in imported(ROOT / "tests/helpers" / f"{name}.py")
    }
    assert not tops & {*PACKAGES, "benchmarks"}


def test_no_code_asks_what_kind_of_thing_it_has():
    """A default for a missing attribute hides misspelt names; scenes and motions have them all."""
    questions = re.compile(
        r"hasattr\(|getattr\((scene|motion)\b|SimpleNamespace|__dict__ \|="
    )
    found = [
        f"{file.relative_to(ROOT)}:{number}"
        for file in FILES
        for number, line in enumerate(file.read_text("utf-8").splitlines(), 1)
        if questions.search(line)
    ]
    assert found == []


def calls_of(name, files):
    """Yield file, line and arguments of each call of a builtin."""
    for file in files:
        for node in ast.walk(ast.parse(file.read_text("utf-8"))):
            if isinstance(node, ast.Call) and ast.unparse(node.func) == name:
                arguments = [ast.unparse(argument) for argument in node.args]
                yield file.relative_to(ROOT), node.lineno, arguments


def test_no_code_outside_dynamics_asks_which_motion_it_has():
    """What differs between motions are methods of `Motion`, and what is decided is in its plan."""
    files = [f for f in FILES if f.relative_to(ROOT).parts[0] != "dynamics"]
    files += sorted((ROOT / "docs").rglob("*.py"))
    asked = re.compile(r"\b\w*Motion\b")
    found = [
        f"{file}:{line}"
        for file, line, (thing, kinds, *_) in calls_of("isinstance", files)
        if asked.search(kinds) or re.search(r"\bmotion$", thing)
    ]
    assert found == []


@pytest.mark.parametrize("name", ["decide_film", "choose_contact_model"])
def test_models_are_decided_at_one_place(name):
    places = [str(file) for file, *_ in calls_of(name, FILES)]
    assert places == ["dynamics/motion_plan.py"]


def test_every_import_keeps_the_contracts():
    """The contracts in pyproject.toml fix the order of packages and stages, and forbid cycles."""
    assert lint_imports(str(ROOT / "pyproject.toml"), no_cache=True) == 0


def run_code(code):
    """Run code in a new process of Python, from the folder of the checkout."""
    return subprocess.run(
        [sys.executable, "-c", code],
        capture_output=True,
        text=True,
        cwd=ROOT,
        check=True,
    )


@pytest.mark.parametrize("command", [["--help"], ["run", "--help"]])
def test_help_loads_nothing_heavy(command):
    code = (
        f"import sys; sys.argv = ['sonify', *{command!r}]\n"
        "import runpy\n"
        "try: runpy.run_module('sonify', run_name='__main__')\n"
        "except SystemExit: pass\n"
        "heavy = {'numpy', 'scipy', 'matplotlib', 'numba', 'heyoka', 'skfem', 'pydantic', "
        "'soundfile', 'meshio'}\n"
        "print(sorted(heavy & set(sys.modules)), file=sys.stderr)"
    )
    done = run_code(code)
    assert done.stderr.strip().splitlines()[-1] == "[]"
    assert done.stdout


@pytest.mark.skipif(
    not find_spec("heyoka"), reason="heyoka, which compiles them, is not installed"
)
def test_flows_are_compiled_before_anything_heavy_is_loaded():
    """The compiler releases Python's global lock, so that it runs in parallel with the imports."""
    code = (
        "import sys; from sonify.entry_points import begin_run; begin_run('published', None)\n"
        "print(sorted({'scipy', 'matplotlib', 'numba', 'skfem', 'soundfile', 'meshio'} & "
        "set(sys.modules)))\n"
        "import os; sys.stdout.flush(); os._exit(0)"
    )
    done = run_code(code)
    assert done.stdout.strip() == "[]"


@pytest.mark.parametrize(
    "package", [dynamics, modal, sonify], ids=lambda package: package.__name__
)
def test_what_a_package_offers_is_listed_and_typed(package):
    """Completion and type checkers see the names that are imported on first use."""
    stub = ast.parse((ROOT / package.__name__ / "__init__.pyi").read_text("utf-8"))
    listed = {
        alias.asname
        for node in stub.body
        if isinstance(node, ast.ImportFrom)
        for alias in node.names
    }
    assert listed == set(dir(package)) == set(package.__all__)
    assert (ROOT / package.__name__ / "py.typed").exists()


@pytest.mark.slow
def test_a_wheel_holds_every_file_of_the_packages_and_runs(tmp_path):
    call = [
        sys.executable,
        "-m",
        "pip",
        "wheel",
        "--quiet",
        "--no-deps",
        "-w",
        str(tmp_path),
        str(ROOT),
    ]
    subprocess.run(call, check=True)
    with zipfile.ZipFile(next(tmp_path.glob("*.whl"))) as wheel:
        wheel.extractall(tmp_path / "unpacked")
    tracked = subprocess.run(
        ["git", "ls-files", *PACKAGES],
        cwd=ROOT,
        capture_output=True,
        text=True,
        check=True,
    ).stdout.split()
    assert [
        name for name in tracked if not (tmp_path / "unpacked" / name).is_file()
    ] == []
    assert not (tmp_path / "unpacked" / "benchmarks").exists()
    code = "import sonify, dynamics, modal; print(sonify.__file__); sonify.load_scene(); dynamics.Disk; modal.Modes"
    ran = subprocess.run(
        [sys.executable, "-c", code],
        cwd=tmp_path / "unpacked",
        capture_output=True,
        text=True,
        check=True,
    )
    assert ran.stdout.startswith(str(tmp_path))
