"""Keep messages of libraries off standard error, which is for those of the program."""

import logging
import sys
import warnings


def hide_library_messages() -> None:
    """Hide warnings and log messages of libraries, unless Python is asked for warnings
    (`python -W` or PYTHONWARNINGS)."""
    if sys.warnoptions:
        return
    warnings.simplefilter("ignore")
    logging.getLogger().addHandler(logging.NullHandler())
