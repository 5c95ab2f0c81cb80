"""Scenes: all input numbers of a run, validated from TOML into frozen dataclasses."""

import json
import tomllib
from collections.abc import Mapping
from copy import deepcopy
from dataclasses import asdict, dataclass, field
from functools import cache, cached_property
from math import hypot, inf, isfinite, radians, sin
from pathlib import Path
from typing import Annotated, Any, ClassVar, Literal

import numpy as np
from annotated_types import Ge, Gt, Le, Lt, MaxLen
from pydantic import ConfigDict, Field, TypeAdapter, ValidationError

from dynamics.air import Air, dry_air_density
from dynamics.disk import Disk
from dynamics.film.wedge import flat_radius
from dynamics.scene_constants import scene_constants
from dynamics.sections import MotionScene
from dynamics.surface import AnySurface, PlateSurface, Surface
from modal.materials import MATERIALS
from modal.modes import Material, Support
from sonify.runtime.json_values import json_safe
from sonify.runtime.toml_files import find_file, read_toml, shipped_names
from sonify.scene_errors import (
    ContradictionError,
    SceneError,
    error_sentence,
    is_contradiction,
    with_whole_numbers,
)
from sonify.suggestions import did_you_mean

SHIPPED_SCENES_FOLDER = Path(__file__).parent / "scenes"
KEYS_ALLOWED_INFINITE = ("friction.mu_static", "friction.mu_dynamic")
"""Keys that may be infinite: with infinite friction the contact never slips."""
FORMER_SCENE_NAMES = {"mirror-base": "toy"}
"""Former name of a shipped scene -> its name."""
SIZE_KEYS = {"thickness", "mass", "density"}
"""Keys of the disk, two of which determine the third."""

Distance = Annotated[float, Gt(0), Le(1000)]
Elevation = Annotated[float, Ge(0), Le(90)]


@dataclass(frozen=True, kw_only=True)
class ListenerPosition:
    """Position of one of several listeners, a microphone or a head."""

    kind: Literal["point", "head"] = "point"
    """Kind of listener: a point microphone, or a head with its ears as the left and the
    right channel."""
    distance: Distance
    """Distance from the centre of the disk [m] to the microphone or to the centre of
    the head; a microphone nearer than the radius must be above the disk and clear of
    its motion."""
    elevation_deg: Elevation = 45.0
    """Elevation above the table [degrees]."""
    azimuth_deg: Annotated[float, Ge(-360), Le(360)] = 0.0
    """Direction on the table, from its x axis to its y axis [degrees]."""
    head_radius: Annotated[float, Ge(0.03), Le(0.2)] = 0.0875
    """Radius of the head, a rigid sphere [m]."""
    facing_deg: Annotated[float, Ge(-180), Le(180)] = 0.0
    """Angle from the direction of the disk to that of the nose, positive to the left
    [degrees]."""
    ear_angle_deg: Annotated[float, Gt(0), Lt(180)] = 90.0
    """Angle of the ears from the nose, on both sides [degrees]."""

    def check_clearance(self, key: str, disk: Disk, inclination: float) -> None:
        """Raise ValueError if disk or table touch the listener.

        `inclination` [rad] is the greatest inclination of the disk."""
        elevation = radians(self.elevation_deg)
        if self.kind == "point":
            for name in ("head_radius", "facing_deg", "ear_angle_deg"):
                if getattr(self, name) != getattr(ListenerPosition, name):
                    raise ValueError(f"{key}.{name}: requires {key}.kind = 'head'")
            above = self.distance * sin(max(elevation - inclination, 0.0))
            if self.distance <= disk.radius and above <= disk.thickness / 2:
                raise ValueError(
                    f"{key}.distance = {self.distance:g}: must be greater than "
                    "disk.radius, or above the disk at its greatest inclination"
                )
            return
        least = disk.radius + self.head_radius
        if self.distance <= least:
            raise ValueError(
                f"{key}.distance = {self.distance:g}: must be greater than disk.radius "
                f"+ head_radius = {least:g}"
            )
        if self.distance * sin(elevation) < self.head_radius:
            raise ValueError(
                f"{key}.elevation_deg = {self.elevation_deg:g}: the head would touch "
                f"the table; its centre must be at least {self.head_radius:g} m above"
            )


