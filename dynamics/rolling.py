"""The rigid disk as a hybrid system: its start, its integration and its regime changes."""

import math
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from operator import add
from typing import TYPE_CHECKING, Any

from dynamics.dissipation import OwnLaw, Resistance
from dynamics.equations import ContactSolution, DiskConstants
from dynamics.guards import LIFT_OFF, STOP_SLIP_SPEED, GuardKind, guard_named
from dynamics.hybrid import MAX_STEPS_PER_ARC, Arc, StalledError, Step, Switch
from dynamics.integrators.slow_slide_criterion import is_stiff
from dynamics.regime import (
    FLOAT_FORMULAS,
    PRECESSION,
    V1,
    V2,
    W3,
    Branch,
    R,
    Regime,
    StateVector,
    describe_state,
    restart_quadratures,
    rotation_rates,
)
from dynamics.switching import (
    MAX_GRAZING_ACCELERATION,
    ImpossibleContactError,
    NoContactAtReleaseError,
    next_regime,
    slide_to_rest,
    state_after_reversal,
    with_rotation_zero,
)

if TYPE_CHECKING:
    from dynamics.disk import Disk, Release


@dataclass(frozen=True)
class RollingDisk:
    """Hybrid system of a disk with a rigid contact.

    Attributes
    ----------
    constants : DiskConstants
        Dimensionless constants of disk and friction.
    loads : OwnLaw, Resistance or None
        Law of dissipation in addition to friction.
    r_end : float
        Square root of the inclination at which the motion ends.
    integrate : callable
        Function `advance` of the integrator.
    tolerance : float
        Tolerance of the integrator.
    announce_compilation : callable
        Callback `announce_compilation(flow)`, called before a flow that may have to be
        compiled.
    """

    constants: DiskConstants
    loads: OwnLaw | Resistance | None
    r_end: float
    integrate: Callable[..., Any]
    tolerance: float
    announce_compilation: Callable[..., Any] = lambda flow: None

    def begin(self, y: list[float]) -> Switch:
        """Select the first regime of a disk released with its contact at rest."""
        if (
            self.loads
            and self.loads.nonsmooth_at_zero_precession
            and abs(y[W3]) <= STOP_SLIP_SPEED
        ):
            raise ImpossibleContactError(
                f"{describe_state(y)}: without precession the law of dissipation has no direction"
            )
        turns = rotation_rates(y)
        at_zero = {0} | {i + 1 for i in range(3) if abs(turns[i]) < 1e-14}
        start = self._select_next_regime(y, at_zero, (), (1.0, 1.0, 1.0))
        if start.ended:
            raise NoContactAtReleaseError(
                f"{describe_state(y)}: the disk leaves the plane at once"
            )
        return start

    def advance(self, y: list[float], regime: Regime, span: float) -> Arc:
        """Integrate within `regime`.

        The quadratures are reset to limit their rounding errors. Raises StalledError if
        the steps are too short.
        """
        local, offset = restart_quadratures(y, self.constants.bowl > 0)
        within = (local, regime, self.constants, self.loads, self.r_end, span)
        arc: Arc | None = None
        if self._is_stiff(y, regime):
            self.announce_compilation("slow slide")
            from dynamics.integrators.slow_slides import (
                advance_slow_slide,
            )  # numba loads slowly

            arc = advance_slow_slide(*within)
        if arc is None:
            self.announce_compilation(str(regime))
            arc = self.integrate(*within, self.tolerance)
        steps = len(arc.times)
        shortest_mean_step = 1e-5 * y[R]
        if (
            arc.guard is None
            and steps >= MAX_STEPS_PER_ARC
            and arc.times[-1] < min(shortest_mean_step * steps, span)
        ):
            raise StalledError(
                f"{describe_state(y)}: the steps become too short in {regime}"
            )
        return shift_arc(arc, offset)

    def _grazing_slide_from_rest(
        self, y: StateVector, nu: float, regime: Regime
    ) -> Arc | None:
        """Integrate a slide that starts along nu [rad] with almost no acceleration.

        A slide that is not stiff is integrated for one step only.
        """
        from dynamics.integrators.slow_slides import (
            advance_grazing_slide,
        )  # numba loads slowly

        local, offset = restart_quadratures(y, self.constants.bowl > 0)
        within = (local, nu, regime, self.constants, self.loads, self.r_end)
        arc = advance_grazing_slide(*within, not self._is_stiff(y, regime))
        return arc and shift_arc(arc, offset)

    def _is_stiff(self, y: StateVector, regime: Regime) -> bool:
        if not (regime.sliding and self.constants.mu_dynamic > 0):
            return False
        rests = y[V1] == y[V2] == 0
        return (
            self._is_grazing
            or rests
            or is_stiff(y, self._contact(y, regime), self.constants)
        )

    @property
    def _is_grazing(self) -> bool:
        """True if slides may start so slowly that slow_slides.py is tried first."""
        return (
            self.constants.mu_static
            < (1 + MAX_GRAZING_ACCELERATION) * self.constants.mu_dynamic
        )

    def _contact(self, y: StateVector, regime: Regime) -> ContactSolution:
        return FLOAT_FORMULAS.contact(
            y,
            Branch.of(regime, self.constants, self.loads),
            regime.senses,
            self.constants,
        )

    def switch(self, y: list[float], regime: Regime, guard: str) -> Switch:
        """Select the next regime after `guard` has fallen through zero."""
        guard = guard_named(guard)
        held = {
            i for i, holds in enumerate((not regime.sliding, *regime.stuck)) if holds
        }
        match guard.kind:
            case (
                GuardKind.REVERSES | GuardKind.UNSTICKS
            ):  # by far the most frequent case
                branch = Branch.of(regime, self.constants, self.loads)
                after = state_after_reversal(y, regime, branch, guard, self.constants)
                if after:
                    return Switch(after[1], after[0])
                fired = {guard.axis + 1} if guard.kind is GuardKind.UNSTICKS else ()
                return self._select_next_regime(
                    with_rotation_zero(y, guard.axis),
                    {*held, guard.axis + 1},
                    fired,
                    regime.senses,
                )
            case GuardKind.END:
                return Switch(None, y, ended=guard)
            case GuardKind.JAM:
                raise ImpossibleContactError(
                    f"{describe_state(y)}: the sliding contact jams: {guard.kind.value}"
                )
            case GuardKind.SLIP:
                if self._is_grazing:
                    self.announce_compilation("slow slide")
                return self._select_next_regime(y, held, {0}, regime.senses)
            case GuardKind.GRIP:
                return self._end_slide(y, regime, held)

    def _end_slide(self, y: list[float], regime: Regime, held: set[int]) -> Switch:
        """Bring a slide to rest, if possible, and select the next regime."""
        last, stops = slide_to_rest(y, regime, self.constants, self.loads)
        if not stops:
            return Switch(regime, last.end, (last,))
        y = last.end
        y[V1] = 0.0
        y[V2] = 0.0
        then = self._select_next_regime(y, held | {0}, (), regime.senses)
        return then._replace(steps=(last, *then.steps))

    def _select_next_regime(
        self,
        y: list[float],
        at_zero: Iterable[int],
        fired: Iterable[int],
        senses: tuple[float, float, float],
    ) -> Switch:
        at_zero = frozenset(at_zero)
        regime, step = next_regime(
            y,
            self.constants,
            self.loads,
            at_zero,
            frozenset(fired),
            senses,
            self._grazing_slide_from_rest,
        )
        if regime is None:
            return Switch(None, y, ended=LIFT_OFF)
        return (
            self._advance_first_slide_step(step, at_zero)
            if isinstance(step, Step)
            else Switch(regime, y, next_arc=step)
        )

    def _advance_first_slide_step(self, step: Step, at_zero: frozenset[int]) -> Switch:
        """Take the first step of a slide; shorten it if a rotation reverses.

        Otherwise the guard of this rotation would be negative at the end of the step.
        """
        _, stuck, senses = step.regime
        turning = [i for i in range(3) if self.constants.arms[i] > 0 and not stuck[i]]

        def guards(y: list[float]) -> dict[int, float]:
            turns = rotation_rates(y)
            return {i: senses[i] * turns[i] for i in turning}

        end, axis = first_guard_zero(step, guards)
        step = step._replace(duration=end)
        if self._contact(step.end, step.regime).Phi <= 0:
            # a negative guard cannot fall through zero
            return self._end_at_lift_off(step)
        y = step.end
        if axis is None:
            return Switch(step.regime, y, (step,))
        y = with_rotation_zero(y, axis)
        held = {*at_zero, axis + 1} - {0}
        if math.hypot(y[V1], y[V2]) < STOP_SLIP_SPEED:
            y[V1] = 0.0
            y[V2] = 0.0
            held |= {0}
        then = self._select_next_regime(y, held, (), senses)
        return then._replace(steps=(step, *then.steps))

    def _end_at_lift_off(self, step: Step) -> Switch:
        """End the motion where the normal force falls to zero within a step."""
        from scipy.optimize import brentq  # loads slowly

        def load(t: float) -> float:
            return self._contact(step.at(t), step.regime).Phi

        if load(0.0) <= 0:
            return Switch(None, step.at(0.0), ended=LIFT_OFF)
        step = step._replace(duration=brentq(load, 0.0, step.duration, xtol=1e-16))
        return Switch(None, step.end, (step,), ended=LIFT_OFF)


