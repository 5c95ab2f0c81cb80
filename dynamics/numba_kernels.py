"""Numba decorators, and the folder of cached machine code."""

from pathlib import Path
from shutil import rmtree
from time import time

from numba import config
from numba import njit as njit  # with the cache folder that is set below

from dynamics.source_digest import source_digest


def machine_code_folder(parent: Path) -> Path:
    """Return the folder in `parent` for the machine code of these sources.

    Numba validates cached code by the file of the outermost function alone, not by those
    of the functions that it calls, and it cannot read an index that names a class which
    no longer exists. Therefore each version of the sources has a folder.
    """
    folders = ("dynamics", "sonify/sound", "sonify/hearing")
    digest = source_digest(Path(__file__).parents[1], folders)
    return parent / f"kernels-{digest[:12]}"


def remove_unused_folders(folder: Path) -> None:
    """Remove the folders of other versions that have not changed for a month."""
    month = 30 * 86400.0  # s
    for other in folder.parent.glob("kernels-*"):
        if other != folder and time() - other.stat().st_mtime > month:
            rmtree(other, ignore_errors=True)


_parent = Path(
    config.CACHE_DIR  # type: ignore[attr-defined]
    or Path(__file__).with_name("__pycache__")
)
_folder = machine_code_folder(_parent.absolute())
if not _folder.exists():
    remove_unused_folders(_folder)
config.CACHE_DIR = str(_folder)  # type: ignore[attr-defined]

kernel = njit(error_model="numpy", forceinline=True)
"""Compile a function that is called by other compiled functions.

Division by zero returns infinity without a branch. Inlining avoids the reference
counting of arrays, which would cost a third of the time of a step. Without `fastmath`,
every operation is rounded as written; with it, the choice of fused operations, and
therefore the bytes of a motion, would depend on the order of compilation."""
outermost = njit(error_model="numpy", cache=True, nogil=True)
"""Compile a function that is called from Python and releases the GIL, with a cache."""
cached = njit(error_model="numpy", cache=True)
"""Compile a function of an integrator, which compiled functions call by its type."""
