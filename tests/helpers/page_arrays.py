"""Arrays and sounds as the data of a page contain them."""

from base64 import b64decode
from io import BytesIO

import numpy as np
import soundfile
from scipy.signal import sosfilt


def decoded(array):
    """Return a stored array (n,)."""
    return np.frombuffer(b64decode(array["base64"]), array["dtype"])


def decoded_track(url):
    """Return the samples of a stored sound."""
    return soundfile.read(BytesIO(b64decode(url.partition(",")[2])))[0]


def with_gain(audible, samples, rate):
    """Return samples (n,) with the stored filter and gain of their audible copy."""
    gain_db = decoded(audible["gain"]) / 100
    middle = (np.arange(len(gain_db)) + 0.5) * audible["interval"]
    gain = 10 ** (np.interp(np.arange(len(samples)) / rate, middle, gain_db) / 20)
    return gain * sosfilt(np.array(audible["sections"]), samples)
