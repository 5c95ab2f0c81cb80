"""Draw the disk on its table in perspective, with motion blur."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from PIL import Image, ImageDraw

from dynamics import Disk
from dynamics.contact_geometry import centre_height, contact_position, edge_profile
from sonify.sound.modal_forcing import in_patch_frame

SUPERSAMPLING = 2
"""Supersampling factor in each direction of the image."""
TABLE_COLOUR = (238, 236, 230)


@dataclass(frozen=True, kw_only=True)
class Camera:
    """Camera at `distance` [m] and `elevation` [rad] that looks at `target` (3,) [m].

    `focal` is the focal length [px] and `size` the width and height of the image [px].
    """

    target: np.ndarray
    distance: float
    elevation: float
    focal: float
    size: tuple[int, int]

    @cached_property
    def axes(self) -> np.ndarray:
        """Unit vectors to the right, up and towards the camera, (3, 3)."""
        c = np.cos(self.elevation)
        s = np.sin(self.elevation)
        return np.array([[1.0, 0, 0], [0, s, c], [0, -c, s]])

    @property
    def position(self) -> np.ndarray:
        """Position of the camera (3,) [m]."""
        return self.target + self.distance * self.axes[2]

    def project(self, points) -> np.ndarray:
        """Project points (..., 3) [m] in front of the camera to image positions (...,
        2) [px].

        The origin of the image is its upper left corner.
        """
        right, up, near = np.moveaxis((points - self.target) @ self.axes.T, -1, 0)
        scale = self.focal / (self.distance - near)
        return np.stack(
            [self.size[0] / 2 + right * scale, self.size[1] / 2 - up * scale], axis=-1
        )


def patch_frame(state, inclination) -> np.ndarray:
    """Return the axes (k, 3, 3) of the patch frame for states (k, 11); (2.1).

    The x axis points to the contact, and the z axis is the axis of the disk.
    """
    c = np.cos(state[:, 0])
    s = np.sin(state[:, 0])
    zero = 0 * inclination
    table = [(c, -s, zero), (s, c, zero), (zero, zero, 1 + zero)]
    return np.stack(
        [in_patch_frame(np.stack(axis, axis=1), inclination) for axis in table], axis=2
    )


def contact_points(state, disk: Disk, fillet: float = 0.0) -> np.ndarray:
    """Return the contact points (k, 3) [m] on the table for states (k, 11)."""
    position = contact_position(state, disk, fillet)
    return np.column_stack([position, np.zeros(len(position))])


def rim_points(state, disk: Disk, fillet: float = 0.0) -> np.ndarray:
    """Return body-fixed points (k, r, n, 3) [m] of r rings, drawn as polygons.

    The rings are ordered from the lower to the upper face; a sharp edge is one ring."""
    side_count = 96
    x, y, z = patch_frame(state, state[:, 1]).swapaxes(0, 1)
    angle = state[:, 2, None] + np.arange(side_count) * 2 * np.pi / side_count
    rim = np.einsum("kn,ki->kni", np.cos(angle), x)
    rim += np.einsum("kn,ki->kni", np.sin(angle), y)
    height = centre_height(state[:, 1], disk, fillet)
    centre = np.column_stack([state[:, 3:5], height])
    edge = edge_profile(disk, fillet, segments=2)
    radius, level = np.concatenate([edge * [1, -1], edge[::-1]]).T
    return (
        centre[:, None, None]
        + radius[:, None, None] * rim[:, None]
        + level[:, None, None] * z[:, None, None]
    )


def draw_table(camera, radius: float) -> Image.Image:
    """Return the image of the empty table.

    Circles of one, two and three times `radius` [m] are centred below the target of the
    camera.
    """
    grid_colour = (205, 202, 195)
    image = Image.new("RGB", supersampled_size(camera), TABLE_COLOUR)
    angle = np.linspace(0, 2 * np.pi, 361)
    circle = np.column_stack([np.cos(angle), np.sin(angle), 0 * angle]) * radius
    for size in (1, 2, 3):
        middle = np.append(camera.target[:2], 0.0)
        line = image_polygon(camera, middle + size * circle)
        ImageDraw.Draw(image).line(line, grid_colour, SUPERSAMPLING)
    return image


def supersampled_size(camera) -> tuple[int, int]:
    """Return width and height [px] of the image before it is reduced."""
    width, height = camera.size
    return SUPERSAMPLING * width, SUPERSAMPLING * height


def draw_blurred_disk(camera, empty, bodies, hole: float = 0.0) -> np.ndarray:
    """Return the mean image (h, w, 3) of the disk on the `empty` table.

    `bodies` (s, r, n, 3) [m] contains the rings of `rim_points` at s instants. `hole`
    is the radius of the hole of a hoop divided by that of the faces.
    """
    total = np.zeros((*camera.size[::-1], 3), np.uint32)
    for body in bodies:
        image = empty.copy()
        _draw_body(ImageDraw.Draw(image), camera, body, hole)
        total += np.asarray(image.reduce(SUPERSAMPLING))
    return (total // len(bodies)).astype(np.uint8)


def draw_trace(camera, image, path) -> Image.Image:
    """Return an image (h, w, 3) with a path (p, 3) [m] drawn over it.

    Objects in front of the path do not hide it.
    """
    colour = (0, 60, 140)
    line = Image.new("L", supersampled_size(camera))
    if len(path) > 1:
        ImageDraw.Draw(line).line(image_polygon(camera, path), 255, 2 * SUPERSAMPLING)
    return Image.composite(
        Image.new("RGB", camera.size, colour),
        Image.fromarray(image),
        line.reduce(SUPERSAMPLING),
    )


def _draw_sides(pen, camera, body, mark_colours):
    """Draw the sides between successive rings of the body that face the camera.

    The first sides of each strip have the `mark_colours`.
    """
    corners = camera.project(body)
    for ring in range(len(body) - 1):
        lower, upper = body[ring : ring + 2]
        outward = np.cross(np.roll(lower, -1, axis=0) - lower, upper - lower)
        facing = np.einsum("ni,ni->n", outward, camera.position - lower) > 0
        colours = face_grey_levels(outward)
        colours[: len(mark_colours)] = mark_colours
        for i in np.flatnonzero(facing):
            j = (i + 1) % len(lower)
            side = np.concatenate([corners[ring, [i, j]], corners[ring + 1, [j, i]]])
            pen.polygon((side * SUPERSAMPLING).ravel().tolist(), colours[i])


def _draw_body(pen, camera, body, hole):
    """Draw the shadow directly below the body and the surfaces that face the camera.

    The body is convex, so these surfaces do not overlap.
    """
    shadow_colour = (190, 187, 180)
    mark_colour = (160, 20, 40)
    marked_sides = 5  # they make the rotation visible
    for rim in body:
        pen.polygon(image_polygon(camera, rim * [1.0, 1.0, 0.0]), shadow_colour)
    _draw_sides(pen, camera, body, [mark_colour] * marked_sides)
    lower, upper = body[[0, -1]]
    middle = body[[0, -1]].mean(axis=1)
    axis = middle[1] - middle[0]
    top = np.dot(axis, camera.position - middle[1]) > 0
    if not top and np.dot(axis, camera.position - middle[0]) > 0:
        return
    face, centre, normal = (
        (upper, middle[1], axis) if top else (lower, middle[0], -axis)
    )
    pen.polygon(image_polygon(camera, face), face_grey_levels(normal[None])[0])
    if hole:
        inner_rim = centre + hole * (face - centre)
        pen.polygon(image_polygon(camera, inner_rim), shadow_colour)
    outer = face[: marked_sides + 1]
    inner = centre + max(0.6, hole) * (outer - centre)
    mark = np.concatenate([outer, inner[::-1]])
    pen.polygon(image_polygon(camera, mark), mark_colour)


def face_grey_levels(normals):
    """Return the colours (grey levels) of faces with normals (n, 3)."""
    light = np.array([0.35, -0.45, 0.82])
    lit = normals @ light / np.linalg.norm(normals, axis=1) / np.linalg.norm(light)
    return [(g, g, g) for g in (90 + 110 * np.maximum(lit, 0)).astype(int).tolist()]


def image_polygon(camera, points):
    return (camera.project(points) * SUPERSAMPLING).ravel().tolist()
