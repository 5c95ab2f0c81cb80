"""The rolling disk as a hybrid system for hybrid.py: start, flow and switching."""

import math
from collections.abc import Callable
from dataclasses import dataclass
from operator import add

from dynamics.dissipation import OwnLaw, Resistance
from dynamics.equations import DiskConstants
from dynamics.guards import AXES, LIFT_OFF, STOP_SPEED, GuardKind, guard_named
from dynamics.hybrid import Arc, StalledError, Step, Switch
from dynamics.integrators.slow_slide_criterion import is_stiff
from dynamics.regime import (
    FLOAT_FORMULAS,
    PRECESSION,
    SPIN,
    V1,
    V2,
    W3,
    Branch,
    R,
    Regime,
    describe_state,
    rotation_rates,
)
from dynamics.switching import (
    MAX_GRAZING_ACCELERATION,
    ImpossibleContactError,
    next_regime,
    slide_to_rest,
    with_rotation_zero,
)


@dataclass(frozen=True)
class RollingDisk:
    """Hybrid system of a disk with a rigid contact.

    Attributes
    ----------
    law : DiskConstants
        Dimensionless constants of disk and friction.
    loads : OwnLaw, Resistance or None
        Law of resistance in addition to friction.
    r_end : float
        Square root of the inclination at which the motion ends.
    integrate : callable
        Function `advance` of the integrator.
    tolerance : float
        Tolerance of the integrator.
    announce : callable
        `announce(what)` is called before each slow slide, since the compiler may run first.
    """

    law: DiskConstants
    loads: OwnLaw | Resistance | None
    r_end: float
    integrate: Callable
    tolerance: float
    announce: Callable = lambda what: None

    def begin(self, y) -> Switch:
        """Select the first regime of a disk that is released with its contact at rest."""
        if self.loads and self.loads.is_singular and abs(y[W3]) <= STOP_SPEED:
            raise ImpossibleContactError(
                f"{describe_state(y)}: without precession the law of dissipation has no direction"
            )
        turns = rotation_rates(y)
        at_zero = {0} | {i + 1 for i in range(3) if abs(turns[i]) < 1e-14}
        start = self._select_next_regime(y, at_zero)
        if start.ended:
            raise ImpossibleContactError(f"{describe_state(y)}: the disk leaves the plane at once")
        return start

    def advance(self, y, regime: Regime, span: float) -> Arc:
        """Integrate within `regime`.

        Precession and quadratures restart near zero, which limits their rounding errors. Raises
        StalledError if all steps are too short.
        """
        local, offset = restart_quadratures(y)
        within = (local, regime, self.law, self.loads, self.r_end, span)
        arc = None
        if self._is_stiff(y, regime):
            self.announce("slow slide")
            from dynamics.integrators.slow_slides import advance_slow_slide  # numba loads slowly

            arc = advance_slow_slide(*within)
        arc = arc or self.integrate(*within, self.tolerance)
        steps = len(arc.times)
        shortest_mean_step = 1e-5 * y[R]
        if (
            arc.guard is None
            and steps >= 1000
            and arc.times[-1] < min(shortest_mean_step * steps, span)
        ):
            raise StalledError(f"{describe_state(y)}: every step is too short in {regime}")
        return shift_arc(arc, offset)

    def _slide_from_rest(self, y, nu, regime) -> Arc | None:
        """Integrate a slide that starts from rest along nu with almost no acceleration.

        A slide that is not stiff is integrated for one step only.
        """
        from dynamics.integrators.slow_slides import (  # numba loads slowly
            MAX_STEPS_PER_CALL,
            advance_from_grazing,
        )

        local, offset = restart_quadratures(y)
        most = MAX_STEPS_PER_CALL if self._is_stiff(y, regime) else 1
        arc = advance_from_grazing(local, nu, regime, self.law, self.loads, self.r_end, most)
        return arc and shift_arc(arc, offset)

    def _is_stiff(self, y, regime) -> bool:
        if not (regime.sliding and self.law.mu_dynamic > 0):
            return False
        rests = y[V1] == y[V2] == 0
        return self._is_grazing or rests or is_stiff(y, self._contact(y, regime), self.law)

    @property
    def _is_grazing(self) -> bool:
        """True if slides start with such a small acceleration that slow_slides.py is tried first."""
        return self.law.mu_static < (1 + MAX_GRAZING_ACCELERATION) * self.law.mu_dynamic

    def _contact(self, y, regime):
        return FLOAT_FORMULAS.contact(
            y, Branch.of(regime, self.law, self.loads), regime.senses, self.law
        )

    def switch(self, y, regime: Regime, guard: str) -> Switch:
        """Select the next regime after `guard` has fallen to zero."""
        guard = guard_named(guard)
        held = {i for i, holds in enumerate((not regime.sliding, *regime.stuck)) if holds}
        match guard.kind:
            case GuardKind.REVERSES | GuardKind.UNSTICKS:  # by far the most frequent case
                fired = {guard.axis + 1} if guard.kind is GuardKind.UNSTICKS else ()
                return self._select_next_regime(
                    with_rotation_zero(y, guard.axis), {*held, guard.axis + 1}, fired, regime.senses
                )
            case GuardKind.END:
                return Switch(None, y, ended=guard)
            case GuardKind.JAM:
                raise ImpossibleContactError(
                    f"{describe_state(y)}: the slide jams, {guard.kind.value}"
                )
            case GuardKind.SLIP:
                if self._is_grazing:
                    self.announce("slow slide")
                return self._select_next_regime(y, held, fired={0}, senses=regime.senses)
            case GuardKind.GRIP:
                return self._end_slide(y, regime, held)

    def _end_slide(self, y, regime, held) -> Switch:
        """Bring a slide to rest and select the next regime, or continue a slide that does not stop."""
        last, stops = slide_to_rest(y, regime, self.law, self.loads)
        if not stops:
            return Switch(regime, last.end, (last,))
        y = last.end
        y[V1] = y[V2] = 0.0
        then = self._select_next_regime(y, held | {0}, senses=regime.senses)
        return then._replace(steps=(last, *then.steps))

    def _select_next_regime(self, y, at_zero, fired=(), senses=(1.0, 1.0, 1.0)) -> Switch:
        at_zero = frozenset(at_zero)
        fired = frozenset(fired)
        regime, step = next_regime(
            y, self.law, self.loads, at_zero, fired, senses, self._slide_from_rest
        )
        if regime is None:
            return Switch(None, y, ended=LIFT_OFF)
        return (
            self._take_first_step(step, at_zero)
            if isinstance(step, Step)
            else Switch(regime, y, ahead=step)
        )

    def _take_first_step(self, step, at_zero) -> Switch:
        """Take the first step of a slide; end it early if a rotation reverses within the step.

        After the reversal, the guard of this rotation would start below zero.
        """
        _, stuck, senses = step.regime
        arms = (self.law.k1, self.law.k2, self.law.k3)

        def guards(y):
            turns = zip(AXES, arms, stuck, senses, rotation_rates(y), strict=True)
            return {
                axis: sense * turn for axis, arm, held, sense, turn in turns if arm > 0 and not held
            }

        end, axis = first_guard_zero(step, guards)
        step = step._replace(duration=end)
        if (
            self._contact(step.end, step.regime).Phi <= 0
        ):  # a guard that starts below zero cannot fall
            return self._lifts_off(step)
        y = step.end
        if axis is None:
            return Switch(step.regime, y, (step,))
        y = with_rotation_zero(y, AXES.index(axis))
        held = {*at_zero, AXES.index(axis) + 1} - {0}
        if math.hypot(y[V1], y[V2]) < STOP_SPEED:
            y[V1] = y[V2] = 0.0
            held |= {0}
        then = self._select_next_regime(y, held, senses=senses)
        return then._replace(steps=(step, *then.steps))

    def _lifts_off(self, step: Step) -> Switch:
        """End the motion at the time within a step at which the normal force reaches zero."""
        from scipy.optimize import brentq  # loads slowly

        def load(t):
            return self._contact(step.at(t), step.regime).Phi

        if load(0.0) <= 0:
            return Switch(None, step.at(0.0), ended=LIFT_OFF)
        step = step._replace(duration=brentq(load, 0.0, step.duration, xtol=1e-16))
        return Switch(None, step.end, (step,), ended=LIFT_OFF)


