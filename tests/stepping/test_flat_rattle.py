"""Claim: the flat limit of a disk with contact anywhere on its rim has the closed forms of a hop, of
the force on a wavy table and of a lossless motion, and loses its inclination at a constant rate.

Source: tests/helpers/flat_rattle.py, an independent program for the flat limit, whose numbers
test_rattling_disk.py expects of the program. Oracle: the normal force on a wavy table, the time of
flight of the rim, the balance of energy.
"""

import numpy as np
import pytest
from flat_rattle import (
    FlatCase,
    flat_disk,
    rolling_start,
    simulate_flat,
)
from rim_unevenness import random_amplitudes, rim_heights

RADIUS = 12.875e-3


def coin(restitution, modulus=40e9):
    return flat_disk(RADIUS, 2.2e-3, 8.5e-3, modulus, 0.5e-3, restitution)


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
