"""Claim: a glTF model holds the arrays that were appended to it, each from a multiple of four bytes
on, in the form of its accessor.

Source: sonify/export/gltf.py. Oracle: the arrays, read back from the binary file by the chunks and
component types of the glTF 2.0 specification.
"""

import json
import struct

import numpy as np
import pytest

pytest.importorskip(
    "pygltflib", reason="the optional package pygltflib is not installed"
)

from sonify.export.gltf import ModelBuilder
from sonify.export.model_geometry import marker_mesh

COMPONENT_TYPES = {5125: "<u4", 5126: "<f4"}
COMPONENTS = {"SCALAR": 1, "VEC3": 3, "VEC4": 4}


def chunks(content):
    """Return the JSON document and the buffer of a binary glTF file."""
    magic, version, length = struct.unpack_from("<4sII", content)
    assert (magic, version, length) == (b"glTF", 2, len(content))
    size, kind = struct.unpack_from("<I4s", content, 12)
    assert kind == b"JSON"
    return json.loads(content[20 : 20 + size]), content[28 + size :]


def array_of(document, buffer, index):
    """Return the array of an accessor."""
    accessor = document["accessors"][index]
    view = document["bufferViews"][accessor["bufferView"]]
    first = view.get("byteOffset", 0)
    assert first % 4 == 0
    part = buffer[first : first + view["byteLength"]]
    values = np.frombuffer(part, COMPONENT_TYPES[accessor["componentType"]])
    return values.reshape(accessor["count"], COMPONENTS[accessor["type"]])


def test_arrays_are_read_back_after_bytes_of_any_length():
    builder = ModelBuilder()
    given = [
        np.array([0.5, -2.0, 3.25]),
        np.arange(12.0).reshape(4, 3),
        np.array([7, 0, 4_000_000_000], dtype=np.int64),
        np.ones((2, 4)),
    ]
    indices = []
    for k, values in enumerate(given):
        builder.add_view(bytes(k + 1))  # moves what follows off the multiples of four
        indices.append(builder.add_accessor(values, bounds=True))
    document, buffer = chunks(builder.file_content(as_text=False))
    for index, values in zip(indices, given, strict=True):
        columns = values.reshape(len(values), -1)
        assert array_of(document, buffer, index).tolist() == columns.tolist()
        accessor = document["accessors"][index]
        assert accessor["min"] == columns.min(axis=0).tolist()
        assert accessor["max"] == columns.max(axis=0).tolist()


def test_an_animated_node_starts_at_its_first_pose():
    builder = ModelBuilder()
    builder.add_mesh("contact", marker_mesh(0.1))
    path = np.array([[1.0, 2.0, 3.0], [4.0, 5.0, 6.0]])
    builder.animate(np.array([0.0, 0.5]), [("contact", "translation", path)])
    document, buffer = chunks(builder.file_content(as_text=False))
    assert document["nodes"][0]["translation"] == [1.0, 2.0, 3.0]
    (sampler,) = document["animations"][0]["samplers"]
    assert array_of(document, buffer, sampler["output"]).tolist() == path.tolist()
    assert array_of(document, buffer, sampler["input"]).ravel().tolist() == [0.0, 0.5]


def test_the_marker_is_a_sphere_whose_triangles_face_outwards():
    mesh = marker_mesh(0.1)
    assert np.linalg.norm(mesh.points, axis=1) == pytest.approx(0.1)
    assert mesh.points == pytest.approx(0.1 * mesh.normals)
    a, b, c = mesh.points[mesh.triangles["contact"]].swapaxes(0, 1)
    volume = np.einsum("ki,ki->", a, np.cross(b, c)) / 6
    # the sphere less the segments outside its 24 by 12 facets
    assert volume == pytest.approx(4 / 3 * np.pi * 0.1**3, rel=0.04)
