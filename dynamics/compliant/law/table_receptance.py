"""Receptance of an elastic table at a contact that runs round a circle.

The receptance A_p is the deflection of the table along the force, in the frame of the
contact, per harmonic force exp(i w t) [m/N]. With the receptances A_c of the contact
and A_d of the disk, a height r of the surfaces changes the force by N' = r/(A_c + A_d +
A_p); on a rigid table A_p is zero.
"""

from dataclasses import dataclass
from functools import cached_property
from typing import Any, Protocol

import numpy as np

RECEPTANCE_AZIMUTH_COUNT = 256
"""Number of azimuths at which the shapes of a table are sampled round the contact circle."""
AVERAGED_AZIMUTH_COUNT = 64
"""Number of azimuths over which powers are averaged on a table that is not round."""
MAX_ROUND_VARIATION = 0.02
"""Relative variation of the receptance round the circle below which the table counts as round."""


class TableReceptance(Protocol):
    """Receptance of a table at the moving contact."""

    def __call__(self, omega: np.ndarray, rate: float) -> np.ndarray:
        """Return the receptance at angular frequencies and a precession rate.

        Parameters
        ----------
        omega : ndarray, (f,)
            Angular frequencies [rad/s] in the frame of the contact.
        rate : float
            Precession rate [rad/s].

        Returns
        -------
        ndarray, (a, f)
            Complex receptance [m/N] at a equally likely azimuths of the contact.
        """

    def supplied_by_weight(self, load: float, rate: float) -> float:
        """Return the power [W] that a constant load [N] loses to the moving table."""


class RigidTable:
    """A table that does not yield."""

    def __call__(self, omega: np.ndarray, rate: float) -> np.ndarray:
        """Return zeros (1, f); see `TableReceptance`."""
        return np.zeros((1, len(omega)))

    def supplied_by_weight(self, load: float, rate: float) -> float:
        """Return 0."""
        return 0.0


RIGID_TABLE = RigidTable()


