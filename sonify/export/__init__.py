"""Export the elastic modes, the motion and takes of the sound to files for other
programs."""
