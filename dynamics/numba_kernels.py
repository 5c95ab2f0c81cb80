"""Numba decorators with a cache of machine code that depends on every source file involved."""

from hashlib import sha256
from pathlib import Path

from numba import njit

kernel = njit(error_model="numpy", forceinline=True)
"""Compile a function that other compiled functions call.

Division by zero gives infinity without a branch. Inlining avoids reference counts of arrays, which
would take a third of a step. Without `fastmath` every operation is rounded as written; with it the
fused operations, and so the bytes of a motion, would depend on the order of compilation.
"""
outermost = njit(error_model="numpy", cache=True, nogil=True)
"""Compile a function that Python calls, and cache its machine code. It releases the GIL."""


def fingerprint(*modules) -> str:
    """Return a hash of the source files of modules.

    Numba keys its cache by the file of the outermost function alone. As a closure variable of that
    function, this hash includes the files of all called functions in the key.
    """
    return sha256(b"".join(Path(module.__file__).read_bytes() for module in modules)).hexdigest()
