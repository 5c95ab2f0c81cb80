"""Machine code of one branch of the flow: its formulas are run once on scalars that write down what
is done to them.

What is written down is a straight program without a choice in it, which numba compiles. The
formulas stay where they are, in equations.py, regime.py and dissipation.py, as they do for heyoka.
"""

import functools
import math
from typing import NamedTuple

from numba import cfunc, njit, types

from dynamics.guards import Guard
from dynamics.integrators.branch_formulas import formulas
from dynamics.regime import Branch, Flow

ROW = types.float64[::1]
FLOW = types.void(ROW, ROW, ROW, ROW)
"""What a compiled branch is called with: state, constants, and where the rates and the guards
go."""


class Program:
    """The lines of a straight program; what was computed before is not computed again."""

    def __init__(self):
        self.names = {}

    def note(self, expression: str) -> "Scalar":
        """Return the scalar that `expression` computes."""
        return Scalar(self, self.names.setdefault(expression, f"t{len(self.names)}"))

    def call(self, function: str):
        """Return a function of scalars that notes a call."""
        return lambda *arguments: self.note(f"{function}({', '.join(map(str, arguments))})")

    def lines(self) -> list[str]:
        """Return the assignments in their order."""
        return [f"{name} = {expression}" for expression, name in self.names.items()]


class Scalar:
    """A number of a program, known by its name."""

    def __init__(self, program: Program, name: str):
        self.program = program
        self.name = name

    def __str__(self):
        return self.name

    def __neg__(self):
        return self.program.note(f"-{self}")


def _operator(symbol):
    def forward(self, other):
        return self.program.note(f"{self} {symbol} {other}")

    def backward(self, other):
        return self.program.note(f"{other} {symbol} {self}")

    return forward, backward


for _name, _symbol in (("add", "+"), ("sub", "-"), ("mul", "*"), ("truediv", "/"), ("pow", "**")):
    _forward, _backward = _operator(_symbol)
    setattr(Scalar, f"__{_name}__", _forward)
    setattr(Scalar, f"__r{_name}__", _backward)


class Compiled(NamedTuple):
    """A branch as an argument of the type FLOW, and the names of its guards in their order."""

    flow: object
    guards: tuple[Guard, ...]


machines: dict = {}


def machine(function, signature):
    """Compile a function when it is first asked for, not when it is imported; numba keeps it on
    disk."""
    if function not in machines:  # numba takes longer to tell the types of a call than to make it
        machines[function] = njit(signature, cache=True, error_model="numpy")(
            function
        ).get_overload(signature)
    return machines[function]


@functools.lru_cache(64)
def compiled(branch: Branch, kind=Flow) -> Compiled:
    """Compile the `shape` of a branch for a kind of flow; the constants of a scene are arguments.

    Safe to share between threads.
    """
    source, names = program_of(branch, kind)
    scope = {name: getattr(math, name) for name in kind.FUNCTIONS}
    exec(source, scope)
    return Compiled(cfunc(FLOW, error_model="numpy")(scope["flow"]), names)


def program_of(branch: Branch, kind=Flow) -> tuple[str, tuple[Guard, ...]]:
    """Return the source of the function (FLOW) of one branch, and the names of its guards."""
    program = Program()
    flow = kind(*(program.call(name) for name in kind.FUNCTIONS))
    y = [program.note(f"y[{i}]") for i in range(kind.SIZE)]
    rates, guards = formulas(flow, y, branch, lambda i: program.note(f"p[{i}]"))
    ends = [f"rates[{i}] = {value}" for i, value in enumerate(rates)]
    ends += [f"guards[{i}] = {value}" for i, value in enumerate(guards.values())]
    return "\n    ".join(["def flow(y, p, rates, guards):", *program.lines(), *ends]), tuple(guards)
