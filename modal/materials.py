"""List elastic constants, loss factors and densities of materials by name, with their
sources."""

from typing import Literal, NamedTuple

MaterialName = Literal[
    "aluminium",
    "brass",
    "bronze",
    "ceramic",
    "copper",
    "cupronickel",
    "glass",
    "gold",
    "nickel",
    "silver",
    "steel",
    "wood",
]


class NamedMaterial(NamedTuple):
    """Typical values of a material at room temperature, with their sources.

    The loss factor is that of the material alone; it varies by a factor of three or
    more between samples.
    """

    young: float
    """Young's modulus [Pa]."""
    poisson: float
    """Poisson's ratio."""
    loss_factor: float
    """Loss factor in bending."""
    density: float
    """Density [kg/m^3]."""
    source: str
    """Type of the material, and source of the values."""


CREMER_HECKL = "Cremer and Heckl, Structure-Borne Sound (1988)"
KAYE_LABY = "Kaye and Laby, Tables of Physical and Chemical Constants (1995)"
CRC = "CRC Handbook of Chemistry and Physics (2004)"

MATERIALS: dict[str, NamedMaterial] = {
    "aluminium": NamedMaterial(
        young=70.3e9,
        poisson=0.345,
        loss_factor=1e-4,
        density=2700.0,
        source=f"{KAYE_LABY}; loss factor: {CREMER_HECKL}",
    ),
    "brass": NamedMaterial(
        young=110e9,
        poisson=0.34,
        loss_factor=5e-4,
        density=8530.0,
        source="cartridge brass, C26000: Copper Development Association, which states a shear "
        f"modulus of 41 GPa; loss factor below 1e-3: {CREMER_HECKL}",
    ),
    "bronze": NamedMaterial(
        young=110e9,
        poisson=0.34,
        loss_factor=5e-4,
        density=8860.0,
        source="phosphor bronze, C51000: Copper Development Association, which states a shear "
        "modulus of 41 GPa; loss factor: assumed, as for brass",
    ),
    "ceramic": NamedMaterial(
        young=416e9,
        poisson=0.231,
        loss_factor=1e-4,
        density=3984.0,
        source="sintered alumina: Munro, Journal of the American Ceramic Society 80, 1919 (1997); "
        "loss factor: assumed",
    ),
    "copper": NamedMaterial(
        young=129.8e9,
        poisson=0.343,
        loss_factor=2e-3,
        density=8960.0,
        source=f"{KAYE_LABY}; density: {CRC}; loss factor: {CREMER_HECKL}",
    ),
    "cupronickel": NamedMaterial(
        young=145e9,
        poisson=0.33,
        loss_factor=5e-4,
        density=8940.0,
        source="coins of 75 % copper and 25 % nickel: interpolated between C70600 (10 % nickel) "
        "and C71500 (30 %) of the Copper Development Association, which states Young's moduli of "
        "124 and 152 GPa and shear moduli of 47 and 57 GPa; loss factor: assumed, as for brass",
    ),
    "glass": NamedMaterial(
        young=70e9,
        poisson=0.2,
        loss_factor=1e-3,
        density=2500.0,
        source="soda-lime glass: EN 572-1; loss factor: the lower end of 0.001 to 0.005",
    ),
    "gold": NamedMaterial(
        young=78e9,
        poisson=0.44,
        loss_factor=3e-4,
        density=19300.0,
        source=f"pure gold: {KAYE_LABY}; density: {CRC}; loss factor: {CREMER_HECKL}",
    ),
    "nickel": NamedMaterial(
        young=199.5e9,
        poisson=0.312,
        loss_factor=5e-4,
        density=8900.0,
        source=f"soft nickel: {KAYE_LABY}; density: {CRC}; loss factor below 1e-3: {CREMER_HECKL}",
    ),
    "silver": NamedMaterial(
        young=82.7e9,
        poisson=0.367,
        loss_factor=3e-4,
        density=10500.0,
        source=f"pure silver: {KAYE_LABY}; density: {CRC}; loss factor below 4e-4: {CREMER_HECKL}",
    ),
    "steel": NamedMaterial(
        young=211.9e9,
        poisson=0.291,
        loss_factor=3e-4,
        density=7850.0,
        source=f"mild steel: {KAYE_LABY}; loss factor, 2e-4 to 6e-4: {CREMER_HECKL}",
    ),
    "wood": NamedMaterial(
        young=11.9e9,
        poisson=0.3,
        loss_factor=0.01,
        density=720.0,
        source="American beech along the grain at 12 % moisture, assumed equal in every "
        "direction: Wood Handbook (FPL-GTR-190, 2010); Poisson's ratio and loss factor: assumed",
    ),
}
"""Materials available in scenes by name, in alphabetical order."""
