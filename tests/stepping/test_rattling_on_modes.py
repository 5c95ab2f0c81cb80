"""Claim: the modes of a table act on a disk that rattles on it.

Source: dynamics/rattling. Oracle: the energy of the states, a rigid table, and the equations of
motion of a dropped disk on one mode, from its Lagrangian, solved by SciPy.
"""

from dataclasses import replace
from math import pi

import numpy as np
import pytest
from rattling_coin import coin, model_of
from scipy.integrate import solve_ivp

from benchmarks.cases.contact_models_case import CASES
from dynamics import plan_motion, simulate
from dynamics.compliant.compliant_motion import FORCE_SAMPLE_RATE, FORCES_PER_ROW
from dynamics.disk import GRAVITY
from dynamics.rattling.layout import CENTRE, DASHPOT, ELASTIC
from dynamics.rattling.rattling_motion import (
    effective_restitution,
    rattling_model,
    rolling_state_at_release,
    simulate_rattling,
    static_deflection,
)
from dynamics.rattling.vibration import (
    INTERPOLATION_NORM,
    SPEED,
    add_table,
    interpolation_at,
    push_nodes,
    table_nodes_under_arc,
)
from sonify.plan.table import table_action
from sonify.scene import from_document


def on_modes(*modes, changes=(), restitution=0.5):
    """Return a rattling coin on a table with modes of order, frequency, damping ratio and mass."""
    names = ("order", "frequency", "damping_ratio", "modal_mass")
    listed = ", ".join(
        "{"
        + ", ".join(f"{name}={value}" for name, value in zip(names, mode, strict=True))
        + "}"
        for mode in modes
    )
    scene = coin(2e-6, 1.0, restitution, 1, 0.09, "numerics.time_limit=0.05")
    return scene.replace(
        "surface.kind=modes",
        f"surface.modes=[{listed}]",
        "surface.action=motion",
        *changes,
    )


@pytest.mark.slow
@pytest.mark.parametrize(
    ("damping", "restitution", "error"), [(0.01, 0.5, 1e-6), (0.0, 0.999999999, 1e-7)]
)
def test_energies_and_losses_of_disk_and_table_add_up(damping, restitution, error):
    """The table is as light as two coins; a lossless one gains nothing."""
    light = [(n, f, damping, 0.02) for n, f in ((0, 400.0), (2, 900.0), (3, 5000.0))]
    changes = [] if damping else ["material.loss_factor=0"]
    scene = on_modes(
        *light, restitution=restitution, changes=["contact.body=elastic", *changes]
    )
    motion = simulate(scene)
    total = motion.energy(motion.t) + motion.state[:, -1]
    assert np.abs(total / total[0] - 1).max() < error
    assert total[-1] == pytest.approx(total[0], rel=1e-6)
    assert motion.moves_table
    assert motion.table_energy(motion.t).max() > 1e-3 * total[0]
    lost = motion.energy_lost(motion.t[-1:])
    assert (lost["table"][0] > 0.01 * total[0]) == (damping > 0)
    assert np.all(np.diff(motion.energy_lost(motion.t)["table"]) > -1e-12 * total[0])


@pytest.mark.slow
@pytest.mark.parametrize("is_fixed", [False, True])
def test_a_lossless_table_that_slopes_gains_nothing(is_fixed):
    """To 1e-6 at half the step; the error falls with its square.

    Without the horizontal part of the contact force it was 1e-5 at any step.
    """
    changes = ["contact.body=elastic", "material.loss_factor=0"]
    changes += ["numerics.contact_rate=2.4e6", "friction.mu_dynamic=0"]
    scene = on_modes(
        *[(n, f, 0.0, 0.02) for n, f in ((0, 400.0), (2, 900.0), (3, 5000.0))],
        restitution=0.999999999,
        changes=changes,
    )
    # modes given by numbers move with the disk; those of a table of known mass do not
    table = replace(table_of(scene), mass=0.02 if is_fixed else 0.0)
    model = rattling_model(plan_motion(scene, table))
    motion = simulate_rattling(
        model, rolling_state_at_release(model, 0.09, scene.release.omega), 0.03, 0.0
    )
    energy = motion.energy(motion.t)
    assert np.abs(energy / energy[0] - 1).max() < 1e-6
    assert motion.contact_losses
    assert motion.table_energy(motion.t).max() > 1e-3 * energy[0]


