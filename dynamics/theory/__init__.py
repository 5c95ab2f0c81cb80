"""Reference solutions in closed form, which judge the simulator."""
