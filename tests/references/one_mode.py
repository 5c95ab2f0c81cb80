"""Writes one_mode.json: the halt of the published disk on one mode of a table, by another method
than the program's.

Free rotation of the symmetric top, mode and flight are exact in each step; the normal force is a
kick, half before and half after; friction is rigid: an impulse that stops the slip, or the Coulomb
one that opposes what slip it leaves (Moreau's method, of first order); so are the rolling moments.
The contact is sought among 96 places of the rim, then by Newton's method. Of the program only the
rigid motion up to tau = 250 is read. Run it as a script, for half an hour."""

import json
from pathlib import Path

import numpy as np
from numba import njit

from dynamics import simulate
from dynamics.observables import precession_rate
from sonify import load_scene

STIFFNESS, LOSS = 1.1e11, 10.0
"""N = K (-G)^1.5 (1 - loss G'): the published disk on granite at 1 mrad."""
ORDER, FREQUENCY, DAMPING, MASS = 2, 600.0, 0.02, 1.0
FLAT = 1e-5


@njit
def cross(a, b):
    return np.array(
        [
            a[1] * b[2] - a[2] * b[1],
            a[2] * b[0] - a[0] * b[2],
            a[0] * b[1] - a[1] * b[0],
        ]
    )


@njit
def rotated(n, turn):
    angle = np.sqrt(turn @ turn)
    k = turn / angle
    return (
        n * np.cos(angle)
        + cross(k, n) * np.sin(angle)
        + k * (k @ n) * (1 - np.cos(angle))
    )


@njit
def gap(phi, z, n, p, R, H, A):
    wave = A * (p[0] * np.cos(ORDER * phi) + p[1] * np.sin(ORDER * phi))
    return z - R * (n[0] * np.cos(phi) + n[1] * np.sin(phi)) - H * n[2] - wave


@njit
def nearest(phi, scan, z, n, p, R, H, A):
    if scan:
        places = 2 * np.pi * np.arange(96) / 96
        phi = places[
            np.argmin(np.array([gap(place, z, n, p, R, H, A) for place in places]))
        ]
    for _ in range(4):
        c = np.cos(phi)
        s = np.sin(phi)
        C = np.cos(ORDER * phi)
        S = np.sin(ORDER * phi)
        slope = R * (n[0] * s - n[1] * c) + A * ORDER * (p[0] * S - p[1] * C)
        bend = R * (n[0] * c + n[1] * s) + A * ORDER**2 * (p[0] * C + p[1] * S)
        bend = bend if bend > 0 else R * np.sqrt(n[0] ** 2 + n[1] ** 2) + 1e-12
        phi -= min(max(slope / bend, -0.2), 0.2)
    return phi


@njit
def arm(n, phi, R, H):
    """Return the arm (3,) of the contact about the centre."""
    c = np.cos(phi)
    s = np.sin(phi)
    down = np.array([c, s, 0.0]) - (n[0] * c + n[1] * s) * n
    return R * down / np.sqrt(down @ down) - H * n


@njit
def moments(L, n, phi, arms, impulse, body):
    _, J1, J2 = body[:3]
    E = 1 / J2 - 1 / J1
    c = np.cos(phi)
    s = np.sin(phi)
    for k in range(3):
        a = (
            np.array([-s, c, 0.0])
            if k == 0
            else np.array([c, s, 0.0])
            if k == 1
            else np.array([0.0, 0.0, 1.0])
        )
        rate = (L @ a) / J1 + E * (n @ a) * (n @ L)
        yields = 1 / J1 + E * (n @ a) ** 2
        L -= np.sign(rate) * min(arms[k] * impulse, abs(rate) / yields) * a


@njit
def solved(W, y, b):
    """Return p of (W + y) p = b, W (2, 2) symmetric."""
    a = W[0, 0] + y
    c = W[0, 1]
    d = W[1, 1] + y
    return np.array([d * b[0] - c * b[1], a * b[1] - c * b[0]]) / (a * d - c * c)


@njit
def friction(v, L, n, r, body, limits, sliding):
    """Stop the slip with an impulse, or oppose it with one of the second size in `limits`.

    Return True if the contact slides.
    """
    m, J1, J2 = body[:3]
    E = 1 / J2 - 1 / J1
    holds, slips = limits
    u = v + cross(L / J1 + E * (n @ L) * n, r)
    W = np.zeros((2, 2))
    for j in range(2):
        unit = np.zeros(3)
        unit[j] = 1.0
        turn = cross(r, unit)
        W[:, j] = (unit / m + cross(turn / J1 + E * (n @ turn) * n, r))[:2]
    p = solved(W, 0.0, -u)
    y = 0.0
    size = np.sqrt(p @ p)
    sliding = size > (slips if sliding else holds)
    if sliding:
        y = (W[0, 0] + W[1, 1]) / 2 * (size / slips - 1)
        for _ in range(30):  # W p + y p = -u with |p| = slips
            p = solved(W, y, -u)
            size = np.sqrt(p @ p)
            step = (size / slips - 1) * size * size / (p @ solved(W, y, p))
            y = max(0.0, y + step)
            if abs(step) < 1e-12 * y:
                break
    impulse = np.array([p[0], p[1], 0.0])
    v += impulse / m
    L += cross(r, impulse)
    return sliding