@pytest.mark.slow
def test_a_heavy_table_is_a_rigid_one():
    heavy = on_modes(
        (0, 400.0, 0.01, 1e7), (2, 900.0, 0.01, 1e7), changes=["contact.body=elastic"]
    )
    rigid = simulate(heavy.replace("surface.action=sound"))
    moving = simulate(heavy)
    assert moving.moves_table
    assert not rigid.moves_table
    t = np.linspace(0.0, 0.005, 500)  # later, the impacts have amplified the difference
    assert moving.contact_losses[4].t == pytest.approx(
        rigid.contact_losses[4].t, abs=1e-6
    )
    assert moving.inclination(t) == pytest.approx(rigid.inclination(t), rel=1e-6)
    assert moving.table_energy(t).max() < 1e-6 * moving.energy(0.0)[0]


@pytest.mark.slow
@pytest.mark.parametrize(("frequency", "mass"), [(300.0, 0.01), (3000.0, 0.002)])
def test_a_disk_dropped_on_one_mode_moves_as_its_lagrangian_says(frequency, mass):
    """A disk without spin keeps its plane: height, inclination and one mode under all its rim.

    The contact has the elastic energy 2/5 K d^2.5, with K = 4/3 E* (R r/beta)^(1/4) and the depth d
    of the rounded edge in the table.
    """
    damping = 0.05
    scene = on_modes((0, frequency, damping, mass), restitution=0.999999999)
    scene = scene.replace("friction.mu_dynamic=0", "numerics.contact_rate=2e6")
    model = model_of(scene, np.zeros(8192), modes=table_of(scene))
    fixed = model.constants
    state = rolling_state_at_release(model, 0.09, (0.0, 0.0, 0.0))
    state[CENTRE, 2] += 2e-5
    bend, displacement = static_deflection(model, state)
    omega = 2 * pi * frequency
    shape = mass**-0.5
    core = fixed.radius - fixed.fillet
    half = fixed.half_thickness - fixed.fillet

    def rates(t, y):
        height, beta, q, climb, turn, speed = y
        depth = (
            q * shape
            - height
            + core * np.sin(beta)
            + half * np.cos(beta)
            + fixed.fillet
        )
        stiffness = 4 / 3 * fixed.modulus * (fixed.radius * fixed.fillet / beta) ** 0.25
        force = stiffness * max(depth, 0.0) ** 1.5
        stored = 2 / 5 * stiffness * max(depth, 0.0) ** 2.5
        moment = stored / (4 * beta) - force * (
            core * np.cos(beta) - half * np.sin(beta)
        )
        return [
            climb,
            turn,
            speed,
            force / fixed.mass - GRAVITY,
            moment / fixed.diametral_inertia,
            -(omega**2) * q - 2 * damping * omega * speed - force * shape,
        ]

    start = [state[CENTRE, 2] + bend, 0.09, displacement[0], 0.0, 0.0, 0.0]
    t = np.arange(0.0, 0.012, FORCES_PER_ROW / FORCE_SAMPLE_RATE)
    later = t + 1e-5 - 0.5 / model.rate  # the first sample is the middle of a step
    options = {"method": "DOP853", "rtol": 1e-10, "atol": 1e-14, "max_step": 1e-5}
    exact = solve_ivp(rates, (0.0, later[-1]), start, t_eval=later, **options)
    motion = simulate_rattling(model, state, 0.015, 0.0)
    assert len(motion.contact_losses) > 2
    assert motion.inclination(t) == pytest.approx(exact.y[1], rel=1e-4)  # 3e-5 here
    energy = (exact.y[5] ** 2 + omega**2 * exact.y[2] ** 2) / 2
    assert motion.table_energy(t) == pytest.approx(energy, abs=0.04 * energy.max())


