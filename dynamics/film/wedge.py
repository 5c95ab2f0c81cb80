"""Model of the air film, a wedge h = sin(beta) (R + x) closed at the contact x = -R.

In Reynolds' equation, the gap changes because the wedge rotates with the precession and
closes as the disk falls. reynolds.py solves this equation, forces.py contains
closed-form fits to the results, and tests/film/test_film_constants.py compares both.
"""

from collections.abc import Iterable
from itertools import islice, repeat
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from dynamics.air import Air
from dynamics.disk import Disk
from dynamics.dissipation import laws_of
from dynamics.equations import DiskConstants, Loads
from dynamics.film.forces import (
    COMPRESSION_ONSET_NUMBER,
    NO_HOLE,
    SLIP_MOBILITY_PER_KNUDSEN,
    film_forces,
)
from dynamics.kinematics import contact_arms, precession_rate
from dynamics.regime import ARRAY_FORMULAS

if TYPE_CHECKING:
    from dynamics.sections import MotionScene

ROTATION_POWER_COEFFICIENT = 0.1067607949
"""I in the power of a rotating film, 12 mu R^3 I Omega^2/sin(beta).

I = pi/3 - (32/pi) int_0^inf k^2 K0(k)/K1(k) F(k) dk with F(k) = int_k^inf K0 K1/t dt.
"""
FALL_POWER_COEFFICIENT = 0.3808
"""I_n in the power of a falling film, 12 mu R^3 I_n omega_1^2/sin(beta)^3."""
NO_FLAT_FACE_MESSAGE = (
    "disk.wall must exceed the rounded edge of the shell, so that it has a flat face"
)
"""What a disk lacks under which there is no film."""


class Film(NamedTuple):
    """Dimensionless constants of the air film (`film_forces`), which return its loads.

    The inertia of the rotating air increases the drag by the factor (1 +
    (S/6.3)^2.5)^0.4, S = sin(beta) R sqrt(Omega rho/(2 mu)). This fit to the unsteady
    Stokes equation is accurate to 5 % for S <= 3, and to 30 % above. The inertia of the
    falling film is neglected.
    """

    turning: Any
    falling: Any
    inertia: Any
    number: Any
    ambient: Any
    slip: Any
    bowl: Any = 0.0
    hole: Any = NO_HOLE

    @property
    def nonsmooth_at_zero_precession(self) -> bool:
        """False, because the film is smooth at any precession rate."""
        return False

    @property
    def keeps_disk_off_table(self) -> bool:
        """True, because the pressure of a film diverges as the gap closes."""
        return True

    @property
    def laws(self) -> tuple["Film"]:
        """The film as the only law of its loads."""
        return (self,)

    def __call__(
        self, beta: Any, omega: Any, slip: Any, constants: DiskConstants, flow: Any
    ) -> Loads:
        """Return the loads; the arguments are those of `OwnLaw.__call__`.

        They are the lift and the moments which together dissipate the power of the
        film.
        """
        s = flow.sin(beta)
        drag, tip, lift = film_forces(s, omega[0], precession_rate(omega[2], s), self)
        lever = contact_arms(flow.cos(beta), s, constants.h, constants.fillet)[1]
        return Loads(M1=-tip - lever * lift, M3=-drag, G3=lift)

    def moments_at(self, beta: Any, omega: Any) -> tuple[Any, Any, Any]:
        """Return the moments of `film_forces` at inclinations and angular velocities."""
        s = np.sin(beta)
        return film_forces(s, omega[0], precession_rate(omega[2], s), self)

    def rotation_and_fall_powers(self, beta: Any, omega: Any) -> tuple[Any, Any]:
        """Return the dimensionless powers dissipated by rotation and fall."""
        drag, tip, _ = self.moments_at(beta, omega)
        return drag * omega[2], tip * omega[0]

    @property
    def compiled_form(self) -> "Film":
        """The film with None as a placeholder for each run-time parameter."""
        return self.with_parameters(repeat(None))

    @property
    def runtime_parameters(self) -> tuple[float, ...]:
        """The six constants, followed by `bowl` if the table is concave or has a hole, and by
        the constants of the hole."""
        if self.hole[0]:
            return (*self[:7], *self.hole)
        return tuple(self[:7]) if self.bowl else tuple(self[:6])

    def with_parameters(self, parameters: Iterable[Any]) -> "Film":
        """Return a film with `parameters`, scalars of any type, as its constants."""
        values = iter(parameters)
        if self.hole[0] != 0:
            first = tuple(islice(values, 7))
            return Film(*first)._replace(hole=tuple(islice(values, len(NO_HOLE))))
        return Film(*islice(values, 6 if self.bowl == 0 else 7))


def film_under(disk: Disk, air: Air, curvature: float = 0.0, hole: float = 0.0) -> Film:
    """Return the film under a disk in air.

    `curvature` is that of a concave table [1/m], and `hole` the radius of a hole in table
    or disk, about the axis, over the radius of the flat face. Raises ValueError if the
    hole leaves no face, or in a vacuum.
    """
    if hole >= 1:
        raise ValueError(f"air.film = 'acts': {NO_FLAT_FACE_MESSAGE}")
    if not air.pressure:
        raise ValueError(
            "air.film = 'acts': requires air, but air.pressure = 0 (vacuum)"
        )
    R = disk.radius
    chi = disk.time_unit
    unit = disk.mass * R**2 / chi**2
    moment = 12 * air.viscosity * R**3 / (unit * chi)
    # ratio S of film to boundary-layer thickness above which inertia affects a rotating film
    inertia_onset_ratio = 6.3
    layers = R**2 * air.density / (2 * air.viscosity * chi) / inertia_onset_ratio**2
    return Film(
        turning=ROTATION_POWER_COEFFICIENT * moment,
        falling=FALL_POWER_COEFFICIENT * moment,
        inertia=layers**2,
        number=12 * air.viscosity / (air.pressure * chi * COMPRESSION_ONSET_NUMBER),
        ambient=air.pressure * np.pi * R**3 / unit,
        slip=SLIP_MOBILITY_PER_KNUDSEN * air.mean_free_path / R,
        bowl=curvature * R / 2,
        hole=_hole_constants(hole) if hole else NO_HOLE,
    )


