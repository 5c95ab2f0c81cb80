"""Time the whole published motion to inclination 1e-9, warm: python -m
benchmarks.speed.motion_speed

The script prints elapsed time, processor time and end of the run for our Taylor series
and for the same event-driven model on scipy's solve_ivp with DOP853. It then prints the
Taylor series for static friction close to or equal to the dynamic one. After tau = 150
the motion amplifies round-off, so that only the ends are comparable."""

from time import perf_counter, process_time

from benchmarks.cases.motion_case import PUBLISHED_LAW, PUBLISHED_RELEASE, scaled
from benchmarks.methods.event_driven import resolved_integrator_name
from dynamics.hybrid import run_events
from dynamics.rolling import RollingDisk
from dynamics.simulation import chosen_integrator

RUNS = {
    "Taylor (heyoka), tol 1e-16": (chosen_integrator("taylor")[1], 1e-16),
    "Taylor (heyoka), tol 1e-12": (chosen_integrator("taylor")[1], 1e-12),
    "our DOP853, tol 1e-12": (chosen_integrator("dop853")[1], 1e-12),
    "solve_ivp DOP853, tol 1e-12": (resolved_integrator_name("DOP853"), 1e-12),
}


def timed(integrate, tolerance, law=PUBLISHED_LAW):
    """Return elapsed time [s], processor time [s] and end of one run."""
    system = RollingDisk(law, None, 1e-9**0.5, integrate, tolerance)
    began = perf_counter()
    processor_before = process_time()
    path, ended = run_events(system, scaled(PUBLISHED_RELEASE), 1000.0)
    end = f"{ended} at tau = {path.t:.3f}, {len(path.crossings)} changes"
    return perf_counter() - began, process_time() - processor_before, end


def nearly_equal(ratio):
    """Return the published law with another ratio of static to dynamic friction."""
    return PUBLISHED_LAW._replace(mu_static=ratio * PUBLISHED_LAW.mu_dynamic)


if __name__ == "__main__":
    first = None
    for name, (integrate, tolerance) in RUNS.items():
        if "Taylor" in name:
            timed(integrate, tolerance)
        elapsed, busy, end = timed(integrate, tolerance)
        first = first or busy
        print(
            f"{name:28} {elapsed:8.3f} s, processor {busy:8.3f} s ({busy / first:.1f} times), "
            f"{end}",
            flush=True,
        )
    for ratio in (1.1, 1.03, 1.0):
        for _ in range(2):  # the first run compiles
            elapsed, busy, end = timed(
                *RUNS["Taylor (heyoka), tol 1e-16"], nearly_equal(ratio)
            )
        name = f"friction ratio {ratio}"
        print(
            f"{name:28} {elapsed:8.3f} s, processor {busy:8.3f} s ({busy / first:.1f} times), {end}"
        )
