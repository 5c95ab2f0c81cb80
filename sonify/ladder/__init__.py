"""A scene on every model that applies, from the cheapest to the most complete one."""
