"""The sections of a scene that the elastic modes read, and the record of the modes.

The frame of everything here is fixed in the disk: origin at its centre, z along its axis, x through the middle of the
patch at the circumferential angle 0. In the paper's basis (2.1), with the contact at the patch, x, y, z = -e3, -e1, e2;
the bottom face, which meets the table, is z = -thickness/2.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from math import log, pi
from typing import Annotated, Literal

import numpy as np
from annotated_types import Ge, Gt, Le, Lt
from numpy.polynomial.legendre import legvander
from numpy.typing import ArrayLike


class UnsolvableError(ArithmeticError, ValueError):
    """Modes that cannot be sought: too many of them, or lost in round-off. The message is one line."""


@dataclass(frozen=True, kw_only=True)
class Material:
    """An isotropic elastic solid."""

    young: Annotated[float, Ge(1), Le(1e15)]
    """Young's modulus [Pa]."""
    poisson: Annotated[float, Gt(-1), Lt(0.5)]
    """Poisson's ratio."""
    loss_factor: Annotated[float, Ge(0), Le(1)] = 0.0
    """Loss of energy per radian over the energy, the inverse of the quality factor."""
    decay_rates: tuple[Annotated[float, Ge(0), Le(1e6)], ...] = ()
    """Measured decay rates of the first modes, in order of their frequencies [1/s]."""


@dataclass(frozen=True, kw_only=True)
class Support:
    """How the disk is held; on patches below the bounds the lowest modes are lost in round-off."""

    kind: Literal["patch", "free", "contact"] = "patch"
    """By an arc of its lateral surface, centred at angle 0; not at all; or by the springs of its elastic contact."""
    inclination_deg: Annotated[float, Ge(1e-5), Lt(90)] | None = None
    """Inclination at which the disk stands on its contact [degrees], that of the release unless given."""
    half_angle_deg: Annotated[float, Ge(0.01), Le(180)] = 5.0
    """How far the patch reaches to either side [degrees]."""
    height: Annotated[float, Ge(1e-5), Le(100)] | None = None
    """How much of the thickness the patch takes [m], all of it unless given."""
    position: Literal["middle", "bottom"] = "middle"
    """Where a lower patch sits: in the middle of the thickness, or from the bottom rim up."""
    held: tuple[Literal["radial", "tangential", "axial"], ...] = ("radial", "tangential", "axial")
    """The components of the displacement that vanish on the patch."""

    def __post_init__(self):
        if not self.held or len(set(self.held)) < len(self.held):
            raise ValueError("held names each held component once: radial, tangential, axial")
        if self.inclination_deg is not None and self.kind != "contact":
            told = f"kind = 'contact' alone has one, and this is {self.kind!r}"
            raise ValueError(f"inclination_deg = {self.inclination_deg:g}: {told}")


@dataclass(frozen=True, kw_only=True)
class Body:
    """The mode shapes on a mesh of the whole disk: `points` (p, 3) [m], `cells` (c, nodes) in VTK order of the meshio
    type `cell_type`, `displacement` (m, p, 3) [kg^-1/2]."""

    points: np.ndarray
    cells: np.ndarray
    cell_type: str
    displacement: np.ndarray


OF_A_MODE: tuple[str, ...] = ("frequency", "decay_rate", "order", "partner", "participation", "rim_shape", "face_shape")
OF_A_MODE += ("residual", "error")
"""The arrays of `Modes` that have a row for every mode."""


