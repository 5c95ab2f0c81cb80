"""Solve the motion of a disk that rattles on an uneven table, and the record of this motion."""

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from math import ceil, pi, radians
from typing import NamedTuple

import numpy as np

from dynamics.compliant.compliant_motion import (
    FORCE_RATE,
    FORCES_PER_ROW,
    CompliantMotion,
)
from dynamics.compliant.law.linearised import inertias
from dynamics.compliant.law.unevenness import (
    curvature_number,
    damping_ratio,
    rim_amplitudes,
    rim_heights,
    static_depth,
)
from dynamics.compliant.model_inputs import contact_law, edge_flexibility
from dynamics.compliant.stepping.model import ContactLosses
from dynamics.compliant.stepping.rim_modes import RimModes, moving_rim_modes
from dynamics.compliant.stepping.row_store import interpolate_rows
from dynamics.disk import GRAVITY, Disk
from dynamics.film.activation import decide_film
from dynamics.film.wedge import Film
from dynamics.motion import CAUSES, Outcome
from dynamics.rattling import contact_steps as layout
from dynamics.rattling.contact_steps import Edge, MotionState, RattlingDisk, step_rattling_disk
from dynamics.rattling.film_force import AirFilm
from dynamics.switching import ImpossibleContactError

STEPS_PER_CONTACT = 2.5
"""Time steps over those of a single elastic contact at the same accuracy."""
MIN_STEPS_PER_PERIOD = 60
"""Least number of time steps in a period of the contact resonance."""
LAST_TILT = 3.0
"""Least height of the raised rim over the rms of the unevenness; below, the disk lies flat."""
CHUNK = 0.02
"""Motion between two calls of the progress callback [s]."""
OUTCOME_OF_END = {
    layout.CONTINUES: Outcome.TIME_LIMIT,
    layout.LIES_FLAT: Outcome.SETTLED,
    layout.STANDS_UPRIGHT: Outcome.UPRIGHT,
    layout.JUMPS: Outcome.LIFTED_OFF,
    layout.FLOATS: Outcome.AIRBORNE,
}
"""Outcome of a motion for each reason of `step_rattling_disk`."""


class RattlingModel(NamedTuple):
    """Disk, contact, unevenness and modes of a rattling disk.

    Attributes
    ----------
    disk : Disk
        The disk.
    constants : RattlingDisk
        Constants of the time steps.
    amplitudes : (n,) array
        Complex amplitudes [m] of the unevenness round the rim, by order.
    heights : (p,) array
        Heights [m] of the rim's profile.
    rim : RimModes
        Modes of the free disk that move the rim.
    film : Film or None
        Air film under the disk.
    rate : float
        Time steps per second.
    """

    disk: Disk
    constants: RattlingDisk
    amplitudes: np.ndarray
    heights: np.ndarray
    rim: RimModes
    film: Film | None
    rate: float

    @property
    def modes(self) -> None:
        """The modes of the table, which does not move."""
        return None

    def depth(self, inclination: float) -> float:
        """Return the depth [m] of the static contact at an inclination [rad]."""
        fixed = self.constants
        return static_depth(
            self.disk.weight, fixed.modulus, self.disk.radius, fixed.fillet, inclination
        )

    def curvature_number(self, inclination: float) -> float:
        """Return kappa at an inclination [rad]: contact is lost from 0.25 to 0.5 on."""
        depth = self.depth(inclination)
        return curvature_number(self.amplitudes, self.disk.radius, inclination, depth)

    @property
    def roughness_rms(self) -> float:
        """Root mean square of the unevenness [m]."""
        return float(np.std(self.heights))

    def edge(self) -> Edge:
        """Return the lower edge of the disk."""
        angle = 2 * pi * np.arange(len(self.heights)) / len(self.heights)
        wave = np.cos(np.outer(self.rim.order, angle) - self.rim.phase[:, None])
        turn = np.sqrt(self.rim.squared) / (2 * self.rate)
        wave *= np.sinc(turn / pi)[:, None]
        return Edge(
            heights=self.heights,
            angles=np.array([np.cos(angle), np.sin(angle)]),
            axial=self.rim.axial[:, None] * wave,
            radial=self.rim.radial[:, None] * wave,
            place_factor=turn / np.tan(turn),
            frequency=np.sqrt(self.rim.squared),
            decay=self.rim.decay,
            highest=np.append(self.heights.max(), abs(self.rim.axial) + abs(self.rim.radial)),
        )


