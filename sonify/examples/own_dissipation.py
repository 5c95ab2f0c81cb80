r"""
Your own law of dissipation
===========================

Turbulent drag takes the power c \|Omega\|^3 from the disk.

A law returns dimensionless loads: masses relative to the mass of the disk, lengths relative to its
radius, and times relative to its `time_unit`.
"""

from dataclasses import dataclass

from dynamics import Loads, Motion, OwnLaw, simulate
from dynamics.disk import GRAVITY
from sonify import load_scene

DRAG = 1e-9
"""c [W s^3]."""


@dataclass(frozen=True)
class Turbulent(OwnLaw):
    """The moment -c Omega |Omega| / cos(alpha) about e_3, whose power is that of the law; `drag` is
    dimensionless."""

    drag: float

    def __call__(self, beta, omega, slip, law, flow) -> Loads:
        """Return the loads at inclination beta and angular velocity omega; `flow` has the functions
        to use."""
        cos_a = flow.sin(beta)
        rate = omega[2] / cos_a
        return Loads(M3=-self.drag * rate * flow.power(rate * rate, 0.5) / cos_a)


def main() -> Motion:
    """Solve the published motion without and with the drag, print how long each lasts, return the
    latter."""
    scene = load_scene("published").replace("numerics.accuracy=draft")
    inertia = (
        scene.disk.weight / GRAVITY * scene.disk.radius**2
    )  # the unit of c [kg m^2]: times cancel in it
    slowed = simulate(scene, loads=Turbulent(DRAG / inertia))
    print(f"{simulate(scene).t[-1]:.3f} s without, {slowed.t[-1]:.3f} s with the drag")
    return slowed


if __name__ == "__main__":
    main()
