"""Plot the inclination, precession rate and normal force of a motion against time."""

from typing import TYPE_CHECKING

import numpy as np

from dynamics.kinematics import precession_rate

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from dynamics.motion import Motion


def plot_motion(motion: "Motion") -> "Figure":
    """Return a figure of a motion, evaluated at evenly spaced times."""
    points = 20_000
    from matplotlib.figure import Figure  # slow to import

    t = np.linspace(0.0, motion.t[-1], points)
    state, force = motion.at_and_force(t)
    curves = {
        "inclination [degrees]": np.degrees(state[:, 1]),
        "precession [Hz]": np.abs(precession_rate(state[:, 7], np.sin(state[:, 1])))
        / (2 * np.pi),
        "normal force [N]": force[:, 2],
    }
    figure = Figure(figsize=(8.0, 7.0), layout="constrained")
    panels = figure.subplots(len(curves), 1, sharex=True)
    for panel, (label, curve) in zip(panels, curves.items(), strict=True):
        panel.plot(t, curve, color="black", linewidth=0.8)
        panel.set_ylabel(label)
        panel.grid(alpha=0.3)
    panels[1].set_yscale("log")
    panels[2].axhline(
        motion.disk.weight, color="tab:blue", linestyle="--", label="weight"
    )
    panels[2].legend(loc="upper left", frameon=False)
    panels[2].set_xlabel("time [s]")
    return figure
