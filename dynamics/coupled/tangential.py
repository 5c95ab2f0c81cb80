"""The tangential part of a step: creeping springs, slip and moments at a disk that stands. It cannot gain energy.

The midpoint rule for u' = -W p, q' = u - q V/l, p = k q keeps kinetic energy + k q^2/2 but for creep, which takes
k q~^2 V h/l >= 0. Where p exceeds what friction holds, p on the circle with C p + y p = C p0 takes its place; p0 is the
force without slip, C positive, y >= 0: the slip 2 y p lies along p and takes 2 y p^2. A spring that begins to slip lets
go what is above dynamic friction, and keeps no more than that; it sticks when it is stretched no further. As k grows a
spring keeps its force, as k falls its stretch; both lower its energy. The moments are impulses against omega.a_i that
are clipped where they stop it, so each takes kinetic energy. Friction that was fitted to a rough disk holds what
contact and creep take: its moments of rolling are spared that.

The film of air (film/law.py) turns against omega_3, and presses on the face where its resultant lies, against the
velocity there: of a contact that stands that is its law. Squeezed air holds what it is given, up to the energy that
such a film has, and loses the rest; it presses no longer where it would give more than it holds, whatever the contact
does.
"""

import numpy as np

from ..film.forces import holds, parts
from . import state as at
from .compiled import kernel
from .gap import column
from .table import K1, K2, LENGTH1, LENGTH2

film, most_held = kernel(parts), kernel(holds)
NEVER = 1e-30
"""Added to a precession rate, by which the drag is divided."""


@kernel
def step_tangential(y, law, powers, spline, h):
    """Advance the state y by the tangential part of a step h, at the lowest point of the rim."""
    hold_at(y, law, powers, spline, y[6] / y[at.SINE], y[7] / y[at.SINE], h)


@kernel
def hold_at(y, law, powers, spline, d0, d1, h):
    """Advance the state y by the tangential part of a step h, with the contact in the horizontal direction d."""
    m, J, R, H = law[at.MASS], law[at.J1], law[at.RADIUS], law[at.HALF]
    down, c, i, u = y[6] * d0 + y[7] * d1, y[8], int(y[at.CELL]), y[at.PART]
    s, reach, rise = max(y[at.SINE], 1e-9), R - down * (R * down / (1 + c) + H), R * down + H * c
    for side in range(2):
        k = column(spline, i, u, K1 if side == 0 else K2)
        q, before = y[at.SPRING + side], y[at.STIFFNESS + side]
        y[at.SPRING + side], y[at.STIFFNESS + side] = q * min(1.0, before / k), k
        y[at.LOSSES + 1] += (before * q * q - k * y[at.SPRING + side] ** 2) / 2
    resist(y, law, powers, s, c, d0, d1, h)
    if law[at.TURNING] > 0:
        press(y, law, s, c, d0, d1, reach, h)
    e = 1 / law[at.J2] - 1 / J
    spin = e * (y[9] * y[6] + y[10] * y[7] + y[11] * y[8])
    wd, wt = (y[9] * d0 + y[10] * d1) / J + spin * down, (y[10] * d0 - y[9] * d1) / J
    ut = y[4] * d0 - y[3] * d1 + reach * (y[11] / J + spin * c) + rise * wd
    ud = y[3] * d0 + y[4] * d1 - rise * wt
    Wt, Wd = 1 / m + R * R / law[at.J2] + H * H / J, 1 / m + rise * rise / J
    pt, pd = hold(y, law, ut, ud, Wt, Wd, column(spline, i, u, LENGTH1), column(spline, i, u, LENGTH2), h)
    # the force -p acts at reach d - rise e3
    y[3], y[4] = y[3] - h / m * (pd * d0 - pt * d1), y[4] - h / m * (pd * d1 + pt * d0)
    y[9], y[10] = y[9] - h * rise * (pt * d0 + pd * d1), y[10] - h * rise * (pt * d1 - pd * d0)
    y[11] -= h * reach * pt
    y[at.TANGENTIAL], y[at.TANGENTIAL + 1] = -pt, -pd


