"""Modes as files that other programs read."""

from pathlib import Path

import numpy as np

from modal.modes import Modes


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


def one(modes: Modes, i):
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


def write_vtu(modes: Modes, path: str | Path) -> None:
    """Write the whole disk [m] with one array of displacement vectors [kg^-1/2] per mode, quadratic cells kept."""
    import meshio

    body = modes.body
    names = [f"mode {i + 1:02d}: {f:.1f} Hz" for i, f in enumerate(modes.frequency)]
    fields = {name: np.ascontiguousarray(u) for name, u in zip(names, body.displacement, strict=True)}
    mesh = meshio.Mesh(body.points, [(body.cell_type, body.cells)], point_data=fields)
    meshio.write(Path(path), mesh, file_format="vtu")


def write_uff(modes: Modes, path: str | Path) -> None:
    """Write the nodes (dataset 15) and one dataset 55, normal modes, per mode; needs the optional package pyuff."""
    try:
        import pyuff
    except ModuleNotFoundError:
        raise ModuleNotFoundError('uff needs pyuff: python -m pip install -e ".[uff]"', name="pyuff") from None
    body, number = modes.body, np.arange(1, len(modes.body.points) + 1)
    x, y, z = body.points.T
    same = np.ones(len(number), int)
    file = pyuff.UFF(str(path))
    nodes = {"type": 15, "node_nums": number, "def_cs": same, "disp_cs": same, "color": same, "x": x, "y": y, "z": z}
    file.write_sets(nodes, mode="overwrite")
    for i, u in enumerate(body.displacement):
        file.write_sets(dataset_55(modes, i, number, u), mode="add")


def dataset_55(modes: Modes, i, number, u):
    """Dataset 55 of mode i: structural, normal mode, three translations per node, displacement, real."""
    damping = modes.decay_rate[i] / (2 * np.pi * modes.frequency[i])
    kind = {"type": 55, "model_type": 1, "analysis_type": 2, "data_ch": 2, "spec_data_type": 8, "data_type": 2}
    place = {"n_data_per_node": 3, "load_case": 1, "mode_n": i + 1, "node_nums": number}
    size = {"freq": modes.frequency[i], "modal_m": 1.0, "modal_damp_vis": damping, "modal_damp_his": 0.0}
    text = {f"id{k}": line for k, line in enumerate(("modes", modes.method, modes.family[i], "SI", "NONE"), 1)}
    return kind | place | size | text | {"r1": u[:, 0], "r2": u[:, 1], "r3": u[:, 2]}


def as_faust(modes: Modes, angle: float = 0.0, name: str = "disk") -> str:
    """A Faust program: a force [N], axial at the bottom edge at `angle` [rad], in; velocity [m/s] there out.

    The model is that of `as_faust_library`, with sliders for what it is scaled by. ValueError if there is no mode,
    or an overdamped one.
    """
    return as_faust_library(modes, angle, name) + FAUST_PROGRAM.format(name=name)


def as_faust_library(modes: Modes, angle: float = 0.0, name: str = "disk") -> str:
    """A Faust library with one function, name(gain, t60_scale, frequency_scale), from force to velocity as `as_faust`.

    q'' + 2 d q' + w^2 q = phi F is stepped exactly for a force that is constant between samples: with the pole
    exp(-d T), angle v T, v^2 = w^2 - d^2, each step of F adds the velocity phi^2 exp(-d t) sin(v t)/v in each mode.
    Frequencies v are multiplied by frequency_scale, and modes beyond half the sample rate are silent; 1/d by t60_scale.
    ValueError if there is no mode, or an overdamped one, d >= w, which has no v.
    """
    if not len(modes):
        raise ValueError("there is no mode to write")
    for i in np.flatnonzero(modes.decay_rate >= 2 * np.pi * modes.frequency):
        f, d = modes.frequency[i], modes.decay_rate[i]
        raise ValueError(f"mode {i + 1} of {f:.1f} Hz does not oscillate: its decay rate of {d:.4g} 1/s is too large")
    phi = modes.at_rim(angle)[:, 0, 2]
    turn = np.sqrt((2 * np.pi * modes.frequency) ** 2 - modes.decay_rate**2)
    rows = zip(turn, modes.decay_rate, phi**2 / turn, strict=True)
    bank = ",\n    ".join(f"mode({w:.15g}, {d:.15g}, {g:.15g})" for w, d, g in rows)
    return FAUST_LIBRARY.format(name=name, count=len(modes), bank=bank)


FAUST_LIBRARY = """declare name "{name}";
import("stdfaust.lib");
// {count} modes: angular rate [rad/s], decay rate [1/s], velocity [m/s] per newton stepped
{name}(gain, t60_scale, frequency_scale) = _ <: (_, mem) : - <:
    {bank}
    :> *(gain)
with {{
  T = 1.0 / ma.SR;
  mode(rate, decay, g) = *(g / frequency_scale * (w * T < ma.PI) * r * sin(w * T)) : fi.tf2(0, 1, 0, a1, r * r)
  with {{
    w = rate * frequency_scale;
    r = exp(0 - decay / t60_scale * T);
    a1 = -2 * r * cos(w * T);
  }};
}};
"""
FAUST_PROGRAM = """process = {name}(
  hslider("gain", 1, 0, 10, 0.001), hslider("t60 scale", 1, 0.01, 100, 0.001),
  hslider("frequency scale", 1, 0.1, 10, 0.0001)
);
"""
