"""SCENE -> FILES of other programs: the elastic modes, the motion, and takes of the sound."""
