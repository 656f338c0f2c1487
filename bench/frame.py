"""Measures encoding and verifying a command to the real chair."""

from app.clock import stopwatch
from app.hardware.chair.key import new_key
from app.hardware.chair.packet import DIGEST_BYTES, DRIVE, NONCE_BYTES, ChairCommand, decode_command, encode_command
from bench.datagram import against_datagram
from bench.row import Row

RUNS = 5
FRAMES = 20_000
REACH = 2.5  # of one loopback datagram


def measure_frame() -> list[Row]:
    """Return the time for encoding and verifying one command, relative to one loopback datagram."""
    both, ratios = against_datagram(_frame_time, RUNS)
    details = f"{1e6 * both:.1f} us, both ends together, HMAC-SHA-256 twice; {FRAMES} in each of {RUNS} runs"
    what = "frame to the chair, encode and verify, against one loopback datagram"
    return [Row(what, ratios, "x", REACH, "lower", details)]


def _frame_time() -> float:
    """Return the mean duration, s."""
    key, nonce, digest = new_key(1), bytes(NONCE_BYTES), bytes(DIGEST_BYTES)
    before = stopwatch()
    for i in range(FRAMES):
        command = ChairCommand(DRIVE, key.id, 7, i, i, 0.5, 0.1, 0.8, 1.2, digest)
        if decode_command(encode_command(command, key, nonce), key, nonce) is None:
            raise RuntimeError("the chair of the benchmark did not take a frame")
    return (stopwatch() - before) / FRAMES
