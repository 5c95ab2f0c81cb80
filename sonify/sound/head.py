"""Compute the pressure at the ears of a head, modelled as a rigid sphere.

The pressure due to a point source at a finite distance is the series of Duda & Martens
(1998, J. Acoust. Soc. Am. 104, 3048), here with the time dependence exp(i w t).
Recurrences for ratios of Hankel functions avoid overflow and loss of precision."""

from dataclasses import dataclass

import numpy as np

from modal.radiation import SOUND_SPEED

EAR_LATENCY = 32  # samples
"""Delay of the ear filter, which makes room for the precursors of its band-limited
response."""


@dataclass(frozen=True, kw_only=True)
class Ear:
    """One ear of a spherical head.

    Attributes
    ----------
    head_radius : float
        Radius of the head [m].
    source_distance : float
        Distance of the source from the centre of the head [m].
    cosine : float
        Cosine of the angle between ear and source, measured at the centre of the head.
    """

    head_radius: float
    source_distance: float
    cosine: float

    @property
    def path(self) -> float:
        """Straight distance from the source to the ear [m]."""
        a = self.head_radius
        d = self.source_distance
        return float(np.sqrt(a * a + d * d - 2 * a * d * self.cosine))


def ear_pressure_ratio(
    ear: Ear, frequency: np.ndarray, sound_speed: float = SOUND_SPEED
) -> np.ndarray:
    """Return the ratio (k,) of the pressure at an ear to the free-field pressure.

    The frequencies (k,) [Hz] are positive; the phase is that of exp(i w t). With k a =
    x, the total pressure of a unit source on the sphere is -k/x^2 times the sum over m
    of (2 m + 1) P_m(cosine) h_m(k d)/h_m'(x)."""
    tolerance = 1e-12
    k = 2 * np.pi * np.asarray(frequency, float) / sound_speed
    near = k * ear.head_radius
    far = k * ear.source_distance
    near_ratio = 1 / near + 1j  # h_1/h_0, of the second kind
    far_ratio = 1 / far + 1j
    # h_0(far)/h_0(near), without the phase of the straight path
    decay = near / far * np.exp(-1j * (far - near - k * ear.path))
    legendre = (1.0, ear.cosine)
    total = -decay / near_ratio
    m = 0
    converged = 0
    while converged < 2:
        m += 1
        decay = decay * far_ratio / near_ratio
        slope = 1 / near_ratio - (m + 1) / near
        total = total + (2 * m + 1) * legendre[1] * decay / slope
        bound = (2 * m + 1) * np.abs(decay / slope)
        converged = converged + 1 if (bound < tolerance * np.abs(total)).all() else 0
        near_ratio = (2 * m + 1) / near - 1 / near_ratio
        far_ratio = (2 * m + 1) / far - 1 / far_ratio
        legendre = (
            legendre[1],
            ((2 * m + 1) * ear.cosine * legendre[1] - m * legendre[0]) / (m + 1),
        )
    return -k / near**2 * total * ear.path


def ear_taps(
    ear: Ear, sample_rate: float, sound_speed: float = SOUND_SPEED
) -> np.ndarray:
    """Return the filter taps of `ear_pressure_ratio`, delayed by EAR_LATENCY.

    The filter is twelve travel times over the head diameter long, after which the
    creeping waves have decayed. The response is tapered to zero over the highest tenth
    of the band."""
    lead = EAR_LATENCY
    count = lead + int(24 * ear.head_radius / sound_speed * sample_rate) + lead
    size = 4 << count.bit_length()
    frequency = np.fft.rfftfreq(size, 1 / sample_rate)
    lowest = 1e-3 * sound_speed / ear.head_radius  # Hz; the ratio is constant below
    ratio = ear_pressure_ratio(ear, np.maximum(frequency, lowest), sound_speed)
    ratio[0] = ratio[0].real
    above = np.clip(20 * frequency / sample_rate - 9, 0, 1)
    delay = np.exp(-2j * np.pi * frequency / sample_rate * lead)
    taps = np.fft.irfft(ratio * delay * np.cos(np.pi / 2 * above) ** 2, size)[:count]
    edge = np.minimum(np.arange(count), np.arange(count)[::-1]) / (lead / 2)
    return taps * np.minimum(edge, 1.0)
