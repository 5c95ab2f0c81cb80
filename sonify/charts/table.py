"""The chart of the table: one mode under a weight that goes round, for our methods, textbooks' and physics engines."""

from functools import partial

from sonify.charts import table_case as case
from sonify.charts.page import milliseconds, number
from sonify.charts.peers import Peer
from sonify.charts.records import Record, Work, along, ends, from_one, measured, nearest
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
RATE = "{:g} 1/s"
PEERS = {
    "MuJoCo, Euler": Peer("mujoco", "table", ("Euler",), (1e2, 1e3, 1e4), RATE),
    "MuJoCo, RK4": Peer("mujoco", "table", ("RK4",), (1e2, 1e3, 1e4), RATE),
    "MuJoCo, plate of flexes": Peer("mujoco", "flexes", (), (9, 17), "{} vertices a side"),
    "Drake, TAMSI": Peer("pydrake", "table", ("Tamsi",), (1e2, 1e3, 1e4), RATE),
    "Drake, SAP": Peer("pydrake", "table", ("Sap",), (1e2, 1e3, 1e4), RATE),
    "Drake, contact by areas": Peer("pydrake", "areas", (), (1e2, 1e3), RATE),
    "PyBullet": Peer("pybullet", "table", (), (1e2, 1e3, 1e4), RATE),
}


def works(quick: bool) -> list[Work]:
    """Return every run; `quick` keeps both ends of every path."""
    runs = []
    for family, method, rates, solve in (
        (SOUND, "exact hold", (25, 100, 400, 1600, 6400), case.exact_hold),
        (MOTION, "midpoint rule, with the disk", (2000, 4000, 8000, 16000), case.with_the_disk),
        (TEXTBOOK, "semi-implicit Euler", (100, 400, 1600, 6400), partial(case.plain, semi_implicit_euler)),
        (TEXTBOOK, "average acceleration", (100, 400, 1600, 6400), partial(case.plain, bilinear)),
    ):
        runs += along(family, method, RATE, ends(rates, quick), solve, CASE, from_one, WRONG)
    for method, peer in PEERS.items():
        for setting, call in ends(peer.runs(), quick):
            runs.append(Work(ENGINE, method, setting, CASE, call, from_one, WRONG))
    return runs


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
