"""Compute benchmarks/references/motion.json: python -m
benchmarks.references.make_motion_reference

The integration between events uses 80-bit arithmetic, which the machine must have, and
the tolerance 1e-19; the changes of regime are determined in double precision. The
values of the published case come from tests/references/motion.json, an independent
simulation in quadruple precision. The script first checks the 80-bit integration
against them."""

import functools
import json
from pathlib import Path

import heyoka
import numpy as np

from benchmarks.cases.motion_case import (
    NUTATION_ARMS,
    PIVOTING_ARMS,
    SMALL_INCLINATIONS,
    answer_of_scaled,
    conservative,
    nearly_flat,
    nutation_arm,
    pivoting_arm,
    published,
    scaled,
    sticking,
)
from dynamics.hybrid import Arc, run_events
from dynamics.integrators.taylor import STATE_SYMBOLS, SYMBOLIC_FORMULAS
from dynamics.regime import Branch
from dynamics.rolling import RollingDisk

ROOT = Path(__file__).parents[2]
LONG = np.longdouble

GUARD_OFFSET = 1e-300
"""Offset of the guards: heyoka would detect a guard that is exactly 0 at the start and
miss its next root."""

PUBLISHED_SPANS = (1, 5, 10, 50, 100, 150)
CASES = (
    *(conservative(span) for span in (1.0, 10.0)),
    *(sticking(span) for span in (5.0, 20.0, 40.0)),
    *map(nutation_arm, NUTATION_ARMS),
    *map(pivoting_arm, PIVOTING_ARMS),
    *map(nearly_flat, SMALL_INCLINATIONS),
)
ABOUT = (
    "Inclination [rad] and dimensionless energy (6.1) of the release (7.4) at times tau. "
    "published: constants (7.1), "
    "(7.3); independent event-driven simulation in quadruple precision. Others: the cases of that "
    "name in "
    "benchmarks/cases/motion_case.py; event-driven Taylor series in 80-bit arithmetic, tolerance "
    "1e-19, made by "
    "benchmarks/references/make_motion_reference.py."
)


@functools.cache
def compiled(branch, senses, law):
    """Return the compiled 80-bit integrator of one branch."""
    y = heyoka.make_vars(*STATE_SYMBOLS)
    law = type(law)(*(heyoka.expression(LONG(x)) for x in law))
    contact = SYMBOLIC_FORMULAS.contact(y, branch, senses, law)
    rates = [
        heyoka.expression(r) if isinstance(r, float) else r
        for r in SYMBOLIC_FORMULAS.rates(y, contact, branch, law)
    ]
    guards = SYMBOLIC_FORMULAS.guards(
        y, contact, branch, senses, law, heyoka.expression(LONG(1e-9))
    )
    falling = {"direction": heyoka.event_direction.negative, "fp_type": LONG}
    events = [heyoka.t_event(g + GUARD_OFFSET, **falling) for g in guards.values()]
    options = {"tol": LONG(1e-19), "t_events": events, "fp_type": LONG}
    return heyoka.taylor_adaptive(
        list(zip(y, rates, strict=True)), [LONG(1)] * len(y), **options
    ), tuple(guards)


def advance(y, regime, law, loads, r_end, span, tolerance):
    """Integrate one regime like `dynamics.integrators.taylor`, in 80-bit arithmetic."""
    integrator, names = compiled(Branch.of(regime, law, loads), regime.senses, law)
    integrator.state[:] = y
    integrator.time = LONG(0)
    integrator.reset_cooldowns()
    outcome = heyoka.taylor_outcome.success
    while outcome == heyoka.taylor_outcome.success:
        outcome, _ = integrator.step(max_delta_t=LONG(span) - integrator.time)
    fired = (
        None
        if outcome == heyoka.taylor_outcome.time_limit
        else names[-int(outcome) - 1]
    )
    end = integrator.state.copy()
    return Arc(
        np.array([float(integrator.time)]), end[None, None].copy(), end.tolist(), fired
    )


class EightyBit(RollingDisk):
    """Rolling disk that solves all slides by `advance`, because the implicit steps have
    double precision."""

    def _is_stiff(self, y, regime):
        return False


def solved(case):
    """Return inclination and energy at the end of a case."""
    states = []
    system = EightyBit(case.law, None, 1e-9, advance, 0.0)
    run_events(system, scaled(case.start), case.span, lambda _, y: states.append(y))
    return list(answer_of_scaled(states[-1], case.law, 0).values)


def main():
    """Check the 80-bit integration on the published case, then write all cases."""
    samples = json.loads((ROOT / "tests/references/motion.json").read_text("utf-8"))[
        "samples"
    ]
    cases = {
        "published": {
            f"{s['tau']:g}": [s["beta"], s["E"]]
            for s in samples
            if s["tau"] in PUBLISHED_SPANS
        }
    }
    for span in (50.0, 100.0):
        error = np.abs(
            np.array(solved(published(span))) / cases["published"][f"{span:g}"] - 1
        ).max()
        print(f"published, tau = {span}: {error:.1e}")
        assert error < 1e-9
    for case in CASES:
        cases.setdefault(case.name, {})[f"{case.span:g}"] = solved(case)
    target = ROOT / "benchmarks/references/motion.json"
    target.write_text(
        json.dumps({"about": ABOUT, "cases": cases}, indent=1) + "\n", encoding="utf-8"
    )


if __name__ == "__main__":
    main()