@njit
def mode_step(p, pv, h):
    """Advance the mode by a time h without a force."""
    w = 2 * np.pi * FREQUENCY
    wd = w * np.sqrt(1 - DAMPING**2)
    decay = np.exp(-DAMPING * w * h)
    C = decay * np.cos(wd * h)
    S = decay * np.sin(wd * h)
    p[:], pv[:] = (
        (C + DAMPING * w / wd * S) * p + S / wd * pv,
        (C - DAMPING * w / wd * S) * pv - w * w / wd * S * p,
    )


@njit
def run(start, body, mus, arms, h, steps, every, out):
    """Fill rows (time, inclination, direction of the tilt); return the time of the first loss of
    contact."""
    x, n, v, L, p, pv = start
    m, J1, _, R, H, g = body
    A = MASS**-0.5
    phi = nearest(0.0, True, x[2], n, p, R, H, A)
    G = gap(phi, x[2], n, p, R, H, A)
    N = STIFFNESS * max(0.0, -G) ** 1.5
    lost = -1.0
    sliding = False
    for i in range(steps):
        for half in range(2):
            r = arm(n, phi, R, H)
            v[2] += h / 2 * (N / m - g)
            L += h / 2 * N * np.array([r[1], -r[0], 0.0])
            pv -= h / 2 * N * A * np.array([np.cos(ORDER * phi), np.sin(ORDER * phi)])
            if half == 0:
                x += h * v
                n[:] = rotated(n, L * (h / J1))
                mode_step(p, pv, h)
                phi = nearest(phi, i % 8 == 0, x[2], n, p, R, H, A)
                before = G
                G = gap(phi, x[2], n, p, R, H, A)
                N = max(
                    0.0, STIFFNESS * max(0.0, -G) ** 1.5 * (1 - LOSS * (G - before) / h)
                )
        if N > 0:
            moments(L, n, phi, arms, h * N, body)
            sliding = friction(v, L, n, r, body, h * N * mus, sliding)
        elif lost < 0:
            lost = i * h
        if (i + 1) % every == 0:
            out[i // every] = (
                (i + 1) * h,
                np.sqrt(n[0] ** 2 + n[1] ** 2),
                np.arctan2(n[1], n[0]),
            )
    return lost


def halt(rate, phase, stop):
    """Return the times [s] after tau = 250 of 300 Hz precession, first loss of contact and flat
    disk."""
    scene = load_scene("published")
    disk = scene.disk
    laws = scene.friction
    motion = simulate(scene)
    t = 250 * disk.time_unit
    theta, beta, _, _, _, w1, w2, w3 = motion.at([t])[0, :8]
    N = motion.force([t])[0, 2]
    turning = precession_rate(motion.at([t]))[0]
    R = disk.radius
    H = disk.thickness / 2
    m = disk.mass
    K = disk.gyration
    a = theta + phase
    J1 = m * R * R * (K / 4 + disk.aspect**2 / 3)
    J2 = m * R * R * K / 2
    a1 = np.array([np.cos(a), np.sin(a), 0.0])
    a2 = np.array([-np.sin(a), np.cos(a), 0.0])
    n = np.sin(beta) * a2 + [0, 0, np.cos(beta)]
    e3 = [0, 0, np.sin(beta)] - np.cos(beta) * a2
    v = np.cross(w1 * a1 + w2 * n + w3 * e3, H * n + R * e3) + motion.at([t])[
        0, 8:10
    ] @ [a1, a2]
    w = 2 * np.pi * FREQUENCY
    along = ORDER * np.arctan2(n[1], n[0])
    q = (
        -N
        * MASS**-0.5
        / (w**2 - (ORDER * turning) ** 2 + 2j * DAMPING * w * ORDER * turning)
        * np.exp(1j * along)
    )
    p, pv = (np.array([c.real, c.imag]) for c in (q, 1j * ORDER * turning * q))
    rise = MASS**-0.5 * (np.exp(-1j * along) * q).real
    x = np.array(
        [0, 0, R * np.sin(beta) + H * np.cos(beta) - (N / STIFFNESS) ** (2 / 3) + rise]
    )
    every = round(rate / 1e5)
    out = np.zeros((round(stop * rate) // every, 3))
    body = (m, J1, J2, R, H, disk.weight / m)
    arms = np.array([laws.arm_nutation, laws.arm_rolling, laws.arm_pivoting])
    mus = np.array([laws.mu_static, laws.mu_dynamic])
    L = J1 * (w1 * a1 + w3 * e3) + J2 * w2 * n
    start = (x, n, v, L, p, pv)
    lost = run(start, body, mus, arms, 1 / rate, len(out) * every, every, out)
    turns = np.abs(np.gradient(np.unwrap(out[:, 2]), out[:, 0])) / (2 * np.pi)
    return (
        out[np.argmax(turns > 300), 0],
        lost,
        out[np.flatnonzero(out[:, 1] > FLAT)[-1], 0],
    )


if __name__ == "__main__":
    found = {"crossing": {}, "lost": {}, "flat": {}}
    for rate in (2e6, 4e6):
        runs = [halt(rate, phase, 0.98) for phase in np.linspace(0.1, 6.2, 18)]
        for times, values in zip(found.values(), zip(*runs, strict=True), strict=True):
            times[f"{rate:g}"] = values
    Path(__file__).with_suffix(".json").write_text(
        json.dumps(found, indent=1) + "\n", "utf-8"
    )
