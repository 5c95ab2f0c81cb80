"""Compare predicted and measured processor seconds of the contact models of shipped scenes.

Run as `python -m benchmarks.speed.contact_option_seconds [SCENE ...]`. Each scene is solved by
the model of its plan, twice: the first run compiles. The exit status is 1 if a prediction is wrong
by more than a factor of MAX_PREDICTION_RATIO.
"""

import sys
from time import process_time

from dynamics import plan_motion, simulate
from dynamics.contact_options import FILTER_SAMPLE_RATE, ContactOption
from dynamics.motion_plan import MotionPlan
from modal import surface_modes
from sonify.scene import Scene, load_scene
from sonify.sound.sources.contact import ContactFilter

MAX_PREDICTION_RATIO = 2.0
"""Largest ratio of predicted and measured seconds, or its reciprocal."""
TIMED_SCENES = ("glass-plate", "granite", "toy", "coin")


def planned(scene: Scene) -> tuple[MotionPlan, object]:
    """Return the plan of a scene, and the modes of its table or None."""
    modes = surface_modes(scene) if scene.surface.kind == "plate" else None
    return plan_motion(scene, modes), modes


def chosen_option(plan: MotionPlan) -> ContactOption:
    """Return the option that the plan has chosen."""
    name = "two-way filter" if plan.filter_is_two_way else plan.contact.kind
    (found,) = (option for option in plan.contact_options if option.name == name)
    return found


def solve(scene: Scene, modes: object) -> None:
    """Solve the motion, and the force of a linear filter."""
    motion = simulate(scene, surface_modes=modes)
    if motion.plan.contact.kind == "filter":
        for _ in ContactFilter.along(
            motion.rolling, scene, int(FILTER_SAMPLE_RATE), 0.0
        ).blocks():
            pass


def measured_seconds(scene: Scene, modes: object) -> float:
    """Return the processor seconds of `solve` without compilation."""
    solve(scene, modes)
    began = process_time()
    solve(scene, modes)
    return process_time() - began


def main(names: tuple[str, ...]) -> int:
    """Print a row for each scene; return 1 if a prediction is wrong, else 0."""
    wrong = 0
    print(f"{'scene':12} {'model':15} {'predicted':>10} {'measured':>9} {'ratio':>6}")
    for name in names:
        scene = load_scene(name)
        plan, modes = planned(scene)
        option = chosen_option(plan)
        seconds = measured_seconds(scene, modes)
        ratio = option.seconds / seconds
        wrong += not 1 / MAX_PREDICTION_RATIO <= ratio <= MAX_PREDICTION_RATIO
        row = f"{name:12} {option.name:15} {option.seconds:8.3g} s {seconds:7.3g} s {ratio:6.2f}"
        print(row, flush=True)
    return min(wrong, 1)


if __name__ == "__main__":
    sys.exit(main(tuple(sys.argv[1:]) or TIMED_SCENES))