@dataclass(frozen=True, kw_only=True, eq=False, repr=False)
class RattlingMotion(CompliantMotion):
    """A motion with contact anywhere on the rim.

    Attributes
    ----------
    model : RattlingModel
        Disk, contact, unevenness and modes.
    ringing : (n, 2 m) array
        Displacement and velocity of each mode of unit modal mass, at the times of the impulses.
    open_time : float
        Time without contact [s].
    """

    model: RattlingModel  # type: ignore[assignment]
    ringing: np.ndarray
    open_time: float

    @property
    def disk(self) -> Disk:
        """The disk."""
        return self.model.disk

    @property
    def moves_table(self) -> bool:
        """False: the table does not move."""
        return False

    @property
    def integrator(self) -> str:
        """Name and rate of the time-stepping scheme."""
        return f"leapfrog with exact flights, {self.model.rate:.4g} steps/s"

    @property
    def open_share(self) -> float:
        """Share of the motion without contact."""
        return self.open_time / self._end

    @property
    def impact_rate(self) -> float:
        """Impacts per second."""
        return len(self.contact_losses) / self._end

    def carrier(self, inclination) -> np.ndarray:
        """Return the contact resonance (k,) [Hz] of the rim under the weight at inclinations (k,)
        [rad].
        """
        beta = np.asarray(inclination, dtype=float)
        depth = static_depth(
            self.disk.weight,
            self.model.constants.modulus,
            self.disk.radius,
            self.model.constants.fillet,
            beta,
        )
        mobility = 1 / self.disk.mass
        mobility += self.disk.radius**2 / self.model.constants.diametral_inertia
        return np.sqrt(1.5 * self.disk.weight / depth * mobility) / (2 * pi)

    def rim_vibration(self, t) -> np.ndarray:
        """Return displacement, velocity and acceleration (k, 3, m) of the modes of unit modal mass
        at times t (k,) [s].
        """
        place = self._row_positions(t) * FORCES_PER_ROW
        value = interpolate_rows(self.ringing, place, False)
        slope = interpolate_rows(self.ringing, place, True) / self.dt
        return np.stack([value[:, ::2], value[:, 1::2], slope[:, 1::2]], axis=1)

    @cached_property
    def _flights(self) -> np.ndarray:
        begin, duration, _ = self.contact_losses.array.T
        return np.column_stack([begin, begin + duration])


def rattling_model(scene) -> RattlingModel:
    """Return the model of a scene. Raises ValueError if no wave of the unevenness fits the rim."""
    disk = scene.disk
    law = contact_law(scene)
    film = decide_film(scene).film
    diametral, axial = inertias(disk)
    restitution = scene.contact.restitution
    # A resonance with the loss factor eta has the damping ratio eta/2.
    ratio = scene.contact.loss_factor / 2 if restitution is None else damping_ratio(restitution)
    constants = RattlingDisk(
        radius=disk.radius,
        half_thickness=disk.thickness / 2,
        mass=disk.mass,
        diametral_inertia=diametral,
        axial_inertia=axial,
        modulus=law.modulus,
        shear_modulus=law.mixed.shear,
        fillet=law.fillet,
        damping_ratio=ratio,
        friction=scene.friction.mu_dynamic,
        contour_moment=scene.dissipation.contour_moment,
        arms=(
            scene.friction.arm_nutation,
            scene.friction.arm_rolling,
            scene.friction.arm_pivoting,
        ),
        film=film_constants(disk, film),
    )
    model = RattlingModel(
        disk=disk,
        constants=constants,
        amplitudes=rim_amplitudes(scene.roughness, disk.radius),
        heights=rim_heights(scene.roughness, scene.imperfection, disk.radius),
        rim=moving_rim_modes(edge_flexibility(scene), scene.material.loss_factor),
        film=film,
        rate=0.0,
    )
    return model._replace(rate=_step_rate(scene, model))


