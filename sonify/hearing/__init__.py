"""SOUND -> ANALYSIS: levels, spectrograms, rising tone, spectral lines and settling disks of any
sound."""
