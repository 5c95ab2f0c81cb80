"""Solve many motions to their end, and report how each of them ends.

`python benchmarks/whole_motions.py grid` releases the disk of `published` at inclinations of 1
to 89 degrees and 0 to 200 rad/s, in a vacuum and in air; `python benchmarks/whole_motions.py
random` solves random scenes. Each motion is solved in a process of its own, with a limit on its
processor time. The exit status is 1 if a motion does not end at rest, or at its time limit, within
this limit, or if a disk that moved has no sound: the contact force, which drives the modes and the
rigid disk, must be finite and vary.
"""

import argparse
import json
import resource
import signal
import sys
import time
from collections import Counter
from collections.abc import Iterator
from multiprocessing import get_context
from random import Random
from typing import Any, NamedTuple

import numpy as np

from dynamics import ImpossibleContactError, Motion, Outcome, simulate
from modal import UnsolvableError
from sonify import load_scene
from sonify.scene import Scene, from_document

MAX_CPU_SECONDS_PER_MOTION = 60.0
"""Largest processor time [s] of a motion."""
MAX_PROCESS_BYTES = 3e9
"""Largest memory of a process [bytes]."""
GRID_INCLINATIONS_DEG = np.linspace(1.0, 89.0, 12)
"""Inclinations [degrees] of the grid."""
GRID_ANGULAR_RATES = np.linspace(0.0, 200.0, 5)
"""In-plane and axial angular velocities [rad/s] of the grid."""


class Case(NamedTuple):
    """A scene to solve: its name, and its document or the changes of a shipped scene."""

    name: str
    document: dict[str, Any] | None = None
    changes: tuple[str, ...] = ()

    def scene(self) -> Scene:
        """Return the scene; raise SceneError if it is not legal."""
        if self.document is None:
            return load_scene("published").replace(*self.changes)
        return from_document(self.document)


class End(NamedTuple):
    """How a motion ended.

    Attributes
    ----------
    name : str
        Name of the scene.
    outcome : str
        Outcome, or the error.
    t, limit : float
        Time of the end, and the time limit [s].
    seconds : float
        Processor time [s].
    parts : int
        Number of parts of the motion.
    energy_error : float
        Largest relative error of the energy balance.
    force : float
        Largest normal force divided by the weight.
    force_change : float
        Difference of the largest and the smallest normal force divided by the weight.
    film : bool
        True if a film of air acts, which can stop a light disk before it touches the table.
    turning : float
        Largest angular velocity [rad/s].
    memory : float
        Largest memory of the process [bytes].
    """

    name: str
    outcome: str
    t: float = 0.0
    limit: float = 0.0
    seconds: float = 0.0
    parts: int = 0
    energy_error: float = 0.0
    force: float = 0.0
    force_change: float = 0.0
    film: bool = False
    turning: float = 0.0
    memory: float = 0.0

    @property
    def is_right(self) -> bool:
        """True if the disk is at rest, or the time limit is reached, or the scene is refused."""
        if self.outcome.startswith("refused"):
            return True
        if self.seconds > MAX_CPU_SECONDS_PER_MOTION or self.memory > MAX_PROCESS_BYTES:
            return False
        if not self.sounds:
            return False
        if self.outcome == Outcome.ROLLING_ON.name:
            return self.t >= 0.999 * self.limit
        return self.outcome == Outcome.AT_REST.name

    @property
    def sounds(self) -> bool:
        """True if the contact force is finite, and something drives the sound of a disk that turns."""
        is_finite = bool(np.isfinite([self.force, self.force_change]).all())
        return is_finite and (self.force_change > 0 or self.film or self.turning == 0)


