"""Compilation of a branch to machine code from its formulas.

The formulas of equations.py, regime.py and dissipation.py are evaluated once with
symbolic scalars, which record each operation as one line of a straight-line program.
Numba compiles this program. heyoka uses the same formulas.
"""

import functools
import math
import os
from collections.abc import Callable
from contextlib import suppress
from hashlib import sha256
from pathlib import Path
from tempfile import NamedTemporaryFile
from typing import TYPE_CHECKING, Any, NamedTuple

from numba import cfunc, config, types

from dynamics.guards import Guard
from dynamics.integrators.branch_formulas import rates_and_guards
from dynamics.numba_kernels import njit
from dynamics.regime import Branch, FlowFormulas

if TYPE_CHECKING:
    pass

ARRAY_TYPE = types.float64[::1]
FLOW_SIGNATURE = types.void(ARRAY_TYPE, ARRAY_TYPE, ARRAY_TYPE, ARRAY_TYPE)
"""Type of a compiled flow (state, constants, output for rates, output for guards)."""


class SourceProgram:
    """A straight-line program that computes each expression only once."""

    def __init__(self) -> None:
        self.names: dict[str, str] = {}

    def record(self, expression: str) -> "SymbolicScalar":
        """Return the symbolic scalar that has the value of `expression`."""
        return SymbolicScalar(
            self, self.names.setdefault(expression, f"t{len(self.names)}")
        )

    def call(self, function: str) -> "Callable[..., SymbolicScalar]":
        """Return a function of symbolic scalars that records a call of `function`."""
        return lambda *arguments: self.record(
            f"{function}({', '.join(map(str, arguments))})"
        )

    def lines(self) -> list[str]:
        """Return the assignments of the program in order."""
        return [f"{name} = {expression}" for expression, name in self.names.items()]


class SymbolicScalar:
    """A number in a program, represented by the name of its variable."""

    def __init__(self, program: SourceProgram, name: str) -> None:
        self.program = program
        self.name = name

    def __str__(self) -> str:
        return self.name

    def __neg__(self) -> "SymbolicScalar":
        return self.program.record(f"-{self}")


def _recording_operator(
    symbol: str,
) -> tuple[
    Callable[[SymbolicScalar, object], SymbolicScalar],
    Callable[[SymbolicScalar, object], SymbolicScalar],
]:
    def operation(self: SymbolicScalar, other: object) -> SymbolicScalar:
        return self.program.record(f"{self} {symbol} {other}")

    def reflected_operation(self: SymbolicScalar, other: object) -> SymbolicScalar:
        return self.program.record(f"{other} {symbol} {self}")

    return operation, reflected_operation


for _name, _symbol in (
    ("add", "+"),
    ("sub", "-"),
    ("mul", "*"),
    ("truediv", "/"),
    ("pow", "**"),
):
    _operation, _reflected_operation = _recording_operator(_symbol)
    setattr(SymbolicScalar, f"__{_name}__", _operation)
    setattr(SymbolicScalar, f"__r{_name}__", _reflected_operation)


class CompiledFlow(NamedTuple):
    """A compiled function of type FLOW_SIGNATURE, and the order of its guards."""

    flow: object
    guards: tuple[Guard, ...]


compiled_functions: dict[Callable[..., Any], Callable[..., Any]] = {}


def compiled_function(
    function: Callable[..., Any], signature: Any
) -> Callable[..., Any]:
    """Compile a function on its first use; numba caches the result on disk."""
    if (
        function not in compiled_functions
    ):  # the type dispatch of numba would take longer than the call
        compiled_functions[function] = njit(signature, cache=True, error_model="numpy")(
            function
        ).get_overload(signature)
    return compiled_functions[function]


@functools.lru_cache(64)
def compile_branch(
    branch: Branch, kind: type[FlowFormulas] = FlowFormulas
) -> CompiledFlow:
    """Compile the flow of a branch; the constants of a scene are its arguments.

    Numba caches the result on disk. Threads can share it.
    """
    source, names = generated_source(branch, kind)
    scope: dict[str, Any] = {name: getattr(math, name) for name in kind.FUNCTIONS}
    scope["__name__"] = __name__  # by which numba finds the function again
    file = cached_source_file(source)
    exec(compile(source, file, "exec"), scope)
    compile_flow = cfunc(FLOW_SIGNATURE, error_model="numpy", cache=file.exists())
    return CompiledFlow(compile_flow(scope["flow"]), names)


def cached_source_file(source: str) -> Path:
    """Return the file of a generated source next to its machine code, which numba caches
    for functions from files only.

    The file does not exist if the folder cannot be written.
    """
    folder = Path(config.CACHE_DIR)  # type: ignore[attr-defined]
    file = folder / f"flow_{sha256(source.encode()).hexdigest()[:16]}.txt"
    if not file.exists():
        with suppress(OSError):
            folder.mkdir(parents=True, exist_ok=True)
            with NamedTemporaryFile("w", dir=folder, delete=False) as temporary:
                temporary.write(source)
            os.replace(temporary.name, file)
    return file


def generated_source(
    branch: Branch, kind: type[FlowFormulas] = FlowFormulas
) -> tuple[str, tuple[Guard, ...]]:
    """Return the source code of the flow of a branch, and its guards."""
    program = SourceProgram()
    flow = kind(*(program.call(name) for name in kind.FUNCTIONS))
    y = [program.record(f"y[{i}]") for i in range(kind.SIZE)]
    rates, guards = rates_and_guards(
        flow, y, branch, lambda i: program.record(f"p[{i}]")
    )
    ends = [f"rates[{i}] = {value}" for i, value in enumerate(rates)]
    ends += [f"guards[{i}] = {value}" for i, value in enumerate(guards.values())]
    return "\n    ".join(
        ["def flow(y, p, rates, guards):", *program.lines(), *ends]
    ), tuple(guards)
