"""Claim: the sound of an infinite plate follows its closed form, and a large plate with strong
damping tends to it.

Source: Cremer, Heckl & Petersson, Structure-Borne Sound, section 6.5. Oracle: the sum over the
modes of a finite plate with Rayleigh's integral, which does not use wavenumbers; the formula itself
at single frequencies; superposition of arrivals.
"""

from types import SimpleNamespace

import numpy as np
import pytest

from dynamics import InfiniteSurface, PlateSurface
from modal import surface_modes
from sonify import load_scene
from sonify.sound.force import ContactForce
from sonify.sound.radiation import Listener
from sonify.sound.sources.infinite_plate import (
    InfiniteTable,
    bending_stiffness,
    coincidence_frequency,
    pressure_per_force,
)
from sonify.sound.sources.tabletop import table_radiation

GLASS = {"young": 70e9, "poisson": 0.22, "density": 2500.0}
LOSS = 0.6
"""Loss factor of the finite plate, applied to its inertia; in the stiffness it would
let modes far above the frequency contribute."""
ENDLESS = InfiniteSurface(thickness=0.003, **GLASS)


@pytest.fixture(scope="module")
def plate():
    """Return a plate of 50 cm radius.

    At 2 kHz its waves fall by exp(eta k R/4) = 48 on the way to the edge, which radiates well.
    """
    scene = SimpleNamespace(
        disk=None,
        surface=PlateSurface(radius=0.5, thickness=0.003, edge="supported", **GLASS),
    )
    scene.numerics = SimpleNamespace(accuracy="draft")
    return surface_modes(scene, 3500.0)


def response(plate, frequency):
    """Return the velocity at the centre and the acceleration of every mode under a force of 1 N
    there."""
    w = 2 * np.pi * frequency
    own = 2 * np.pi * plate.frequency
    shape = plate.at(np.zeros(1), np.zeros(1))[0]
    moved = shape / (own**2 - w**2 * (1 - 1j * LOSS))
    return 1j * w * (shape @ moved), -(w**2) * moved


@pytest.mark.slow
@pytest.mark.parametrize("elevation", [20.0, 45.0])
@pytest.mark.parametrize("frequency", [1250.0, 1750.0, 2250.0])
def test_a_large_damped_plate_tends_to_the_endless_one(plate, frequency, elevation):
    """Mobility and sound agree within 1 dB; the loss makes m'' complex in both.

    Coincidence in the plane is at 4 kHz.
    """
    lossy = 1 - 1j * LOSS
    velocity, acceleration = response(plate, frequency)
    mass_per_area = ENDLESS.density * ENDLESS.thickness
    mobility = 1 / (8 * np.sqrt(bending_stiffness(ENDLESS) * mass_per_area * lossy))
    assert 20 * np.log10(velocity.real / mobility.real) == pytest.approx(0, abs=1.0)
    listener = Listener(distance=30.0, elevation=np.radians(elevation))
    heard = abs(table_radiation(plate, listener, [frequency])[0] @ acceleration)
    closed = pressure_per_force(ENDLESS, listener) / abs(
        lossy - (frequency / coincidence_frequency(ENDLESS, listener)) ** 2
    )
    assert 20 * np.log10(heard / closed) == pytest.approx(0, abs=1.0)


def test_power_far_below_coincidence_adds_up():
    """The integral of p^2/(rho c) of a monopole over the half space is rho F^2/(2 pi c m''^2)."""
    listener = Listener(distance=2.0, elevation=np.pi / 2)
    air = listener.air
    mass = ENDLESS.density * ENDLESS.thickness
    power = (
        2
        * np.pi
        * 2.0**2
        * pressure_per_force(ENDLESS, listener) ** 2
        / (air.density * air.sound_speed)
    )
    assert power == pytest.approx(air.density / (2 * np.pi * air.sound_speed * mass**2))


def source(listener):
    text = "surface={kind='infinite', thickness=0.01, young=70e9, poisson=0.22, density=2500.0, loss_factor=0.1}"
    scene = load_scene("published").replace(text)
    return InfiniteTable(scene, listener), scene.disk.weight


def pressure(table, normal, ahead, blocks=1):
    """Return the pressure of normal forces (k + 1,) that arrive `ahead` (k + 1,) samples early."""
    first = np.array([normal[0], ahead[0]])
    out = []
    advance = table.make_block_renderer(first, lambda *noted: None)
    for part in np.array_split(np.arange(len(normal) - 1), blocks):
        n = np.append(part, part[-1] + 1)
        smooth = np.column_stack([normal[n], ahead[n]])
        force = ContactForce.without_jumps(n / 48000, smooth, 0 * smooth)
        out.append(advance(force)[:, 0])
    return np.concatenate(out)


@pytest.mark.parametrize("frequency", [200.0, 2000.0, 6000.0])
def test_a_swinging_force_sounds_as_the_formula_says(frequency):
    listener = Listener(distance=0.5, elevation=np.radians(45))
    table, weight = source(listener)
    t = np.arange(48001) / 48000
    heard = pressure(table, weight + np.sin(2 * np.pi * frequency * t), 0 * t, blocks=7)
    level = np.sqrt(2 * np.mean(heard[24000:] ** 2))
    at = frequency / coincidence_frequency(table._scene.surface, listener)
    assert level == pytest.approx(
        pressure_per_force(table._scene.surface, listener)
        / abs(1 - at**2 * (1 + 0.1j)),
        rel=0.02,
    )


def test_a_constant_force_is_heard_only_where_it_moves():
    """A force that moves in a circle radiates p = -rho F/(2 pi r m'') d(arrival)/d(sending).

    The result is to first order and without its mean.
    """
    listener = Listener(distance=0.5, elevation=np.radians(45))
    table, weight = source(listener)
    t = np.arange(9601) / 48000
    assert np.abs(pressure(table, weight + 0 * t, 0 * t)).max() < 1e-12
    rate = 2 * np.pi * 40.0
    most = 3.0  # samples
    heard = pressure(table, weight + 0 * t, most * np.sin(rate * t))
    expected = (
        pressure_per_force(table._scene.surface, listener)
        * weight
        * most
        * rate
        / 48000
    )
    assert np.abs(heard[2400:-2400]).max() == pytest.approx(expected, rel=0.05)
