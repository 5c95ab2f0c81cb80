"""Pictures of the mode shapes."""

import numpy as np
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.patches import Arc, Circle

from .modes import Modes

COLUMNS = 5
STRETCH = 0.16
"""Largest drawn displacement over the radius, of the rim seen from above."""


def draw_modes(modes: Modes, path) -> None:
    """Write a picture (png, svg, pdf by suffix) of every mode seen from above.

    Colour is axial motion, black its nodal lines, dashed the rim moved in its plane; both are to scale within a mode.
    """
    rows = max(1, -(-len(modes) // COLUMNS))
    figure = Figure(figsize=(3.1 * COLUMNS, 3.55 * rows + 0.9), dpi=110)
    FigureCanvasAgg(figure)
    axes = figure.subplots(rows, COLUMNS, squeeze=False).ravel()
    for i, axis in enumerate(axes):
        axis.set_axis_off()
        if i < len(modes):
            draw(axis, modes, i)
    figure.suptitle("Modes of the disk: axial motion of the top face (colour), nodal lines (black), rim (dashed)")
    figure.tight_layout(rect=(0, 0, 1, 0.97))
    figure.savefig(path)


def draw(axis, modes, i):
    """One mode: colour map, nodal lines, rim at rest and displaced, title."""
    radius = modes.face_radius[-1] + modes.face_radius[0]
    x, y, w = top_face(modes, i, radius)
    plane = modes.rim_shape[i, :, :2]
    scale = max(np.abs(w).max(), np.abs(plane).max())
    axis.contourf(x, y, w / scale, levels=np.linspace(-1, 1, 21), cmap="RdBu_r")
    if np.abs(w).max() > 0.1 * scale:
        axis.contour(x, y, w / scale, levels=[0.0], colors="black", linewidths=1.3)
    axis.add_patch(Circle((0, 0), radius, fill=False, color="0.3", lw=1))
    axis.plot(*moved_rim(modes, i, radius, STRETCH * radius / scale), color="0.1", lw=1, ls=(0, (4, 2)))
    held = modes.rim_angle[np.abs(modes.rim_shape).max(axis=(0, 2)) < 1e-9 * np.abs(modes.rim_shape).max()]
    if len(held):
        reach = np.rad2deg(np.abs(np.angle(np.exp(1j * held))).max())
        axis.add_patch(Arc((0, 0), 2 * radius, 2 * radius, theta1=-reach, theta2=reach, color="tab:green", lw=5))
    axis.set_aspect("equal")
    axis.set(xlim=(-1.25 * radius, 1.25 * radius), ylim=(-1.25 * radius, 1.25 * radius))
    axis.set_title(caption(modes, i), fontsize=10)


def caption(modes, i):
    """Number, frequency, family, order and T60 of mode i."""
    time = f", T60 {modes.decay_time[i]:.2g} s" if modes.decay_rate[i] > 0 else ""
    pair = f"{modes.parity[i]}, " if modes.partner[i] >= 0 else ""
    return f"{i + 1}: {modes.frequency[i]:.0f} Hz{time}\n{modes.family[i]}, {pair}order {modes.order[i]}"


def top_face(modes, i, radius):
    """Cartesian grids x, y and axial motion w of the top face, closed around and reaching the rim and the centre."""
    w = modes.face_shape[i, 1]
    rim = w[-1] + (w[-1] - w[-2]) * (radius - modes.face_radius[-1]) / (modes.face_radius[-1] - modes.face_radius[-2])
    w = np.vstack([np.full(w.shape[1], w[0].mean()), w, rim])
    r = np.concatenate([[0.0], modes.face_radius, [radius]])
    angle = np.append(modes.face_angle, 2 * np.pi)
    w = np.hstack([w, w[:, :1]])
    return np.outer(r, np.cos(angle)), np.outer(r, np.sin(angle)), w


def moved_rim(modes, i, radius, factor):
    """x, y (k + 1,) of the bottom edge displaced in the plane."""
    radial, tangential = factor * modes.rim_shape[i, :, 0], factor * modes.rim_shape[i, :, 1]
    c, s = np.cos(modes.rim_angle), np.sin(modes.rim_angle)
    x, y = (radius + radial) * c - tangential * s, (radius + radial) * s + tangential * c
    return np.append(x, x[0]), np.append(y, y[0])
