"""Export modes to file formats of other programs."""

from itertools import count
from math import degrees, pi
from pathlib import Path
from typing import Any

import numpy as np

from modal.mesh.hexahedron import HEXAHEDRON_PARTS
from modal.mesh.tetrahedra import FACES, TETRAHEDRON_PARTS, corner_lists
from modal.modes import Body, Modes


def as_json(modes: Modes) -> dict[str, Any]:
    """Return the content of modes.json.

    It consists of the method and of the properties and rim shape of each mode.

    Parameters
    ----------
    modes : Modes
        The modes to export.

    Returns
    -------
    dict
        Values supported by `json.dumps`. The rim shape is the radial, tangential and
        axial displacement [kg^-1/2] of the bottom edge at the angles `rim_angle` [rad].

    Examples
    --------
    >>> from modal import Material, Plate, plate_modes, as_json
    >>> steel = Material(name="steel")
    >>> plate = Plate(radius=0.0375, thickness=0.003, material=steel, density=7850.0)
    >>> modes = plate_modes(plate, 8e3, "draft")
    >>> sorted(as_json(modes))
    ['mass', 'method', 'modes', 'rim_angle', 'unknowns']
    """
    return {
        "method": modes.method,
        "unknowns": modes.unknowns,
        "mass": modes.mass,
        "rim_angle": modes.rim_angle.tolist(),
        "modes": [mode_entry(modes, i) for i in range(len(modes))],
    }


def mode_entry(modes: Modes, i: int) -> dict[str, Any]:
    """Return the entry of mode i in modes.json; infinite decay times and quality
    factors are null."""
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
    """Write the mode shapes to a VTU file, for example for ParaView.

    The file contains the mesh of the whole disk [m] and one array of displacement
    vectors [kg^-1/2] per mode. Quadratic cells remain quadratic.

    Parameters
    ----------
    modes : Modes
        The modes to export.
    path : str or Path
        File to write.

    Examples
    --------
    >>> from modal import Material, Plate, plate_modes, write_vtu
    >>> steel = Material(name="steel")
    >>> plate = Plate(radius=0.0375, thickness=0.003, material=steel, density=7850.0)
    >>> modes = plate_modes(plate, 8e3, "draft")
    >>> from tempfile import TemporaryDirectory
    >>> with TemporaryDirectory() as folder:
    ...     write_vtu(modes, Path(folder) / "modes.vtu")
    ...     [file.name for file in Path(folder).iterdir()]
    ['modes.vtu']
    """
    import meshio

    body = modes.body
    names = [f"mode {i + 1:02d}: {f:.1f} Hz" for i, f in enumerate(modes.frequency)]
    fields = {
        name: np.ascontiguousarray(u)
        for name, u in zip(names, body.displacement, strict=True)
    }
    mesh = meshio.Mesh(body.points, [(body.cell_type, body.cells)], point_data=fields)
    meshio.write(Path(path), mesh, file_format="vtu")


def write_uff(modes: Modes, path: str | Path) -> None:
    """Write the mode shapes to a universal file for programs of modal analysis.

    The file contains the SI units (dataset 164), the nodes (15), the elements (2412) and
    the normal modes (55). The elements are solids with linear sides that connect all
    nodes, and the faces of their surface, for programs that draw faces only.

    Parameters
    ----------
    modes : Modes
        The modes to export.
    path : str or Path
        File to write.

    Raises
    ------
    ModuleNotFoundError
        If the optional package pyuff is not installed.

    Examples
    --------
    >>> from modal import Material, Plate, plate_modes, write_uff
    >>> steel = Material(name="steel")
    >>> plate = Plate(radius=0.0375, thickness=0.003, material=steel, density=7850.0)
    >>> modes = plate_modes(plate, 8e3, "draft")
    >>> write_uff(modes, "modes.uff")  # doctest: +SKIP
    """
    try:
        import pyuff
    except ModuleNotFoundError:
        raise ModuleNotFoundError(
            'the format uff requires pyuff; install it with: python -m pip install -e ".[uff]"',
            name="pyuff",
        ) from None
    body = modes.body
    number = np.arange(1, len(modes.body.points) + 1)
    x, y, z = body.points.T
    same = np.ones(len(number), int)
    file = pyuff.UFF(str(path))
    units = {
        "type": 164,
        "units_code": 1,
        "units_description": "SI: metre, newton",
        "temp_mode": 2,  # relative
        "length": 1.0,
        "force": 1.0,
        "temp": 1.0,
        "temp_offset": 273.15,
    }
    nodes = {
        "type": 15,
        "node_nums": number,
        "def_cs": same,
        "disp_cs": same,
        "color": same,
        "x": x,
        "y": y,
        "z": z,
    }
    file.write_sets([units, nodes, uff_element_dataset(body)], mode="overwrite")
    for i, u in enumerate(body.displacement):
        file.write_sets(uff_mode_dataset(modes, i, number, u), mode="add")


