"""Claim: hours of sound need little more memory than minutes, and a file of any length can be read
back.

Source: the program computes, writes and analyses the sound block by block; EBU Tech 3306 (RF64) for
files of more than 4 GB. Oracle: the peak resident memory of processes that handle five minutes and
half an hour of sound; libsndfile. Only the records of the motion and of the modal energy grow, by a
few kilobytes per second of sound.
"""

import json
import subprocess
import sys

import numpy as np
import pytest
import soundfile
from paths import ROOT

from dynamics import simulate
from modal import eigenmodes
from sonify.sound import wav
from sonify.sound.render import Renderer

AGAIN_AND_AGAIN = """
import json, resource, sys
import numpy as np
from dynamics import simulate
from dynamics.motion import ForceJumps
from modal import eigenmodes
from sonify import load_scene
from sonify.hearing.loudness import audibility, loudness_lufs
from sonify.hearing.recording import listen
from sonify.sound.render import Renderer
from sonify.sound.wav import write_sound

what, seconds, folder = sys.argv[1], float(sys.argv[2]), sys.argv[3]
scene = load_scene("published").replace("audio.sample_rate=8000", "numerics.time_limit=2.0")
if what == "render":
    once, modes = simulate(scene), eigenmodes(scene, below=4e3)
    period, jumps = once.t[-1], once.jumps
    n = int(seconds / period)

    class Endless:
        # the motion `once` over and over
        t = np.array([0.0, seconds])
        jumps = ForceJumps((np.arange(n)[:, None] * period + jumps.t).ravel(), *(np.tile(f, (n, 1)) for f in jumps[1:]))

        def __getattr__(self, name):
            return getattr(once, name)

        def at(self, t):
            return once.at(np.asarray(t) % period)

        def force(self, t):
            return once.force(np.asarray(t) % period)

        def at_and_force(self, t):
            return once.at_and_force(np.asarray(t) % period)

    sound = Renderer(scene, Endless(), modes).sound()
    write_sound(sound, folder)
    assert sound.samples >= seconds * 8000
else:
    path = folder + "/sound.wav"
    {"listen": listen, "audibility": audibility, "loudness": loudness_lufs}[what](path)
print(json.dumps(resource.getrusage(resource.RUSAGE_SELF).ru_maxrss))
"""


def peak(what, seconds, folder):
    """Return the peak resident memory of a process that runs `what` on a sound of `seconds`."""
    folder.mkdir(exist_ok=True)
    asked = [sys.executable, "-c", AGAIN_AND_AGAIN, what, str(seconds), str(folder)]
    return json.loads(
        subprocess.run(asked, capture_output=True, check=True, cwd=ROOT).stdout
    )


def test_half_an_hour_takes_the_memory_of_five_minutes(tmp_path):
    pytest.importorskip(
        "resource", reason="this system does not tell the memory of a process"
    )
    for what in ("render", "listen", "audibility", "loudness"):
        short, long = (
            peak(what, seconds, tmp_path / str(seconds)) for seconds in (300, 1800)
        )
        assert long < 1.4 * short, (what, short, long)


@pytest.fixture(scope="module")
def renderer(scene):
    short = simulate(scene.replace("numerics.time_limit=0.3"))
    return Renderer(scene, short, eigenmodes(scene, below=20e3))


def test_what_a_wav_file_cannot_hold_is_written_as_rf64(
    scene, renderer, tmp_path, monkeypatch
):
    """The limit lies between the sizes of sound.wav and pressure.wav; the samples are the same."""
    monkeypatch.setattr(wav, "MAX_RIFF_BYTES", int(3.5 * renderer.samples))
    sound = renderer.sound()
    wav.write_sound(sound, tmp_path)
    assert soundfile.info(tmp_path / "pressure.wav").format == "RF64"
    assert soundfile.info(tmp_path / "sound.wav").format == "WAV"
    pressure, copy = (
        soundfile.read(tmp_path / name)[0] for name in ("pressure.wav", "sound.wav")
    )
    assert len(pressure) == sound.samples
    assert np.abs(copy * sound.full_scale - pressure).max() < sound.full_scale * 2**-23


def test_the_limit_is_that_of_lengths_of_32_bits():
    assert 2**32 - 2**16 < wav.MAX_RIFF_BYTES < 2**32 - 1000