@kernel
def hold(y, law, ut, ud, Wt, Wd, length_t, length_d, h):
    """Advance the springs; return the mean force (along t, d) with which they hold the contact point."""
    kt, kd, N = y[at.STIFFNESS], y[at.STIFFNESS + 1], y[at.FORCE]
    creep_t, creep_d = h * y[at.SPEED] / length_t, h * y[at.SPEED] / length_d
    Ct, Cd = (1 + creep_t / 2) / kt + h * h / 4 * Wt, (1 + creep_d / 2) / kd + h * h / 4 * Wd
    qt, qd, limit = y[at.SPRING], y[at.SPRING + 1], law[at.MU_D] * N
    before = kt * qt * qt + kd * qd * qd
    pt, pd = (qt + h / 2 * ut) / Ct, (qd + h / 2 * ud) / Cd
    tried, slides = np.sqrt(pt * pt + pd * pd), y[at.SLIDES] > 0
    if tried > (limit if slides else law[at.MU_S] * N):
        if not slides:
            qt, qd = within(qt, qd, kt, kd, limit)
            pt, pd = (qt + h / 2 * ut) / Ct, (qd + h / 2 * ud) / Cd
            tried = np.sqrt(pt * pt + pd * pd)
        if tried > limit:
            pt, pd = on_circle(pt, pd, Ct, Cd, limit, tried)
        qt, qd = within(2 * pt / kt - qt, 2 * pd / kd - qd, kt, kd, limit)
        slides = True
    else:
        slides = slides and pt * (pt / kt - qt) + pd * (pd / kd - qd) > 0
        qt, qd = 2 * pt / kt - qt, 2 * pd / kd - qd
    if N > 0:
        y[at.SLIDES] = 1.0 if slides else 0.0
    y[at.SPRING], y[at.SPRING + 1] = qt, qd
    y[at.EXCESS] = max(y[at.EXCESS], np.sqrt(pt * pt + pd * pd) - (limit if slides else law[at.MU_S] * N))
    creep = creep_t * pt * pt / kt + creep_d * pd * pd / kd
    work = h * (pt * (ut - h / 2 * Wt * pt) + pd * (ud - h / 2 * Wd * pd))
    y[at.LOSSES + 1] += creep
    y[at.LOSSES + 2] += work - (kt * qt * qt + kd * qd * qd - before) / 2 - creep
    return pt, pd


@kernel
def within(qt, qd, kt, kd, limit):
    """Return a deflection, shortened where its force exceeds the limit."""
    keep = min(1.0, limit / max(np.sqrt((kt * qt) ** 2 + (kd * qd) ** 2), 1e-300))
    return keep * qt, keep * qd


@kernel
def on_circle(pt, pd, Ct, Cd, limit, tried):
    """Return the force with |p| = limit and C p + y p = C p0."""
    if limit == 0:
        return 0.0, 0.0
    y = (Ct + Cd) / 2 * (tried / limit - 1)
    for _ in range(4):  # Newton's method for 1/|p|, which is almost linear in y
        qt, qd = Ct * pt / (Ct + y), Cd * pd / (Cd + y)
        size = np.sqrt(qt * qt + qd * qd)
        slope = (qt * qt / (Ct + y) + qd * qd / (Cd + y)) / size
        y = max(0.0, y + (size / limit - 1) * size / slope)
    return Ct * pt / (Ct + y), Cd * pd / (Cd + y)


@kernel
def resist(y, law, powers, s, c, d0, d1, h):
    """Apply the moments k1, k2, k3, the power laws (n, 2) of the precession rate, and viscous loads as impulses."""
    J, e = law[at.J1], 1 / law[at.J2] - 1 / law[at.J1]
    for i in range(3):
        a0, a1, a2 = (-d1, d0, 0.0) if i == 0 else (d0, d1, 0.0) if i == 1 else (0.0, 0.0, 1.0)
        size, held = h * law[at.ARMS + i] * y[at.FORCE], 0.0 if i != 1 else law[at.FITTED]
        impulse(y, a0, a1, a2, size, h * law[at.VISCOUS_MOMENT], J, e, at.LOSSES + 3, held)
    if law[at.VISCOUS_FORCE] > 0:
        left = max(0.0, 1 - h * law[at.VISCOUS_FORCE] / law[at.MASS])
        y[at.LOSSES + 3] += law[at.MASS] / 2 * (y[3] * y[3] + y[4] * y[4]) * (1 - left * left)
        y[3], y[4] = left * y[3], left * y[4]
    for i in range(len(powers)):
        a0, a1, a2 = -c * d0, -c * d1, s  # e_3, upwards along the diameter through the contact
        rate = abs(y[9] * a0 + y[10] * a1 + y[11] * a2) / (J * s)
        growth = 1.0 if powers[i, 1] == 1 else rate ** (powers[i, 1] - 1)
        impulse(y, a0, a1, a2, h * powers[i, 0] * growth / s, 0.0, J, e, at.LOSSES + 3, law[at.FITTED])


