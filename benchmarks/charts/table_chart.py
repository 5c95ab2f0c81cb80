"""Chart methods, textbook methods and physics engines for one table mode under a moving
weight."""

from functools import partial

from benchmarks.cases import table_case as case
from benchmarks.charts.chart_page import milliseconds, number
from benchmarks.methods.oscillator_steps import bilinear, semi_implicit_euler
from benchmarks.peers.engines import EngineMethod
from benchmarks.timed_runs import (
    Record,
    Work,
    distance_from_one,
    measured,
    most_accurate,
    selected_values,
    works_over,
)

PROBLEM = r"""
A weight $P$ moves along a circle at the angular velocity $\Omega$ on one mode of a table, of order $n$. The amplitudes
of its cosine and sine are $z = q_c + i q_s$,

$$\ddot z + 2 \zeta \omega \dot z + \omega^2 z = -\frac{P}{M} e^{i n \Omega t}, \qquad
z = A e^{i n \Omega t}, \quad A = \frac{-P/M}{\omega^2 - n^2 \Omega^2 + 2 i \zeta \omega n \Omega}.$$

The result is $z e^{-i n \Omega t}/A$ after 25 periods of the mode, exactly 1, at $n = 1$, $n \Omega/\omega = 0.8$,
$\zeta = 0.05$. In the engines the mode is a plate on two springs, and the weight is a ball on a rotating arm; the
engines compute the contact themselves. In our two-way steps the weight is the published disk, which rolls on the mode.
The imaginary part of $A$ determines the power that the table takes from the motion.
"""
CASE = "one mode under a weight that goes round"
ONE_WAY = "it sounds"
TWO_WAY = "it acts back"
TEXTBOOK = "textbook"
ENGINE = "engine"
RATE_SETTING = "{:g} 1/s"

MAX_AMPLITUDE_ERROR = 0.1
"""Relative error of the amplitude above which a run counts as failed."""

ENGINE_METHODS = {
    "MuJoCo, Euler": EngineMethod(
        "mujoco", "table", ("Euler",), (1e2, 1e3, 1e4), RATE_SETTING
    ),
    "MuJoCo, RK4": EngineMethod(
        "mujoco", "table", ("RK4",), (1e2, 1e3, 1e4), RATE_SETTING
    ),
    "MuJoCo, plate of flexes": EngineMethod(
        "mujoco", "flexes", (), (9, 17), "{} vertices a side"
    ),
    "Drake, TAMSI": EngineMethod(
        "pydrake", "table", ("Tamsi",), (1e2, 1e3, 1e4), RATE_SETTING
    ),
    "Drake, SAP": EngineMethod(
        "pydrake", "table", ("Sap",), (1e2, 1e3, 1e4), RATE_SETTING
    ),
    "Drake, contact by areas": EngineMethod(
        "pydrake", "areas", (), (1e2, 1e3), RATE_SETTING
    ),
    "PyBullet": EngineMethod("pybullet", "table", (), (1e2, 1e3, 1e4), RATE_SETTING),
}


def works(quick: bool) -> list[Work]:
    """Return all runs; `quick` keeps the first and the last value of every setting."""
    runs = []
    for family, method, rates, solve in (
        (ONE_WAY, "exact hold", (25, 100, 400, 1600, 6400), case.exact_hold),
        (
            TWO_WAY,
            "midpoint rule, with the disk",
            (2000, 4000, 8000, 16000),
            case.two_way_disk,
        ),
        (
            TEXTBOOK,
            "semi-implicit Euler",
            (100, 400, 1600, 6400),
            partial(case.textbook_steps, semi_implicit_euler),
        ),
        (
            TEXTBOOK,
            "average acceleration",
            (100, 400, 1600, 6400),
            partial(case.textbook_steps, bilinear),
        ),
    ):
        runs += works_over(
            family,
            method,
            RATE_SETTING,
            selected_values(rates, quick),
            solve,
            CASE,
            distance_from_one,
            MAX_AMPLITUDE_ERROR,
        )
    for method, peer in ENGINE_METHODS.items():
        for setting, call in selected_values(peer.runs(), quick):
            runs.append(
                Work(
                    ENGINE,
                    method,
                    setting,
                    CASE,
                    call,
                    distance_from_one,
                    MAX_AMPLITUDE_ERROR,
                )
            )
    return runs


def run(quick: bool, watch=lambda fraction, note: None) -> list[Record]:
    """Return the records of the chart; `watch(fraction, note)` is called before every
    run."""
    return measured(works(quick), watch, warm=lambda work: work.family != ENGINE)


def conclusion(records: list[Record]) -> list[str]:
    """Return at most five sentences on the method for each kind of table and on the
    errors of other methods."""
    one_way = most_accurate(records, family=ONE_WAY)
    two_way = most_accurate(records, family=TWO_WAY)
    textbook = most_accurate(records, family=TEXTBOOK)
    engine = most_accurate(records, family=ENGINE)
    lines = [
        f"If the table only radiates, use the {in_words(one_way)}; its only error is the force "
        f"between two samples.",
        f"With two-way coupling, use the {in_words(two_way)}; the mode agrees with the closed "
        f"form.",
        f"The most accurate textbook method is the {in_words(textbook)}.",
    ]
    if engine:
        lines.append(
            f"The engines compute the contact themselves; the most accurate one is "
            f"{in_words(engine)}."
        )
    failed_flexes = [
        r for r in records if r.failure and not r.left_out and "flexes" in r.method
    ]
    if failed_flexes:
        lines.append(
            f"A plate of MuJoCo's flexes cannot solve the case: {failed_flexes[-1].failure}."
        )
    return lines


def in_words(record: Record) -> str:
    """Return method, error, setting and time of a record in words."""
    return f"{record.method}, {number(record.error)} at {record.setting} in {milliseconds(record)}"