@dataclass(frozen=True)
class ModalReceptance:
    """Receptance of a table with modes.

    Attributes
    ----------
    shapes : ndarray, (a, m)
        Deflections [kg^-1/2] of m modes at equidistant azimuths of the contact circle.
    frequency, decay_rate : ndarray, (m,)
        Frequencies [Hz] and decay rates [1/s].

    Notes
    -----
    A mode with the Fourier components c_n round the circle responds to a moving harmonic
    force at the frequencies w + n Omega. If the sum over the modes does not depend on
    the azimuth, as for a disk in the middle of a round table, then A_p = sum_m sum_n
    |c_n|^2 H_m(w + n Omega) exactly. Otherwise the table is quasi-static, A_p(azimuth) =
    sum_m w_m^2 H_m(w), and powers are averaged over the azimuth.
    """

    shapes: np.ndarray
    frequency: np.ndarray
    decay_rate: np.ndarray

    @cached_property
    def orders_and_squares(self) -> tuple[np.ndarray, np.ndarray]:
        """Orders (n,) and mean squares (n, m) of the shapes round the circle [1/kg]."""
        count = len(self.shapes)
        parts = np.abs(np.fft.fft(self.shapes, axis=0) / count) ** 2
        orders = np.fft.fftfreq(count, 1 / count)
        relevant = parts.max(axis=1) > 1e-8 * parts.max(initial=1e-300)
        return orders[relevant], parts[relevant]

    @cached_property
    def is_round(self) -> bool:
        """True if modes of equal frequency together deflect the same all round the circle."""
        square = _sums_of_equal_frequencies(self.shapes**2, self.frequency)
        largest = square.mean(axis=0).max(initial=0.0)
        return bool(np.all(square.std(axis=0) <= MAX_ROUND_VARIATION * largest))

    def __call__(self, omega: np.ndarray, rate: float) -> np.ndarray:
        """Return the receptance (a, f) [m/N]; see `TableReceptance`."""
        if not self.is_round:
            stride = max(len(self.shapes) // AVERAGED_AZIMUTH_COUNT, 1)
            return self.shapes[::stride] ** 2 @ self._response(omega)
        total = np.zeros(len(omega), complex)
        for order in self.orders_and_squares[0]:
            total += self.of_order(order, omega, rate)
        return total[None]

    def of_order(self, order: float, omega: np.ndarray, rate: float) -> np.ndarray:
        """Return the part (f,) [m/N] of the Fourier components of one order.

        It is the mean over the azimuth for a table that is not round.
        """
        orders, parts = self.orders_and_squares
        square = parts[orders == order].sum(axis=0)
        some = square > 1e-8 * square.max(initial=0.0)
        response = self._response(omega + order * rate, some)
        return square[some] @ response

    def supplied_by_weight(self, load: float, rate: float) -> float:
        """Return the power [W] of the weight that drags its own static bowl."""
        power = 0.0
        for order in self.orders_and_squares[0]:
            bowl = self.of_order(order, np.zeros(1), rate)[0].imag
            power -= order * rate * bowl
        return load**2 * power

    @cached_property
    def lowest_frequency_by_order(self) -> dict[float, float]:
        """Lowest frequency [Hz] of a mode with relevant waves of each order above 0."""
        min_share = 0.01  # of the mean square of the mode
        orders, parts = self.orders_and_squares
        shares = parts / np.maximum(parts.sum(axis=0), 1e-300)
        return {
            float(order): float(self.frequency[share > min_share].min())
            for order, share in zip(orders, shares, strict=True)
            if order > 0 and np.any(share > min_share)
        }

    def _response(self, omega: np.ndarray, some: Any = slice(None)) -> np.ndarray:
        """Return 1/(w_m^2 - w^2 + 2 i d_m w) (m, f) of some modes."""
        stiff = ((2 * np.pi * self.frequency[some]) ** 2)[:, None]
        return 1 / (stiff - omega**2 + 2j * self.decay_rate[some, None] * omega)


@dataclass(frozen=True)
class InfinitePlateReceptance:
    """Receptance Y/(i w) of an infinite plate, with the real mobility Y [s/kg]."""

    mobility: float

    def __call__(self, omega: np.ndarray, rate: float) -> np.ndarray:
        """Return the receptance (1, f) [m/N]; see `TableReceptance`."""
        return (self.mobility / (1j * omega))[None]

    def supplied_by_weight(self, load: float, rate: float) -> float:
        """Return 0: the static bowl of the infinite plate is left out."""
        return 0.0


def bending_stiffness(surface: Any) -> float:
    """Return the bending stiffness E h^3/(12 (1 - nu^2)) of a plate [N m].

    `surface` has thickness [m], young [Pa] and poisson.
    """
    return surface.young * surface.thickness**3 / (12 * (1 - surface.poisson**2))


def infinite_plate_mobility(surface: Any) -> float:
    """Return the point mobility 1/(8 sqrt(D rho h)) [s/kg] of an infinite plate.

    `surface` has thickness [m], young [Pa], poisson and density [kg/m^3].
    """
    mass_per_area = surface.density * surface.thickness
    return 1 / (8 * np.sqrt(bending_stiffness(surface) * mass_per_area))


def shapes_on_circle(modes: Any, centre: Any, radius: float, count: int) -> np.ndarray:
    """Return the shapes (count, m) [kg^-1/2] of a table at equidistant azimuths.

    Parameters
    ----------
    modes : modal.SurfaceModes
        Modes of the table.
    centre : array_like, (2,)
        Centre of the circle, in the frame of the modes [m].
    radius : float
        Radius of the circle [m].
    count : int
        Number of azimuths.

    Returns
    -------
    ndarray, (count, m)
        The shapes; the first azimuth is along x.
    """
    angle = 2 * np.pi * np.arange(count) / count
    circle = radius * np.array([np.cos(angle), np.sin(angle)])
    return modes.at(*(np.reshape(centre, (2, 1)) + circle))


def modal_receptance(modes: Any, radius: float) -> ModalReceptance:
    """Return the receptance of `modal.SurfaceModes` on a circle around the disk.

    Parameters
    ----------
    modes : modal.SurfaceModes
        Modes of the table.
    radius : float
        Radius of the contact circle [m].

    Returns
    -------
    ModalReceptance
        The receptance.
    """
    shapes = shapes_on_circle(modes, modes.place, radius, RECEPTANCE_AZIMUTH_COUNT)
    return ModalReceptance(shapes, modes.frequency, modes.decay_rate)


def mean_square_response(
    force_per_height: np.ndarray, receptance: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Return the response of the force to heights on an elastic table.

    Parameters
    ----------
    force_per_height : ndarray, (f,)
        N'/r = 1/(A_c + A_d) on a rigid table [N/m].
    receptance : ndarray, (a, f)
        Receptance of the table [m/N].

    Returns
    -------
    square : ndarray, (f,)
        Mean of |N'/r|^2 over the azimuth [N^2/m^2].
    response : ndarray, (f,)
        Mean of N'/r over the azimuth [N/m].
    """
    response = force_per_height / (1 + force_per_height * receptance)
    return np.mean(np.abs(response) ** 2, axis=0), np.mean(response, axis=0)


def _sums_of_equal_frequencies(values: np.ndarray, frequency: np.ndarray) -> np.ndarray:
    """Return the sums (a, g) of columns (a, m) whose frequencies agree within 1e-3."""
    begins = np.append(0, np.flatnonzero(np.diff(frequency) > 1e-3 * frequency[1:]) + 1)
    return np.add.reduceat(values, begins, axis=1)
