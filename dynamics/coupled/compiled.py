"""Machine code that is kept between runs, and forgotten when any file it came from changes."""

from hashlib import sha256
from pathlib import Path


def fingerprint(*modules) -> str:
    """Return a hash of the source of modules.

    Numba keeps compiled code by the file of the outermost function alone. As a closure variable of that function, this
    makes the files of the functions that it calls part of the key.
    """
    return sha256(b"".join(Path(module.__file__).read_bytes() for module in modules)).hexdigest()
