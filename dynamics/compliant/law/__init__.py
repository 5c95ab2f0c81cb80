"""Law of the elastic contact: stiffness, creep, roughness, and its linearised response."""
