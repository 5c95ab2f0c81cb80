"""Compute the modes of a disk on a patch by finite elements and modal synthesis.

Synthesis is about ten times as accurate and provides frequencies with error estimates,
where applicable. Finite elements provide the mesh and the shapes for any patch. The two
methods use different discretisations and boundary conditions; if they do not find the
same modes, the result is that of the finite elements alone.
"""

from dataclasses import replace

import numpy as np
from scipy.optimize import linear_sum_assignment

from modal.accuracy import ACCURACY_LEVELS
from modal.elements import patch as elements
from modal.elements import sample
from modal.elements.elastic import lame_constants
from modal.elements.patch import SolvedSymmetryClass
from modal.elements.unfold import (
    bottom_and_top_interpolation,
    displacement_on_faces,
    whole_disk_modes,
)
from modal.mesh.sector import patch_height
from modal.modes import Modes, Support
from modal.progress import progress_range
from modal.spectral.basis import Plate
from modal.spectral.p_refinement import first_basis_size
from modal.synthesis.clamped import HeldSymmetryClass
from modal.synthesis.free_disk import FreeDisk
from modal.synthesis.tractions import MAX_HALF_ANGLE_DEG, BasisSizes

FREE_MODE_CUTOFF_RATIO = 2.0
"""Ratio of the highest frequency of the free modes used to that of the requested
modes."""


def synthesis_basis_sizes(accuracy: str) -> BasisSizes:
    """Return the minimum `BasisSizes` of the synthesis at an accuracy."""
    return BasisSizes(**ACCURACY_LEVELS[accuracy].basis_sizes)


def held_modes(plate: Plate, support: Support, below: float, accuracy: str) -> Modes:
    """Return the `Modes` of a solid disk on a patch below a frequency [Hz], see
    `eigenmodes`."""
    with progress_range(0.0, 0.4):
        known = synthesised_classes(plate, support, below, accuracy)
    with progress_range(0.4, 1.0):
        combined = known and modes_with_synthesised_frequencies(
            plate, support, below, accuracy, known
        )
    return combined or elements.held_modes(plate, support, below, accuracy)


def synthesised_classes(
    plate: Plate, support: Support, below: float, accuracy: str
) -> list[HeldSymmetryClass] | None:
    """Return each `HeldSymmetryClass`, or None if synthesis is not applicable."""
    max_cutoff = 4.0  # largest `BasisSizes.cutoff`
    min_sizes = synthesis_basis_sizes(accuracy)
    shear_speed = (lame_constants(plate.material)[1] / plate.density) ** 0.5
    waves = below * plate.radius / shear_speed
    is_low = patch_height(plate.thickness, support) < plate.thickness
    if is_low or support.half_angle_deg > MAX_HALF_ANGLE_DEG:
        return None
    if FREE_MODE_CUTOFF_RATIO * waves > max_cutoff:
        return None
    radial = max(min_sizes.size[0], 2 + first_basis_size(plate, below)[0])
    richness = replace(
        min_sizes,
        size=(radial, min_sizes.size[1]),
        cutoff=max(min_sizes.cutoff, FREE_MODE_CUTOFF_RATIO * waves),
    )
    full_height = replace(support, height=None)
    try:
        return FreeDisk(plate=plate, richness=richness).held(
            full_height, below, sample.rim_angles()
        )
    except (
        np.linalg.LinAlgError
    ):  # round-off exceeds the tractions of a foil or tiny patch
        return None


def modes_with_synthesised_frequencies(
    plate: Plate,
    support: Support,
    below: float,
    accuracy: str,
    known: list[HeldSymmetryClass],
) -> Modes | None:
    """Return the finite-element `Modes` with the frequencies of the synthesis, or
    None if the modes differ."""
    size = elements.resolving_mesh_size(
        elements.mesh_sizes(accuracy, plate, support)[0],
        plate,
        below,
    )
    selections: list[elements.Selection] = [
        {"below": np.inf, "exact_count": len(k.frequency) + 1} for k in known
    ]
    part, solid, solved = elements.solve_symmetry_classes(
        plate, support, size, selections
    )
    points, _ = sample.sample_points(plate.radius)
    rim = bottom_and_top_interpolation(solid, part, points), points
    top_rims = [displacement_on_faces(*rim, part.quarter, c)[:, 1] for c in solved]
    limit = (2 * np.pi * below) ** 2
    matched = []
    for three in zip(solved, known, top_rims, strict=True):
        element_class = match_modes_of_class(*three, limit)
        if element_class is None:
            return None
        matched.append(element_class)
    error = np.concatenate([k.error for k in known])
    modes = whole_disk_modes(part, solid, matched, error, plate)
    return replace(modes, method="finite elements, their frequencies by synthesis")


def match_modes_of_class(
    element_class: SolvedSymmetryClass,
    known: HeldSymmetryClass,
    top_rim: np.ndarray,
    limit: float,
) -> SolvedSymmetryClass | None:
    """Return the finite-element class with the frequencies of the synthesis, or None.

    The result is None if the modes do not match.

    `top_rim` (k, n, 3) is the displacement of the top edge in the element modes. An
    element mode matches a mode of the synthesis if its frequency is slightly higher and
    the rim motions are similar. Every mode of the synthesis and every element eigenvalue
    below `limit` [1/s^2] must have a match.
    """
    max_excess = 0.04  # of the frequency, as a fraction
    min_similarity = 0.9  # squared correlation of the rim motions
    values = element_class.values
    rim = sample.polar_components(top_rim, sample.rim_angles())
    element_rims, known_rims = (
        unit_rows(shape, rim[0].size) for shape in (rim, known.rim)
    )
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


def unit_rows(shapes: np.ndarray, size: int) -> np.ndarray:
    """Return shapes (k, n, 3) as rows (k, size) of unit length."""
    return (
        shapes.reshape(len(shapes), size) / np.linalg.norm(shapes, axis=(1, 2))[:, None]
    )