@dataclass(frozen=True, kw_only=True)
class Audio:
    """The sound file and the listener: the section `audio` of a scene.

    Examples
    --------
    >>> from sonify import Audio
    >>> Audio(distance=1.0).single_listener.elevation_deg
    45.0
    """

    sample_rate: Annotated[int, Ge(8000), Le(768000)] = 48000
    """Samples per second [Hz]."""
    distance: Distance = 0.5
    """Distance of the listener from the centre of the disk [m]; a listener nearer than
    the radius must be above the disk and clear of its motion."""
    elevation_deg: Elevation = ListenerPosition.elevation_deg
    """Elevation of the listener above the table [degrees]."""
    listeners: Annotated[tuple[ListenerPosition, ...], MaxLen(16)] = ()
    """Several listeners that replace the single one, each with its own channel in the
    files and with the keys distance, elevation_deg and azimuth_deg; kind = "head" has
    two channels, its ears, and the keys head_radius, facing_deg and ear_angle_deg."""

    @property
    def single_listener(self) -> ListenerPosition:
        """The single listener of the section."""
        return ListenerPosition(
            distance=self.distance, elevation_deg=self.elevation_deg
        )


@dataclass(frozen=True, kw_only=True)
class Scene(MotionScene):
    """All inputs of a run, one section of the TOML file per field.

    Missing sections have default values. Units are SI unless a key ends in `_deg` or
    `_db`. A scene is created by `load_scene` and changed by `replace`.

    See Also
    --------
    load_scene : Load a shipped scene or a TOML file.

    Examples
    --------
    >>> from sonify import load_scene
    >>> scene = load_scene("published")
    >>> scene.name, scene.disk.radius, scene.audio.sample_rate
    ('published', 0.03755, 48000)
    """

    __pydantic_config__ = ConfigDict(extra="forbid", strict=True)

    name: Annotated[
        str,
        Field(
            pattern=r"^[A-Za-z0-9][A-Za-z0-9._-]*$",
            description="Name of the scene and of its default output folder.",
        ),
    ] = "scene"
    material: Material = field()
    """Elastic material of the disk."""
    support: Support = field(default_factory=Support)
    """Support of the disk in the computation of its modes."""
    surface: Annotated[AnySurface, Field(discriminator="kind")] = field(
        default_factory=Surface
    )
    """The table: rigid, a plate, an infinite plate, given modes or a mesh."""
    air: Air = field(default_factory=Air)
    """The air around the disk, and the treatment of the film below it."""
    audio: Audio = field(default_factory=Audio)
    """The sound file and the listener."""
    _document: ClassVar[dict[str, Any] | None] = None

    def __post_init__(self) -> None:
        inclination = radians(self.release.inclination_deg)
        self.audio.single_listener.check_clearance("audio", self.disk, inclination)
        for i, listener in enumerate(self.audio.listeners):
            listener.check_clearance(f"audio.listeners.{i}", self.disk, inclination)
        for key in ("arm_nutation", "arm_rolling", "arm_pivoting"):
            arm = vars(self.friction)[key]
            if arm != "contact" and arm > self.disk.radius:
                raise ValueError(
                    f"friction.{key} = {arm:g}: must not exceed disk.radius = {self.disk.radius:g}"
                )
        self.contact.check_fillet(self.disk)
        self.surface.check_disk_fits_bowl(self.disk.radius)
        self.surface.check_hole(flat_radius(self))
        scene_constants(self)
        grain = self.roughness is not None and self.roughness.grain
        if (
            self.contact.restitution is not None
            or grain
            or self.numerics.contact == "many"
        ):
            from dynamics.scene_checks import check_rattling

            check_rattling(self)
        if self.contact.law == "elastic":
            from dynamics.scene_checks import check_contact  # imports SciPy

            check_contact(self)
        elif self.roughness is not None:
            from dynamics.compliant.law.roughness import check_roughness

            check_roughness(self.roughness, self.disk.radius)
        plate = self.surface
        if isinstance(plate, PlateSurface):
            most = plate.radius - self.disk.radius
            if most < 0:
                raise ValueError(
                    f"surface.radius = {plate.radius:g}: must be at least disk.radius"
                )
            if hypot(*plate.place) + self.disk.radius > plate.radius:
                raise ValueError(
                    f"surface.place = {list(plate.place)}: must not be more than {most:g} m from the centre"
                )

    @property
    def document(self) -> dict[str, Any]:
        """Copy of the TOML document of this scene, a dict of nested plain values."""
        return deepcopy(self._document) if self._document else _document(asdict(self))

    @cached_property
    def elastic_edge(self) -> Any:
        """Elastic compliance [m/N] of the disk at its edge (`modal.Edge`); None for a
        shell."""
        if self.disk.shape != "solid":
            return None
        from modal import edge_flexibility
        from modal.solve import free_plate

        return edge_flexibility(free_plate(self))

    def replace(self, *assignments: str | Mapping[str, Any]) -> "Scene":
        """Return a copy of this scene with assignments applied in order.

        Parameters
        ----------
        *assignments : str or mapping of str to value
            Texts "section.key=value" with a value in TOML, or a bare word for a string;
            or mappings of key paths to values, as in {"disk.radius": 0.04}. The value
            None in a mapping removes the key, so that its default applies.

        Returns
        -------
        Scene
            The new scene.

        Raises
        ------
        SceneError
            If an assignment is malformed, or a key or value is not allowed.

        Examples
        --------
        >>> from sonify import load_scene
        >>> load_scene("published").replace("disk.radius=0.04").disk.radius
        0.04
        >>> load_scene("published").replace({"disk.radius": 0.04}).disk.radius
        0.04
        """
        document = self.document
        for assignment in assignments:
            for path, value in _values_by_path(assignment).items():
                _assign(document, path, value)
        return from_document(document)

    def diff(self, other: "Scene") -> dict[str, tuple[Any, Any]]:
        """Compare two scenes.

        Parameters
        ----------
        other : Scene
            The other scene.

        Returns
        -------
        dict of str to pair
            Path of each key that differs, as in `replace`, with its values in this
            scene and in `other`. The value of a missing key is None.

        Examples
        --------
        >>> from sonify import load_scene
        >>> scene = load_scene("published")
        >>> scene.diff(scene.replace("disk.radius=0.04"))
        {'disk.radius': (0.03755, 0.04)}
        """
        return differing_values(asdict(self), asdict(other))


