"""Claim: the compliant motion has the interface of every motion, and stops with a named outcome at
the limits of its model.

Source: the Protocol of dynamics/motion.py. Oracle: kinematics and momentum, which are independent
in the record; the event-driven motion; polynomials.
"""

from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace

import numpy as np
import pytest
from psutil import Process

from dynamics import Motion, simulate
from dynamics.compliant.compliant_motion import FORCES_PER_ROW, losses_until
from dynamics.compliant.law.height_profile import mean_heights
from dynamics.compliant.law.hertz_mindlin import MIN_CONTACT_INCLINATION
from dynamics.compliant.stepping.time_loop import step_motion
from dynamics.contact_losses import ContactLosses
from dynamics.motion import CAUSES
from dynamics.observables import precession_rate
from dynamics.stepping_core.row_store import (
    RowStore,
    interpolate_rows,
)
from modal import surface_modes
from sonify import load_scene
from sonify.claims.checks import motion_checks, pushing_contact
from sonify.claims.rigid_motion import contact_kept

BRIEF = "numerics.time_limit=0.3", "numerics.contact_rate=2e5"
MEBIBYTE = 2**20
FLAT = (
    "release.inclination_deg=0.02",
    "numerics.contact_rate=2e5",
    "friction.arm_rolling=1e-3",
)


@pytest.fixture(scope="module")
def elastic():
    changes = "contact.law=elastic", "contact.fillet=1.6e-3", "numerics.contact=full"
    return load_scene("published").replace(*changes)


@pytest.fixture(scope="module")
def rough(elastic):
    return simulate(elastic.replace("roughness.rms=1e-7", *BRIEF))


def of_other_numbers(elastic, i):
    """Return a scene with values that depend on i.

    One in three scenes has a film, one in three a rough moving table.
    """
    mode = f"{{order=2, frequency={600 + i}, damping_ratio=0.02, modal_mass={1 + 0.1 * i}}}"
    table = "surface.kind=modes", f"surface.modes=[{mode}]", "surface.action=motion"
    rough = (f"roughness.rms={1e-8 + 1e-10 * i}",)
    film = "air.film=acts", f"air.viscosity={1e-5 + 1e-7 * i}"
    disk = (
        f"disk.radius={0.03 + 1e-4 * i}",
        f"disk.thickness={0.01 + 1e-5 * i}",
        f"disk.mass={0.4 + 1e-3 * i}",
    )
    contact = (
        "contact.body=rigid",
        f"contact.young={5e10 + 1e9 * i}",
        f"contact.fillet={1e-3 + 1e-5 * i}",
    )
    friction = (f"friction.mu_static={0.4 + 1e-3 * i}",)
    start = (
        f"release.inclination_deg={20 + 0.1 * i}",
        "numerics.time_limit=0.004",
        "numerics.contact_rate=2e5",
    )
    return elastic.replace(
        *disk, *contact, *friction, *start, *((), film, (*table, *rough))[i % 3]
    )


@pytest.mark.slow
def test_scenes_of_other_numbers_compile_nothing_and_leave_nothing_behind(elastic):
    """The code compiles once for 51 contacts: film and table are numbers or empty arrays."""
    ends = set()
    compiled = []
    used = []
    for i in range(51):
        scene = of_other_numbers(elastic, i)
        motion = simulate(
            scene, surface_modes=surface_modes(scene) if i % 3 == 2 else None
        )
        ends.add(float(motion.state[-1, 10]))
        compiled.append(
            sum(
                len(machine.signatures)
                for machine in (step_motion, interpolate_rows, mean_heights)
            )
        )
        used.append(Process().memory_info().rss)
    assert len(ends) == 51
    assert compiled[2] == compiled[-1]
    assert max(used[35:]) - max(used[18:35]) < 5 * MEBIBYTE  # sixteen laws are kept


