"""Analyse the sound of a run in a worker process.

The worker loads or compiles the detector while the main process solves the motion.
"""

from typing import TYPE_CHECKING

from sonify.runtime.workers import BackgroundWorker, one_per_process, serve_calls

if TYPE_CHECKING:
    from sonify.hearing.recording import Heard
    from sonify.sound.pressure import Track


@one_per_process
def listener() -> BackgroundWorker:
    """Return the single listener of this process; the first call starts its worker."""
    return BackgroundWorker(__name__)


def listen_in_worker(sound: "Track", end: float) -> "Heard":
    """Return `listen_to_known_disk(sound, end)` from the listener, or from here for
    long sounds."""
    import numpy as np

    from sonify.hearing.recording import listen_to_known_disk

    if not isinstance(sound.columns, np.ndarray):
        return listen_to_known_disk(sound, end)
    whole = sound.without_stems()
    return listener().submit(listen_to_known_disk, whole, end).result()


def detect_rising_tone() -> None:
    """Detect a short tone, which compiles the detector."""
    import numpy as np

    from sonify.hearing.settling.detector import strongest_tone
    from sonify.sound.pressure import Track

    rate = 8000
    left = 0.65 - np.arange(0.6 * rate) / rate
    tone = np.cos(800 * np.sqrt(left)).astype(np.float32)
    strongest_tone(Track(sample_rate=rate, columns=tone[:, None], column=0))


if __name__ == "__main__":
    detect_rising_tone()
    serve_calls()
