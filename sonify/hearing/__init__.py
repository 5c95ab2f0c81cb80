"""Analysis of sounds: levels, spectrograms, rising tones, spectral lines and settling
disks."""
