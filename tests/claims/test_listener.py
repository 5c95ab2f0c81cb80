"""Claim: a sound analysed in the worker process gives the same result as in this process.

Oracle: `listen_to_known_disk` in this process; the worker may have died.
"""

from dataclasses import asdict

import numpy as np
import pytest

from sonify.claims.listener import listen_in_worker, listener
from sonify.hearing.recording import listen_to_known_disk
from sonify.sound.pressure import Track


def two_listeners_with_stems():
    """Return a rising tone at two listeners, the second of which is louder."""
    rate = 16000
    left = 3.05 - np.arange(3 * rate) / rate
    tone = np.cos(800 * np.sqrt(left)).astype(np.float32)
    columns = np.column_stack([tone, np.zeros_like(tone), 2 * tone])
    other = Track(sample_rate=rate, columns=columns, column=2)
    return Track(sample_rate=rate, columns=columns, column=0, others=(other,))


@pytest.mark.slow
def test_the_worker_hears_the_same_also_once_it_has_died():
    sound = two_listeners_with_stems()
    here = listen_to_known_disk(sound, 3.0)
    assert here.tone is not None
    np.testing.assert_equal(asdict(listen_in_worker(sound, 3.0)), asdict(here))
    listener().close()
    np.testing.assert_equal(asdict(listen_in_worker(sound, 3.0)), asdict(here))
    listener.cache_clear()


def test_a_track_without_stems_has_the_samples_of_each_listener():
    sound = two_listeners_with_stems()
    alone = sound.without_stems()
    assert alone.columns.shape[1] == 2
    assert np.array_equal(next(alone.blocks()), next(sound.blocks()))
