"""The whole published run to inclination 1e-9, warm: python tests/benchmarks/motion_speed.py

Prints the time and the processor time of our Taylor series and of the same event-driven model on scipy's solve_ivp with
DOP853, and when each run ends. After tau = 150 the motion amplifies rounding, so that only the ends can be compared.
"""

from time import perf_counter, process_time

from dynamics.hybrid import drive
from dynamics.rolling import RollingDisk
from dynamics.simulation import chosen_integrator
from sonify.charts.event_driven import integrator_of
from sonify.charts.motion_case import PUBLISHED, RELEASED, scaled

RUNS = {
    "Taylor (heyoka), tol 1e-16": (chosen_integrator("taylor")[1], 1e-16),
    "Taylor (heyoka), tol 1e-12": (chosen_integrator("taylor")[1], 1e-12),
    "our DOP853, tol 1e-12": (chosen_integrator("dop853")[1], 1e-12),
    "solve_ivp DOP853, tol 1e-12": (integrator_of("DOP853"), 1e-12),
}


def timed(integrate, tolerance):
    """Return time, processor time and end of one run."""
    system = RollingDisk(PUBLISHED, None, 1e-9**0.5, integrate, tolerance)
    began, busy = perf_counter(), process_time()
    path, ended = drive(system, scaled(RELEASED), 1000.0)
    return perf_counter() - began, process_time() - busy, f"{ended} at tau = {path.t:.3f}"


if __name__ == "__main__":
    first = None
    for name, (integrate, tolerance) in RUNS.items():
        if "Taylor" in name:
            timed(integrate, tolerance)
        elapsed, busy, end = timed(integrate, tolerance)
        first = first or busy
        print(f"{name:28} {elapsed:8.3f} s, processor {busy:8.3f} s ({busy / first:.1f} times), {end}", flush=True)
