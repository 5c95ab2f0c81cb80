"""From a scene to its motion: `simulate`."""

import math
from collections.abc import Callable
from dataclasses import replace
from functools import cache
from importlib import import_module
from typing import Any

import numpy as np

from . import guards
from .dissipation import OwnLaw
from .equations import law_of
from .film.acting import loads_of
from .hybrid import CASCADE, STALLED, StalledError, drive
from .motion import Motion, MotionScene, Outcome, Transition, read_only
from .numerics import integrator_of
from .pieces import Pieces
from .regime import FLOAT, V1, V2, W1, W3, R, Regime
from .rigid_motion import RigidMotion
from .rolling import RollingDisk, released
from .switching import ImpossibleContactError

OUTCOMES = {
    guards.FLAT: Outcome.SETTLED,
    guards.FALLS: Outcome.FELL,
    guards.UPRIGHT: Outcome.UPRIGHT,
    guards.LIFT_OFF: Outcome.LIFTED_OFF,
    guards.PRECESSION_STOPS: Outcome.PRECESSION_STOPPED,
    CASCADE: Outcome.CASCADE,
    STALLED: Outcome.STALLED,
    None: Outcome.TIME_LIMIT,
}


CARRIES = 0.01
"""Part of the weight that a film bears at least where it, and not the turning of the disk, takes the contact force."""
GONE = 1e-9
"""Part of the weight below which the contact force is gone, where regimes change at one instant without end."""


Watch = Callable[[float, float, str], None]


def simulate(
    scene: MotionScene,
    watch: Watch = lambda t, inclination, doing: None,
    loads: OwnLaw | None = None,
    surface_modes: Any = None,
) -> Motion:
    """Solve the motion of `scene`, in which `loads`, where given, resist in place of its dissipation.

    It is that of the rigid disk, event by event, unless the contact of the scene is elastic and `coupled.choice` has it
    solved in full. A table with surface.action = "motion" moves with the disk by its modes (`modal.SurfaceModes`), and
    one with "auto" from where `coupled.acting` says.

    `watch(t, inclination, doing)` [s, rad] is called on the way, and before a wait for the compiler, which `doing` then
    names. Threads may call this at the same time and share scenes and motions, which nobody changes; every call has
    integrators of its own. Raises ImpossibleContactError, with time and state, where no contact force satisfies the
    balance laws, and ValueError where a profile cannot be read or `loads` are given to an elastic contact.
    """
    if loads is None and getattr(getattr(scene, "surface", None), "action", "") == "auto" and surface_modes is not None:
        from .coupled.acting import acting

        table = acting(scene, surface_modes)
        if table.acts:
            from .coupled.handed import hand_over

            return hand_over(scene, table.inclination, lambda part: simulate(part, watch), watch, surface_modes)
    if is_compliant(scene):
        from .coupled.motion import solve

        if loads is not None:
            raise ValueError("loads: a law of your own acts on a rigid contact, or with numerics.contact = 'filter'")
        return solve(scene, watch, surface_modes)
    prepare(scene, loads)
    disk, system = scene.disk, system_of(scene, loads)
    known, now, inclination, last = set(), 0.0, math.radians(scene.release.inclination_deg), None

    def announce(what):
        if what not in known:
            known.add(what)
            watch(now, inclination, f"compiling the flow of '{what}'")

    def integrate(y, regime, *rest):
        announce(str(regime))
        return system.integrate(y, regime, *rest)

    def watched(tau, y):
        nonlocal now, inclination, last
        now, inclination, last = tau * disk.time_unit, y[R] ** 2, y
        watch(now, inclination, "")

    span = scene.numerics.time_limit / disk.time_unit
    try:
        path, guard = drive(
            replace(system, integrate=integrate, announce=announce), released(disk, scene.release), span, watched
        )
    except (ImpossibleContactError, StalledError) as error:
        raise ImpossibleContactError(f"at t = {now:.9g} s: {error}") from None
    motion = _motion(disk, system, path, outcome_of(guard, last, system), integrator_of(scene.numerics.integrator))
    if guard == CASCADE and motion.normal_load(motion.t[-1])[0] < GONE:  # friction of no force holds nothing
        return replace(motion, outcome=outcome_of(guards.LIFT_OFF, last, system))
    return motion


