"""SOUND -> SETTLING RUNS: disks and coins that come to rest, by the rising rate of their bursts."""
