"""Synthetic sounds of known law for the tests of the detector: settling disks and sounds that only
resemble them; degraded copies of a sound, and what the detector hears in samples."""

from dataclasses import dataclass

import numpy as np
from scipy.fft import dct, idct
from scipy.signal import butter, sosfilt

from sonify.hearing.settling.detector import SettlingRun, settling_runs

RATE = 48000


@dataclass(frozen=True)
class Take:
    """A sound and the law of its disk: exponent, end [s], rate one second before the end [Hz]."""

    samples: np.ndarray
    exponent: float
    t_end: float
    rate_at_1s: float
    kind: str


def clicks(times, levels, length, rng, decay=None, tonal=None):
    """Return a sound of `length` seconds with decaying bursts of noise, or of a few tones, at times
    [s]."""
    decay = rng.uniform(0.002, 0.008) if decay is None else decay
    tonal = rng.random() < 0.5 if tonal is None else tonal
    sound = np.zeros(int(length * RATE) + RATE)
    age = np.arange(int(8 * decay * RATE)) / RATE
    frequencies = rng.uniform(1500, 14000, size=4)
    for time, level in zip(times, levels, strict=True):
        if tonal:
            burst = np.sin(
                2 * np.pi * frequencies * age[:, None] + rng.uniform(0, 6.28, 4)
            ).sum(axis=1)
        else:
            burst = rng.normal(size=len(age))
        first = int(time * RATE)
        if 0 <= first < len(sound) - len(age):
            sound[first : first + len(age)] += level * burst * np.exp(-age / decay)
    return sound[: int(length * RATE)]


def with_noise(sound, snr_db, rng):
    """Return a sound with white noise, `snr_db` below the mean power of its audible part."""
    loud = np.abs(sound) > 1e-3 * np.abs(sound).max()
    power = np.mean(np.square(sound[loud]))
    noisy = sound + rng.normal(size=len(sound)) * np.sqrt(power * 10 ** (-snr_db / 10))
    return 0.3 * noisy / np.abs(noisy).max()


def times_of_phase(phase_of_time, first, last, jitter, rng):
    """Return the times between `first` and `last` at which a rising phase passes whole numbers.

    Each has a random jitter, in turns.
    """
    grid = np.linspace(first, last, 40000)
    phase = phase_of_time(grid)
    count = int(phase[-1] - phase[0])
    wanted = phase[0] + np.arange(count) + rng.normal(size=count) * jitter
    return np.interp(wanted, phase, grid)


def settling_phase(t, exponent, t_end, rate_at_1s):
    """Return the turns, up to a constant, for a rate `rate_at_1s` (t_end - t)^-exponent."""
    left = np.maximum(t_end - t, 1e-4)
    if abs(exponent - 1) < 1e-6:
        return -rate_at_1s * np.log(left)
    return -rate_at_1s * left ** (1 - exponent) / (1 - exponent)


def settling_take(seed, exponents=(1 / 6, 1.0), snr_db=(15, 40)):
    """Return a take of a disk with bursts that follow a random power law up to the end."""
    rng = np.random.default_rng(seed)
    exponent = rng.uniform(*exponents)
    rate = rng.uniform(12, 30)
    t_end = rng.uniform(2.5, 4.0)
    duration = rng.uniform(1.2, 2.2)
    last = rng.uniform(0.004, 0.02)
    times = times_of_phase(
        lambda t: settling_phase(t, exponent, t_end, rate),
        t_end - duration,
        t_end - last,
        rng.uniform(0, 0.05),
        rng,
    )
    spread = rng.uniform(0, 3)
    slope = rng.uniform(-0.4, 0.4)
    levels = (t_end - times) ** slope * 10 ** (
        rng.normal(size=len(times)) * spread / 20
    )
    sound = clicks(times, levels, t_end + rng.uniform(0.4, 1.2), rng)
    return Take(
        with_noise(sound, rng.uniform(*snr_db), rng), exponent, t_end, rate, "settling"
    )


def tonal_take(seed):
    """Return a take of a disk with a harmonic tone that follows a power law, in noise."""
    rng = np.random.default_rng(seed)
    exponent = rng.uniform(1 / 6, 1.0)
    rate = rng.uniform(25, 60)
    t_end = rng.uniform(3.5, 4.5)
    t = np.arange(int((t_end + 0.8) * RATE)) / RATE
    phase = settling_phase(np.minimum(t, t_end - 0.003), exponent, t_end, rate)
    sound = sum(
        np.sin(2 * np.pi * h * phase + h) / h for h in range(1, rng.integers(2, 5))
    )
    sound = (
        sound
        * (t < t_end - 0.003)
        * np.maximum(t_end - t, 0.003) ** rng.uniform(-0.3, 0.3)
    )
    return Take(
        with_noise(sound, rng.uniform(15, 40), rng), exponent, t_end, rate, "tonal"
    )