def outcome_of(guard: str | None, y, system: RollingDisk) -> Outcome:
    """Return how a motion ended whose last guard, at state y, was `guard`.

    Where the contact force is gone and a film bears more than CARRIES of the weight, the air carries the disk.
    """
    if guard == guards.LIFT_OFF and system.loads:
        r = y[R]
        state = r * r, tuple(r * w for w in y[W1 : W3 + 1]), (r * y[V1], r * y[V2])
        if system.loads(*state, system.law, FLOAT).G3 > CARRIES * (system.law.K + 4) / 4:
            return Outcome.AIRBORNE
    return OUTCOMES[guard]


def prepare(scene: MotionScene, loads: OwnLaw | None = None) -> None:
    """Begin to compile the flows that most motions need, beside whatever is done before `scene` is simulated."""
    if integrator_of(scene.numerics.integrator) == "taylor" and not is_compliant(scene):
        from . import taylor

        system = system_of(scene, loads)
        for sliding in (False, True)[: 1 if system.law.mu_static == math.inf else 2]:
            taylor.prepare(Regime(sliding, (False,) * 3, (1.0,) * 3), system.law, system.loads, system.tolerance)


def is_compliant(scene: MotionScene) -> bool:
    """Return whether the contact of a scene, which may say nothing on it, is elastic and solved in full."""
    contact = getattr(scene, "contact", None)
    if contact is None or contact.law == "rigid":
        return False
    from .coupled.choice import choice

    return choice(scene).kind == "full"  # type: ignore[arg-type]


def system_of(scene: MotionScene, loads: OwnLaw | None) -> RollingDisk:
    """Return the hybrid system of a scene."""
    disk, numerics = scene.disk, scene.numerics
    return RollingDisk(
        law=law_of(disk, scene.friction),
        loads=loads_of(scene, loads),
        r_end=math.sqrt(numerics.stopping_inclination(disk)),
        integrate=chosen_integrator(numerics.integrator)[1],
        tolerance=numerics.chosen_tolerance,
    )


def chosen_integrator(name: str):
    """Return name and flow of the integrator asked for, see `integrator_of`; nothing else is imported."""
    name = integrator_of(name)
    return name, import_module(f".{name}", __package__).advance


def _motion(disk, system, path, outcome, name) -> RigidMotion:
    """Join the pieces of a path to one record; pieces of no duration are left out."""
    x, blocks = np.concatenate(path.times), path.coefficients
    lasting, start = np.diff(x) > 0, 0
    terms = np.zeros((np.count_nonzero(lasting), blocks[0].shape[2], max(block.shape[1] for block in blocks)))
    ends = np.cumsum([len(block) for block in blocks])
    for block, keep in zip(blocks, np.split(lasting, ends[:-1]), strict=True):
        block = block if keep.all() else block[keep]
        terms[start : start + len(block), :, : block.shape[1]] = block.swapaxes(1, 2)
        start += len(block)
    regimes = tuple(dict.fromkeys(regime for regime, _ in path.regimes))
    kinds = np.repeat([regimes.index(regime) for regime, _ in path.regimes], [n for _, n in path.regimes])
    chi = disk.time_unit
    name_of = cache(str)
    crossings = (Transition(a.t * chi, name_of(a.before), name_of(a.after), a.guard) for a in path.crossings)
    return RigidMotion(
        disk=disk,
        law=system.law,
        loads=system.loads,
        path=Pieces(read_only(terms.transpose(2, 0, 1)[::-1]), read_only(np.append(x[0], x[1:][lasting]))),
        regimes=regimes,
        regime_of_piece=read_only(kinds[lasting]),
        transitions=tuple(crossings),
        contact_losses=(),
        outcome=outcome,
        integrator=name,
    )
