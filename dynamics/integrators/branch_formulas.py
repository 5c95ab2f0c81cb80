"""Formulas of one branch of the flow for compilers, with symbols for state and constants."""

from collections.abc import Callable
from functools import lru_cache
from itertools import count, islice

import numpy as np

from dynamics.equations import Law
from dynamics.regime import Branch, Flow, Regime


def constants(regime: Regime, law: Law, loads, r_end: float) -> tuple[float, ...]:
    """Return the run-time constants (n,) of a flow, in the order of their symbols in `formulas`."""
    return *law, *regime.senses, r_end, *(loads.numbers if loads else ())


def shape(regime: Regime, law: Law, loads) -> Branch:
    """Return the branch to compile, which contains none of the `constants`."""
    return Branch.of(regime, law, loads and loads.shape)


@lru_cache(64)
def prepared(compiled: Callable, regime: Regime, law: Law, loads, r_end: float, *how):
    """Return `compiled(shape, *how)` for a regime, and the constants (n,) of its flow."""
    return compiled(shape(regime, law, loads), *how), np.array(constants(regime, law, loads, r_end))


def formulas(flow: Flow, y, branch: Branch, symbol):
    """Return the rates (k,) and the guards of a `shape`, for a state y (k,) and the symbol(i) of
    constant i."""
    following = map(symbol, count())
    law = Law(*islice(following, len(Law._fields)))
    senses = tuple(islice(following, 3))
    r_end = next(following)
    if branch.loads:
        branch = branch._replace(loads=branch.loads.filled(following))
    contact = flow.contact(y, branch, senses, law)
    return flow.rates(y, contact, branch, law), flow.guards(y, contact, branch, senses, law, r_end)
