"""A shirt at 1 kHz: rests, so that the chair can be armed, then moves endlessly.

Arguments: port, and for signed frames the key file. Ends with stdin.
"""

import itertools
import socket
import sys
import threading
from pathlib import Path

import numpy as np

from app.clock import MonotonicClock
from app.hardware.chair.key import read_key
from app.hardware.shirt.packet import encode
from app.hardware.shirt.sender import signed_frame
from app.realtime import go_real_time
from bench.subject import CHANNELS, bench_parameters, bench_signals

SAMPLE_RATE = 1000.0  # Hz
REST = 10.0  # s
MOVEMENT = 30.0  # s, repeated


def main(port: int, key_file: Path | None) -> None:
    """Send until stdin ends."""
    key = None if key_file is None else read_key(key_file)
    moving = bench_signals(bench_parameters(SAMPLE_RATE), MOVEMENT)
    resting = np.random.default_rng(3).normal(scale=0.002, size=(int(REST * SAMPLE_RATE), CHANNELS)).astype(np.float32)
    ending = threading.Event()

    def wait() -> None:
        sys.stdin.read()
        ending.set()

    threading.Thread(target=wait, daemon=True).start()
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as out:
        go_real_time()
        clock = MonotonicClock()
        start = clock.now()
        for i, row in enumerate(itertools.chain(resting, itertools.cycle(moving))):
            if ending.is_set():
                return
            clock.sleep_until(start + i / SAMPLE_RATE)
            t = i / SAMPLE_RATE
            frame = encode(i, t, row) if key is None else signed_frame(key, 1, i, round(t * 1e6), row.tolist())
            out.sendto(frame, ("127.0.0.1", port))


if __name__ == "__main__":
    main(int(sys.argv[1]), Path(sys.argv[2]) if len(sys.argv) > 2 else None)
