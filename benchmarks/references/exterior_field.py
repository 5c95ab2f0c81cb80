"""Compute the sound field outside a solid disk above a baffle, and write its table,
sonify/sound/exterior_field.npz: python -m benchmarks.references.exterior_field

The upper face of the disk and the air that leaves the gap radiate sound. Lengths are in
units of the radius R, and pressures in units of density times R times acceleration.
Fields of azimuthal order n vary as exp(i w t), with k = w R/c. Finite elements in the
(r, z) half plane extend from the disk to a hemisphere, beyond which the field is a sum
of outgoing multipoles. Their amplitudes determine the pressure at every listener
outside the hemisphere. See tests/sound/test_open_film_sound.py."""

import numpy as np
from scipy.sparse import coo_matrix
from scipy.sparse.linalg import splu
from skfem import Basis, BilinearForm, ElementQuad2, FacetBasis, LinearForm, MeshQuad

from sonify.sound.film_radiation import (
    EXTERIOR_MEAN_GAPS,
    EXTERIOR_TABLE_FILE,
    EXTERIOR_WAVENUMBERS,
    MAX_RIM_ORDER,
    exterior_domain_radius,
)
from sonify.sound.multipoles import (
    associated_legendre,
    multipole_degrees,
    outgoing_hankel,
)

TABULATED_THICKNESSES = np.append(
    np.geomspace(0.021, 0.36, 12), np.linspace(0.42, 1.32, 16)
)
"""Ratios of thickness to radius."""


class ExteriorField:
    """Finite-element model of the air between a disk and a hemisphere of radius `far`.

    Attributes
    ----------
    loads : ndarray, shape (3, nodes)
        Load vectors of heave, tilt, and a unit volume flow per length of the rim.
    """

    def __init__(self, thickness: float, gap: float, far: float):
        self.far = far
        height = thickness + gap
        mesh = self._mesh(height, gap)
        self._basis = Basis(mesh, ElementQuad2())
        facets = mesh.boundary_facets()
        ends = mesh.p[:, mesh.facets[:, facets]]
        r, z = ends.mean(axis=1)
        on_rim = np.abs(r - 1) < 1e-9
        parts = (
            (np.abs(z - height) < 1e-9) & (r < 1),
            on_rim & (z > gap),
            on_rim & (z < gap),
            np.hypot(*ends).min(axis=0) > 0.999 * far,
        )
        face, side, outlet, self._hemisphere = (
            FacetBasis(mesh, ElementQuad2(), facets=facets[part]) for part in parts
        )
        self._axis = self._basis.get_dofs(facets[r < 1e-9]).all()
        self._forms = [
            form.assemble(self._basis)
            for form in (gradient_form, azimuthal_form, mass_form)
        ]
        load = boundary_load_form.assemble
        face_tilt = load(face, weight=quadrature_coordinates(face)[0])
        side_tilt = load(
            side, weight=quadrature_coordinates(side)[1] - gap - thickness / 2
        )
        self.loads = np.array(
            [
                load(face, weight=1.0),
                face_tilt - side_tilt,
                load(outlet, weight=1 / gap),
            ]
        )

    def _mesh(self, height, gap):
        face_cells = 14  # along the face of the disk
        radial_cells = 6  # between the disk and the hemisphere
        return exterior_mesh(height, gap, self.far, face_cells, radial_cells)

    def solve(self, n: int, wavenumbers) -> tuple[np.ndarray, np.ndarray]:
        """Solve for each load, multiplied by cos n theta, at wavenumbers k (a,).

        Returns
        -------
        at_rim : ndarray, shape (a, 3)
            Mean pressure at the outlet of the gap.
        multipoles : ndarray, shape (a, m, 3)
            Amplitudes on the hemisphere.
        """
        degree = multipole_degrees(n)
        stiffness, azimuthal, mass = self._forms
        r, z = quadrature_coordinates(self._hemisphere)
        shapes = associated_legendre(n, z / np.hypot(r, z))
        loads = [
            boundary_load_form.assemble(self._hemisphere, weight=w) for w in shapes
        ]
        waves = np.array(loads) / self.far**2
        on = np.flatnonzero(waves.any(axis=0))
        free = np.setdiff1d(np.arange(waves.shape[1]), self._axis if n else [])
        at_rim = []
        multipoles = []
        for k in wavenumbers:
            outgoing = (
                k
                * self.far**2
                * outgoing_hankel(degree, k * self.far, True)
                / outgoing_hankel(degree, k * self.far)
            )
            values = ((waves[:, on].T * outgoing) @ waves[:, on]).ravel()
            boundary = coo_matrix(
                (values, (np.repeat(on, len(on)), np.tile(on, len(on)))), mass.shape
            )
            matrix = stiffness + n * n * azimuthal - k * k * mass - boundary
            p = splu(matrix.tocsc()[free][:, free]).solve(
                self.loads.T[free].astype(complex)
            )
            at_rim.append(self.loads[2, free] @ p)
            multipoles.append(waves[:, free] @ p)
        return np.array(at_rim), np.array(multipoles)


