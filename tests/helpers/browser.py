"""A browser for the tests of the pages."""

import shutil
import time

CHROMIUM = next(
    filter(None, map(shutil.which, ("chromium", "chromium-browser", "google-chrome"))),
    None,
)
"""The program, or None where it is not installed."""


def until(page, expression):
    """Wait until an expression is true; Playwright's own wait needs `eval`, which the policy
    forbids."""
    end = time.monotonic() + 300
    while not page.evaluate(expression):
        assert time.monotonic() < end, expression
        page.wait_for_timeout(50)
