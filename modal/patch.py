"""Modes of a disk on a patch: shapes by finite elements, frequencies and their errors by synthesis
where it applies.

Synthesis is about ten times as accurate and estimates its own error; finite elements provide the
mesh and the shapes, and treat every patch. The two share neither mesh nor boundary condition and
must find the same modes; otherwise the result is that of the finite elements alone.
"""

from dataclasses import replace

import numpy as np
from scipy.optimize import linear_sum_assignment

from modal.accuracy import ACCURACY_LEVELS
from modal.elements import patch as elements
from modal.elements import sample
from modal.elements.elastic import lame_constants
from modal.elements.unfold import displacement_on_faces, face_interpolation_pair, whole_disk_modes
from modal.mesh.sector import patch_height
from modal.modes import Modes
from modal.progress import portion
from modal.spectral.p_refinement import first_basis_size
from modal.synthesis.free_disk import FreeDisk
from modal.synthesis.tractions import DEFAULT_BASIS_SIZES, MAX_HALF_ANGLE_DEG

FREE_MODE_FREQUENCY_RATIO = 2.0
"""Free modes are kept up to this multiple of the highest frequency wanted."""


def synthesis_richness(accuracy):
    """Return the smallest `Richness` of the synthesis at an accuracy."""
    return replace(DEFAULT_BASIS_SIZES, **ACCURACY_LEVELS[accuracy].richness)


def held_modes(plate, support, below, accuracy) -> Modes:
    """Return the `Modes` below `below` [Hz] of a solid disk on a patch, see `eigenmodes`."""
    with portion(0.0, 0.4):
        known = synthesised_classes(plate, support, below, accuracy)
    with portion(0.4, 1.0):
        combined = known and combined_modes(plate, support, below, accuracy, known)
    return combined or elements.held_modes(plate, support, below, accuracy)


def synthesised_classes(plate, support, below, accuracy, max_cutoff=4.0):
    """Return the `HeldClass` of every symmetry class; None if synthesis does not treat the patch or
    the frequencies.

    `max_cutoff` is the largest `Richness.cutoff`.
    """
    least = synthesis_richness(accuracy)
    shear_speed = (lame_constants(plate.material)[1] / plate.density) ** 0.5
    waves = below * plate.radius / shear_speed
    is_low = patch_height(plate.thickness, support) < plate.thickness
    if is_low or support.half_angle_deg > MAX_HALF_ANGLE_DEG:
        return None
    if FREE_MODE_FREQUENCY_RATIO * waves > max_cutoff:
        return None
    radial = max(least.size[0], 2 + first_basis_size(plate, below)[0])
    richness = replace(
        least,
        size=(radial, least.size[1]),
        cutoff=max(least.cutoff, FREE_MODE_FREQUENCY_RATIO * waves),
    )
    full_height = replace(support, height=None)
    return FreeDisk(plate=plate, richness=richness).held(full_height, below, sample.rim_angles())


def combined_modes(plate, support, below, accuracy, known):
    """Return the `Modes` of the mesh with the frequencies of the synthesis; None if the two differ
    in their modes."""
    size = elements.resolving_mesh_size(
        elements.mesh_sizes(accuracy, plate, support)[0],
        plate,
        below,
    )
    selections = [{"below": np.inf, "exact_count": len(k.frequency) + 1} for k in known]
    part, solid, solved = elements.solve_classes(plate, support, size, selections)
    points, _ = sample.sample_points(plate.radius)
    rim = face_interpolation_pair(solid, part, points), points
    top_rims = [displacement_on_faces(*rim, part.quarter, c)[:, 1] for c in solved]
    limit = (2 * np.pi * below) ** 2
    matched = [match_class(*three, limit) for three in zip(solved, known, top_rims, strict=True)]
    if None in matched:
        return None
    error = np.concatenate([k.error for k in known])
    modes = whole_disk_modes(part, solid, matched, error, plate)
    return replace(modes, method="finite elements, their frequencies by synthesis")


def match_class(element_class, known, top_rim, limit, max_excess=0.04, min_similarity=0.9):
    """Return the element class with the frequencies of the synthesis, each on its shape; None
    without a match.

    top_rim (k, n, 3) is the displacement of the top edge in the element modes. A shape belongs to a
    frequency if its own frequency is higher by at most `max_excess` (relative) and the squared
    correlation of the two motions of the rim is at least `min_similarity`. There is no match if a
    frequency has no shape, or if an element eigenvalue below `limit` [1/s^2] has no frequency.
    """
    values = element_class.values
    rim = sample.polar_components(top_rim, sample.rim_angles())
    element_rims, known_rims = (unit_rows(shape, rim[0].size) for shape in (rim, known.rim))
    similarity = (known_rims @ element_rims.T) ** 2
    mode, shape = linear_sum_assignment(-similarity)
    excess = np.sqrt(values[shape]) / (2 * np.pi * known.frequency) - 1
    if (similarity[mode, shape] < min_similarity).any():
        return None
    if (excess > max_excess).any() or (excess < -known.error).any():
        return None
    if (np.delete(values, shape) < limit).any():
        return None
    return replace(
        element_class,
        values=(2 * np.pi * known.frequency) ** 2,
        shapes=element_class.shapes[shape],
        residual=element_class.residual[shape],
    )


def unit_rows(shapes, size):
    """Return shapes (k, n, 3) as rows (k, size) of length 1."""
    return shapes.reshape(len(shapes), size) / np.linalg.norm(shapes, axis=(1, 2))[:, None]
