"""Definition of a sweep, read from TOML and validated."""

import json
from collections import defaultdict
from collections.abc import Iterable
from copy import deepcopy
from dataclasses import asdict, dataclass, field
from functools import cached_property
from hashlib import sha256
from pathlib import Path
from typing import Annotated, Any, Literal

from annotated_types import Gt, Le
from pydantic import ConfigDict, Field, TypeAdapter, ValidationError

from sonify.plan.motion import planned_scene
from sonify.plan.unused import unused_keys
from sonify.runtime.toml_files import find_file, read_toml, shipped_names
from sonify.scene import from_document, load_scene, scene_with_accuracy
from sonify.scene_errors import (
    ContradictionError,
    InputError,
    SceneError,
    error_sentence,
)
from sonify.sweeps.axes import Axis, Points, Samples, points_of
from sonify.sweeps.required_stages import stages_for

SHIPPED_SWEEPS_FOLDER = Path(__file__).parent / "shipped"


@dataclass(frozen=True, kw_only=True)
class Sweep:
    """Contents of a sweep file."""

    __pydantic_config__ = ConfigDict(extra="forbid", strict=True)

    name: Annotated[str, Field(pattern=r"^[A-Za-z0-9][A-Za-z0-9._-]*$")]
    """Name of the sweep and of its output folder."""
    scene: str = "published"
    """Scene common to all runs, as a shipped name or a path relative to the sweep
    file."""
    accuracy: Literal["draft", "standard", "reference"] | None = None
    """Accuracy level; overrides the level of the scene."""
    set: tuple[str, ...] = ()
    """Assignments that replace values of the scene, as with `run --set`."""
    axes: dict[str, Any]
    """Varied scene keys, each with a list of values or {from, to, n, scale}."""
    samples: Samples | None = None
    """Settings for sampled points; None for a grid."""
    find: tuple[str, ...] = ()
    """Names of the requested stages, scalars, findings and checks; all quantities if
    empty."""
    keep: tuple[Literal["arrays", "wav", "page"], ...] = ()
    """Kinds of output files that are kept for each run."""
    sources: dict[str, str] = field(default_factory=dict)
    """Source of the range of each axis; a text with the word "assumed" or "unknown", and a
    missing one, marks a range that is at least partly assumed."""
    limit: Annotated[float, Gt(0), Le(1e6)] = 600.0
    """Time limit of a run [s]."""
    folder = Path()

    @cached_property
    def document(self) -> dict[str, Any]:
        """Document of the scene common to all runs."""
        near = self.folder / self.scene
        scene = load_scene(near if near.is_file() else self.scene).replace(*self.set)
        return scene_with_accuracy(scene, self.accuracy).document

    @cached_property
    def points(self) -> Points:
        """Values of the axes in each run."""
        return points_of(self.axes, self.samples)

    @cached_property
    def stages(self) -> tuple[str, ...]:
        """Stages that every run solves."""
        return stages_for(self.find, self.keep)

    @property
    def identity(self) -> dict[str, Any]:
        """Plain values that identify the sweep; sweeps with equal identity can share a
        table."""
        content = {
            "scene": with_hashed_mesh(self.document),
            "axes": self.axes,
            "samples": asdict(self.samples) if self.samples else None,
            "stages": self.stages,
            "keep": sorted(self.keep),
        }
        return json.loads(json.dumps(content, default=str))

    @property
    def assumed_axes(self) -> list[str]:
        """Names of the axes whose range is at least partly assumed."""
        return [name for name in self.axes if is_assumed(self.sources.get(name, ""))]

    def source_of(self, axis: Axis) -> str:
        """Return the source of the range of an axis, or "assumed"."""
        return self.sources.get(", ".join(axis.keys)) or "assumed"

    def scene_of(self, run: int) -> dict[str, Any]:
        """Return the scene document of a run."""
        return with_values(self.document, self.points[run])

    def columns(self, run: int) -> dict[str, Any]:
        """Return the values of the axes in a run in the form in which the table stores
        them.

        Each column has one type; mixed types, lists and tables are stored as JSON.
        """
        return {
            key: json.dumps(value) if key in self._json_columns else value
            for key, value in self.points[run].items()
        }

    @cached_property
    def _json_columns(self) -> frozenset[str]:
        kinds = defaultdict[str, set[type]](set)
        for axis in self.points.axes:
            for entry in axis.entries:
                for key, value in entry.items():
                    kinds[key].add(float if type(value) is int else type(value))
        return frozenset(
            key for key, found in kinds.items() if found not in ({float}, {bool}, {str})
        )

    def check(self) -> None:
        """Check all listed values and both ends of every range.

        Each value is tested with the first and with the last values of the other axes,
        and without them. Raises SceneError if a value is invalid in each of these
        scenes or if an axis has no valid value. A value that merely contradicts other
        keys causes errors in the affected runs."""
        points = self.points
        first = points.point(axis.step(0) for axis in points.axes)
        last = points.point(axis.step(axis.n - 1) for axis in points.axes)
        for axis in points.axes:
            faults = [
                _contradiction(
                    [
                        with_values(self.document, others | own)
                        for others in (first, last, {})
                    ]
                )
                for own in axis.entries
            ]
            refusals = [fault for fault in faults if fault is not None]
            if len(refusals) == len(faults):
                raise refusals[0]
            if all(
                self._is_unused(own, others)
                for own in axis.entries
                for others in (first, last)
            ):
                raise InputError(
                    f"axes.{axis.keys[0]}: has no effect on the runs of this sweep"
                )
        for key in self.sources.keys() - {*self.axes}:
            raise InputError(f"sources.{key}: no such axis")

    def _is_unused(self, own: dict[str, Any], others: dict[str, Any]) -> bool:
        """Return True if no stage reads the keys in `own` in the scene with the values
        `others` and `own`."""
        try:
            scene, plan = planned_scene(
                from_document(with_values(self.document, others | own))
            )
        except SceneError:
            return False
        return own.keys() <= set(unused_keys(scene, plan))


