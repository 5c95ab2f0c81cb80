"""Motion of the disk on an elastic, rough contact.

`law` contains the contact law (hertz_mindlin, kalker, tabulated), the heights of table
and edge (height_profile, roughness), the linearised contact (linearised,
statistical_linearisation), and the vibration along a rigid motion while contact is
maintained (linear_response). `stepping` solves the full compliant motion in time steps; what
it shares with `dynamics.rattling` is in `dynamics.stepping_core`.
`model_selection` and `two_way_onset` select the model of a scene. `compliant_motion`
and `switched_motion` implement the solved motions. `state_conversion` converts between
the state of the time steps and the columns of a `Motion`.
"""
