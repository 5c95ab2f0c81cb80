"""Errors of the motion by filter and one contact, as measured for the chart `contact-models`."""

import numpy as np

TABULATED_FORCE_RMS = (0.19, 0.29, 0.39, 0.49, 0.68, 0.97)
"""Rms of N'/weight of the cases on short waves in the chart `contact-models`."""

ERROR_BY_FORCE_RMS = {
    "filter": (0.007, 0.016, 0.029, 0.049, 0.077, 0.14),
    "full": (0.0031, 0.0065, 0.0089, 0.0082, 0.06, 0.13),
}
"""Errors of the motion at these rms."""

TABULATED_CURVATURE_NUMBERS = (0.05, 0.1, 0.2, 0.25, 0.3, 0.4)
"""Curvature numbers of the cases on long waves in the chart `contact-models`."""

ERROR_BY_CURVATURE = {
    "filter": (0.0004, 0.00073, 0.0033, 0.0093, 0.029, 0.39),
    "full": (0.0001, 0.0001, 0.0024, 0.0082, 0.027, 0.35),
}
"""Errors of the motion at these curvature numbers."""


def motion_error(model: str, force_rms: float, kappa: float) -> float:
    """Return the error of the motion by `model` at an rms of N'/weight and a curvature number.

    It is proportional to both below the cases of the chart, and constant above them.
    """
    by_rms = np.interp(
        force_rms, (0.0, *TABULATED_FORCE_RMS), (0.0, *ERROR_BY_FORCE_RMS[model])
    )
    by_curvature = np.interp(
        kappa, (0.0, *TABULATED_CURVATURE_NUMBERS), (0.0, *ERROR_BY_CURVATURE[model])
    )
    return float(max(by_rms, by_curvature))
