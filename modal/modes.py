"""Define the scene sections of the elastic disk and the record of its modes.

The coordinate frame is fixed in the disk. Its origin is the centre, z is the axis, and
x points to the middle of the patch, at the circumferential angle 0. In the paper's
basis (2.1), with the contact at the patch, x, y, z = -e3, -e1, e2. The bottom face, z =
-thickness/2, faces the table.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from math import log, pi
from typing import TYPE_CHECKING, Annotated, Literal

import numpy as np
from annotated_types import Ge, Gt, Le, Lt
from numpy.polynomial.legendre import legvander
from numpy.typing import ArrayLike

from modal.materials import MATERIALS, MaterialName

if TYPE_CHECKING:
    from matplotlib.figure import Figure

DEFAULT_HIGHEST_FREQUENCY = 24000.0  # Hz
"""Default exclusive upper limit of the frequencies of modes."""


class UnsolvableError(ArithmeticError, ValueError):
    """Error for modes that cannot be computed; the message is one line.

    It is raised if there are too many modes or if round-off exceeds the lowest modes.

    Examples
    --------
    >>> from modal import UnsolvableError
    >>> issubclass(UnsolvableError, ValueError)
    True
    """


@dataclass(frozen=True, kw_only=True)
class Material:
    """An isotropic elastic solid.

    It is specified by a name from `modal.materials` or by its constants, which take
    precedence over those of the named material.

    Raises
    ------
    ValueError
        If there is neither a name nor both elastic constants.

    Examples
    --------
    >>> from modal import Material
    >>> glass = Material(name="glass", loss_factor=0.005)
    >>> glass.young, glass.loss_factor
    (70000000000.0, 0.005)
    """

    name: MaterialName | None = None
    """Name of a material; its typical values replace constants that are not given."""
    young: Annotated[float, Ge(1), Le(1e15)] = None  # type: ignore[assignment]
    """Young's modulus [Pa]; required unless the material is named."""
    poisson: Annotated[float, Gt(-1), Lt(0.5)] = None  # type: ignore[assignment]
    """Poisson's ratio; required unless the material is named."""
    loss_factor: Annotated[float, Ge(0), Le(1)] = None  # type: ignore[assignment]
    """Loss factor: energy lost per radian divided by the stored energy, the inverse of
    the quality factor (default: that of the named material, or 0)."""
    decay_rates: tuple[Annotated[float, Ge(0), Le(1e6)], ...] = ()
    """Measured decay rates [1/s] of the lowest modes, in order of frequency."""

    def __post_init__(self) -> None:
        typical = self.tabulated_constants
        for key in ("young", "poisson"):
            if vars(self)[key] is None and key not in typical:
                raise ValueError(
                    f"{key}: missing; give it or the name of a material ({', '.join(MATERIALS)})"
                )
        typical.setdefault("loss_factor", 0.0)
        for key, value in typical.items():
            if vars(self)[key] is None:
                object.__setattr__(self, key, value)

    @property
    def tabulated_constants(self) -> dict[str, float]:
        """Elastic constants and loss factor of a named material; empty without a name."""
        if self.name is None:
            return {}
        named = MATERIALS[self.name]
        return {key: getattr(named, key) for key in ("young", "poisson", "loss_factor")}