@pytest.mark.slow
def test_an_impact_on_a_light_table_loses_energy_to_its_waves():
    # a mode with little damping returns its energy before the contact ends
    scene = on_modes((0, 3000.0, 0.3, 0.002), changes=["friction.mu_dynamic=0"])
    model = rattling_model(plan_motion(scene))
    alone = effective_restitution(model._replace(modes=None), 0.09, 0.01)
    assert effective_restitution(model, 0.09, 0.01) < alone - 0.05


@pytest.mark.slow
def test_a_table_that_stores_too_little_only_sounds():
    """With surface.action = 'auto' the coupling starts at the release, or never."""
    for mass, acts in ((0.02, True), (1e6, False)):
        scene = on_modes((2, 900.0, 0.01, mass)).replace(
            "surface.action=auto", "dissipation.contour_moment=3.2e-7"
        )
        motion = simulate(scene)
        assert motion.moves_table == acts
        decision = table_action(motion.plan)
        assert motion.plan.two_way.is_two_way == acts
        assert ("from the release" in decision.reason) == acts


def test_contact_anywhere_is_chosen_on_a_table_that_moves():
    scene = on_modes((2, 900.0, 0.01, 0.1)).document
    del scene["contact"]["restitution"]
    scene["numerics"]["contact"] = "auto"
    assert plan_motion(from_document(scene)).contact.kind == "many"
    scene["roughness"]["rms"] = 1e-9
    assert plan_motion(from_document(scene)).contact.kind == "full"


def table_of(scene):
    """Return the modes of the table of a scene that gives them as numbers."""
    return simulate(scene.replace("numerics.time_limit=0.001")).model.modes


@pytest.mark.parametrize("order", [0, 2, 8])
def test_the_table_between_its_nodes_is_that_of_its_waves(order):
    """The cubic through four of 64 nodes errs by 3/128 (n d)^4 at most; the chord through two
    nodes errs by (n d)^2/8, at order 8 by 8 %."""
    count = 64
    place = np.linspace(0.0, count, 1001)[:-1]
    node, weight = interpolation_at(place, count)
    angle = 2 * pi / count
    at_nodes = np.exp(1j * order * angle * np.arange(count))
    error = (weight * at_nodes[node]).sum(axis=1) - np.exp(1j * order * angle * place)
    allowed = 3 / 128 * (order * angle) ** 4
    assert np.abs(error).max() <= allowed + 1e-14
    assert np.abs(error).max() >= 0.8 * allowed  # the bound is not loose
    assert np.abs(weight).sum(axis=1).max() == pytest.approx(
        INTERPOLATION_NORM, rel=1e-4
    )


def test_forces_on_the_nodes_do_the_work_of_the_forces_on_the_points():
    """Whatever the table does, the power is that at the interpolated speeds."""
    scene = on_modes((3, 400.0, 0.01, 0.02))
    table = rattling_model(plan_motion(scene)).table()
    random = np.random.default_rng(5)
    table.motion[SPEED] = random.normal(size=table.motion.shape[1])
    first, size = 10, 300
    speed = np.zeros(len(table.weight))
    add_table(table, SPEED, first, size, speed)
    depth = np.zeros(len(table.weight))
    depth[first : first + size] = random.uniform(size=size)
    push_nodes(table, depth, first, size, 2.0, 3.0)
    for cause, factor in ((ELASTIC, 2.0), (DASHPOT, 3.0)):
        assert table.force[cause] @ table.motion[SPEED] == pytest.approx(
            factor * depth @ speed, rel=1e-12
        )
    begin, nodes = table_nodes_under_arc(table, first, size, len(depth))
    used = np.flatnonzero(table.force[ELASTIC])
    assert set(used) <= {
        n % len(table.known_since) for n in range(begin, begin + nodes)
    }


@pytest.mark.slow
def test_a_smooth_disk_on_a_bending_table_makes_no_tone_of_the_nodes():
    """Each passing node was a corner of a polygon: 1.8 % of the weight at 1025 Hz, where 64 nodes
    pass; one contact at the exact table has 1e-7 there."""
    case = CASES["flexible, 0"]
    frequency, power = case.solve("many", 1.2e6).values.spectrum()
    near = (frequency > 700) & (frequency < 1500)
    tone = np.sqrt(power[near].sum() * frequency[1]) / case.scene.disk.weight
    assert tone < 5e-4
