"""Claim: in the flat limit, a disk with contact anywhere on its rim hops, rattles and comes to rest
as closed forms and an earlier prototype predict.

Source: tests/helpers/flat_rattle.py, a reference for models with several contacts. Oracle: the
normal force on a wavy table, the time of flight of the rim, the exponent (2 - H)/(4 - H) of the
rate, and numbers of the prototype.
"""

import numpy as np
import pytest
from flat_rattle import (
    FlatCase,
    FreeModes,
    flat_disk,
    rolling_start,
    simulate_flat,
)
from rim_unevenness import contact_depth, random_amplitudes, rim_heights

RADIUS = 12.875e-3


def coin(restitution, modulus=40e9):
    return flat_disk(RADIUS, 2.2e-3, 8.5e-3, modulus, 0.5e-3, restitution)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("ratio", "open_share", "tolerance"),
    [(1, 0.01, 0.01), (2, 0.09, 0.03), (5, 0.34, 0.04), (20, 0.62, 0.05)],
)
def test_share_of_time_without_contact_grows_with_the_unevenness(
    ratio, open_share, tolerance
):
    disk = coin(0.5)
    depth = contact_depth(disk.mass * 9.81, disk.modulus, RADIUS, disk.fillet, 0.1)
    heights = rim_heights(random_amplitudes(ratio * depth, 0.0, 300, seed=0), 4096)
    start = rolling_start(disk, 0.105)
    start[0] += heights[0]
    motion = simulate_flat(FlatCase(disk, heights), start, 0.25, 1e-6, 10, last=0.095)
    assert motion.open_time[-1] / motion.t[-1] == pytest.approx(
        open_share, abs=tolerance
    )


def test_hop_of_a_kicked_rim_lasts_as_long_as_a_free_flight():
    disk = coin(0.5)
    start = rolling_start(disk, 0.03)
    start[0] = RADIUS * 0.03
    start[3] = 0.01 * disk.gyration / (1 + disk.gyration)
    start[4] = 0.01 / (1 + disk.gyration)
    motion = simulate_flat(FlatCase(disk, np.zeros(8192)), start, 0.0006, 1e-7, 1)
    landing = motion.t[np.argmax((motion.force > 0) & (motion.t > 1e-5))]
    assert landing == pytest.approx(0.410e-3, rel=0.01)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("restitution", "k"), [(0.1, 0.83), (0.37, 0.785), (0.523, 0.68), (0.793, 0.44)]
)
def test_impacts_lower_the_inclination_at_a_constant_rate(restitution, k):
    disk = coin(restitution)
    rates = []
    for seed in range(4):
        heights = rim_heights(random_amplitudes(3e-6, 0.0, 300, seed), 4096)
        start = rolling_start(disk, 0.2)
        start[0] += heights[0]
        motion = simulate_flat(
            FlatCase(disk, heights), start, 3.0, 1e-6, 100, last=0.006
        )
        inclination = motion.inclination(RADIUS)
        late = inclination < 0.18
        fall = -np.polyfit(motion.t[late], inclination[late], 1)[0]
        rates.append(fall * RADIUS / np.sqrt(9.81 * 3e-6))
    assert np.mean(rates) == pytest.approx(k, rel=0.08)


@pytest.mark.slow
def test_free_modes_delay_the_end_of_a_rattling_coin():
    mass = 8.5e-3
    modes = FreeModes(
        order=np.array([2.0, 0.0]),
        frequency=2 * np.pi * np.array([10587.0, 17790.0]),
        decay=np.array([5.0, 17.0]),
        shape=1 / np.sqrt(np.array([0.191, 0.475]) * mass),
    )
    disk = coin(0.5)
    ends = []
    hits = []
    for seed in range(1, 5):
        heights = rim_heights(random_amplitudes(1e-6, 0.0, 300, seed), 4096)
        start = rolling_start(disk, 0.12)
        start[0] += heights[0]
        motion = simulate_flat(
            FlatCase(disk, heights, modes), start, 1.2, 1e-6, 100, last=0.01
        )
        ends.append(motion.t[-1])
        hits.append(motion.hits[-1] / motion.t[-1])
    assert np.mean(ends) == pytest.approx(0.730, rel=0.05)
    assert np.mean(hits) == pytest.approx(2130, rel=0.08)


