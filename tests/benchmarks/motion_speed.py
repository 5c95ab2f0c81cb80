"""The whole published run to inclination 1e-9, warm: python tests/benchmarks/motion_speed.py

Prints the time and the processor time of our Taylor series and of the same event-driven model on scipy's solve_ivp with
DOP853, and when each run ends; then the Taylor series where static friction is nearly or just the dynamic one. After
tau = 150 the motion amplifies rounding, so that only the ends can be compared.
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


def timed(integrate, tolerance, law=PUBLISHED):
    """Return time, processor time and end of one run."""
    system = RollingDisk(law, None, 1e-9**0.5, integrate, tolerance)
    began, busy = perf_counter(), process_time()
    path, ended = drive(system, scaled(RELEASED), 1000.0)
    end = f"{ended} at tau = {path.t:.3f}, {len(path.crossings)} changes"
    return perf_counter() - began, process_time() - busy, end


def nearly_equal(ratio):
    """Return the law in which static friction is so many times the dynamic one."""
    return PUBLISHED._replace(mu_static=ratio * PUBLISHED.mu_dynamic)


if __name__ == "__main__":
    first = None
    for name, (integrate, tolerance) in RUNS.items():
        if "Taylor" in name:
            timed(integrate, tolerance)
        elapsed, busy, end = timed(integrate, tolerance)
        first = first or busy
        print(f"{name:28} {elapsed:8.3f} s, processor {busy:8.3f} s ({busy / first:.1f} times), {end}", flush=True)
    for ratio in (1.1, 1.03, 1.0):
        for _ in range(2):  # the first asks the compiler
            elapsed, busy, end = timed(*RUNS["Taylor (heyoka), tol 1e-16"], nearly_equal(ratio))
        name = f"friction {ratio} times"
        print(f"{name:28} {elapsed:8.3f} s, processor {busy:8.3f} s ({busy / first:.1f} times), {end}")
