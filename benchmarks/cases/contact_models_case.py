"""Define short stretches of motion on smooth, rough, wavy and flexible tables, and solve
them by each model of the contact.

All models have the same disk, table, heights along the rim and moment against the motion.
The disk of the scene `granite` is rigid and starts in steady motion. Without friction no
model has tangential forces."""

from dataclasses import dataclass, fields, replace
from functools import cached_property, partial
from math import degrees, pi
from typing import NamedTuple

import numpy as np
from scipy.signal import welch

from benchmarks.cases.elastic_steady_motion import steady_state
from benchmarks.timed_runs import Answer, Failure
from dynamics import simulate
from dynamics.compliant.compliant_motion import (
    FORCE_SAMPLE_RATE,
    compliant_model,
    simulate_from,
)
from dynamics.compliant.law.height_profile import (
    SMOOTH_PROFILE,
    Profile,
    spline_profile,
)
from dynamics.compliant.law.linear_response import (
    linear_contact_force_blocks,
    motion_blocks,
)
from dynamics.compliant.law.sections import Imperfection, Roughness
from dynamics.compliant.law.unevenness import (
    curvature_number,
    rim_point_count,
    spectral_amplitudes,
    static_depth,
)
from dynamics.compliant.model_inputs import contact_law
from dynamics.compliant.stepping.model import CompliantModel
from dynamics.compliant.stepping.state_layout import STATE
from dynamics.compliant.stepping.table_modes import ContactModes, mode_energies
from dynamics.motion_plan import plan_motion
from dynamics.rattling.rattling_motion import (
    rattling_model,
    rolling_state_at_release,
    simulate_rattling,
)
from sonify.scene import Scene, load_scene

FIRST_INCLINATION = 0.1
"""Inclination at the start of the stretch [rad]."""

LAST_INCLINATION = 0.09
"""Inclination at the end of the stretch [rad]."""

MAX_DURATION = 0.5
"""Time limit of the stretch [s]; undisturbed, it lasts 0.22 s."""

FALL_RATE = 0.044
"""Rate at which the inclination of the steady motion decreases [rad/s]."""

MIN_DURATION = 0.1
"""Duration [s] of the shortest stretch with a spectrum of the force."""

TRANSIENT_DURATION = 0.05
"""Initial part of the stretch without influence on the spectrum of the force [s]."""

MIN_FORCE_RMS = 0.01
"""Smallest rms of the varying force, divided by the weight, to which errors relate."""

LONG_WAVE_CUTOFF = 6e-3
"""Shortest wavelength [m] of unevenness that does not excite the contact resonance."""

SHORT_WAVE_CUTOFF = 2e-3
"""Shortest wavelength [m] of unevenness that excites the contact resonance."""


class Errors(NamedTuple):
    """Deviations of a solution from the reference.

    Attributes
    ----------
    inclination : float
        Largest deviation of the inclination, divided by its decrease. Cubic polynomials
        of time replace the inclinations, which removes the ripple due to the heights.
    spectrum : float
        Rms deviation of the amplitude spectrum of the normal force, divided by the rms of
        its varying part.
    end : float
        Relative deviation of the time at which LAST_INCLINATION is reached.
    energy : float
        Relative deviation of the energy lost.
    """

    inclination: float
    spectrum: float
    end: float
    energy: float


