"""DISK ON A PATCH -> MODES: shapes by finite elements, frequencies and their errors by synthesis where it applies.

Synthesis is some ten times nearer and knows how near it is; the elements have the mesh, the shapes and all patches. The
two share no mesh and no boundary condition, and must find the same modes: otherwise the elements alone answer.
"""

from dataclasses import replace

import numpy as np
from scipy.optimize import linear_sum_assignment

from modal.accuracy import LEVELS
from modal.elements import patch as elements
from modal.elements import sample
from modal.elements.elastic import lame
from modal.elements.unfold import face_matrices, on_faces, unfolded
from modal.mesh.sector import held_height
from modal.modes import Modes
from modal.spectral.converge import first_size
from modal.synthesis.patches import FreeDisk
from modal.synthesis.tractions import STANDARD, WIDEST

APART, MOST = 2.0, 4.0
"""Free modes are kept up to so many times the highest frequency sought, but not so many as `Richness.cutoff` of MOST
asks for."""
NEAR, ALIKE = 0.04, 0.9
"""A shape of the elements belongs to a frequency by synthesis if its own is no further above it, and if so much of the
square of the motion of the rim is the same."""


def richness_of(accuracy):
    """How much of everything synthesis has at an accuracy, at least."""
    return replace(STANDARD, **LEVELS[accuracy].richness)


def held_modes(plate, support, below, accuracy) -> Modes:
    """The `Modes` below `below` [Hz] of a solid disk on a patch, see `eigenmodes`."""
    known = synthesis(plate, support, below, accuracy)
    together = known and on_shapes(plate, support, below, accuracy, known)
    return together or elements.held_modes(plate, support, below, accuracy)


def synthesis(plate, support, below, accuracy):
    """The `HeldClass` of every symmetry class; None where the patch is not for synthesis, or too much is sought."""
    least, waves = richness_of(accuracy), below * plate.radius / (lame(plate.material)[1] / plate.density) ** 0.5
    part = held_height(plate.thickness, support) < plate.thickness
    if part or support.half_angle_deg > WIDEST or APART * waves > MOST:
        return None
    radial = max(least.size[0], 2 + first_size(plate, below)[0])
    richness = replace(least, size=(radial, least.size[1]), cutoff=max(least.cutoff, APART * waves))
    whole = replace(support, height=None)
    return FreeDisk(plate=plate, richness=richness).held(whole, below, sample.rim_angles())


def on_shapes(plate, support, below, accuracy, known):
    """The `Modes` of the mesh with the known frequencies; None if the two have not found the same modes."""
    size = elements.resolving(elements.meshes(accuracy, plate, support)[0], plate, below)
    which = [{"below": np.inf, "exactly": len(k.frequency) + 1} for k in known]
    part, solid, solved = elements.solve(plate, support, size, which)
    points, _ = sample.places(plate.radius)
    rim = face_matrices(solid, part, points), points
    rims = [on_faces(*rim, part.quarter, c)[:, 1] for c in solved]
    paired = [pair(*three, (2 * np.pi * below) ** 2) for three in zip(solved, known, rims, strict=True)]
    if None in paired:
        return None
    error = np.concatenate([k.error for k in known])
    modes = unfolded(part, solid, paired, error, plate)
    return replace(modes, method="finite elements, their frequencies by synthesis")


def pair(c, known, rim, limit):
    """The class with every known frequency on its shape; rim (k, n, 3) is the top edge's. None if a frequency has no
    shape, or a shape with an eigenvalue below limit [1/s^2] no frequency."""
    rim = sample.polar_components(rim, sample.rim_angles())
    flat = [a.reshape(len(a), rim[0].size) / np.linalg.norm(a, axis=(1, 2))[:, None] for a in (rim, known.rim)]
    alike = (flat[1] @ flat[0].T) ** 2
    mode, shape = linear_sum_assignment(-alike)
    above = np.sqrt(c.values[shape]) / (2 * np.pi * known.frequency) - 1
    strange = (alike[mode, shape] < ALIKE).any() or (above > NEAR).any() or (above < -known.error).any()
    if strange or (np.delete(c.values, shape) < limit).any():
        return None
    values = (2 * np.pi * known.frequency) ** 2
    return replace(c, values=values, shapes=c.shapes[shape], residual=c.residual[shape])
