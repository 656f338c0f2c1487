"""A shirt at 1 kHz: rests, so that the chair can be armed, then moves for ever. Arguments: port. Ends with stdin."""

import itertools
import socket
import sys
import threading

import numpy as np

from app.bench.subject import CHANNELS, bench_parameters, bench_signals
from app.clock import MonotonicClock
from app.hardware.shirt.packet import encode
from app.realtime import go_real_time

SAMPLE_RATE = 1000.0  # Hz
REST = 10.0  # s
MOVEMENT = 30.0  # s, then it begins anew


def main(port: int) -> None:
    """Send until stdin ends."""
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
            out.sendto(encode(i, i / SAMPLE_RATE, row), ("127.0.0.1", port))


if __name__ == "__main__":
    main(int(sys.argv[1]))
