"""The Campbell diagram of a disk on one mode of a table, and the growth of its flutter by the steps of two ways."""

from functools import cache

import numpy as np
from matplotlib.figure import Figure

from dynamics.coupled.campbell import Campbell, campbell
from dynamics.coupled.from_scene import contact_law
from dynamics.coupled.full import Compliant
from dynamics.coupled.handover import columns, release
from dynamics.coupled.resonance import inertias
from dynamics.coupled.state import AXIS, MOMENTUM, VELOCITY
from dynamics.coupled.table import LawTable
from dynamics.disk import Friction
from dynamics.surface import ModesSurface, SurfaceMode
from modal.surface import table_by_modes
from sonify.charts.chart import DPI, save
from sonify.charts.page import number
from sonify.charts.records import Answer, Failure, Record, along, ends, measured, nearest
from sonify.scene import load_scene

PROBLEM = r"""
A smooth disk turns steadily over one mode of a table, of order $n$ and angular frequency $w$; seen from the contact,
$x = n\Omega/w$, the linear equations do not change with time. Their eigenvalues are those of the nutation and of the
waves with and against the contact. The steps of a table that acts back are judged by the rate at which a nutation,
kicked by a ten thousandth, grows where the flutter is strongest.
"""
MODE = SurfaceMode(order=2, frequency=150.0, damping_ratio=0.005, modal_mass=50.0)
FLUTTER = 2 / (2 - 0.786)
"""Where the wave that runs against the contact has the frequency of the nutation."""
SPEEDS = np.linspace(0.3, 2.2, 951)
KICK, TURNS = 1e-4, 40
"""Kick of the nutation, over the precession; turns of the contact that are looked at."""
EARLY, LATE = (0.35, 0.6), (0.7, 0.95)
"""Parts of that time whose amplitudes are compared."""


@cache
def law() -> LawTable:
    """Return the law of the contact of the published disk on granite, without loss."""
    return LawTable(law=contact_law(load_scene("published")), damping=0.0)


def grown(mode: SurfaceMode, x: float, rate: float) -> complex:
    """Return growth and angular frequency [1/s], as a complex number, of the nutation at x by `rate` steps a second."""
    disk, smooth = law().law.disk, Friction(mu_static=0.0, mu_dynamic=0.0)
    _, (omega,), (beta,), (values,) = campbell(disk, mode, x)
    modes = table_by_modes(ModesSurface(modes=(mode,)), disk, 2 * mode.frequency)
    model = Compliant(table=law(), friction=smooth, modes=modes, rate=rate)
    y = release(model, np.array([0, beta, 0, 0, 0, 0, 0, omega * np.sin(beta), 0, 0, 0]))
    waves, kick, d = model.waves(y), KICK * omega * beta, y[AXIS : AXIS + 2] / np.sin(beta)
    y[VELOCITY : VELOCITY + 3] = 0, 0, kick * disk.radius
    y[MOMENTUM : MOMENTUM + 2] += inertias(disk)[0] * kick * np.array([d[1], -d[0]])
    pieces = list(model.run(y, 4, TURNS * 2 * np.pi / omega, waves=waves))
    t, state = (np.concatenate([getattr(piece, part) for piece in pieces]) for part in ("t", "state"))
    nutation = columns(model, state)[:, 5]
    near = abs(values[values.real.argmax()].imag)
    (a, first), (b, last) = (_amplitude(t, nutation, near, *part) for part in (EARLY, LATE))
    return np.log(last / first) / (b - a) + 1j * near


def _amplitude(t, x, omega, begin, end):
    """Return the middle [s] of a part of the time, and the complex amplitude there of what turns about as omega."""
    some = (t > begin * t[-1]) & (t <= end * t[-1])
    hann = np.hanning(np.count_nonzero(some)) * np.exp(-1j * omega * t[some])
    return (begin + end) / 2 * t[-1], hann @ (x[some] - x[some].mean()) / len(hann)


def expected(mode: SurfaceMode, x: float) -> float:
    """Return the growth [1/s] of the eigenvalue that grows fastest."""
    return float(campbell(law().law.disk, mode, x).eigenvalue.real.max())


