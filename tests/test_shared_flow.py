"""Claim: scenes that differ in numbers share what is compiled, threads share nothing that changes, memory stays flat.

Source: the numbers of a scene are arguments of the compiled flow; each run has an integrator of its own.
Oracle: the number of compilations; the same scenes solved one after the other, byte by byte; the process's memory.
"""

import sys
from concurrent.futures import ThreadPoolExecutor

import pytest
from psutil import Process
from scenes import scene, whirling

from dynamics import simulate
from dynamics.simulation import chosen_integrator

INTEGRATORS = ["taylor", "dop853"]
MEBIBYTE = 2**20


@pytest.fixture(params=INTEGRATORS)
def integrator(request):
    if request.param == "taylor":
        pytest.importorskip("heyoka", reason="heyoka is not installed")
    return request.param


@pytest.fixture
def impatient():
    """Let threads take turns a hundred times as often as they do."""
    before = sys.getswitchinterval()
    sys.setswitchinterval(5e-5)
    yield
    sys.setswitchinterval(before)


def written(motion) -> bytes:
    return motion.path.x.tobytes() + motion.path.c.tobytes() + motion.regime_of_piece.tobytes()


@pytest.mark.parametrize("threads", [2, 4])
def test_threads_write_the_same_bytes(integrator, impatient, threads):
    numerics = {"integrator": integrator, "time_limit": 2.5}
    scenes = [scene(numerics, k2=k2, mu_static=mu) for k2, mu in ((8e-4, 0.4), (2e-3, 0.35), (4e-4, 0.31))] * 3
    with ThreadPoolExecutor(threads) as pool:
        together = list(pool.map(simulate, scenes))
    alone = [simulate(one) for one in scenes[:3]] * 3
    assert len(alone[0].transitions) > 10
    assert [written(motion) for motion in together] == [written(motion) for motion in alone]


def numbers(i: int, integrator: str):
    """A scene whose every number depends on i."""
    return whirling(
        0.2 + 1e-3 * i,
        disk={"radius": 0.03 + 1e-4 * i, "thickness": 0.01 + 1e-5 * i},
        numerics={"integrator": integrator, "time_limit": 0.02},
        dissipation={"power_coefficient": 1e-9 * (i + 1), "power_exponent": 2.2 + 0.013 * i, "viscous_force": 1e-6 * i},
    )


def test_scenes_of_other_numbers_compile_nothing_and_leave_nothing_behind(integrator):
    compiled, process = chosen_integrator(integrator)[1].__globals__["compiled"], Process()
    ends, misses, used = set(), [], []
    for i in range(1, 52):
        ends.add(simulate(numbers(i, integrator)).state[-1, 10])
        misses.append(compiled.cache_info().misses)
        used.append(process.memory_info().rss)
    assert len(ends) == 51
    assert misses[0] == misses[-1]
    assert used[-1] - used[10] < 5 * MEBIBYTE
