"""The full compliant motion: a rigid disk on an elastic, rough contact with creep, slip and loss of contact.

Valid from upright down to LEAST_INCLINATION, where one ellipse no longer is the contact, and while the roughness under
the ellipse makes one contact (roughness.shift_of_contact below 1). The normal force follows the gap at every step; the
tangential springs and the length of the ellipse are those under the weight, at the inclination of the step.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np

from ..disk import LARGEST, Friction
from ..film.law import Film
from .bending import RIGID, Bending
from .contact import LEAST_INCLINATION
from .march import CARRIED, FLAT, GOES, UNSOLVED, UPRIGHT, march
from .profile import SMOOTH, Profile
from .resonance import inertias, rate_needed
from .sections import Imperfection
from .state import AXIS, SIZE
from .table import STEP, LawTable
from .waves import settle, still, wavy

RATE = 400e3
"""Steps a second: safe to 1e-6 rad."""
STEPS = 2**15
"""Steps that are taken together, or one row where it takes more."""
NODES = 10
"""Nodes of the table of the law from one to the next at which the rate needed is known: between, right to 2e-4."""
ENDS = {
    FLAT: "the inclination reached its final value: below, one ellipse is not the contact",
    UPRIGHT: "the disk stood upright on a generator of its lateral surface: contact passes to the other rim",
    UNSOLVED: "the roughness turned the disk too far in one step: several contacts at once, or too low a rate",
    CARRIED: "the film of air carried the disk: without a contact it is no wedge",
}
"""Why a motion stopped, in words."""


class ContactLoss(NamedTuple):
    """A flight of the contact: begin and duration [s], greatest height [m] of the edge above the table."""

    t: float
    duration: float
    height: float


class Losses(Sequence):
    """Losses of contact, kept as an array (n, 3): begin, duration [s], height [m]."""

    def __init__(self, array):
        self.array = array

    def __len__(self):
        return len(self.array)

    def __getitem__(self, i):
        return Losses(self.array[i]) if isinstance(i, slice) else ContactLoss(*self.array[i].tolist())

    def __repr__(self):
        return f"Losses({len(self)}, {self.array[:, 1].sum():.4g} s in all)"


class Piece(NamedTuple):
    """A stretch of motion, and what ended in it.

    Times (n,) [s], states (n, SIZE), mean forces (n p, 3) [N] along a_1, a_2 and the normal, p of them since the row
    before; losses of contact; slips (s, 2), begin and end [s]; why the motion stopped, GOES where it did not.
    """

    t: np.ndarray
    state: np.ndarray
    force: np.ndarray
    losses: Losses
    slips: np.ndarray
    why: int


@dataclass(frozen=True, kw_only=True, eq=False)
class Compliant:
    """A disk on a table: the law of its contact, friction, power laws (c [W s^b], b) of the precession rate, a moment
    [N m s] and a force [N s/m] per velocity.

    `profiles` of table and edge; `impedance` Z [N s/m] of the table; `modes` (`modal.SurfaceModes`)
    with which it moves, and those of the disk that move with them, `bending`, or its `imperfection`, none unless given;
    the `film` of air; whether friction was `fitted` to
    a rough disk and holds what contact and creep take; `rate` of the steps [1/s].
    """

    table: LawTable
    friction: Friction
    powers: tuple[tuple[float, float], ...] = ()
    viscous: tuple[float, float] = (0.0, 0.0)
    profiles: tuple[Profile, Profile] = (SMOOTH, SMOOTH)
    impedance: float = np.inf
    modes: Any = None
    bending: Bending = RIGID
    imperfection: Imperfection | None = None
    film: Film | None = None
    fitted: bool = False
    rate: float = RATE

    @cached_property
    def constants(self) -> np.ndarray:
        """The numbers that the steps read, in the places of state.py."""
        disk, f = self.table.law.disk, self.friction
        body = disk.mass, *inertias(disk), disk.radius, disk.thickness / 2, disk.weight
        friction = min(f.mu_static, LARGEST), min(f.mu_dynamic, LARGEST), f.arm_nutation, f.arm_rolling, f.arm_pivoting
        chi, energy = disk.time_unit, disk.mass * disk.radius**2 / disk.time_unit**2
        units = energy * chi, energy * chi, chi**2, chi, energy, 1.0
        air = np.multiply(self.film or np.zeros(len(units)), units)  # type: ignore[arg-type]
        return np.array([*body, *friction, self.impedance, *self.viscous, *air, float(self.fitted)])

    @cached_property
    def cubics(self) -> np.ndarray:
        """The table of the law (intervals, columns, 4), each cubic in the part of its interval."""
        return np.ascontiguousarray(self.table.spline.c.transpose(1, 2, 0) * STEP ** np.array([3, 2, 1, 0]))

    @cached_property
    def _needed(self) -> np.ndarray:
        """The rate (n,) [1/s] needed at every NODES-th node of the table of the law."""
        return rate_needed(self.table.law, self.table.inclinations[::NODES])

    def finer(self) -> "Compliant":
        """Return the same in steps of half the length."""
        return replace(self, rate=2 * self.rate)

    def stiffer(self) -> "Compliant":
        """Return the same on an elastic contact that is twice as stiff, in finer steps where it needs them."""
        law = self.table.law
        body, table = (side._replace(young=2 * side.young) for side in (law.body, law.table))
        law = replace(law, body=body, table=table)
        rate = max(self.rate, float(rate_needed(law, np.array([LEAST_INCLINATION]))[0]))
        return replace(self, table=replace(self.table, law=law), rate=rate)

    def run(
        self, y, every: int, stop: float, last: float = LEAST_INCLINATION, parts: int = 1, waves=None
    ) -> Iterator[Piece]:
        """Yield the motion from the state y up to `stop` [s] or to the inclination `last`, a row every so many steps.

        The forces on the steps of a row are meant in so many `parts`; `waves` are those of y, if it was asked for them
        before. The array y is advanced. The last piece says by its `why` in ENDS where the model ended. Raises
        ValueError where the rate is too low for the stiffness of the contact, naming what is needed.
        """
        law = self.constants, np.reshape(np.array(self.powers, dtype=float), (-1, 2))
        table, sine = (self.table.grid[0], 1 / STEP, self.cubics, *self.profiles), np.sin(max(last, LEAST_INCLINATION))
        waves = waves or self.waves(y)
        count, left, why = 0, int(np.ceil(stop * self.rate / every - 1e-9)), GOES
        flying, slipping = [np.nan, np.nan, 0.0], [np.nan, np.nan]
        while left > 0 and why == GOES:
            self._hold(y)
            rows = np.empty((min(max(STEPS // every, 1), left), SIZE))
            forces = np.empty((len(rows) * parts, 3))
            flights, slips = (np.full((len(rows) * every // 2 + 2, k), np.nan) for k in (3, 2))
            flights[0], slips[0] = flying, slipping
            report = rows, forces, (flights, slips)
            why, n, flown, slid = march(y, count, *law, *table, waves, 1 / self.rate, every, sine, *report)
            t = (count + every * np.arange(1, n + 1)) / self.rate
            flying, slipping, count, left = flights[flown], slips[slid], count + every * n, left - n
            if left == 0 or why != GOES:  # what goes on to the end of the motion ends with it
                flying[1] = slipping[1] = end = count / self.rate
                flown, slid = flown + (flying[0] < end), slid + (slipping[0] < end)
            begin, end, top = flights[:flown].T
            losses = Losses(np.column_stack([begin, end - begin, top]))
            yield Piece(t, rows[:n], forces[: n * parts] * [-1.0, 1.0, 1.0], losses, slips[:slid], why)

    def waves(self, y):
        """Return the modes of the table as they carry a disk in the state y, which is raised onto them."""
        if self.imperfection is not None:
            return wavy(self.imperfection, y, self.constants)
        waves = still(self.modes, 1 / self.rate, self.bending)
        settle(waves, self.modes, self, y)
        return waves

    def _hold(self, y):
        """Raise ValueError where a resonance turns too far in a step."""
        fastest = np.interp(np.hypot(*y[AXIS : AXIS + 2]), np.exp(self.table.grid[::NODES]), self._needed)
        if fastest > self.rate:
            raise ValueError(f"rate = {self.rate:g}: too low for so stiff a contact, at least {fastest:.4g} 1/s needed")
