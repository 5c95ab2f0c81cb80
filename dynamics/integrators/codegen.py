"""Machine code of one branch of the flow, from one run of its formulas on recording scalars.

The scalars record each operation as one line of a straight-line program, which numba compiles. The
formulas remain in equations.py, regime.py and dissipation.py; heyoka uses the same formulas."""

import functools
import math
from typing import NamedTuple

from numba import cfunc, njit, types

from dynamics.guards import Guard
from dynamics.integrators.branch_formulas import rates_and_guards
from dynamics.regime import Branch, FlowFormulas

ARRAY_TYPE = types.float64[::1]
FLOW_SIGNATURE = types.void(ARRAY_TYPE, ARRAY_TYPE, ARRAY_TYPE, ARRAY_TYPE)
"""Type of a compiled branch: state, constants, array for the rates, array for the guards."""


class SourceProgram:
    """A straight-line program; each expression is computed only once."""

    def __init__(self):
        self.names = {}

    def note(self, expression: str) -> "SymbolicScalar":
        """Return the scalar with the value of `expression`."""
        return SymbolicScalar(self, self.names.setdefault(expression, f"t{len(self.names)}"))

    def call(self, function: str):
        """Return a function of scalars that records a call of `function`."""
        return lambda *arguments: self.note(f"{function}({', '.join(map(str, arguments))})")

    def lines(self) -> list[str]:
        """Return the assignments in order of execution."""
        return [f"{name} = {expression}" for expression, name in self.names.items()]


class SymbolicScalar:
    """A number in a program, represented by its name."""

    def __init__(self, program: SourceProgram, name: str):
        self.program = program
        self.name = name

    def __str__(self):
        return self.name

    def __neg__(self):
        return self.program.note(f"-{self}")


def _recording_operator(symbol):
    def forward(self, other):
        return self.program.note(f"{self} {symbol} {other}")

    def backward(self, other):
        return self.program.note(f"{other} {symbol} {self}")

    return forward, backward


for _name, _symbol in (("add", "+"), ("sub", "-"), ("mul", "*"), ("truediv", "/"), ("pow", "**")):
    _forward, _backward = _recording_operator(_symbol)
    setattr(SymbolicScalar, f"__{_name}__", _forward)
    setattr(SymbolicScalar, f"__r{_name}__", _backward)


class CompiledFlow(NamedTuple):
    """A branch as an argument of the type FLOW_SIGNATURE, and its guards in order."""

    flow: object
    guards: tuple[Guard, ...]


compiled_functions: dict = {}


def machine_code(function, signature):
    """Compile a function on first use rather than on import; numba caches the result on disk."""
    if (
        function not in compiled_functions
    ):  # numba's type dispatch takes longer than the call itself
        compiled_functions[function] = njit(signature, cache=True, error_model="numpy")(
            function
        ).get_overload(signature)
    return compiled_functions[function]


@functools.lru_cache(64)
def compile_branch(branch: Branch, kind=FlowFormulas) -> CompiledFlow:
    """Compile a branch for a kind of flow; the constants of a scene are arguments.

    Threads can share the result."""
    source, names = generated_source(branch, kind)
    scope = {name: getattr(math, name) for name in kind.FUNCTIONS}
    exec(source, scope)
    return CompiledFlow(cfunc(FLOW_SIGNATURE, error_model="numpy")(scope["flow"]), names)


def generated_source(branch: Branch, kind=FlowFormulas) -> tuple[str, tuple[Guard, ...]]:
    """Return the source of the function (FLOW_SIGNATURE) of one branch, and its guards."""
    program = SourceProgram()
    flow = kind(*(program.call(name) for name in kind.FUNCTIONS))
    y = [program.note(f"y[{i}]") for i in range(kind.SIZE)]
    rates, guards = rates_and_guards(flow, y, branch, lambda i: program.note(f"p[{i}]"))
    ends = [f"rates[{i}] = {value}" for i, value in enumerate(rates)]
    ends += [f"guards[{i}] = {value}" for i, value in enumerate(guards.values())]
    return "\n    ".join(["def flow(y, p, rates, guards):", *program.lines(), *ends]), tuple(guards)
