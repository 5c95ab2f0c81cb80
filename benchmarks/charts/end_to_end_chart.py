"""Chart audible error against processor time from scene to sound.

Runs are the accuracy levels and single coarse choices; the reference is the same scene
at accuracy "reference". The times are those of modes, motion and sound."""

import math
from dataclasses import replace
from functools import partial
from itertools import product
from pathlib import Path

import numpy as np
from matplotlib.figure import Figure

from benchmarks.cases.sound_error import audible_error, level_error
from benchmarks.charts.error_time_picture import DPI, MARKERS, family_colours, save
from benchmarks.timed_runs import Answer, Record, Work, measured
from dynamics import simulate
from dynamics.solver_settings import ACCURACY_LEVELS
from sonify.plan.preflight import plan_with_modes
from sonify.scene import load_scene
from sonify.sound.render import Renderer

PROBLEM = r"""
The published scene is solved from its release to the pressure $p(t)$ at a distance of half a metre, with the modes of
the disk *held* at its contact and of the *free* disk. The error is the level of the difference from
$p_\mathrm{ref}(t)$, the pressure of the same scene at accuracy `reference`,

$$L = 20 \log_{10} \frac{\lVert p - p_\mathrm{ref} \rVert}{\lVert p_\mathrm{ref} \rVert}$$

of the samples, of the A-weighted samples, and of the third-octave levels. The times are those of modes, motion and
sound.
"""
SUPPORTS = {"held": "patch", "free": "free"}
MEASURES = {
    "samples, A-weighted": audible_error,
    "samples": partial(audible_error, weighted=False),
    "third octaves": level_error,
}
"""Error measures of a sound against the reference."""

ACCURACY = "accuracy"
PREDICTED = "predicted for"
CHOICE = "reference, but"

QUICK_CHANGES = ("numerics.time_limit=3.0",)
"""Changes of the scene for the quick chart."""

MIN_LEVEL = -140.0
"""Lowest drawn level of the error [dB]; lower ones are drawn at this value."""

DRAFT_MODES = "modes as in the draft"
SPREAD_JUMPS = "jumps spread over a sample"
CHOICES = {
    "tolerance of the motion 1e-9": lambda draft, _: {"tolerance": 1e-9},
    "motion stops at the highest audible rate": lambda draft, _: {
        "final_inclination": draft.final_inclination
    },
    DRAFT_MODES: lambda draft, modes: {"sounding": tuple(range(len(modes)))},
    f"force read every {ACCURACY_LEVELS['draft'].max_contact_turn:g} rad": lambda draft, _: {
        "max_contact_turn": draft.max_contact_turn
    },
    f"modes within {ACCURACY_LEVELS['draft'].range_db:g} dB(A) of the loudest": lambda draft, _: {
        "sounding": draft.sounding
    },
    SPREAD_JUMPS: lambda draft, _: {},
}
"""Function of plan and modes of the draft that returns the changed fields of the plan,
by name of the coarse choice."""


class JumpsOnGrid:
    """Sampler of the force that spreads jumps over one sample."""

    def __init__(self, sampler):
        self._sampler = sampler
        self.end = sampler.end

    def block(self, first: int, count: int):
        """Return `count` samples of the force without jumps between them."""
        force = self._sampler.block(first, count)
        none = np.zeros((0, force.smooth.shape[1]))
        return replace(force, jump_time=np.zeros(0), jump=none, bend=none)


def render(scene, choice) -> Answer:
    """Return the pressure of a scene, rendered with one coarse choice or with none
    (None)."""
    plan, modes = plan_with_modes(scene)
    if choice:
        draft_plan, draft_modes = plan_with_modes(
            scene.replace("numerics.accuracy=draft")
        )
        plan = replace(plan, **CHOICES[choice](draft_plan, draft_modes))
        if choice == DRAFT_MODES:
            modes = draft_modes
    numerics = replace(
        scene.numerics,
        tolerance=plan.tolerance,
        final_inclination=plan.final_inclination,
    )
    motion = simulate(replace(scene, numerics=numerics))
    renderer = Renderer(scene, motion, modes, plan.sounding, plan.max_contact_turn)
    if choice == SPREAD_JUMPS:
        renderer.sampler = JumpsOnGrid(renderer.sampler)
    return Answer(renderer.sound().pressure, renderer.samples)


def works(support: str, quick: bool, pressures: dict) -> list[Work]:
    """Return the runs of one support, beginning with the reference; run i stores its
    pressure in pressures[i]."""
    scene = load_scene("published").replace(
        f"support.kind={SUPPORTS[support]}", *(QUICK_CHANGES if quick else ())
    )
    settings = [(ACCURACY, name, None) for name in reversed(ACCURACY_LEVELS)]
    settings += [
        (CHOICE, "reference", name)
        for name in (list(CHOICES)[:2] if quick else CHOICES)
    ]
    runs = []
    for i, (family, accuracy, choice) in enumerate(settings):
        call = partial(render, scene.replace(f"numerics.accuracy={accuracy}"), choice)
        runs.append(
            Work(
                family,
                choice or accuracy,
                "",
                support,
                call,
                partial(keep, pressures, i),
                math.inf,
            )
        )
    return runs


