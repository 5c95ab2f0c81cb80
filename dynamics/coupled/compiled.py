"""Machine code that is kept between runs, and forgotten when any file it came from changes."""

from hashlib import sha256
from pathlib import Path

from numba import njit

kernel = njit(error_model="numpy", fastmath={"contract", "nsz", "arcp"}, forceinline=True)
"""Compile a function that others call: division by zero gives infinity, and costs no branch. Products and sums may be
fused, and one reciprocal serve several divisions: this moves the last bits, and no order of sums. What is called is
made part of what calls it: arrays are counted at every call, and that took a third of a step."""
outermost = njit(error_model="numpy", cache=True, nogil=True)
"""Compile a function that Python calls, and keep its machine code; other threads go on while it runs."""


def fingerprint(*modules) -> str:
    """Return a hash of the source of modules.

    Numba keeps compiled code by the file of the outermost function alone. As a closure variable of that function, this
    makes the files of the functions that it calls part of the key.
    """
    return sha256(b"".join(Path(module.__file__).read_bytes() for module in modules)).hexdigest()
