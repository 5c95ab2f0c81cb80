"""Write a motion as an animated glTF 2.0 model of disk, contact and table, with the y
axis pointing upwards; requires the package pygltflib."""

from io import BytesIO
from pathlib import Path

import numpy as np
import pygltflib as gltf
import soundfile

from dynamics import Motion
from sonify import __version__
from sonify.export.disk_frame import contact_points
from sonify.export.model_geometry import (
    Mesh,
    body_poses,
    disk_mesh,
    marker_mesh,
    table_mesh,
    to_y_upwards,
)
from sonify.hearing.audio_source import read_samples, source_of_file
from sonify.scene import Scene

COLOURS = {
    "metal": (0.6, 0.62, 0.65, 0.9),
    "mark": (0.63, 0.08, 0.16, 0.2),
    "contact": (0.0, 0.24, 0.55, 0.0),
    "table": (0.86, 0.84, 0.8, 0.0),
}
"""Red, green, blue and metallic factor of each material."""
SOUND_EXTENSION = "KHR_audio_emitter"
"""Extension of glTF, a draft of Khronos, for sounds at nodes of a model."""


class ModelBuilder:
    """A glTF model with one buffer, to which data are appended."""

    def __init__(self) -> None:
        self.model = gltf.GLTF2(
            asset=gltf.Asset(generator=f"eulers-disk-sonify {__version__}")
        )
        self._content = bytearray()

    def add_view(self, content: bytes, target: int | None = None) -> int:
        """Append bytes and return the index of their buffer view."""
        self._content += bytes(-len(self._content) % 4)
        view = gltf.BufferView(
            buffer=0,
            byteOffset=len(self._content),
            byteLength=len(content),
            target=target,
        )
        self._content += content
        self.model.bufferViews.append(view)
        return len(self.model.bufferViews) - 1

    def add_accessor(
        self, values: np.ndarray, target: int | None = None, bounds: bool = False
    ) -> int:
        """Append float or index values (k,) or (k, n) and return the index of their
        accessor."""
        is_index = values.dtype.kind in "iu"
        array = np.ascontiguousarray(values, "<u4" if is_index else "<f4")
        columns = array.reshape(len(array), -1)
        accessor = gltf.Accessor(
            bufferView=self.add_view(array.tobytes(), target),
            componentType=gltf.UNSIGNED_INT if is_index else gltf.FLOAT,
            count=len(array),
            type={1: gltf.SCALAR, 3: gltf.VEC3, 4: gltf.VEC4}[columns.shape[1]],
        )
        if bounds:
            accessor.min = columns.min(axis=0).tolist()
            accessor.max = columns.max(axis=0).tolist()
        self.model.accessors.append(accessor)
        return len(self.model.accessors) - 1

    def add_mesh(self, name: str, mesh: Mesh) -> None:
        """Append a mesh and a node of the same name."""
        attributes = gltf.Attributes(
            POSITION=self.add_accessor(mesh.points, gltf.ARRAY_BUFFER, bounds=True),
            NORMAL=self.add_accessor(mesh.normals, gltf.ARRAY_BUFFER),
        )
        primitives = [
            gltf.Primitive(
                attributes=attributes,
                indices=self.add_accessor(triangles.ravel(), gltf.ELEMENT_ARRAY_BUFFER),
                material=list(COLOURS).index(material),
            )
            for material, triangles in mesh.triangles.items()
        ]
        self.model.nodes.append(gltf.Node(name=name, mesh=len(self.model.meshes)))
        self.model.meshes.append(gltf.Mesh(name=name, primitives=primitives))

    def animate(
        self, times: np.ndarray, tracks: list[tuple[str, str, np.ndarray]]
    ) -> None:
        """Append an animation of nodes by linear interpolation.

        Each track has the name of a node, "translation" or "rotation", and the values
        (k, n) at the times (k,) [s]. The pose of the node is that of the first time.
        """
        clock = self.add_accessor(times, bounds=True)
        names = [node.name for node in self.model.nodes]
        animation = gltf.Animation(name="motion")
        for name, path, values in tracks:
            node = names.index(name)
            setattr(self.model.nodes[node], path, values[0].tolist())
            target = gltf.AnimationChannelTarget(node=node, path=path)
            channel = gltf.AnimationChannel(
                sampler=len(animation.samplers), target=target
            )
            animation.channels.append(channel)
            sampler = gltf.AnimationSampler(
                input=clock, output=self.add_accessor(values)
            )
            animation.samplers.append(sampler)
        self.model.animations.append(animation)

    def add_sound(self, name: str, wav: bytes, distance: float) -> None:
        """Let a node emit a WAV file, which starts when the model is loaded.

        Its level is that of the file up to a distance [m] from the node and falls as
        one over the distance farther away."""
        emitter = {
            "name": name,
            "type": "positional",
            "sources": [0],
            "positional": {"distanceModel": "inverse", "refDistance": distance},
        }
        audio = {"bufferView": self.add_view(wav), "mimeType": "audio/wav"}
        source = {"name": "audible", "audio": 0, "autoPlay": True}
        self.model.extensionsUsed.append(SOUND_EXTENSION)
        self.model.extensions[SOUND_EXTENSION] = {
            "audio": [audio],
            "sources": [source],
            "emitters": [emitter],
        }
        (node,) = (node for node in self.model.nodes if node.name == name)
        node.extensions[SOUND_EXTENSION] = {"emitter": 0}

    def file_content(self, as_text: bool) -> bytes:
        """Return the content of a file: text (.gltf) with the buffer as base64, or
        binary (.glb)."""
        self.model.buffers = [gltf.Buffer(byteLength=len(self._content))]
        self.model.set_binary_blob(bytes(self._content))
        if not as_text:
            return b"".join(self.model.save_to_bytes())
        self.model.convert_buffers(gltf.BufferFormat.DATAURI)
        return f"{self.model.gltf_to_json(indent=None)}\n".encode()


