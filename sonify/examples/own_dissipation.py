r"""
Your own law of dissipation
===========================

A turbulent drag dissipates the power c \|Omega\|^3.

A dissipation law returns dimensionless loads. The units are the mass and the radius of the disk and
its `time_unit`.
"""

from dataclasses import dataclass
from typing import Any

from dynamics import Loads, Motion, OwnLaw, simulate
from dynamics.disk import GRAVITY
from sonify import load_scene


@dataclass(frozen=True)
class Turbulent(OwnLaw):
    """Moment -c Omega |Omega| / cos(alpha) about e_3; `drag` is the dimensionless c."""

    drag: float

    def __call__(
        self, beta: float, omega: Any, slip: Any, law: Any, flow: Any
    ) -> Loads:
        """Return the loads at inclination beta and angular velocity omega; `flow` provides
        the elementary functions."""
        cos_a = flow.sin(beta)
        rate = omega[2] / cos_a
        return Loads(M3=-self.drag * rate * flow.power(rate * rate, 0.5) / cos_a)


def main() -> Motion:
    """Solve the published motion without and with drag, print both durations, and
    return the motion with drag."""
    drag_coefficient = 1e-9  # c [W s^3]
    scene = load_scene("published").replace("numerics.accuracy=draft")
    inertia = (
        scene.disk.weight / GRAVITY * scene.disk.radius**2
    )  # unit of c [kg m^2], in which the units of time cancel
    slowed = simulate(scene, loads=Turbulent(drag_coefficient / inertia))
    print(f"{simulate(scene).t[-1]:.3f} s without, {slowed.t[-1]:.3f} s with the drag")
    return slowed


if __name__ == "__main__":
    main()
