"""Disks on table modes: models, steady motions and their time stepping."""

from types import SimpleNamespace

import numpy as np
from contact_scenes import slope_of_contact, steady_precession_rate
from scipy.interpolate import CubicSpline

from dynamics.compliant.law.table_receptance import ModalReceptance
from dynamics.compliant.law.tabulated import LAW_COLUMNS, TabulatedLaw
from dynamics.compliant.model_inputs import contact_law
from dynamics.compliant.state_conversion import energy
from dynamics.compliant.stepping.model import CompliantModel
from dynamics.compliant.stepping.state_layout import ENERGY_LOSSES
from dynamics.disk import Friction
from dynamics.surface import ModesSurface, SurfaceMode
from modal import surface_modes

GRIPS = Friction(mu_static=10.0, mu_dynamic=10.0)


def standing(scene, rate, friction, *modes, damps=True, stiffness=None):
    """Return the model of a disk without creep on table modes (order, frequency, damping ratio,
    modal mass); `stiffness` [N/m^1.5] replaces that of the contact at all inclinations."""
    names = "order", "frequency", "damping_ratio", "modal_mass"
    surface = ModesSurface(
        modes=tuple(
            SurfaceMode(**dict(zip(names, mode, strict=True))) for mode in modes
        )
    )
    table = TabulatedLaw(law=contact_law(scene))
    scale = np.ones(len(LAW_COLUMNS))
    scale[[LAW_COLUMNS.relaxation_length_1, LAW_COLUMNS.relaxation_length_2]] = 1e9
    scale[LAW_COLUMNS.loss_coefficient] = float(damps)
    values = table.spline(table.grid) * scale
    if stiffness is not None:
        values[:, LAW_COLUMNS.hertz_stiffness] = stiffness
    table.__dict__["spline"] = CubicSpline(table.grid, values)
    known = surface_modes(
        SimpleNamespace(disk=scene.disk, surface=surface, numerics=scene.numerics)
    )
    return CompliantModel(
        tabulated_law=table, friction=friction, rate=rate, modes=known
    )


def steady(law, beta):
    """Return the columns of the steady motion, centre fixed, and its precession rate [rad/s]."""
    rate = steady_precession_rate(law, beta)
    w3 = rate * np.sin(beta)
    return np.array(
        [0.0, beta, 0, 0, 0, 0, slope_of_contact(law, beta) * w3, w3, 0, 0, 0]
    ), rate


def run(model, y, every, stop):
    """Return the initial energy, times, states, losses of contact and the reason of the stop."""
    modes = model.supporting_modes(y)
    first = energy(model, y[None])[0]
    pieces = list(model.run(y, every, stop, modes=modes))
    t, state = (
        np.concatenate([getattr(p, name) for p in pieces]) for name in ("t", "state")
    )
    return (
        first,
        t,
        state,
        [loss for p in pieces for loss in p.losses],
        pieces[-1].end_reason,
    )


def energy_error(model, state, first):
    """Return the largest deviation of energy and losses in states (n, s) from a first energy, relative
    to it."""
    total = energy(model, state) + state[:, ENERGY_LOSSES].sum(axis=1)
    return np.abs(total - first).max() / first


def assert_never_gained(model, state, first):
    """Assert that no energy is lost without a cause, and that none is gained in any step."""
    assert energy_error(model, state, first) < 1e-10
    gained = np.diff(np.append(first, energy(model, state)))
    assert gained.max() < 1e-12 * first


def one_mode(frequency, square, decay=0.0, order=0):
    """Return the receptance of one mode, or of a pair, on the contact circle."""
    angle = 2 * np.pi * np.arange(64) / 64
    if order == 0:
        shapes = np.full((64, 1), np.sqrt(square))
    else:
        shapes = np.sqrt(square) * np.column_stack(
            [np.cos(order * angle), np.sin(order * angle)]
        )
    count = shapes.shape[1]
    return ModalReceptance(shapes, np.full(count, frequency), np.full(count, decay))


MODE = "{order=2, frequency=600.0, damping_ratio=0.02, modal_mass=1.0}"
TABLE = f"surface={{kind='modes', action='motion', modes=[{MODE}]}}"
