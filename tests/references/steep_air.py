"""What the normal force of a contact radiates of a steep disk over a rigid table, without film or
losses, by NGSolve: curved tetrahedra of degree 3 within a hemisphere, finer in the wedge, joined to
outgoing multipoles; it prints steep_air.json. Lengths are over the radius, pressures over density
and radius; half of the air, its mirror is y = 0."""

import json

import ngsolve as ng
import numpy as np
from netgen.meshing import MeshingParameters
from netgen.occ import Axis, Box, Cylinder, OCCGeometry, Pnt, Sphere, Vec
from ngsolve import ds, dx, grad, x, y, z
from scipy.special import gammaln, lpmv, spherical_jn, spherical_yn

RADIUS, NUMBERS = 0.03755, (0.3, 0.7, 1.0, 1.2, 1.4, 1.7, 2.0, 2.5, 3.2, 4.0, 5.0)
TOY, COIN, STONE = (0.0128 / 0.03755, 1.6 / 37.55), (0.1, 0.03), (0.8, 1.6 / 37.55)
"""Height and fillet of three disks, over the radius: the toy, a thinner and a thicker one."""
INCLINATIONS = {
    TOY: (0.1, 0.2, 0.35, 0.6),
    COIN: (0.2, 0.35, 0.6),
    STONE: (0.2, 0.35, 0.6),
}
CLEAR = {0.1: 0.001, 0.2: 0.003, 0.35: 0.003, 0.6: 0.003}
"""Height of the lowest point over the table, by inclination [rad].

A third of it changes the level by 0.8 dB at 0.1 rad, half of it by 0.12 dB at 0.35 rad.
"""
FAR, CELL, ORDER, DEGREES = 1.8, 0.55, 3, 9
SHIFTS, LEVELS = (1.3, 3.3), 3
"""Wavenumbers of the factorised systems, and powers of the inverse that span the solutions between
them."""


def disk(height, fillet, beta, clear):
    """Return the disk, with its lowest point at x < 0 and its centre above the origin, and the
    height of the centre."""
    body = Cylinder(Pnt(0, 0, 0), Vec(0, 0, 1), 1.0, height)
    body = body.MakeFillet(body.edges, fillet).Rotate(
        Axis(Pnt(0, 0, 0), Vec(0, -1, 0)), np.degrees(beta)
    )
    low = fillet * np.cos(beta) - (1 - fillet) * np.sin(beta) - fillet
    centre = height / 2 * np.cos(beta) - low + clear
    return body.Move(Vec(height / 2 * np.sin(beta), 0, clear - low)), centre


def meshed(body, gaps=(), least=0.02):
    """Return the mesh of the air round a body.

    Cells below the body are twice as large as the gap, given by places and gaps (x, y, gap).
    """
    body.faces.name = "body"
    ball = Sphere(Pnt(0, 0, 0), FAR)
    ball.faces.name = "far"
    how = MeshingParameters(
        maxh=CELL, grading=0.4, segmentsperedge=1, curvaturesafety=1.0
    )
    for px, py, gap in gaps:
        if max(2 * gap, least) < CELL:
            how.RestrictH(x=px, y=py, z=gap / 2, h=max(2 * gap, least))
    half = Box(Pnt(-9, 0, 0), Pnt(9, 9, 9))
    mesh = ng.Mesh(OCCGeometry(ball * half - body).GenerateMesh(mp=how))
    return mesh.Curve(ORDER)


def wedge(height, beta, centre):
    """Return places and gaps (x, y, gap) below the disk."""
    s = np.sin(beta)
    c = np.cos(beta)
    places = [
        (u, v)
        for u in np.linspace(-1, 1, 161)
        for v in np.linspace(0, 1, 81)
        if u * u + v * v <= 1
    ]
    return [
        (u * c + height / 2 * s, v, u * s - height / 2 * c + centre) for u, v in places
    ]


def size(degree, n):
    """Return the factor that normalises a spherical harmonic to mean square 1."""
    return np.sqrt(
        (2 * degree + 1)
        * (2 - (n == 0))
        * np.exp(gammaln(degree - n + 1) - gammaln(degree + n + 1))
    )


WAVES = [
    (degree, n)
    for degree in range(DEGREES + 1)
    for n in range(degree % 2, degree + 1, 2)
]


def harmonic(degree, n):
    """Return a harmonic on the hemisphere that is even in z and y, as a polynomial."""
    legendre = np.polynomial.legendre.leg2poly([0] * degree + [1])
    value = ng.CF(0)
    wave = (ng.CF(1), ng.CF(0))
    for a in (np.polynomial.polynomial.polyder(legendre, n) if n else legendre)[::-1]:
        value = value * z / FAR + float(a)
    for _ in range(n):
        wave = (wave[0] * x - wave[1] * y) / FAR, (wave[0] * y + wave[1] * x) / FAR
    return (-1) ** n * size(degree, n) * value * wave[0]


def hankel(degree, k, slope=False):
    """Return the outgoing spherical Hankel function for the time factor exp(i w t)."""
    return spherical_jn(degree, k, slope) - 1j * spherical_yn(degree, k, slope)


