"""Claim: scenes that differ only in numbers share compiled code, threads share no mutable state,
and memory use stays constant. DOP853 reads its flows from a cache of earlier processes.

Source: the numbers of a scene are arguments of the compiled flow; each run has its own integrator.
Oracle: the number of compilations, also that of Numba; the same scenes solved one after the other, byte by byte; the
process's memory.
"""

import os
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass

import pytest
from psutil import Process
from scenes import scene, whirling

from dynamics import Loads, OwnLaw, plan_motion, simulate
from dynamics.equations import DiskConstants
from dynamics.hybrid import StalledError
from dynamics.integrators import codegen
from dynamics.regime import Branch, Regime
from dynamics.simulation import chosen_integrator, compile_in_background

INTEGRATORS = ["taylor", "dop853"]
LAW = DiskConstants(0.17, 1.0, 0.5, 0.3, 1e-4, 8e-4, 8e-3)
MEBIBYTE = 2**20
ROLLING = Regime(False, (False,) * 3, (1.0,) * 3)
FLOW_SCRIPT = """
from dynamics.equations import DiskConstants
from dynamics.integrators.codegen import compile_branch
from dynamics.regime import Branch, Regime
rolling = Regime(False, (False,) * 3, (1.0,) * 3)
constants = DiskConstants(0.17, 1.0, 0.5, 0.3, 1e-4, 8e-4, 8e-3)
print(compile_branch(Branch.of(rolling, constants, None)).flow.cache_hits)
"""
RUN_SCRIPT = """
import sys
from numba.core.event import install_recorder
from sonify import load_scene, pipeline
with install_recorder("numba:compile") as recorder:
    pipeline.solve(load_scene(sys.argv[1]).replace("numerics.time_limit=0.5"), "draft")
print(len(recorder.buffer))
"""


@pytest.fixture(params=INTEGRATORS)
def integrator(request):
    if request.param == "taylor":
        pytest.importorskip("heyoka", reason="heyoka is not installed")
    return request.param


@pytest.fixture
def impatient():
    """Let threads switch a hundred times as often as by default."""
    before = sys.getswitchinterval()
    sys.setswitchinterval(5e-5)
    yield
    sys.setswitchinterval(before)


def written(motion) -> bytes:
    return (
        motion.path.x.tobytes()
        + motion.path.c.tobytes()
        + motion.regime_of_piece.tobytes()
    )


@pytest.mark.parametrize("threads", [2, 4])
def test_threads_write_the_same_bytes(integrator, impatient, threads):
    numerics = {"integrator": integrator, "time_limit": 2.0}
    scenes = [
        scene(numerics, k2=k2, mu_static=mu)
        for k2, mu in ((8e-4, 0.4), (2e-3, 0.35), (4e-4, 0.31))
    ] * 2
    with ThreadPoolExecutor(threads) as pool:
        together = list(pool.map(simulate, scenes))
    alone = [simulate(one) for one in scenes[:3]] * 2
    assert len(alone[0].transitions) > 10
    assert [written(motion) for motion in together] == [
        written(motion) for motion in alone
    ]


def numbers(i: int, integrator: str):
    """Return a scene in which every number depends on i."""
    return whirling(
        0.2 + 1e-3 * i,
        disk={"radius": 0.03 + 1e-4 * i, "thickness": 0.01 + 1e-5 * i},
        numerics={"integrator": integrator, "time_limit": 0.02},
        dissipation={
            "power_coefficient": 1e-9 * (i + 1),
            "power_exponent": 2.2 + 0.013 * i,
            "viscous_force": 1e-6 * i,
        },
    )


def test_scenes_of_other_numbers_compile_nothing_and_leave_nothing_behind(integrator):
    name = {"taylor": "compiled_taylor_future", "dop853": "compile_branch"}[integrator]
    compiled = chosen_integrator(integrator)[1].__globals__[name]
    process = Process()
    ends = set()
    misses = []
    used = []
    for i in range(1, 52):
        ends.add(simulate(numbers(i, integrator)).state[-1, 10])
        misses.append(compiled.cache_info().misses)
        used.append(process.memory_info().rss)
    assert len(ends) == 51
    assert misses[0] == misses[-1]
    assert used[-1] - used[10] < 5 * MEBIBYTE


