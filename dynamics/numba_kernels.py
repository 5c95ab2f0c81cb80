"""Numba decorators, and the hash of source files that validates cached machine code."""

from hashlib import sha256
from pathlib import Path

from numba import njit

kernel = njit(error_model="numpy", forceinline=True)
"""Compile a function that is called by other compiled functions.

Division by zero returns infinity without a branch. Inlining avoids the reference
counting of arrays, which would cost a third of the time of a step. Without `fastmath`,
every operation is rounded as written; with it, the choice of fused operations, and
therefore the bytes of a motion, would depend on the order of compilation."""
outermost = njit(error_model="numpy", cache=True, nogil=True)
"""Compile a function that is called from Python and releases the GIL, with a cache."""


def fingerprint(*modules) -> str:
    """Return a hash of the source files of modules.

    Numba keys its cache by the source file of the outermost function only. If that
    function uses this hash as a closure variable, the key also covers the files of all
    called functions.
    """
    return sha256(
        b"".join(Path(module.__file__).read_bytes() for module in modules)
    ).hexdigest()
