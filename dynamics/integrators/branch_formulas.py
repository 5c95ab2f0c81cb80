"""Formulas of one branch of the flow for compilers, with symbolic state and constants."""

from collections.abc import Callable
from functools import lru_cache
from itertools import count, islice

import numpy as np

from dynamics.equations import DiskConstants
from dynamics.regime import Branch, FlowFormulas, Regime


def flow_constants(regime: Regime, law: DiskConstants, loads, r_end: float) -> tuple[float, ...]:
    """Return the run-time constants (n,) of a flow, in the order of their symbols in `rates_and_guards`."""
    return *law, *regime.senses, r_end, *(loads.runtime_parameters if loads else ())


def branch_to_compile(regime: Regime, law: DiskConstants, loads) -> Branch:
    """Return the branch to compile, which contains none of the `flow_constants`."""
    return Branch.of(regime, law, loads and loads.compiled_form)


@lru_cache(64)
def compiled_flow(
    compiled: Callable, regime: Regime, law: DiskConstants, loads, r_end: float, *how
):
    """Return `compiled(branch, *how)` for a regime, and the constants (n,) of its flow."""
    return compiled(branch_to_compile(regime, law, loads), *how), np.array(
        flow_constants(regime, law, loads, r_end)
    )


def rates_and_guards(flow: FlowFormulas, y, branch: Branch, symbol):
    """Return the rates (k,) and the guards of a branch, for a state y (k,) and the symbol(i) of
    constant i."""
    following = map(symbol, count())
    law = DiskConstants(*islice(following, len(DiskConstants._fields)))
    senses = tuple(islice(following, 3))
    r_end = next(following)
    if branch.loads:
        branch = branch._replace(loads=branch.loads.with_parameters(following))
    contact = flow.contact(y, branch, senses, law)
    return flow.rates(y, contact, branch, law), flow.guards(y, contact, branch, senses, law, r_end)