class Stretch(NamedTuple):
    """A solved stretch of motion.

    Attributes
    ----------
    t, inclination, lost : (k,) arrays
        Time [s], inclination [rad] and energy lost since the start [J].
    force : (n,) array
        Normal force [N].
    force_rate : float
        Rate of the force [1/s].
    losses : int
        Number of losses of contact.
    """

    t: np.ndarray
    inclination: np.ndarray
    lost: np.ndarray
    force: np.ndarray
    force_rate: float
    losses: int

    def force_rms(self) -> float:
        """Return the rms [N] of the varying part of the force up to 5 kHz."""
        f, power = self.spectrum()
        return float(np.sqrt(power.sum() * f[1]))

    @property
    def end(self) -> float:
        """Time [s] at which LAST_INCLINATION is reached. Raises Failure if it never is."""
        below = np.flatnonzero(self.inclination <= LAST_INCLINATION)
        if not len(below):
            raise Failure(f"ends at {self.inclination[-1]:.3g} rad")
        last = below[0]
        pair = slice(last - 1, last + 1)
        return float(
            np.interp(-LAST_INCLINATION, -self.inclination[pair], self.t[pair])
        )

    def spectrum(self) -> tuple[np.ndarray, np.ndarray]:
        """Return frequencies (f,) [Hz] up to 5 kHz and the density (f,) [N^2/Hz] of the
        force from TRANSIENT_DURATION until the end."""
        resolution = 25.0  # Hz
        first = int(TRANSIENT_DURATION * self.force_rate)
        force = self.force[first : int(self.end * self.force_rate)]
        f, power = welch(
            force, self.force_rate, nperseg=round(self.force_rate / resolution)
        )
        audible = f <= 5e3
        return f[audible], power[audible]


