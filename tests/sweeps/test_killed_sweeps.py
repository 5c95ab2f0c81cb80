"""Claim: if any process of a sweep is killed at any moment without warning, the same command
resumes and ends with the table of an undisturbed sweep; a cluster on the loopback gives the results
of the local machine.

Source: the README's `sweep`. Oracle: the table of an undisturbed sweep, value by value; real
processes that are really killed.
"""

import os
import signal
import socket
import subprocess
import sys
import time
from contextlib import contextmanager

import psutil
import pytest
import tomli_w
from paths import ROOT
from sweep_files import QUICK, found

import sonify
from sonify.scene_errors import InputError
from sonify.sweeps.executors import WORKERS_LOST_MESSAGE
from sonify.sweeps.store import RUNS_FILE
from sonify.sweeps.version import version

pytestmark = pytest.mark.slow
LONG = QUICK | {
    "axes": QUICK["axes"]
    | {"friction.arm_rolling": {"from": 1e-3, "to": 3e-3, "n": 48}}
}
WORKER = "sonify.sweeps.worker_loop"
PATIENCE = 120.0


@pytest.fixture(scope="module")
def truth(tmp_path_factory):
    return found(sonify.sweep(LONG, out=tmp_path_factory.mktemp("truth")))


@pytest.fixture
def file(tmp_path):
    (tmp_path / "long.toml").write_text(tomli_w.dumps(LONG))
    return tmp_path / "long.toml"


def until(true, what):
    """Wait until true() returns a true value, and return it."""
    end = time.monotonic() + PATIENCE
    while not (answer := true()):
        assert time.monotonic() < end, what
        time.sleep(0.02)
    return answer


def start(module, *arguments):
    call = [sys.executable, "-m", module, *map(str, arguments)]
    environment = os.environ | {"PYTHONPATH": str(ROOT)}
    ours = signal.signal(
        signal.SIGINT, signal.default_int_handler
    )  # the parent may ignore SIGINT
    try:
        return subprocess.Popen(
            call,
            env=environment,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
        )
    finally:
        signal.signal(signal.SIGINT, ours)


@contextmanager
def begun(file, *options, rows=5):
    """Yield the driver process of a sweep in progress."""
    out = file.parent / "out"
    driver = start("sonify", "sweep", file, "--out", out, *options)
    try:
        until(lambda: driver.poll() is not None or _written(out) > rows, "rows")
        assert driver.poll() is None, driver.communicate()
        yield driver
    finally:
        driver.kill()
        driver.communicate()


def _written(folder):
    """Return the number of rows in the table so far."""
    return found(folder / RUNS_FILE).num_rows if (folder / RUNS_FILE).exists() else 0


def workers(process):
    """Return the worker processes started by a process or its descendants."""
    below = psutil.Process(process.pid).children(recursive=True)
    return [one for one in below if WORKER in one.cmdline()]


def test_a_killed_driver(file, truth):
    with begun(file) as driver:
        left = workers(driver)
        driver.kill()
        until(
            lambda: (
                not any(
                    one.is_running() and one.status() != psutil.STATUS_ZOMBIE
                    for one in left
                )
            ),
            "orphans",
        )
    assert len(left) > 0
    assert found(sonify.sweep(file, out=file.parent / "out")).equals(truth)


def test_a_killed_process_that_solves(file, truth):
    with begun(file) as driver:
        workers(driver)[0].kill()
        _, told = driver.communicate(timeout=PATIENCE)
    assert driver.returncode == 0, told
    assert found(file.parent / "out" / RUNS_FILE).equals(truth)


def test_an_interrupted_driver_keeps_its_rows(file, truth):
    with begun(file) as driver:
        driver.send_signal(signal.SIGINT)
        assert (
            driver.communicate(timeout=PATIENCE)[1].splitlines()[-1]
            == "sonify: interrupted"
        )
    assert driver.returncode == 130
    assert 5 <= found(file.parent / "out" / RUNS_FILE).num_rows < truth.num_rows
    assert found(sonify.sweep(file, out=file.parent / "out")).equals(truth)


