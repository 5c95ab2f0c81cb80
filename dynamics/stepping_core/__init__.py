"""What the time steps of one contact and of contacts anywhere on the rim share.

`body` contains constants, start, energy and columns of the rigid disk; `rotation` its
rotation in a step; `resistance` the moments against it; `oscillators` the modes in a step;
`table_shapes` and `round_table` the shapes of a table below the rim, and `rim_modes` those
of the disk; `ledger` and `row_store` the stored rows; `end_reasons` the outcomes; `layout`
and `vectors` serve compiled code. `dynamics.compliant.stepping` (one contact, implicit
steps that conserve energy) and `dynamics.rattling` (springs along the rim, exact flights
between impulses) remain two models: on a smooth table the second takes fifteen times the
time of the first (chart `contact-models`).
"""
