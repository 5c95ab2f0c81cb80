"""Measure time and memory of a sweep of motions with one and with two processes.

Run as `python -m benchmarks.speed.sweep_speed [RUNS]`. The script also prints the load
average of the machine."""

import os
import sys
import threading
import time
from tempfile import TemporaryDirectory

import numpy as np
import psutil

import sonify
from sonify.sweeps.store import read_table

AXES = {"friction.arm_rolling": {"from": 2.5e-5, "to": 6e-5, "n": 0}}


def main(runs):
    """Print seconds, speed-up, resident memory, and bytes per row."""
    elapsed = {}
    for processes in (1, 2):
        memory_samples = []
        finished = threading.Event()
        sampler = threading.Thread(
            target=sample_memory, args=(memory_samples, finished)
        )
        sampler.start()
        with TemporaryDirectory() as folder:
            axes = {key: given | {"n": runs} for key, given in AXES.items()}
            began = time.perf_counter()
            sweep = {
                "name": "speed",
                "accuracy": "draft",
                "find": ["motion"],
                "axes": axes,
            }
            path = sonify.sweep(sweep, out=folder, processes=processes)
            elapsed[processes] = time.perf_counter() - began
            finished.set()
            sampler.join()
            rows = read_table(path)[0]
            table_size = path.stat().st_size
        quarters = np.array_split(np.array(memory_samples), 4)
        second_quarter = np.median(quarters[1]) / 2**20
        last_quarter = np.median(quarters[3]) / 2**20
        run_seconds = np.median(rows["seconds"].to_numpy())
        print(
            f"{processes} processes: {runs} runs in {elapsed[processes]:.1f} s, {run_seconds:.3f} "
            f"s per run (median), "
            f"{second_quarter:.0f} MiB in the second quarter, {last_quarter:.0f} MiB in the last, "
            f"{table_size / runs:.0f} bytes per row, load {os.getloadavg()[0]:.1f}"
        )
    print(f"speed-up {elapsed[1] / elapsed[2]:.2f}")


def sample_memory(samples, finished):
    """Append the resident memory [bytes] of this process and its children to `samples`
    five times per second."""
    process = psutil.Process()
    while not finished.wait(0.2):
        processes = [process, *process.children(recursive=True)]
        samples.append(sum(p.memory_info().rss for p in processes if p.is_running()))


if __name__ == "__main__":
    main(int(sys.argv[1]) if len(sys.argv) > 1 else 1000)
