"""Findings of a result: one function per claim, with an expected range, a tolerance and
a source."""
