"""Claim: every check of a run is computed, not set: it fails if what it guards is broken.

Source: sonify/claims/checks.py. Oracle: the same run with one fault in the code that the check
guards. A fault takes the place of a function; the compiled time steps run as Python, so that
the fault takes effect where they call each other.
"""

import ast
from dataclasses import dataclass, replace
from math import nan
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from interpreted import interpret_dynamics
from rattling_coin import coin, model_of

import sonify
from dynamics import Loads, Outcome, OwnLaw, rigid_motion, simulate
from dynamics.compliant import compliant_motion
from dynamics.compliant.stepping import normal, tangential, time_loop
from dynamics.kinematics import contact_arms
from dynamics.landing.equations import LandingModel, LandingState
from dynamics.rattling import rattling_motion, rim_contacts
from dynamics.rattling.layout import DASHPOT, ELASTIC, FRICTION, VELOCITY
from dynamics.rigid_motion import RigidMotion
from modal import eigenmodes
from modal.elements import elastic
from modal.spectral import p_refinement, ritz
from sonify import load_scene
from sonify.claims.checks import CHECK_BY_KEY
from sonify.sound.audible_modes import RingDown
from sonify.sound.pressure import Sound

assert compliant_motion  # loads every compiled function before it is interpreted


def rigid_disk(**options):
    """Return the first second of the published motion."""
    scene = load_scene("published").replace("numerics.time_limit=1.0")
    return (simulate(scene, **options),)


def elastic_contact(name, *changes):
    """Return a motion with an elastic contact, of a shipped scene with changes."""
    scene = load_scene(name).replace(
        "contact.law=elastic",
        "numerics.contact=full",
        "numerics.accuracy=draft",
        *changes,
    )
    return (simulate(scene),)


def slipping_disk():
    """Return 0.6 ms of a disk whose elastic contact slips at once."""
    friction = ("friction.mu_static=0.02", "friction.mu_dynamic=0.01")
    return elastic_contact("published", "numerics.time_limit=6e-4", *friction)


def hopping_disk():
    """Return 1 ms of a disk that leaves a rough table twice."""
    return elastic_contact("granite", "numerics.time_limit=1e-3", "roughness.rms=3e-6")


def rattling_coin():
    """Return 0.5 ms of a coin on an uneven table, released with a slip."""
    scene = coin(2e-6, 1.0, 0.5, 1, 0.1, "friction.mu_dynamic=0.3")
    model = model_of(scene)
    state = rattling_motion.rolling_state_at_release(model, 0.1, scene.release.omega)
    state[VELOCITY, 0] += 0.05
    return (rattling_motion.simulate_rattling(model, state, 5e-4, 0.0),)


def lifted_disk():
    """Return the last second of a disk that the air lifts."""
    low = ("release.inclination_deg=0.6", "release.omega=[0.0,0.0,-3.2]")
    scene = load_scene("published").replace(
        "numerics.accuracy=draft", "air.film=acts", *low
    )
    return (simulate(scene),)


def free_disk():
    """Return modes and disk of the free published disk."""
    scene = load_scene("published").replace("support.kind=free")
    return eigenmodes(scene, below=22e3), scene.disk


def disk_on_patch():
    """Return the lowest modes and the disk of the published scene."""
    scene = load_scene("published").replace("numerics.accuracy=draft")
    return eigenmodes(scene, below=5e3), scene.disk


def free_modes():
    """Return the modes of the free published disk."""
    return free_disk()[:1]


def modes_on_patch():
    """Return the lowest modes of the published disk on its patch."""
    return disk_on_patch()[:1]


def sound_of(pressure):
    """Return a sound with given pressures (n,) [Pa]."""
    nothing = np.zeros(0)
    sound = Sound(
        name="wave",
        sample_rate=48000,
        columns=np.column_stack([pressure, pressure]).astype(np.float32),
        source_end=0.0,
        outcome=Outcome.SETTLED,
        ringing=RingDown(
            frequency=nothing, decay_rate=nothing, decay_rate_without_film=nothing
        ),
        energy_time=nothing,
        energy=nothing,
        names=("heave",),
    )
    return (sound,)


