"""Write the run that the studio shows at first; `python -m sonify.studio.opening` renews it."""

import gzip
import json
from importlib import resources

from sonify.pipeline import solve
from sonify.report.page_data import encoded_motion, encoded_sounds, page_data
from sonify.report.render_worker import draw_png
from sonify.report.write import run_record
from sonify.runtime.json_values import plain_value
from sonify.scene import load_scene

OPENING_SCENE = "toy"
OPENING_DURATION = 15.0
"""Length of the final part of the run [s]."""
LISTED_PARTS = ("scene", "outcome", "motion", "sound", "headline", "checks")
"""Parts of run.json that the list of runs needs."""


def opening_run() -> bytes:
    """Return the data of the end of the scene toy for the page, as compressed JSON."""
    result = solve(load_scene(OPENING_SCENE), accuracy="draft")
    parts = {
        "motion": encoded_motion(result.motion, OPENING_DURATION),
        "sound": encoded_sounds(result.sound, OPENING_DURATION),
        "colours": draw_png("sound", "write_colour_table", {}),
    }
    record = run_record(result)
    listed = {name: record[name] for name in LISTED_PARTS}
    data = page_data(result, parts) | {"record": listed}
    text = json.dumps(data, default=plain_value, allow_nan=False)
    return gzip.compress(text.encode(), mtime=0)


def main() -> None:
    """Write the file into the package."""
    from sonify.studio.application import OPENING_RUN

    file = resources.files("sonify.studio") / OPENING_RUN
    file.write_bytes(opening_run())  # type: ignore[attr-defined]


if __name__ == "__main__":
    main()
