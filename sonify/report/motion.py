"""MOTION -> PICTURE: the paper's figures 3 to 6."""

import numpy as np

from dynamics import Motion
from dynamics.rates import nutation_frequency, precession_rate
from sonify.report.figure import figure_at


def draw_motion(motion: Motion, path):
    """Draw the paper's figures 3 to 6."""
    chi, weight = motion.disk.time_unit, motion.disk.weight
    t = np.linspace(0, motion.t[-1], 12000)
    state, tau = motion.at(t), t / chi
    peaks, frequency = nutation_frequency(motion)
    energy = motion.energy(t) * chi**2 / (motion.disk.mass * motion.disk.radius**2)
    with figure_at(path, 3, 2, (11, 11)) as (_, axes):
        curves = [
            (tau, np.pi / 2 - state[:, 1], "α [rad]", "Figure 3 (a): angle of the disk to the upright"),
            (tau, energy, "Ê", "Figure 3 (b): energy"),
            (tau, motion.normal_load(t), "Φ", "Figure 4 (a): normal force"),
            (peaks / chi, frequency * chi, "f̂", "Figure 4 (b): frequency of the normal force"),
            (state[:, 3] / motion.disk.radius, state[:, 4] / motion.disk.radius, "y/R", "Figure 5: path of the centre"),
            (tau, precession_rate(state) * chi, "dθ/dτ", "Figure 6: rate of precession"),
        ]
        for panel, (x, y, label, title) in zip(axes.flat, curves, strict=True):
            panel.plot(x, y, color="k", lw=0.6)
            panel.set(xlabel="time τ = t/χ", ylabel=label, title=title)
            panel.grid(alpha=0.3)
        at_rest = motion.normal_load([0.0])[0] * weight / motion.force([0.0])[0, 2]
        for panel, height, name in ((axes[0, 0], np.pi / 2, "flat"), (axes[1, 0], at_rest, "weight")):
            panel.axhline(height, color="0.5", lw=1.2, ls="--", label=name)
            panel.legend(loc="lower right", fontsize=8, framealpha=1)
        axes[1, 1].set(ylim=(0, 4))
        axes[2, 0].set(xlabel="x/R", aspect="equal", adjustable="datalim")
        lowest, highest = np.percentile(precession_rate(state) * chi, [1, 99])
        axes[2, 1].set(ylim=(1.1 * min(lowest, -1.0), 1.1 * max(highest, 0.0)))