def _hole_constants(hole: float) -> tuple[float, ...]:
    """Return the constants of `moment_parts_over_hole`, relative to a film without a hole.

    They are polynomials for drag, fall and lift.
    """
    from dynamics.film.annular_film import (  # imports scikit-fem
        closed_film_polynomials,
    )

    turning, closing, lifting = closed_film_polynomials(hole)
    turning = turning / ROTATION_POWER_COEFFICIENT
    resistances = np.concatenate([closing, lifting]) / FALL_POWER_COEFFICIENT
    return (*turning.tolist(), *resistances.tolist())


def film_of_scene(scene: "MotionScene") -> Film:
    """Return the film under the disk of a scene, whether or not it acts.

    Raises ValueError if the disk has no flat face, or in a vacuum.
    """
    return film_under(scene.disk, scene.air, scene.surface.curvature, hole_share(scene))


def hole_share(scene: "MotionScene") -> float:
    """Return the radius of the hole in table or disk over that of the flat face.

    Of two holes about the same axis, the larger one counts. The ratio is at least 1 for a
    shell without a flat face.
    """
    hole = max(scene.surface.hole / 2, scene.disk.inner_radius)
    return hole / flat_radius(scene)


def flat_radius(scene: "MotionScene") -> float:
    """Return the radius [m] of the flat face of the disk of a scene, inside its rounded edge."""
    return scene.disk.radius - scene.contact.rolling_fillet(scene.disk)


def film_in_si_units(film: Film | None, disk: Disk) -> Film:
    """Return the constants of a film under a disk in SI units; zeros without a film.

    `turning` and `falling` are in N m s, `inertia` in s^2, `number` in s and `ambient`
    in J.
    """
    chi = disk.time_unit
    energy = disk.mass * disk.radius**2 / chi**2
    units = energy * chi, energy * chi, chi**2, chi, energy, 1.0, 1.0
    if film is None:
        return Film(*(0.0,) * len(units))
    return Film(*np.multiply(film[:7], units).tolist())._replace(hole=film.hole)


def film_powers(disk: Disk, film: Film, state: np.ndarray) -> np.ndarray:
    """Return the powers (2, n) [W] dissipated by rotation and fall at states (n, 11)."""
    unit = disk.mass * disk.radius**2 / disk.time_unit**3
    return (
        np.array(
            film.rotation_and_fall_powers(state[:, 1], state[:, 5:8].T * disk.time_unit)
        )
        * unit
    )


def film_loads_of(film: Film | None, disk: Disk, state: np.ndarray) -> np.ndarray:
    """Return lift [N] and moments [N m] about e_1 and e_3, (3, k), at states (k, 11).

    They are zero without a film.
    """
    if film is None:
        return np.zeros((3, len(state)))
    chi = disk.time_unit
    frictionless = (0.0,) * 5
    law = DiskConstants(disk.aspect, disk.gyration, *frictionless)
    loads = film(state[:, 1], state[:, 5:8].T * chi, None, law, ARRAY_FORMULAS)
    force = disk.mass * disk.radius / chi**2
    moment = force * disk.radius
    return np.array([force * loads.G3, moment * loads.M1, moment * loads.M3])


def boundary_layer_ratio(beta: Any, rate: Any, radius: float, air: Air) -> Any:
    """Return S, the mean gap over the boundary-layer thickness sqrt(2 nu/Omega).

    `rate` is the precession rate [rad/s].
    """
    return (
        np.sin(beta)
        * radius
        * np.sqrt(np.abs(rate) * air.density / (2 * air.viscosity))
    )


def compressibility_number(beta: Any, rate: Any, air: Air) -> Any:
    """Return the compressibility number Lam = 12 mu Omega/(p sin(beta)^2).

    `rate` is the precession rate Omega [rad/s].
    """
    return rotation_number(rate, np.sin(beta), air)


def rotation_number(rate: Any, gap: Any, air: Air) -> Any:
    """Return Lam = 12 mu |Omega|/(p gap^2) at a precession rate Omega [rad/s].

    The mean gap is divided by the radius; it is sin(beta) for a disk in contact.
    """
    return 12 * air.viscosity * np.abs(rate) / (air.pressure * gap**2)


def squeeze_number(beta: Any, nutation: ArrayLike, radius: float, air: Air) -> Any:
    """Return the rate at which the film closes over that at which its air escapes.

    For a disk that falls at `nutation` [rad/s] it is 12 mu omega_1/(p beta^3), if wall
    slip is negligible. If the film retains its air, its resistance exceeds that of
    `film_forces` by 12 % where the number is 1, and by 27 % where it is 3.
    """
    s = np.sin(beta)
    out = s * s * (s + SLIP_MOBILITY_PER_KNUDSEN / 2 * air.mean_free_path / radius)
    return 12 * air.viscosity * np.maximum(nutation, 0.0) / (air.pressure * out)


def find_film(loads: Any) -> Film | None:
    """Return the `Film` among the loads of a motion, or None."""
    return next((law for law in laws_of(loads) if isinstance(law, Film)), None)