@dataclass(frozen=True, kw_only=True)
class Support:
    """Support of the disk: a held patch, none, or the springs of an elastic contact.

    The lower bounds exclude patches so small that round-off exceeds the lowest modes.

    Raises
    ------
    ValueError
        If `held` is empty or has duplicates, or if an inclination is given and `kind`
        is not "contact".

    Examples
    --------
    >>> from modal import Support
    >>> Support(kind="free").half_angle_deg
    5.0
    """

    kind: Literal["patch", "free", "contact"] = "patch"
    """Kind of support: held on a patch around angle 0, free, or on the springs of the
    contact."""
    inclination_deg: Annotated[float, Ge(1e-5), Lt(90)] | None = None
    """Inclination of the disk on its contact [degrees] (default: that of the
    release)."""
    half_angle_deg: Annotated[float, Ge(0.01), Le(180)] = 5.0
    """Half of the angle covered by the patch [degrees]."""
    height: Annotated[float, Ge(1e-5), Le(100)] | None = None
    """Height of the patch [m] (default: the thickness of the disk)."""
    position: Literal["middle", "bottom"] = "middle"
    """Position of a patch lower than the disk: at mid-thickness, or at the bottom
    rim."""
    held: tuple[Literal["radial", "tangential", "axial"], ...] = (
        "radial",
        "tangential",
        "axial",
    )
    """Components of the displacement that vanish on the patch."""

    def __post_init__(self) -> None:
        if not self.held or len(set(self.held)) < len(self.held):
            raise ValueError(
                "held must contain one or more of radial, tangential, axial, each at most once"
            )
        if self.inclination_deg is not None and self.kind != "contact":
            requirement = f"allowed only with kind = 'contact', not {self.kind!r}"
            raise ValueError(
                f"inclination_deg = {self.inclination_deg:g}: {requirement}"
            )


@dataclass(frozen=True, kw_only=True)
class Body:
    """Mode shapes on a mesh of the whole disk.

    Attributes
    ----------
    points : ndarray, shape (p, 3)
        Nodes [m].
    cells : ndarray of int, shape (c, nodes)
        Node numbers of each cell in VTK's order.
    cell_type : str
        meshio's name of the cell type.
    displacement : ndarray, shape (m, p, 3)
        Displacement of the nodes along x, y, z in each mode [kg^-1/2].

    Examples
    --------
    >>> from modal import Material, Plate, plate_modes
    >>> steel = Material(name="steel")
    >>> plate = Plate(radius=0.0375, thickness=0.003, material=steel, density=7850.0)
    >>> modes = plate_modes(plate, 8e3, "draft")
    >>> modes.body.cell_type
    'hexahedron27'
    """

    points: np.ndarray
    cells: np.ndarray
    cell_type: str
    displacement: np.ndarray


PER_MODE_ARRAYS = (
    "frequency",
    "decay_rate",
    "order",
    "partner",
    "participation",
    "rim_shape",
    "face_shape",
    "residual",
    "error",
)
"""Fields of `Modes` that are arrays with one row per mode."""


