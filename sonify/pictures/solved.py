"""MOTION, MODES -> PICTURES: the paper's figures 3 to 6, and the mode shapes."""

import numpy as np

from dynamics.rates import nutation_frequency, precession_rate

from .figure import figure_at


def draw_motion(motion, path):
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
            panel.legend(loc="lower right", fontsize=8)
        axes[1, 1].set(ylim=(0, 4))
        axes[2, 0].set(xlabel="x/R", aspect="equal")
        lowest, highest = np.percentile(precession_rate(state) * chi, [1, 99])
        axes[2, 1].set(ylim=(1.1 * min(lowest, -1.0), 1.1 * max(highest, 0.0)))


def draw_modes(modes, path):
    """Draw the normal displacement of the top face of every mode, with the patch to the right where there is one."""
    count = max(len(modes.frequency), 1)
    columns = min(count, 5)
    rows = -(-count // columns)
    angle = np.append(modes.face_angle, modes.face_angle[0] + 2 * np.pi)
    rim = modes.face_radius[-1]
    x, y = (np.outer(modes.face_radius / rim, f(angle)) for f in (np.cos, np.sin))
    with figure_at(path, 1, 1, (2.3 * columns, 2.7 * rows)) as (figure, axes):
        figure.subplots_adjust(left=0, right=1, bottom=0, top=1)
        axes.set(xlim=(-1.15, 2.3 * columns - 1.15), ylim=(1.5 - 2.7 * rows, 1.5), aspect="equal")
        axes.set_axis_off()
        for i in range(len(modes.frequency)):
            shape = modes.face_shape[i, 1][:, np.arange(len(angle)) % len(modes.face_angle)]
            shape = shape / (np.abs(shape).max() or 1.0)
            across, down = 2.3 * (i % columns), 2.7 * (i // columns)
            axes.contourf(x + across, y - down, shape, np.linspace(-1, 1, 17), cmap="RdGy")
            axes.contour(x + across, y - down, shape, [0.0], colors="k", linewidths=0.8)
            axes.plot(x[-1] + across, y[-1] - down, color="0.6", lw=0.5)
            title = f"{modes.frequency[i]:.0f} Hz\n{modes.family[i]}, order {modes.order[i]}"
            axes.text(across, 1.05 - down, title, fontsize=8, ha="center", va="bottom")