def wave():
    """Return a sound of 10 ms."""
    return sound_of(np.sin(np.arange(480.0)))


def driven_disk():
    """Return the motion of a disk that a moment about e_3 drives."""
    return rigid_disk(loads=DrivingLaw())


def disk_that_never_slips():
    """Return a motion that rolls where the friction exceeds its limit."""
    scene = load_scene("published").replace(
        "numerics.time_limit=1.0", "friction.mu_static=10.0"
    )
    motion = simulate(scene)
    constants = motion.plan.constants._replace(mu_static=0.5)
    return (replace(motion, plan=replace(motion.plan, constants=constants)),)


def wave_with_a_gap():
    """Return a sound with one sample that is not a number."""
    return sound_of(np.append(np.sin(np.arange(480.0)), nan))


class DrivingLaw(OwnLaw):
    """Moment that drives the precession."""

    def __call__(self, beta, omega, slip, law, flow) -> Loads:
        return Loads(M3=0.01 * omega[2])


def printed_energy(correct):
    """Return the energy (6.1) as printed, without its two corrections."""

    def energy(beta, omega, slip, law, *position):
        e, f = contact_arms(np.cos(beta), np.sin(beta), law.h, law.fillet)
        wrong = 2 * slip[1] * e * omega[0] - (f * omega[0]) ** 2 / 2
        return correct(beta, omega, slip, law, *position) + wrong

    return energy


def force_without_weight(correct):
    """Return a normal force that lacks the weight."""

    def force(motion, *state):
        return correct(motion, *state) - [0, 0, 1.2 * motion.disk.weight]

    return force


def scaled_force(cause, factor):
    """Return a fault of `add_force` that multiplies the forces by one cause."""

    def fault(correct):
        def add_force(contacts, of, force, arm):
            scale = factor if of == cause else 1.0
            correct(contacts, of, tuple(scale * part for part in force), arm)

        return add_force

    return fault


def scaled(factor):
    """Return a fault that multiplies every result of a function."""

    def fault(correct):
        def function(*arguments):
            found = correct(*arguments)
            if isinstance(found, tuple):
                return tuple(factor * part for part in found)
            return factor * found

        return function

    return fault


def no_projection(correct):
    """Return a fault that leaves the friction beyond its limit."""
    return lambda first, second, *rest: (first, second)


def no_record(correct):
    """Return a fault that records no loss of contact."""
    return lambda flights, flight, *rest: (False, flight)


def no_swirling(correct):
    """Return rates of a landing that forget the power of the precessing film."""
    swirling = LandingState._fields.index("swirling")

    def rates(model, t, y):
        found = correct(model, t, y)
        found[swirling] = 0.0
        return found

    return rates


def disturbed_vectors(correct):
    """Return a fault of an eigenvalue solver that changes the first entry of each vector."""

    def solver(*arguments, **options):
        found = correct(*arguments, **options)
        if options.get("eigvals_only"):
            return found
        values, vectors = found
        vectors[:1] += 1e-3 * np.abs(vectors).max(initial=0.0)
        return values, vectors

    return solver


def small_basis(correct):
    """Return a fault that does not enlarge the basis."""
    solve = p_refinement.solve_problem
    return lambda plate, p, size, below, tolerance: solve(plate, p, (2, 2), below)


def heavier_quadrature(correct):
    """Return a fault that makes the weights along the radius 1 % too large."""

    def gauss_grid(*arguments):
        rho, zeta, radial, axial = correct(*arguments)
        return rho, zeta, 1.01 * radial, axial

    return gauss_grid


def heavier_solid(correct):
    """Return a fault that makes the density of the elements 1 % too large."""

    def solid(*arguments, **options):
        found = correct(*arguments, **options)
        return replace(found, total_mass=1.01 * found.total_mass)

    return solid


