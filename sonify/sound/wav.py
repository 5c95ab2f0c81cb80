"""SOUND -> FILES: pascal in 32-bit float, one file for the whole and one for every cause, and a copy to listen to."""

import errno
from contextlib import ExitStack, contextmanager
from pathlib import Path

import numpy as np
import soundfile

from sonify.files import whole
from sonify.sound.render import BLOCK, STEMS, Renderer, Sound

LISTENING_PEAK_DB = -1.0
"""Peak of sound.wav relative to full scale [dB]."""
MOST_BYTES = 2**32 - 2**12
"""Samples that take more do not fit into a WAV file: it is RF64 then (EBU Tech 3306), which has lengths of 64 bits."""
BYTES = {"FLOAT": 4, "PCM_24": 3}


def write_sound(renderer: Renderer, folder: str | Path, watch=lambda done: None) -> Sound:
    """Render block by block into pressure.wav, stems/*.wav [Pa] and sound.wav in `folder`; return what was written.

    The samples of the stems add up exactly, in double precision and then rounded, to those of pressure.wav. Memory does
    not grow with the length, but for the noted energy of the modes. `watch(share)` is called with the share done.
    Raises OSError when the disk is full.
    """
    folder, rate = Path(folder), renderer.sample_rate
    peaks, finite = np.zeros(1 + len(STEMS)), True
    with ExitStack() as stack:
        paths = [folder / "pressure.wav", *(folder / "stems" / f"{name}.wav" for name in STEMS)]
        files = [stack.enter_context(_wav(path, rate, "FLOAT", renderer.samples)) for path in paths]
        for stems in renderer.blocks():
            stems = stems.astype(np.float32)
            columns = np.column_stack([stems.astype(float).sum(axis=1).astype(np.float32), stems])
            for file, column in zip(files, columns.T, strict=True):
                file.write(column)
            peaks, finite = np.maximum(peaks, np.abs(columns).max(axis=0)), finite and bool(np.isfinite(columns).all())
            watch(files[0].frames / renderer.samples)
    sound = Sound(
        sample_rate=rate,
        samples=renderer.samples,
        peak=float(peaks[0]),
        full_scale=float(peaks[0] / 10 ** (LISTENING_PEAK_DB / 20)) or 1.0,
        finite=finite,
        stem_peak=dict(zip(STEMS, peaks[1:].tolist(), strict=True)),
        modes_heard=len(renderer.modes.frequency),
        source_end=renderer.source_end,
        energy_time=np.concatenate(renderer.energy_time),
        energy=np.concatenate(renderer.energy),
        folder=folder,
    )
    _write_listening_copy(sound)
    return sound


def _write_listening_copy(sound):
    with (
        soundfile.SoundFile(sound.folder / "pressure.wav") as pressure,
        _wav(sound.folder / "sound.wav", sound.sample_rate, "PCM_24", sound.samples) as copy,
    ):
        for block in pressure.blocks(BLOCK):
            copy.write(block / sound.full_scale)


@contextmanager
def _wav(path, rate, subtype, samples):
    """A WAV file for so many samples that is whole or not there, and the same bytes for the same samples."""
    form = "RF64" if samples * BYTES[subtype] > MOST_BYTES else "WAV"
    with whole(path) as temporary:
        try:
            with soundfile.SoundFile(temporary, "w", rate, 1, subtype, format=form) as file:
                yield file
        except (AssertionError, soundfile.LibsndfileError) as error:  # a short write is all that libsndfile says
            raise OSError(errno.ENOSPC, "could not be written in full", str(path)) from error
        _forget_time(temporary)


def _forget_time(path):
    """Zero the time stamp that libsndfile puts into the PEAK chunk of a file of floats."""
    with open(path, "r+b") as file:
        stamp = file.read(4096).find(b"PEAK")
        if stamp >= 0:
            file.seek(stamp + 12)
            file.write(bytes(4))
