"""SOUND -> WHAT IS HEARD: levels, spectrograms, the rising tone and the carriers of any sound."""
