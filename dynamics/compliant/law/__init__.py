"""Elastic contact law: stiffness, creep, roughness and linearised response."""