def uff_element_dataset(body: Body) -> dict[str | int, Any]:
    """Return dataset 2412 of a body: solids of linear sides, and the faces of the
    surface."""
    solids = linear_subcells(body)
    triangular = solids.shape[1] == 4
    cells_by_descriptor = {
        111 if triangular else 115: solids,
        41 if triangular else 44: outer_faces(solids),
    }
    dataset: dict[str | int, Any] = {"type": 2412}
    label = count(1)
    for descriptor, cells in cells_by_descriptor.items():
        dataset[descriptor] = [
            {
                "element_nums": next(label),
                "fe_descriptor": descriptor,
                "phys_table": 1,
                "mat_table": 1,
                "color": 7,
                "num_nodes": len(cell),
                "nodes_nums": cell,
            }
            for cell in (cells + 1).tolist()
        ]
    return dataset


def linear_subcells(body: Body) -> np.ndarray:
    """Return the cells (c, 4) or (c, 8) of a body with each quadratic cell divided into
    eight.

    The nodes are in VTK's order, and the volumes are positive.
    """
    node_count = body.cells.shape[1]
    if node_count in (4, 10):
        parts = TETRAHEDRON_PARTS if node_count == 10 else [[0, 1, 2, 3]]
        edges = [1, 2, 3]
        mirrored = [0, 2, 1, 3]
    else:
        parts = HEXAHEDRON_PARTS if node_count == 27 else [list(range(8))]
        edges = [1, 3, 4]
        mirrored = [0, 3, 2, 1, 4, 7, 6, 5]
    cells = np.concatenate([body.cells[:, part] for part in parts])
    sides = body.points[cells[:, edges]] - body.points[cells[:, :1]]
    left_handed = np.linalg.det(sides) < 0
    cells[left_handed] = cells[left_handed][:, mirrored]
    return cells


def outer_faces(cells: np.ndarray) -> np.ndarray:
    """Return the faces (f, 3) or (f, 4) that belong to one cell only, numbered around
    their outward normals.

    The nodes of the cells are in VTK's order.
    """
    shape = "tetra" if cells.shape[1] == 4 else "hexahedron"
    numbers = np.array(corner_lists(FACES[shape]))
    faces = cells[:, numbers].reshape(-1, numbers.shape[1])
    _, first, shared = np.unique(
        np.sort(faces, axis=1), axis=0, return_index=True, return_counts=True
    )
    return faces[np.sort(first[shared == 1])]


def uff_mode_dataset(
    modes: Modes, i: int, number: np.ndarray, u: np.ndarray
) -> dict[str, Any]:
    """Return dataset 55 of mode i: structural model, normal mode, three real
    displacements per node."""
    id_lines = ("modes", modes.method, modes.family[i], "SI", "NONE")
    return {
        "type": 55,
        "model_type": 1,
        "analysis_type": 2,
        "data_ch": 2,
        "spec_data_type": 8,
        "data_type": 2,
        "n_data_per_node": 3,
        "load_case": 1,
        "mode_n": i + 1,
        "node_nums": number,
        "freq": modes.frequency[i],
        "modal_m": 1.0,
        "modal_damp_vis": modes.decay_rate[i] / (2 * np.pi * modes.frequency[i]),
        "modal_damp_his": 0.0,
        **{f"id{k}": line for k, line in enumerate(id_lines, 1)},
        "r1": u[:, 0],
        "r2": u[:, 1],
        "r3": u[:, 2],
    }


UNIT_STRIKE_PEAK = 0.9
"""Peak output of a Faust program after a unit strike, a single sample of value 1."""
OPPOSITE_ANGLE = pi
"""Angle [rad] of the rim point opposite the contact, where the disk can move with every
support."""


def as_faust(modes: Modes, angle: float = OPPOSITE_ANGLE, name: str = "disk") -> str:
    """Return a Faust program that simulates a disk struck at its bottom edge.

    The program contains the function of `as_faust_library`, a slider for each of its
    arguments, and a button whose strikes of 1 are added to the input.

    Parameters
    ----------
    modes : Modes
        The modes.
    angle : float
        Angle [rad] of the struck point (default: opposite the patch).
    name : str
        Name of the function.

    Returns
    -------
    str
        The text of the program.

    Raises
    ------
    ValueError
        Under the conditions of `as_faust_library`.

    Examples
    --------
    >>> from modal import Material, Plate, plate_modes, as_faust
    >>> steel = Material(name="steel")
    >>> plate = Plate(radius=0.0375, thickness=0.003, material=steel, density=7850.0)
    >>> modes = plate_modes(plate, 8e3, "draft")
    >>> "process = +(strike) : bell(" in as_faust(modes, name="bell")
    True
    """
    return as_faust_library(modes, angle, name) + FAUST_PROGRAM.format(name=name)