def test_a_polynomial_of_degree_five_is_read_exactly():
    x = np.arange(20.0)
    at = np.array([0.0, 0.3, 2.5, 7.0, 18.2, 19.0])
    c = np.array([0.3, -0.1, 0.02, 1e-3, -2e-4, 1e-5])
    rows = np.column_stack([np.polynomial.polynomial.polyval(x, c), x])
    for derivative in (False, True):
        expected = np.polynomial.polynomial.polyval(
            at, np.polynomial.polynomial.polyder(c) if derivative else c
        )
        assert interpolate_rows(rows, at, derivative)[:, 0] == pytest.approx(
            expected, rel=1e-12, abs=1e-12
        )
    record = RowStore(rows[:0])
    assert record.rows().shape == (0, 2)
    for part in (rows[:3], rows[3:3], rows[3:]):
        record.append(part)
    assert (record.rows() == rows).all()


def test_it_is_a_motion_that_passes_every_check(rough):
    assert isinstance(rough, Motion)
    checks = motion_checks(rough)
    assert [check.key for check in checks if not check.passed] == []
    assert rough.outcome.name == "ROLLING_ON"
    assert (
        0.3 - FORCES_PER_ROW * rough.dt
        <= rough.t[-1]
        <= 0.3 + FORCES_PER_ROW * rough.dt
    )
    assert (np.diff(rough.t) > 0).all()
    for wrong in (-1e-9, rough.t[-1] + 1e-6, [[0.1]]):
        with pytest.raises(ValueError, match="t must"):
            rough.at(wrong)


def test_states_and_forces_belong_together(rough):
    """Angles change at their rates, and momentum by the impulse of the force.

    Rows at 25 kHz resolve a vibration of 3 kHz, one hundredth of the rates, to 10 %.
    """
    t = np.linspace(0.01, 0.29, 300)
    h = 2e-6
    state = rough.at(t)
    change = (rough.at(t + h) - rough.at(t - h)) / (2 * h)
    assert change[:, 1] == pytest.approx(
        -state[:, 5], abs=1e-3 * np.abs(state[:, 5]).max()
    )
    assert change[:, 0] == pytest.approx(precession_rate(state), rel=1e-3)
    ends = np.array([0.05, 0.25])
    disk = rough.disk
    momentum = disk.mass * np.diff(rising(disk, rough.at(ends)))[0]
    n = np.linspace(*ends, 40001)
    force = rough.force(n)[:, 2]
    impulse = np.sum((force[1:] + force[:-1]) / 2) * (n[1] - n[0])
    assert impulse - disk.weight * 0.2 == pytest.approx(momentum, abs=8e-3 * disk.mass)
    assert rough.at_and_force(t)[1].tobytes() == rough.force(t).tobytes()


def rising(disk, state):
    """Return the vertical velocity [m/s] of the centre with the contact at fixed height.

    The contact vibrates by 2 mm/s.
    """
    lever = disk.radius * np.cos(state[:, 1]) - disk.thickness / 2 * np.sin(state[:, 1])
    return -lever * state[:, 5]


def test_a_disk_that_flies_from_the_first_step_has_lost_its_contact_until_the_end():
    """So the motion ends at its shortest duration, in which the contact does not pull."""
    flights = np.array([[0.0, 2e-3, 3e-6], [5e-5, 1e-3, 1e-6]])
    assert losses_until(5e-5, flights).array.tolist() == [[0.0, 5e-5, 3e-6]]
    assert len(losses_until(5e-5, flights[1:])) == 0


def test_losses_of_contact_are_flights_without_force(rough):
    assert len(rough.contact_losses) > 3
    assert not contact_kept(rough).holds
    for loss in list(rough.contact_losses)[:10]:
        assert loss.height > 0
        middle = loss.t + loss.duration / 2
        assert rough.regime([middle])[0] == "flight"
        if loss.duration > 1e-4:
            assert rough.force([middle])[0] == pytest.approx([0, 0, 0], abs=1e-3)
    names = {(change.before, change.after) for change in rough.transitions}
    assert {("roll", "slide"), ("slide", "roll")} <= names
    assert any("flight" in pair for pair in names)
    t = [change.t for change in rough.transitions]
    assert t == sorted(t)


