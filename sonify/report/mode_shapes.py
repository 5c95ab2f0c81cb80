"""Draw the mode shapes of disk and table."""

from typing import TYPE_CHECKING, Any, TypeGuard

import numpy as np
from matplotlib import colormaps
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.collections import PolyCollection
from matplotlib.figure import Figure
from matplotlib.patches import Arc, Circle
from matplotlib.tri import Triangulation

from modal.modes import Modes, Support
from sonify.report.lit_polygons import projected_mode_shape, surface_polygons
from sonify.report.mode_names import mode_caption

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from sonify.report.figure import PicturePath

MODES_PER_ROW = 5
MODE_WIDTH = 2.6  # this and the following lengths in disk radii
TOP_VIEW_HEIGHT = 2.5
CAPTION_HEIGHT = 0.6
MAX_DRAWN_DISPLACEMENT = 0.16
PICTURE_WIDTH = MODE_WIDTH * MODES_PER_ROW


def draw_colour_bars(
    axis: "Axes", y: float, scales: dict[str, tuple[int, str]]
) -> None:
    """Draw the colour bars of scales side by side, each with its minimum and colours."""
    for column, (label, (minimum, name)) in enumerate(scales.items()):
        place = 2.4 * MODE_WIDTH * (column - (len(scales) - 1) / 2)
        draw_colour_bar(axis, (PICTURE_WIDTH / 2 + place, y), label, minimum, name)


def draw_modes(
    modes: Modes,
    path: "PicturePath",
    slanted: bool = True,
    support: Support | None = None,
    moving: str = "",
    table: tuple[np.ndarray, np.ndarray, list[str], int] | None = None,
) -> None:
    """Write a picture of all modes, seen from above and, if `slanted`, in an oblique
    view.

    In the oblique view, colour shows the displacement. In the view from above, colour
    shows axial motion, solid black lines are its nodal lines, and the dashed line is
    the rim displaced in its plane. Displacements are to scale within each mode. If the
    disk has no modes, the picture contains a sentence to that effect.

    Parameters
    ----------
    modes : Modes
        Modes of the disk.
    path : path or file
        Destination; the suffix selects png, svg or pdf.
    slanted : bool
        If True, draw the oblique view of the whole body above the view from above.
    support : Support or None
        A green arc on the rim marks the patch of a patch support.
    moving : str
        Text on the change of the modes during the run, printed after the last mode.
    table : tuple or None
        Modes of the table, drawn below: points (p, 2), upward motion (n, p) of its top
        face, n captions, and the total number of modes.
    """
    oblique_height = 1.9 if slanted else 0.0
    mode_height = CAPTION_HEIGHT + oblique_height + TOP_VIEW_HEIGHT
    rows_height = mode_height * max(1, row_count(len(modes) + bool(moving)))
    table_height = 0.0
    if table:
        table_rows = row_count(len(table[2]))
        table_height = CAPTION_HEIGHT + table_rows * (CAPTION_HEIGHT + TOP_VIEW_HEIGHT)
    colour_bar_height = 0.95
    height = rows_height + table_height + CAPTION_HEIGHT + colour_bar_height
    bottom = -rows_height - table_height - colour_bar_height
    inches_per_radius = 0.95
    width = inches_per_radius * MODE_WIDTH * MODES_PER_ROW
    figure = Figure(figsize=(width, inches_per_radius * height), dpi=100)
    FigureCanvasAgg(figure)
    # single axes, because drawing axes takes as long as drawing a mode
    axis = figure.add_axes((0, 0, 1, 1))
    axis.set(xlim=(0, PICTURE_WIDTH), ylim=(bottom, CAPTION_HEIGHT))
    axis.set_axis_off()
    polygons = surface_polygons(modes.body) if slanted and len(modes) else np.empty(0)
    for i in range(len(modes)):
        x, y = cell_position(i, 0.0, mode_height)
        text = mode_caption(modes, i, support is not None and support.kind != "free")
        write(axis, x, y - 0.05, text)
        y -= CAPTION_HEIGHT
        if slanted:
            draw_oblique_view(axis, modes, polygons, i, (x, y - oblique_height / 2))
        y -= oblique_height
        draw_top_view(axis, modes, i, (x, y - TOP_VIEW_HEIGHT / 2), support)
    if moving:
        x, y = cell_position(len(modes), 0.0, mode_height)
        write(axis, x, y - 0.05, moving)
    if not len(modes):
        text = "There are no modes below the upper frequency limit."
        axis.text(PICTURE_WIDTH / 2, -mode_height / 2, text, ha="center")
    if table:
        draw_table_modes(axis, *table, -rows_height)
    write_heading(axis, CAPTION_HEIGHT / 2, picture_explanation(slanted, support))
    scales = {}
    if slanted and len(modes):
        scales["oblique view: displacement / its maximum"] = (0, "viridis")
    if table or len(modes):
        scales["from above: axial displacement / maximum"] = (-1, "RdBu_r")
    draw_colour_bars(axis, bottom + 0.62, scales)
    figure.savefig(path)


