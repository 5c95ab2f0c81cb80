"""Motion of a rattling disk, which may touch the table at several points of its rim."""
