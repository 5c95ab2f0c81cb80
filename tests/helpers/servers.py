"""Servers that run in a thread until the tests end."""

import queue
import threading


def address_of(serve, *arguments):
    """Start a server, and return the address that it tells with its last argument."""
    told = queue.Queue()
    threading.Thread(target=serve, args=(*arguments, told.put), daemon=True).start()
    return told.get(timeout=60)