@pytest.fixture
def port():
    pytest.importorskip("distributed", reason="needs the extra `cluster`")
    with socket.socket() as one:
        one.bind(("127.0.0.1", 0))
        return one.getsockname()[1]


@contextmanager
def cluster(port, folder):
    """Yield the address, the scheduler and two workers."""
    address = f"tcp://127.0.0.1:{port}"
    scheduler = ["scheduler", "--host", "127.0.0.1", "--port", port, "--no-dashboard"]
    worker = [
        "worker",
        address,
        "--nthreads",
        1,
        "--no-dashboard",
        "--no-nanny",
        "--local-directory",
        folder,
    ]
    processes = [start("dask", *what) for what in (scheduler, worker, worker)]
    try:
        _answering(address)
        yield address, processes
    finally:
        for process in processes:
            process.kill()
            process.communicate()


def _answering(address):
    from distributed import Client

    def two():
        with Client(address, timeout=PATIENCE) as client:
            return len(client.scheduler_info()["workers"]) == 2

    until(two, "workers")


def test_a_cluster_finds_what_this_machine_finds_even_if_a_worker_is_killed(
    file, truth, port
):
    with (
        cluster(port, file.parent) as (address, processes),
        begun(file, "--scheduler", address) as driver,
    ):
        processes[1].kill()
        _, told = driver.communicate(timeout=PATIENCE)
    assert driver.returncode == 0, told
    assert found(file.parent / "out" / RUNS_FILE).equals(truth)


def test_a_killed_scheduler_and_a_killed_driver_of_a_cluster(file, truth, port):
    with (
        cluster(port, file.parent) as (address, processes),
        begun(file, "--scheduler", address) as driver,
    ):
        processes[0].kill()
        _, told = driver.communicate(timeout=PATIENCE)
        assert driver.returncode == 1, told
        assert told.splitlines()[-1].startswith(f"sonify: {WORKERS_LOST_MESSAGE}:")
    kept = found(file.parent / "out" / RUNS_FILE).num_rows
    assert 5 <= kept < truth.num_rows
    with cluster(port, file.parent) as (address, processes):
        with begun(file, "--scheduler", address) as driver:
            driver.kill()
        assert found(
            sonify.sweep(file, scheduler=address, out=file.parent / "out")
        ).equals(truth)


def test_a_cluster_without_workers_is_one_line(file, port):
    """The scheduler answers but has no worker; without the error the user would wait for ever."""
    scheduler = start(
        "dask", "scheduler", "--host", "127.0.0.1", "--port", port, "--no-dashboard"
    )
    address = f"tcp://127.0.0.1:{port}"
    try:
        until(lambda: _listens(port), "scheduler")
        options = ("--out", file.parent / "out", "--scheduler", address)
        driver = start("sonify", "sweep", file, *options)
        told = driver.communicate(timeout=PATIENCE)[1].splitlines()
    finally:
        scheduler.kill()
        scheduler.communicate()
    fault = f"sonify: --scheduler {address}: no worker within 5 s; start one with: "
    assert (driver.returncode, told) == (2, [f"{fault}dask worker {address}"])
    assert not (file.parent / "out").exists()


def _listens(port):
    with socket.socket() as one:
        return one.connect_ex(("127.0.0.1", port)) == 0


def test_a_scheduler_that_does_not_answer_or_has_other_workers_is_one_line(
    file, port, monkeypatch
):
    began = time.monotonic()
    with pytest.raises(InputError, match="no scheduler answers"):
        sonify.sweep(file, scheduler=f"tcp://127.0.0.1:{port}", out=file.parent / "out")
    assert time.monotonic() - began < 10
    with cluster(port, file.parent) as (address, _):
        monkeypatch.setattr("sonify.__version__", "0.0.9")
        version.cache_clear()
        with pytest.raises(InputError, match="has another version of the program"):
            sonify.sweep(file, scheduler=address, out=file.parent / "out")
    version.cache_clear()
    assert not (file.parent / "out").exists()
