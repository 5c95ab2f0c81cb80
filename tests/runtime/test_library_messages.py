"""Claim: warnings and log messages of libraries do not reach standard error unless asked for.

Oracle: the standard error of a fresh process in which a library warns and logs.
"""

import subprocess
import sys

SCRIPT = """
import logging, warnings
from sonify.runtime.library_messages import hide_library_messages
hide_library_messages()
warnings.warn("a library warns")
logging.getLogger("library").warning("a library logs")
"""


def written(*options):
    """Return standard error of the script."""
    command = [sys.executable, *options, "-c", SCRIPT]
    return subprocess.run(command, capture_output=True, text=True, check=True).stderr


def test_nothing_is_written():
    assert written() == ""


def test_warnings_are_written_on_request():
    assert "a library warns" in written("-W", "default")
    assert "a library logs" in written("-W", "default")