def row_count(modes: int) -> int:
    """Return the number of rows of a number of modes."""
    return -(-modes // MODES_PER_ROW)


def cell_position(i: int, top: float, height: float) -> tuple[float, float]:
    """Return the centre x and the upper end y of mode i in rows of `height` below `top`."""
    row, column = divmod(i, MODES_PER_ROW)
    return MODE_WIDTH * (column + 0.5), top - height * row


def write(axis: "Axes", x: float, y: float, text: str, **options: Any) -> None:
    """Write text below a point."""
    axis.text(x, y, text, ha="center", va="top", **options)


def write_heading(axis: "Axes", y: float, text: str) -> None:
    """Write text in the middle of the picture at a height."""
    axis.text(PICTURE_WIDTH / 2, y, text, fontsize=11, ha="center", va="center")


def picture_explanation(slanted: bool, support: Support | None) -> str:
    """Return the two-line explanation of the picture."""
    oblique = (
        "Oblique view: the deformed body, exaggerated; bright parts move most. "
        if slanted
        else ""
    )
    held = (
        "; green: the patch that holds the disk, about which it swings"
        if _on_patch(support)
        else ""
    )
    first = f"{oblique}From above: axial motion of the top face (colour)"
    return f"{first},\nnodal lines (black), in-plane displacement of the rim (dashed){held}"


def _on_patch(support: Support | None) -> TypeGuard[Support]:
    return support is not None and support.kind == "patch"


def draw_colour_bar(
    axis: "Axes", at: tuple[float, float], label: str, minimum: float, colours: str
) -> None:
    """Draw a colour bar from `minimum` to 1, with numbers and `label` below it.

    `at` (x, y) is the middle of its lower side.
    """
    x, y = at
    length = 2.0
    height = 0.16
    left = x - length / 2
    axis.imshow(
        np.linspace(0, 1, 256)[None],
        cmap=colours,
        extent=(left, left + length, y, y + height),
        aspect="auto",
        zorder=2,
    )
    for share in (0.0, 0.5, 1.0):
        number = f"{minimum + share * (1 - minimum):g}"
        write(axis, left + share * length, y - 0.05, number, fontsize=9)
    write(axis, x, y - 0.3, label)


def draw_oblique_view(
    axis: "Axes", modes: Modes, polygons: np.ndarray, i: int, at: tuple[float, float]
) -> None:
    """Draw the oblique view of mode i with its centre `at` (x, y) [disk radii]."""
    radius, _ = outer_and_hole_radius(modes)
    stretch = MAX_DRAWN_DISPLACEMENT * radius / np.abs(modes.body.displacement[i]).max()
    places, far, light = projected_mode_shape(modes.body, polygons, i, stretch)
    colour = colormaps["viridis"](far)
    colour[:, :3] *= light[:, None]
    axis.add_collection(
        PolyCollection(
            list(places / radius + at),
            facecolors=colour,
            edgecolors=colour,
            linewidths=0.4,
        ),
        autolim=False,
    )


def draw_table_modes(
    axis: "Axes",
    points: np.ndarray,
    face: np.ndarray,
    captions: list[str],
    count: int,
    top: float,
) -> None:
    """Draw the modes of a table from above, below the height `top`.

    Colour shows upward motion; black lines are nodal lines.
    """
    few = "" if len(face) == count else f", the lowest {len(face)} of {count}"
    text = f"Modes of the table{few}: upward motion of its top face (colour), nodal lines (black)"
    write_heading(axis, top - CAPTION_HEIGHT / 2, text)
    middle = (points.max(axis=0) + points.min(axis=0)) / 2
    x, y = ((points - middle) / np.abs(points - middle).max()).T
    triangles = Triangulation(x, y).triangles
    for i, (shape, text) in enumerate(zip(face, captions, strict=True)):
        at, head = cell_position(
            i, top - CAPTION_HEIGHT, CAPTION_HEIGHT + TOP_VIEW_HEIGHT
        )
        write(axis, at, head - 0.05, text)
        here = Triangulation(
            x + at, y + head - CAPTION_HEIGHT - TOP_VIEW_HEIGHT / 2, triangles
        )
        levels = np.linspace(-1, 1, 22)
        axis.tricontourf(here, shape / np.abs(shape).max(), levels, cmap="RdBu_r")
        axis.tricontour(here, shape, levels=[0.0], colors="black", linewidths=1.3)


def outer_and_hole_radius(modes: Modes) -> tuple[float, float]:
    """Return the outer radius and the hole radius [m] of the faces; the latter is 0 if
    there is no hole.

    The sum of the face weights is (R^2 - r^2)/2.
    """
    radius = np.hypot(*modes.body.points[:, :2].T).max()
    hole = radius**2 - 2 * modes.face_weight.sum()
    return radius, np.sqrt(hole) if hole > 1e-3 * radius**2 else 0.0


def draw_top_view(
    axis: "Axes", modes: Modes, i: int, at: tuple[float, float], support: Support | None
) -> None:
    """Draw mode i from above with its centre `at` (x, y) [disk radii].

    The view contains axial motion in colour, nodal lines, the rim at rest and
    displaced, and the patch.
    """
    radius, hole = outer_and_hole_radius(modes)
    x, y, w = top_face(modes, i, radius, hole)
    x = x / radius + at[0]
    y = y / radius + at[1]
    plane = modes.rim_shape[i, :, :2]
    scale = max(np.abs(w).max(), np.abs(plane).max())
    axis.contourf(x, y, w / scale, levels=np.linspace(-1, 1, 22), cmap="RdBu_r")
    if np.abs(w).max() > 0.1 * scale:
        axis.contour(x, y, w / scale, levels=[0.0], colors="black", linewidths=1.3)
    for r in (1.0, hole / radius):
        axis.add_patch(Circle(at, r, fill=False, color="0.3", lw=1))
    moved = displaced_rim(modes, i, MAX_DRAWN_DISPLACEMENT / scale)
    axis.plot(moved[0] + at[0], moved[1] + at[1], color="0.1", lw=1, ls=(0, (4, 2)))
    if _on_patch(support):
        reach = support.half_angle_deg
        axis.add_patch(
            Arc(at, 2, 2, theta1=-reach, theta2=reach, color="tab:green", lw=5)
        )


def top_face(
    modes: Modes, i: int, radius: float, hole: float
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return Cartesian grids x, y [m] and the axial motion w of the top face in mode i.

    The grids are periodic in angle and extend from the hole or the centre to the rim.
    """
    w = modes.face_shape[i, 1]
    at = modes.face_radius
    rim = w[-1] + (w[-1] - w[-2]) * (radius - at[-1]) / (at[-1] - at[-2])
    within = (
        w[0] + (w[1] - w[0]) * (hole - at[0]) / (at[1] - at[0])
        if hole
        else np.full(w.shape[1], w[0].mean())
    )
    w = np.vstack([within, w, rim])
    r = np.concatenate([[hole], at, [radius]])
    angle = np.append(modes.face_angle, 2 * np.pi)
    w = np.hstack([w, w[:, :1]])
    return np.outer(r, np.cos(angle)), np.outer(r, np.sin(angle)), w


def displaced_rim(modes: Modes, i: int, factor: float) -> tuple[np.ndarray, np.ndarray]:
    """Return the coordinates x, y (k + 1,) [disk radii] of the bottom edge displaced in
    its plane, a closed curve."""
    radial, tangential, _ = factor * modes.rim_shape[i].T
    c = np.cos(modes.rim_angle)
    s = np.sin(modes.rim_angle)
    x = (1 + radial) * c - tangential * s
    y = (1 + radial) * s + tangential * c
    return np.append(x, x[0]), np.append(y, y[0])
