"""Equations of motion of one branch with symbolic state and constants, for compilation."""

from collections.abc import Callable
from functools import lru_cache
from itertools import count, islice
from typing import TYPE_CHECKING, Any

import numpy as np

from dynamics.equations import DiskConstants, NumberOrExpression
from dynamics.pivoting import PIVOTING_COEFFICIENT_COUNT
from dynamics.regime import Branch, FlowFormulas, Regime, StateVector

if TYPE_CHECKING:
    from dynamics.guards import Guard


def flow_constants(
    regime: Regime, constants: DiskConstants, loads: Any, r_end: float
) -> tuple[float, ...]:
    """Return the run-time constants (n,) of a flow, ordered as in `rates_and_guards`."""
    own = loads.runtime_parameters if loads else ()
    return *constants[:-1], *regime.senses, r_end, *constants.pivoting, *own


def branch_to_compile(regime: Regime, constants: DiskConstants, loads: Any) -> Branch:
    """Return the branch of a regime without any of the `flow_constants`."""
    return Branch.of(regime, constants, loads and loads.compiled_form)


@lru_cache(64)
def compiled_flow_and_constants(
    compiled: Callable[..., Any],
    regime: Regime,
    constants: DiskConstants,
    loads: Any,
    r_end: float,
    *options: Any,
) -> tuple[Any, np.ndarray]:
    """Return `compiled(branch, *options)` of a regime, and the constants of its flow."""
    return compiled(branch_to_compile(regime, constants, loads), *options), np.array(
        flow_constants(regime, constants, loads, r_end)
    )


def rates_and_guards(
    flow: FlowFormulas,
    y: StateVector,
    branch: Branch,
    symbol: Callable[[int], NumberOrExpression],
) -> "tuple[list[NumberOrExpression], dict[Guard, NumberOrExpression]]":
    """Return the rates (k,) and the guards of a branch at a state y (k,).

    `symbol(i)` is the symbol of run-time constant i.
    """
    following = map(symbol, count())
    constants = DiskConstants(*islice(following, len(DiskConstants._fields) - 1))
    senses = tuple(islice(following, 3))
    r_end = next(following)
    if not branch.has_fillet:
        constants = constants._replace(fillet=0.0)
    if not branch.has_bowl:
        constants = constants._replace(bowl=0.0, bowl_x=0.0, bowl_y=0.0)
    if branch.has_spin_friction:
        constants = constants._replace(
            pivoting=tuple(islice(following, 2 * PIVOTING_COEFFICIENT_COUNT))
        )
    if branch.loads:
        branch = branch._replace(loads=branch.loads.with_parameters(following))
    contact = flow.contact(y, branch, senses, constants)
    return flow.rates(y, contact, branch, constants), flow.guards(
        y, contact, branch, senses, constants, r_end
    )
