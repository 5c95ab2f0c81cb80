"""The chart of the whole way from scene to sound: audible error against seconds, for the accuracies and for single
coarse choices.

Everything is compared with the same scene at accuracy "reference". The seconds are those of modes, motion and sound.
"""

import math
from dataclasses import replace
from functools import partial
from itertools import product
from pathlib import Path

import numpy as np
from matplotlib.figure import Figure

from dynamics import simulate
from dynamics.numerics import LEVELS
from sonify.charts.chart import DPI, MARKERS, save, tones_of
from sonify.charts.records import Answer, Record, Work, measured
from sonify.plan.predictions import SOUND, audible_error, level_error
from sonify.plan.solvable import planned
from sonify.scene import load_scene
from sonify.sound.render import Renderer

PROBLEM = r"""
The published scene from its release to the pressure $p(t)$ half a metre away, with the modes of the disk *held* at its
contact and of the *free* disk, compared with $p_\mathrm{ref}(t)$ of the same scene at accuracy `reference`:

$$L = 20 \log_{10} \frac{\lVert p - p_\mathrm{ref} \rVert}{\lVert p_\mathrm{ref} \rVert}$$

for the samples, for the samples after A-weighting, and for the levels of third octaves. The seconds are those of modes,
motion and sound.
"""
SUPPORTS = {"held": "patch", "free": "free"}
MEASURES = {
    "samples, A-weighted": audible_error,
    "samples": partial(audible_error, weighted=False),
    "third octaves": level_error,
}
"""The errors of a sound against another."""
ACCURACY, PREDICTED, CHOICE = "accuracy", "predicted for", "reference, but"
QUICK = ("numerics.time_limit=3.0",)
REPEATS = 3
"""How often a run is timed."""
FLOOR_DB = -140.0
"""An error below this is drawn here."""


DRAFT_MODES, SPREAD = "modes as in the draft", "jumps spread over a sample"
CHOICES = {
    "tolerance of the motion 1e-9": lambda draft, _: {"tolerance": 1e-9},
    "motion stops at the highest audible rate": lambda draft, _: {"final_inclination": draft.final_inclination},
    DRAFT_MODES: lambda draft, modes: {"sounding": tuple(range(len(modes)))},
    f"force read every {LEVELS['draft'].calm:g} rad": lambda draft, _: {"calm": draft.calm},
    f"modes within {LEVELS['draft'].range_db:g} dB(A) of the loudest": lambda draft, _: {"sounding": draft.sounding},
    SPREAD: lambda draft, _: {},
}
"""What is coarse, by name: from plan and modes of the draft, what differs in the plan of the reference."""


class JumpsOnGrid:
    """A sampler of the force that knows its jumps by the samples before and after them only."""

    def __init__(self, sampler):
        self._sampler, self.end = sampler, sampler.end

    def block(self, first: int, count: int):
        """Return the samples without the times of the jumps."""
        force = self._sampler.block(first, count)
        none = np.zeros((0, force.smooth.shape[1]))
        return replace(force, jump_time=np.zeros(0), jump=none, bend=none)


def render(scene, choice) -> Answer:
    """Render `scene`, with a coarse `choice` by name or None; return its pressure."""
    plan, modes = planned(scene)
    if choice:
        draft, fewer = planned(scene.replace("numerics.accuracy=draft"))
        plan, modes = replace(plan, **CHOICES[choice](draft, fewer)), fewer if choice == DRAFT_MODES else modes
    numerics = replace(scene.numerics, tolerance=plan.tolerance, final_inclination=plan.final_inclination)
    motion = simulate(replace(scene, numerics=numerics))
    renderer = Renderer(scene, motion, modes, plan.sounding, plan.calm)
    if choice == SPREAD:
        renderer.sampler = JumpsOnGrid(renderer.sampler)
    return Answer(renderer.sound().pressure, renderer.samples)


def works(support: str, quick: bool, heard: dict) -> list[Work]:
    """Return the runs of one support, the reference first; run i leaves its pressure in `heard`."""
    scene = load_scene("published").replace(f"support.kind={SUPPORTS[support]}", *(QUICK if quick else ()))
    settings = [(ACCURACY, name, None) for name in reversed(LEVELS)]
    settings += [(CHOICE, "reference", name) for name in (list(CHOICES)[:2] if quick else CHOICES)]
    runs = []
    for i, (family, accuracy, choice) in enumerate(settings):
        call = partial(render, scene.replace(f"numerics.accuracy={accuracy}"), choice)
        runs.append(Work(family, choice or accuracy, "", support, call, partial(keep, heard, i), math.inf))
    return runs


def keep(heard: dict, i: int, pressure) -> float:
    """Put a pressure into `heard`; it is judged when the reference is known."""
    heard[i] = pressure
    return 0.0