@kernel
def press(y, law, s, c, d0, d1, reach, h):
    """Apply the film of air as impulses: its drag about e_3, its pressure on the face as the disk falls, and that of
    the air that is squeezed as it turns."""
    a0, a1, a2, J, m = -c * d0, -c * d1, s, law[at.J1], law[at.MASS]
    rate = (y[9] * a0 + y[10] * a1 + y[11] * a2) / (J * s) + NEVER
    drag, fall, lever, tip, lift = film(
        s, rate, law[at.TURNING], law[at.FALLING], law[at.INERTIA], law[at.NUMBER], law[at.AMBIENT], law[at.SLIP]
    )
    impulse(y, a0, a1, a2, 0.0, h * drag / (rate * s), J, 0.0, at.LOSSES + 5, 0.0)
    lever /= law[at.RADIUS]
    arm = reach - 1 / lever
    v, yields = y[5] - arm * (y[10] * d0 - y[9] * d1) / J, 1 / m + arm * arm / J
    push = v / yields * np.expm1(-h * lever * lever * fall * yields)
    y[at.LOSSES + 5] -= push * (v + push * yields / 2)
    y[5], y[9], y[10] = y[5] + push / m, y[9] + arm * push * d1, y[10] - arm * push * d0
    borne = h * lift / law[at.RADIUS]
    if borne > 0:
        arm = reach - law[at.RADIUS] * tip / lift
        v, yields = y[5] - arm * (y[10] * d0 - y[9] * d1) / J, 1 / m + arm * arm / J
        borne = min(borne, (np.sqrt(v * v + 2 * yields * y[at.SQUEEZED]) - v) / yields)  # it gives what it holds
        y[at.SQUEEZED] = max(0.0, y[at.SQUEEZED] - borne * (v + borne * yields / 2))
        y[5], y[9], y[10] = y[5] + borne / m, y[9] + arm * borne * d1, y[10] - arm * borne * d0
    held = min(y[at.SQUEEZED], most_held(s, rate, law[at.NUMBER], law[at.AMBIENT], law[at.SLIP]))
    y[at.LOSSES + 5], y[at.SQUEEZED] = y[at.LOSSES + 5] + y[at.SQUEEZED] - held, held
    y[at.LIFT] = (push + borne) / h


@kernel
def impulse(y, a0, a1, a2, size, per_rate, J, e, cause, fitted):
    """Turn against omega along the unit vector a by an angular impulse of `size` and more `per_rate`, at most the one
    that stops it; where it is `fitted` it is spared what contact and creep took."""
    if size == 0 and per_rate == 0:
        return
    n = a0 * y[6] + a1 * y[7] + a2 * y[8]
    rate = (a0 * y[9] + a1 * y[10] + a2 * y[11]) / J + e * n * (y[6] * y[9] + y[7] * y[10] + y[8] * y[11])
    yields = 1 / J + e * n * n
    taken = fitted * (y[at.LOSSES] + y[at.LOSSES + 1]) - y[at.SPARED]
    if fitted > 0 and taken > 0 and rate != 0:
        spared = min(size, taken / abs(rate))
        y[at.SPARED], size = y[at.SPARED] + spared * abs(rate), size - spared
    turn = -np.sign(rate) * min(size + per_rate * abs(rate), abs(rate) / yields)
    y[9], y[10], y[11] = y[9] + turn * a0, y[10] + turn * a1, y[11] + turn * a2
    y[cause] -= turn * (rate + turn * yields / 2)