def grid() -> Iterator[Case]:
    """Yield the releases of the grid in a vacuum and in air."""
    for air in ("none", "acts"):
        for inclination in GRID_INCLINATIONS_DEG:
            for axial in GRID_ANGULAR_RATES:
                for in_plane in GRID_ANGULAR_RATES:
                    release = (
                        f"release={{inclination_deg={inclination:.6g}, "
                        f"omega=[0.0, {axial:.6g}, {in_plane:.6g}]}}"
                    )
                    name = f"{air} {inclination:.3g} deg {axial:.3g} {in_plane:.3g}"
                    yield Case(name, changes=(release, f"air.film={air}"))


def random_scenes() -> Iterator[Case]:
    """Yield random legal scenes."""
    from legal_scenes import any_document  # tests/helpers

    for seed in range(1, 301):
        yield Case(f"random {seed}", document=any_document(Random(seed)))


def motion_of(case: Case) -> tuple[Motion, float]:
    """Return the motion of a case, and its time limit [s]."""
    scene = case.scene()
    modes = None
    if scene.surface.kind in ("plate", "mesh"):
        from modal import surface_modes

        modes = surface_modes(scene)
    return simulate(scene, surface_modes=modes), scene.numerics.time_limit


def stop_after(seconds: float) -> None:
    """Raise RuntimeError in this process after a processor time [s]."""

    def stop(number: int, frame: Any) -> None:
        raise RuntimeError(f"no end in {seconds:g} s")

    signal.signal(signal.SIGXCPU, stop)
    limit = round(time.process_time() + seconds)
    resource.setrlimit(resource.RLIMIT_CPU, (limit, limit + 10))


def end_of(case: Case) -> End:
    """Solve a case and return its end."""
    stop_after(1.5 * MAX_CPU_SECONDS_PER_MOTION)
    began = time.process_time()
    try:
        motion, limit = motion_of(case)
    except ImpossibleContactError as error:
        return End(case.name, f"impossible: {error}")
    except (UnsolvableError, ValueError) as error:
        return End(case.name, f"refused: {error}")
    except Exception as error:
        return End(case.name, f"{type(error).__name__}: {error}")
    seconds = time.process_time() - began
    t = motion.t[:: len(motion.t) // 20_000 + 1]
    state = motion.at(t)
    load = motion.force(t)[:, 2] / motion.disk.weight
    total = motion.energy(t) + state[:, 10]
    return End(
        case.name,
        motion.outcome.name,
        float(motion.t[-1]),
        limit,
        seconds,
        len(motion.parts),
        float(np.ptp(total) / max(abs(total[0]), 1e-300)),
        float(load.max()),
        float(np.ptp(load)),
        motion.plan.film is not None,
        float(np.abs(state[:, 5:8]).max()),
        1024.0 * resource.getrusage(resource.RUSAGE_SELF).ru_maxrss,
    )


def solve_all(cases: list[Case], processes: int) -> Iterator[End]:
    """Yield the ends of cases, each solved in a process of its own."""
    with get_context("spawn").Pool(processes, maxtasksperchild=1) as pool:
        yield from pool.imap(end_of, cases)


def main() -> None:
    """Solve the chosen motions, print their ends and count the outcomes."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("motions", choices=["grid", "random"])
    parser.add_argument("--every", type=int, default=1, help="solve every n-th motion")
    parser.add_argument(
        "--first", type=int, default=0, help="number of the first motion"
    )
    parser.add_argument("--processes", type=int, default=1)
    options = parser.parse_args()
    cases = list(grid() if options.motions == "grid" else random_scenes())
    chosen = cases[options.first :: options.every]
    ends = []
    for end in solve_all(chosen, options.processes):
        ends.append(end)
        mark = " " if end.is_right else "!"
        print(mark, json.dumps(end._asdict()), flush=True)
    counts = Counter(end.outcome.split(":")[0] for end in ends)
    wrong = [end.name for end in ends if not end.is_right]
    print(
        dict(counts),
        f"{max(end.seconds for end in ends):.1f} s at most, wrong: {wrong}",
    )
    sys.exit(bool(wrong))


if __name__ == "__main__":
    main()