@dataclass(frozen=True)
class Drag(OwnLaw):
    factor: float
    axis: str = "M2"

    def __call__(self, beta, omega, slip, law, flow):
        return Loads(**{self.axis: -self.factor * omega[1]})


def test_numbers_of_a_law_of_ones_own_are_not_compiled_in(integrator):
    name = {"taylor": "compiled_taylor_future", "dop853": "compile_branch"}[integrator]
    compiled = chosen_integrator(integrator)[1].__globals__[name]
    ends = []
    for factor in (1e-3, 2e-3):
        ends.append(simulate(numbers(1, integrator), loads=Drag(factor)).state[-1, 10])
        misses = compiled.cache_info().misses
    simulate(numbers(1, integrator), loads=Drag(3e-3))
    assert compiled.cache_info().misses == misses
    assert ends[1] == pytest.approx(2 * ends[0], rel=0.01)


def test_what_most_motions_need_is_compiled_before_they_ask():
    taylor = pytest.importorskip(
        "dynamics.integrators.taylor", reason="heyoka is not installed"
    )
    wanted = scene(
        {"tolerance": 1e-10, "time_limit": 1.5, "integrator": "taylor"},
        dissipation={"viscous_force": 1e-9},
    )
    before = taylor.compiled_taylor_future.cache_info().misses
    compile_in_background(plan_motion(wanted))
    assert taylor.compiled_taylor_future.cache_info().misses == before + 2
    assert {t.after for t in simulate(wanted).transitions} == {"roll", "slide"}
    assert taylor.compiled_taylor_future.cache_info().misses == before + 2


def test_a_second_process_compiles_no_flow(tmp_path):
    environment = os.environ | {"NUMBA_CACHE_DIR": str(tmp_path)}
    command = [sys.executable, "-c", FLOW_SCRIPT]
    hits = [
        subprocess.check_output(command, env=environment, text=True) for _ in range(2)
    ]
    assert hits == ["0\n", "1\n"]


@pytest.mark.slow
@pytest.mark.parametrize("name", ["toy", "glass-plate"])
def test_a_later_run_compiles_no_kernel(name):
    """Another process may replace the index of the cache meanwhile, hence a third run."""
    command = [sys.executable, "-c", RUN_SCRIPT, name]
    compiled = (int(subprocess.check_output(command, text=True)) for _ in range(3))
    assert 0 in compiled


def test_flows_compile_where_no_cache_can_be_written(tmp_path, monkeypatch):
    file = tmp_path / "file"
    file.touch()
    monkeypatch.setattr(codegen.config, "CACHE_DIR", str(file / "folder"))
    flow, _ = codegen.compile_branch.__wrapped__(Branch.of(ROLLING, LAW, None))
    assert flow.cache_hits == 0
    assert list(tmp_path.iterdir()) == [file]


def test_a_wait_for_the_compiler_is_announced(integrator):
    told = []
    simulate(
        scene({"time_limit": 1.5, "integrator": integrator}),
        lambda t, _, doing: told.append((t, doing)),
    )
    assert told[0] == (0.0, "compiling the flow of 'roll'")
    assert [doing for _, doing in told if doing] == [
        f"compiling the flow of '{kind}'" for kind in ("roll", "slide")
    ]
    assert told[-1] == (pytest.approx(1.5), "")


def test_a_series_that_is_not_finite_stops_the_run(integrator):
    lost = [0.7, 0.0, 0.2, float("nan"), *[0.0] * 7]
    with pytest.raises(StalledError, match="nan"):
        chosen_integrator(integrator)[1](lost, ROLLING, LAW, None, 1e-5, 1.0, 1e-12)