def compressed_take(seed):
    """Return a take degraded by a lossy codec: silent above 4 to 12 kHz, spectrum quantised."""
    take = settling_take(seed)
    rng = np.random.default_rng(seed)
    frame = 1152
    count = len(take.samples) // frame
    spectrum = dct(
        take.samples[: count * frame].reshape(count, frame), axis=1, norm="ortho"
    )
    step = rng.uniform(0.1, 0.5) * np.abs(spectrum).mean(axis=1, keepdims=True) + 1e-9
    spectrum = np.round(spectrum / step) * step
    spectrum[:, int(rng.uniform(4000, 12000) / RATE * 2 * frame) :] = 0
    samples = idct(spectrum, axis=1, norm="ortho").ravel()
    return Take(samples, take.exponent, take.t_end, take.rate_at_1s, "lossy codec")


def simulated_take(seed):
    """Return a take of known law: rattling, tonal, noisy (white noise at 8 to 15 dB) or from a
    lossy codec."""
    if seed % 4 == 0:
        return settling_take(seed)
    if seed % 4 == 1:
        return tonal_take(seed)
    if seed % 4 == 2:
        noisy = settling_take(seed, snr_db=(8, 15))
        return Take(
            noisy.samples, noisy.exponent, noisy.t_end, noisy.rate_at_1s, "noisy"
        )
    return compressed_take(seed)


def intervals_hold(take, run):
    """Return which intervals of a run, of exponent, end and rate, contain the truth of its take."""
    left = min(1.0, take.t_end - run.start)
    truths = (take.exponent, take.t_end, take.rate_at_1s * left**-take.exponent)
    estimates = (run.exponent, run.t_end, run.rate_at_1s)
    return [
        one.low < truth < one.high for one, truth in zip(estimates, truths, strict=True)
    ]


def train(rate_of_time, duration, rng, lead=0.6, tail=0.8, jitter=0.02):
    """Return a train of clicks with a given rate [Hz] as a function of time [s], which stops
    suddenly."""
    grid = np.linspace(0, duration, 20000)
    phase = np.concatenate([[0], np.cumsum(rate_of_time(grid[:-1]) * np.diff(grid))])
    count = int(phase[-1])
    times = np.interp(
        np.arange(1, count + 1) + rng.normal(size=count) * jitter, phase, grid
    )
    levels = 10 ** (rng.normal(size=count) * rng.uniform(0, 2) / 20)
    sound = clicks(lead + times, levels, lead + duration + tail, rng)
    return with_noise(sound, rng.uniform(20, 40), rng)


def metronome(seed):
    """Return clicks at a constant rate."""
    rng = np.random.default_rng(seed)
    rate = rng.uniform(6, 40)
    return train(lambda t: np.full_like(t, rate), rng.uniform(1, 3), rng)


def linear_train(seed):
    """Return clicks at a linearly rising rate."""
    rng = np.random.default_rng(seed)
    duration = rng.uniform(1, 3)
    low = rng.uniform(6, 12)
    high = rng.uniform(20, 60)
    return train(lambda t: low + (high - low) * t / duration, duration, rng)


def exponential_train(seed):
    """Return clicks at an exponentially rising rate."""
    rng = np.random.default_rng(seed)
    duration = rng.uniform(1, 3)
    low = rng.uniform(6, 12)
    high = rng.uniform(20, 60)
    return train(lambda t: low * (high / low) ** (t / duration), duration, rng)


def slowing_train(seed):
    """Return clicks at a falling rate: a wheel running down or a settling disk in reverse."""
    rng = np.random.default_rng(seed)
    duration = rng.uniform(1, 3)
    if seed % 2:
        high = rng.uniform(20, 50)
        low = rng.uniform(4, 8)
        return train(lambda t: high + (low - high) * t / duration, duration, rng)
    exponent = rng.uniform(0.3, 1)
    return train(lambda t: 15 * (t + 0.02) ** -exponent, duration, rng)


