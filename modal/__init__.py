"""The elastic modes of the disk: `eigenmodes(scene)` gives `Modes`. Importing the package costs nothing."""

from importlib import import_module

_HOME = {
    "eigenmodes": "solve",
    "Material": "modes",
    "Support": "modes",
    "Modes": "modes",
    "UnsolvableError": "modes",
    "Body": "modes",
    "Plate": "spectral.basis",
    "FreeDisk": "synthesis.patches",
    "plate_modes": "spectral.axisymmetric",
    "write_vtu": "export",
    "write_uff": "export",
    "as_json": "export",
    "as_faust": "export",
    "as_faust_library": "export",
    "mesh_modes": "elements.given_mesh",
    "radiation_decay": "radiation",
    "with_radiation": "radiation",
}
__all__ = sorted(_HOME)


def __getattr__(name):
    if name not in _HOME:
        raise AttributeError(f"module 'modal' has no attribute {name!r}")
    return getattr(import_module(f"modal.{_HOME[name]}"), name)
