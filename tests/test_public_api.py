"""Claim: the public names and signatures of the three packages change only on purpose, and results
can be read by name.

Source: the compatibility promise to user scripts. Oracle: `tests/references/public_api.json`,
written by `python tests/test_public_api.py`; for named access, the underlying arrays.
"""

import importlib
import inspect
import json
import re
from enum import Enum

import numpy as np
import pytest
from paths import REFERENCES

from dynamics import Outcome, simulate
from dynamics.motion import COLUMNS, FORCE_COLUMNS
from sonify import load_scene
from sonify.claims.finding import Finding, Findings

STORED = REFERENCES / "public_api.json"
PACKAGES = ("dynamics", "modal", "sonify")


def public_api() -> dict[str, str]:
    """Return the signature of every exported name, including its fields and public methods."""
    found = {}
    for package in PACKAGES:
        module = importlib.import_module(package)
        for name in sorted(module.__all__):
            thing = getattr(module, name)
            found[f"{package}.{name}"] = signature_of(thing)
            if inspect.isclass(thing):
                for own, member in sorted(members_of(thing).items()):
                    if own[0] != "_" and callable(member):
                        found[f"{package}.{name}.{own}"] = signature_of(member)
    return found


def members_of(kind: type) -> dict[str, object]:
    """Return the members of a class, with those inherited within its module."""
    bases = [base for base in kind.__mro__ if base.__module__ == kind.__module__]
    return {name: own for base in bases[::-1] for name, own in vars(base).items()}


def signature_of(thing) -> str:
    """Return the parameter names, with "=" for a default; empty for enumerations and exceptions."""
    if inspect.isclass(thing) and issubclass(thing, (Enum, Exception)):
        return ""
    try:
        parameters = inspect.signature(thing).parameters.values()
    except (TypeError, ValueError):
        return ""
    return ", ".join(
        re.sub(
            "[:=].*", "", str(parameter.replace(annotation=inspect.Parameter.empty))
        ).strip()
        + ("=" if parameter.default is not inspect.Parameter.empty else "")
        for parameter in parameters
    )


def test_the_public_names_and_signatures_are_those_stored():
    assert public_api() == json.loads(STORED.read_text("utf-8"))


@pytest.fixture(scope="module")
def motion():
    return simulate(load_scene("published").replace("numerics.accuracy=draft"))


@pytest.mark.parametrize("name", ["inclination", "precession", "spin"])
def test_an_angle_by_name_is_its_column(motion, name):
    t = [0.0, 1.0, motion.t[-1]]
    assert np.array_equal(
        getattr(motion, name)(t), motion.at(t)[:, COLUMNS.index(name)]
    )


def test_a_motion_is_a_data_frame_with_named_columns(motion):
    pytest.importorskip("pandas", reason="the data frame is one of pandas")
    frame = motion.to_frame([0.0, 1.0])
    assert list(frame.columns) == [*COLUMNS, *FORCE_COLUMNS]
    assert frame.index.tolist() == [0.0, 1.0]
    assert np.array_equal(frame[list(FORCE_COLUMNS)], motion.force([0.0, 1.0]))
    assert len(motion.to_frame()) == len(motion.t)
    with pytest.raises(ValueError, match="within the motion"):
        motion.to_frame([1e9])


def test_findings_are_read_by_place_and_by_key():
    first, second = (
        Finding(key=key, claim=key, value=1.0, unit="s", source="here")
        for key in ("one", "two")
    )
    findings = Findings([first, second])
    assert findings["two"] is findings[1] is second
    assert findings[:1] == [first]
    with pytest.raises(KeyError, match="did you mean two"):
        findings["twoo"]


def test_scenes_tell_in_which_keys_they_differ():
    scene = load_scene("published")
    other = scene.replace("friction.mu_static=0.4", "roughness.rms=1e-7")
    assert scene.diff(scene) == {}
    assert scene.diff(other)["friction.mu_static"] == (scene.friction.mu_static, 0.4)
    assert other.diff(scene)["roughness.rms"] == (1e-7, None)


if __name__ == "__main__":
    STORED.write_text(
        json.dumps(public_api(), indent=1, sort_keys=True) + "\n", encoding="utf-8"
    )


def test_the_former_name_of_an_outcome_is_an_alias():
    assert Outcome.TIME_LIMIT is Outcome.ROLLING_ON
    assert Outcome["TIME_LIMIT"].name == "ROLLING_ON"
    assert [outcome.name for outcome in Outcome].count("TIME_LIMIT") == 0
