"""Claim: a contact that cannot be solved is refused with the key, its value and what is allowed.

Source: dynamics/scene_checks.py. Oracle: the sentences written out.
"""

from dataclasses import replace

import pytest

from dynamics.scene_checks import check_contact, check_rattling
from sonify import load_scene

COIN = load_scene("coin")
GRANITE = load_scene("granite")


@pytest.mark.parametrize(
    ("check", "scene", "change", "fault"),
    [
        (
            check_rattling,
            COIN,
            "numerics.contact=full",
            r"contact\.restitution = 0\.\d+: requires numerics\.contact = 'many'",
        ),
        (
            check_contact,
            GRANITE,
            "numerics.contact_rate=1000",
            r"numerics\.contact_rate = 1000: too low .* must be at least [\d.e+]+ 1/s",
        ),
        (
            check_contact,
            replace(GRANITE, roughness=None),
            "release.inclination_deg=1e-7",
            r"release\.inclination_deg = 1e-07: must exceed the final inclination",
        ),
    ],
)
def test_what_cannot_be_solved_is_refused_with_its_key(check, scene, change, fault):
    key, _, value = change.partition("=")
    with pytest.raises(ValueError, match=fault):
        check(changed(scene, key, value))


def changed(scene, key, value):
    """Return a scene with another value, which `replace` itself would refuse."""
    section, _, name = key.partition(".")
    part = getattr(scene, section)
    new = value if isinstance(getattr(part, name), str) else float(value)
    return replace(scene, **{section: replace(part, **{name: new})})