def with_hashed_mesh(document: dict[str, Any]) -> dict[str, Any]:
    """Return a scene document in which the content of a mesh file, which may have any
    path, replaces its name."""
    document = deepcopy(document)
    if mesh := document.get("surface", {}).get("file"):
        document["surface"]["file"] = sha256(Path(mesh).read_bytes()).hexdigest()
    return document


def is_assumed(source: str) -> bool:
    """Return True if the source of a range says that it is at least partly assumed."""
    return not source or any(word in source for word in ("assumed", "unknown"))


def _contradiction(documents: Iterable[dict[str, Any]]) -> ContradictionError | None:
    """Return None if one of the documents is a valid scene, otherwise a
    ContradictionError.

    Raises SceneError if every document contains an invalid value.
    """
    faults = []
    for document in documents:
        try:
            from_document(document)
        except SceneError as error:
            faults.append(error)
        else:
            return None
    for fault in faults:
        if isinstance(fault, ContradictionError):
            return fault
    raise faults[0]


def with_values(document: dict[str, Any], values: dict[str, Any]) -> dict[str, Any]:
    """Return a copy of a document with new values at keys such as `release.omega.2`."""
    document = deepcopy(document)
    for path, value in values.items():
        *sections, key = path.split(".")
        place = document
        try:
            for section in sections:
                place = (
                    place[int(section)]
                    if isinstance(place, list)
                    else place.setdefault(section, {})
                )
            place[int(key) if isinstance(place, list) else key] = value
        except (AttributeError, IndexError, TypeError, ValueError):
            raise SceneError(f"{path}: the scene has no such key") from None
    return document


def load_sweep(source: "str | Path | dict[str, Any]") -> Sweep:
    """Load and check a sweep.

    Parameters
    ----------
    source : str, Path or dict
        Name of a shipped sweep, path of a TOML file, or parsed sweep document.

    Returns
    -------
    Sweep
        The validated sweep.

    Raises
    ------
    InputError
        If there is no such sweep, or if a key or value is not allowed.
    """
    # Largest number of runs of a sweep, limited by the memory for their completion
    # flags
    max_runs = 1_000_000_000
    folder = Path()
    if not isinstance(source, dict):
        path = find_file(source, SHIPPED_SWEEPS_FOLDER, "sweep", InputError)
        folder = path.parent
        source = read_toml(path, InputError)
    try:
        sweep = TypeAdapter(Sweep).validate_json(json.dumps(source, default=str))
    except ValidationError as error:
        raise InputError(error_sentence(error, Sweep)) from None
    object.__setattr__(sweep, "folder", folder)
    if sweep.points.count > max_runs:
        raise InputError(
            f"axes: {sweep.points.count:.3g} runs are more than {max_runs:.0e}; divide the sweep into "
            f"several sweeps"
        )
    sweep.check()
    _ = sweep.stages
    return sweep


def shipped_sweeps() -> list[str]:
    """List the shipped sweeps.

    Returns
    -------
    list of str
        Names that `load_sweep` and `sonify.sweep` accept.

    Examples
    --------
    >>> from sonify.sweeps.sweep import shipped_sweeps
    >>> "verdict-glass" in shipped_sweeps()
    True
    """
    return shipped_names(SHIPPED_SWEEPS_FOLDER)