def loud_copy(correct):
    """Return a scale of sound.wav at which the peak is beyond full scale."""
    return property(lambda sound: sound.peak / 1.1)


@dataclass(frozen=True)
class Mutant:
    """A fault in a run that a check must find.

    `run` returns the arguments of the check without the fault. `fault` replaces the
    function `name` of a module or class `where`, or `broken` is a run with the fault.
    """

    key: str
    run: Any
    where: Any = None
    name: str = ""
    fault: Any = None
    broken: Any = None

    def __str__(self):
        return f"{self.key}-{(self.broken or self.run).__name__}-{self.name}"


COIN = rattling_coin, rim_contacts, "add_force"
SLIP = slipping_disk, tangential, "project_on_friction_circle"
MUTANTS = [
    Mutant("energy_balance", rigid_disk, rigid_motion, "energy", printed_energy),
    Mutant("energy_balance", slipping_disk, normal, "mean_force", scaled(1.1)),
    Mutant("rattling_energy_balance", *COIN, scaled_force(ELASTIC, 0.2)),
    Mutant("dissipation_never_falls", rigid_disk, broken=driven_disk),
    Mutant("dissipation_never_falls", *SLIP, scaled(-1.0)),
    Mutant("dissipation_never_falls", *COIN, scaled_force(FRICTION, -1.0)),
    Mutant("friction_cone", rigid_disk, broken=disk_that_never_slips),
    Mutant("friction_cone", *SLIP, no_projection),
    Mutant("friction_cone", *COIN, scaled_force(FRICTION, 2.0)),
    Mutant("pushing_contact", rigid_disk, RigidMotion, "_force", force_without_weight),
    Mutant("pushing_contact", hopping_disk, time_loop, "record_flight", no_record),
    Mutant("pushing_contact", *COIN, scaled_force(DASHPOT, -1.0)),
    Mutant("landing_energy_balance", lifted_disk, LandingModel, "rates", no_swirling),
    Mutant("mode_residuals", free_modes, p_refinement, "eigh", disturbed_vectors),
    Mutant("mode_residuals", modes_on_patch, elastic, "eigsh", disturbed_vectors),
    Mutant("mode_errors", free_modes, p_refinement, "solve_to_tolerance", small_basis),
    Mutant("discrete_mass", free_disk, ritz, "gauss_grid", heavier_quadrature),
    Mutant("discrete_mass", disk_on_patch, elastic, "Solid", heavier_solid),
    Mutant("no_sample_clipped", wave, Sound, "full_scale", loud_copy),
    Mutant("no_sample_clipped", wave, broken=wave_with_a_gap),
]


def test_every_check_has_a_mutant():
    assert {mutant.key for mutant in MUTANTS} == set(CHECK_BY_KEY)


def test_checks_are_made_by_the_decorator_alone():
    """The page of a run makes one from a record, for its text."""
    package = Path(sonify.__file__).parent
    found = [
        path.relative_to(package).as_posix()
        for path in package.rglob("*.py")
        for node in ast.walk(ast.parse(path.read_text("utf-8")))
        if isinstance(node, ast.Call) and getattr(node.func, "id", "") == "Check"
    ]
    assert sorted(found) == ["claims/checks.py", "studio/run_list.py"]


@pytest.mark.slow
@pytest.mark.parametrize("mutant", MUTANTS, ids=str)
def test_a_check_fails_where_its_object_is_broken(mutant, monkeypatch):
    monkeypatch.setattr(rattling_motion, "PROGRESS_INTERVAL", 5e-4)
    if mutant.run in (slipping_disk, hopping_disk, rattling_coin):
        interpret_dynamics(monkeypatch)
    check = CHECK_BY_KEY[mutant.key]
    assert check(*mutant.run()).passed
    if mutant.fault:
        correct = getattr(mutant.where, mutant.name)
        monkeypatch.setattr(mutant.where, mutant.name, mutant.fault(correct))
    assert not check(*(mutant.broken or mutant.run)()).passed