def times(matrix, rows):
    """Return the products (k, n) of a matrix with the rows (k, n)."""
    given = matrix.CreateRowVector()
    out = []
    for row in rows:
        given.FV().NumPy()[:] = row
        out.append((matrix * given).Evaluate().FV().NumPy().copy())
    return np.array(out)


def reduced_basis(forms, mass, loads):
    """Return orthonormal rows that span the answers to the loads near the shifts."""
    basis = np.zeros((0, loads.shape[1]))
    for shift in SHIFTS:
        matrix = (
            ng.BilinearForm(forms[0] - shift**2 * forms[1], symmetric=True)
            .Assemble()
            .mat
        )
        inverse = matrix.Inverse(inverse="sparsecholesky")
        rows = loads
        for _ in range(LEVELS):
            new = times(inverse, rows)
            for _ in range(2):
                new = new - (new @ basis.T) @ basis
            _, singular, new = np.linalg.svd(new, full_matrices=False)
            new = new[singular > 1e-9 * singular[0]]
            basis = np.vstack([basis, new])
            rows = times(mass, new)
    return basis


def multipoles(mesh, accelerations, numbers):
    """Return the multipole amplitudes (k, waves, a) on the hemisphere for accelerations of the
    body."""
    space = ng.H1(mesh, order=ORDER)
    normal = ng.specialcf.normal(3)
    p, q = space.TnT()

    def load(form):
        return ng.LinearForm(form).Assemble().vec.FV().NumPy().copy()

    loads = [load(-(ng.CF(a) * normal) * q * ds("body")) for a in accelerations]
    loads += [
        load(harmonic(*wave) * q * ds("far", bonus_intorder=DEGREES + 4)) / FAR**2
        for wave in WAVES
    ]
    loads = np.array(loads)
    forms = [grad(p) * grad(q) * dx, p * q * dx]
    stiff, mass = (
        ng.BilinearForm(form, symmetric=True).Assemble().mat for form in forms
    )

    basis = reduced_basis(forms, mass, loads)
    K = basis @ times(stiff, basis).T
    M = basis @ times(mass, basis).T
    B = loads @ basis.T
    degree = np.array(WAVES)[:, 0]
    found = []
    of = len(accelerations)
    for k in numbers:
        G = B[of:] @ np.linalg.solve(K - k * k * M, B.T)
        outwards = (
            FAR**2 / np.pi * k * hankel(degree, k * FAR, True) / hankel(degree, k * FAR)
        )
        found.append(
            np.linalg.solve(np.eye(len(degree)) - G[:, of:] * outwards, G[:, :of])
            / np.pi
        )
    return np.array(found)


def heard(amplitudes, k, distance, elevation, azimuth):
    """Return the pressures (azimuths, a) at a distance."""
    degree = np.array(WAVES)[:, 0]
    waves = [
        size(*w) * lpmv(w[1], w[0], np.sin(elevation)) * np.cos(w[1] * azimuth)
        for w in WAVES
    ]
    return (
        np.array(waves).T * (hankel(degree, k * distance) / hankel(degree, k * FAR))
    ) @ amplitudes


def sphere(k=1.7, radius=0.8):
    """Return the ratio of the pressure at a distance of 5 to its closed form, for a half sphere
    moving along the table."""
    mesh = meshed(Sphere(Pnt(0, 0, 0), radius))
    found = heard(multipoles(mesh, [(1, 0, 0)], [k])[0], k, 5.0, 0.0, np.array([0.0]))[
        0, 0
    ]
    return found / (-hankel(1, 5 * k) / (k * hankel(1, k * radius, True)))


def levels(height, fillet, beta):
    """Return the mean square [dB] round the disk at 0.5 m and 45 degrees of the pressure per unit
    acceleration force/mass."""
    body, centre = disk(height, fillet, beta, CLEAR[beta])
    s = np.sin(beta)
    c = np.cos(beta)
    u = x * c + (z - centre) * s
    w = -x * s + (z - centre) * c
    arm = np.cos(beta) - height / 2 * np.sin(beta)  # lever arm of the force
    tilt = -arm / (1 / 4 + height**2 / 12)
    moved = [(0, 0, 1), (-u * s - w * c, 0, u * c - w * s)]
    azimuth = np.pi * (np.arange(72) + 0.5) / 72
    found = []
    for k, amplitudes in zip(
        NUMBERS,
        multipoles(meshed(body, wedge(height, beta, centre)), moved, NUMBERS),
        strict=True,
    ):
        pressure = heard(amplitudes, k, 0.5 / RADIUS, np.pi / 4, azimuth) @ [1.0, tilt]
        found.append(10 * np.log10(np.mean(np.abs(pressure) ** 2)))
    return [round(float(level), 2) for level in found]


if __name__ == "__main__":
    off = abs(20 * np.log10(abs(sphere())))
    disks = [
        {
            "height": shape[0],
            "fillet": shape[1],
            "inclination": some,
            "level_db": [levels(*shape, b) for b in some],
        }
        for shape, some in INCLINATIONS.items()
    ]
    print(
        json.dumps({"number": NUMBERS, "disks": disks, "sphere_off_db": round(off, 4)})
    )