def test_every_loss_of_energy_has_its_cause(rough):
    lost = rough.lost_by_cause(rough.t)
    assert lost.shape[1] == len(CAUSES)
    assert lost.sum(axis=1) == pytest.approx(rough.state[:, 10])
    assert (np.diff(lost, axis=0) >= 0).all()


def test_a_smooth_elastic_disk_moves_as_the_rigid_one(elastic):
    """Until the first slip they differ by creep of F/k V/l = 1 mm/s, or 0.01 rad in 0.25 s."""
    motion, rigid = (
        simulate(elastic.replace(*BRIEF, f"contact.law={law}"))
        for law in ("elastic", "rigid")
    )
    t = np.linspace(0, 0.25, 100)
    assert motion.at(t)[:, 1] == pytest.approx(rigid.at(t)[:, 1], abs=1e-2)
    assert motion.steady_load(t) == pytest.approx(rigid.force(t)[:, 2], rel=0.1)
    assert not motion.contact_losses


@pytest.mark.parametrize(
    ("changes", "outcome"),
    [
        (("release.omega=[0.0, 0.0, 0.6]", *FLAT), "SETTLED"),
        (
            ("release.omega=[0.0, 0.0, 0.0]", "release.inclination_deg=5", FLAT[1]),
            "FELL",
        ),
        pytest.param(
            ("release.omega=[-10.0, 0.0, 0.0]", "release.inclination_deg=80", FLAT[1]),
            "UPRIGHT",
            marks=pytest.mark.slow,
        ),
    ],
)
def test_it_ends_with_a_name(elastic, changes, outcome):
    motion = simulate(elastic.replace(*changes)).rolling
    assert motion.rolling_outcome.name == outcome
    assert motion.rows[:, 1].min() >= MIN_CONTACT_INCLINATION
    assert motion.t[-1] <= motion.t_end < motion.t[-1] + 0.1
    assert np.isfinite(motion.state).all()


EPS = np.finfo(float).eps


@pytest.mark.slow
def test_nutation_approaches_that_of_the_rigid_disk(elastic):
    """On its rounded edge, the rigid disk falls flat at 18.4 s, because its nutation grows.

    Creep damps the nutation. The deficit of the relative swing of the inclination near 15 s falls
    by at least a quarter each time that disk and table become ten times as stiff.
    """
    t = np.linspace(14.5, 15.5, 4001)

    def swing(motion):
        beta = motion.at(t)[:, 1]
        return np.ptp(beta - np.poly1d(np.polyfit(t, beta, 2))(t)) / beta.mean()

    rigid = simulate(elastic.replace("contact.law=rigid"))
    draft = simulate(elastic.replace("contact.law=rigid", "numerics.accuracy=draft"))
    assert rigid.rolling_outcome.name == "FELL"
    assert draft.t[-1] == pytest.approx(rigid.t[-1], abs=1e-3)
    deficits = []
    for factor in (1, 10, 100):
        stiffness = (
            f"contact.young={6e10 * factor}",
            f"material.young={1.95e11 * factor}",
        )
        full = (
            "numerics.contact=full",
            "numerics.accuracy=draft",
            "numerics.time_limit=16",
        )
        deficits.append(
            swing(rigid) - swing(simulate(elastic.replace(*stiffness, *full)))
        )
    assert deficits[0] < 0.75 * swing(rigid)
    assert deficits[1] < 0.75 * deficits[0]
    assert 0 < deficits[2] < 0.75 * deficits[1]


def test_threads_find_the_same(elastic):
    """The rows agree to a few roundings: older NumPy sines depend on the alignment of an array."""
    scene = elastic.replace(
        "roughness.rms=1e-7", "numerics.time_limit=0.02", "numerics.contact_rate=2e5"
    )
    with ThreadPoolExecutor(2) as pool:
        one, other = pool.map(simulate, [scene] * 2)
    assert one.impulses.tobytes() == other.impulses.tobytes()
    scale = np.abs(one.rows).max(axis=0)
    scale[5:8] = scale[5:8].max()  # omega
    scale[8:10] = scene.disk.radius * scale[5]  # slip
    assert (np.abs(one.rows - other.rows).max(axis=0) <= 8 * EPS * scale).all()