def around(values, angle):
    """Fourier's sum (..., k) at angles (k,) [rad] of values (..., n) at n even angles, of the orders they contain."""
    n = values.shape[-1]
    wave = np.fft.rfft(values) / n
    wave[..., 1 : (n + 1) // 2] *= 2
    size = np.abs(wave).max(axis=tuple(range(wave.ndim - 1)), initial=0.0)
    order = np.flatnonzero(size > np.finfo(float).eps * size.max())
    turn = np.outer(order, angle)
    return wave.real[..., order] @ np.cos(turn) - wave.imag[..., order] @ np.sin(turn)


class ModeList:
    """What the records of modes have in common: arrays that are finite and cannot be changed, and a length."""

    frequency: np.ndarray
    method: str
    unknowns: int

    def __post_init__(self):
        for name, value in vars(self).items():
            if isinstance(value, np.ndarray):
                if not np.isfinite(value).all():
                    raise ArithmeticError(f"{type(self).__name__}: {name} has values that are not finite")
                value.flags.writeable = False

    def __len__(self):
        return len(self.frequency)

    def __repr__(self):
        """In one line."""
        span = f", {self.frequency[0]:.6g} to {self.frequency[-1]:.6g} Hz" if len(self) else ""
        return f"{type(self).__name__}({len(self)}{span}; {self.method}, {self.unknowns} unknowns)"

    def numbers(self, indices: Sequence[int] | np.ndarray) -> np.ndarray:
        """The numbers (k,) of modes that are given by indices (k,), or by a mask (m,)."""
        return np.arange(len(self))[np.asarray(indices, dtype=None if len(indices) else int)]


@dataclass(frozen=True, kw_only=True, repr=False)
class Modes(ModeList):
    """m elastic modes, ascending, rigid-body modes not among them, of modal mass 1: phi^T M phi = 1, phi in [kg^-1/2].

    frequency, decay_rate (m,) -- [Hz] and [1/s]: a mode rings as exp(-decay_rate t) sin(2 pi frequency t).
    order (m,)          -- number of waves around the circumference; of a held disk the strongest one.
    family (m,)         -- "flexural" (axial motion), "extensional" (in the plane), "torsional" (order 0 of a disk
                           that is not held, u_theta alone).
    parity (m,)         -- "even": symmetric about the plane y = 0, u_r, u_z ~ cos n theta; "odd": the sine partner.
    partner (m,)        -- index of the other mode of a degenerate pair of an axisymmetric disk; -1 if there is none.
    participation (m, 6) -- phi^T M r for the translations along x, y, z [kg^1/2] and the rotations about x, y, z
                           through the centre [kg^1/2 m]; a base that accelerates as r drives q'' with -participation.
    rim_angle (k,), rim_shape (m, k, 3) -- radial, tangential, axial displacement of the bottom edge at k even angles.
    face_radius (a,), face_weight (a,), face_angle (b,), face_shape (m, 2, a, b) -- axial displacement of the bottom (0)
                           and top (1) face at Gauss points in the radius and even angles: the integral over a face is
                           sum(face_weight[:, None] * w) * 2 pi / b, in m^2; face_weight includes the radius.
    residual (m,)       -- |phi - w^2 K^-1 M phi| / |phi| of the computed pair, K shifted where the body is free.
    error (m,)          -- estimated relative error of the frequency.
    mass                -- mass of the discrete model [kg].  method, unknowns -- how it was computed, and how large.
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
        """T60 (m,) [s]: time in which a mode falls by 60 dB; infinite without losses."""
        with np.errstate(divide="ignore"):
            return 3 * log(10) / self.decay_rate

    @property
    def quality(self) -> np.ndarray:
        """Q = pi f / d (m,); infinite without losses."""
        with np.errstate(divide="ignore"):
            return pi * self.frequency / self.decay_rate

    @property
    def effective_mass(self) -> np.ndarray:
        """participation^2 (m, 6) [kg, kg m^2]; the columns of a held disk add up to its mass and inertia."""
        return self.participation**2

    def select(self, indices: Sequence[int] | np.ndarray) -> "Modes":
        """The modes of these indices (k,), or a mask (m,), in that order; `partner` is renumbered, -1 if left out."""
        kept = self.numbers(indices)
        place = np.full(len(self) + 1, -1)
        place[kept] = np.arange(len(kept))
        of_a_mode = {name: getattr(self, name)[kept] for name in OF_A_MODE}
        of_a_mode["partner"] = place[of_a_mode["partner"]]
        family, parity = (tuple(names[i] for i in kept) for names in (self.family, self.parity))
        body = replace(self.body, displacement=self.body.displacement[kept])
        return replace(self, family=family, parity=parity, body=body, **of_a_mode)

    def at_rim(self, angle: ArrayLike) -> np.ndarray:
        """Radial, tangential, axial displacement (m, k, 3) [kg^-1/2] of the bottom edge at angles (k,) [rad]."""
        shape = around(self.rim_shape.transpose(0, 2, 1), np.atleast_1d(angle))
        return np.ascontiguousarray(shape.transpose(0, 2, 1))

    def at_face(self, radius: ArrayLike, angle: ArrayLike) -> np.ndarray:
        """Axial displacement (m, 2, k) [kg^-1/2] of the bottom (0) and top (1) face at radii [m], angles [rad], (k,).

        Fourier's sum of `face_shape` around, the polynomial through its Gauss points in the radius, up to the rim.
        """
        radius, angle = np.broadcast_arrays(np.atleast_1d(radius), angle)
        nodes, degree = self.face_radius, len(self.face_radius) - 1
        at, between = (legvander(2 * (r - nodes[0]) / np.ptp(nodes) - 1, degree) for r in (radius, nodes))
        return np.einsum("mfrk,kr->mfk", around(self.face_shape, angle), at @ np.linalg.inv(between))

    def with_decay(self, decay_rate: ArrayLike) -> "Modes":
        """The same modes with other decay rates (m,) or scalar [1/s], as measured on a real disk."""
        decay_rate = np.broadcast_to(np.asarray(decay_rate, float), self.frequency.shape).copy()
        if (decay_rate < 0).any():
            raise ValueError("a decay rate is not negative")
        return replace(self, decay_rate=decay_rate)
