"""Interface to the operating system: signals, worker processes, progress and files."""
