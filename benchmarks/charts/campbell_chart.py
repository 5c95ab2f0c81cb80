"""Draw the Campbell diagram of a disk on one table mode, and measure its flutter by the
two-way steps."""

from functools import cache

import numpy as np
from matplotlib.figure import Figure

from benchmarks.charts.chart_page import number
from benchmarks.charts.error_time_picture import DPI, save
from benchmarks.methods.campbell import CampbellDiagram, campbell_diagram
from benchmarks.timed_runs import (
    Answer,
    Failure,
    Record,
    measured,
    most_accurate,
    selected_values,
    works_over,
)
from dynamics.compliant.law.linearised import inertias
from dynamics.compliant.law.tabulated import TabulatedLaw
from dynamics.compliant.model_inputs import contact_law
from dynamics.compliant.state_conversion import columns, preloaded_compliant_state
from dynamics.compliant.stepping.model import CompliantModel
from dynamics.compliant.stepping.state_layout import STATE
from dynamics.disk import Friction
from dynamics.surface import ModesSurface, SurfaceMode
from modal.tabletop.solve import table_modes_listed_in_scene
from sonify.scene import load_scene

PROBLEM = r"""
A smooth disk precesses steadily at the rate $\Omega$ on one mode of a table, of order $n$ and angular frequency $w$. In
the frame of the contact the linear equations have constant coefficients, which depend on $x = n\Omega/w$. Their
eigenvalues belong to the nutation and to the waves that travel with and against the contact. The two-way steps are
assessed by the growth rate of a nutation, excited with a relative amplitude of $10^{-4}$, at the strongest flutter.
"""
MODE = SurfaceMode(order=2, frequency=150.0, damping_ratio=0.005, modal_mass=50.0)

FLUTTER_SPEED = 2 / (2 - 0.786)
"""Value of x at which the wave travelling against the contact has the nutation
frequency."""

SPEEDS = np.linspace(0.3, 2.2, 951)
"""Values of x in the diagram."""

NUTATION_KICK = 1e-4
"""Initial nutation rate, divided by precession rate times inclination."""

REVOLUTIONS = 40
"""Number of revolutions of the contact in a run."""

EARLY_WINDOW = (0.35, 0.6)
LATE_WINDOW = (0.7, 0.95)
"""Fractions of the duration at which amplitudes are compared for the growth rate."""


@cache
def contact_table() -> TabulatedLaw:
    """Return the tabulated contact law of the published scene, without loss."""
    return TabulatedLaw(law=contact_law(load_scene("published")), damping=0.0)


def growth_by_steps(mode: SurfaceMode, x: float, rate: float) -> complex:
    """Return growth rate and angular frequency [1/s] of the nutation at x as a complex
    number.

    The steps have the given rate [1/s].
    """
    disk = contact_table().law.disk
    smooth = Friction(mu_static=0.0, mu_dynamic=0.0)
    _, (omega,), (beta,), (values,) = campbell_diagram(disk, mode, x)
    modes = table_modes_listed_in_scene(
        ModesSurface(modes=(mode,)), disk, 2 * mode.frequency
    )
    model = CompliantModel(
        tabulated_law=contact_table(), friction=smooth, modes=modes, rate=rate
    )
    y = preloaded_compliant_state(
        model, np.array([0, beta, 0, 0, 0, 0, 0, omega * np.sin(beta), 0, 0, 0])
    )
    waves = model.supporting_modes(y)
    _kick_nutation(y, disk, NUTATION_KICK * omega * beta, beta)
    pieces = list(model.run(y, 4, REVOLUTIONS * 2 * np.pi / omega, modes=waves))
    t = np.concatenate([piece.t for piece in pieces])
    state = np.concatenate([piece.state for piece in pieces])
    nutation = columns(model, state)[:, 5]
    frequency = abs(values[values.real.argmax()].imag)
    early, early_amplitude = _amplitude(t, nutation, frequency, *EARLY_WINDOW)
    late, late_amplitude = _amplitude(t, nutation, frequency, *LATE_WINDOW)
    return np.log(late_amplitude / early_amplitude) / (late - early) + 1j * frequency


def _kick_nutation(y, disk, kick, beta):
    """Add a nutation rate `kick` [rad/s] to a state at inclination beta [rad]."""
    d = y[STATE.axis : STATE.axis + 2] / np.sin(beta)
    y[STATE.velocity : STATE.velocity + 3] = 0, 0, kick * disk.radius
    y[STATE.angular_momentum : STATE.angular_momentum + 2] += (
        inertias(disk)[0] * kick * np.array([d[1], -d[0]])
    )


def _amplitude(t, x, omega, begin, end):
    """Return the middle [s] of a part of the duration and the complex amplitude of x
    there at the frequency omega."""
    within = (t > begin * t[-1]) & (t <= end * t[-1])
    hann = np.hanning(np.count_nonzero(within)) * np.exp(-1j * omega * t[within])
    return (begin + end) / 2 * t[-1], hann @ (x[within] - x[within].mean()) / len(hann)


