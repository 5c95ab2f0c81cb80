"""Pictures of the mode shapes."""

import numpy as np
from matplotlib import colormaps
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.collections import PolyCollection
from matplotlib.figure import Figure
from matplotlib.patches import Arc, Circle

from .modes import Modes
from .solid_view import skin, view

COLUMNS = 5
STRETCH = 0.16
"""Largest drawn displacement over the radius, of the rim seen from above."""


def draw_modes(modes: Modes, path) -> None:
    """Write a picture (png, svg, pdf by suffix) of every mode, the whole body at a slant over what is seen from above.

    At a slant colour is how far a point moves; from above it is axial motion, black its nodal lines, dashed the rim
    moved in its plane. All are to scale within a mode. A disk without modes gives a picture that says so.
    """
    rows = max(1, -(-len(modes) // COLUMNS))
    figure = Figure(figsize=(3.1 * COLUMNS, 5.6 * rows + 1.1), dpi=90)
    FigureCanvasAgg(figure)
    heights = [1.0, 1.25] * rows
    axes = figure.subplots(2 * rows, COLUMNS, squeeze=False, height_ratios=heights)
    for axis in axes.ravel():
        axis.set_axis_off()
    polygons = skin(modes.body) if len(modes) else None
    for i in range(len(modes)):
        row, column = divmod(i, COLUMNS)
        draw_solid(axes[2 * row, column], modes, polygons, i)
        draw(axes[2 * row + 1, column], modes, i)
    if not len(modes):
        figure.text(0.5, 0.45, "no mode below the highest frequency asked for", ha="center", fontsize=14)
    figure.suptitle(
        "Modes of the disk. At a slant: exaggerated, bright where it moves most; the patch is to the right.\n"
        "From above: axial motion of the top face (colour), nodal lines (black), rim (dashed), patch (green)"
    )
    figure.tight_layout(rect=(0, 0, 1, 0.99))
    figure.savefig(path)


def draw_solid(axis, modes, polygons, i):
    """One mode at a slant, with its title."""
    radius, _ = edges(modes)
    stretch = STRETCH * radius / np.abs(modes.body.displacement[i]).max()
    places, far, light = view(modes.body, polygons, i, stretch)
    colour = colormaps["viridis"](far)
    colour[:, :3] *= light[:, None]
    axis.add_collection(PolyCollection(places, facecolors=colour, edgecolors=colour, linewidths=0.4))
    axis.set_aspect("equal")
    axis.set(xlim=(-1.2 * radius, 1.2 * radius), ylim=(-0.95 * radius, 0.95 * radius))
    axis.set_title(caption(modes, i), fontsize=10)


def edges(modes):
    """Radius of the rim and of the hole, 0 if there is none, of the faces [m]: the weights add up to (R^2 - r^2)/2."""
    radius = np.hypot(*modes.body.points[:, :2].T).max()
    hole = radius**2 - 2 * modes.face_weight.sum()
    return radius, np.sqrt(hole) if hole > 1e-3 * radius**2 else 0.0


def draw(axis, modes, i):
    """One mode from above: colour map, nodal lines, rim at rest and displaced."""
    radius, hole = edges(modes)
    x, y, w = top_face(modes, i, radius, hole)
    plane = modes.rim_shape[i, :, :2]
    scale = max(np.abs(w).max(), np.abs(plane).max())
    axis.contourf(x, y, w / scale, levels=np.linspace(-1, 1, 21), cmap="RdBu_r")
    if np.abs(w).max() > 0.1 * scale:
        axis.contour(x, y, w / scale, levels=[0.0], colors="black", linewidths=1.3)
    for r in (radius, hole):
        axis.add_patch(Circle((0, 0), r, fill=False, color="0.3", lw=1))
    axis.plot(*moved_rim(modes, i, radius, STRETCH * radius / scale), color="0.1", lw=1, ls=(0, (4, 2)))
    held = modes.rim_angle[np.abs(modes.rim_shape).max(axis=(0, 2)) < 1e-9 * np.abs(modes.rim_shape).max()]
    if len(held):
        reach = np.rad2deg(np.abs(np.angle(np.exp(1j * held))).max())
        axis.add_patch(Arc((0, 0), 2 * radius, 2 * radius, theta1=-reach, theta2=reach, color="tab:green", lw=5))
    axis.set_aspect("equal")
    axis.set(xlim=(-1.25 * radius, 1.25 * radius), ylim=(-1.25 * radius, 1.25 * radius))


def caption(modes, i):
    """Number, frequency, family, order and T60 of mode i."""
    time = f", T60 {modes.decay_time[i]:.2g} s" if modes.decay_rate[i] > 0 else ""
    pair = f"{modes.parity[i]}, " if modes.partner[i] >= 0 else ""
    return f"{i + 1}: {modes.frequency[i]:.0f} Hz{time}\n{modes.family[i]}, {pair}order {modes.order[i]}"


def top_face(modes, i, radius, hole):
    """Cartesian grids x, y and axial motion w of the top face, closed around, up to the rim and the centre or hole."""
    w, at = modes.face_shape[i, 1], modes.face_radius
    rim = w[-1] + (w[-1] - w[-2]) * (radius - at[-1]) / (at[-1] - at[-2])
    within = w[0] + (w[1] - w[0]) * (hole - at[0]) / (at[1] - at[0]) if hole else np.full(w.shape[1], w[0].mean())
    w = np.vstack([within, w, rim])
    r = np.concatenate([[hole], at, [radius]])
    angle = np.append(modes.face_angle, 2 * np.pi)
    w = np.hstack([w, w[:, :1]])
    return np.outer(r, np.cos(angle)), np.outer(r, np.sin(angle)), w


def moved_rim(modes, i, radius, factor):
    """x, y (k + 1,) of the bottom edge displaced in the plane."""
    radial, tangential = factor * modes.rim_shape[i, :, 0], factor * modes.rim_shape[i, :, 1]
    c, s = np.cos(modes.rim_angle), np.sin(modes.rim_angle)
    x, y = (radius + radial) * c - tangential * s, (radius + radial) * s + tangential * c
    return np.append(x, x[0]), np.append(y, y[0])
