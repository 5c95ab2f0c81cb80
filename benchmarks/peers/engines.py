"""Define methods, settings and runs of the physics engines; engines that are not
installed are omitted."""

from collections.abc import Callable
from functools import partial
from importlib import import_module
from importlib.util import find_spec
from typing import NamedTuple

from benchmarks.cases.motion_case import Case
from benchmarks.timed_runs import LEFT_OUT, Answer, Failure

ENGINES = {"mujoco": "MuJoCo", "pydrake": "Drake", "pybullet": "PyBullet"}
"""Name of each engine, by Python package."""

CASE_MODULES = {
    "mujoco": "benchmarks.peers.mujoco_case",
    "pydrake": "benchmarks.peers.drake_case",
    "pybullet": "benchmarks.peers.pybullet_case",
}
"""Module that solves the benchmark problems with each engine, by Python package."""


class EngineMethod(NamedTuple):
    """Method of an engine: Python package, function of its case module, and arguments
    of this function.

    The function is called with the case (if any), the fixed arguments, and one value of
    `values` per run. `setting` is the format string of that value."""

    package: str
    function: str
    fixed: tuple
    values: tuple
    setting: str = "step {:g}"

    def runs(self, *case) -> list[tuple[str, Callable[[], Answer]]]:
        """Return setting and call of every run on a case, or one call that fails if the
        engine is not installed."""
        if not find_spec(self.package):
            return [("", self.missing)]
        return [
            (self.setting.format(x), partial(self.solve, *case, *self.fixed, x))
            for x in self.values
        ]

    def missing(self) -> Answer:
        """Raise the Failure of an engine that is not installed."""
        raise Failure(f"{LEFT_OUT}: {ENGINES[self.package]} is not installed")

    def solve(self, *arguments) -> Answer:
        """Return the result of the engine. Raises Failure if the engine stops."""
        engine = getattr(import_module(CASE_MODULES[self.package]), self.function)
        try:
            return engine(*arguments)
        except RuntimeError as error:
            raise Failure(f"stops: {' '.join(str(error).split())[:80]}") from None


METHODS = {
    "MuJoCo, Euler": EngineMethod("mujoco", "disk", ("Euler",), (1e-2, 1e-3, 1e-4)),
    "MuJoCo, RK4": EngineMethod("mujoco", "disk", ("RK4",), (1e-2, 1e-3)),
    "Drake, TAMSI": EngineMethod("pydrake", "disk", ("Tamsi",), (1e-2, 1e-3)),
    "Drake, SAP": EngineMethod("pydrake", "disk", ("Sap",), (1e-2, 1e-3)),
    "PyBullet": EngineMethod("pybullet", "disk", (), (1e-2, 1e-3, 1e-4)),
}
METHODS_WITHOUT_MOMENTS = {
    "Drake, RK3": EngineMethod(
        "pydrake", "continuous", (), (1e-2, 1e-3, 1e-4), "slip speed {:g}"
    ),
    "Drake, contact by areas": EngineMethod(
        "pydrake", "hydroelastic", (), (1e4, 1e6, 1e8), "modulus {:g}"
    ),
}
"""Methods that cannot apply external torques, and therefore no resisting moments."""


def methods_for(case: Case) -> dict[str, EngineMethod]:
    """Return the methods that can solve a case."""
    has_moments = case.law.k1 or case.law.k2 or case.law.k3
    return METHODS if has_moments else METHODS | METHODS_WITHOUT_MOMENTS
