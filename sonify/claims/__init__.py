"""RESULT -> FINDINGS: every claim once, as a function with a value, what is expected, a tolerance
and a source."""
