"""Solution of the motion of a rattling disk, and its `Motion`."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from math import ceil, inf, pi, radians, sqrt
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from dynamics.compliant.compliant_motion import (
    FORCE_SAMPLE_RATE,
    FORCES_PER_ROW,
    CompliantMotion,
    impulse_rounding,
    losses_until,
)
from dynamics.compliant.law.linearised import mobility
from dynamics.compliant.law.unevenness import (
    curvature_number,
    damping_ratio,
    rim_amplitudes,
    rim_heights,
    static_depth,
)
from dynamics.compliant.model_inputs import contact_law, scene_edge_flexibility
from dynamics.disk import GRAVITY, Disk
from dynamics.film.wedge import Film, film_in_si_units
from dynamics.kinematics import contact_place, contact_place_in_metres
from dynamics.motion import (
    FILM_COLUMNS,
    FindingGroup,
    MotionEvent,
    Outcome,
    release_columns,
)
from dynamics.pivoting import PIVOTING_COEFFICIENT_COUNT
from dynamics.rattling import layout
from dynamics.rattling.body import MotionState, motion_state
from dynamics.rattling.layout import RECORD, LowerEdge, RattlingDisk
from dynamics.rattling.time_loop import TimeSteps, step_rattling_disk
from dynamics.rattling.vibration import (
    INTERPOLATION_NORM,
    MovingTable,
    interpolation_at,
)
from dynamics.stepping_core.body import (
    angular_momentum,
    body_axes,
    body_constants,
    kinetic_and_bowl_energy,
    relative_columns,
    rolling_velocity,
)
from dynamics.stepping_core.end_reasons import OUTCOME_OF_END, EndReason
from dynamics.stepping_core.ledger import motion_rows
from dynamics.stepping_core.oscillators import exact_modes
from dynamics.stepping_core.rim_modes import RimModes, moving_rim_modes
from dynamics.stepping_core.round_table import greatest_shape_norm
from dynamics.stepping_core.row_store import interpolate_rows
from dynamics.stepping_core.table_shapes import table_shapes
from dynamics.switching import ImpossibleContactError, NoContactAtReleaseError

if TYPE_CHECKING:
    from dynamics.compliant.law.hertz_mindlin import ContactLaw
    from dynamics.motion_plan import MotionPlan
    from dynamics.sections import MotionScene

PROGRESS_INTERVAL = 0.02
"""Duration of motion between two calls of the progress callback [s]."""


class RattlingModel(NamedTuple):
    """Disk, contact, unevenness and modes of a rattling disk.

    Attributes
    ----------
    plan : MotionPlan
        The decisions of the motion.
    disk : Disk
        The disk.
    constants : RattlingDisk
        Constants of the time steps.
    amplitudes : ndarray, shape (n,)
        Complex amplitudes [m] of the unevenness around the rim, by order.
    heights : ndarray, shape (p,)
        Heights [m] of table and edge along the rim.
    rim : RimModes
        Modes of the free disk that displace the rim.
    film : Film or None
        Air film under the disk.
    modes : modal.SurfaceModes or None
        Modes of a table that moves with the disk.
    rate : float
        Time steps per second.
    """

    plan: "MotionPlan"
    disk: Disk
    constants: RattlingDisk
    amplitudes: np.ndarray
    heights: np.ndarray
    rim: RimModes
    film: Film | None
    modes: Any
    rate: float

    def depth(self, inclination: Any) -> Any:
        """Return the depth [m] of the static contact at an inclination [rad]."""
        return edge_depth(self.disk, self.constants, inclination)

    def curvature_number(self, inclination: float) -> float:
        """Return the curvature number kappa at an inclination [rad]."""
        depth = self.depth(inclination)
        return curvature_number(self.amplitudes, self.disk.radius, inclination, depth)

    def contact_resonance(self, inclination: ArrayLike) -> np.ndarray:
        """Return the contact resonance (k,) [Hz] at inclinations (k,) [rad]."""
        return edge_resonance(
            self.disk, self.depth(inclination), inclination, self.constants.fillet
        )

    @property
    def roughness_rms(self) -> float:
        """Root mean square of the unevenness [m]."""
        return float(np.std(self.heights))

    def edge(self) -> LowerEdge:
        """Return the heights and the modes of the lower edge of the disk."""
        angle = 2 * pi * np.arange(len(self.heights)) / len(self.heights)
        modes = exact_modes(np.sqrt(self.rim.squared), self.rim.decay, self.rate)
        wave = np.cos(np.outer(self.rim.order, angle) - self.rim.phase[:, None])
        wave *= modes.mean_factor[:, None]
        displacement = abs(self.rim.axial) + abs(self.rim.radial)
        return LowerEdge(
            heights=self.heights,
            block_heights=np.maximum.reduceat(
                self.heights, np.arange(0, len(self.heights), layout.RIM_BLOCK_POINTS)
            ),
            angles=np.array([np.cos(angle), np.sin(angle)]),
            axial=self.rim.axial[:, None] * wave,
            radial=self.rim.radial[:, None] * wave,
            modes=modes,
            highest=np.array([self.heights.max(), *displacement]),
        )

    def table(self) -> MovingTable | None:
        """Return the modes of the table, or None if it is rigid."""
        modes = self.modes
        if modes is None:
            return None
        frequency = 2 * pi * modes.frequency
        waves = modes.round_shapes
        if waves is None:
            nodes_per_knot = 2
            spacing = min(np.diff(part).max() for part in modes.knots) / nodes_per_knot
            norm = float(np.linalg.norm(modes.coefficients, axis=2).max())
        else:
            spacing = waves.radius / (len(waves.starts) - 1)
            norm = greatest_shape_norm(waves)
        min_count = 64
        nodes_per_wave = 8  # for which the interpolation is wrong by less than 1 %
        if waves is not None:
            min_count = max(min_count, nodes_per_wave * int(waves.order.max()))
        count = max(min_count, ceil(2 * pi * self.constants.radius / spacing))
        place = np.arange(len(self.heights)) * count / len(self.heights)
        node, weight = interpolation_at(place, count)
        return MovingTable(
            table_shapes(modes),
            exact_modes(frequency, np.array(modes.decay_rate), self.rate),
            shape_norm=INTERPOLATION_NORM * norm,
            shapes=np.zeros((count, len(frequency))),
            slopes=np.zeros((count, 2, len(frequency))),
            known_since=np.full(count, -1.0),
            position=np.zeros((count, 2)),
            motion=np.zeros((3, count)),
            incline=np.zeros((count, 2)),
            force=np.zeros((2, count)),
            displacement=np.zeros(len(frequency)),
            work=np.zeros(len(frequency)),
            evaluated=np.full((2, count), -1.0),
            node=node,
            weight=weight,
        )


@dataclass(frozen=True, kw_only=True, eq=False, repr=False)
class RattlingMotion(CompliantMotion):
    """A motion with any number of contacts along the rim.

    Attributes
    ----------
    model : RattlingModel
        Disk, contact, unevenness and modes.
    ringing : ndarray, shape (n, 2 m)
        Displacement and velocity of each disk mode of unit modal mass, at the times of the
        impulses.
    film_impulses : ndarray, shape (n,)
        Vertical impulse of the pressure in the air film [N s], a part of the impulses.
    open_time : float
        Time without contact [s].
    final_gap : float
        Mean gap [m] below the face at the end.
    """

    model: RattlingModel  # type: ignore[assignment]
    ringing: np.ndarray
    film_impulses: np.ndarray
    open_time: float
    final_gap: float

    @property
    def disk(self) -> Disk:
        """The disk."""
        return self.model.disk

    @property
    def rolling_fillet(self) -> float:
        """Radius [m] of the edge on which the disk rolls."""
        return self.model.constants.fillet

    @property
    def moves_table(self) -> bool:
        """True if the table has modes that move with the disk."""
        return self.model.modes is not None

    @property
    def finding_groups(self) -> tuple[FindingGroup, ...]:
        """The findings on contacts anywhere on the rim."""
        return ("rattling",)

    @property
    def rim_modes(self) -> RimModes:
        """The modes of the disk, which are solved together with the motion."""
        return self.model.rim

    @property
    def vibration_crossover(self) -> float:
        """A frequency [Hz] above the precession rate of a rattling disk."""
        return 200.0

    @property
    def max_energy_error(self) -> float:
        """Largest relative error of the energy balance, of second order in the time step.

        Measured values are 0.02e-5 to 0.6e-5 at a million steps per second.
        """
        return 2e-5 * (1e6 / self.model.rate) ** 2

    @property
    def integrator(self) -> str:
        """Name and rate of the time-stepping scheme."""
        return f"leapfrog with exact flights, {self.model.rate:.4g} steps/s"

    @property
    def open_share(self) -> float:
        """Fraction of the motion without contact."""
        return self.open_time / self._end

    @property
    def impact_rate(self) -> float:
        """Number of impacts per second."""
        return len(self.contact_losses) / self._end

    @property
    def contact_impulses(self) -> np.ndarray:
        """Normal impulse (n,) [N s] of the contact since the start, without the film."""
        return self.impulses[:, 2] - self.film_impulses

    @property
    def events(self) -> tuple[MotionEvent, ...]:
        """The rest of a disk that lies flat."""
        if self.outcome is not Outcome.AT_REST:
            return ()
        end = self._end
        return (MotionEvent(end, "lies flat", 0.0, float(self.energy(end)[0])),)

    def contact_force(self, t: ArrayLike) -> np.ndarray:
        """Return the normal force of the contact (k,) [N] at t (k,) [s], without the
        pressure in the air film, which may be below that of the room.

        It is 0 below 1e-9 of the weight, the rounding error of the impulses.
        """
        force = self._impulse_rate(self.contact_impulses[:, None], t)[:, 0]
        return np.where(force > 1e-9 * self.disk.weight, force, 0.0)

    def film_loads(self, t: ArrayLike, state: np.ndarray) -> np.ndarray:
        """Return the FILM_COLUMNS (k, 5), where the film adds nothing to `force`."""
        loads = np.zeros((len(state), len(FILM_COLUMNS)))
        loads[:, 0] = self.disk.radius * np.sin(state[:, 1])
        return loads

    def contact_resonance(self, inclination: ArrayLike) -> np.ndarray:
        """Return the contact resonance (k,) [Hz] at inclinations (k,) [rad]."""
        return self.model.contact_resonance(np.asarray(inclination, dtype=float))

    def rim_vibration(self, t: ArrayLike) -> np.ndarray:
        """Return displacement, velocity, acceleration (k, 3, m) of modes at t (k,) [s].

        The modes have unit modal mass.
        """
        place = self._fractional_rows(t) * FORCES_PER_ROW
        value = interpolate_rows(self.ringing, place, False)
        slope = interpolate_rows(self.ringing, place, True) / self.dt
        return np.stack([value[:, ::2], value[:, 1::2], slope[:, 1::2]], axis=1)


def edge_depth(
    disk: Disk, law: "ContactLaw | RattlingDisk", inclination: float | np.ndarray
) -> Any:
    """Return the depth [m] of the static contact of the edge at inclinations [rad]."""
    return static_depth(disk.weight, law.modulus, disk.radius, law.fillet, inclination)


def edge_resonance(
    disk: Disk, depth: Any, inclination: ArrayLike, fillet: float
) -> np.ndarray:
    """Return the resonances (k,) [Hz] of a disk on its edge at inclinations (k,) [rad].

    `depth` [m] is that of the static contact, and `fillet` [m] the radius of the edge.
    """
    stiffness = 1.5 * disk.weight / depth
    W = mobility(disk, inclination, fillet)
    return np.sqrt(stiffness * W[:, 2, 2]) / (2 * pi)


def rattling_model(plan: "MotionPlan") -> RattlingModel:
    """Return the model of a plan on a table whose modes move, or on a rigid table.

    Raises ValueError if no wave of the unevenness fits the rim.
    """
    scene = plan.scene
    disk = scene.disk
    law = contact_law(scene)
    pivoting = plan.constants.pivoting or (0.0,) * (2 * PIVOTING_COEFFICIENT_COUNT)
    arm_pivoting = scene.friction.arm_pivoting
    has_spin_friction = arm_pivoting == "contact"
    restitution = scene.contact.restitution
    # the damping ratio is half the loss factor
    ratio = (
        scene.contact.loss_factor / 2
        if restitution is None
        else damping_ratio(restitution)
    )
    constants = RattlingDisk(
        **body_constants(
            disk, law.fillet, scene.surface.curvature, scene.surface.place
        ),
        half_thickness=disk.thickness / 2,
        modulus=law.modulus,
        shear_modulus=law.equivalent_material.shear,
        damping_ratio=ratio,
        friction=scene.friction.mu_dynamic,
        contour_moment=scene.dissipation.contour_moment,
        spin_friction=(float(has_spin_friction), *pivoting),
        arms=(
            scene.friction.arm_nutation,
            scene.friction.arm_rolling,
            0.0 if arm_pivoting == "contact" else arm_pivoting,
        ),
        film=film_in_si_units(plan.film, disk),
    )
    return RattlingModel(
        plan=plan,
        disk=disk,
        constants=constants,
        amplitudes=rim_amplitudes(scene.roughness, disk.radius),
        heights=rim_heights(scene.roughness, scene.imperfection, disk.radius),
        rim=moving_rim_modes(scene_edge_flexibility(scene), scene.material.loss_factor),
        film=plan.film,
        modes=plan.moving_modes,
        rate=plan.step_rate,
    )


def rattling_step_rate(scene: "MotionScene") -> float:
    """Return a step rate [1/s] that resolves the contact of a rattling disk.

    It is a multiple of FORCE_SAMPLE_RATE.
    """
    steps_per_contact = (
        3.0  # step rate divided by that of one elastic contact as accurate
    )
    min_steps_per_period = 60  # of the contact resonance
    disk = scene.disk
    inclination = radians(scene.release.inclination_deg)
    law = contact_law(scene)
    depth = edge_depth(disk, law, inclination)
    (resonance,) = edge_resonance(disk, depth, inclination, law.fillet)
    wanted = scene.numerics.contact_rate or max(
        steps_per_contact * scene.numerics.level.contact_rate,
        min_steps_per_period * resonance,
    )
    return FORCE_SAMPLE_RATE * ceil(wanted / FORCE_SAMPLE_RATE)


def rolling_state_at_release(
    model: RattlingModel, inclination: float, omega: Sequence[float] | np.ndarray
) -> np.ndarray:
    """Return the state (5, 3) of a disk released on its contact, rolling without slip.

    `inclination` [rad] and the angular velocity `omega` (3,) [rad/s] along a_1, a_2' (the axis)
    and e3 are those of the release.
    """
    fixed = model.constants
    s = np.sin(inclination)
    c = np.cos(inclination)
    axes = body_axes(0.0, inclination)
    place = contact_place(
        c, s, fixed.half_thickness / fixed.radius, fixed.fillet / fixed.radius
    )
    lever = fixed.radius * (place.depth * axes[2] + place.radius * axes[3])
    angle = 2 * pi * np.arange(len(model.heights)) / len(model.heights)
    clearance = model.heights - fixed.core_radius * s * (1 - np.cos(angle))
    height = fixed.radius * place.e + clearance.max() - model.depth(inclination)
    return np.array(
        [
            [0.0, 0.0, height],
            rolling_velocity(omega, axes, lever),
            axes[2],
            -axes[3],
            angular_momentum(fixed, omega, axes),
        ]
    )


def turned_to(state: np.ndarray, columns: np.ndarray) -> np.ndarray:
    """Return a state (5, 3) of precession 0 at the precession and place of COLUMNS (11,)."""
    c, s = np.cos(columns[0]), np.sin(columns[0])
    turned = state @ np.array([[c, s, 0.0], [-s, c, 0.0], [0.0, 0.0, 1.0]])
    turned[layout.CENTRE, :2] += columns[3:5]
    return turned


def effective_restitution(
    model: RattlingModel, inclination: float, speed: float
) -> float:
    """Return the coefficient of restitution of the edge with the modes of the disk.

    The edge of a disk at an inclination [rad] hits a smooth table at a speed [m/s]
    without gravity. The speeds before and after the impact are those of the rigid disk,
    so energy in its modes counts as lost.
    """
    fixed = model.constants
    alone = fixed._replace(
        friction=0.0,
        contour_moment=0.0,
        arms=(0.0, 0.0, 0.0),
        film=film_in_si_units(None, model.disk),
    )
    smooth = model._replace(heights=np.zeros(len(model.heights)), constants=alone)
    state = rolling_state_at_release(smooth, inclination, (0.0, 0.0, 0.0))
    state[layout.CENTRE, 2] += smooth.depth(inclination)
    (W,) = mobility(model.disk, inclination, fixed.fillet)
    impulse = np.array([0.0, 0.0, -speed / W[2, 2]])
    state[layout.VELOCITY] = impulse / fixed.mass
    state[layout.MOMENTUM] = np.cross(_lowest_point(fixed, state), impulse)
    # gravity is not 0, because losses are divided by the weight
    simulate_rattling(smooth, state, PROGRESS_INTERVAL / 2, 0.0, gravity=1e-9)
    return _edge_speed(fixed, state) / speed


def _lowest_point(fixed: RattlingDisk, state: np.ndarray) -> np.ndarray:
    """Return the vector (3,) [m] from the centre to the lowest point of the edge, without
    the vertical radius of its fillet."""
    axis = state[layout.AXIS]
    down = axis[2] * axis - [0.0, 0.0, 1.0]
    core = fixed.core_radius * down / np.linalg.norm(down)
    return core - fixed.core_depth * axis


def _edge_speed(fixed: RattlingDisk, state: np.ndarray) -> float:
    """Return the vertical speed [m/s] of the lowest point of the edge in a state (5, 3)."""
    axis = state[layout.AXIS]
    momentum = state[layout.MOMENTUM]
    axial = (momentum @ axis) * axis
    omega = (momentum - axial) / fixed.diametral_inertia + axial / fixed.axial_inertia
    turning = np.cross(omega, _lowest_point(fixed, state))
    return float(state[layout.VELOCITY, 2] + turning[2])


def solve_rattling_motion(
    plan: "MotionPlan",
    watch: Callable[[float, float, str], None] = lambda t, inclination, doing: None,
    start: np.ndarray | None = None,
) -> RattlingMotion:
    """Solve the motion of a rattling disk from its release, or from a state in which it rolls.

    Parameters
    ----------
    plan : MotionPlan
        Plan with contacts anywhere on the rim.
    watch : callable
        Progress callback, as in `dynamics.simulate`.
    start : ndarray, (11,), optional
        The COLUMNS of a rolling disk at the start; those of the release by default. The
        angles of the motion begin at 0.

    Returns
    -------
    RattlingMotion
        The solved motion.

    Raises
    ------
    ValueError
        If no wavelength of the unevenness fits the rim.
    ImpossibleContactError
        If the disk leaves the table or lies flat at once.
    NoContactAtReleaseError
        If it is steeper than `plan.max_rolling_inclination` at the start.
    """
    scene = plan.scene
    if start is None:
        start = release_columns(scene.release)
    inclination = float(start[1])
    if inclination > plan.max_rolling_inclination:
        raise NoContactAtReleaseError(
            f"inclination {inclination:.6g} rad: the disk is too steep to touch the table with "
            f"its lower rim alone; the limit is {plan.max_rolling_inclination:g} rad"
        )
    watch(0.0, inclination, "loading or compiling the equations")
    model = rattling_model(plan)
    state = turned_to(rolling_state_at_release(model, inclination, start[5:8]), start)
    last = scene.numerics.final_inclination or 0.0
    # ratio of rim height to rms unevenness below which the disk lies flat
    min_height_ratio = 3.0
    final_tilt = max(
        min_height_ratio * model.roughness_rms,
        model.disk.radius * last,
        model.depth(0.1),
    )
    rest_share = 1e-6  # kinetic energy of a disk at rest over the energy at the release
    rest_energy = rest_share * float(rigid_energy(model, state[None])[0])
    limit = scene.numerics.time_limit
    return simulate_rattling(model, state, limit, final_tilt, watch, rest_energy)


def simulate_rattling(
    model: RattlingModel,
    state: np.ndarray,
    time_limit: float,
    final_tilt: float,
    watch: Callable[[float, float, str], None] = lambda t, inclination, doing: None,
    rest_energy: float = inf,
    gravity: float = GRAVITY,
) -> RattlingMotion:
    """Advance a state (5, 3) in place until a time [s] or a final tilt of the rim [m].

    At the final tilt, the kinetic energy of heave and tilt [J] must be below `rest_energy`.

    A table with modes is initially at rest and deflected by the weight of the disk,
    which is lowered accordingly.
    """
    edge = model.edge()
    table = model.table()
    motion = _motion_at_rest(model, table, state, gravity)
    per_sample = round(model.rate / FORCE_SAMPLE_RATE)
    steps = TimeSteps(1 / model.rate, per_sample, gravity, final_tilt, rest_energy)
    chunk = round(PROGRESS_INTERVAL * FORCE_SAMPLE_RATE)
    sizes = (state.size, motion.record.size, 2 * len(model.rim.order), 1)
    blocks = []
    flights = [np.zeros((0, 3))]
    begin = 0.0
    reason = EndReason.CONTINUES
    while reason == EndReason.CONTINUES and begin < time_limit:
        samples = np.empty((chunk, sum(sizes)))
        found = np.empty((chunk * per_sample // 2 + 1, 3))
        written, losses, reason = step_rattling_disk(
            model.constants,
            edge,
            table,
            steps,
            motion,
            begin,
            samples,
            found,
        )
        blocks.append(samples[:written])
        flights.append(found[:losses].copy())
        begin += written / FORCE_SAMPLE_RATE
        sine = np.hypot(state[layout.AXIS, 0], state[layout.AXIS, 1])
        watch(begin, float(np.arcsin(min(sine, 1.0))), "")
    samples = np.concatenate(blocks)
    count = (len(samples) - 1) // FORCES_PER_ROW * FORCES_PER_ROW + 1
    if count < 2 * FORCES_PER_ROW:
        raise ImpossibleContactError("the disk lies flat or leaves the table at once")
    flights.append(_unfinished_flight(motion.record, begin + 1 / FORCE_SAMPLE_RATE))
    lost = np.concatenate(flights)
    lost[:, 0] -= 1 / FORCE_SAMPLE_RATE  # the first sample is the start of the motion
    columns = np.split(samples[:count], np.cumsum(sizes[:-1]), axis=1)
    return _motion_of_samples(model, columns, lost, OUTCOME_OF_END[reason], gravity)


def _motion_at_rest(
    model: RattlingModel, table: MovingTable | None, state: np.ndarray, gravity: float
) -> MotionState:
    """Return the motion of a state (5, 3) with modes at rest.

    The centre is lowered by the static deflection of the table.
    """
    disk_modes = len(model.rim.order)
    table_modes = 0 if table is None else len(table.modes.frequency)
    ring = np.zeros((2, disk_modes + table_modes))
    if table is not None:
        bend, ring[0, disk_modes:] = static_deflection(model, state, gravity)
        state[layout.CENTRE, 2] += bend
    record = np.zeros(layout.RECORD_SIZE)
    record[RECORD.flight_start] = -1.0
    return motion_state(state, ring, record, disk_modes)


def _unfinished_flight(record: np.ndarray, end: float) -> np.ndarray:
    """Return start [s], duration [s] and height [m] (k, 3) of a flight that lasts until the
    end [s]; k is 1 or 0."""
    since = record[RECORD.flight_start]
    if since < 0:
        return np.zeros((0, 3))
    return np.array([[since, end - since, record[RECORD.max_flight_height]]])


def static_deflection(
    model: RattlingModel, state: np.ndarray, gravity: float = GRAVITY
) -> tuple[float, np.ndarray]:
    """Return the static height [m] of the table at the contact and the displacements
    (t,) of its modes.

    The table carries the weight of a disk in a state (5, 3).
    """
    fixed = model.constants
    axis = state[layout.AXIS]
    sine = np.hypot(axis[0], axis[1])
    reach = fixed.core_radius * axis[2] - (fixed.core_depth) * sine
    x, y = reach * axis[:2] / sine + model.modes.place
    if model.modes.mass > 0:
        x += state[layout.CENTRE, 0]
        y += state[layout.CENTRE, 1]
    shape = model.modes.at(np.array([x]), np.array([y]))[0]
    moved = -fixed.mass * gravity * shape / (2 * pi * model.modes.frequency) ** 2
    return float(shape @ moved), moved


def _motion_of_samples(
    model: RattlingModel,
    samples: list[np.ndarray],
    flights: np.ndarray,
    outcome: Outcome,
    gravity: float,
) -> RattlingMotion:
    """Return the motion from samples at FORCE_SAMPLE_RATE.

    The `samples` are state (n, 15), record, modes of the disk (n, 2 d) and energy of the
    table (n, 1).
    """
    state, record, ringing, in_table = samples
    state = state.reshape(len(state), -1, 3)
    in_table = in_table[:, 0]
    columns = motion_columns(model, state)
    internal = modal_energy(model.rim.squared, ringing)
    stored = record[:, RECORD.spring_energy] + record[:, RECORD.compressed_air_energy]
    energy = rigid_energy(model, state, gravity) + stored + internal + in_table
    lost = record[:, layout.ENERGY_LOSSES]
    rows = motion_rows(columns, energy, lost, in_table, internal)
    impulse = record[:, RECORD.impulse : RECORD.contact_loss]
    step = np.diff(impulse, axis=0)
    excess, slides = friction_over_limit(model, record)
    middle = (columns[1:, 0] + columns[:-1, 0]) / 2
    along = step[:, 0] * np.cos(middle) + step[:, 1] * np.sin(middle)
    across = step[:, 1] * np.cos(middle) - step[:, 0] * np.sin(middle)
    own = np.zeros_like(impulse)
    own[1:] = np.cumsum(np.column_stack([along, across, step[:, 2]]), axis=0)
    end = (len(state) - 1) / FORCE_SAMPLE_RATE
    return RattlingMotion(
        plan=model.plan,
        model=model,
        dt=1 / FORCE_SAMPLE_RATE,
        impulses=own,
        rows=rows[::FORCES_PER_ROW],
        slides=slides,
        contact_losses=losses_until(end, flights),
        max_friction_excess=excess,
        rolling_outcome=outcome,
        ringing=np.ascontiguousarray(ringing),
        film_impulses=record[:, RECORD.film_impulse].copy(),
        open_time=float(record[-1, RECORD.open_time]),
        final_gap=float(state[-1, layout.CENTRE, 2] - model.constants.half_thickness),
    )


def friction_over_limit(
    model: RattlingModel, record: np.ndarray
) -> tuple[float, np.ndarray]:
    """Return the largest excess of friction over its limit [N], and the slides (s, 2) [s].

    Both follow from the impulses in the records (n, RECORD_SIZE) of successive samples.
    The whole contact slips where the linear law of creep exceeds three times the limit
    (Vermeulen & Johnson 1964). The friction of `press_patch` is then 3/sqrt(10) of its
    limit.
    """
    slide_ratio = 3 / sqrt(10)
    impulse = record[:, RECORD.impulse + 2] - record[:, RECORD.film_impulse]
    normal = np.diff(impulse) * FORCE_SAMPLE_RATE
    along = record[:, RECORD.friction_impulse : RECORD.friction_impulse + 2]
    friction = np.hypot(*np.diff(along, axis=0).T) * FORCE_SAMPLE_RATE
    limit = model.constants.friction * normal
    pressed = normal > impulse_rounding(impulse, 1 / FORCE_SAMPLE_RATE)
    sliding = pressed & (friction >= slide_ratio * limit)
    edges = np.diff(np.concatenate([[0], sliding.astype(int), [0]]))
    slides = np.column_stack([np.flatnonzero(edges == sign) for sign in (1, -1)])
    excess = float((friction - limit).max(initial=0.0))
    return excess, slides / FORCE_SAMPLE_RATE


def rigid_energy(
    model: RattlingModel, state: np.ndarray, gravity: float = GRAVITY
) -> np.ndarray:
    """Return kinetic plus potential energy (k,) [J] of the rigid disk at states (k, 5, 3)."""
    fixed = model.constants
    vectors = np.ascontiguousarray(state.transpose(1, 2, 0))
    kinetic = kinetic_and_bowl_energy(
        fixed,
        vectors[layout.CENTRE],
        vectors[layout.VELOCITY],
        vectors[layout.AXIS],
        vectors[layout.MOMENTUM],
    )
    height = vectors[layout.CENTRE, 2] - fixed.half_thickness
    return kinetic + fixed.mass * gravity * height


def modal_energy(squared: np.ndarray, ringing: np.ndarray) -> np.ndarray:
    """Return the energy (k,) [J] of modes of unit modal mass with squared angular frequencies (m,)
    [1/s^2] at displacements and velocities (k, 2 m).
    """
    return (ringing[:, 1::2] ** 2 + squared * ringing[:, ::2] ** 2).sum(axis=1) / 2


def motion_columns(model: RattlingModel, state: np.ndarray) -> np.ndarray:
    """Return the COLUMNS (k, 11) of states (k, 5, 3); precession and spin are continuous."""
    fixed = model.constants
    axis = state[:, layout.AXIS]
    reference = state[:, layout.RIM_REFERENCE_VECTOR]
    sine = np.hypot(axis[:, 0], axis[:, 1])
    inclination = np.arctan2(sine, axis[:, 2])
    precession = np.unwrap(np.arctan2(axis[:, 1], axis[:, 0]) - pi / 2)
    precession -= precession[0]
    a2 = np.column_stack([axis[:, 0] / sine, axis[:, 1] / sine, np.zeros(len(axis))])
    a1 = np.column_stack([a2[:, 1], -a2[:, 0], np.zeros(len(axis))])
    e3 = np.cross(a1, axis)
    quarter_turn_vector = np.cross(axis, reference)
    lowest = np.unwrap(
        np.arctan2(
            -np.sum(e3 * quarter_turn_vector, axis=1), -np.sum(e3 * reference, axis=1)
        )
    )
    vectors = np.ascontiguousarray(state.transpose(1, 2, 0))
    relative = relative_columns(
        fixed,
        contact_place_in_metres(model.disk, fixed.fillet, axis[:, 2], sine),
        vectors[layout.VELOCITY],
        vectors[layout.AXIS],
        vectors[layout.MOMENTUM],
    )
    return np.column_stack(
        [
            precession,
            inclination,
            lowest[0] - lowest,
            state[:, layout.CENTRE, :2],
            *relative,
            np.zeros(len(axis)),
        ]
    )
