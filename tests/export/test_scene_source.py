"""Claim: an export takes a scene, its name, its file, or the folder or record of an earlier run.

Source: sonify/export/scene_source.py. Oracle: the scene that was written.
"""

import json

from sonify import load_scene
from sonify.export.scene_source import scene_to_export
from sonify.scene import scene_record


def test_every_source_gives_the_same_scene(tmp_path):
    scene = load_scene("published")
    record = tmp_path / "run.json"
    record.write_text(json.dumps({"scene": scene_record(scene)}), "utf-8")
    for source in (scene, "published", tmp_path, str(tmp_path), record):
        found, plan = scene_to_export(source)
        assert found.diff(scene) == {}
        assert plan.scene.disk == scene.disk
