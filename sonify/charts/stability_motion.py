"""Where motions fail: small inclinations, small slips, moments that stick."""

from functools import partial

from sonify.charts import event_driven
from sonify.charts.moreau import moreau
from sonify.charts.motion_case import (
    INCLINATIONS,
    NUTATION_ARMS,
    PIVOTING_ARMS,
    flat,
    nutation_arm,
    pivoting_arm,
    published,
)
from sonify.charts.naive import euler_angles, naive_sign
from sonify.charts.records import Work, ends
from sonify.charts.regularised import tanh_regularised
from sonify.charts.slip_tolerance import slip_tolerance

OURS = {
    ("ours", "Taylor series"): (event_driven.ours, "taylor", 1e-16),
    ("ours", "DOP853"): (event_driven.ours, "dop853", 1e-12),
}
ROLLING = OURS | {
    ("naive sign()", "RK45, tol 1e-8"): (naive_sign, "RK45", 1e-8),
    ("naive sign()", "LSODA, tol 1e-8"): (naive_sign, "LSODA", 1e-8),
    ("Euler angles", "DOP853, tol 1e-12"): (euler_angles, 1e-12),
    ("Moreau", "step 1e-3"): (moreau, 1e-3),
    ("Moreau", "step 1e-5"): (moreau, 1e-5),
}
STICKING = OURS | {
    ("event-driven", "solve_ivp DOP853, tol 1e-12"): (event_driven.with_solve_ivp, "DOP853", 1e-12),
    ("event-driven", "solve_ivp DOP853, tol 1e-6"): (event_driven.with_solve_ivp, "DOP853", 1e-6),
    **{("naive sign()", f"{m}, tol 1e-8"): (naive_sign, m, 1e-8) for m in ("RK45", "DOP853", "LSODA", "Radau", "BDF")},
    ("slip tolerance", "1e-4"): (slip_tolerance, 1e-4, 1e-4, 0.01, 1e-9),
    ("tanh", "LSODA, width 1e-3"): (tanh_regularised, "LSODA", 1e-3, 1e-6),
    ("tanh", "LSODA, width 1e-6"): (tanh_regularised, "LSODA", 1e-6, 1e-9),
    ("Moreau", "step 1e-2"): (moreau, 1e-2),
    ("Moreau", "step 1e-3"): (moreau, 1e-3),
}
PATHS = {
    "small inclination": (flat, INCLINATIONS, ROLLING),
    "nutation sticks": (nutation_arm, NUTATION_ARMS, STICKING),
    "pivoting sticks": (pivoting_arm, PIVOTING_ARMS, STICKING),
}
"""Hazard: case of a parameter, the parameters, the methods."""
RESOLUTIONS = (1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-10, 1e-12)
"""Slip speeds, over R/chi, at which rolling and sliding are told apart, or the tolerances that stand for them."""
ALLOWED = 1e-9
"""Tolerance that scenes do not let the integrators of `dynamics` exceed."""
FINEST = 1e-13
"""Tolerance that solve_ivp bears."""
RESOLVED = {
    ("ours", "Taylor series, tolerance"): lambda case, x: event_driven.ours(case, "taylor", x),
    ("ours", "DOP853, tolerance"): lambda case, x: event_driven.ours(case, "dop853", x),
    ("event-driven", "solve_ivp DOP853, tolerance"): lambda case, x: event_driven.with_solve_ivp(case, "DOP853", x),
    ("slip tolerance", "starts and ends slides"): lambda case, x: slip_tolerance(case, x, x, 0.01, 1e-9),
    ("slip tolerance", "1e-5 starts them"): lambda case, x: slip_tolerance(case, max(x, 1e-5), x, 0.1, 1e-6),
    ("tanh", "LSODA, width"): lambda case, x: tanh_regularised(case, "LSODA", x, max(1e-3 * x, FINEST)),
    ("tanh", "Radau, width"): lambda case, x: tanh_regularised(case, "Radau", x, max(1e-2 * x, FINEST)),
}


def works(quick: bool) -> list[Work]:
    """Return every run; `quick` keeps both ends of the paths, and one kind of sticking."""
    runs = []
    for hazard, (case_of, parameters, methods) in PATHS.items():
        if quick and hazard == "pivoting sticks":  # the same methods as where the nutation sticks
            continue
        for about, (function, *arguments) in methods.items():
            for x in ends(parameters, quick):
                case = case_of(x)
                runs.append(Work(*about, f"{x:g}", hazard, partial(function, case, *arguments), case.error))
    case = published(10.0)
    for about, function in RESOLVED.items():
        allowed = [x for x in RESOLUTIONS if about[0] != "ours" or x <= ALLOWED]
        for x in ends(allowed, quick):
            runs.append(Work(*about, f"{x:g}", "small slip", partial(function, case, x), case.error))
    return runs
