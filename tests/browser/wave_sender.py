"""A shirt over the network that sends waves, for tests of pages."""

import socket
import threading

import numpy as np

from app.hardware.shirt.packet import encode
from app.hardware.shirt.sender import waves
from app.layout import MAX_CHANNELS


class WaveSender:
    """Sends frames of so many `channels` without a key until it is closed."""

    def __init__(self, port, channels=52):
        self.channels = channels
        self._port, self._ended = port, threading.Event()
        self._socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self._socket.bind(("127.0.0.1", 0))
        self.name = f"127.0.0.1:{self._socket.getsockname()[1]}"
        self._thread = threading.Thread(target=self._send)
        self._thread.start()

    def _send(self):
        for seq, (t, samples) in enumerate(waves(MAX_CHANNELS, 100)):
            self._socket.sendto(
                encode(seq, t, np.array(samples[: self.channels], np.float32)), ("127.0.0.1", self._port)
            )
            if self._ended.wait(0.01):
                return

    def close(self):
        self._ended.set()
        self._thread.join()
        self._socket.close()