def first_guard_zero(step: Step, guards: Callable, checks: int = 4):
    """Find the first guard that falls to zero within a step.

    Returns the time and the name of the guard, or the duration of the step and None. `guards(y)`
    is evaluated at `checks` equidistant times. A guard that is not positive at the start is
    ignored.
    """
    before = guards(step.at(0.0))
    start = 0.0
    for look in (k * step.duration / checks for k in range(1, checks + 1)):
        now = guards(step.at(look))
        falls = [name for name in now if before[name] > 0 >= now[name]]
        if falls:
            from scipy.optimize import brentq  # loads slowly

            roots = {
                name: brentq(lambda t, n=name: guards(step.at(t))[n], start, look, xtol=1e-16)
                for name in falls
            }
            name = min(roots, key=roots.get)
            return roots[name], name
        start = look
        before = now
    return step.duration, None


def restart_quadratures(y):
    """Return y with precession in [-pi, pi] and zero quadratures, and the subtracted offset."""
    turned = math.remainder(y[PRECESSION], 2 * math.pi)
    lost = [*[0.0] * PRECESSION, y[PRECESSION] - turned, *y[SPIN:]]
    return [*y[:PRECESSION], turned, *[0.0] * 4], lost


def shift_arc(arc, origin):
    """Return an arc with precession and quadratures shifted to start at `origin`."""
    end = [*arc.end[:PRECESSION], *map(add, arc.end[PRECESSION:], origin[PRECESSION:])]
    return Arc(arc.times, arc.coefficients, end, arc.guard, arc.passed, origin)


def initial_state(disk, release) -> list:
    """Return the initial state (7.4): the contact at rest, the centre above the origin."""
    r = math.sqrt(math.radians(release.inclination_deg))
    return [r, *(w * disk.time_unit / r for w in release.omega), *[0.0] * 7]