def first_guard_zero(step: Step, guards: Callable[..., Any]) -> tuple[float, Any]:
    """Find the first guard that falls to zero within a step.

    Returns its time and name, or the duration of the step and None. `guards(y)` is
    evaluated at equidistant times. Guards that are not positive at the start
    are ignored.
    """
    checks_per_step = 4
    before = guards(step.at(0.0))
    start = 0.0
    for look in (
        k * step.duration / checks_per_step for k in range(1, checks_per_step + 1)
    ):
        now = guards(step.at(look))
        falls = [name for name in now if before[name] > 0 >= now[name]]
        if falls:
            from scipy.optimize import brentq  # loads slowly

            roots = {
                name: brentq(
                    lambda t, n=name: guards(step.at(t))[n], start, look, xtol=1e-16
                )
                for name in falls
            }
            name = min(roots, key=roots.__getitem__)
            return roots[name], name
        start = look
        before = now
    return step.duration, None


def shift_arc(arc: Arc, origin: Sequence[float]) -> Arc:
    """Return an arc with the offset `origin` added to its quadratures."""
    end = [*arc.end[:PRECESSION], *map(add, arc.end[PRECESSION:], origin[PRECESSION:])]
    arc.coefficients[:, 0] += origin
    return arc._replace(end=end)


def initial_state(disk: "Disk", release: "Release") -> list[Any]:
    """Return the initial state (7.4), with the disk centre above the origin."""
    r = math.sqrt(math.radians(release.inclination_deg))
    return [r, *(w * disk.time_unit / r for w in release.omega), *[0.0] * 7]


def rolling_state(disk: "Disk", columns: Any) -> list[Any]:
    """Return the state of a disk that rolls with the COLUMNS (11,) of a motion, without slip."""
    precession, inclination, spin, x, y = map(float, columns[:5])
    r = math.sqrt(inclination)
    rates = (float(w) * disk.time_unit / r for w in columns[5:8])
    R = disk.radius
    return [r, *rates, 0.0, 0.0, precession, spin, x / R, y / R, 0.0]
