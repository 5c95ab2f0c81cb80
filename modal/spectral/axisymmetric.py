"""The record of the modes of an axisymmetric solid: every order n >= 1 gives a degenerate (cosine, sine) pair."""

from math import pi

import numpy as np

from modal.accuracy import LEVELS
from modal.elements import sample
from modal.elements.unfold import whole_mesh
from modal.mesh.half_disk import Blocks, divided
from modal.mesh.half_disk import columns as columns_of_ring
from modal.mesh.sector import extrude, hexahedra, sector
from modal.modes import Modes, Support
from modal.spectral.basis import Plate
from modal.spectral.converge import Pairs, all_pairs, amplitudes
from modal.spectral.ritz import gauss


def turned(amplitude, n, angle, odd):
    """Displacement (..., 3) (cylindrical) at angles (q,) from amplitudes (3, ..., q), or of the sine partner."""
    c, s = np.cos(n * angle), np.sin(n * angle)
    factors = (s, -c, s) if odd else (c, s, c)
    return np.stack([a * f for a, f in zip(amplitude, factors, strict=True)], axis=-1)


def parities(pairs: Pairs):
    """For each member of a pair whether it is the sine partner, as torsion with its u_theta even in theta always is."""
    return (False, True) if pairs.problem.n else (pairs.problem.family == "torsional",)


def participation_of(plate, pairs):
    """Participation (k, 6) of the cosine member, see `Modes`."""
    n = pairs.problem.n
    rho, zeta, along, through = gauss(plate, n, pairs.size)
    a, b, w = amplitudes(plate, pairs, rho, zeta)
    weight = plate.density * np.outer(along, through)
    r, h, zero = rho[:, None] * plate.radius, zeta * plate.thickness / 2, 0 * a
    if n == 0:
        work = [zero, zero, w, zero, zero, r * b]
    else:
        work = [a - b, zero, zero, zero, h * (a - b) - r * w, zero] if n == 1 else [zero] * 6
    return np.einsum("fkrz,rz->kf", work, weight)


def columns(plate, pairs, odd, body):
    """The columns of `Modes` that one problem contributes, arrays (k, ...)."""
    p, n, k = pairs.problem, pairs.problem.n, len(pairs.values)
    family = p.family if p.family == "torsional" else "extensional" if p.even > 0 else "flexural"
    participation = participation_of(plate, pairs)
    if odd:
        participation = participation[:, [1, 0, 2, 4, 3, 5]] * [1, 1, 1, -1, 1, -1]
    angle = sample.rim_angles()
    rim = amplitudes(plate, pairs, np.ones(1), -np.ones(1))[..., 0]
    r, _, theta = sample.face_grid(1.0, plate.hole)
    faces = amplitudes(plate, pairs, r, np.array([-1.0, 1.0]))[2].transpose(0, 2, 1)
    around = np.sin(n * theta) if odd else np.cos(n * theta)
    body_angle, (rho, at_rho), (zeta, at_zeta) = body
    inside = amplitudes(plate, pairs, rho, zeta)[..., at_rho, at_zeta]
    return {
        "frequency": np.sqrt(pairs.values) / (2 * pi),
        "order": np.full(k, n),
        "family": np.full(k, family),
        "parity": np.full(k, "odd" if odd else "even"),
        "pair": np.arange(k),
        "participation": participation,
        "rim_shape": turned(np.broadcast_to(rim, (3, k, len(angle))), n, angle, odd),
        "face_shape": faces[..., None] * around,
        "residual": pairs.residual,
        "error": pairs.error.sum(axis=0),
        "displacement": sample.polar_components(turned(inside, n, body_angle, odd), -body_angle),  # back to x, y, z
    }


def body_mesh(plate, highest):
    """Nodes (p, 3) and cells of the whole plate, fine enough to draw waves of the highest order; and of the nodes the
    angles (p,), and the distinct radii and heights, each with indices (p,) into them."""
    size = Blocks(width=pi / 8, depth=0.38, rings=1, split=1 + highest // 6)
    if plate.hole:
        half = divided(columns_of_ring(np.linspace(0, pi, 17), 1 - plate.hole), size) * plate.radius
        mesh = hexahedra(extrude(half, np.linspace(0, plate.thickness / 2, size.split + 1)))
    else:
        mesh = sector(plate.radius, plate.thickness, Support(kind="free"), size).mesh
    points, cells, _ = whole_mesh(mesh.doflocs.T, mesh.dofs.element_dofs.T, quarter=True)
    x, y, z = points.T
    rho = np.clip(np.hypot(x, y) / plate.radius, plate.hole, 1).round(12)
    zeta = np.clip(2 * z / plate.thickness, -1, 1).round(12)
    return points, cells, (np.arctan2(y, x), *(np.unique(part, return_inverse=True) for part in (rho, zeta)))


def plate_modes(plate: Plate, below: float, accuracy: str = "standard") -> Modes:
    """The `Modes` below `below` [Hz] of an axisymmetric plate; there may be none."""
    limit, found = below, []
    while not found:
        found = all_pairs(plate, limit, LEVELS[accuracy].free)
        limit *= 2
    points, cells, body = body_mesh(plate, max(pairs.problem.n for pairs in found))
    parts = []
    for number, pairs in enumerate(found):
        for odd in parities(pairs):
            part = columns(plate, pairs, odd, body)
            parts.append(part | {"pair": 1000 * number + part["pair"]})
    whole = {name: np.concatenate([part[name] for part in parts]) for name in parts[0]}
    whole = {name: value[whole["frequency"] < below] for name, value in whole.items()}
    return sample.recorded(
        whole,
        plate.material,
        plate.radius,
        points,
        cells,
        plate.inner_radius,
        mass=plate.mass,
        method="Fourier and polynomials",
        unknowns=sum(len(pairs.vectors) for pairs in found),
    )
