"""Between the columns of a Motion and the state of the disk on its compliant contact, and the energy of that state."""

import numpy as np

from ..film.forces import holds
from . import state as at
from .contact import LEAST_INCLINATION
from .profile import height
from .resonance import inertias
from .table import K1, K2, LENGTH1, LENGTH2, A, K


def release(model, state, force=None) -> np.ndarray:
    """Return the state (SIZE,) of a Compliant at the columns of a Motion (11,), its springs loaded with a force (3,).

    The force [N] is friction along a_1, a_2 and the normal force; by default the weight alone. What the springs hold
    they hold by creep, so that nothing rings which the motion itself does not excite.
    """
    law, theta, beta, slip = model.table.law, state[0], state[1], state[8:10]
    f1, f2, N = (0.0, 0.0, law.disk.weight) if force is None else force
    R, H, (J1, J2) = law.disk.radius, law.disk.thickness / 2, inertias(law.disk)
    c = model.table.columns(np.array([beta]))[0]
    a1, a2 = np.array([np.cos(theta), np.sin(theta), 0.0]), np.array([-np.sin(theta), np.cos(theta), 0.0])
    n, e3 = np.sin(beta) * a2 + [0, 0, np.cos(beta)], [0, 0, np.sin(beta)] - np.cos(beta) * a2
    w1, w2, w3 = state[5:8]
    speed = abs(R * (w2 - w3 / np.tan(beta)) + slip[0])
    deflection, delta = np.array([-f1 / c[K1], -f2 / c[K2]]), (N / c[K]) ** (2 / 3)  # against the force, along a_1, a_2
    slip = slip + deflection * speed / c[[LENGTH1, LENGTH2]]
    y = np.zeros(at.SIZE)
    y[at.HEIGHTS : at.HEIGHTS + 2] = [height(p, -R * state[2], c[A]) for p in model.profiles]
    y[0], y[1] = state[3:5]
    y[2] = R * np.sin(beta) - 2 * H * np.sin(beta / 2) ** 2 - delta + y[at.HEIGHTS : at.HEIGHTS + 2].sum()
    y[at.VELOCITY : at.AXIS] = slip @ [a1, a2] + np.cross(w1 * a1 + w2 * n + w3 * e3, H * n + R * e3)
    y[at.AXIS : at.MOMENTUM], y[at.MOMENTUM : at.SPRING] = n, J1 * (w1 * a1 + w3 * e3) + J2 * w2 * n
    y[at.SPRING : at.SPRING + 2] = deflection * [-1, 1]  # along t = -a_1, d = a_2
    y[at.STIFFNESS : at.STIFFNESS + 2] = c[K1 : K2 + 1]
    y[at.FORCE], y[at.LAST : at.LAST + 2], y[at.GAP], y[[at.PATH, at.EDGE]] = N, N, -delta, -R * state[2]
    y[at.SQUEEZED] = holds(np.sin(beta), w3 / np.sin(beta), *model.constants[at.NUMBER : at.SLIP + 1])
    return y


def inclination(y) -> np.ndarray:
    """Return the inclinations (n,) [rad] of states (n, SIZE), exact however small."""
    return np.arctan2(np.hypot(y[:, at.AXIS], y[:, at.AXIS + 1]), y[:, at.AXIS + 2])


def energy(model, y) -> np.ndarray:
    """Return kinetic, potential and elastic energy [J] of states (n, SIZE), zero for the disk lying flat, with that of
    the modes of table and disk and of squeezed air."""
    y, (J1, J2), disk = np.ascontiguousarray(y.T), inertias(model.table.law.disk), model.table.law.disk
    v, n, L = y[at.VELOCITY : at.AXIS], y[at.AXIS : at.MOMENTUM], y[at.MOMENTUM : at.SPRING]
    moved = disk.mass * (v * v).sum(axis=0) + (L * L).sum(axis=0) / J1 + (1 / J2 - 1 / J1) * (L * n).sum(axis=0) ** 2
    x = np.log(np.maximum(np.hypot(n[0], n[1]), np.sin(LEAST_INCLINATION)))
    moved += 0.8 * model.table.stiffness(x) * np.sqrt(np.maximum(0.0, -y[at.GAP])) ** 5
    moved += (y[at.STIFFNESS : at.STIFFNESS + 2] * y[at.SPRING : at.SPRING + 2] ** 2).sum(axis=0)
    return moved / 2 + model.constants[at.WEIGHT] * (y[2] - y[at.TABLE]) + y[at.SURFACE] + y[at.BODY] + y[at.SQUEEZED]


def columns(model, y) -> np.ndarray:
    """Return the columns of a Motion (n, 11) at states y (n, SIZE); the precession is in (-pi, pi]."""
    disk, (J1, J2), beta = model.table.law.disk, inertias(model.table.law.disk), inclination(y)
    y, R, H, s, c = np.ascontiguousarray(y.T), disk.radius, disk.thickness / 2, np.sin(beta), np.cos(beta)
    d0, d1, L = y[at.AXIS] / s, y[at.AXIS + 1] / s, y[at.MOMENTUM : at.SPRING]
    w1, w2 = (L[0] * d1 - L[1] * d0) / J1, (y[at.AXIS : at.MOMENTUM] * L).sum(axis=0) / J2
    w3 = (L[2] * s - (L[0] * d0 + L[1] * d1) * c) / J1
    u1 = y[3] * d1 - y[4] * d0 - R * w2 + H * w3
    u2 = y[3] * d0 + y[4] * d1 + (R * s + H * c) * w1
    lost = y[at.LOSSES : at.LOSSES + len(at.CAUSES)].sum(axis=0)
    return np.column_stack([np.arctan2(-d0, d1), beta, -y[at.EDGE] / R, y[0], y[1], w1, w2, w3, u1, u2, lost])
