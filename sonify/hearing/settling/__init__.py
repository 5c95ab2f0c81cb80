"""Detection of disks and coins that come to rest, from the rising rate of their
bursts."""