def keep(pressures: dict, i: int, pressure) -> float:
    """Store a pressure and return 0 as a provisional error.

    The error is computed after the run of the reference."""
    pressures[i] = pressure
    return 0.0


def run(quick: bool, watch=lambda fraction, note: None) -> list[Record]:
    """Return the records of the chart, one per run and error measure; `watch(fraction,
    note)` is called before runs."""
    records = []
    for support_index, support in enumerate(SUPPORTS):
        pressures = {}
        runs = works(support, quick, pressures)
        watch_support = partial(within, watch, support_index)
        timed_runs = measured(
            runs, watch_support, warm=lambda work: not quick, repeats=1 if quick else 3
        )
        for i, timed in enumerate(timed_runs):
            errors = {
                f"{support}: {name}": error(pressures[i], pressures[0])
                for name, error in MEASURES.items()
            }
            records += [
                replace(timed, case=case, error=error) for case, error in errors.items()
            ]
            records += predicted(runs[i], timed, next(iter(errors)))
    return records


def within(watch, support_index: int, fraction: float, note: str):
    """Convert the progress within the runs of one support to that of the whole chart,
    and report it."""
    watch((support_index + fraction) / len(SUPPORTS), note)


def predicted(work: Work, timed: Record, case: str) -> list[Record]:
    """Return a list with the record of the error predicted by the plan; empty for a
    coarse choice."""
    plan, _ = plan_with_modes(work.call.args[0])
    errors = [p.error for p in plan.predictions if p.key == "sound"]
    return [
        replace(timed, family=PREDICTED, case=case, error=error)
        for error in errors
        if work.family == ACCURACY
    ]


def decibel(error: float) -> float:
    """Return the level [dB] of a relative error."""
    return 20 * math.log10(max(error, 10 ** (MIN_LEVEL / 20)))


def conclusion(records: list[Record]) -> list[str]:
    """Return one sentence per support on the errors of the accuracy levels and the
    worst coarse choice."""
    lines = []
    for support in dict.fromkeys(r.case.partition(":")[0] for r in records):
        runs = [
            r
            for r in records
            if r.case == f"{support}: {next(iter(MEASURES))}" and r.error > 0
        ]
        clauses = [
            f"{r.method} {decibel(r.error):.0f} dB(A) in {r.seconds:.2g} s"
            for r in runs
            if r.family == ACCURACY
        ]
        worst = max(
            (r for r in runs if r.family == CHOICE), key=lambda r: r.error, default=None
        )
        if worst:
            clauses.append(
                f"the worst single choice is {worst.method}, {decibel(worst.error):.0f} dB(A)"
            )
        lines.append(f"{support}: {'; '.join(clauses)}.")
    return lines


def tables(records: list[Record]) -> dict[str, list[list]]:
    """Return one table of the levels of all runs by all measures, with the predictions
    of the plan."""
    cases = list(dict.fromkeys(r.case for r in records))
    known = {(r.family, r.method, r.case): r for r in records}
    rows = [["method", *cases, f"seconds, {cases[0].partition(':')[0]}"]]
    for family, method in dict.fromkeys((r.family, r.method) for r in records):
        runs = [known.get((family, method, case)) for case in cases]
        levels = [
            f"{decibel(r.error):.0f} dB" if r and r.error > 0 else "-" for r in runs
        ]
        rows.append(
            [f"{family}: {method}", *levels, f"{next(filter(None, runs)).seconds:.2g}"]
        )
    return {"Levels of the difference": rows}


def draw(records: list[Record], title: str, path: Path):
    """Draw the level of the error against processor time, one row per support and one
    column per measure."""
    figure = Figure(figsize=(16, 10), dpi=DPI, layout="constrained")
    panels = figure.subplots(len(SUPPORTS), len(MEASURES), sharex="row", sharey="row")
    names = [(r.family, r.method) for r in records]
    tones = family_colours(list(dict.fromkeys(family for family, _ in names)))
    styles = {
        name: MARKERS[i % len(MARKERS)] for i, name in enumerate(dict.fromkeys(names))
    }
    for axes, (support, measure_name) in zip(
        panels.flat, product(SUPPORTS, MEASURES), strict=True
    ):
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
        axes.plot(
            [r.seconds for r in curve], [decibel(r.error) for r in curve], "k-", lw=1
        )
        axes.set(
            title=f"modes {support}: {measure_name}",
            xlim=(0, None),
            ylim=(MIN_LEVEL - 5, 15),
        )
        axes.grid(alpha=0.3)
    for axes in panels[-1]:
        axes.set_xlabel("processor time of modes, motion and sound [s], median")
    for axes in panels[:, 0]:
        axes.set_ylabel("difference from the reference [dB re its sound]")
    handles = dict(zip(*panels[0, 0].get_legend_handles_labels()[::-1], strict=True))
    figure.legend(
        handles.values(),
        handles.keys(),
        loc="outside lower center",
        ncols=3,
        fontsize=9,
    )
    figure.suptitle(f"{title} (the reference is at the lower edge)")
    save(figure, path)
