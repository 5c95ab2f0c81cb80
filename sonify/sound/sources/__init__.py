"""Sources of sound: what turns the contact force into stems of pressure."""
