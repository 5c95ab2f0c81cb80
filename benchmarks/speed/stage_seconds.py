"""Print the CPU seconds of the stages of a run as JSON, one stage after another.

Run as `python benchmarks/speed/stage_seconds.py [SCENE]` in a process whose caches are
filled. The pictures are not included: another process draws them."""

import gc
import json
import sys
from concurrent.futures import Future
from dataclasses import replace
from pathlib import Path
from tempfile import TemporaryDirectory
from time import process_time


class SerialExecutor:
    """Executor that runs each task at once, in the calling thread."""

    def submit(self, task, /, *arguments):
        """Return the completed Future of a task."""
        future = Future()
        future.set_result(task(*arguments))
        return future


def stage_seconds(scene: str) -> dict[str, float]:
    """Return the CPU seconds of the imports and of each stage of a scene."""
    seconds = {}
    began = 0.0

    def end_stage(name):
        nonlocal began
        now = process_time()
        seconds[name] = now - began
        began = now

    import_light()
    from sonify.entry_points import begin_run

    scene, motion_plan = begin_run(scene, None)
    from sonify import pipeline
    from sonify.report import page, pictures, write
    from sonify.sound.wav import write_sound

    end_stage("imports and plan")
    tools = pipeline.Tools(
        executor=SerialExecutor(),
        stages=pipeline.Stages(),
        begin=lambda solved: None,
        eigenmodes=pipeline.eigenmodes,
        listen=pipeline.listen_to_known_disk,
        dynamics="compressed",
    )
    solved = pipeline.solved_motion(scene, motion_plan, tools)
    end_stage("motion and modes")
    solved = replace(solved, sound=pipeline.sound_stage(solved, tools))
    end_stage("sound")
    two_way = tools.executor.submit(pipeline.two_way_stage, solved, tools.stages)
    result = pipeline.findings_stage(solved, two_way, tools)
    end_stage("findings")
    with TemporaryDirectory() as folder:
        write_sound(result.sound, folder)
        write.write_motion(result.motion, Path(folder) / "motion.npz")
        write.run_record(result)
        parts = {name: encode(result) for name, encode in pictures.PAGE_PARTS.items()}
        page.template_data(result, parts | {"colours": bytes(3 * 256)})
    end_stage("files and page")
    return seconds


def import_light() -> None:
    """Import as the command line does, in versions of the program that do."""
    try:
        from sonify.runtime.imports import import_signal_without_stats
    except ImportError:
        return
    gc.set_threshold(50_000)
    import_signal_without_stats()


if __name__ == "__main__":
    print(json.dumps(stage_seconds(sys.argv[1] if len(sys.argv) > 1 else "published")))
