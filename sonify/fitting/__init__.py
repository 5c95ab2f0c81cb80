"""Fit of the dissipation of a disk to recordings.

The stages are: read the files (`sonify.hearing`); model the decay of the motion for any
shares of dissipation (decay_model); measure the rate of a tone from its phase, in the
time coordinate of a decay (phase_demodulation); fit shares with intervals
(least_squares); select signal and spectral line and give a verdict (line_selection);
judge a rattling disk by the law of its bursts (impacts); compare a recording with a
simulation (comparison); write the results (result, report). `parallel` runs tasks in parallel."""
