"""Claim: the picture of the modes shows one drawing per mode, labelled with its frequency."""

from types import SimpleNamespace

import matplotlib.image
import pytest

from modal import Material, Plate, draw_modes, plate_modes
from modal.pictures import caption

STEEL = Material(young=195e9, poisson=0.28, loss_factor=3e-4)


@pytest.fixture(scope="module")
def modes():
    return plate_modes(Plate(radius=0.03755, thickness=0.0128, material=STEEL, density=7737.27), 20e3)


def test_the_picture_has_ink_in_every_panel(modes, tmp_path):
    draw_modes(modes, tmp_path / "modes.png")
    image = matplotlib.image.imread(tmp_path / "modes.png")[..., :3]
    height, width = image.shape[:2]
    for column in range(len(modes)):
        panel = image[height // 4 :, column * width // 5 : (column + 1) * width // 5]
        assert (panel.std(axis=2) > 0.05).mean() > 0.1, "no colour in a panel"
    assert (image[:, -width // 5 :].std(axis=2) > 0.05).mean() < 0.01, "colour where there is no mode"


def test_captions_say_what_a_mode_is(modes):
    assert caption(modes, 0) == "1: 10603 Hz, T60 0.69 s\nflexural, even, order 2"
    silent = SimpleNamespace(frequency=modes.frequency, decay_rate=0 * modes.decay_rate, decay_time=modes.decay_time)
    vars(silent).update(parity=modes.parity, partner=modes.partner, family=modes.family, order=modes.order)
    assert "T60" not in caption(silent, 0)
