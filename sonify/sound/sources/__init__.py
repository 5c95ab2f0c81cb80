"""Sound sources, which convert the contact force to sound-pressure signals, one per
stem."""
