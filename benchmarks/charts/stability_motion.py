"""Test methods for the motion at small inclinations, small slip speeds and sticking
rotations."""

from functools import partial

from benchmarks.cases.motion_case import (
    NUTATION_ARMS,
    PIVOTING_ARMS,
    SMALL_INCLINATIONS,
    nearly_flat,
    nutation_arm,
    pivoting_arm,
    published,
)
from benchmarks.methods import event_driven
from benchmarks.methods.moreau_time_stepping import moreau
from benchmarks.methods.sign_friction import euler_angles, naive_sign
from benchmarks.methods.slip_tolerance import slip_tolerance
from benchmarks.methods.tanh_friction import tanh_regularised
from benchmarks.timed_runs import Work, selected_values

OUR_METHODS = {
    ("ours", "Taylor series"): (event_driven.ours, "taylor", 1e-16),
    ("ours", "DOP853"): (event_driven.ours, "dop853", 1e-12),
}
ROLLING_METHODS = OUR_METHODS | {
    ("naive sign()", "RK45, tol 1e-8"): (naive_sign, "RK45", 1e-8),
    ("naive sign()", "LSODA, tol 1e-8"): (naive_sign, "LSODA", 1e-8),
    ("Euler angles", "DOP853, tol 1e-12"): (euler_angles, 1e-12),
    ("Moreau", "step 1e-3"): (moreau, 1e-3),
    ("Moreau", "step 1e-5"): (moreau, 1e-5),
}
STICKING_METHODS = OUR_METHODS | {
    ("event-driven", "solve_ivp DOP853, tol 1e-12"): (
        event_driven.with_solve_ivp,
        "DOP853",
        1e-12,
    ),
    ("event-driven", "solve_ivp DOP853, tol 1e-6"): (
        event_driven.with_solve_ivp,
        "DOP853",
        1e-6,
    ),
    **{
        ("naive sign()", f"{m}, tol 1e-8"): (naive_sign, m, 1e-8)
        for m in ("RK45", "DOP853", "LSODA", "Radau", "BDF")
    },
    ("slip tolerance", "1e-4"): (slip_tolerance, 1e-4, 1e-4, 0.01, 1e-9),
    ("tanh", "LSODA, width 1e-3"): (tanh_regularised, "LSODA", 1e-3, 1e-6),
    ("tanh", "LSODA, width 1e-6"): (tanh_regularised, "LSODA", 1e-6, 1e-9),
    ("Moreau", "step 1e-2"): (moreau, 1e-2),
    ("Moreau", "step 1e-3"): (moreau, 1e-3),
}
MOTION_HAZARDS = {
    "small inclination": (nearly_flat, SMALL_INCLINATIONS, ROLLING_METHODS),
    "nutation sticks": (nutation_arm, NUTATION_ARMS, STICKING_METHODS),
    "pivoting sticks": (pivoting_arm, PIVOTING_ARMS, STICKING_METHODS),
}
"""Function from parameter value to case, values, and methods of each hazard of the
motion."""

SLIP_RESOLUTIONS = (1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-10, 1e-12)
"""Slip speeds [R/chi] that separate rolling from sliding, or tolerances with the same
role."""

MAX_SCENE_TOLERANCE = 1e-9
"""Largest tolerance of the integrators of `dynamics` allowed in a scene."""

MIN_TOLERANCE = 1e-13
"""Smallest tolerance accepted by solve_ivp."""

SLIP_METHODS = {
    ("ours", "Taylor series, tolerance"): lambda case, x: event_driven.ours(
        case, "taylor", x
    ),
    ("ours", "DOP853, tolerance"): lambda case, x: event_driven.ours(case, "dop853", x),
    ("event-driven", "solve_ivp DOP853, tolerance"): lambda case, x: (
        event_driven.with_solve_ivp(case, "DOP853", x)
    ),
    ("slip tolerance", "starts and ends slides"): lambda case, x: slip_tolerance(
        case, x, x, 0.01, 1e-9
    ),
    ("slip tolerance", "1e-5 starts them"): lambda case, x: slip_tolerance(
        case, max(x, 1e-5), x, 0.1, 1e-6
    ),
    ("tanh", "LSODA, width"): lambda case, x: tanh_regularised(
        case, "LSODA", x, max(1e-3 * x, MIN_TOLERANCE)
    ),
    ("tanh", "Radau, width"): lambda case, x: tanh_regularised(
        case, "Radau", x, max(1e-2 * x, MIN_TOLERANCE)
    ),
}


def works(quick: bool) -> list[Work]:
    """Return all runs; `quick` keeps the first and the last value of each parameter,
    and one kind of sticking."""
    runs = []
    for hazard, (case_of, parameters, methods) in MOTION_HAZARDS.items():
        if (
            quick and hazard == "pivoting sticks"
        ):  # the methods are those of the sticking nutation
            continue
        for about, (function, *arguments) in methods.items():
            for x in selected_values(parameters, quick):
                case = case_of(x)
                runs.append(
                    Work(
                        *about,
                        f"{x:g}",
                        hazard,
                        partial(function, case, *arguments),
                        case.error,
                    )
                )
    case = published(10.0)
    for about, function in SLIP_METHODS.items():
        allowed = [
            x
            for x in SLIP_RESOLUTIONS
            if about[0] != "ours" or x <= MAX_SCENE_TOLERANCE
        ]
        for x in selected_values(allowed, quick):
            runs.append(
                Work(
                    *about,
                    f"{x:g}",
                    "small slip",
                    partial(function, case, x),
                    case.error,
                )
            )
    return runs