def run(quick: bool, watch=lambda share, note: None) -> list[Record]:
    """Return the records of the chart, one for each measure of a run; `watch(share, note)` is called before each."""
    records = []
    for half, support in enumerate(SUPPORTS):
        heard = {}
        runs = works(support, quick, heard)
        for i, timed in enumerate(
            measured(runs, partial(within, watch, half), lambda work: not quick, 1 if quick else REPEATS)
        ):
            cases = {f"{support}: {name}": error(heard[i], heard[0]) for name, error in MEASURES.items()}
            records += [replace(timed, case=case, error=error) for case, error in cases.items()]
            records += predicted(runs[i], timed, next(iter(cases)))
    return records


def within(watch, half: int, share: float, note: str):
    """Tell `watch` the progress within the runs of one support."""
    watch((half + share) / len(SUPPORTS), note)


def predicted(work: Work, timed: Record, case: str) -> list[Record]:
    """Return the record of the error that the plan of an accuracy predicts; none for a coarse choice."""
    plan, _ = planned(work.call.args[0])
    errors = [p.error for p in plan.predictions if p.name == SOUND]
    return [replace(timed, family=PREDICTED, case=case, error=error) for error in errors if work.family == ACCURACY]


def decibel(error: float) -> float:
    """Return the level [dB] of an error relative to what it is an error of."""
    return 20 * math.log10(max(error, 10 ** (FLOOR_DB / 20)))


def conclusion(records: list[Record]) -> list[str]:
    """Return in a sentence for each support what the accuracies give, and which coarse choice harms most."""
    lines = []
    for support in dict.fromkeys(r.case.partition(":")[0] for r in records):
        here = [r for r in records if r.case == f"{support}: {next(iter(MEASURES))}" and r.error > 0]
        told = [f"{r.method} {decibel(r.error):.0f} dB(A) in {r.seconds:.2g} s" for r in here if r.family == ACCURACY]
        worst = max((r for r in here if r.family == CHOICE), key=lambda r: r.error, default=None)
        told += [f"the worst single choice is {worst.method}, {decibel(worst.error):.0f} dB(A)"] if worst else []
        lines.append(f"{support}: {'; '.join(told)}.")
    return lines


def tables(records: list[Record]) -> dict[str, list[list]]:
    """Return the level of every run by every measure, and what the plan predicted."""
    cases = list(dict.fromkeys(r.case for r in records))
    known = {(r.family, r.method, r.case): r for r in records}
    rows = [["method", *cases, f"seconds, {cases[0].partition(':')[0]}"]]
    for family, method in dict.fromkeys((r.family, r.method) for r in records):
        runs = [known.get((family, method, case)) for case in cases]
        levels = [f"{decibel(r.error):.0f} dB" if r and r.error > 0 else "-" for r in runs]
        rows.append([f"{family}: {method}", *levels, f"{next(filter(None, runs)).seconds:.2g}"])
    return {"Levels of the difference": rows}


def draw(records: list[Record], title: str, path: Path):
    """Draw level of the error against seconds: a row for each support, a column for each measure."""
    figure = Figure(figsize=(16, 10), dpi=DPI, layout="constrained")
    panels = figure.subplots(len(SUPPORTS), len(MEASURES), sharex="row", sharey="row")
    names = [(r.family, r.method) for r in records]
    tones = tones_of(list(dict.fromkeys(family for family, _ in names)))
    styles = {name: MARKERS[i % len(MARKERS)] for i, name in enumerate(dict.fromkeys(names))}
    for axes, (support, measure_name) in zip(panels.flat, product(SUPPORTS, MEASURES), strict=True):
        here = [r for r in records if r.case == f"{support}: {measure_name}"]
        for r in here:
            ours = r.family != CHOICE
            axes.plot(
                r.seconds,
                decibel(r.error),
                styles[r.family, r.method],
                ms=11 if ours else 7,
                color=tones[r.family],
                mfc="white" if r.family == PREDICTED else None,
                ls="",
                label=f"{r.family}: {r.method}",
            )
        curve = [r for r in here if r.family == ACCURACY]
        axes.plot([r.seconds for r in curve], [decibel(r.error) for r in curve], "k-", lw=1)
        axes.set(title=f"modes {support}: {measure_name}", xlim=(0, None), ylim=(FLOOR_DB - 5, 15))
        axes.grid(alpha=0.3)
    for axes in panels[-1]:
        axes.set_xlabel("processor time of modes, motion and sound [s], median")
    for axes in panels[:, 0]:
        axes.set_ylabel("difference from the reference [dB re its sound]")
    handles = dict(zip(*panels[0, 0].get_legend_handles_labels()[::-1], strict=True))
    figure.legend(handles.values(), handles.keys(), loc="outside lower center", ncols=3, fontsize=9)
    figure.suptitle(f"{title} (the reference stands at the floor)")
    save(figure, path)
