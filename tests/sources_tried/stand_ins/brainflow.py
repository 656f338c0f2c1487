"""Stands in for BrainFlow in a program that is tried: one board, whose samples its far end sends by UDP."""

import os
import socket
import threading

import numpy as np
from hardware.shirt.fake_brainflow import FakeBrainFlow

CHANNELS = 12
LONGEST = 4096  # bytes


class BrainFlow(FakeBrainFlow):
    """The module brainflow.board_shim."""

    def disable_board_logger(self):
        """Do nothing: there is no library of a device."""


def take_samples(library, port):
    """Take what the far end sends to a port, while the board is connected."""
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as listening:
        listening.bind(("127.0.0.1", port))
        while True:
            sample = np.frombuffer(listening.recv(LONGEST))
            if library.is_prepared:
                library.send([sample])


board_shim = BrainFlow(
    {
        "name": "Cyton",
        "sampling_rate": 100,
        "package_num_channel": 0,
        "analog_channels": list(range(1, CHANNELS + 1)),
        "timestamp_channel": CHANNELS + 1,
        "num_rows": CHANNELS + 2,
    }
)
threading.Thread(
    target=take_samples, args=(board_shim, int(os.environ["SOURCES_TRIED_PORT"])), name="far end", daemon=True
).start()