def film_constants(disk: Disk, film: Film | None) -> AirFilm:
    """Return the constants of a film in SI units, zero without a film."""
    chi = disk.time_unit
    energy = disk.mass * disk.radius**2 / chi**2
    units = energy * chi, energy * chi, chi**2, chi, energy, 1.0
    return AirFilm(*np.multiply(film or np.zeros(len(units)), units).tolist())  # type: ignore[arg-type]


def _step_rate(scene, model):
    """Return the steps per second: a multiple of FORCE_RATE that resolves contact and modes."""
    beta = radians(scene.release.inclination_deg)
    stiffness = 1.5 * model.disk.weight / model.depth(beta)
    mobility = 1 / model.disk.mass + model.disk.radius**2 / model.constants.diametral_inertia
    resonance = np.sqrt(stiffness * mobility) / (2 * pi)
    wanted = scene.numerics.contact_rate or max(
        STEPS_PER_CONTACT * scene.numerics.level.contact_rate, MIN_STEPS_PER_PERIOD * resonance
    )
    return FORCE_RATE * ceil(wanted / FORCE_RATE)


def released_state(model: RattlingModel, inclination: float, omega) -> np.ndarray:
    """Return the state (15,) of a disk released on its contact, rolling without slip.

    `inclination` [rad] and the angular velocity `omega` (3,) [rad/s] along a_1, a_2' (the axis)
    and e3 are those of the release.
    """
    fixed = model.constants
    s = np.sin(inclination)
    c = np.cos(inclination)
    a1 = np.array([1.0, 0.0, 0.0])
    axis = np.array([0.0, s, c])
    e3 = np.array([0.0, -c, s])
    spin = omega[0] * a1 + omega[1] * axis + omega[2] * e3
    state = np.zeros(layout.STATE_SIZE)
    state[layout.AXIS : layout.AXIS + 3] = axis
    state[layout.MARK : layout.MARK + 3] = -e3
    lever = fixed.half_thickness * axis + fixed.radius * e3
    state[layout.VELOCITY : layout.VELOCITY + 3] = np.cross(spin, lever)
    momentum = fixed.diametral_inertia * (omega[0] * a1 + omega[2] * e3)
    state[layout.MOMENTUM : layout.MOMENTUM + 3] = momentum + fixed.axial_inertia * omega[1] * axis
    angle = 2 * pi * np.arange(len(model.heights)) / len(model.heights)
    clearance = model.heights - fixed.radius * s * (1 - np.cos(angle))
    height = fixed.half_thickness * c + fixed.radius * s
    state[layout.CENTRE + 2] = height + clearance.max() - model.depth(inclination)
    return state


def solve_rattling_motion(
    scene, watch: Callable[[float, float, str], None] = lambda t, inclination, doing: None
) -> RattlingMotion:
    """Solve the motion of a disk with contact anywhere on its rim, from the release.

    Parameters
    ----------
    scene : MotionScene
        Scene with an elastic contact.
    watch : callable
        Progress callback, as in `dynamics.simulate`.

    Returns
    -------
    RattlingMotion
        The solved motion.

    Raises
    ------
    ValueError
        If no wave of the unevenness fits the rim.
    ImpossibleContactError
        If the disk leaves the table or lies flat at once.
    """
    watch(0.0, radians(scene.release.inclination_deg), "loading or compiling the equations")
    model = rattling_model(scene)
    inclination = radians(scene.release.inclination_deg)
    state = released_state(model, inclination, scene.release.omega)
    last = scene.numerics.final_inclination or 0.0
    last_tilt = max(LAST_TILT * model.roughness_rms, model.disk.radius * last, model.depth(0.1))
    return simulate_rattling(model, state, scene.numerics.time_limit, last_tilt, watch)