def _answer(rate):
    try:
        growth = grown(MODE, FLUTTER, rate).real
    except ValueError as error:
        raise Failure("refused: a resonance of the contact turns too far in a step") from error
    return Answer((growth,), int(TURNS * MODE.order / (FLUTTER * MODE.frequency) * rate))


def _off(values):
    return abs(values[0] / expected(MODE, FLUTTER) - 1)


def run(quick: bool, watch=lambda share, note: None) -> list[Record]:
    """Return the records of the chart; `watch(share, note)` is called before every run."""
    rates = ends((1e4, 5e4, 1e5, 2e5, 4e5, 8e5), quick)
    works = along("two ways", "discrete gradient", "{:g} 1/s", rates, _answer, "growth of the flutter", _off, 0.1)
    return measured(works, watch, warm=lambda work: True)


def diverges(diagram: Campbell) -> np.ndarray:
    """Return whether (k,) an eigenvalue without a frequency grows faster than the waves decay."""
    still = np.abs(diagram.eigenvalue.imag) < 1e-9 * diagram.omega[:, None]
    return np.where(still, diagram.eigenvalue.real, 0.0).max(axis=1) > 2 * np.pi * MODE.frequency * MODE.damping_ratio


def flutters(diagram: Campbell) -> np.ndarray:
    """Return the fastest growth (k,) [1/s] of what has a frequency, 0 of none."""
    moves = np.abs(diagram.eigenvalue.imag) > 0.05 * diagram.omega[:, None]
    return np.where(moves, diagram.eigenvalue.real, 0.0).max(axis=1).clip(0)


def draw(records: list[Record], title: str, path):
    """Draw frequencies over Omega and growths over x, and where the steps were judged."""
    seen = campbell(law().law.disk, MODE, SPEEDS)
    figure = Figure(figsize=(9, 9), dpi=DPI, layout="constrained")
    above, below = figure.subplots(2, 1, sharex=True)
    growth, rate = seen.eigenvalue.real, seen.omega[:, None]
    up = seen.eigenvalue.imag >= 0
    x = np.broadcast_to(SPEEDS[:, None], growth.shape)
    for part, colour, label in ((growth <= 0, "0.6", "decays"), (growth > 0, "#b5367a", "grows")):
        above.plot(x[part & up], (seen.eigenvalue.imag / rate)[part & up], ".", ms=3, color=colour, label=label)
        below.plot(x[part], growth[part], ".", ms=3, color=colour)
    for axes in (above, below):
        axes.axvline(1, ls=":", lw=1, color="k")
        axes.axvline(FLUTTER, ls="--", lw=1, color="k")
    above.set(ylim=(0, 5), ylabel="angular frequency over that of the contact")
    above.legend(loc="upper right")
    below.plot(FLUTTER, expected(MODE, FLUTTER), "o", mfc="none", ms=10, color="k", label="judged by the steps")
    below.set(xlabel="x = n Omega / w   (dotted: 1, dashed: n/(n - 0.786))", ylabel="growth [1/s]", ylim=(-40, 40))
    below.legend(loc="upper right")
    mode = f"n = {MODE.order}, {MODE.frequency:g} Hz, damping ratio {MODE.damping_ratio:g}, {MODE.modal_mass:g} kg"
    figure.suptitle(f"{title}\n{mode}")
    save(figure, path)


def conclusion(records: list[Record]) -> list[str]:
    """Return where the steady motion is left, and how near the steps come, in a sentence each."""
    seen = campbell(law().law.disk, MODE, SPEEDS)
    wide, growth = SPEEDS[diverges(seen)], np.where(SPEEDS > 1.1, flutters(seen), 0.0)
    most = growth.argmax()
    lines = [
        f"The steady motion diverges from x = {wide[0]:.3f} to {wide[-1]:.3f}, faster than the waves decay, and its "
        f"nutation flutters most at x = {SPEEDS[most]:.3f}, by {growth[most]:.3g} 1/s; n/(n - 0.786) is {FLUTTER:.3f}."
    ]
    if best := nearest(records):
        lines.append(f"The steps give that growth within {number(best.error)} at {best.setting}.")
    return lines
