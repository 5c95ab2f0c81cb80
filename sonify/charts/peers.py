"""The physics engines beside us: which runs they make, where they are installed."""

from importlib import import_module
from importlib.util import find_spec

from sonify.charts.motion_case import Case
from sonify.charts.records import LEFT_OUT, Answer, Failure

ENGINES = {"mujoco": "MuJoCo", "pydrake": "Drake", "pybullet": "PyBullet"}
"""Name by package."""
RUNS = {
    "MuJoCo, Euler": ("mujoco", "peer_mujoco", "mujoco", ("Euler",), (1e-2, 1e-3, 1e-4)),
    "MuJoCo, RK4": ("mujoco", "peer_mujoco", "mujoco", ("RK4",), (1e-2, 1e-3)),
    "Drake, TAMSI": ("pydrake", "peer_drake", "drake", ("Tamsi",), (1e-2, 1e-3)),
    "Drake, SAP": ("pydrake", "peer_drake", "drake", ("Sap",), (1e-2, 1e-3)),
    "PyBullet": ("pybullet", "peer_bullet", "bullet", (), (1e-2, 1e-3, 1e-4)),
}
"""Method: package, module, function and its first arguments, steps."""
WITHOUT_MOMENTS = {
    "Drake, RK3": ("pydrake", "peer_drake", "continuous", (), (1e-2, 1e-3, 1e-4)),
    "Drake, contact by areas": ("pydrake", "peer_drake", "hydroelastic", (), (1e4, 1e6, 1e8)),
}
"""The same for what takes no external torque, with slip speeds and moduli in place of steps."""
UNIT = {"Drake, RK3": "slip speed", "Drake, contact by areas": "modulus"}
"""What the last argument is, where it is not a step."""


def runs(case: Case):
    """Yield (method, setting, function of the case and its further arguments) of every run on a case."""
    moments = case.law.k1 or case.law.k2 or case.law.k3
    for method, (package, module, function, first, settings) in (RUNS | ({} if moments else WITHOUT_MOMENTS)).items():
        if not find_spec(package):
            yield method, "", missing, (package,)
            continue
        for setting in settings:
            about = f"{UNIT.get(method, 'step')} {setting:g}"
            yield method, about, solved, (module, function, *first, setting)


def missing(case: Case, package: str) -> Answer:
    """Raise the Failure of an engine that is not installed."""
    raise Failure(f"{LEFT_OUT}: {ENGINES[package]} is not installed")


def solved(case: Case, module: str, function: str, *arguments) -> Answer:
    """Call the function of the module of an engine. Raises Failure where the engine stops."""
    engine = getattr(import_module(f"sonify.charts.{module}"), function)
    try:
        return engine(case, *arguments)
    except RuntimeError as error:
        raise Failure(f"stops: {' '.join(str(error).split())[:80]}") from None
