"""A motion that begins on a table that does not act back, and goes on in steps of two ways where it does."""

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cached_property
from types import SimpleNamespace
from typing import Any

import numpy as np

from ..disk import Disk
from ..motion import Answers, Jumps, Motion, Outcome, Transition, read_only
from .full import Losses
from .motion import CompliantMotion, solve


class Changed:
    """A scene of which some sections are others."""

    def __init__(self, scene, **sections):
        self.__dict__.update(sections, _scene=scene)

    def __getattr__(self, name):
        return getattr(self._scene, name)


def hand_over(scene, inclination: float, alone: Callable, watch, modes) -> Motion:
    """Solve a scene by `alone(scene)` down to an inclination [rad], then on the modes of its table.

    A motion that does not come so far is the one alone. A contact that is rigid there yields from then on.
    """
    short = replace(scene.numerics, final_inclination=inclination)
    first = alone(Changed(scene, numerics=short))
    if first.outcome is not Outcome.SETTLED:
        return first
    t = float(first.t[-1])
    left = replace(scene.numerics, time_limit=scene.numerics.time_limit - t)
    yields = replace(scene.contact, law="elastic")
    parts = Changed(scene, numerics=left, contact=yields, surface=SimpleNamespace(action="motion"))
    state, force = first.at_and_force(t)
    then = solve(parts, lambda now, *rest: watch(t + now, *rest), modes, (state[0], force[0]))
    return HandedOver(first, then, then.outcome)


@dataclass(frozen=True, eq=False)
class HandedOver(Answers):
    """A `Motion` in two parts: `first` on a table that does not act back, `then` on one that does.

    What the energies of both differ by where they meet, since table and contact yield there, counts as dissipated.
    """

    first: Motion
    then: CompliantMotion
    outcome: Outcome

    def __repr__(self):
        """In one line."""
        return f"Motion({self.t[-1]:.6g} s, {self.outcome.name}, handed over at {self.handed_over:.6g} s)"

    @property
    def disk(self) -> Disk:
        """The disk."""
        return self.first.disk

    @property
    def loads(self) -> Any:
        """What acts on the disk beside its contact, in both parts: the film of air."""
        return getattr(self.first, "loads", None)

    @property
    def integrator(self) -> str:
        """How both parts were solved."""
        return f"{self.first.integrator}, then {self.then.integrator}"

    @cached_property
    def handed_over(self) -> float:
        """When the second part begins [s]."""
        return float(self.first.t[-1])

    @cached_property
    def t(self) -> np.ndarray:
        """Ends of the pieces of the solution, (n,) [s]."""
        return read_only(np.concatenate([self.first.t, self.handed_over + self.then.t[1:]]))

    @property
    def t_end(self) -> float:
        """The time [s] at which the inclination of a settled motion would be zero."""
        return self.handed_over + self.then.t_end

    @cached_property
    def jumps(self) -> Jumps:
        """Those of the first part: an elastic contact has none."""
        return self.first.jumps

    @cached_property
    def transitions(self) -> tuple[Transition, ...]:
        """Those of both parts."""
        later = (event._replace(t=event.t + self.handed_over) for event in self.then.transitions)
        return (*self.first.transitions, *later)

    @cached_property
    def contact_losses(self) -> Losses:
        """Those of both parts."""
        later = self.then.contact_losses.array + np.array([self.handed_over, 0, 0])
        return Losses(np.vstack([np.reshape(list(self.first.contact_losses), (-1, 3)), later]))

    @cached_property
    def _offset(self) -> np.ndarray:
        """What the columns of the second part lack: angles that went round before, and what was dissipated."""
        end, begin = self.first.at(self.handed_over)[0], self.then.at(0.0)[0]
        offset = np.zeros(len(end))
        offset[[0, 2]] = (end - begin)[[0, 2]]
        offset[-1] = end[-1] + self.first.energy(self.handed_over)[0] - self.then.energy(0.0)[0]
        return offset

    def _since(self, t) -> np.ndarray:
        """Return the times t (k,) [s] in the second part, its end where they are that of the motion, rounded."""
        return np.where(t <= self.t[-1], np.minimum(t - self.handed_over, self.then.t[-1]), t - self.handed_over)

    def _both(self, name, t):
        """Return what the method `name` of the part to which each time belongs says of it."""
        t = np.atleast_1d(np.asarray(t, dtype=float))
        late = t >= self.handed_over
        early, later = getattr(self.first, name)(t[~late]), getattr(self.then, name)(self._since(t[late]))
        out = np.empty((len(t), *early.shape[1:]), dtype=np.result_type(early, later))
        out[~late], out[late] = early, later
        return out

    def at(self, t) -> np.ndarray:
        """Return the state at the times t (k,) [s] as (k, 11): COLUMNS, in SI units; the frame of omega precesses."""
        late = np.atleast_1d(t) >= self.handed_over
        return self._both("at", t) + late[:, None] * self._offset

    def force(self, t) -> np.ndarray:
        """Return the contact force at times t (k,) [s] as (k, 3) [N]: friction along a_1, a_2, and the normal force."""
        return self._both("force", t)

    def steady_load(self, t) -> np.ndarray:
        """Return the normal force (k,) [N] at t (k,) without the vibration of the contact."""
        return self._both("steady_load", t)

    def energy(self, t) -> np.ndarray:
        """Return kinetic, potential and elastic energy [J] at times t (k,) [s], with that of a table that acts back."""
        return self._both("energy", t)

    def table_energy(self, t) -> np.ndarray:
        """Return the energy of the modes of the table at t (k,) [s], (k,) [J], since it acts back."""
        late = np.atleast_1d(t) >= self.handed_over
        return np.where(late, self.then.table_energy(np.maximum(self._since(np.atleast_1d(t)), 0.0)), 0.0)

    def regime(self, t) -> np.ndarray:
        """Return the name of the regime at the times t (k,) [s], an array of strings."""
        return self._both("regime", t)

    def bandwidth(self, state) -> np.ndarray:
        """Return the highest frequency (k,) [Hz] that the contact force is taken to hold at states (k, 11)."""
        late = state[:, -1] >= self._offset[-1]  # what is dissipated never falls
        return np.where(late, self.then.bandwidth(state), self.first.bandwidth(state))

    def largest_regain(self) -> float:
        """Return by how much [J] the dissipated energy ever falls, from any instant to any later one."""
        where_they_meet = float(self.first.at(self.handed_over)[0, -1] - self._offset[-1])
        return max(self.first.largest_regain(), self.then.largest_regain(), where_they_meet)

    def friction_excess(self) -> float:
        """Return by how much, over the weight, friction exceeds its law in either part."""
        return max(self.first.friction_excess(), self.then.friction_excess())
