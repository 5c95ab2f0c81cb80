"""RECORDINGS -> CAUSE OF THE DECLINE: fit the dissipation of a disk to recordings.

The stages are: read the files (recordings_io); model the decline of a disk for any shares of
dissipation (decay_model); measure the rate of a tone from its phase, in time coordinates of a
decline (phase_demodulation); fit shares with intervals (least_squares); choose signal and spectral
line, and give a verdict (line_selection); write the results (result, report). `synthetic` generates
test recordings, `fu_berlin` reproduces a published analysis, and `parallel` runs tasks in parallel.
"""