def fourier_interpolation(values: np.ndarray, angle: ArrayLike) -> np.ndarray:
    """Interpolate values at equally spaced angles to other angles by their Fourier sum.

    The values (..., n) at n angles are converted to values (..., k) at `angle` (k,)
    [rad].
    """
    n = values.shape[-1]
    coefficients = np.fft.rfft(values) / n
    coefficients[..., 1 : (n + 1) // 2] *= 2
    magnitude = np.abs(coefficients).max(
        axis=tuple(range(coefficients.ndim - 1)), initial=0.0
    )
    order = np.flatnonzero(magnitude > np.finfo(float).eps * magnitude.max())
    phase = np.outer(order, np.asarray(angle))
    kept = coefficients[..., order]
    return kept.real @ np.cos(phase) - kept.imag @ np.sin(phase)


class ModeList:
    """Base class of records of modes.

    The arrays are finite and read-only. The length of a record is its number of modes.
    """

    frequency: np.ndarray
    method: str
    unknowns: int

    def __post_init__(self) -> None:
        for name, value in vars(self).items():
            if isinstance(value, np.ndarray):
                if not np.isfinite(value).all():
                    raise ArithmeticError(
                        f"{type(self).__name__}: {name} has non-finite values"
                    )
                value.flags.writeable = False

    def __len__(self) -> int:
        return len(self.frequency)

    def __repr__(self) -> str:
        """Return a one-line summary: number of modes, frequency range, method and
        unknowns."""
        span = (
            f", {self.frequency[0]:.6g} to {self.frequency[-1]:.6g} Hz"
            if len(self)
            else ""
        )
        return f"{type(self).__name__}({len(self)}{span}; {self.method}, {self.unknowns} unknowns)"

    def as_indices(self, selection: Sequence[int] | np.ndarray) -> np.ndarray:
        """Convert a selection of modes to indices.

        Parameters
        ----------
        selection : sequence of int, shape (k,), or ndarray of bool, shape (m,)
            Indices in the desired order, or a mask.

        Returns
        -------
        ndarray of int, shape (k,)
            Indices of the selected modes.
        """
        return np.arange(len(self))[
            np.asarray(selection, dtype=None if len(selection) else int)
        ]


@dataclass(frozen=True, kw_only=True, repr=False, eq=False)
class Modes(ModeList):
    """The m elastic modes of a disk in ascending order of frequency.

    Rigid-body modes are excluded. The shapes phi [kg^-1/2] are normalised to unit modal
    mass, phi^T M phi = 1.

    Attributes
    ----------
    frequency, decay_rate : ndarray, shape (m,)
        Frequency [Hz] and decay rate [1/s]: a mode rings as exp(-decay_rate t) sin(2 pi
        frequency t).
    order : ndarray of int, shape (m,)
        Number of waves around the circumference; the dominant order for a held disk.
    family : tuple of str, length m
        "flexural" (axial motion), "extensional" (in-plane motion), or "torsional"
        (order 0 of a free disk, with u_theta only).
    parity : tuple of str, length m
        "even": symmetric about the plane y = 0, u_r and u_z ~ cos n theta. "odd": the
        sine partner.
    partner : ndarray of int, shape (m,)
        Index of the other mode of a degenerate pair of an axisymmetric disk, or -1 if
        there is none.
    participation : ndarray, shape (m, 6)
        phi^T M r for translations r along x, y, z [kg^1/2] and rotations about axes x,
        y, z through the centre [kg^1/2 m]. A base acceleration r drives q'' with
        -participation.
    rim_angle : ndarray, shape (k,)
        Equally spaced angles [rad] at the bottom edge.
    rim_shape : ndarray, shape (m, k, 3)
        Radial, tangential and axial displacement of the bottom edge at `rim_angle`
        [kg^-1/2].
    face_radius, face_weight : ndarray, shape (a,)
        Gauss radii [m] and weights [m^2] of the faces. The weights include the factor
        r: the integral of w over a face is ``sum(face_weight[:, None] * w) * 2 * pi /
        b`` [m^2].
    face_angle : ndarray, shape (b,)
        Equally spaced angles [rad] on the faces.
    face_shape : ndarray, shape (m, 2, a, b)
        Axial displacement of the bottom (0) and top (1) faces [kg^-1/2].
    residual : ndarray, shape (m,)
        |phi - w^2 K^-1 M phi| / |phi| of the computed eigenpair, with K shifted if the
        body is free.
    error : ndarray, shape (m,)
        Estimated relative error of the frequency.
    mass : float
        Mass of the discrete model [kg].
    method : str
        Method of computation.
    unknowns : int
        Number of unknowns of the discrete model.
    body : Body
        Mode shapes on a mesh of the whole disk.

    Examples
    --------
    >>> from modal import Material, Plate, plate_modes
    >>> steel = Material(name="steel")
    >>> plate = Plate(radius=0.0375, thickness=0.003, material=steel, density=7850.0)
    >>> modes = plate_modes(plate, 8e3, "draft")
    >>> modes.order.tolist()
    [2, 2, 0, 3, 3]
    >>> modes.partner.tolist()
    [1, 0, -1, 4, 3]
    """

    frequency: np.ndarray
    decay_rate: np.ndarray
    order: np.ndarray
    family: tuple[str, ...]
    parity: tuple[str, ...]
    partner: np.ndarray
    participation: np.ndarray
    rim_angle: np.ndarray
    rim_shape: np.ndarray
    face_radius: np.ndarray
    face_weight: np.ndarray
    face_angle: np.ndarray
    face_shape: np.ndarray
    residual: np.ndarray
    error: np.ndarray
    mass: float
    method: str
    unknowns: int
    body: Body

    @property
    def decay_time(self) -> np.ndarray:
        """Time T60 (m,) [s] in which a mode decays by 60 dB; infinite without
        losses."""
        with np.errstate(divide="ignore"):
            return 3 * log(10) / self.decay_rate

    @property
    def quality(self) -> np.ndarray:
        """Quality factor (m,), Q = pi f/d with the decay rate d; infinite without
        losses."""
        with np.errstate(divide="ignore"):
            return pi * self.frequency / self.decay_rate

    @property
    def effective_mass(self) -> np.ndarray:
        """Effective masses (m, 6) [kg; kg m^2], the squared participations.

        The sums over all modes of a held disk are its mass and its moments of inertia.
        """
        return self.participation**2

    def plot(self) -> "Figure":
        """Plot frequency against order, and decay time against frequency.

        Returns
        -------
        matplotlib.figure.Figure
            The figure.

        Examples
        --------
        >>> figure = modes.plot()  # doctest: +SKIP
        >>> figure.savefig("modes.png")  # doctest: +SKIP
        """
        from modal.plotting import plot_modes  # matplotlib is slow to import

        return plot_modes(self)

    def select(self, indices: Sequence[int] | np.ndarray) -> "Modes":
        """Return a selection of the modes.

        Parameters
        ----------
        indices : sequence of int, shape (k,), or ndarray of bool, shape (m,)
            Indices in the desired order, or a mask.

        Returns
        -------
        Modes
            The selected modes. `partner` is renumbered and is -1 if the partner is not
            selected.
        """
        kept = self.as_indices(indices)
        new_index = np.full(len(self) + 1, -1)
        new_index[kept] = np.arange(len(kept))
        arrays = {name: getattr(self, name)[kept] for name in PER_MODE_ARRAYS}
        arrays["partner"] = new_index[arrays["partner"]]
        family = tuple(self.family[i] for i in kept)
        parity = tuple(self.parity[i] for i in kept)
        body = replace(self.body, displacement=self.body.displacement[kept])
        return replace(self, family=family, parity=parity, body=body, **arrays)

    def at_rim(self, angle: ArrayLike) -> np.ndarray:
        """Return the mode shapes at points of the bottom edge.

        Parameters
        ----------
        angle : array_like, shape (k,)
            Circumferential angles [rad].

        Returns
        -------
        ndarray, shape (m, k, 3)
            Radial, tangential and axial displacement [kg^-1/2], from the Fourier sum of
            `rim_shape`.
        """
        shape = fourier_interpolation(
            self.rim_shape.transpose(0, 2, 1), np.atleast_1d(angle)
        )
        return np.ascontiguousarray(shape.transpose(0, 2, 1))

    def at_face(self, radius: ArrayLike, angle: ArrayLike) -> np.ndarray:
        """Return the axial displacement of the modes at points of both faces, up to the
        rim.

        Parameters
        ----------
        radius, angle : array_like, shape (k,)
            Polar coordinates of the points [m], [rad].

        Returns
        -------
        ndarray, shape (m, 2, k)
            Axial displacement [kg^-1/2] of the bottom (0) and top (1) faces,
            interpolated by Fourier sums in the angle and polynomials through the Gauss
            points in the radius.
        """
        radius, angle = np.broadcast_arrays(np.atleast_1d(radius), angle)
        nodes = self.face_radius

        def legendre_values(r: np.ndarray) -> np.ndarray:
            return legvander(2 * (r - nodes[0]) / np.ptp(nodes) - 1, len(nodes) - 1)

        to_points = legendre_values(radius) @ np.linalg.inv(legendre_values(nodes))
        in_angle = fourier_interpolation(self.face_shape, angle)
        return np.einsum("mfrk,kr->mfk", in_angle, to_points)

    def with_decay(self, decay_rate: ArrayLike) -> "Modes":
        """Return the same modes with other decay rates, for example measured ones.

        Parameters
        ----------
        decay_rate : float or array_like, shape (m,)
            Decay rates [1/s].

        Returns
        -------
        Modes
            The modes with these decay rates.

        Raises
        ------
        ValueError
            If a decay rate is negative.
        """
        decay_rate = np.broadcast_to(
            np.asarray(decay_rate, float), self.frequency.shape
        ).copy()
        if (decay_rate < 0).any():
            raise ValueError(f"decay_rate = {decay_rate.min():g}: must not be negative")
        return replace(self, decay_rate=decay_rate)
