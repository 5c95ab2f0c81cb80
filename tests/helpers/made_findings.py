"""Findings made for tests."""

from sonify.claims.finding import Finding


def found(key, value, margin=0.0, cause=""):
    """Return a finding that holds for a positive value."""
    return Finding(
        key=key,
        claim=key,
        value=value,
        unit="",
        at_least=0.0,
        margin=margin,
        cause=cause,
        source="a test",
    )
