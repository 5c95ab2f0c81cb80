"""Speed against accuracy, and where methods fail: every method on the same work, in one process."""
