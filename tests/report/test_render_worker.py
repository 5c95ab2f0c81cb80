"""Claim: a picture drawn in a worker process equals the one drawn in this process, even if the
worker dies; scripts need no main guard, and no process is left running.

Oracle: the bytes from the same function called in this process.
"""

import subprocess
import sys
import time

import numpy as np
import psutil
import pytest

from sonify.report.render_worker import Painter, draw_png

ROWS = np.arange(1.0, 6.0) ** np.arange(3)[:, None]
CURVES = {
    "motion": dict.fromkeys(("time", "inclination", "energy"), np.arange(5.0))
    | {
        "force": (np.arange(5.0), 1.0),
        "centre": ROWS[:2],
        "rates": ROWS,
        "before_end": ROWS[:, ::-1],
    }
}


@pytest.fixture
def painter():
    painter = Painter()
    yield painter
    painter.close()


def test_both_processes_draw_the_same_bytes_also_once_one_is_dead(painter):
    here = draw_png("motion", "draw_motion", CURVES)
    assert here.startswith(b"\x89PNG")
    assert painter.draw("motion", "draw_motion", lambda: CURVES).result() == here
    painter.close()
    assert painter.draw("motion", "draw_motion", lambda: CURVES).result() == here


def test_a_process_that_is_ended_leaves_no_pipe():
    painter = Painter()
    process = painter._worker.result().process
    painter.close()
    assert process.returncode is not None
    assert process.stdin.closed
    assert process.stdout.closed


def test_where_no_process_can_be_had_this_one_draws(monkeypatch):
    monkeypatch.setattr(sys, "executable", "")
    assert Painter().draw("motion", "draw_motion", lambda: CURVES).result() == draw_png(
        "motion", "draw_motion", CURVES
    )


def test_what_goes_wrong_there_is_raised_here(painter):
    with pytest.raises(TypeError, match="time"):
        painter.draw("motion", "draw_motion", lambda: {"motion": {}}).result()


SCRIPT = """
import numpy as np
from sonify.report.render_worker import painter
rows = np.arange(1.0, 6.0) ** np.arange(3)[:, None]
data = dict.fromkeys(("time", "inclination", "energy"), rows[1])
data |= {"force": (rows[1], 1.0), "centre": rows[:2], "rates": rows, "before_end": rows[:, ::-1]}
picture = painter().draw("motion", "draw_motion", lambda: {"motion": data}).result()
print(painter()._worker.result().process.pid, len(picture), flush=True)
END
"""


@pytest.mark.slow
@pytest.mark.parametrize("end", ["", "import os; os.kill(os.getpid(), 9)"])
def test_a_script_without_a_guard_draws_and_leaves_no_process(end, tmp_path):
    script = tmp_path / "script.py"
    script.write_text(SCRIPT.replace("END", end), encoding="utf-8")
    done = subprocess.run(
        [sys.executable, script], capture_output=True, text=True, check=False
    )
    pid, size = map(int, done.stdout.split())
    assert size > 1000
    assert not done.stderr
    deadline = time.monotonic() + 60
    while (
        psutil.pid_exists(pid) and psutil.Process(pid).status() != psutil.STATUS_ZOMBIE
    ):
        assert time.monotonic() < deadline
        time.sleep(0.05)