def test_a_lossless_contact_keeps_the_energy():
    disk = coin(0.9999999999)
    heights = rim_heights(random_amplitudes(1e-6, 0.0, 300, 1), 4096)
    start = rolling_start(disk, 0.1)
    start[0] += heights[0]
    motion = simulate_flat(FlatCase(disk, heights), start, 0.05, 5e-7, 1)
    z, _, _, fall, rate_x, rate_y = motion.state.T
    kinetic = 0.5 * disk.mass * (fall**2 + disk.gyration * (rate_x**2 + rate_y**2))
    energy = kinetic + disk.mass * 9.81 * z + motion.stored
    assert np.abs(energy / energy[0] - 1).max() < 1e-6


@pytest.mark.slow
@pytest.mark.parametrize("order", [5, 8, 16])
def test_waves_first_break_the_contact_near_the_rigid_bound(order):
    disk = coin(0.5)
    inclination = 0.03 if order == 16 else 0.02
    angle = 2 * np.pi * np.arange(8192) / 8192
    opened = []
    for ratio in (1.0, 1.1):
        amplitude = inclination * RADIUS / ((order**2 - 1) * ratio)
        start = rolling_start(disk, inclination)
        start[0] += amplitude
        heights = amplitude * np.cos(order * angle)
        motion = simulate_flat(FlatCase(disk, heights), start, 0.2, 1e-6, 10)
        half = len(motion.t) // 2
        opened.append(motion.open_time[-1] - motion.open_time[half])
    assert opened[0] > 0
    assert opened[1] == 0


def test_force_on_crest_and_in_valley_of_a_smooth_wave():
    disk = coin(0.5)
    amplitude = 3.2513e-6
    heights = amplitude * np.cos(10 * 2 * np.pi * np.arange(8192) / 8192)
    start = rolling_start(disk, 0.05)
    start[0] += amplitude
    motion = simulate_flat(FlatCase(disk, heights), start, 0.12, 1e-6, 1)
    settled = motion.force[len(motion.t) * 2 // 3 :] / (disk.mass * 9.81)
    assert settled.min() == pytest.approx(0.734, rel=0.01)
    assert settled.max() == pytest.approx(1.798, rel=0.01)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("slope", "rms", "exponent"),
    [(0.0, 3e-6, 0.50), (0.5, 3e-6, 0.43), (1.0, 10e-6, 0.32)],
)
def test_exponent_of_the_rate_follows_from_the_slope(slope, rms, exponent):
    """The exponents of single draws scatter by 0.03; the mean of twelve is 0.499 for a slope of 0."""
    disk = coin(0.5)
    exponents = []
    for seed in range(1, 7):
        heights = rim_heights(random_amplitudes(rms, slope, 300, seed), 4096)
        start = rolling_start(disk, 0.2)
        start[0] += heights[0]
        motion = simulate_flat(
            FlatCase(disk, heights), start, 3.0, 1e-6, 100, last=0.006
        )
        inclination = motion.inclination(RADIUS)
        late = inclination < 0.18
        t = motion.t[late][::20]
        logarithm = np.log(inclination[late][::20])
        fits = []
        for end in motion.t[-1] + np.geomspace(1e-4, 0.3, 200):
            line, rest, *_ = np.polyfit(np.log(end - t), logarithm, 1, full=True)
            fits.append((rest[0], line[0] / 2))
        exponents.append(min(fits)[1])
    assert np.mean(exponents) == pytest.approx(exponent, abs=0.03)
