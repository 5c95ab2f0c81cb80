"""Commands whose arguments are wrong."""

from click.testing import CliRunner

from sonify.__main__ import main


def assert_refused(arguments, message):
    """Assert that a command ends with status 2 and one line that begins with a message."""
    told = CliRunner().invoke(main, arguments)
    assert told.exit_code == 2
    assert told.stderr.startswith(f"sonify: {message}")
    assert told.stderr.count("\n") == 1
