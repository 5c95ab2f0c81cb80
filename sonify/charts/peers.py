"""The physics engines beside us: which runs they make, where they are installed."""

from collections.abc import Callable
from functools import partial
from importlib import import_module
from importlib.util import find_spec
from typing import NamedTuple

from sonify.charts.motion_case import Case
from sonify.charts.records import LEFT_OUT, Answer, Failure

ENGINES = {"mujoco": "MuJoCo", "pydrake": "Drake", "pybullet": "PyBullet"}
"""Name by package."""


class Peer(NamedTuple):
    """A method of an engine: its package, a function of sonify.charts.peer_<package> and the first of its arguments
    after the case; its last one, a run each, and how a run with it is called."""

    package: str
    function: str
    first: tuple
    last: tuple
    setting: str = "step {:g}"

    def runs(self, *case) -> list[tuple[str, Callable[[], Answer]]]:
        """Return setting and call of every run on a case, or the one call that fails for want of the engine."""
        if not find_spec(self.package):
            return [("", self.missing)]
        return [(self.setting.format(x), partial(self.ask, *case, *self.first, x)) for x in self.last]

    def missing(self) -> Answer:
        """Raise the Failure of an engine that is not installed."""
        raise Failure(f"{LEFT_OUT}: {ENGINES[self.package]} is not installed")

    def ask(self, *arguments) -> Answer:
        """Return what the engine answers. Raises Failure where it stops."""
        engine = getattr(import_module(f"sonify.charts.peer_{self.package}"), self.function)
        try:
            return engine(*arguments)
        except RuntimeError as error:
            raise Failure(f"stops: {' '.join(str(error).split())[:80]}") from None


RUNS = {
    "MuJoCo, Euler": Peer("mujoco", "disk", ("Euler",), (1e-2, 1e-3, 1e-4)),
    "MuJoCo, RK4": Peer("mujoco", "disk", ("RK4",), (1e-2, 1e-3)),
    "Drake, TAMSI": Peer("pydrake", "disk", ("Tamsi",), (1e-2, 1e-3)),
    "Drake, SAP": Peer("pydrake", "disk", ("Sap",), (1e-2, 1e-3)),
    "PyBullet": Peer("pybullet", "disk", (), (1e-2, 1e-3, 1e-4)),
}
WITHOUT_MOMENTS = {
    "Drake, RK3": Peer("pydrake", "continuous", (), (1e-2, 1e-3, 1e-4), "slip speed {:g}"),
    "Drake, contact by areas": Peer("pydrake", "hydroelastic", (), (1e4, 1e6, 1e8), "modulus {:g}"),
}
"""What takes no external torque."""


def able(case: Case) -> dict[str, Peer]:
    """Return the methods that can solve a case."""
    return RUNS | ({} if case.law.k1 or case.law.k2 or case.law.k3 else WITHOUT_MOMENTS)