@dataclass(frozen=True, kw_only=True)
class TableCase:
    """A table under the disk.

    Attributes
    ----------
    kind : str
        Kind of the table.
    curvature_number : float
        Curvature number of the heights at the start; 0 for a smooth table.
    shortest : float
        Shortest wavelength of random heights [m].
    order : int
        Number of waves around the rim of a wavy table; 0 for random heights.
    friction : float
        Coefficient of friction.
    is_flexible : bool
        True if the table has a mode.
    """

    kind: str
    curvature_number: float = 0.0
    shortest: float = LONG_WAVE_CUTOFF
    order: int = 0
    friction: float = 0.0
    is_flexible: bool = False

    @property
    def name(self) -> str:
        """Kind of the table and curvature number."""
        return f"{self.kind}, {self.curvature_number:g}"

    @cached_property
    def scene(self) -> Scene:
        """The smooth scene of the case."""
        scene = replace(load_scene("granite"), roughness=None).replace(
            "contact.body=rigid",
            "contact.loss_factor=0.1",
            f"friction.mu_static={self.friction}",
            f"friction.mu_dynamic={self.friction}",
            "friction.arm_nutation=0.0",
            "friction.arm_pivoting=0.0",
            "friction.arm_rolling=2.3e-4",
            "dissipation.contour_moment=0.0",
            "air.film=none",
            f"numerics.time_limit={MAX_DURATION}",
            # beyond LAST_INCLINATION, with room for nutation
            f"numerics.final_inclination={0.98 * LAST_INCLINATION}",
            f"release.inclination_deg={degrees(FIRST_INCLINATION)}",
        )
        omega = steady_state(contact_law(scene), FIRST_INCLINATION)[5:8]
        omega[0] = FALL_RATE
        scene = scene.replace(f"release.omega={omega.tolist()}")
        if not self.is_flexible:
            return scene
        mode = "order = 2, frequency = 60.0, damping_ratio = 0.05, modal_mass = 2.0"
        modes = f'{{kind = "modes", modes = [{{{mode}}}]}}'
        return scene.replace(f"surface={modes}")

    @cached_property
    def amplitudes(self) -> np.ndarray:
        """Complex amplitudes (n,) [m] of the heights around the rim, by order."""
        disk = self.scene.disk
        if self.order:
            unit = np.zeros(self.order + 1, complex)
            unit[self.order] = 1.0
        else:
            rough = Roughness(rms=1.0, shortest=self.shortest, exponent=1.0)
            unit = spectral_amplitudes(rough, 1.0, disk.radius)
        law = contact_law(self.scene)
        depth = static_depth(
            disk.weight, law.modulus, disk.radius, law.fillet, FIRST_INCLINATION
        )
        of_unit = curvature_number(unit, disk.radius, FIRST_INCLINATION, depth)
        return unit * (self.curvature_number / of_unit)

    @cached_property
    def heights(self) -> np.ndarray:
        """Heights (p,) [m] at equidistant angles around the rim."""
        count = rim_point_count(len(self.amplitudes) - 1)
        waves = np.zeros(count // 2 + 1, complex)
        waves[: len(self.amplitudes)] = self.amplitudes
        return np.fft.irfft(waves, count) * count / 2

    @cached_property
    def profiles(self) -> tuple[Profile, Profile]:
        """Height profiles of a smooth table and of an edge with all heights."""
        if not self.curvature_number:
            return SMOOTH_PROFILE, SMOOTH_PROFILE
        edge = spline_profile(
            np.fft.rfft(self.heights), 2 * pi * self.scene.disk.radius
        )
        return SMOOTH_PROFILE, edge

    @property
    def models(self) -> tuple[str, ...]:
        """Names of the models that apply; on a flexible table "full" follows the gap."""
        return tuple(name for name in SOLVERS if name != "full" or not self.is_flexible)

    def solve(self, model: str, rate: float) -> Answer:
        """Return the `Stretch` by one of `models`.

        `rate` [1/s] is that of the force samples of the filter and of the time steps of
        the other models. Raises Failure if the solution ends early."""
        motion, force, force_rate = SOLVERS[model](self, rate)
        t = np.arange(0.0, motion.t[-1], 1e-4)
        stretch = Stretch(
            t,
            motion.at(t)[:, 1],
            motion.energy(np.zeros(1)) - motion.energy(t),
            force,
            force_rate,
            len(motion.contact_losses),
        )
        if stretch.end < MIN_DURATION:
            raise Failure(
                f"reaches {LAST_INCLINATION} rad after {stretch.end:.2g} s already"
            )
        return Answer(stretch, int(stretch.end * rate))

    def planned(self, model: str, rate: float = 4e5):
        """Return the plan of the smooth scene with a contact model."""
        scene = self.scene.replace(
            f"numerics.contact={model}", f"numerics.contact_rate={rate}"
        )
        if self.is_flexible:
            action = "sound" if model == "filter" else "motion"
            scene = scene.replace(f"surface.action={action}")
        return plan_motion(scene)


def filtered(case: TableCase, rate: float):
    """Return motion, force (n,) [N] and its rate of the linear response along the rigid
    motion. The table yields to the varying part of the force."""
    plan = case.planned("filter")
    motion = simulate(plan.scene)
    blocks = motion_blocks(motion, rate)
    modes = plan.surface_modes
    varying = np.concatenate(
        list(
            linear_contact_force_blocks(
                plan.series_tabulated_law, blocks, rate, case.profiles, modes
            )
        )
    )[:, 1]
    t = (np.arange(len(varying)) + 1) / rate
    return motion, motion.force(t)[:, 2] + varying, rate


class TableAtRest(CompliantModel):
    """One contact on a table that is at rest at the start, bent by the weight, as for
    contacts anywhere on the rim."""

    def supporting_modes(self, y: np.ndarray) -> ContactModes:
        """Return the modes that support a disk in the state y, and adjust its height."""
        modes = super().supporting_modes(y)
        if self.modes is not None:
            y[2] -= modes.amplitude @ modes.shape_before
            modes.velocity[:] = 0.0
            modes.amplitude[:] = -y[STATE.normal_force] * modes.shape_before
            modes.amplitude[:] /= modes.stiffness
            y[STATE.table_mode_energy], _ = mode_energies(modes)
            y[2] += modes.amplitude @ modes.shape_before
        return modes


def one_contact(case: TableCase, rate: float, imperfection=None):
    """Return motion, force (n,) [N] and its rate of one contact in time steps.

    The contact is the lowest point of the disk, or with an `imperfection` the point of
    the smallest gap without the heights."""
    plan = case.planned("full", rate)
    scene = plan.scene
    planned = compliant_model(plan)
    model = TableAtRest(
        **{field.name: vars(planned)[field.name] for field in fields(planned)}
        | {"profiles": case.profiles, "imperfection": imperfection}
    )
    still = np.zeros(3)
    motion = simulate_from(
        plan,
        model,
        np.concatenate([[0.0, FIRST_INCLINATION], still, scene.release.omega, still]),
        np.array([0.0, 0.0, scene.disk.weight]),
        MAX_DURATION,
        scene.numerics.final_inclination,
    )
    return motion, _step_forces(motion), FORCE_SAMPLE_RATE


def one_tracked_contact(case: TableCase, rate: float):
    """Return the solution of `one_contact` at the smallest gap, as on wavy and flexible
    tables. Waves of 1 fm select these steps on a rigid table."""
    no_waves = Imperfection(amplitude=1e-15)
    return one_contact(case, rate, None if case.is_flexible else no_waves)


def contacts_anywhere(case: TableCase, rate: float):
    """Return motion, force (n,) [N] and its rate of contacts anywhere on the rim in time
    steps."""
    plan = case.planned("many", rate)
    scene = plan.scene
    model = rattling_model(plan)._replace(
        amplitudes=case.amplitudes, heights=case.heights
    )
    state = rolling_state_at_release(model, FIRST_INCLINATION, scene.release.omega)
    final_tilt = (scene.disk.radius - model.constants.fillet) * np.sin(
        scene.numerics.final_inclination
    )
    motion = simulate_rattling(model, state, MAX_DURATION, final_tilt)
    return motion, _step_forces(motion), FORCE_SAMPLE_RATE


def _step_forces(motion) -> np.ndarray:
    """Return the mean normal force (n,) [N] between the stored impulses of a motion."""
    return np.diff(motion.impulses[:, 2]) * FORCE_SAMPLE_RATE


SOLVERS = {
    "filter": filtered,
    "full": one_contact,
    "full, tracked": one_tracked_contact,
    "many": contacts_anywhere,
}
"""Functions of case and rate by the name of the model."""


def predicted_force_rms(case: TableCase) -> float:
    """Return the rms of the varying force by the filter, divided by the weight."""
    stretch = case.solve("filter", 1.92e5).values
    return stretch.force_rms() / case.scene.disk.weight


def errors(found: Stretch, reference: Stretch, weight: float) -> Errors:
    """Return the errors of a stretch of a disk of a weight [N] against a reference."""
    stop = min(found.end, reference.end)
    common = np.linspace(0.0, stop, 1000)
    inclination = [
        np.polynomial.Polynomial.fit(
            common, np.interp(common, each.t, each.inclination), 3
        )(common)
        for each in (found, reference)
    ]
    lost = [np.interp(stop, each.t, each.lost) for each in (found, reference)]
    f, exact = reference.spectrum()
    amplitude = np.sqrt(np.interp(f, *found.spectrum()))
    varying = max(reference.force_rms(), MIN_FORCE_RMS * weight)
    deviation = np.sqrt(np.sum((amplitude - np.sqrt(exact)) ** 2) * f[1])
    fall = FIRST_INCLINATION - LAST_INCLINATION
    return Errors(
        inclination=float(np.abs(inclination[0] - inclination[1]).max() / fall),
        spectrum=float(deviation / varying),
        end=abs(found.end / reference.end - 1),
        energy=float(abs(lost[0] / lost[1] - 1)),
    )


LONG_WAVE_CASE = partial(TableCase, kind="rough, long waves")
SHORT_WAVE_CASE = partial(
    TableCase, kind="rough, short waves", shortest=SHORT_WAVE_CUTOFF
)
WAVY_TABLE_CASE = partial(TableCase, kind="wavy", order=12)
FLEXIBLE_TABLE_CASE = partial(TableCase, kind="flexible", is_flexible=True)
FRICTION_CASE = partial(TableCase, kind="with friction", friction=10.0)
CASES = {
    case.name: case
    for case in (
        TableCase(kind="smooth"),
        *(
            LONG_WAVE_CASE(curvature_number=k)
            for k in (0.05, 0.1, 0.2, 0.25, 0.3, 0.4, 0.5)
        ),
        *(WAVY_TABLE_CASE(curvature_number=k) for k in (0.1, 0.25, 0.5)),
        *(
            SHORT_WAVE_CASE(curvature_number=k)
            for k in (0.02, 0.03, 0.04, 0.05, 0.07, 0.1, 0.2)
        ),
        *(FLEXIBLE_TABLE_CASE(curvature_number=k) for k in (0.0, 0.2)),
        *(FRICTION_CASE(curvature_number=k) for k in (0.0, 0.2)),
    )
}
"""All cases by name."""
