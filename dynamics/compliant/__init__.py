"""Motion of the disk on an elastic, rough contact.

`law` contains the contact law (hertz_mindlin, kalker, tabulated), the heights of table and edge
(height_profile, roughness), the linearised contact (linearised, statistical_linearisation), and the
vibration of a contact without losses along a rigid motion (linear_response). `stepping` solves the
full compliant motion in time steps. `model_selection` and `two_way_onset` select the model of a
scene. `compliant_motion` and `switched_motion` contain the solved motions, and `state_conversion`
converts between the state of the time steps and the columns of a `Motion`.
"""