def expected_growth(mode: SurfaceMode, x: float) -> float:
    """Return the largest real part of the eigenvalues [1/s]."""
    return float(
        campbell_diagram(contact_table().law.disk, mode, x).eigenvalue.real.max()
    )


def _answer(rate):
    try:
        growth = growth_by_steps(MODE, FLUTTER_SPEED, rate).real
    except ValueError as error:
        raise Failure(
            "refused: a resonance of the contact turns too far in a step"
        ) from error
    return Answer(
        (growth,),
        int(REVOLUTIONS * MODE.order / (FLUTTER_SPEED * MODE.frequency) * rate),
    )


def _growth_error(values):
    """Return the relative error of the growth rate."""
    return abs(values[0] / expected_growth(MODE, FLUTTER_SPEED) - 1)


def run(quick: bool, watch=lambda fraction, note: None) -> list[Record]:
    """Return the records of the chart; `watch(fraction, note)` is called before every
    run."""
    rates = selected_values((1e4, 5e4, 1e5, 2e5, 4e5, 8e5), quick)
    works = works_over(
        "two ways",
        "discrete gradient",
        "{:g} 1/s",
        rates,
        _answer,
        "growth of the flutter",
        _growth_error,
        0.1,
    )
    return measured(works, watch, warm=lambda work: True)


def is_divergent(diagram: CampbellDiagram) -> np.ndarray:
    """Return (k,) True where a non-oscillating eigenvalue grows faster than the waves
    decay."""
    still = np.abs(diagram.eigenvalue.imag) < 1e-9 * diagram.omega[:, None]
    return (
        np.where(still, diagram.eigenvalue.real, 0.0).max(axis=1)
        > 2 * np.pi * MODE.frequency * MODE.damping_ratio
    )


def flutter_growth(diagram: CampbellDiagram) -> np.ndarray:
    """Return the largest growth rate (k,) [1/s] of the oscillating eigenvalues, 0 if
    none grows."""
    moves = np.abs(diagram.eigenvalue.imag) > 0.05 * diagram.omega[:, None]
    return np.where(moves, diagram.eigenvalue.real, 0.0).max(axis=1).clip(0)


def draw(records: list[Record], title: str, path):
    """Draw frequencies divided by Omega and growth rates against x, and mark the speed
    of the two-way runs."""
    diagram = campbell_diagram(contact_table().law.disk, MODE, SPEEDS)
    figure = Figure(figsize=(9, 9), dpi=DPI, layout="constrained")
    above, below = figure.subplots(2, 1, sharex=True)
    growth = diagram.eigenvalue.real
    rate = diagram.omega[:, None]
    up = diagram.eigenvalue.imag >= 0
    x = np.broadcast_to(SPEEDS[:, None], growth.shape)
    for part, colour, label in (
        (growth <= 0, "0.6", "decays"),
        (growth > 0, "#b5367a", "grows"),
    ):
        above.plot(
            x[part & up],
            (diagram.eigenvalue.imag / rate)[part & up],
            ".",
            ms=3,
            color=colour,
            label=label,
        )
        below.plot(x[part], growth[part], ".", ms=3, color=colour)
    for axes in (above, below):
        axes.axvline(1, ls=":", lw=1, color="k")
        axes.axvline(FLUTTER_SPEED, ls="--", lw=1, color="k")
    above.set(ylim=(0, 5), ylabel="angular frequency over Omega")
    above.legend(loc="upper right")
    below.plot(
        FLUTTER_SPEED,
        expected_growth(MODE, FLUTTER_SPEED),
        "o",
        mfc="none",
        ms=10,
        color="k",
        label="speed of the two-way runs",
    )
    below.set(
        xlabel="x = n Omega / w   (dotted: 1, dashed: n/(n - 0.786))",
        ylabel="growth rate [1/s]",
        ylim=(-40, 40),
    )
    below.legend(loc="upper right")
    mode = f"n = {MODE.order}, {MODE.frequency:g} Hz, damping ratio {MODE.damping_ratio:g}, {MODE.modal_mass:g} kg"
    figure.suptitle(f"{title}\n{mode}")
    save(figure, path)


def conclusion(records: list[Record]) -> list[str]:
    """Return sentences on the instability of the steady motion and the error of the
    two-way steps."""
    diagram = campbell_diagram(contact_table().law.disk, MODE, SPEEDS)
    divergent = SPEEDS[is_divergent(diagram)]
    growth = np.where(SPEEDS > 1.1, flutter_growth(diagram), 0.0)
    strongest = growth.argmax()
    lines = [
        f"From x = {divergent[0]:.3f} to {divergent[-1]:.3f} the steady motion diverges faster "
        f"than the waves decay. "
        f"The nutation flutters most at x = {SPEEDS[strongest]:.3f}, with a growth rate of "
        f"{growth[strongest]:.3g} "
        f"1/s; n/(n - 0.786) is {FLUTTER_SPEED:.3f}."
    ]
    if best := most_accurate(records):
        lines.append(
            f"The relative error of this growth rate by the two-way steps is {number(best.error)} "
            f"at {best.setting}."
        )
    return lines