@cache
def scene_adapter() -> TypeAdapter[Any]:
    """Return the pydantic adapter that validates a scene."""
    return TypeAdapter(Scene)


def from_document(document: dict[str, Any]) -> Scene:
    """Return the scene of a TOML document given as nested plain values.

    Raises SceneError if a key or value is invalid, or its subclass ContradictionError
    if valid values cannot be combined."""
    _refuse_non_finite(document)
    if {"restitution", "loss_factor"} <= _section(document, "contact").keys():
        raise ContradictionError(
            "contact.restitution: cannot be combined with loss_factor; give one of them"
        )
    complete = _with_density(document)
    table = _section(complete, "surface")
    if table and table.keys() <= {"sag", "diameter", "place", "hole"}:
        complete = complete | {"surface": {"kind": "rigid"} | table}
    try:
        scene = scene_adapter().validate_json(json.dumps(complete, default=str))
    except ValidationError as error:
        corrected = with_whole_numbers(document, error, Scene)
        if corrected is not None:
            return from_document(corrected)
        kind = ContradictionError if is_contradiction(error) else SceneError
        raise kind(error_sentence(error, Scene)) from None
    object.__setattr__(scene, "_document", deepcopy(document))
    return scene


def _with_density(document: dict[str, Any]) -> dict[str, Any]:
    """Return the document with the density of its named material, if the disk has only
    one of thickness, mass and density."""
    name = _section(document, "material").get("name")
    disk = _section(document, "disk")
    if not isinstance(name, str):
        return document
    if name not in MATERIALS:
        allowed = ", ".join(map(repr, MATERIALS))
        meant = did_you_mean(name, MATERIALS)
        raise SceneError(f"material.name = {name!r}: must be one of {allowed}{meant}")
    if len(disk.keys() & SIZE_KEYS) != 1 or "density" in disk:
        return document
    return document | {"disk": disk | {"density": MATERIALS[name].density}}