def exterior_mesh(height, gap, far, face_cells, radial_cells):
    """Return a quadrilateral mesh of the air, refined at the edges of the disk."""
    half = height - (height - gap) / 2
    inwards = np.linspace(0, 1, face_cells + 1) ** 2
    low = int(np.ceil(np.log2(max((half - gap) / gap, 4.0)))) + 1
    sides = [
        height - (height - half) * np.linspace(0, 1, face_cells // 2 + 1)[1:] ** 2,
        gap + (half - gap) * (2.0 ** np.arange(low, -1, -1) - 1)[1:] / (2.0**low - 1),
        [gap / 2, 0.0],
    ]
    z = np.concatenate([np.full(face_cells + 1, height), *sides])
    r = np.minimum(np.append(1 - inwards[::-1], np.ones(len(z) - face_cells - 1)), 1.0)
    length = np.append(0.0, np.cumsum(np.hypot(np.diff(r), np.diff(z))))
    angle = np.pi / 4 * (2 - length / length[-1] - np.linspace(0, 1, len(z)))
    disk = np.array([r, z])[..., None]
    arc = far * np.array([np.cos(angle), np.sin(angle)])[..., None]
    part = np.linspace(0, 1, radial_cells + 1) ** 2.0
    grid = MeshQuad.init_tensor(
        np.arange(len(z), dtype=float), np.arange(radial_cells + 1, dtype=float)
    )
    along, across = np.rint(grid.p).astype(int)
    return MeshQuad(
        np.ascontiguousarray((disk * (1 - part) + arc * part)[:, along, across]), grid.t
    )


def quadrature_coordinates(basis):
    """Return the coordinates r and z of the quadrature points."""
    return np.asarray(basis.global_coordinates())


@BilinearForm
def gradient_form(p, q, w):
    return (p.grad[0] * q.grad[0] + p.grad[1] * q.grad[1]) * w.x[0]


@BilinearForm
def azimuthal_form(p, q, w):
    return p * q / w.x[0]


@BilinearForm
def mass_form(p, q, w):
    return p * q * w.x[0]


@LinearForm
def boundary_load_form(q, w):
    return w.weight * q * w.x[0]


def field_of_disk(thickness: float, gap: float) -> tuple[np.ndarray, np.ndarray]:
    """Return the field of a disk at EXTERIOR_WAVENUMBERS (k,).

    Thickness and gap are divided by the radius. The results are the pressures at the rim
    (k, MAX_RIM_ORDER + 1, 3) and the multipoles (k, MAX_RIM_ORDER + 1, m, 3), both
    without the heave of waves that are not of order 0 and the tilt of those that are not
    of order 1, which no motion of a rigid face excites.
    """
    field = ExteriorField(thickness, gap, exterior_domain_radius(thickness))
    orders = range(MAX_RIM_ORDER + 1)
    solutions = [field.solve(n, EXTERIOR_WAVENUMBERS) for n in orders]
    rim, multipoles = (np.stack(part, axis=1) for part in zip(*solutions, strict=True))
    for order in orders:
        for load in {0, 1} - {order}:
            rim[:, order, load] = 0.0
            multipoles[:, order, :, load] = 0.0
    return rim, multipoles


def write_table() -> None:
    """Write the fields at TABULATED_THICKNESSES and EXTERIOR_MEAN_GAPS."""
    fields = [
        [field_of_disk(thickness, gap) for gap in EXTERIOR_MEAN_GAPS]
        for thickness in TABULATED_THICKNESSES
    ]
    rim, multipoles = (
        np.array([[pair[part] for pair in gaps] for gaps in fields], np.complex64)
        for part in (0, 1)
    )
    np.savez_compressed(
        EXTERIOR_TABLE_FILE,
        thickness=TABULATED_THICKNESSES,
        rim=rim,
        multipoles=multipoles,
    )


if __name__ == "__main__":
    write_table()
