"""Claim: one scene gives the same bytes on one machine, whatever code was compiled before and in
whatever order.

Source: IEEE 754: an operation that is rounded as written has a unique result. A compiler that may
fuse a product with a sum, or reorder a sum, decides from the surrounding code: the motion on the
light table below had 30 losses of contact with one cache of machine code and 31 with another.
Oracle: the flags and the instructions of the machine code; a process with an empty cache, and one
with the usual cache, which other tests have filled in their order.
"""

import ast
import os
import re
import subprocess
import sys

import numpy as np
import pytest
from numba import njit
from paths import REFERENCES, ROOT

from dynamics.numba_kernels import kernel, outermost

FILES = sorted(
    file
    for package in ("dynamics", "modal", "sonify")
    for file in (ROOT / package).rglob("*.py")
)
LOOSE = re.compile(
    r"^.*(?: (?:contract|reassoc|arcp|afn|fast) |llvm\.fmuladd|llvm\.fma\.).*$",
    re.MULTILINE,
)
FUSED = re.compile(
    r"^\s*(?:vf?n?m(?:add|sub)[0-9a-z]*|fn?m(?:add|sub|la|ls))\b.*$", re.MULTILINE
)


def product_and_sum(x, y, z):
    """Accumulate products, which a processor may fuse with the sum, and return their sum."""
    total = 0.0
    for i in range(len(x)):
        z[i] += x[i] * y[i]
        total += x[i] * y[i]
    return total


def machine_code(function):
    """Return the LLVM text and the assembly of a compiled function for three arrays."""
    outer = outermost(lambda x, y, z: function(x, y, z))
    outer(np.ones(4), np.ones(4), np.ones(4))
    (llvm,) = outer.inspect_llvm().values()
    (assembly,) = outer.inspect_asm().values()
    return llvm, assembly


def test_no_function_is_compiled_with_loose_arithmetic():
    """Numba rounds every operation as written unless `fastmath` is given."""
    found = []
    for file in FILES:
        for node in ast.walk(ast.parse(file.read_text("utf-8"))):
            if isinstance(node, ast.keyword) and node.arg in ("fastmath", "parallel"):
                found.append(f"{file.relative_to(ROOT)}:{node.value.lineno}")
    assert found == []
    assert not kernel(product_and_sum).targetoptions.get("fastmath")
    assert not outermost(product_and_sum).targetoptions.get("fastmath")


def test_products_and_sums_are_not_fused():
    """LLVM fuses only where the source allows; the flag `contract` would show both patterns."""
    llvm, assembly = machine_code(kernel(product_and_sum))
    assert "fmul" in llvm
    assert "fadd" in llvm
    assert LOOSE.findall(llvm) == []
    assert FUSED.findall(assembly) == []
    loose_llvm, _ = machine_code(
        njit(fastmath={"contract", "reassoc"})(product_and_sum)
    )
    assert LOOSE.findall(loose_llvm)  # the pattern detects loose arithmetic


@pytest.mark.slow
def test_bytes_do_not_depend_on_what_was_compiled_before(tmp_path):
    """Compiling the portable integrator first once changed the last bits of a motion.

    With an empty usual cache, the two processes compile in opposite orders.
    """
    script = REFERENCES / "compile_in_order.py"
    found = []
    usual = {**os.environ, "PYTHONPATH": str(ROOT)}
    empty = usual | {"NUMBA_CACHE_DIR": str(tmp_path)}
    for environment, order in (
        (usual, ["table", "rough", "portable"]),
        (empty, ["portable", "rough", "table"]),
    ):
        command = [sys.executable, str(script), *order]
        done = subprocess.run(
            command,
            capture_output=True,
            text=True,
            check=True,
            cwd=ROOT,
            env=environment,
        )
        found.append(done.stdout.splitlines())
    (*usual_cases, _), (*cases, march) = found  # Numba does not inspect cached code
    assert usual_cases == cases
    assert [line.split()[0] for line in cases] == ["portable", "rough", "table"]
    products, fused = map(int, march.split()[1:])
    assert products > 100
    assert fused == 0
