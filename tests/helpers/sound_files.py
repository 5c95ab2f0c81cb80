"""Sound files in the formats that libsndfile writes."""

import numpy as np
import soundfile

from sonify.hearing.mp3 import mp3_frames

LENGTH = 8.0
"""Duration of the whole sound [s]."""
DECODER_DELAY = 529
"""Delay of a layer III decoder [samples]; libsndfile omits these samples."""
FORMATS = {
    "wav": {"subtype": "PCM_16"},
    "aiff": {"subtype": "PCM_16"},
    "flac": {"subtype": "PCM_16"},
    "ogg": {"subtype": "VORBIS"},
    "opus": {"format": "OGG", "subtype": "OPUS"},
    "constant.mp3": {
        "subtype": "MPEG_LAYER_III",
        "bitrate_mode": "CONSTANT",
        "compression_level": 0.5,
    },
    "variable.mp3": {
        "subtype": "MPEG_LAYER_III",
        "bitrate_mode": "VARIABLE",
        "compression_level": 0.5,
    },
}


def written(path, rate=48_000, channels=1):
    """Write a tone of 900 Hz in noise and return its bytes."""
    t = np.arange(round(LENGTH * rate)) / rate
    noise = np.random.default_rng(0).standard_normal(len(t))
    sound = 0.2 * np.sin(2 * np.pi * 900 * t) + 0.02 * noise
    kind = next(kind for end, kind in FORMATS.items() if path.name.endswith(end))
    soundfile.write(path, np.column_stack([sound] * channels), rate, **kind)
    return path.read_bytes()


def read_mp3(path):
    """Return the frames of an MP3 file, or None for another file."""
    with open(path, "rb") as file:
        return mp3_frames(file)
