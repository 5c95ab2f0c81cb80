"""Find the ends of the sliders of the studio; `python -m sonify.studio.slider_ends`
renews their file.

Both ends of a slider are values with which a run of the otherwise unchanged scene starts.
"""

import json
import sys
from importlib import resources
from typing import Any

from sonify.plan.preflight import check_solvable_scene
from sonify.scene import Scene, from_document, load_scene, shipped_scenes
from sonify.scene_errors import SceneError
from sonify.studio.controls import (
    SLIDER_ENDS,
    apply_control_value,
    slider_keys,
    slider_range,
)


def slider_ends(scene: Scene) -> dict[str, tuple[float, float]]:
    """Return the lower and the upper end of each slider of a scene."""
    return {key: _accepted_ends(scene, key) for key in slider_keys(scene)}


def _accepted_ends(scene: Scene, key: str) -> tuple[float, float]:
    """Return the ends of the range of a slider as far as runs are accepted."""
    wanted = slider_range(scene, key)
    low, high = (
        _accepted_end(scene, key, wanted.middle, end, wanted.logarithmic)
        for end in (wanted.low, wanted.high)
    )
    return low, high


def _accepted_end(
    scene: Scene, key: str, accepted: float, end: float, logarithmic: bool
) -> float:
    """Return the end of a slider or, if a run with this value is refused, the last
    value before it that is accepted, to a thousandth of the slider."""
    refused = _rounded(end)
    if _is_accepted(scene, key, refused):
        return refused
    step_count = 10  # halvings
    for _ in range(step_count):
        middle = (
            (accepted * refused) ** 0.5 if logarithmic else (accepted + refused) / 2
        )
        middle = _rounded(middle)
        if _is_accepted(scene, key, middle):
            accepted = middle
        else:
            refused = middle
    return accepted


def _rounded(value: float) -> float:
    """Return a value with the four significant digits that the page shows."""
    return float(f"{value:.4g}")


def _is_accepted(scene: Scene, key: str, value: Any) -> bool:
    """Return True if a run starts with one changed value of a scene."""
    document = scene.document
    apply_control_value(document, key, value)
    try:
        check_solvable_scene(from_document(document), None)
    except SceneError:
        return False
    return True


def main(names: list[str]) -> None:
    """Write the ends for the named scenes, or for all, into the package."""
    file = resources.files("sonify.studio") / SLIDER_ENDS
    known = json.loads(file.read_text("utf-8")) if names and file.is_file() else {}
    found = {name: slider_ends(load_scene(name)) for name in names or shipped_scenes()}
    text = json.dumps(known | found, indent=1, sort_keys=True)
    file.write_text(text + "\n", "utf-8")  # type: ignore[attr-defined]


if __name__ == "__main__":
    main(sys.argv[1:])
