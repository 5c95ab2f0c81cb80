"""A disk that is full."""

from contextlib import contextmanager

import pytest


@contextmanager
def files_of_at_most(size):
    """Let no file grow beyond a size [bytes]: its writes fail as on a full disk."""
    resource = pytest.importorskip(
        "resource", reason="this system cannot limit the size of files"
    )
    before = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (size, before[1]))
    try:
        yield
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, before)