def animated_model(
    scene: Scene,
    motion: Motion,
    times: np.ndarray,
    as_text: bool,
    sound: Path | None = None,
) -> bytes:
    """Return the motion at times (k,) [s] as a glTF 2.0 file, binary (.glb) or text
    (.gltf).

    Lengths are in metres, and the y axis points upwards. The nodes are `table`,
    `disk` (animated translation and rotation) and `contact` (animated translation).
    The disk emits the first channel of the file `sound`. Raises RecordingError if it
    cannot be read.
    """
    state = motion.at(times)
    fillet = motion.rolling_fillet
    contact = to_y_upwards(contact_points(state, motion.disk, fillet))
    centre, quaternion = body_poses(state, motion.disk, fillet)
    builder = ModelBuilder()
    builder.model.materials = [_material(name) for name in COLOURS]
    builder.add_mesh("table", table_mesh(scene, contact))
    builder.add_mesh("disk", disk_mesh(motion.disk, fillet))
    builder.add_mesh("contact", marker_mesh(0.03 * motion.disk.radius))
    builder.model.scene = 0
    builder.model.scenes = [gltf.Scene(name=scene.name, nodes=[0, 1, 2])]
    tracks = [
        ("disk", "translation", centre),
        ("disk", "rotation", quaternion),
        ("contact", "translation", contact),
    ]
    builder.animate(times, tracks)
    if sound is not None:
        listeners = scene.audio.listeners or [scene.audio.single_listener]
        builder.add_sound("disk", _first_channel(sound), listeners[0].distance)
    return builder.file_content(as_text)


def _first_channel(path: Path) -> bytes:
    """Return the first channel of a sound as a 16-bit WAV file; raises RecordingError if
    it cannot be read."""
    source = source_of_file(path)
    samples = read_samples(source, 0, source.frames)
    file = BytesIO()
    soundfile.write(file, samples[:, 0], source.sample_rate, "PCM_16", format="WAV")
    return file.getvalue()


def _material(name: str) -> gltf.Material:
    *colour, metallic = COLOURS[name]
    surface = gltf.PbrMetallicRoughness(
        baseColorFactor=[*colour, 1.0], metallicFactor=metallic, roughnessFactor=0.5
    )
    return gltf.Material(name=name, pbrMetallicRoughness=surface)