def as_faust_library(
    modes: Modes, angle: float = OPPOSITE_ANGLE, name: str = "disk"
) -> str:
    """Return a Faust library with one function that converts strikes to velocity.

    The function is name(gain, t60_scale, frequency_scale). The disk is struck at the
    bottom edge along its axis, and the output is the axial velocity of the struck
    point. A sample of value x represents an impulse x. The response of each mode is
    exactly g exp(-d t) (cos v t - d/v sin v t) with v^2 = w^2 - d^2, where g is its
    contribution to the first sample. The sum of the contributions is UNIT_STRIKE_PEAK,
    which no later sample exceeds. The file states the corresponding velocity in m/s.

    Parameters
    ----------
    modes : Modes
        The modes. The function multiplies their frequencies v by frequency_scale and
        their decay times 1/d by t60_scale; modes above the Nyquist frequency are muted.
    angle : float
        Angle [rad] of the struck point from the middle of the patch (default: the
        opposite point).
    name : str
        Name of the function.

    Returns
    -------
    str
        The text of the library.

    Raises
    ------
    ValueError
        If there is no mode, if a mode is overdamped (d >= w), or if the disk is held at
        this angle.

    Examples
    --------
    >>> from modal import Material, Plate, plate_modes, as_faust_library
    >>> steel = Material(name="steel")
    >>> plate = Plate(radius=0.0375, thickness=0.003, material=steel, density=7850.0)
    >>> modes = plate_modes(plate, 8e3, "draft")
    >>> as_faust_library(modes, name="bell").splitlines()[0]
    'declare name "bell";'
    """
    if not len(modes):
        raise ValueError("there are no modes to export")
    for i in np.flatnonzero(modes.decay_rate >= 2 * np.pi * modes.frequency):
        f = modes.frequency[i]
        d = modes.decay_rate[i]
        raise ValueError(
            f"mode {i + 1} of {f:.1f} Hz does not oscillate: its decay rate of {d:.4g} 1/s is too "
            f"large"
        )
    share, velocity = strike_velocity_shares(modes, angle)
    turn = np.sqrt((2 * np.pi * modes.frequency) ** 2 - modes.decay_rate**2)
    rows = zip(turn, modes.decay_rate, UNIT_STRIKE_PEAK * share, strict=True)
    bank = ",\n    ".join(f"mode({w:.15g}, {d:.15g}, {g:.15g})" for w, d, g in rows)
    return FAUST_LIBRARY.format(
        name=name,
        count=len(modes),
        bank=bank,
        strike=degrees(angle),
        peak=UNIT_STRIKE_PEAK,
        velocity=velocity / UNIT_STRIKE_PEAK,
    )


def strike_velocity_shares(modes: Modes, angle: float) -> tuple[np.ndarray, float]:
    """Return the fractions (m,) of the modes in the velocity of a struck point, and the
    velocity [m/s].

    The velocity is that after an impulse of 1 N s at an angle [rad] of the bottom edge.
    A mode of unit modal mass with the axial displacement phi contributes phi^2. Raises
    ValueError if the disk is held at this point.
    """
    if not np.isfinite(angle):
        raise ValueError(f"strike at {angle} degrees: must be a finite angle")
    mobility = modes.at_rim(angle)[:, 0, 2] ** 2
    greatest = (modes.rim_shape[:, :, 2] ** 2).sum(axis=0).max()
    if mobility.sum() <= 1e-4 * greatest:
        raise ValueError(
            f"strike at {degrees(angle):g} degrees: the disk is held there; strike where it can "
            f"move"
        )
    share = mobility / mobility.sum()
    share[share < np.finfo(float).eps] = 0.0  # remove round-off at nodes of a mode
    return share, float(mobility.sum())


FAUST_LIBRARY = """declare name "{name}";
declare strike "axially at the bottom edge, {strike:.6g} degrees from the contact";
declare peak "{peak:g} after a unit strike, which is one sample of 1";
declare scale "1.0 = {velocity:.6g} m/s after a strike of 1 N s";
import("stdfaust.lib");
// A disk with {count} modes is struck axially at its bottom edge,
// {strike:.6g} degrees from the contact. A strike is one input sample; the output is
// the axial velocity of the struck point. After a unit strike, a sample of 1, the
// first output sample is the peak {peak:g}. If an input of 1 represents an impulse
// of 1 N s, an output of 1.0 represents {velocity:.6g} m/s. The arguments of each
// mode are angular frequency [rad/s], decay rate [1/s], and share of that sample.
{name}(gain, t60_scale, frequency_scale) = _ <:
    {bank}
    :> *(gain)
with {{
  T = 1.0 / ma.SR;
  mode(rate, decay, g) = *(g * (w * T < ma.PI)) : fi.tf2(1, b1, 0, a1, r * r)
  with {{
    w = rate * frequency_scale;
    d = decay / t60_scale;
    r = exp(0 - d * T);
    b1 = 0 - r * (cos(w * T) + d / w * sin(w * T));
    a1 = -2 * r * cos(w * T);
  }};
}};
"""
FAUST_PROGRAM = """strike = button("strike") : ba.impulsify;
process = +(strike) : {name}(
  hslider("gain", 1, 0, 10, 0.001), hslider("t60 scale", 1, 0.01, 100, 0.001),
  hslider("frequency scale", 1, 0.1, 10, 0.0001)
);
"""