def simulate_rattling(
    model: RattlingModel,
    state: np.ndarray,
    time_limit: float,
    last_tilt: float,
    watch: Callable[[float, float, str], None] = lambda t, inclination, doing: None,
    gravity: float = GRAVITY,
) -> RattlingMotion:
    """Advance a state (15,), which is changed, until a time [s] or a height of the rim [m]."""
    edge = model.edge()
    ring = np.zeros((len(edge.frequency), 2))
    record = np.zeros(layout.RECORD_SIZE)
    record[layout.OPEN_SINCE] = -1.0
    per_sample = round(model.rate / FORCE_RATE)
    chunk = round(CHUNK * FORCE_RATE)
    width = layout.STATE_SIZE + layout.RECORD_SIZE + ring.size
    blocks = []
    flights = [np.zeros((0, 3))]
    begin = 0.0
    reason = layout.CONTINUES
    while reason == layout.CONTINUES and begin < time_limit:
        samples = np.empty((chunk, width))
        found = np.empty((chunk * per_sample // 2 + 1, 3))
        written, losses, reason = step_rattling_disk(
            model.constants,
            edge,
            gravity,
            last_tilt,
            1 / model.rate,
            per_sample,
            MotionState(state, ring, record),
            begin,
            samples,
            found,
        )
        blocks.append(samples[:written])
        flights.append(found[:losses].copy())
        begin += written / FORCE_RATE
        sine = np.hypot(state[layout.AXIS], state[layout.AXIS + 1])
        watch(begin, float(np.arcsin(min(sine, 1.0))), "")
    samples = np.concatenate(blocks)
    count = (len(samples) - 1) // FORCES_PER_ROW * FORCES_PER_ROW + 1
    if count < 2 * FORCES_PER_ROW:
        raise ImpossibleContactError("the disk lies flat or leaves the table at once")
    if record[layout.OPEN_SINCE] >= 0:
        since = record[layout.OPEN_SINCE]
        flights.append(np.array([[since, begin + 1 / FORCE_RATE - since, 0.0]]))
        flights[-1][0, 2] = record[layout.GREATEST_GAP]
    lost = np.concatenate(flights)
    lost[:, 0] -= 1 / FORCE_RATE  # the first sample is the start of the motion
    return _motion_of_samples(model, samples[:count], lost, OUTCOME_OF_END[reason], gravity)


def _motion_of_samples(model, samples, flights, outcome, gravity):
    """Return the motion of samples (n, 29 + 2 m) at FORCE_RATE."""
    state = samples[:, : layout.STATE_SIZE]
    record = samples[:, layout.STATE_SIZE : layout.STATE_SIZE + layout.RECORD_SIZE]
    ringing = samples[:, layout.STATE_SIZE + layout.RECORD_SIZE :]
    columns = motion_columns(model, state)
    lost = np.zeros((len(state), len(CAUSES)))
    lost[:, CAUSES.index("contact")] = record[:, layout.CONTACT_LOSS]
    lost[:, CAUSES.index("slip")] = record[:, layout.SLIP_LOSS]
    lost[:, CAUSES.index("moments")] = record[:, layout.MOMENT_LOSS]
    lost[:, CAUSES.index("body")] = record[:, layout.BODY_LOSS]
    lost[:, CAUSES.index("film")] = record[:, layout.FILM_LOSS]
    internal = modal_energy(model, ringing)
    stored = record[:, layout.STORED] + record[:, layout.AIR_ENERGY]
    energy = rigid_energy(model, state, gravity) + stored + internal
    rows = np.column_stack([columns, energy, lost, np.zeros(len(state)), internal])
    impulse = record[:, layout.IMPULSE : layout.IMPULSE + 3]
    step = np.diff(impulse, axis=0)
    middle = (columns[1:, 0] + columns[:-1, 0]) / 2
    along = step[:, 0] * np.cos(middle) + step[:, 1] * np.sin(middle)
    across = step[:, 1] * np.cos(middle) - step[:, 0] * np.sin(middle)
    own = np.zeros_like(impulse)
    own[1:] = np.cumsum(np.column_stack([along, across, step[:, 2]]), axis=0)
    end = (len(samples) - 1) / FORCE_RATE
    losses = flights[flights[:, 0] < end]
    losses[:, 1] = np.minimum(losses[:, 1], end - losses[:, 0])
    return RattlingMotion(
        model=model,
        dt=1 / FORCE_RATE,
        impulses=own,
        rows=rows[::FORCES_PER_ROW],
        slides=np.zeros((0, 2)),
        contact_losses=ContactLosses(losses),
        excess=0.0,
        outcome=outcome,
        ringing=np.ascontiguousarray(ringing),
        open_time=float(record[-1, layout.OPEN_TIME]),
    )


def rigid_energy(model: RattlingModel, state: np.ndarray, gravity: float = GRAVITY) -> np.ndarray:
    """Return kinetic plus potential energy (k,) [J] of the rigid disk at states (k, 15)."""
    fixed = model.constants
    momentum = state[:, layout.MOMENTUM : layout.MOMENTUM + 3]
    axial = np.sum(momentum * state[:, layout.AXIS : layout.AXIS + 3], axis=1)
    turning = (np.sum(momentum**2, axis=1) - axial**2) / fixed.diametral_inertia
    turning += axial**2 / fixed.axial_inertia
    speed = np.sum(state[:, layout.VELOCITY : layout.VELOCITY + 3] ** 2, axis=1)
    height = state[:, layout.CENTRE + 2] - fixed.half_thickness
    return (fixed.mass * speed + turning) / 2 + fixed.mass * gravity * height


def modal_energy(model: RattlingModel, ringing: np.ndarray) -> np.ndarray:
    """Return the energy (k,) [J] of the modes at displacements and velocities (k, 2 m)."""
    return (ringing[:, 1::2] ** 2 + model.rim.squared * ringing[:, ::2] ** 2).sum(axis=1) / 2


def motion_columns(model: RattlingModel, state: np.ndarray) -> np.ndarray:
    """Return the COLUMNS (k, 11) of states (k, 15); precession and spin are continuous."""
    fixed = model.constants
    axis = state[:, layout.AXIS : layout.AXIS + 3]
    mark = state[:, layout.MARK : layout.MARK + 3]
    sine = np.hypot(axis[:, 0], axis[:, 1])
    inclination = np.arctan2(sine, axis[:, 2])
    precession = np.unwrap(np.arctan2(axis[:, 1], axis[:, 0]) - pi / 2)
    precession -= precession[0]
    a2 = np.column_stack([axis[:, 0] / sine, axis[:, 1] / sine, np.zeros(len(axis))])
    a1 = np.column_stack([a2[:, 1], -a2[:, 0], np.zeros(len(axis))])
    e3 = np.cross(a1, axis)
    mark_2 = np.cross(axis, mark)
    lowest = np.unwrap(np.arctan2(-np.sum(e3 * mark_2, axis=1), -np.sum(e3 * mark, axis=1)))
    momentum = state[:, layout.MOMENTUM : layout.MOMENTUM + 3]
    axial = np.sum(momentum * axis, axis=1)
    omega = momentum / fixed.diametral_inertia
    omega += ((1 / fixed.axial_inertia - 1 / fixed.diametral_inertia) * axial)[:, None] * axis
    contact = -fixed.half_thickness * axis - fixed.radius * e3
    slip = state[:, layout.VELOCITY : layout.VELOCITY + 3] + np.cross(omega, contact)
    return np.column_stack(
        [
            precession,
            inclination,
            lowest[0] - lowest,
            state[:, layout.CENTRE : layout.CENTRE + 2],
            np.sum(omega * a1, axis=1),
            np.sum(omega * axis, axis=1),
            np.sum(omega * e3, axis=1),
            np.sum(slip * a1, axis=1),
            np.sum(slip * a2, axis=1),
            np.zeros(len(axis)),
        ]
    )
