"""Modes as files that other programs read."""

from pathlib import Path

import numpy as np

from .modes import Modes


def as_json(modes: Modes) -> dict:
    """The content of modes.json: how the modes were computed, and for each mode its numbers and its rim shape.

    The rim shape is given as the radial, tangential and axial displacement [kg^-1/2] of the bottom edge at `rim_angle`.
    """
    return {
        "method": modes.method,
        "unknowns": modes.unknowns,
        "mass": modes.mass,
        "rim_angle": modes.rim_angle.tolist(),
        "modes": [one(modes, i) for i in range(len(modes))],
    }


def one(modes, i):
    """What modes.json says of mode i; a time or quality that is infinite is null."""
    finite = modes.decay_rate[i] > 0
    return {
        "frequency": float(modes.frequency[i]),
        "decay_rate": float(modes.decay_rate[i]),
        "decay_time": float(modes.decay_time[i]) if finite else None,
        "quality": float(modes.quality[i]) if finite else None,
        "order": int(modes.order[i]),
        "family": modes.family[i],
        "parity": modes.parity[i],
        "partner": int(modes.partner[i]) if modes.partner[i] >= 0 else None,
        "participation": modes.participation[i].tolist(),
        "residual": float(modes.residual[i]),
        "error": float(modes.error[i]),
        "rim_shape": modes.rim_shape[i].T.tolist(),
    }


def write_vtu(modes: Modes, path) -> None:
    """Write the whole disk [m] with one array of displacement vectors [kg^-1/2] per mode, quadratic cells kept."""
    import meshio

    body = modes.body
    names = [f"mode {i + 1:02d}: {f:.1f} Hz" for i, f in enumerate(modes.frequency)]
    fields = {name: np.ascontiguousarray(u) for name, u in zip(names, body.displacement, strict=True)}
    mesh = meshio.Mesh(body.points, [(body.cell_type, body.cells)], point_data=fields)
    meshio.write(Path(path), mesh, file_format="vtu")
