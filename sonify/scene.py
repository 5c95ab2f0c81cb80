"""A scene: every number that a run depends on, read strictly from TOML into frozen dataclasses."""

import json
import tomllib
from copy import deepcopy
from dataclasses import asdict, dataclass, field
from importlib import resources
from math import isfinite
from pathlib import Path
from typing import Annotated, Literal

from annotated_types import Ge, Gt, Le
from pydantic import ConfigDict, Field, TypeAdapter, ValidationError

from dynamics.disk import Disk, Friction, Release
from dynamics.dissipation import Dissipation
from modal.modes import Material, Support
from sonify.scene_errors import SceneError, explain

MAY_BE_INFINITE = {"friction.mu_static", "friction.mu_dynamic"}
"""Infinite friction is physics: the contact never slips. Nothing else in a scene may be infinite."""


@dataclass(frozen=True, kw_only=True)
class Surface:
    """What the disk stands on: `rigid` neither moves nor sounds."""

    kind: Literal["rigid"] = "rigid"


@dataclass(frozen=True, kw_only=True)
class Audio:
    """Samples per second, and the listener: distance [m] from the disk's centre, elevation above the table."""

    sample_rate: Annotated[int, Ge(8000), Le(768000)] = 48000
    distance: Annotated[float, Gt(0), Le(1000)] = 0.5
    elevation_deg: Annotated[float, Ge(0), Le(90)] = 45.0


@dataclass(frozen=True, kw_only=True)
class Numerics:
    """How exactly to solve; None leaves the choice to `accuracy`.

    `tolerance` is the integrator's relative one, at most the slip speed at which a slide counts as at rest;
    `final_inclination` [rad] is where the motion counts as settled; `time_limit` [s] ends one that does not settle.
    """

    accuracy: Literal["draft", "standard", "reference"] = "standard"
    integrator: Literal["auto", "taylor", "dop853"] = "auto"
    tolerance: Annotated[float, Gt(0), Le(1e-9)] | None = None
    final_inclination: Annotated[float, Gt(0), Le(0.1)] | None = None
    time_limit: Annotated[float, Gt(0)] = 600.0


@dataclass(frozen=True, kw_only=True)
class Scene:
    """Everything a run depends on. A section that is not given has its defaults; SI units unless a key says `_deg`."""

    __pydantic_config__ = ConfigDict(extra="forbid", strict=True)

    name: Annotated[str, Field(pattern=r"^[A-Za-z0-9][A-Za-z0-9._-]*$")] = "scene"
    disk: Disk
    material: Material
    friction: Friction
    release: Release
    support: Support = field(default_factory=Support)
    surface: Surface = field(default_factory=Surface)
    dissipation: Dissipation = field(default_factory=Dissipation)
    audio: Audio = field(default_factory=Audio)
    numerics: Numerics = field(default_factory=Numerics)

    def __post_init__(self):
        if self.audio.distance <= self.disk.radius:
            raise ValueError(f"audio.distance = {self.audio.distance:g}: must be greater than disk.radius")

    @property
    def document(self) -> dict:
        """The TOML document that this scene came from, or would come from, as nested plain values (a copy)."""
        return deepcopy(self._document) if hasattr(self, "_document") else _document(self)

    def replace(self, *assignments: str) -> "Scene":
        """Return this scene with `section.key=value` applied in turn; values are TOML, a bare word is a string.

        Raises SceneError as `load_scene` does. Shown by tests/test_scene.py.
        """
        document = self.document
        for assignment in assignments:
            _assign(document, assignment)
        return from_document(document)


def from_document(document: dict) -> Scene:
    """Return the scene of a TOML document given as nested plain values. Raises SceneError."""
    _refuse_non_finite(document)
    try:
        scene = TypeAdapter(Scene).validate_json(json.dumps(document, default=str))
    except ValidationError as error:
        raise SceneError(explain(error, Scene)) from None
    object.__setattr__(scene, "_document", deepcopy(document))
    return scene


def load_scene(source: str | Path = "published") -> Scene:
    """Return the scene of a shipped name or of a TOML file.

    Raises SceneError if there is no such scene, if the file cannot be read or is not TOML, and if a key is unknown or
    missing or has a value that is not allowed.
    """
    try:
        text = _find(source).read_text(encoding="utf-8")
        return from_document(tomllib.loads(text))
    except OSError as error:
        raise SceneError(f"{source}: cannot be read: {error.strerror}") from None
    except (UnicodeDecodeError, tomllib.TOMLDecodeError) as error:
        raise SceneError(f"{source}: not TOML: {error}") from None


def shipped_scenes() -> dict[str, str]:
    """Name and first comment line of every scene that comes with the program."""
    files = sorted(_shipped().iterdir(), key=lambda file: file.name)
    return {f.name.removesuffix(".toml"): _summary(f.read_text("utf-8")) for f in files if f.name.endswith(".toml")}


def _summary(text: str) -> str:
    return text.splitlines()[0].removeprefix("#").strip()


def _shipped():
    return resources.files("sonify") / "scenes"


def _document(scene):
    """The document of a scene that was not read from one: every key that has a value."""
    document = _given(asdict(scene))
    if scene.disk.density is not None:
        del document["disk"]["mass"]  # it follows from the density
    return document


def _given(section):
    """A section without the keys that are None, tuples as lists."""
    plain = {key: list(value) if isinstance(value, tuple) else value for key, value in section.items()}
    return {key: _given(v) if isinstance(v, dict) else v for key, v in plain.items() if v is not None}


def _find(source):
    shipped = _shipped() / f"{source}.toml"
    if str(source).replace("-", "").replace("_", "").isalnum() and not Path(source).is_file():
        if not shipped.is_file():
            raise SceneError(f"{source}: no such scene; shipped: {', '.join(shipped_scenes())}; or give a TOML file")
        return shipped
    return Path(source)


def _assign(document, assignment):
    path, equals, text = assignment.partition("=")
    *sections, key = path.strip().split(".")
    if not equals or not all([*sections, key]):
        raise SceneError(f"{assignment!r}: expected section.key=value")
    for section in sections:
        document = document.setdefault(section, {})
        if not isinstance(document, dict):
            raise SceneError(f"{path.strip()}: {section} is a value, not a section")
    document[key] = _value(text.strip())


def _value(text):
    try:
        return tomllib.loads(f"value = {text}")["value"]
    except tomllib.TOMLDecodeError:
        return text


def _refuse_non_finite(value, path=""):
    if isinstance(value, dict):
        for key, item in value.items():
            _refuse_non_finite(item, f"{path}.{key}" if path else key)
    elif isinstance(value, list):
        for item in value:
            _refuse_non_finite(item, path)
    elif isinstance(value, float) and not isfinite(value) and not (path in MAY_BE_INFINITE and value > 0):
        raise SceneError(f"{path} = {value}: must be finite")
