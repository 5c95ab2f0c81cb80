"""Closed-form reference solutions, against which the simulator is tested."""
