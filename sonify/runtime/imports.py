"""Import libraries without packages that a run does not need."""

import sys
from collections.abc import Iterator
from contextlib import contextmanager
from importlib import import_module
from types import ModuleType
from typing import Any


def import_signal_without_stats() -> None:
    """Import scipy.signal without scipy.stats, which takes longer than all the rest.

    scipy.signal uses a single function of scipy.stats, a percentile for one method of
    peak detection. During the import, a placeholder replaces scipy.stats; the function is
    loaded on its first call, and any other name at once. A later `import scipy.stats`
    imports the real package.
    """
    if "scipy.stats" in sys.modules:
        return
    placeholder = _StatsPlaceholder("scipy.stats")
    sys.modules["scipy.stats"] = placeholder
    try:
        with _unchanged_docstrings():
            import scipy.signal  # noqa: F401
    finally:
        if sys.modules.get("scipy.stats") is placeholder:
            del sys.modules["scipy.stats"]


@contextmanager
def _unchanged_docstrings() -> Iterator[None]:
    """Skip the notes on array libraries that SciPy adds to its docstrings at each import,
    which takes a third of the time."""
    from scipy._lib import _array_api

    add_notes = vars(_array_api).get("xp_capabilities")
    if add_notes is None:  # other versions of SciPy add no notes
        yield
        return
    _array_api.xp_capabilities = lambda **backends: lambda function: function
    try:
        yield
    finally:
        _array_api.xp_capabilities = add_notes


class _StatsPlaceholder(ModuleType):
    """Stand-in for scipy.stats during the import of scipy.signal."""

    @staticmethod
    def scoreatpercentile(*arguments: Any, **options: Any) -> Any:
        """Return scipy.stats.scoreatpercentile of the arguments."""
        from scipy.stats import scoreatpercentile

        return scoreatpercentile(*arguments, **options)

    def __getattr__(self, name: str) -> Any:
        if name.startswith("__"):
            raise AttributeError(name)
        if sys.modules.get("scipy.stats") is self:
            del sys.modules["scipy.stats"]
        return getattr(import_module("scipy.stats"), name)