def load_scene(source: str | Path = "published") -> Scene:
    """Load a scene.

    Parameters
    ----------
    source : str or Path
        Name of a shipped scene, also a former one, or path of a TOML file or of the
        run.json of an earlier run.

    Returns
    -------
    Scene
        The validated scene.

    Raises
    ------
    SceneError
        If there is no such scene, if the file cannot be read or parsed, or if a key is
        unknown or missing, or its value is invalid.

    Examples
    --------
    >>> from sonify import load_scene
    >>> load_scene("published").disk.mass  # kg
    0.4387
    """
    named = source if Path(source).is_file() else present_scene_name(str(source))
    file = find_file(named, SHIPPED_SCENES_FOLDER, "scene", SceneError)
    document = read_toml(file, SceneError)
    if file.suffix == ".json":
        try:
            document = _scene_of_record(document)
        except (LookupError, TypeError, AttributeError):
            raise SceneError(
                f"{source}: not the run.json of a run: it contains no scene"
            ) from None
    return from_document(_with_mesh(document, file.parent))


def present_scene_name(name: str) -> str:
    """Return the name of the shipped scene that had a former name; any other name itself."""
    return FORMER_SCENE_NAMES.get(name, name)


def _with_mesh(document: dict[str, Any], folder: Path) -> dict[str, Any]:
    """Return the document with its mesh file as a path in `folder`, if the file exists
    there."""
    surface = _section(document, "surface")
    file = surface.get("file")
    if isinstance(file, str) and (folder / file).is_file():
        surface["file"] = str(folder / file)
    return document


def _section(document: dict[str, Any], name: str) -> dict[str, Any]:
    """Return a section of a document; empty if it is missing or not a section."""
    section = document.get(name)
    return section if isinstance(section, dict) else {}


def scene_with_accuracy(
    scene: Scene | str | Path, accuracy: str | None = None
) -> Scene:
    """Return a scene, or load it by name or path, and set `accuracy` if given."""
    scene = scene if isinstance(scene, Scene) else load_scene(scene)
    return scene.replace(f"numerics.accuracy={accuracy}") if accuracy else scene


def shipped_scenes() -> dict[str, str]:
    """List the shipped scenes.

    Returns
    -------
    dict of str to str
        Name of each scene, and the first comment line of its file.

    Examples
    --------
    >>> from sonify import shipped_scenes
    >>> "published" in shipped_scenes()
    True
    """
    summaries = {}
    for name in shipped_names(SHIPPED_SCENES_FOLDER):
        text = (SHIPPED_SCENES_FOLDER / f"{name}.toml").read_text("utf-8")
        summaries[name] = text.splitlines()[0].removeprefix("#").strip()
    return summaries


def _document(sections: Mapping[str, Any]) -> dict[str, Any]:
    """Return the document of a scene from its sections, without None and derived
    values."""
    document = _plain_value(sections)
    if "density" in document["disk"]:
        del document["disk"]["mass"]  # it follows from the density
    if "restitution" in document["contact"]:
        del document["contact"]["loss_factor"]  # it has no effect
    _remove_typical_values(document["disk"], document["material"])
    air = document.get("air", {})
    if "density" in air and air["density"] == dry_air_density(
        air["pressure"], air["temperature"]
    ):
        del air["density"]  # it follows from pressure and temperature
    return document


def _remove_typical_values(disk: dict[str, Any], material: dict[str, Any]) -> None:
    """Remove from the sections the values that the name of the material implies."""
    if "name" not in material:
        return
    typical = MATERIALS[material["name"]]
    for section, keys in (
        (material, ("young", "poisson", "loss_factor")),
        (disk, ("density",)),
    ):
        for key in keys:
            if section.get(key) == getattr(typical, key):
                del section[key]


def _scene_of_record(record: Any) -> dict[str, Any]:
    """Return the document of the scene in a run.json, which stores infinity as a
    string."""
    document = _document(record["scene"])
    for section, key in (path.split(".") for path in KEYS_ALLOWED_INFINITE):
        if document[section][key] == "inf":
            document[section][key] = inf
    return document


def scene_record(scene: Scene) -> dict[str, Any]:
    """Return all keys of a scene, as run.json contains them; the file name of a mesh has
    no folder."""
    record: dict[str, Any] = json_safe(asdict(scene))
    if scene.surface.kind == "mesh":
        record["surface"]["file"] = Path(scene.surface.file).name
    return record


