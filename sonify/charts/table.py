"""The chart of the table: one mode under a weight that goes round, for our methods, textbooks' and physics engines."""

from functools import partial
from importlib import import_module
from importlib.util import find_spec

from sonify.charts import table_case as case
from sonify.charts.page import milliseconds, number
from sonify.charts.peers import ENGINES
from sonify.charts.records import LEFT_OUT, Answer, Failure, Record, Work, ends, measured, nearest
from sonify.charts.steps import bilinear, semi_implicit_euler

PROBLEM = r"""
One mode of a table, of order $n$ round the contact, with its sine and its cosine, under a weight $P$ that goes round at
the rate $\Omega$: $z = q_c + i q_s$,

$$\ddot z + 2 \zeta \omega \dot z + \omega^2 z = -\frac{P}{M} e^{i n \Omega t}, \qquad
z = A e^{i n \Omega t}, \quad A = \frac{-P/M}{\omega^2 - n^2 \Omega^2 + 2 i \zeta \omega n \Omega}.$$

Asked is $z e^{-i n \Omega t}/A$ after 25 periods of the mode, exactly 1, at $n = 1$, $n \Omega/\omega = 0.8$,
$\zeta = 0.05$. To the engines it is a plate that rocks on two springs under a ball that slides on a turning arm, whose
contact they find themselves; to our two-way steps it is the published disk that rolls on the mode. The imaginary part
of $A$ is what the table takes from the motion.
"""
CASE = "one mode under a weight that goes round"
SOUND, MOTION, TEXTBOOK, ENGINE = "it sounds", "it acts back", "textbook", "engine"
WRONG = 0.1
PEERS = {
    "MuJoCo, Euler": ("mujoco", "mujoco", ("Euler",), (1e-2, 1e-3, 1e-4)),
    "MuJoCo, RK4": ("mujoco", "mujoco", ("RK4",), (1e-2, 1e-3, 1e-4)),
    "MuJoCo, plate of flexes": ("mujoco", "flexes", (), (9, 17)),
    "Drake, TAMSI": ("pydrake", "drake", ("Tamsi",), (1e-2, 1e-3, 1e-4)),
    "Drake, SAP": ("pydrake", "drake", ("Sap",), (1e-2, 1e-3, 1e-4)),
    "Drake, contact by areas": ("pydrake", "areas", (), (1e-2, 1e-3)),
    "PyBullet": ("pybullet", "bullet", (), (1e-2, 1e-3, 1e-4)),
}
"""Method: package, function of peer_table and its first arguments, steps [s] or vertices."""


def works(quick: bool) -> list[Work]:
    """Return every run; `quick` keeps both ends of every path."""

    def work(family, method, setting, call):
        return Work(family, method, setting, CASE, call, distance, WRONG)

    runs = []
    for rate in ends((25, 100, 400, 1600, 6400), quick):
        runs.append(work(SOUND, "exact hold", f"{rate:g} 1/s", partial(case.exact_hold, rate)))
    for rate in ends((2000, 4000, 8000, 16000), quick):
        runs.append(work(MOTION, "midpoint rule, with the disk", f"{rate:g} 1/s", partial(case.with_the_disk, rate)))
    for method, step in (("semi-implicit Euler", semi_implicit_euler), ("average acceleration", bilinear)):
        for rate in ends((100, 400, 1600, 6400), quick):
            runs.append(work(TEXTBOOK, method, f"{rate:g} 1/s", partial(case.plain, step, rate)))
    for method, (package, function, first, settings) in PEERS.items():
        if not find_spec(package):
            runs.append(work(ENGINE, method, "", partial(missing, package)))
            continue
        for setting in ends(settings, quick):
            about = f"{setting} vertices a side" if setting > 1 else f"{1 / setting:g} 1/s"
            runs.append(work(ENGINE, method, about, partial(engine, function, *first, setting)))
    return runs


def distance(values) -> float:
    """Return how far the answer is from 1 in the plane of complex numbers: amplitude and phase in one."""
    return abs(values[0] - 1)


def missing(package: str) -> Answer:
    """Raise the Failure of an engine that is not installed."""
    raise Failure(f"{LEFT_OUT}: {ENGINES[package]} is not installed")


def engine(function: str, *arguments) -> Answer:
    """Call a function of peer_table. Raises Failure where the engine stops."""
    try:
        return getattr(import_module("sonify.charts.peer_table"), function)(*arguments)
    except RuntimeError as error:
        raise Failure(f"stops: {' '.join(str(error).split())[:80]}") from None


def run(quick: bool, watch=lambda share, note: None) -> list[Record]:
    """Return the records of the chart; `watch(share, note)` is called before every run."""
    return measured(works(quick), watch, warm=lambda work: work.family != ENGINE)


def conclusion(records: list[Record]) -> list[str]:
    """Return what to take for a table that sounds and one that acts back, and what the others cost and miss."""
    hold, disk, plain, peer = (nearest(records, family=family) for family in (SOUND, MOTION, TEXTBOOK, ENGINE))
    lines = [
        f"For a table that only sounds take the {told(hold)}: the force between two samples is all that errs.",
        f"For one that acts back take the {told(disk)}: the mode is where the closed form has it.",
        f"Of the textbooks' methods the best is the {told(plain)}.",
    ]
    lines += [f"The engines, which find the contact themselves, pose the same case: {told(peer)}."] if peer else []
    broken = [r for r in records if r.failure and not r.left_out and "flexes" in r.method]
    return lines + [f"A plate of MuJoCo's flexes cannot be asked: {r.failure}." for r in broken[-1:]]


def told(record: Record) -> str:
    """Return method, error, rate and time of a record in words."""
    return f"{record.method}, {number(record.error)} at {record.setting} in {milliseconds(record)}"
