"""The formulas of one branch of the flow for compilers: a state and the numbers of a scene go in as
symbols."""

from collections.abc import Callable
from functools import lru_cache
from itertools import count, islice

import numpy as np

from dynamics.equations import Law
from dynamics.regime import Branch, Flow, Regime


def constants(regime: Regime, law: Law, loads, r_end: float) -> tuple[float, ...]:
    """Return the run-time numbers (n,) of a flow in the order in which `formulas` asks for their
    symbols."""
    return *law, *regime.senses, r_end, *(loads.numbers if loads else ())


def shape(regime: Regime, law: Law, loads) -> Branch:
    """Return the branch that is to be compiled: without any of the `constants`."""
    return Branch.of(regime, law, loads and loads.shape)


@lru_cache(64)
def prepared(compiled: Callable, regime: Regime, law: Law, loads, r_end: float, *how):
    """Return what `compiled(shape, *how)` makes of the flow of a regime, and the constants (n,) of
    the flow."""
    return compiled(shape(regime, law, loads), *how), np.array(constants(regime, law, loads, r_end))


def formulas(flow: Flow, y, branch: Branch, symbol):
    """Return the rates (k,) and the guards by name of a `shape`, for a state y (k,) and symbol(i)
    of constant i."""
    following = map(symbol, count())
    law = Law(*islice(following, len(Law._fields)))
    senses = tuple(islice(following, 3))
    r_end = next(following)
    if branch.loads:
        branch = branch._replace(loads=branch.loads.filled(following))
    contact = flow.contact(y, branch, senses, law)
    return flow.rates(y, contact, branch, law), flow.guards(y, contact, branch, senses, law, r_end)