def differing_values(
    one: dict[str, Any], other: dict[str, Any]
) -> dict[str, tuple[Any, Any]]:
    """Return the values that differ between two nested documents, by key path."""
    here = _flat_keys(one)
    there = _flat_keys(other)
    return {
        key: (here.get(key), there.get(key))
        for key in here | there
        if here.get(key) != there.get(key)
    }


def _flat_keys(section: dict[str, Any], path: str = "") -> dict[str, Any]:
    """Return the values of nested sections by their key paths."""
    flat: dict[str, Any] = {}
    for key, value in section.items():
        if isinstance(value, dict):
            flat |= _flat_keys(value, f"{path}{key}.")
        else:
            flat[path + key] = value
    return flat


def _plain_value(value: Any) -> Any:
    """Return a value with tuples converted to lists and sections without None
    values."""
    if isinstance(value, tuple):
        return list(map(_plain_value, value))
    if isinstance(value, dict):
        return {
            key: _plain_value(item) for key, item in value.items() if item is not None
        }
    return value


def _values_by_path(assignment: str | Mapping[str, Any]) -> dict[str, Any]:
    """Return the values of a text `section.key=value` or of a mapping, by key path."""
    if isinstance(assignment, Mapping):
        return {
            _checked_path(path, assignment): _value_from_python(path, value)
            for path, value in assignment.items()
        }
    if not isinstance(assignment, str):
        raise SceneError(
            f'{assignment!r}: expected "section.key=value" or '
            'a mapping such as {"section.key": value}'
        )
    path, equals, text = assignment.partition("=")
    path = _checked_path(path.strip() if equals else "", assignment)
    return {path: _parsed_value(path, text.strip())}


def _checked_path(path: Any, assignment: Any) -> str:
    """Return a key path. Raises SceneError if it is not text, or a part is empty."""
    if not isinstance(path, str) or not all(path.split(".")):
        raise SceneError(f"{assignment!r}: expected section.key=value")
    return path


def _value_from_python(path: str, value: Any) -> Any:
    """Return a value as in a TOML document; raises SceneError for other types."""
    if isinstance(value, np.generic | np.ndarray):
        return value.tolist()
    if isinstance(value, list | tuple):
        return [_value_from_python(path, item) for item in value]
    if isinstance(value, Mapping):
        return {
            key: _value_from_python(f"{path}.{key}", item)
            for key, item in value.items()
        }
    if value is None or isinstance(value, str | bool | int | float):
        return value
    raise SceneError(
        f"{path} = {value!r}: must be a number, a text, a list or a mapping"
    )


def _assign(document: dict[str, Any], path: str, value: Any) -> None:
    """Set the value at a key path of a document, or remove the key if it is None."""
    *sections, key = path.split(".")
    for section in sections:
        document = document.setdefault(section, {})
        if not isinstance(document, dict):
            raise SceneError(f"{path}: {section} is a value, not a section")
    if value is None:
        document.pop(key, None)
    else:
        document[key] = value


def _parsed_value(path: str, text: str) -> Any:
    """Return the value of a TOML text, or the text itself if it is a bare word."""
    try:
        value, *more = tomllib.loads(f"value = {text}").values()
    except (ValueError, RecursionError) as error:
        if (number := _number(text)) is not None:
            raise SceneError(
                f"{path} = {text}: in TOML this number is written {number!r}"
            ) from None
        if "\n" in text or text[:1] in {"'", '"', "[", "{"}:
            raise SceneError(f"{path} = {text!r}: invalid TOML: {error}") from None
        return text
    if more:
        raise SceneError(f"{path} = {text!r}: must be a single value on one line")
    return value


def _number(text: str) -> Any:
    try:
        return float(text)
    except ValueError:
        return None


def _refuse_non_finite(value: Any, path: str = "") -> None:
    if isinstance(value, dict):
        for key, item in value.items():
            _refuse_non_finite(item, f"{path}.{key}" if path else key)
    elif isinstance(value, list):
        for item in value:
            _refuse_non_finite(item, path)
    elif (
        isinstance(value, float)
        and not isfinite(value)
        and not (path in KEYS_ALLOWED_INFINITE and value > 0)
    ):
        raise SceneError(f"{path} = {value}: must be finite")