def bouncing_ball(seed):
    """Return the knocks of a bouncing ball: intervals and speeds fall geometrically."""
    rng = np.random.default_rng(seed)
    restitution = rng.uniform(0.75, 0.95)
    first = rng.uniform(0.2, 0.6)
    intervals = first * restitution ** np.arange(200)
    intervals = intervals[intervals > 0.004]
    times = 0.5 + np.concatenate([[0], np.cumsum(intervals)])
    levels = np.append(intervals, intervals[-1] * restitution) * 10 ** (
        rng.normal(size=len(times)) * 0.5 / 20
    )
    sound = clicks(times, levels, times[-1] + 0.8, rng)
    return with_noise(sound, rng.uniform(30, 50), rng)


def random_clicks(seed):
    """Return clicks at random times."""
    rng = np.random.default_rng(seed)
    times = np.cumsum(rng.exponential(1 / rng.uniform(8, 40), size=400))
    times = 0.3 + times[times < rng.uniform(1, 4)]
    sound = clicks(
        times, 10 ** (rng.normal(size=len(times)) * 4 / 20), times[-1] + 0.8, rng
    )
    return with_noise(sound, rng.uniform(20, 40), rng)


def engine(seed):
    """Return the sound of a motor that revs up and is switched off: harmonics of a saturating rate,
    in modulated noise."""
    rng = np.random.default_rng(seed)
    t = np.arange(int(4 * RATE)) / RATE
    rate = rng.uniform(15, 30) + rng.uniform(10, 60) * (
        1 - np.exp(-t / rng.uniform(0.3, 2))
    )
    phase = 2 * np.pi * np.cumsum(rate) / RATE
    tones = sum(np.cos(h * phase + rng.uniform(0, 6)) / h for h in range(1, 12))
    noise = rng.normal(size=len(t)) * np.maximum(1 + np.cos(phase), 0) ** 3
    sound = (tones + 0.5 * noise) * (t < 3.2) * np.minimum(1, t * 5)
    return with_noise(sound, rng.uniform(20, 40), rng)


def glissando(seed):
    """Return a harmonic tone that glides up, linearly or exponentially, and stops, as in audio test
    sweeps."""
    rng = np.random.default_rng(seed)
    duration = rng.uniform(1, 4)
    t = np.arange(int(5.5 * RATE)) / RATE
    low = rng.uniform(20, 80)
    high = rng.uniform(150, 2000)
    share = np.minimum(t / duration, 1)
    rate = low * (high / low) ** share if seed % 2 else low + (high - low) * share
    phase = 2 * np.pi * np.cumsum(rate) / RATE
    sound = sum(np.sin(h * phase) / h for h in range(1, rng.integers(2, 6)))
    return with_noise(sound * (t < duration), rng.uniform(20, 40), rng)


def modulated_noise(seed):
    """Return noise of slowly varying loudness that stops."""
    rng = np.random.default_rng(seed)
    t = np.arange(int(4 * RATE)) / RATE
    slow = sosfilt(
        butter(2, rng.uniform(10, 40), fs=RATE, output="sos"), rng.normal(size=len(t))
    )
    sound = rng.normal(size=len(t)) * np.exp(slow / slow.std()) * (t < 3)
    return with_noise(sound, rng.uniform(20, 40), rng)


IMITATIONS = {
    "metronome": metronome,
    "linear train": linear_train,
    "exponential train": exponential_train,
    "slowing train": slowing_train,
    "bouncing ball": bouncing_ball,
    "random clicks": random_clicks,
    "engine": engine,
    "glissando": glissando,
    "modulated noise": modulated_noise,
}
"""Sounds without a disk, by name; each is a function of a seed."""


@dataclass(frozen=True)
class Samples:
    """An audio source of samples (n, channels) in memory."""

    channels: np.ndarray
    sample_rate: int = RATE

    @property
    def frames(self):
        return len(self.channels)

    def blocks(self, start=0):
        for first in range(start, self.frames, 65536):
            yield self.channels[first : first + 65536]


def heard(samples, rate=RATE) -> list[SettlingRun]:
    """Return the settling runs found in samples (n,)."""
    return settling_runs(Samples(np.asarray(samples, dtype=np.float32)[:, None], rate))


def degraded(samples, rate):
    """Return samples (n,) of the end of a sound, and four degraded copies, by name."""
    noise = np.random.default_rng(0).standard_normal(len(samples)) * samples.std()
    low = butter(8, 3000, fs=rate, output="sos")
    return {
        "clean": samples,
        "clipped": np.clip(samples, *np.array([-0.3, 0.3]) * np.abs(samples).max()),
        "low-passed": sosfilt(low, samples),
        "noise at 20 dB": samples + 0.1 * noise,
        "noise at 10 dB": samples + 10**-0.5 * noise,
    }
