"""How long a sweep of motions takes on one and on two processes, and what memory they hold: python
tests/benchmarks/sweep_speed.py [RUNS]. The load that others put on the machine is printed with it."""

import os
import sys
import threading
import time
from tempfile import TemporaryDirectory

import numpy as np
import psutil

import sonify
from sonify.sweeps.table import read_table

AXES = {"friction.arm_rolling": {"from": 2.5e-5, "to": 6e-5, "n": 0}}


def main(runs):
    """Print seconds, speed-up, memory and bytes."""
    spent = {}
    for processes in (1, 2):
        sizes, over = [], threading.Event()
        watch = threading.Thread(target=memory, args=(sizes, over))
        watch.start()
        with TemporaryDirectory() as folder:
            axes = {key: given | {"n": runs} for key, given in AXES.items()}
            began = time.perf_counter()
            asked = {"name": "speed", "accuracy": "draft", "find": ["motion"], "axes": axes}
            path = sonify.sweep(asked, out=folder, processes=processes)
            spent[processes] = time.perf_counter() - began
            over.set()
            watch.join()
            rows, size = read_table(path)[0], path.stat().st_size
        first, last = (np.median(part) / 2**20 for part in np.array_split(np.array(sizes), 4)[1::2])
        own = np.median(rows["seconds"].to_numpy())
        print(
            f"{processes} processes: {runs} runs in {spent[processes]:.1f} s, {own:.3f} s a run (median), "
            f"{first:.0f} MiB in the second quarter, {last:.0f} MiB in the last, {size / runs:.0f} bytes a row, "
            f"load {os.getloadavg()[0]:.1f}"
        )
    print(f"speed-up {spent[1] / spent[2]:.2f}")


def memory(sizes, over):
    """Note the resident memory [bytes] of this process and those below it, five times a second."""
    me = psutil.Process()
    while not over.wait(0.2):
        alive = [me, *me.children(recursive=True)]
        sizes.append(sum(one.memory_info().rss for one in alive if one.is_running()))


if __name__ == "__main__":
    main(int(sys.argv[1]) if len(sys.argv) > 1 else 1000)