def test_viscous_loads_take_what_they_take_of_a_rigid_disk(elastic):
    """With viscous moment and force alone, both motions lose the same energy over 0.1 s."""
    slow = (
        "release.inclination_deg=20",
        "friction.mu_static=5",
        "friction.arm_rolling=0",
        "friction.arm_nutation=0",
    )
    viscous = (
        "friction.arm_pivoting=0",
        "dissipation.viscous_moment=3e-5",
        "dissipation.viscous_force=0.02",
    )
    scene = elastic.replace(
        *slow, *viscous, "numerics.time_limit=0.1", "numerics.contact_rate=2e5"
    )
    motion = simulate(scene)
    rigid = simulate(scene.replace("contact.law=rigid"))
    spent = motion.lost_by_cause([0.1])[0, CAUSES.index("moments")]
    assert spent == pytest.approx(rigid.at([0.1])[0, 10], rel=1e-2)
    assert spent > 1e-4


SAMPLES = 3000
"""Mean forces of the motions with recorded forces; each lasts 3 s."""


def motion_with_force(rough, force):
    """Return a motion of 3 s with mean forces (SAMPLES,) [N] and a loss of contact at 0.9 s."""
    dt = 3.0 / SAMPLES
    impulses = np.zeros((SAMPLES + 1, 3))
    impulses[1:, 2] = np.cumsum(force) * dt
    rows = np.resize(rough.rows, (SAMPLES // FORCES_PER_ROW + 1, rough.rows.shape[1]))
    losses = ContactLosses(np.array([[0.9, 0.2, 1e-6]]))
    return replace(rough, dt=dt, impulses=impulses, rows=rows, contact_losses=losses)


@pytest.mark.parametrize(
    ("force", "share"),
    [
        (lambda t: np.where(np.abs(t - 1) < 0.1, 0.0, 4.0), 0.0),  # within the loss
        (lambda t: np.where(np.abs(t - 2) < 0.1, 0.0, 4.0), 0.2 / 3),  # outside it
        (lambda t: np.where(np.abs(t - 1) < 0.1, -1.0, 4.0), 0.2 / 3),  # pulls
        (lambda t: np.where(t < 2.9, 4.0, -1e-7), 0.1 / 3),  # hardly pulls
    ],
)
def test_a_contact_pushes_except_in_its_noted_losses(rough, force, share):
    middle = (np.arange(SAMPLES) + 0.5) * 3.0 / SAMPLES
    motion = motion_with_force(rough, force(middle))
    assert pushing_contact(motion).value == pytest.approx(share)


def test_losses_of_contact_of_a_disk_that_is_nearly_flat_are_noted():
    """A table mode throws up a disk below 1e-5 rad; every interval of zero force is recorded.

    Oracle: the normal force at the middle of every recorded interval.
    """
    mode = "[{order=3, frequency=600.0, damping_ratio=0.005, modal_mass=1.0}]"
    scene = load_scene("published").replace(
        "contact.law=elastic", "surface.kind=modes", f"surface.modes={mode}"
    )
    scene = scene.replace(
        "surface.action=motion",
        "release.inclination_deg=0.004",
        "numerics.time_limit=0.05",
    )
    scene = scene.replace("release.omega=[0.0,0.0,0.4]")
    motion = simulate(scene, surface_modes=surface_modes(scene))
    t = motion.dt * (np.arange(len(motion.impulses) - 1) + 0.5)
    silent = t[np.diff(motion.impulses[:, 2]) == 0]
    assert len(silent) > 10
    assert motion.at(silent)[:, 1].min() < 1e-5
    assert set(motion.regime(silent)) == {"flight"}
    assert pushing_contact(motion).value == 0
